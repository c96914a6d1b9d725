//! How the command speaks while it works: one progress bar a stage with rate and time left on a
//! terminal, JSON lines with `--json`, nothing but warnings elsewhere.

use std::io::IsTerminal;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::out;
use crate::error::Stage;
use crate::observe::{Observer, Warning};

/// Least time between two lines of progress.
const BETWEEN: Duration = Duration::from_millis(200);

/// Shows progress and warnings; Ctrl-C asks the stages to stop.
pub struct Terminal {
    bar: ProgressBar,
    shown: AtomicUsize,
    told: Mutex<Option<Instant>>,
    json: bool,
    stop: Arc<AtomicBool>,
    quiet: bool,
}

impl Terminal {
    /// A terminal observer; `quiet` shows no progress (warnings are still printed).
    pub fn new(quiet: bool) -> Self {
        // Before anything is written: a reader of standard output that has gone to sleep must not
        // keep the signals from being heard.
        let stop = super::signals::stop_flag(super::signals::ONE_RUN);
        let bar = ProgressBar::new(1);
        let json = out::event(&serde_json::json!({ "event": "start", "program": crate::run::program() }));
        if quiet || json || !std::io::stderr().is_terminal() {
            bar.set_draw_target(ProgressDrawTarget::hidden());
        }
        if let Ok(style) =
            ProgressStyle::with_template("{msg:>9} {bar:40} {percent:>3} %  {per_sec}  {elapsed} (left {eta})")
        {
            bar.set_style(style);
        }
        Terminal { bar, shown: AtomicUsize::new(usize::MAX), told: Mutex::new(None), json, stop, quiet }
    }

    /// Takes the bar away.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

impl Terminal {
    /// A line of progress: a stage's first and last, and no more than some a second between.
    fn tell(&self, stage: Stage, done: usize, total: usize) {
        let Ok(mut last) = self.told.lock() else { return };
        if done < total && last.is_some_and(|t| t.elapsed() < BETWEEN) {
            return;
        }
        *last = Some(Instant::now());
        out::event(&serde_json::json!({
            "event": "progress", "stage": stage, "done": done, "total": total,
            "per_s": self.bar.per_sec(), "left_s": self.bar.eta().as_secs_f64(),
        }));
    }
}

impl Observer for Terminal {
    fn progress(&self, stage: Stage, done: usize, total: usize) {
        if self.shown.swap(stage as usize, Ordering::Relaxed) != stage as usize {
            self.bar.set_message(stage.to_string());
            self.bar.reset();
            if let Ok(mut told) = self.told.lock() {
                *told = None;
            }
        }
        self.bar.set_length(total as u64);
        self.bar.set_position(done as u64);
        if self.json && !self.quiet {
            self.tell(stage, done, total);
        }
    }

    fn warn(&self, warning: Warning) {
        let mut told = serde_json::json!(warning);
        told["event"] = "warning".into();
        if self.json && out::event(&told) {
            return;
        }
        self.bar.suspend(|| out::told(&format!("warning: {}: {}", warning.stage, warning.doubt)));
    }

    fn cancelled(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}
