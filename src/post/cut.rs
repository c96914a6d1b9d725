//! The cutting lines: rounded words and inverse-time feeds, the same for all dialects.

use crate::artifact::Plan;
use crate::error::{Error, Result, Stage};

use super::text::Fixed;

/// Greatest and least feed word, 1/min: what controls read (Siemens: 0.001 to 999 999.999).
const FEED: [f64; 2] = [0.001, 999_999.999];

/// One cutting line.
pub(super) struct Cut<const N: usize> {
    /// Its words, rounded.
    pub(super) words: [Fixed; N],
    /// The same words of the position before.
    pub(super) before: [Fixed; N],
    /// Inverse time, 1/min, as text.
    pub(super) feed: String,
}

/// Checks that a plan can be written at all.
pub(super) fn well_formed(plan: &Plan) -> Result<()> {
    let n = plan.toolpath.locations.len();
    let bad = |m: String| Err(Error::usage(Stage::Post, m));
    if n < 2 {
        return bad(format!("the plan has {n} cutter locations, a program needs at least 2"));
    }
    for (name, rows) in [
        ("angles", plan.schedule.theta.len()),
        ("axis positions", plan.motion.position.len()),
        ("times", plan.motion.t_s.len()),
    ] {
        if rows != n {
            return bad(format!("the plan has {n} cutter locations but {rows} {name}"));
        }
    }
    let rows = plan.toolpath.locations.iter().zip(&plan.schedule.theta).zip(&plan.motion.position);
    for (i, ((l, theta), q)) in rows.enumerate() {
        let numbers = l.centre.iter().chain(l.normal.iter()).chain(q.iter()).chain([theta]);
        if !numbers.into_iter().all(|x| x.is_finite()) {
            return bad(format!("cutter location {i} of the plan has a value that is not a finite number"));
        }
    }
    if !plan.channel.b_rad.is_finite() {
        return bad("the head's angle B is not a finite number".into());
    }
    if let Some(i) = plan.motion.t_s.windows(2).position(|w| !(w[1] >= w[0] && w[1].is_finite())) {
        return bad(format!("time goes back or is not finite after cutter location {i}"));
    }
    Ok(())
}

/// Inverse time of a move, as text with at least six digits that count; never 0.
fn feed_word(dt_s: f64) -> String {
    let f = (60.0 / dt_s).clamp(FEED[0], FEED[1]);
    let before_point = f.log10().floor().max(0.0) as usize + 1;
    format!("{f:.*}", 8usize.saturating_sub(before_point).clamp(3, 6))
}

/// The cutting lines of a whole path. `rows`: the words' values at each location, in the units of the program;
/// `decimals`: of each word. A location whose words all round to those before is left out; its time goes to the next
/// line.
pub(super) fn cuts<const N: usize>(
    rows: impl IntoIterator<Item = [f64; N]>,
    t_s: &[f64],
    decimals: [usize; N],
) -> Result<Vec<Cut<N>>> {
    let mut out: Vec<Cut<N>> = Vec::with_capacity(t_s.len());
    let mut last: Option<([Fixed; N], f64)> = None;
    for (row, &t) in rows.into_iter().zip(t_s) {
        let words = rounded(&row, &decimals)?;
        match last {
            None => last = Some((words, t)),
            Some((before, _)) if before == words => {}
            Some((before, since)) => {
                out.push(Cut { words, before, feed: feed_word(t - since) });
                last = Some((words, t));
            }
        }
    }
    if out.is_empty() {
        return Err(Error::usage(Stage::Post, "the whole path rounds to a single position, there is nothing to cut"));
    }
    Ok(out)
}

/// Rounds one row of words.
pub(super) fn rounded<const N: usize>(row: &[f64; N], decimals: &[usize; N]) -> Result<[Fixed; N]> {
    let mut words = [Fixed::new(0.0, 0)?; N];
    for ((w, v), d) in words.iter_mut().zip(row).zip(decimals) {
        *w = Fixed::new(*v, *d)?;
    }
    Ok(words)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn feed_words_keep_time_and_are_never_zero() {
        for dt in [1e-9, 1e-4, 0.003, 0.02, 0.7, 3.0, 59.0, 4000.0, 1e9] {
            let f: f64 = feed_word(dt).parse().unwrap();
            assert!(f > 0.0);
            if (1e-4..1000.0).contains(&dt) {
                assert!((60.0 / f / dt - 1.0).abs() < 1e-5, "{dt} {f}");
            }
        }
    }

    #[test]
    fn a_repeated_position_gives_its_time_to_the_next_line() {
        let rows = [[0.0], [1.0], [1.000_000_1], [2.0]];
        let c = cuts(rows, &[0.0, 1.0, 2.0, 3.0], [5]).unwrap();
        let total: f64 = c.iter().map(|c| 60.0 / c.feed.parse::<f64>().unwrap()).sum();
        assert_eq!(c.len(), 2);
        assert!((total - 3.0).abs() < 1e-5);
    }
}
