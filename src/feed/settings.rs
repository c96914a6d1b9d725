//! `[feed]` of the job file.

use crate::settings::section;

section! {
    /// `[feed]`
    #[derive(Copy)]
    "feed" FeedSettings, FeedKeys, s {
        /// Greatest feed of the ball centre over the part, mm/min.
        ///
        /// The default is for finishing of blade steel with a ball cutter.
        feed_mm_min: f64 = 2000.0, 0.01..=1e6;
        /// Radius of the arcs on which the ball comes onto the path and leaves it, mm; 0: straight
        /// along the tool axis.
        ///
        /// Default: the ball radius where it is greater: the axes come up to their feed on the arc.
        lead_radius_mm: f64 = 2.0, 0.0..=1000.0;
        /// Program a curve that is smooth to the fourth derivative in place of straight moves from
        /// location to location.
        ///
        /// By default not: it takes the stage `smooth` and a second channel, and rounding that a
        /// control would do by itself is then left to the curve. `docs/smoothing.md` says what is
        /// gained.
        smooth: bool = false;
        /// Program a curve of as few polynomials as the search finds, with the ball within this
        /// distance of its place on the part, mm; for controls that take polynomials.
        ///
        /// By default not: `smooth` takes more polynomials, and makes the curve as smooth as they
        /// can.
        #[serde(skip_serializing_if = "Option::is_none")]
        fit_mm: f64 as Option<f64> = None, 1e-4..=0.05;
    }
}

impl FeedSettings {
    /// The key that asks for a smooth curve.
    pub fn curve_key(&self) -> &'static str {
        if self.fit_mm.is_some() { "feed.fit_mm" } else { "feed.smooth" }
    }
}
