//! Loops whose rounds run at the same time, on the threads of the current pool.
//!
//! What a loop makes comes back in the order of its items. So nothing depends on the number of
//! threads as long as a round depends on its item alone; sums are for the caller to take, in that
//! order.
//!
//! All loops meet rayon in one function, which is compiled once. A chain of its parallel iterators
//! is compiled anew wherever it is written, thousands of lines of LLVM each time.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use rayon::prelude::*;

/// Pieces that a loop is cut into at most: enough to share out rounds of uneven cost, few enough
/// that sharing out costs nothing.
const MOST_PIECES: usize = 1024;

/// What `one` makes of every item, in order.
pub fn map<A: Send, T: Send>(items: impl IntoIterator<Item = A>, one: impl Fn(A) -> T + Sync) -> Vec<T> {
    made(1, &mut items.into_iter(), &one)
}

/// As [`map`], for rounds so short that a thread is to take at least so many of them in a row.
pub fn map_short<A: Send, T: Send>(
    in_a_row: usize,
    items: impl IntoIterator<Item = A>,
    one: impl Fn(A) -> T + Sync,
) -> Vec<T> {
    made(in_a_row, &mut items.into_iter(), &one)
}

/// As [`map`], for rounds that may fail.
///
/// # Errors
/// That of the first item, in order, that has one. Items behind one that has failed may be left
/// out.
pub fn try_map<A: Send, T: Send, E: Send>(
    items: impl IntoIterator<Item = A>,
    one: impl Fn(A) -> Result<T, E> + Sync,
) -> Result<Vec<T>, E> {
    let failed = AtomicUsize::new(usize::MAX);
    let all = map(items.into_iter().enumerate(), |(i, item)| {
        // Those before one that has failed still run: one of them may fail too.
        if i > failed.load(Ordering::Relaxed) {
            return None;
        }
        let made = one(item);
        if made.is_err() {
            failed.fetch_min(i, Ordering::Relaxed);
        }
        Some(made)
    });
    let mut out = Vec::with_capacity(all.len());
    for made in all {
        // What was left out is behind an error.
        let Some(made) = made else { break };
        out.push(made?);
    }
    Ok(out)
}

/// As [`map`], without the items of which `one` makes nothing.
pub fn filter_map<A: Send, T: Send>(items: impl IntoIterator<Item = A>, one: impl Fn(A) -> Option<T> + Sync) -> Vec<T> {
    let mut out = Vec::new();
    for made in map(items, one) {
        let Some(made) = made else { continue };
        out.push(made);
    }
    out
}

/// The items that are wanted, in order.
pub fn filter<A: Send>(items: impl IntoIterator<Item = A>, wanted: impl Fn(&A) -> bool + Sync) -> Vec<A> {
    filter_map(items, |item| wanted(&item).then_some(item))
}

/// The lists that `one` makes of every item, one after another.
pub fn flat_map<A: Send, T: Send>(items: impl IntoIterator<Item = A>, one: impl Fn(A) -> Vec<T> + Sync) -> Vec<T> {
    let mut out = Vec::new();
    for mut list in map(items, one) {
        out.append(&mut list);
    }
    out
}

/// What both make, each on a thread of its own where one is free.
pub fn both<A: Send, B: Send>(a: impl FnOnce() -> A + Send, b: impl FnOnce() -> B + Send) -> (A, B) {
    let (mut a, mut b) = (Slot::Item(a), Slot::Item(b));
    join(&mut || a.fill(|a| a()), &mut || b.fill(|b| b()));
    match (a, b) {
        (Slot::Made(a), Slot::Made(b)) => (a, b),
        _ => unreachable!("what does not return a value panics"),
    }
}

/// An item, and in its place what is made of it.
enum Slot<A, T> {
    Item(A),
    Taken,
    Made(T),
}

impl<A, T> Slot<A, T> {
    fn fill(&mut self, one: impl FnOnce(A) -> T) {
        if let Slot::Item(item) = std::mem::replace(self, Slot::Taken) {
            *self = Slot::Made(one(item));
        }
    }
}

