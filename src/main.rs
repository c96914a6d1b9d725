//! The command `bladewright`; everything is in the library.
fn main() -> std::process::ExitCode {
    bladewright::cli::run()
}
