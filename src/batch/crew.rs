//! Who works on what: members side by side, each with threads and memory of its own, never more of
//! either than there are.
//!
//! Every member runs in a thread pool of its own, so threads are never oversubscribed, however deep
//! the parallel loops inside are nested, and a member never waits inside another's loop. As long as
//! members are left for all threads, each gets one thread, which loses nothing to synchronisation;
//! the last ones get several. Costly members come first. A member that needs more memory than is
//! free waits while smaller ones go on; one that needs more than there is runs alone.

use std::collections::BTreeSet;
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};

use crate::error::{Error, ErrorKind, Result, Stage};

/// One piece of work.
#[derive(Clone, Copy, Debug)]
pub(super) struct Task {
    /// Its number.
    pub id: usize,
    /// Likely effort.
    pub cost: f64,
    /// Likely peak of memory, MiB.
    pub memory_mib: u64,
    /// A task whose result helps with this one: it goes first.
    pub after: Option<usize>,
}

/// What there is to share out.
#[derive(Clone, Copy, Debug)]
pub(super) struct Means {
    /// Threads.
    pub threads: usize,
    /// Memory, MiB.
    pub memory_mib: u64,
}

struct State {
    /// Tasks not begun, the costliest first.
    waiting: Vec<Task>,
    /// Numbers of tasks that have not ended.
    open: BTreeSet<usize>,
    /// Tasks at work, with what they hold.
    running: Vec<(usize, Means)>,
    free: Means,
    /// The first error that stops everything.
    failed: Option<Error>,
}

impl State {
    fn blocked(&self, task: &Task) -> bool {
        task.after.is_some_and(|id| self.open.contains(&id))
    }

    /// The next task that may begin, with what it gets.
    fn next(&mut self) -> Option<(Task, Means)> {
        if self.free.threads == 0 {
            return None;
        }
        let ready = self.waiting.iter().filter(|t| !self.blocked(t)).count();
        let alone = self.running.is_empty();
        let place =
            self.waiting.iter().position(|t| !self.blocked(t) && (alone || t.memory_mib <= self.free.memory_mib))?;
        let task = self.waiting.remove(place);
        let large = task.memory_mib >= self.free.memory_mib;
        let threads = if large { self.free.threads } else { (self.free.threads / ready.max(1)).max(1) };
        let held = Means { threads, memory_mib: task.memory_mib.min(self.free.memory_mib) };
        self.free.threads -= held.threads;
        self.free.memory_mib -= held.memory_mib;
        self.running.push((task.id, held));
        Some((task, held))
    }

    fn give_back(&mut self, id: usize) {
        self.open.remove(&id);
        if let Some(k) = self.running.iter().position(|r| r.0 == id) {
            let (_, held) = self.running.swap_remove(k);
            self.free.threads += held.threads;
            self.free.memory_mib += held.memory_mib;
        }
    }
}

/// Works on all tasks. `work` is called in a pool of as many threads as its argument says; its
/// first error stops the rest, as does `stop`.
///
/// # Errors
/// The first of `work`.
pub(super) fn run(
    mut tasks: Vec<Task>,
    means: Means,
    stop: &(dyn Fn() -> bool + Sync),
    work: &(dyn Fn(usize, usize) -> Result<()> + Sync),
) -> Result<()> {
    tasks.sort_by(|a, b| b.cost.total_cmp(&a.cost).then(a.id.cmp(&b.id)));
    let state = Mutex::new(State {
        open: tasks.iter().map(|t| t.id).collect(),
        waiting: tasks,
        running: Vec::new(),
        free: means,
        failed: None,
    });
    let (state, changed) = (&state, &Condvar::new());
    std::thread::scope(|scope| {
        let mut s = lock(state);
        loop {
            if s.failed.is_some() || stop() {
                s.waiting.clear();
            }
            if let Some((task, held)) = s.next() {
                scope.spawn(move || {
                    let ended = in_pool(held.threads, || work(task.id, held.threads));
                    let mut s = lock(state);
                    s.give_back(task.id);
                    if let Err(e) = ended {
                        s.failed.get_or_insert(e);
                    }
                    changed.notify_all();
                });
            } else if s.running.is_empty() {
                break;
            } else {
                s = changed.wait(s).unwrap_or_else(PoisonError::into_inner);
            }
        }
    });
    lock(state).failed.take().map_or(Ok(()), Err)
}

fn lock(state: &Mutex<State>) -> MutexGuard<'_, State> {
    state.lock().unwrap_or_else(PoisonError::into_inner)
}

fn in_pool(threads: usize, work: impl FnOnce() -> Result<()> + Send) -> Result<()> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.map_err(|e| {
        Error::new(Stage::Batch, ErrorKind::InputOutput, format!("a pool of {threads} threads cannot be started: {e}"))
    })?;
    pool.install(work)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};

    fn task(id: usize, memory_mib: u64, after: Option<usize>) -> Task {
        Task { id, cost: 100.0 - id as f64, memory_mib, after }
    }

    #[test]
    fn threads_and_memory_are_never_exceeded_and_all_is_done() {
        let means = Means { threads: 3, memory_mib: 100 };
        let tasks: Vec<Task> = (0..30).map(|k| task(k, [10, 60, 45, 90, 500][k % 5], None)).collect();
        let (threads, memory, done) = (AtomicUsize::new(0), AtomicU64::new(0), Mutex::new(Vec::new()));
        let need = |id: usize| [10, 60, 45, 90, 500][id % 5];
        run(tasks, means, &|| false, &|id, n| {
            let t = threads.fetch_add(n, Ordering::SeqCst) + n;
            let m = memory.fetch_add(need(id), Ordering::SeqCst) + need(id);
            assert!(t <= 3, "{t} threads");
            assert!(m <= 100 || m == 500, "{m} MiB");
            assert_eq!(rayon::current_num_threads(), n);
            std::thread::yield_now();
            memory.fetch_sub(need(id), Ordering::SeqCst);
            threads.fetch_sub(n, Ordering::SeqCst);
            done.lock().unwrap().push(id);
            Ok(())
        })
        .unwrap();
        let mut done = done.into_inner().unwrap();
        done.sort_unstable();
        assert_eq!(done, (0..30).collect::<Vec<_>>());
    }

    #[test]
    fn helpers_go_first_and_an_error_stops_the_rest() {
        let order = Mutex::new(Vec::new());
        let tasks = vec![task(0, 1, Some(2)), task(1, 1, Some(2)), task(2, 1, None)];
        run(tasks, Means { threads: 2, memory_mib: 10 }, &|| false, &|id, n| {
            order.lock().unwrap().push((id, n));
            Ok(())
        })
        .unwrap();
        let order = order.into_inner().unwrap();
        assert_eq!(order[0], (2, 2), "the helper comes first and has all threads");
        assert_eq!(order.len(), 3);
        let begun = AtomicUsize::new(0);
        let ended = run(
            (0..9).map(|k| task(k, 1, None)).collect(),
            Means { threads: 1, memory_mib: 1 },
            &|| false,
            &|id, _| {
                begun.fetch_add(1, Ordering::SeqCst);
                if id == 3 { Err(Error::io(Stage::Output, "full")) } else { Ok(()) }
            },
        );
        assert_eq!((ended.unwrap_err().message.as_str(), begun.into_inner()), ("full", 4));
    }
}
