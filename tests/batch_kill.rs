//! Slow suite: families killed at random moments and started again leave the bytes of an
//! undisturbed run.
//!
//! `just kill`.

use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use super::families::{FAMILY, same};

fn start(dir: &Path, out: &Path, shard: &str) -> Child {
    Command::new(env!("CARGO_BIN_EXE_bladewright"))
        .args(["--quiet", "batch", "family.toml", "--shard", shard, "-o"])
        .arg(out)
        .current_dir(dir)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the command starts")
}

/// SplitMix64: the same runs for the same seed.
struct Random(u64);

impl Random {
    fn below(&mut self, n: u64) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (z ^ (z >> 31)) % n
    }
}

#[test]
#[ignore = "slow: many runs, killed"]
fn killed_at_random_moments() {
    let number = |key: &str, or: u64| std::env::var(key).ok().and_then(|v| v.parse().ok()).unwrap_or(or);
    let (runs, mut random) = (number("BLADEWRIGHT_RUNS", 100), Random(number("BLADEWRIGHT_SEED", 1)));
    let dir = tempfile::tempdir().expect("temporary folder");
    let d = dir.path();
    std::fs::write(d.join("family.toml"), FAMILY).expect("writable");
    let (whole, begun) = (d.join("whole"), Instant::now());
    assert!(start(d, &whole, "1/1").wait().expect("it ends").success());
    let full_ms = u64::try_from(begun.elapsed().as_millis()).expect("short");
    let (mut kills, mut midway) = (0, 0);
    for run in 0..runs {
        let out = d.join("out");
        // Every third run is two processes on one folder of which one is killed; the others one
        // process, killed up to three times.
        if run % 3 == 2 {
            let (mut a, mut b) = (start(d, &out, "1/2"), start(d, &out, "2/2"));
            std::thread::sleep(Duration::from_millis(random.below(full_ms)));
            a.kill().expect("it can be killed");
            kills += 1;
            a.wait().expect("it ends");
            assert!(b.wait().expect("it ends").success(), "the other shard goes on");
        } else {
            for _ in 0..=random.below(3) {
                let mut child = start(d, &out, "1/1");
                std::thread::sleep(Duration::from_millis(random.below(full_ms)));
                child.kill().expect("it can be killed");
                kills += 1;
                child.wait().expect("it ends");
            }
        }
        let done = std::fs::read_dir(out.join("members")).map_or(0, Iterator::count);
        midway += u64::from(done > 0 && !out.join("family.html").exists());
        assert!(start(d, &out, "1/1").wait().expect("it ends").success());
        eprintln!("run {run}");
        same(&whole, &out);
        std::fs::remove_dir_all(&out).expect("removable");
    }
    eprintln!(
        "{runs} runs, {kills} kills, {midway} of them with some members done and others not: all trees are the same"
    );
    assert!(runs < 20 || midway > runs / 5, "the kills came too early or too late to tell anything");
}
