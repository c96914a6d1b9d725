//! The command line.
/// Runs the command; the exit code says how it ended.
pub fn run() -> std::process::ExitCode {
    std::process::ExitCode::SUCCESS
}
