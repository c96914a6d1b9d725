//! What is to keep apart: taper and shank, and the holder, each from the part and from all that
//! stands around it.

use super::options::VerifyOptions;
use crate::artifact::{Blade, Obstacle};
use crate::geometry::part::Part;
use crate::tool::{Segment, Tool};

/// Segments of the tool and a body that keep apart.
pub struct Apart<'a> {
    /// The body.
    pub(super) part: &'a Part,
    /// The body as it stands around the part; `None`: it is the part.
    pub(super) obstacle: Option<&'a Obstacle>,
    /// The segments, one at least.
    pub(super) segments: Vec<Segment>,
    /// They are the holder's, not taper and shank.
    pub(super) is_holder: bool,
    /// How far, mm.
    pub(super) asked_mm: f64,
}

impl Apart<'_> {
    /// The body in words, with the face where it is the part.
    pub(super) fn named(&self, face: Option<u32>) -> String {
        match self.obstacle {
            Some(o) => o.name.clone(),
            None => face.map_or_else(|| "nothing".to_owned(), |f| self.part.face_name(f)),
        }
    }
}

/// All that is to keep apart, the part first. Of stock, into which the tool cuts, only the holder
/// keeps clear.
pub fn apart<'a>(blade: &'a Blade, obstacles: &'a [Obstacle], tool: &Tool, options: &VerifyOptions) -> Vec<Apart<'a>> {
    let [cutter, holder] = tool.cutter_and_holder();
    let part = (&blade.part, None, [Some(options.clearance_mm), Some(options.holder_clearance_mm)]);
    let around = obstacles.iter().map(|o| {
        let cutter_mm = (!o.cut_by_the_tool).then_some(o.clearance_mm);
        (&o.part, Some(o), [cutter_mm, Some(o.holder_clearance_mm)])
    });
    let mut out = Vec::new();
    for (part, obstacle, asked) in std::iter::once(part).chain(around) {
        for (is_holder, (segments, asked_mm)) in
            [false, true].into_iter().zip([&cutter, &holder].into_iter().zip(asked))
        {
            let Some(asked_mm) = asked_mm.filter(|_| !segments.is_empty() && !part.mesh.triangles.is_empty()) else {
                continue;
            };
            out.push(Apart { part, obstacle, segments: segments.clone(), is_holder, asked_mm });
        }
    }
    out
}
