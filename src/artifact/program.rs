//! NC programs as text.

/// The controls that a program can be written for.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize, schemars::JsonSchema, clap::ValueEnum,
)]
#[serde(rename_all = "kebab-case")]
pub enum Control {
    /// Siemens 840D, `program.mpf`.
    Siemens,
    /// LinuxCNC, `program.ngc`.
    Linuxcnc,
}

impl Control {
    /// File name of the program.
    pub fn file_name(self) -> &'static str {
        match self {
            Control::Siemens => "program.mpf",
            Control::Linuxcnc => "program.ngc",
        }
    }
}

/// A program.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    /// For which control.
    pub control: Control,
    /// The text, lines ended by `\n`.
    pub text: String,
}
