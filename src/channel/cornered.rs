//! Free angles of a cutter with a corner, which leans forwards along the way.
//!
//! The contact stays while θ turns, so the disc under the corner goes with it: its centre is
//! `p + r n + R (n − a cos α) / sin α` ([`crate::tool::contact`]). Three things limit θ.
//!
//! * The contact angle, forwards, and the strip that passes are laid for: a window of θ
//!   ([`Inclined::window_rad`]).
//! * Taper, shank and holder. The window is cut into pieces in which the centre stays within a
//!   room [`ROOM_MM`] of where it is in the middle of the piece; there the search of balls runs
//!   about that centre, with the room added to the clearance. So a wall lies at most twice that
//!   room inside the one that is asked for.
//! * The disc itself: on hollow ground its back cuts where the axis leans too little. It is
//!   looked at where angles are [`LOOK_RAD`] apart at most, and the ends of what is clear are
//!   halved to the tolerance. What lies between these angles is a matter of the checks, which
//!   follow the whole motion.

use std::f64::consts::FRAC_PI_2;

use super::arcs::Witness;
use super::forbidden::Free;
use super::report::Reporter;
use super::samples::Sample;
use super::{ChannelOptions, Surroundings, track};
use crate::artifact::Toolpath;
use crate::error::{Bound, Error, Infeasible, Result, Stage};
use crate::geometry::near_disc::DiscSearch;
use crate::geometry::{Point, Vector};
use crate::observe::Observer;
use crate::parallel;
use crate::tool::Tool;
use crate::tool::inclination::{Inclined, forwards_rad};

/// Half of what the centre moves while one search stands for all angles of a piece, mm.
const ROOM_MM: f64 = 0.05;
/// Turning of the surface normal from place to place, rad: windows are hardly wider than what they
/// move by round an edge, and are to overlap.
pub(super) const TURN_RAD: f64 = 0.02;
/// Pieces of the window at most: wider ones get more room.
const MOST_PIECES: usize = 24;
/// Angles at which the disc is looked at are no farther apart than this, rad.
const LOOK_RAD: f64 = 0.05;
/// The disc may come nearer than its corner's radius by this, mm: a third of a micrometre is what
/// gouges are judged to.
const CUT_MM: f64 = 3e-4;
/// About its contact the disc is not looked at, as far as it rises by this on flat ground, mm:
/// what fits farther off fits there.
const RISES_MM: f64 = 0.01;
/// Places that one thread looks at in a row.
const CHUNK: usize = 64;
/// Places at which the greatest way of the centre over a window is measured.
const WAYS: usize = 8;

/// A cutter with a corner among bodies.
struct Scene<'a> {
    around: &'a Surroundings<'a>,
    tool: &'a Tool,
    options: &'a ChannelOptions,
    stock_mm: f64,
    /// What places between locations may lie off the path, mm.
    chord_mm: f64,
}

/// θ from and to, rad.
type Window = Option<[f64; 2]>;

/// Free intervals of all places of the path of corners.
pub(super) fn layers(
    around: &Surroundings,
    tool: &Tool,
    options: &ChannelOptions,
    (samples, path): (&[Sample], &Toolpath),
    observer: &dyn Observer,
) -> Result<Vec<Vec<Free>>> {
    let scene = Scene { around, tool, options, stock_mm: path.stock_mm, chord_mm: path.chord_mm };
    let windows = scene.windows(samples);
    let clear_of_tool = scene.clear_of_tool(samples, &windows, observer)?;
    let chunks = samples.len().div_ceil(CHUNK);
    parallel::try_map(0..chunks, |k| {
        observer.check(Stage::Channel)?;
        let mut discs = Discs::new(&scene);
        let places = (k * CHUNK..((k + 1) * CHUNK).min(samples.len())).collect::<Vec<_>>();
        let of = |i: usize| clear_of_tool[i].iter().flat_map(|free| discs.clear(&samples[i], free)).collect();
        Ok(places.into_iter().map(of).collect::<Vec<Vec<Free>>>())
    })
    .map(|chunks: Vec<_>| chunks.into_iter().flatten().collect())
}

