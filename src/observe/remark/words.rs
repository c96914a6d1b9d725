//! The sentences of remarks.

use std::fmt;

use super::{FarthestMove, Remark};

/// The first few of a list.
pub fn listed(all: &[String]) -> String {
    const MOST: usize = 6;
    let more = if all.len() > MOST { format!(" and {} more", all.len() - MOST) } else { String::new() };
    format!("{}{more}", all[..all.len().min(MOST)].join(", "))
}

/// A direction: `+Z of the model`, or its three numbers.
pub fn direction(d: &[f64; 3]) -> String {
    for (x, name) in d.iter().zip(["X", "Y", "Z"]) {
        if x.abs() > 1.0 - 1e-12 {
            return format!("{}{name} of the model", if *x < 0.0 { "-" } else { "+" });
        }
    }
    let [x, y, z] = d;
    format!("({x:.4}, {y:.4}, {z:.4}) in the model")
}

/// A direction by two decimals.
fn rough([x, y, z]: &[f64; 3]) -> String {
    format!("({x:.2}, {y:.2}, {z:.2})")
}

/// A length with four significant digits.
pub fn short(x: f64) -> String {
    let digits = if x > 0.0 { (3.0 - x.log10().floor()).clamp(0.0, 9.0) as usize } else { 1 };
    format!("{x:.digits$}")
}

/// What every doubt about the axis ends with.
const GIVE_AXIS: &str = "give it with --axis if it is wrong";

