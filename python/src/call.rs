//! Long work beside the interpreter. The work runs on threads of its own without the interpreter's
//! lock. The calling thread looks up ten times a second: it hands progress and warnings to Python
//! and notices Ctrl-C, which Python reports to its main thread alone.

use std::collections::VecDeque;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use bladewright::error::{Error, Result, Stage};
use bladewright::observe::{Observer, Warning};
use pyo3::prelude::*;

use super::error::{fault, raised};

/// Time between two looks.
const BETWEEN: Duration = Duration::from_millis(100);

/// What the work has to report.
enum News {
    Progress(Stage, usize, usize),
    Warning(Warning),
}

#[derive(Default)]
struct State {
    news: VecDeque<News>,
    over: bool,
}

/// Between the work and the thread that called for it.
#[derive(Default)]
struct Desk {
    state: Mutex<State>,
    ended: Condvar,
    stop: AtomicBool,
}

impl Desk {
    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Waits for a while, or until the work is over; says whether it is.
    fn wait(&self) -> bool {
        let waited = self.ended.wait_timeout_while(self.state(), BETWEEN, |s| !s.over);
        waited.unwrap_or_else(PoisonError::into_inner).0.over
    }

    /// Hands all news to Python.
    fn hand_over(&self, py: Python<'_>, progress: Option<&Bound<'_, PyAny>>) -> PyResult<()> {
        // Taken out first: what Python does with it may take its time.
        let news = std::mem::take(&mut self.state().news);
        for one in news {
            match (one, progress) {
                (News::Progress(stage, done, total), Some(progress)) => {
                    progress.call1((stage.to_string(), done, total))?;
                }
                (News::Progress(..), None) => {}
                (News::Warning(w), _) => {
                    let log = py.import("logging")?.call_method1("getLogger", ("bladewright",))?;
                    log.call_method1("warning", ("%s: %s", w.stage.to_string(), w.doubt.to_string()))?;
                }
            }
        }
        Ok(())
    }
}

impl Observer for Desk {
    fn progress(&self, stage: Stage, done: usize, total: usize) {
        let mut state = self.state();
        // Nobody looks at each of a hundred thousand steps.
        if matches!(state.news.back(), Some(News::Progress(last, ..)) if *last == stage) {
            state.news.pop_back();
        }
        state.news.push_back(News::Progress(stage, done, total));
    }
    fn warn(&self, warning: Warning) {
        self.state().news.push_back(News::Warning(warning));
    }
    fn cancelled(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}

/// Tells the end of the work, also of one that panics.
struct Ending<'a>(&'a Desk);

impl Drop for Ending<'_> {
    fn drop(&mut self) {
        self.0.state().over = true;
        self.0.ended.notify_all();
    }
}

/// Does the work on so many threads (`None`: one for each core). An exception of `progress` and
/// Ctrl-C ask it to stop, and are raised once it has.
pub fn run<T: Send>(
    py: Python<'_>,
    threads: Option<usize>,
    progress: Option<&Bound<'_, PyAny>>,
    work: impl FnOnce(&dyn Observer) -> Result<T> + Send,
) -> PyResult<T> {
    let pool = if threads == Some(0) {
        Err("there must be at least one".to_owned())
    } else {
        let builder = rayon::ThreadPoolBuilder::new().num_threads(threads.unwrap_or(0));
        builder.build().map_err(|e| e.to_string())
    };
    let pool = pool
        .map_err(|e| raised(py, &Error::usage(Stage::Job, format!("the threads asked for cannot be started: {e}"))))?;
    let desk = Desk::default();
    let mut exception = None;
    let ended = std::thread::scope(|scope| {
        let worker = scope.spawn(|| {
            let _ending = Ending(&desk);
            pool.install(|| work(&desk))
        });
        loop {
            let over = py.detach(|| desk.wait());
            if exception.is_none()
                && let Err(e) = py.check_signals().and_then(|()| desk.hand_over(py, progress))
            {
                desk.stop.store(true, Ordering::Relaxed);
                exception = Some(e);
            }
            if over {
                break worker.join();
            }
        }
    });
    match (exception, ended) {
        (Some(e), _) => Err(e),
        (None, Ok(Ok(value))) => Ok(value),
        (None, Ok(Err(e))) => Err(raised(py, &e)),
        (None, Err(panic)) => Err(fault(py, panic.as_ref())),
    }
}
