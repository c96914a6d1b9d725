//! What is in the tool's way, and the channel's width among it.

use super::Setup;
use crate::artifact::channel::Width;
use crate::artifact::{Channel, Plan, Toolpath};
use crate::channel::{self, ChannelOptions, Leans, Surroundings};
use crate::error::Result;
use crate::observe::Observer;

/// Angles B that a report looks at (from, to, step, degrees).
const REPORT_SWEEP_DEG: [f64; 3] = [-20.0, 45.0, 5.0];
/// Locations of the path that it looks at for each, about: whole turns, in some seconds.
const REPORT_PLACES: usize = 3000;

impl Setup {
    /// Angles B from the first to the second by the third, degrees, as far as the machine leans the
    /// tool.
    pub fn angles_b(&self, [from, to, step]: [f64; 3]) -> Vec<f64> {
        let count = ((to - from) / step + 1e-9).floor().clamp(0.0, 1000.0) as u32;
        let all = (0..=count).map(|k| from + f64::from(k) * step);
        all.filter(|b| b.abs() <= 85.0 && self.machine.leans(b.to_radians())).collect()
    }

    /// What is in the tool's way, indexed.
    ///
    /// # Errors
    /// Kind `Usage`: an empty or damaged mesh.
    pub fn surroundings(&self) -> Result<Surroundings<'_>> {
        self.surroundings_of(self.job.tool.radius_mm)
    }

    /// The same for a ball of this radius, mm.
    ///
    /// # Errors
    /// As [`Setup::surroundings`].
    pub fn surroundings_of(&self, radius_mm: f64) -> Result<Surroundings<'_>> {
        let around = Surroundings::new(&self.blade, &self.obstacles, radius_mm)?;
        Ok(if self.job.channel.exact_ends { around.finer(radius_mm) } else { around })
    }

    /// The same with a finer index of exact faces, for ends of the channel that are theirs.
    ///
    /// # Errors
    /// Kind `Usage`: an empty or damaged mesh.
    pub fn finer_surroundings(&self) -> Result<Surroundings<'_>> {
        let radius_mm = self.job.tool.radius_mm;
        Ok(Surroundings::new(&self.blade, &self.obstacles, radius_mm)?.finer(radius_mm))
    }

    /// The channel along a path, with the moves after these locations proven.
    pub(super) fn channel_proven(
        &self,
        path: &Toolpath,
        prove_at: &[usize],
        exact_ends: bool,
        observer: &dyn Observer,
    ) -> Result<Channel> {
        let (around, options) = self.proving(prove_at, exact_ends)?;
        channel::plan_among(&around, &self.job.tool, path, &options, observer)
    }

    /// A channel with the moves after these locations proven too, its other walls as they are;
    /// `None` where that leaves nothing.
    pub(super) fn channel_with_proven(
        &self,
        (path, channel): (&Toolpath, &Channel),
        prove_at: &[usize],
        exact_ends: bool,
        observer: &dyn Observer,
    ) -> Result<Option<Channel>> {
        let (around, options) = self.proving(prove_at, exact_ends)?;
        channel::proven(&around, &self.job.tool, (path, channel), &options, observer)
    }

    /// What moves are proven among, and how.
    fn proving(&self, prove_at: &[usize], exact_ends: bool) -> Result<(Surroundings<'_>, ChannelOptions)> {
        let options = ChannelOptions { prove_at: prove_at.to_vec(), ..self.channel_options() };
        let around = if exact_ends { self.finer_surroundings()? } else { self.surroundings()? };
        Ok((around, options.with(|s| s.exact_ends = exact_ends)))
    }

    /// The channel's width against B for a report.
    ///
    /// # Errors
    /// Those of [`channel::sweep_b`].
    pub fn widths(&self, plan: &Plan, observer: &dyn Observer) -> Result<Vec<Width>> {
        let (around, options, angles) = (self.surroundings()?, self.channel_options(), self.angles_b(REPORT_SWEEP_DEG));
        let leans = Leans { b_deg: &angles, places: REPORT_PLACES };
        channel::sweep_b(&around, &self.job.tool, &plan.toolpath.of_corner(), &options, leans, observer)
    }
}
