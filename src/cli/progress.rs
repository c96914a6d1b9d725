//! How the command speaks while it works: one progress bar a stage on a terminal, plain lines elsewhere.

use std::io::IsTerminal;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::error::Stage;
use crate::observe::{Observer, Warning};

/// Shows progress and warnings; Ctrl-C asks the stages to stop.
pub struct Terminal {
    bar: ProgressBar,
    shown: AtomicUsize,
    stop: Arc<AtomicBool>,
    quiet: bool,
}

impl Terminal {
    /// A terminal observer; `quiet` shows no progress (warnings are still printed).
    pub fn new(quiet: bool) -> Self {
        let bar = ProgressBar::new(1);
        if quiet || !std::io::stderr().is_terminal() {
            bar.set_draw_target(ProgressDrawTarget::hidden());
        }
        if let Ok(style) = ProgressStyle::with_template("{msg:>9} {bar:40} {percent:>3} %  {elapsed} (left {eta})") {
            bar.set_style(style);
        }
        let stop = Arc::new(AtomicBool::new(false));
        let flag = Arc::clone(&stop);
        // A second handler in one process (tests) is refused; the first goes on working.
        let _ = ctrlc::set_handler(move || flag.store(true, Ordering::SeqCst));
        Terminal { bar, shown: AtomicUsize::new(usize::MAX), stop, quiet }
    }

    /// Takes the bar away.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

impl Observer for Terminal {
    fn progress(&self, stage: Stage, done: usize, total: usize) {
        if self.shown.swap(stage as usize, Ordering::Relaxed) != stage as usize {
            self.bar.set_message(stage.to_string());
            self.bar.reset();
            if self.bar.is_hidden() && !self.quiet {
                eprintln!("{stage} …");
            }
        }
        self.bar.set_length(total as u64);
        self.bar.set_position(done as u64);
    }

    fn warn(&self, warning: Warning) {
        self.bar.suspend(|| eprintln!("warning: {}: {}", warning.stage, warning.message));
    }

    fn cancelled(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}