/// Behind [`map`]: compiled for each pair of types, not for each loop.
fn made<A: Send, T: Send>(
    in_a_row: usize,
    items: &mut dyn Iterator<Item = A>,
    one: &(dyn Fn(A) -> T + Sync),
) -> Vec<T> {
    let (least, most) = items.size_hint();
    // Nothing to share out: without the detour.
    if most.is_some_and(|most| most <= in_a_row) || rayon::current_num_threads() == 1 {
        let mut out = Vec::with_capacity(least);
        for item in items {
            out.push(one(item));
        }
        return out;
    }
    let mut slots = Vec::with_capacity(least);
    for item in items {
        slots.push(Slot::Item(item));
    }
    let size = slots.len().div_ceil(MOST_PIECES).max(in_a_row).max(1);
    let mut pieces = Vec::with_capacity(slots.len().div_ceil(size));
    for piece in slots.chunks_mut(size) {
        pieces.push(Mutex::new(piece));
    }
    drive(pieces.len(), &|k| {
        // Each piece is taken once: nobody waits for the lock.
        let piece = std::mem::take(&mut *pieces[k].lock().unwrap_or_else(PoisonError::into_inner));
        for slot in piece {
            slot.fill(one);
        }
    });
    drop(pieces);
    let mut out = Vec::with_capacity(slots.len());
    for slot in slots {
        if let Slot::Made(made) = slot {
            out.push(made);
        }
    }
    out
}

fn drive(pieces: usize, work: &(dyn Fn(usize) + Sync)) {
    (0..pieces).into_par_iter().for_each(work);
}

fn join(a: &mut (dyn FnMut() + Send), b: &mut (dyn FnMut() + Send)) {
    rayon::join(a, b);
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    fn with_threads<T: Send>(count: usize, work: impl FnOnce() -> T + Send) -> T {
        rayon::ThreadPoolBuilder::new().num_threads(count).build().unwrap().install(work)
    }

    /// Harder and easier rounds, more and fewer than there are pieces.
    #[test]
    fn order_is_kept_on_any_number_of_threads() {
        let one = |k: usize| (0..k % 97 * 50).fold(k as f64, |sum, i| sum + (i as f64).sqrt());
        for n in [0, 1, 2, 1000, 5000] {
            let want: Vec<f64> = (0..n).map(one).collect();
            for threads in [1, 8] {
                with_threads(threads, || {
                    assert_eq!(map(0..n, one), want);
                    assert_eq!(map_short(64, 0..n, one), want);
                    assert_eq!(try_map(0..n, |k| Ok::<_, ()>(one(k))), Ok(want.clone()));
                    let lists: Vec<usize> = (0..n).flat_map(|k| vec![k; k % 3]).collect();
                    assert_eq!(flat_map(0..n, |k| vec![k; k % 3]), lists);
                    let even: Vec<usize> = (0..n).filter(|k| k % 2 == 0).collect();
                    assert_eq!(filter(0..n, |k| k % 2 == 0), even);
                    assert_eq!(filter_map(0..n, |k| (k % 2 == 0).then_some(k)), even);
                });
            }
        }
    }

    #[test]
    fn items_are_given_away_or_changed_where_they_are() {
        let mut names: Vec<String> = (0..100).map(|k| k.to_string()).collect();
        let lengths = map(&mut names, |name| {
            name.push('!');
            name.len()
        });
        assert_eq!((names[7].as_str(), lengths[7], lengths[42]), ("7!", 2, 3));
        assert_eq!(map(names, |name| name + "?")[99], "99!?");
    }

    #[test]
    fn the_first_error_is_told() {
        for threads in [1, 8] {
            let failing = |k: usize| if k % 300 == 299 { Err(k) } else { Ok(k) };
            assert_eq!(with_threads(threads, || try_map(0..3000, failing)), Err(299));
        }
    }

    #[test]
    fn panics_go_on() {
        let failing = |k: usize| assert!(k != 500, "round {k}");
        for threads in [1, 8] {
            let caught = std::panic::catch_unwind(|| with_threads(threads, || map(0..1000, failing)));
            assert_eq!(caught.unwrap_err().downcast_ref::<String>().unwrap(), "round 500");
            let caught = std::panic::catch_unwind(|| with_threads(threads, || both(|| 1, || failing(500))));
            assert!(caught.is_err());
        }
    }

    #[test]
    fn both_are_made_and_loops_may_stand_within_loops() {
        let sums = with_threads(4, || map(0..50, |k| both(|| map(0..k, |i| i).len(), || k).0));
        assert_eq!(sums, (0..50).collect::<Vec<_>>());
    }
}