/// Why no angle is free at a place, and what would do: the contact angle, or the disc.
pub(super) fn closed(
    around: &Surroundings,
    tool: &Tool,
    options: &ChannelOptions,
    (reporter, at): (&Reporter, usize),
) -> Option<Error> {
    let sample = reporter.samples.get(at)?;
    let scene = Scene { around, tool, options, stock_mm: reporter.path.stock_mm, chord_mm: reporter.path.chord_mm };
    let [least, most] = [options.settings.contact_angle_min_deg, options.settings.contact_angle_max_deg];
    let place = reporter.place(sample.row);
    let refused = |why: String, bound: Bound, advice: String| {
        let message = format!("no angle of the tool axis is free at {place}: {why}");
        let what = Infeasible::NoFreeAngle {
            at: reporter.at(sample.row),
            at_start: at == 0,
            bounds: vec![bound],
            region_may_end_mm: reporter.above(sample.row),
        };
        Some(Error::infeasible(Stage::Channel, message, what).advise(advice))
    };
    let around_it = reporter.samples.get(at.saturating_sub(1)..(at + 2).min(reporter.samples.len()))?;
    let Some([low, high]) = scene.windows(around_it).get(at.min(1)).copied().flatten() else {
        let azimuth = sample.azimuth;
        let nearest_deg = sample.cone.tool_axis(azimuth).angle(&sample.normal).to_degrees();
        let why = format!(
            "head and wall lean apart by {nearest_deg:.2}°, the angle between tool axis and surface normal may be at most {most}°"
        );
        let advice = "lean the head with machine.b_deg, end the region before that place, or allow more with \
                      channel.contact_angle_max_deg";
        return refused(why, Bound::ContactAngle, advice.into());
    };
    let mut discs = Discs::new(&scene);
    let cuts = |discs: &mut Discs, theta: f64| discs.cut_at(sample, theta);
    let body = cuts(&mut discs, high)?;
    let name = discs.name(&body);
    let square = forwards_rad(&sample.cone, &sample.normal, FRAC_PI_2);
    let would = square.map(|on| sample.azimuth + on).filter(|end| cuts(&mut discs, *end).is_none());
    let (advice, more) = match would {
        Some(mut clear) => {
            let mut cut = high.max(low);
            while clear - cut > options.settings.tolerance_deg.to_radians() {
                let middle = 0.5 * (cut + clear);
                if cuts(&mut discs, middle).is_some() { cut = middle } else { clear = middle }
            }
            let needs_deg = sample.cone.tool_axis(clear).angle(&sample.normal).to_degrees();
            (
                "let it lean more with channel.contact_angle_max_deg, or take a narrower cutter or a larger corner"
                    .to_owned(),
                format!("; at {needs_deg:.2}° it would be clear there"),
            )
        }
        None => ("take a narrower cutter, or a ball".into(), "; no inclination would do".into()),
    };
    let why = format!("inclined by {least}° to {most}° the cutter cuts {name} beside its contact{more}");
    refused(why, Bound::Part { tool: "cutter".into(), face: name }, advice)
}

