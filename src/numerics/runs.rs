//! Runs in lists of flags.

use std::ops::Range;

/// The longest run of flags that are set, the first of equals; empty where none is.
pub fn longest(flags: &[bool]) -> Range<usize> {
    let (mut best, mut from) = (0..0, 0);
    for k in 0..=flags.len() {
        if flags.get(k) == Some(&true) {
            continue;
        }
        if k - from > best.len() {
            best = from..k;
        }
        from = k + 1;
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_longest_run_is_found_at_either_end_and_amid() {
        let of = |text: &str| longest(&text.chars().map(|c| c == 'x').collect::<Vec<_>>());
        assert_eq!((of(""), of("..."), of("xxx")), (0..0, 0..0, 0..3));
        assert_eq!((of("xx.x"), of("x.xx"), of(".xx.x"), of("x.x")), (0..2, 2..4, 1..3, 0..1));
    }
}
