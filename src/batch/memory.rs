//! How much memory there is to share out.

/// Taken where the system does not give it, MiB.
const UNKNOWN_MIB: u64 = 4096;

/// 80 % of what is available now, within the limit of the control group that this process is in,
/// MiB.
pub(super) fn to_share() -> u64 {
    let text = |path: &str| std::fs::read_to_string(path).ok();
    let available = text("/proc/meminfo").and_then(|t| kib_of(&t, "MemAvailable:")).map(|kib| kib >> 10);
    let number = |path: &str| text(path)?.trim().parse::<u64>().ok().map(|b| b >> 20);
    let group = number("/sys/fs/cgroup/memory.max").or_else(|| number("/sys/fs/cgroup/memory/memory.limit_in_bytes"));
    let least = available.into_iter().chain(group).min().unwrap_or(UNKNOWN_MIB);
    (least * 8 / 10).max(1)
}

fn kib_of(text: &str, key: &str) -> Option<u64> {
    text.lines().find_map(|l| l.strip_prefix(key))?.split_whitespace().next()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn meminfo_is_read() {
        let text = "MemTotal:       24000000 kB\nMemAvailable:   20480000 kB\n";
        assert_eq!(kib_of(text, "MemAvailable:"), Some(20_480_000));
        assert_eq!(kib_of("MemTotal: 1 kB", "MemAvailable:"), None);
        assert!(to_share() >= 1);
    }
}