impl Scene<'_> {
    /// θ that contact angle and strip leave, at a place of a path that goes on along `way`, unit.
    fn window(&self, s: &Sample, way: &Vector) -> Window {
        let settings = &self.options.settings;
        let inclined = Inclined {
            disc_radius_mm: self.tool.disc_radius_mm(),
            corner_radius_mm: self.tool.corner_mm(),
            contact_rad: [settings.contact_angle_min_deg, settings.contact_angle_max_deg].map(f64::to_radians),
            cone: s.cone,
            rises: true,
        };
        Some(inclined.window_rad(&s.normal, way)?.map(|on| s.azimuth + on))
    }

    /// Windows of all places.
    fn windows(&self, samples: &[Sample]) -> Vec<Window> {
        let at = |k: usize| samples[k.min(samples.len() - 1)].centre;
        parallel::map(0..samples.len(), |k| {
            let (s, way) = (&samples[k], at(k + 1) - at(k.saturating_sub(1)));
            let way = (way - s.normal * way.dot(&s.normal)).try_normalize(1e-12)?;
            self.window(s, &way)
        })
    }

    /// Centre of the disc at θ, on the corner's centre of a place.
    fn centre(&self, s: &Sample, theta: f64) -> Option<(Point, Vector)> {
        let axis = s.cone.tool_axis(theta);
        let contact = s.centre - s.normal * self.tool.corner_mm();
        Some((self.tool.centre_at(&contact, &s.normal, &axis, None)?, axis))
    }

    /// What taper, shank and holder leave of the windows.
    fn clear_of_tool(&self, samples: &[Sample], windows: &[Window], observer: &dyn Observer) -> Result<Vec<Vec<Free>>> {
        let way = |(s, window): (&Sample, &Window)| {
            let Some([low, high]) = *window else { return 0.0 };
            let at = |k: usize| self.centre(s, low + (high - low) * k as f64 / WAYS as f64).map(|c| c.0);
            let ways = (0..WAYS).filter_map(|k| Some((at(k + 1)? - at(k)?).norm()));
            // Of chords, which are shorter than the way.
            WAYS as f64 * 1.1 * ways.fold(0.0, f64::max)
        };
        let ways = samples.iter().zip(windows).collect::<Vec<_>>();
        let longest_mm = parallel::map(&ways, |pair| way(*pair)).into_iter().fold(0.0, f64::max);
        let pieces = ((longest_mm / (2.0 * ROOM_MM)).ceil() as usize).clamp(1, MOST_PIECES);
        let room_mm = 0.5 * longest_mm / pieces as f64;
        let all_angles = self.options.clone().with(|s| {
            (s.contact_angle_min_deg, s.contact_angle_max_deg) = (0.0, 180.0);
        });
        let scene = self.around.scene_with(self.tool, &all_angles, room_mm);
        let mut out: Vec<Vec<Free>> = vec![Vec::new(); samples.len()];
        for k in 0..pieces {
            let part = |window: &Window| {
                window.map(|[low, high]| [k, k + 1].map(|j| low + (high - low) * j as f64 / pieces as f64))
            };
            let moved: Vec<Sample> = samples.iter().zip(windows).map(|(s, w)| self.moved(s, part(w))).collect();
            let free = track::free_everywhere(&scene, &moved, observer)?;
            for ((list, window), free) in out.iter_mut().zip(windows).zip(free) {
                let Some(piece) = part(window) else { continue };
                free.iter().for_each(|f| join(list, f, piece, *window));
            }
        }
        Ok(out)
    }

    /// A place with the disc's centre amid a piece of its window.
    fn moved(&self, s: &Sample, piece: Window) -> Sample {
        let middle = piece.map(|[a, b]| 0.5 * (a + b));
        let centre = middle.and_then(|theta| self.centre(s, theta)).map_or(s.centre, |c| c.0);
        Sample { centre, ..*s }
    }
}

/// Takes what of a free interval lies in a piece of a window to those before it.
fn join(list: &mut Vec<Free>, free: &Free, [from, to]: [f64; 2], window: Window) {
    let Some([low, high]) = window else { return };
    let mut new = *free;
    if new.lo <= from {
        (new.lo, new.lo_by) = (from, if from == low { Witness::Contact } else { Witness::Cut });
    }
    if new.hi >= to {
        (new.hi, new.hi_by) = (to, if to == high { Witness::Contact } else { free.hi_by });
    }
    if new.lo > new.hi {
        return;
    }
    match list.last_mut() {
        Some(last) if last.hi >= new.lo => (last.hi, last.hi_by) = (new.hi, new.hi_by),
        _ => list.push(new),
    }
}

/// What the disc would cut.
#[derive(Clone, Copy)]
struct Cut {
    body: u16,
    triangle: u32,
}

/// The disc against the part and the bodies about it.
struct Discs<'a> {
    scene: &'a Scene<'a>,
    /// Each with how near to it the disc may come, mm.
    bodies: Vec<(u16, DiscSearch<'a>, f64)>,
}

