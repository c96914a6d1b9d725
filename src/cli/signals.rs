//! Ctrl-C, and what `kill`, `timeout` and a cluster's scheduler send: the first asks the stages to stop, so that nothing half-written is
//! left; a second one does not wait for them.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;

use crate::error::ErrorKind;

/// A flag that the signals set. A hang-up is not among them: who starts a long run with `nohup` means it to go on.
pub(super) fn stop_flag() -> Arc<AtomicBool> {
    let stop = Arc::new(AtomicBool::new(false));
    for signal in [SIGINT, SIGTERM] {
        // Refused only where the system has no such signal; the run then cannot be asked to stop, and goes on.
        let _ =
            flag::register_conditional_shutdown(signal, i32::from(ErrorKind::Cancelled.exit_code()), Arc::clone(&stop));
        let _ = flag::register(signal, Arc::clone(&stop));
    }
    stop
}
