//! What the targets share: bytes as a file of one format, read, healed and surveyed, with a mutator that knows numbers and lines.

/// A target: any bytes as a file of this name are a survey or an error. Half of the mutations are libFuzzer's own, half those of
/// `mutate.rs`, which damage numbers, lines and counts.
macro_rules! reader {
    ($name:literal) => {
        #[path = "../mutate.rs"]
        mod mutate;

        libfuzzer_sys::fuzz_target!(|data: &[u8]| {
            let options = bladewright::model::ModelOptions { deflection_mm: 0.5, ..Default::default() };
            let path = std::path::Path::new($name);
            let _ = bladewright::model::survey_bytes(path, data, &options, &bladewright::observe::Silent);
        });

        libfuzzer_sys::fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
            let mut random = mutate::Random(u64::from(seed));
            if random.below(2) == 0 {
                return libfuzzer_sys::fuzzer_mutate(data, size, max_size);
            }
            let made = mutate::mutated(&data[..size], &mut random);
            let kept = made.len().min(max_size);
            data[..kept].copy_from_slice(&made[..kept]);
            kept
        });
    };
}