impl<'a> Discs<'a> {
    fn new(scene: &'a Scene<'a>) -> Self {
        let corner = scene.tool.corner_mm();
        let part = (0, DiscSearch::new(&scene.around.blade.part), corner + scene.stock_mm - CUT_MM);
        let others = scene.around.obstacles.iter().zip(1..).filter(|(o, _)| !o.cut_by_the_tool);
        let others = others.map(|(o, k)| (k, DiscSearch::new(&o.part), corner + o.clearance_mm));
        Discs { scene, bodies: std::iter::once(part).chain(others).collect() }
    }

    /// What the disc cuts at θ, if anything.
    fn cut_at(&mut self, s: &Sample, theta: f64) -> Option<Cut> {
        let scene = self.scene;
        let (centre, axis) = scene.centre(s, theta)?;
        let disc = scene.tool.disc(centre, axis);
        let (corner, contact) = (scene.tool.corner_mm(), s.centre - s.normal * scene.tool.corner_mm());
        let flattest_mm = corner + disc.radius_mm / axis.cross(&s.normal).norm().max(1e-3);
        let spared_mm = (2.0 * RISES_MM * flattest_mm).sqrt().min(disc.radius_mm);
        self.bodies.iter_mut().find_map(|(body, search, near_mm)| {
            let (part, spared_mm) = match usize::from(*body).checked_sub(1) {
                None => (&scene.around.blade.part, spared_mm),
                Some(k) => (&scene.around.obstacles[k].part, 0.0),
            };
            // What is spared lies under the contact where stock stays on the part.
            let foot = contact - s.normal * scene.stock_mm;
            let off_mm = if s.fraction > 0.0 { scene.chord_mm } else { 0.0 };
            let point = search.cut(&disc, *near_mm - off_mm, (&foot, spared_mm))?;
            let triangle = part.closest_on_mesh(&point, f64::INFINITY).and_then(|c| c.triangle).unwrap_or(0);
            Some(Cut { body: *body, triangle })
        })
    }

    /// The name of what is cut.
    fn name(&self, cut: &Cut) -> String {
        let around = self.scene.around;
        match usize::from(cut.body).checked_sub(1).and_then(|k| around.obstacles.get(k)) {
            Some(obstacle) => obstacle.name.clone(),
            None => {
                let part = &around.blade.part;
                part.face_name(part.mesh.face(cut.triangle as usize)).to_string()
            }
        }
    }

    /// What of a free interval the disc leaves.
    fn clear(&mut self, s: &Sample, free: &Free) -> Vec<Free> {
        let steps = ((free.hi - free.lo) / LOOK_RAD).ceil().max(2.0) as usize;
        let at = |k: usize| free.lo + (free.hi - free.lo) * k as f64 / steps as f64;
        let seen: Vec<Option<Cut>> = (0..=steps).map(|k| self.cut_at(s, at(k))).collect();
        let mut out: Vec<Free> = Vec::new();
        for k in 0..=steps {
            if seen[k].is_some() {
                continue;
            }
            let goes_on = k > 0 && seen[k - 1].is_none();
            match out.last_mut() {
                Some(last) if goes_on => last.hi = at(k),
                _ => {
                    let mut new = Free { lo: at(k), hi: at(k), ..*free };
                    if let Some(cut) = k.checked_sub(1).and_then(|j| seen[j]) {
                        (new.lo, new.lo_by) = self.end(s, (at(k), at(k - 1)), cut);
                    }
                    out.push(new);
                }
            }
            if let (Some(last), Some(Some(cut))) = (out.last_mut(), seen.get(k + 1)) {
                (last.hi, last.hi_by) = self.end(s, (at(k), at(k + 1)), *cut);
            }
        }
        out.retain(|f| f.lo < f.hi);
        out
    }

    /// Where between an angle that is clear and one that is not the disc begins to cut, on the
    /// clear side, and what it cuts.
    fn end(&mut self, s: &Sample, (mut clear, mut taken): (f64, f64), mut cut: Cut) -> (f64, Witness) {
        let tolerance = self.scene.options.settings.tolerance_deg.to_radians();
        while (taken - clear).abs() > tolerance {
            let middle = 0.5 * (clear + taken);
            match self.cut_at(s, middle) {
                Some(found) => (taken, cut) = (middle, found),
                None => clear = middle,
            }
        }
        (clear, Witness::Cutter { body: cut.body, triangle: cut.triangle })
    }
}
