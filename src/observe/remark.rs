//! What reading a model left to be said, as data: the sentence is made of it (`words`).

mod words;

use serde::{Deserialize, Serialize};

pub use words::{direction, listed, short, standing_out};

/// What was changed on a model, or looks odd.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case", tag = "what")]
pub enum Remark {
    /// Bytes behind the last triangle were ignored.
    BytesIgnored {
        /// How many.
        bytes: usize,
    },
    /// Primitives of points or lines were passed over.
    PrimitivesPassedOver {
        /// How many.
        count: usize,
    },
    /// Skins and morph targets are not applied.
    TakenAtRest,
    /// Weights were passed over.
    WeightsPassedOver {
        /// Vertices that have one.
        vertices: usize,
    },
    /// Hidden bodies or faces were passed over.
    HiddenPassedOver {
        /// How many.
        count: usize,
    },
    /// The model scale of an IGES file was undone.
    ScaleUndone {
        /// The scale.
        scale: f64,
    },
    /// Entities that no face needs were skipped.
    EntitiesSkipped {
        /// How many.
        count: usize,
        /// Number of the first.
        first: u64,
        /// Why it was skipped.
        reason: String,
    },
    /// What the reader of STEP says in its own words.
    StepReader {
        /// Its words.
        words: String,
    },
    /// Degenerate triangles were dropped.
    DegenerateDropped {
        /// How many.
        triangles: usize,
    },
    /// Triangles given twice were dropped.
    RepeatedDropped {
        /// How many.
        triangles: usize,
    },
    /// Triangles without area were merged into their neighbours.
    FlatMerged {
        /// How many.
        triangles: usize,
    },
    /// Triangles without area stay.
    FlatLeft {
        /// How many.
        triangles: usize,
    },
    /// Vertices were merged.
    VerticesMerged {
        /// How many.
        vertices: usize,
        /// Those closer than this, mm.
        within_mm: f64,
        /// Triangles that vanished by it.
        vanished: usize,
    },
    /// Holes were closed.
    HolesClosed {
        /// How many.
        count: usize,
        /// Up to this extent, mm.
        most_mm: f64,
        /// Triangles that were added.
        triangles: usize,
    },
    /// There is no hole to close.
    NoHoleToClose {
        /// Up to this extent, mm.
        most_mm: f64,
    },
    /// Corners of triangles moved.
    CornersMoved {
        /// Triangles.
        triangles: usize,
        /// Farther than this, mm.
        beyond_mm: f64,
    },
    /// Triangles were wound against their neighbours.
    TrianglesTurned {
        /// How many.
        triangles: usize,
    },
    /// All triangles were wound inward.
    AllTrianglesTurned,
    /// Pieces were wound inward.
    PiecesTurned {
        /// Triangles of them.
        triangles: usize,
    },
    /// Pieces inside others are cavities.
    Cavities {
        /// How many.
        pieces: usize,
    },
    /// Faces were oriented against their neighbours or inward.
    FacesTurned {
        /// How many.
        count: usize,
        /// Of all these.
        of: usize,
    },
    /// Faces are meshed more coarsely than asked for.
    MeshedCoarser {
        /// Deflection taken, mm.
        least_mm: f64,
        /// That over the part's size.
        share: f64,
        /// Deflection asked for, mm.
        asked_mm: f64,
    },
    /// Edges that faces did not share were joined.
    EdgesJoined {
        /// How many.
        count: usize,
        /// Greatest distance between two of them, mm.
        gap_mm: f64,
    },
    /// Gaps between edges that follow one another in a loop were closed.
    GapsClosed {
        /// How many.
        count: usize,
        /// Width of the widest, mm.
        widest_mm: f64,
        /// Where that is, mm.
        at_mm: [f64; 3],
    },
    /// Stretches in which edges fold back on themselves were left out.
    FoldsLeftOut {
        /// How many.
        count: usize,
        /// Length of the longest, mm.
        longest_mm: f64,
        /// Where that is, mm.
        at_mm: [f64; 3],
    },
    /// Edges were cut where edges of neighbouring faces end.
    EdgesCut {
        /// How many.
        count: usize,
    },
    /// Edges shorter than the sewing tolerance were dropped.
    EdgesDropped {
        /// How many.
        count: usize,
    },
    /// Sliver faces were dropped.
    SliversDropped {
        /// Their names.
        faces: Vec<String>,
    },
    /// Faces given twice were dropped.
    RepeatedFaces {
        /// Each with the one that it repeats.
        faces: Vec<[String; 2]>,
    },
    /// Edges were joined and faces meshed more closely than usual.
    MadeCloser {
        /// Tolerance of edges, mm.
        edges_mm: f64,
        /// Deflection of faces, mm.
        faces_mm: f64,
        /// What goes wrong with more.
        reason: String,
    },
    /// A face was taken up to its natural boundary.
    Untrimmed {
        /// Its name.
        face: String,
        /// Why it cannot be trimmed.
        reason: String,
    },
    /// A face was left out.
    FaceLeftOut {
        /// Why.
        reason: String,
    },
    /// Sewing changed faces.
    FacesChanged {
        /// How many.
        count: usize,
        /// Of these, dropped.
        dropped: usize,
        /// Where most, and how far.
        farthest: Option<FarthestMove>,
    },
    /// Faces cannot be followed as the file trims them.
    NotAsTrimmed {
        /// Their names.
        faces: Vec<String>,
        /// Greatest distance from the sewn part, mm.
        moved_mm: f64,
    },
    /// Openings between exact faces are not closed.
    ExactOpeningsStay,
    /// The size of the part is unusual, and the file names no unit.
    UnitNotCertain {
        /// Longest side of its box in the unit taken, mm.
        across_mm: f64,
        /// Unit taken.
        unit: String,
        /// Other units in which the size is usual, with it, mm.
        others: Vec<(String, f64)>,
    },
    /// The part is too small or too large for a blade.
    SizeUnusual {
        /// Name of the file.
        file: String,
        /// Longest side of its box in the unit taken, mm.
        across_mm: f64,
        /// Unit taken.
        unit: String,
        /// Too small; else too large.
        small: bool,
        /// What to do; `None`: no plan is made.
        advice: Option<String>,
    },
    /// The unit is a guess.
    UnitGuessed {
        /// The unit taken.
        unit: String,
        /// Why.
        reason: String,
    },
    /// The blade is as slender as a wind turbine's.
    WindTurbine {
        /// Length over mean chord.
        ratio: f64,
        /// Length if the file is in metres, m.
        length_m: f64,
        /// Unit taken.
        unit: String,
    },
    /// A section of a table was left out at an end.
    SectionLeftOut {
        /// Where it is and why.
        reason: String,
    },
    /// A point of a table stands out from its neighbours.
    PointStandsOut {
        /// Place of its section.
        section: String,
        /// Its number in it, from 1.
        number: usize,
        /// Where it is, mm.
        at_mm: [f64; 3],
        /// How far it is off the middle of its neighbours, mm.
        off_mm: f64,
    },
    /// A table of sections was lofted.
    Lofted {
        /// Sections.
        sections: usize,
        /// Points were joined by their number; else sections were sampled.
        by_number: bool,
        /// Points round a section.
        around: usize,
        /// Sharp edges of a section.
        sharp_edges: usize,
        /// Greatest distance of the table's points from the surface, mm.
        greatest_mm: f64,
    },
    /// All edges of sections are taken as round.
    EdgesTakenAsRound {
        /// Why.
        reason: String,
    },
    /// How far a loft through half of the table misses the other half.
    LeftOutTest {
        /// `point` or `section`.
        of: String,
        /// Greatest distance, mm.
        greatest_mm: f64,
        /// Root mean square, mm.
        rms_mm: f64,
    },
    /// The part is a bladed wheel.
    Wheel {
        /// The wheel in words.
        wheel: String,
    },
    /// The model is an assembly.
    Assembly {
        /// How many bodies.
        bodies: usize,
        /// Number of the one with the airfoil, from 1.
        number: usize,
        /// That body in words.
        body: String,
    },
    /// The blade axis was given the other way round than it is found.
    AxisOpposite {
        /// The axis given.
        given: [f64; 3],
        /// The axis found.
        found: [f64; 3],
        /// Why that way round.
        reason: String,
    },
    /// Another blade axis than the one given looks far better.
    AxisElsewhere {
        /// The axis given.
        given: [f64; 3],
        /// The axis found.
        found: [f64; 3],
        /// Angle between both, degrees.
        apart_deg: f64,
        /// Scores of the found and the given one.
        scores: [f64; 2],
    },
    /// Sections along another direction look like an airfoil too.
    AxisRivalled {
        /// That direction.
        other: [f64; 3],
        /// Its score and that of the axis taken.
        scores: [f64; 2],
    },
    /// Sections are cut short by ends that are not square to the axis.
    EndsCutSections {
        /// Over this share of the part.
        share: f64,
    },
    /// Both ends are square to another direction than the axis.
    EndsSlanted {
        /// That direction.
        normal: [f64; 3],
        /// Its angle with the axis, degrees.
        off_deg: f64,
    },
    /// Sections reach neither end of the airfoil.
    EndsNotReached {
        /// Direction to which they are square.
        square_to: [f64; 3],
    },
    /// The blade leans.
    BladeLeans {
        /// Direction of its middle.
        middle: [f64; 3],
        /// Direction to which its sections are square.
        square_to: [f64; 3],
        /// Angle between both, degrees.
        lean_deg: f64,
    },
    /// A table's sections grow from the first to the last.
    RootNotCertain {
        /// Area of the last over that of the first.
        growth: f64,
    },
    /// No section looks like an airfoil.
    NoAirfoil {
        /// Likeness of the best.
        likeness: f64,
        /// The axis was given.
        axis_given: bool,
    },
    /// Sections look only partly like an airfoil.
    PartlyAirfoil {
        /// Likeness of the best.
        likeness: f64,
    },
}

/// Where sewing moved a surface farthest.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FarthestMove {
    /// How far, mm.
    pub mm: f64,
    /// Name of the face.
    pub face: String,
    /// Place, mm.
    pub at_mm: [f64; 3],
}
