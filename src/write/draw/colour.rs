//! The one scale of colours, for values from low to high.
//!
//! Viridis (van der Walt and Smith, released under CC0): lightness grows evenly all along, so it is
//! read alike with any colour vision and in black and white.

/// Evenly spaced stops, sRGB, low to high.
pub const STOPS: [[u8; 3]; 11] = [
    [0x44, 0x01, 0x54],
    [0x48, 0x24, 0x75],
    [0x41, 0x44, 0x87],
    [0x35, 0x5f, 0x8d],
    [0x2a, 0x78, 0x8e],
    [0x21, 0x91, 0x8c],
    [0x22, 0xa8, 0x84],
    [0x44, 0xbf, 0x70],
    [0x7a, 0xd1, 0x51],
    [0xbd, 0xdf, 0x26],
    [0xfd, 0xe7, 0x25],
];

/// For places without a value, sRGB.
pub const NONE: [u8; 3] = [0x8c, 0x8c, 0x8c];

/// sRGB of `share` (0 low, 1 high); [`NONE`] where it is not a number.
pub fn of(share: f64) -> [u8; 3] {
    if !share.is_finite() {
        return NONE;
    }
    let x = share.clamp(0.0, 1.0) * (STOPS.len() - 1) as f64;
    let i = (x.floor() as usize).min(STOPS.len() - 2);
    let f = x - i as f64;
    std::array::from_fn(|k| (f64::from(STOPS[i][k]) * (1.0 - f) + f64::from(STOPS[i + 1][k]) * f).round() as u8)
}

/// `#rrggbb`.
pub fn hex([r, g, b]: [u8; 3]) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lightness_grows_all_along() {
        let light = |s: f64| {
            let [r, g, b] = of(s).map(f64::from);
            0.2126 * r + 0.7152 * g + 0.0722 * b
        };
        assert!((0..100).all(|k| light(f64::from(k + 1) / 100.0) >= light(f64::from(k) / 100.0)));
        assert_eq!((of(0.0), of(2.0), of(f64::NAN)), (STOPS[0], STOPS[10], NONE));
        assert_eq!(hex(of(1.0)), "#fde725");
    }
}
