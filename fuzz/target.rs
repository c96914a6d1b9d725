//! What the targets share: bytes as a file of one format, read, healed and surveyed, with a mutator
//! that knows numbers and lines.

/// A target: any bytes as a file of this name are a survey or an error. Half of the mutations are
/// libFuzzer's own, half those of `mutate.rs`, which damage numbers, lines and counts.
#[allow(unused_macros)]
macro_rules! reader {
    ($name:literal) => {
        #[path = "../mutate.rs"]
        mod mutate;

        libfuzzer_sys::fuzz_target!(|data: &[u8]| {
            let options = bladewright::read::model::ModelOptions { deflection_mm: 0.5, ..Default::default() };
            let path = std::path::Path::new($name);
            let _ = bladewright::read::model::survey_bytes(path, data, &options, &bladewright::observe::Silent);
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

/// A target: any bytes as a program of a family are moves or an error.
#[allow(unused_macros)]
macro_rules! program {
    ($name:literal) => {
        #[path = "../mutate.rs"]
        mod mutate;
        #[path = "../nc.rs"]
        mod nc;

        libfuzzer_sys::fuzz_target!(|data: &[u8]| {
            static SHOP: std::sync::OnceLock<nc::Shop> = std::sync::OnceLock::new();
            let shop = SHOP.get_or_init(|| nc::Shop::new().expect("the built-in machine"));
            let _ = shop.moved($name, data);
        });

        libfuzzer_sys::fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
            let mut random = mutate::Random(u64::from(seed));
            if random.below(2) == 0 {
                return libfuzzer_sys::fuzzer_mutate(data, size, max_size);
            }
            // An empty input grows from a program as posts write it.
            let seeds = nc::seeds();
            let own: Vec<_> = seeds.iter().filter(|(name, _)| name.ends_with($name)).collect();
            let from = if size < 16 { &own[random.below(own.len())].1[..] } else { &data[..size] };
            let made = nc::damaged($name, from, &mut random);
            let kept = made.len().min(max_size);
            data[..kept].copy_from_slice(&made[..kept]);
            kept
        });
    };
}
