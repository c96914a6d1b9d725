//! NC programs as text.

/// A ball of a program that others wrote touches the part where it is this near to it, mm: more
/// than the chords of their path and the rounding of their words, less than any stock.
pub const TOUCHES_MM: f64 = 0.02;

/// The controls that a program can be written for: each is a post file that is built in.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, serde::Serialize, serde::Deserialize, schemars::JsonSchema,
)]
#[serde(rename_all = "kebab-case")]
pub enum Control {
    /// Siemens 840D: `TRAORI`, rotary axes as positions, `program.mpf`.
    Siemens,
    /// Siemens 840D: `TRAORI`, the tool axis as the vector `A3 B3 C3`, `program.vector.mpf`.
    SiemensVector,
    /// Siemens 840D: `TRAORI`, tool tip and rotary axes as polynomials (`POLY`),
    /// `program.poly.mpf`.
    SiemensPoly,
    /// Siemens 840D without transformation, as on lathes: positions of the machine's axes,
    /// `program.axes.mpf`.
    SiemensAxes,
    /// Heidenhain TNC: `TCPM`, rotary axes as positions, `program.h`.
    Heidenhain,
    /// Heidenhain TNC: `TCPM`, ball centre and rotary axes as splines of degree 3 (`SPL`, an option
    /// of the iTNC 530), `program.spl.h`.
    HeidenhainSpl,
    /// Heidenhain TNC: `TCPM`, `LN` blocks with the tool axis as a vector, `program.vector.h`.
    HeidenhainVector,
    /// Fanuc: `G43.4`, rotary axes as positions, `program.nc`.
    Fanuc,
    /// Fanuc: `G43.5`, the tool axis as the vector `I J K`, `program.vector.nc`.
    FanucVector,
    /// Fanuc without tool-centre-point control, as on lathes: positions of the machine's axes,
    /// `program.axes.nc`.
    FanucAxes,
    /// The same with NURBS interpolation (`G06.2`) of the smooth curve, `program.nurbs.nc`.
    FanucNurbs,
    /// LinuxCNC with trivial kinematics, inverse time, `program.ngc`.
    Linuxcnc,
    /// LinuxCNC with trivial kinematics, feed per minute, `program.feed.ngc`.
    LinuxcncFeed,
    /// Any control without tool-centre-point control: positions of the machine's axes,
    /// `program.iso.nc`.
    Iso,
    /// APT cutter-location file, `program.apt`.
    Apt,
}

impl Control {
    /// All of them.
    pub const ALL: [Control; 15] = [
        Control::Siemens,
        Control::SiemensVector,
        Control::SiemensPoly,
        Control::SiemensAxes,
        Control::Heidenhain,
        Control::HeidenhainSpl,
        Control::HeidenhainVector,
        Control::Fanuc,
        Control::FanucVector,
        Control::FanucAxes,
        Control::FanucNurbs,
        Control::Linuxcnc,
        Control::LinuxcncFeed,
        Control::Iso,
        Control::Apt,
    ];
}

impl std::fmt::Display for Control {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&super::word(self))
    }
}

/// How the text of a program is to be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Grammar {
    /// Words of an address and a number: ISO 6983, Siemens, Fanuc, LinuxCNC.
    Gcode,
    /// Heidenhain Klartext.
    Heidenhain,
    /// APT: major words, a slash, minor words and numbers.
    Apt,
}

/// What X, Y and Z of a cutting line mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Programmed {
    /// The tool tip in the blade frame.
    Tip,
    /// The ball centre in the blade frame.
    Centre,
    /// The machine's axes.
    Machine,
}

/// How a program is to be understood, beside its text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Language {
    /// Its grammar.
    pub grammar: Grammar,
    /// Its coordinates.
    pub programmed: Programmed,
    /// Rotary words go the shortest way: a modulo axis, or one with a setting for it.
    pub shortest_way: bool,
    /// F per minute is along all axes of a line together, a degree counted as a millimetre; else it
    /// is along X, Y and Z, and of rotary axes on lines that turn only.
    pub feed_counts_degrees: bool,
}

/// Where the length of the tool comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LengthOffset {
    /// The program does not say.
    #[default]
    Unsaid,
    /// It is not taken into account.
    Off,
    /// A number of the offset table, `H`.
    Number(u32),
    /// A cutting edge of the tool, `D`.
    Edge(u32),
}

/// How the spindle turns.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Turning {
    /// It stands.
    #[default]
    Off,
    /// Clockwise, seen from the spindle: `M3`.
    Right,
    /// Counter-clockwise: `M4`.
    Left,
}

/// What is set while a line moves.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Setting {
    /// The length of the tool.
    pub length: LengthOffset,
    /// The spindle.
    pub turning: Turning,
    /// Its speed, 1/min; `None`: not said.
    pub rpm: Option<f64>,
    /// How far the control may leave the programmed path, mm; `None`: not said.
    pub tolerance_mm: Option<f64>,
    /// The program says that rotary axes turn evenly: `ORIAXES`.
    pub axes_evenly: bool,
}

/// What an operation of a program was written with.
#[derive(Clone, Debug, PartialEq)]
pub struct Asked {
    /// Tool number.
    pub tool_number: u32,
    /// Spindle speed, 1/min.
    pub spindle_rpm: f64,
    /// What is set where it begins to move at a feed.
    pub setting: Setting,
    /// Work offset: 54 for `G54`.
    pub frame: Option<u32>,
}

/// What a control reads in the words of an address, by its manual.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WordRange {
    /// Least value.
    pub least: f64,
    /// Greatest value.
    pub greatest: f64,
    /// Most digits after the point.
    pub decimals: usize,
}

/// Words and what a control reads in them, by address.
pub type Ranges = std::collections::BTreeMap<String, WordRange>;

/// Where the time of an operation goes, s. Tool changes, and the way from wherever the machine
/// stood, are in none: no file says how long they take.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct CycleTime {
    /// From the end of travel over the part down to where the lead-in begins.
    pub approach_s: f64,
    /// On the arc onto the path.
    pub lead_in_s: f64,
    /// Along the path.
    pub cutting_s: f64,
    /// On the arc off the path.
    pub lead_out_s: f64,
    /// Up to the end of travel.
    pub retract_s: f64,
    /// The rotary axes back to where they began.
    pub unwinding_s: f64,
    /// All of it.
    pub total_s: f64,
}

/// A line that moves the tool by the plan: on a lead, or on the path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CutLine {
    /// Its number in the text, from 1; of a move that takes several lines the last.
    pub line: usize,
    /// The plan's time at which the tool is where the line ends, s.
    pub until_s: f64,
}

/// A program.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    /// The control, in words.
    pub control: String,
    /// Name of its file.
    pub file_name: String,
    /// How it is to be understood.
    pub language: Language,
    /// What its control reads in its words.
    pub ranges: Ranges,
    /// Where the time of each operation goes.
    pub cycles: Vec<CycleTime>,
    /// The text, lines ended by `\n`.
    pub text: String,
    /// Where the tool is as its lines move it, operation by operation in the order of time.
    pub cut_lines: Vec<CutLine>,
    /// What its operations were written with, in their order; whatever the text may have become
    /// since.
    pub asked: Vec<Asked>,
}
