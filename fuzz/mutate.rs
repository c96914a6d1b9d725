//! Damage to model files: a seeded, structure-aware mutation. Used by `examples/fuzz_readers.rs`,
//! by the short form in the test suite, and by the mutator of the targets of this folder.

use std::sync::Once;
use std::sync::atomic::{AtomicU64, Ordering};

static OWN_PANICS: AtomicU64 = AtomicU64::new(0);

/// From now on panics of the library's own code are counted, also where a reader makes a sentence
/// of them, as it has to where a parser of others panics.
pub fn count_own_panics() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let before = std::panic::take_hook();
        std::panic::set_hook(Box::new(move |panic| {
            // Paths of the package that is tested are relative, those of its dependencies are not:
            // their panics are expected, and silent.
            let place = panic.location().map_or("", |place| place.file());
            OWN_PANICS.fetch_add(u64::from(place.starts_with("src/")), Ordering::SeqCst);
            if !place.contains("/registry/") {
                before(panic);
            }
        }));
    });
}

/// How many there were.
pub fn own_panics() -> u64 {
    OWN_PANICS.load(Ordering::SeqCst)
}

/// SplitMix64 (Steele, Lea, Flood 2014): small, seeded, good enough to choose faults.
pub struct Random(pub u64);

impl Random {
    /// The next number.
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }
    /// A number below `n`; 0 for `n` of 0.
    pub fn below(&mut self, n: usize) -> usize {
        if n == 0 { 0 } else { (self.next() % n as u64) as usize }
    }
}

/// Numbers that readers are not prepared for.
const NUMBERS: [&str; 18] = [
    "0",
    "-1",
    "1",
    "2",
    "nan",
    "inf",
    "-inf",
    "1e400",
    "1e-400",
    "1e308",
    "-1e300",
    "4294967295",
    "4294967296",
    "2147483648",
    "18446744073709551616",
    "0.0000001",
    "999999",
    "",
];

/// The bytes with one to four faults.
pub fn mutated(bytes: &[u8], random: &mut Random) -> Vec<u8> {
    let mut out = bytes.to_vec();
    for _ in 0..1 + random.below(4) {
        let text = out.iter().take(4096).filter(|b| **b == 0).count() == 0;
        match random.below(if text { 9 } else { 5 }) {
            0 => flip(&mut out, random),
            1 => truncate(&mut out, random),
            2 => word(&mut out, random),
            3 => copy_within(&mut out, random),
            4 => cut_out(&mut out, random),
            5 | 6 => number(&mut out, random),
            7 => swap_lines(&mut out, random),
            _ => drop_line(&mut out, random),
        }
    }
    out
}

fn flip(out: &mut [u8], random: &mut Random) {
    let at = random.below(out.len());
    if let Some(b) = out.get_mut(at) {
        *b ^= 1 << random.below(8);
    }
}

fn truncate(out: &mut Vec<u8>, random: &mut Random) {
    let keep = random.below(out.len() + 1);
    out.truncate(keep);
}

/// Four bytes become a number that a count or an index may not be.
fn word(out: &mut [u8], random: &mut Random) {
    // Half of the time in the head, where counts are.
    let reach = if random.below(2) == 0 { out.len().min(256) } else { out.len() };
    let at = random.below(reach.saturating_sub(4));
    let values = [0u32, 1, 0xff, 0xffff, 0x7fff_ffff, 0x8000_0000, 0xffff_ffff, 0x7fc0_0000, 0x7f80_0000];
    let value = values[random.below(values.len())];
    if let Some(slot) = out.get_mut(at..at + 4) {
        slot.copy_from_slice(&value.to_le_bytes());
    }
}

fn copy_within(out: &mut [u8], random: &mut Random) {
    let length = 1 + random.below(64);
    let (from, to) = (random.below(out.len()), random.below(out.len()));
    if from + length <= out.len() && to + length <= out.len() {
        out.copy_within(from..from + length, to);
    }
}

fn cut_out(out: &mut Vec<u8>, random: &mut Random) {
    let at = random.below(out.len());
    let end = (at + 1 + random.below(200)).min(out.len());
    out.drain(at..end);
}

/// A number of the text becomes another.
fn number(out: &mut Vec<u8>, random: &mut Random) {
    let from = random.below(out.len());
    let digit = |b: &u8| b.is_ascii_digit() || [b'.', b'-', b'+', b'e', b'E'].contains(b);
    let Some(start) = out.iter().skip(from).position(u8::is_ascii_digit).map(|k| k + from) else { return };
    let end = out.iter().skip(start).position(|b| !digit(b)).map_or(out.len(), |k| k + start);
    let new = NUMBERS[random.below(NUMBERS.len())].bytes();
    out.splice(start..end, new);
}

fn lines(out: &[u8]) -> Vec<std::ops::Range<usize>> {
    let mut at = 0;
    out.split_inclusive(|b| *b == b'\n')
        .map(|l| {
            let r = at..at + l.len();
            at = r.end;
            r
        })
        .collect()
}

fn swap_lines(out: &mut Vec<u8>, random: &mut Random) {
    let all = lines(out);
    let (i, j) = (random.below(all.len()), random.below(all.len()));
    let (Some(a), Some(b)) = (all.get(i.min(j)), all.get(i.max(j))) else { return };
    let (a, b) = (a.clone(), b.clone());
    if a.end <= b.start {
        let mixed = [&out[..a.start], &out[b.clone()], &out[a.end..b.start], &out[a.clone()], &out[b.end..]].concat();
        *out = mixed;
    }
}

fn drop_line(out: &mut Vec<u8>, random: &mut Random) {
    let all = lines(out);
    if let Some(r) = all.get(random.below(all.len())) {
        out.drain(r.clone());
    }
}