impl fmt::Display for Remark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Remark::BytesIgnored { bytes } => write!(f, "{bytes} bytes after the last triangle were ignored"),
            Remark::PrimitivesPassedOver { count } => {
                write!(f, "{count} primitives of points or lines were passed over")
            }
            Remark::TakenAtRest => f.write_str("skins and morph targets are not applied: the mesh is taken at rest"),
            Remark::WeightsPassedOver { vertices } => {
                write!(f, "weights of {vertices} vertices were passed over: they are for curves, not for a mesh")
            }
            Remark::HiddenPassedOver { count } => write!(f, "{count} hidden bodies or faces were passed over"),
            Remark::ScaleUndone { scale } => write!(f, "the file's model scale of {scale} was undone"),
            Remark::EntitiesSkipped { count, first, reason } => {
                write!(f, "{count} entities that no face needs were skipped, the first #{first} ({reason})")
            }
            Remark::StepReader { words } => write!(f, "STEP reader: {words}"),
            Remark::DegenerateDropped { triangles } => write!(f, "{triangles} degenerate triangles were dropped"),
            Remark::RepeatedDropped { triangles } => write!(f, "{triangles} duplicate triangles were dropped"),
            Remark::FlatMerged { triangles } => {
                write!(f, "{triangles} triangles without area were merged into their neighbours")
            }
            Remark::FlatLeft { triangles } => {
                write!(f, "{triangles} triangles without area stay: they have no neighbour to merge with")
            }
            Remark::VerticesMerged { vertices, within_mm, vanished } => {
                write!(f, "{vertices} vertices closer than {within_mm:.2e} mm to another were merged")?;
                if *vanished > 0 { write!(f, "; {vanished} triangles vanished by it") } else { Ok(()) }
            }
            Remark::HolesClosed { count, most_mm, triangles } => {
                write!(f, "{count} holes up to {most_mm} mm were closed with {triangles} triangles")
            }
            Remark::NoHoleToClose { most_mm } => write!(f, "no hole up to {most_mm} mm was found to close"),
            Remark::CornersMoved { triangles, beyond_mm } => write!(
                f,
                "{triangles} triangles had corners that moved by more than {beyond_mm} mm: the tool spares them as the \
                 file has them too"
            ),
            Remark::TrianglesTurned { triangles } => {
                write!(f, "{triangles} triangles were wound against their neighbours and were turned")
            }
            Remark::AllTrianglesTurned => f.write_str("all triangles were wound inward and were turned"),
            Remark::PiecesTurned { triangles } => {
                write!(f, "pieces of {triangles} triangles were wound inward and were turned")
            }
            Remark::Cavities { pieces } => write!(f, "{pieces} closed pieces wound inward inside another are cavities"),
            Remark::FacesTurned { count, of } if count == of => {
                f.write_str("all faces were oriented inward and were turned")
            }
            Remark::FacesTurned { count, of } => {
                write!(f, "{count} of {of} faces were oriented against their neighbours or inward and were turned")
            }
            Remark::MeshedCoarser { least_mm, share, asked_mm } => write!(
                f,
                "faces are meshed within {least_mm:.3} mm, {share:e} of the part's size, not within {asked_mm} mm: the \
                 mesh would be too large"
            ),
            Remark::EdgesJoined { count, gap_mm } => {
                write!(f, "{count} edges that faces did not share were joined, at most {gap_mm:.2e} mm apart")
            }
            Remark::GapsClosed { count, widest_mm, at_mm: [x, y, z] } => {
                write!(
                    f,
                    "{count} gaps between edges of loops were closed, the widest of {widest_mm:.3} mm at ({x:.3}, {y:.3}, \
                     {z:.3})"
                )
            }
            Remark::FoldsLeftOut { count, longest_mm, at_mm: [x, y, z] } => {
                write!(
                    f,
                    "stretches in which edges fold back on themselves were left out: {count}, the longest of \
                     {longest_mm:.3} mm at ({x:.3}, {y:.3}, {z:.3})"
                )
            }
            Remark::EdgesCut { count } => write!(f, "{count} edges were cut where edges of neighbouring faces end"),
            Remark::EdgesDropped { count } => {
                write!(f, "{count} edges shorter than the sewing tolerance were dropped")
            }
            Remark::SliversDropped { faces } => {
                write!(f, "sliver faces were dropped, their neighbours joined: {}", listed(faces))
            }
            Remark::RepeatedFaces { faces } => {
                let pairs: Vec<String> = faces.iter().map(|[a, b]| format!("{a} repeats {b}")).collect();
                write!(f, "faces given twice were dropped: {}", listed(&pairs))
            }
            Remark::MadeCloser { edges_mm, faces_mm, reason } => write!(
                f,
                "edges were joined within {edges_mm:.1e} mm and faces meshed within {faces_mm} mm, since with more \
                 {reason}"
            ),
            Remark::Untrimmed { face, reason } => {
                write!(f, "{face} cannot be trimmed ({reason}): it was taken up to its natural boundary")
            }
            Remark::FaceLeftOut { reason } => write!(f, "left out: {reason}"),
            Remark::FacesChanged { count, dropped, farthest } => {
                write!(f, "sewing changed {count} faces")?;
                if *dropped > 0 {
                    write!(f, ", {dropped} of them dropped")?;
                }
                if let Some(FarthestMove { mm, face, at_mm: [x, y, z] }) = farthest {
                    write!(f, ", the most {mm:.4} mm at {face} near ({x:.3}, {y:.3}, {z:.3})")?;
                }
                f.write_str(": the tool spares them as the file has them too")
            }
            Remark::NotAsTrimmed { faces, moved_mm } => write!(
                f,
                "{} cannot be followed as the file trims them, by up to {moved_mm:.4} mm otherwise than sewn: gouge is \
                 measured there on the sewn part alone; sew the part in CAD to be sure",
                listed(faces)
            ),
            Remark::ExactOpeningsStay => f.write_str(
                "openings between exact faces are not closed, close_holes_mm acts on meshes: an invented face would \
                 pass for the designer's; add the face in the CAD system, or export a mesh",
            ),
            Remark::UnitNotCertain { across_mm, unit, others } => {
                let list: Vec<String> = others.iter().map(|(u, mm)| format!("in {u} {} mm", short(*mm))).collect();
                let other =
                    if list.is_empty() { String::new() } else { format!("; {} would be usual", list.join(", ")) };
                write!(
                    f,
                    "the unit is not certain: the file names none, and {} mm across in {unit} is unusual for a \
                     blade{other}; give it with --unit",
                    short(*across_mm)
                )
            }
            Remark::SizeUnusual { file, across_mm, unit, small, advice } => {
                let side = if *small { "small" } else { "large" };
                write!(f, "{file} is {} mm across in {unit}, too {side} for a blade", short(*across_mm))?;
                advice.as_ref().map_or(Ok(()), |advice| write!(f, " ({advice})"))
            }
            Remark::UnitGuessed { unit, reason } => {
                write!(f, "the unit is a guess: {reason}; give it with --unit {unit} before planning")
            }
            Remark::WindTurbine { ratio, length_m, unit } => write!(
                f,
                "the unit is not certain: the blade is {ratio:.0} times as long as its mean chord, as slender as a \
                 wind turbine's, and {} m would be the length of one; if the file is in metres, pass --unit m, else \
                 --unit {unit}",
                short(*length_m)
            ),
            Remark::SectionLeftOut { reason } => write!(f, "left out at the end: {reason}"),
            Remark::PointStandsOut { section, number, at_mm, off_mm } => {
                let words = standing_out(section, *number, at_mm, *off_mm);
                write!(f, "{words}: is it right?")
            }
            Remark::Lofted { sections, by_number, around, sharp_edges, greatest_mm } => {
                let how =
                    if *by_number { "points joined by number" } else { "sections sampled along splines of their own" };
                write!(
                    f,
                    "lofted through {sections} sections ({how}, {around} round, {sharp_edges} sharp edges): the points \
                     of the table are within {greatest_mm:.6} mm of the surface"
                )
            }
            Remark::EdgesTakenAsRound { reason } => write!(f, "{reason}; all edges are taken as round"),
            Remark::LeftOutTest { of, greatest_mm, rms_mm } => write!(
                f,
                "left-out test: through every second {of} only, the surface misses the others by up to \
                 {greatest_mm:.4} mm, {rms_mm:.4} mm in the root mean square"
            ),
            Remark::Wheel { wheel } => {
                write!(f, "the part is {wheel}: the path goes round one blade, the others stand in the tool's way")
            }
            Remark::Assembly { bodies, number, body } => write!(
                f,
                "the model is an assembly of {bodies} bodies; the airfoil was found on body {number} ({body}), and the \
                 tool keeps clear of all of them; --body chooses another"
            ),
            Remark::AxisOpposite { given, found, reason } => write!(
                f,
                "the blade axis was given as {}; without --axis {} is found, the opposite ({reason}): with the axis as \
                 given the airfoil's free end is taken for its root and machined",
                direction(given),
                direction(found)
            ),
            Remark::AxisElsewhere { given, found, apart_deg, scores: [score, own] } => write!(
                f,
                "the blade axis was given as {}; without --axis {} is found, {apart_deg:.0}° away, along which \
                 sections look far more like an airfoil (score {score:.2} against {own:.2})",
                direction(given),
                direction(found)
            ),
            Remark::AxisRivalled { other, scores: [score, own] } => write!(
                f,
                "the blade axis is not certain: sections along {} look like an airfoil too (score {score:.2} against \
                 {own:.2}); {GIVE_AXIS}",
                rough(other)
            ),
            Remark::EndsCutSections { share } => write!(
                f,
                "the blade axis is not certain: over {:.0} % of the part sections are cut short by its ends, which are \
                 not square to the axis; {GIVE_AXIS}",
                100.0 * share
            ),
            Remark::EndsSlanted { normal, off_deg } => write!(
                f,
                "the blade axis is not certain: both ends of the blade are square to {}, {off_deg:.0}° from it; \
                 {GIVE_AXIS}",
                rough(normal)
            ),
            Remark::EndsNotReached { square_to } => write!(
                f,
                "the blade axis is not certain: sections square to {} look most like an airfoil, but reach neither of \
                 its ends, between which the blade turns; give the axis with --axis if it is wrong",
                rough(square_to)
            ),
            Remark::BladeLeans { middle, square_to, lean_deg } => write!(
                f,
                "the blade axis is not certain: the blade leans, its middle runs along {}, the sections themselves are \
                 square to {}, {lean_deg:.0}° away; give the axis with --axis if it is wrong",
                rough(middle),
                rough(square_to)
            ),
            Remark::RootNotCertain { growth } => write!(
                f,
                "which end is the root is not certain: the last section of the table is {growth:.1} times as large as \
                 the first; give the axis from root to tip with --axis if the table runs from tip to root"
            ),
            Remark::NoAirfoil { likeness, axis_given } => {
                let advice = if *axis_given {
                    "the blade axis may be another than was given"
                } else {
                    "give the axis if it is wrong"
                };
                write!(
                    f,
                    "no section looks like an airfoil (likeness {likeness:.2}): the longest steady run of sections was \
                     taken; {advice}"
                )
            }
            Remark::PartlyAirfoil { likeness } => write!(
                f,
                "sections look only partly like an airfoil (likeness {likeness:.2}): something seems to be attached to \
                 the blade, such as a back plate, a web or another blade"
            ),
        }
    }
}

/// What is said of a point of a table that stands out.
pub fn standing_out(section: &str, number: usize, [x, y, z]: &[f64; 3], off_mm: f64) -> String {
    format!(
        "in the section at {section} point {number} at ({x:.4}, {y:.4}, {z:.4}) mm stands out, {off_mm:.4} mm from the \
         middle of its neighbours, while the chain goes on beside it as if it were not there"
    )
}
