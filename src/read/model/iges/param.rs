//! Parameters as IGES defines them against those of our NURBS.
//!
//! Arcs in IGES run with the angle; as rational quadratics they do not. Inside a segment of half
//! angle `h` the angle `φ` from its middle and the parameter `x` in [0, 1] belong together by
//! `2x − 1 = tan(φ/2) / tan(h/2)`.

/// One stretch of a parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParamSpan {
    /// In the file.
    pub file: [f64; 2],
    /// In our NURBS.
    pub ours: [f64; 2],
    /// Half the angle of the arc segment, rad; `None` where both run evenly.
    pub half: Option<f64>,
}

/// A monotone map from the file's parameter to ours.
#[derive(Clone, Debug, PartialEq)]
pub struct ParamMap(pub Vec<ParamSpan>);

impl ParamMap {
    /// Even from one range to another.
    pub fn even(file: [f64; 2], ours: [f64; 2]) -> Self {
        ParamMap(vec![ParamSpan { file, ours, half: None }])
    }

    /// Arc segments of equal angle: knots stand at the angles.
    pub fn arcs(from: f64, to: f64, segments: usize) -> Self {
        let at = |k: usize| from + (to - from) * k as f64 / segments as f64;
        let half = 0.5 * (to - from) / segments as f64;
        ParamMap(
            (0..segments)
                .map(|k| [at(k), at(k + 1)])
                .map(|r| ParamSpan { file: r, ours: r, half: Some(half) })
                .collect(),
        )
    }

    /// One map behind the other, the file's parameter running on.
    pub fn chain(maps: &[ParamMap]) -> Self {
        let mut out: Vec<ParamSpan> = Vec::new();
        for map in maps {
            let Some(first) = map.0.first() else { continue };
            let shift = |end: fn(&ParamSpan) -> f64, begin: f64| out.last().map_or(0.0, |s| end(s) - begin);
            let (f, o) = (shift(|s| s.file[1], first.file[0]), shift(|s| s.ours[1], first.ours[0]));
            out.extend(map.0.iter().map(|s| ParamSpan {
                file: s.file.map(|x| x + f),
                ours: s.ours.map(|x| x + o),
                ..*s
            }));
        }
        ParamMap(out)
    }

    /// The same with the file's parameter (or ours) running over another range.
    #[must_use]
    pub fn over(mut self, file: Option<[f64; 2]>, ours: Option<[f64; 2]>) -> Self {
        let (Some(first), Some(last)) = (self.0.first().copied(), self.0.last().copied()) else { return self };
        let ranges = [[first.file[0], last.file[1]], [first.ours[0], last.ours[1]]];
        let even = |x: f64, [a, b]: [f64; 2], [c, d]: [f64; 2]| c + (x - a) / (b - a) * (d - c);
        for s in &mut self.0 {
            if let Some(to) = file {
                s.file = s.file.map(|x| even(x, ranges[0], to));
            }
            if let Some(to) = ours {
                s.ours = s.ours.map(|x| even(x, ranges[1], to));
            }
        }
        self
    }

    /// Our parameter; evenly continued beyond the ends.
    pub fn ours(&self, x: f64) -> f64 {
        let Some(s) = self.0.iter().find(|s| x <= s.file[1]).or(self.0.last()) else { return x };
        let share = (x - s.file[0]) / (s.file[1] - s.file[0]);
        let share = match s.half {
            Some(h) if (0.0..=1.0).contains(&share) => {
                0.5 * (1.0 + ((2.0 * share - 1.0) * 0.5 * h).tan() / (0.5 * h).tan())
            }
            _ => share,
        };
        s.ours[0] + share * (s.ours[1] - s.ours[0])
    }

    /// Whether equal steps in the file are equal steps of ours.
    pub fn is_even(&self) -> bool {
        self.0.len() == 1 && self.0[0].half.is_none()
    }
}
