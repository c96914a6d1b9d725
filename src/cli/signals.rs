//! Ctrl-C, and what `kill`, `timeout` and a cluster's scheduler send: the first asks the stages to
//! stop, so that nothing half-written is left; where they do not hear it in time, the program ends
//! all the same. A second one does not wait for them.

use std::sync::atomic::AtomicBool;
use std::sync::{Arc, OnceLock};
use std::time::Duration;

use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;

use crate::error::ErrorKind;

/// How long a run has to stop by itself. The files of a run come in together or not at all, so what
/// this cuts off is nowhere half-done.
pub(super) const ONE_RUN: Duration = Duration::from_secs(2);
/// How long a family has: its members stop, then its tables are written. A cluster kills after 30
/// s.
pub(super) const FAMILY: Duration = Duration::from_secs(20);

/// A flag that the signals set, one for the whole process. A hang-up is not among them: a user who
/// starts a long run with `nohup` means it to go on.
pub(super) fn stop_flag(patience: Duration) -> Arc<AtomicBool> {
    static STOP: OnceLock<Arc<AtomicBool>> = OnceLock::new();
    Arc::clone(STOP.get_or_init(|| {
        let stop = Arc::new(AtomicBool::new(false));
        // First: a signal that comes in between ends the program then, where the flag would not
        // have heard it.
        end_after(patience, &stop);
        for signal in [SIGINT, SIGTERM] {
            // Refused only where the system has no such signal; the run then cannot be asked to
            // stop, and goes on.
            let _ = flag::register_conditional_shutdown(signal, exit_code(), Arc::clone(&stop));
            let _ = flag::register(signal, Arc::clone(&stop));
        }
        stop
    }))
}

fn exit_code() -> i32 {
    i32::from(ErrorKind::Cancelled.exit_code())
}

/// Ends the program some time after the first signal: a stage may be at something that cannot be
/// stopped, or a reader of what it prints asleep.
#[cfg(unix)]
fn end_after(patience: Duration, _stop: &Arc<AtomicBool>) {
    use std::io::Read;
    use std::os::unix::net::UnixStream;
    let Ok((mut heard, tell)) = UnixStream::pair() else { return };
    for signal in [SIGINT, SIGTERM] {
        let Ok(tell) = tell.try_clone() else { return };
        let _ = signal_hook::low_level::pipe::register(signal, tell);
    }
    std::thread::spawn(move || {
        // The other end stays open as long as the process lives.
        if heard.read_exact(&mut [0]).is_ok() {
            std::thread::sleep(patience);
            std::process::exit(exit_code());
        }
    });
}

/// The same where there are no pipes that a signal may write to: Windows.
#[cfg(not(unix))]
fn end_after(patience: Duration, stop: &Arc<AtomicBool>) {
    use std::sync::atomic::Ordering;
    let stop = Arc::clone(stop);
    std::thread::spawn(move || {
        while !stop.load(Ordering::Relaxed) {
            std::thread::sleep(Duration::from_millis(100));
        }
        std::thread::sleep(patience);
        std::process::exit(exit_code());
    });
}
