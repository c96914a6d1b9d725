//! What is in the tool's way, and the channel's width among it.

use super::Setup;
use crate::artifact::channel::Width;
use crate::artifact::{Blade, Obstacle, Plan};
use crate::channel::{self, Surroundings};
use crate::error::{Result, Stage};
use crate::job::Job;
use crate::observe::Observer;
use crate::read::model;
use crate::run::manifest::{self, Input};

/// Angles B that a report looks at (from, to, step, degrees).
const REPORT_SWEEP_DEG: [f64; 3] = [-20.0, 45.0, 5.0];
/// Locations of the path that it looks at for each, about: whole turns, in some seconds.
const REPORT_PLACES: usize = 3000;

impl Setup {
    /// Angles B from the first to the second by the third, degrees, as far as the machine leans the tool.
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
        if self.job.channel.exact_ends {
            return self.finer_surroundings();
        }
        Surroundings::new(&self.blade, &self.obstacles, self.job.tool.radius_mm)
    }

    /// The same with a finer index of exact faces, for ends of the channel that are theirs.
    ///
    /// # Errors
    /// Kind `Usage`: an empty or damaged mesh.
    pub fn finer_surroundings(&self) -> Result<Surroundings<'_>> {
        let radius_mm = self.job.tool.radius_mm;
        Ok(Surroundings::new(&self.blade, &self.obstacles, radius_mm)?.finer(radius_mm))
    }
}

/// Fixtures and stock in the blade frame; their files are inputs.
pub(super) fn obstacles(
    job: &Job,
    blade: &Blade,
    inputs: &mut Vec<Input>,
    observer: &dyn Observer,
) -> Result<Vec<Obstacle>> {
    let mut all = job.fixture.iter().map(|f| (false, f)).chain(job.stock.iter().map(|f| (true, f)));
    all.try_fold(Vec::new(), |mut out, (stock, f)| {
        inputs.push(manifest::input(&f.file, Stage::Model, if stock { "stock.file" } else { "fixture.file" })?);
        let room = [f.clearance_mm, f.holder_clearance_mm];
        out.push(model::obstacle(&f.file, f.unit, stock, room, &blade.model_from_blade, observer)?);
        Ok(out)
    })
}

/// The channel's width against B for a report.
pub(super) fn widths(setup: &Setup, plan: &Plan, observer: &dyn Observer) -> Result<Vec<Width>> {
    let (around, options, angles) = (setup.surroundings()?, setup.channel_options(), setup.angles_b(REPORT_SWEEP_DEG));
    channel::sweep_b(&around, &setup.job.tool, &plan.toolpath, &options, &angles, REPORT_PLACES, observer)
}
