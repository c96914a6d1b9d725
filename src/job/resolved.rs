//! The resolved job: every value settled, ready to be saved with the run and run again as it is.

use serde::{Deserialize, Serialize};

use super::sections::{FixtureSettings, ModelSettings, RegionSettings, WheelSettings};
use crate::artifact::toolpath::PathKind;
use crate::channel::ChannelSettings;
use crate::error::{Error, Result, Stage};
use crate::feed::FeedSettings;
use crate::machine::MachineSettings;
use crate::orient::{OrientationKind, OrientationSettings};
use crate::pair::PinchSettings;
use crate::path::PathSettings;
use crate::schedule::ScheduleSettings;
use crate::section::SectionSettings;
use crate::settings::{Number, TINY, check};
use crate::tool::{Chip, CutSettings, Tool};
use crate::verify::VerifySettings;
use crate::write::post::PostSettings;

/// A complete job. Its TOML is a job file again.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Job {
    /// The CAD file and how to read it.
    pub model: ModelSettings,
    /// Where to machine.
    pub region: RegionSettings,
    /// The helix.
    pub path: PathSettings,
    /// What the tool axis may do.
    pub channel: ChannelSettings,
    /// The machine.
    pub machine: MachineSettings,
    /// What the tool axis does.
    pub schedule: ScheduleSettings,
    /// How fast.
    pub feed: FeedSettings,
    /// Programs to write.
    pub post: PostSettings,
    /// Limits of the checks.
    pub verify: VerifySettings,
    /// Sections to report.
    pub section: SectionSettings,
    /// The tool.
    pub tool: Tool,
    /// The second of two tools on one blade, for `pinch`. Default, left out: like the first.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tool_2: Option<Tool>,
    /// What else is in the tool's way. Default, left out: nothing.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub fixture: Vec<FixtureSettings>,
    /// Material that is still to be cut away: the holder keeps clear of it. Default, left out:
    /// none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stock: Option<FixtureSettings>,
    /// The wheel that the blade belongs to. Default, left out: the blade stands alone.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wheel: Option<WheelSettings>,
    /// What each tooth cuts. Default, left out: not looked at.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cut: Option<CutSettings>,
    /// Which tool axes there are to choose from. Default, left out: the one cone of a root.
    #[serde(default, skip_serializing_if = "OrientationSettings::is_usual")]
    pub orientation: OrientationSettings,
    /// Two tools on one blade, for `pinch`. Default, left out: as that verb has it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pinch: Option<PinchSettings>,
}

impl Job {
    /// Checks every number.
    ///
    /// # Errors
    /// `Usage` naming key, value and limits.
    pub fn validate(&self) -> Result<()> {
        let number = |key: &str, value: &dyn Number, range| check(Stage::Job, key, value, &range);
        self.model.check(Stage::Job)?;
        number("region.start_mm", &self.region.start_mm, -1e6..=1e6)?;
        number("region.end_mm", &self.region.end_mm, -1e6..=1e6)?;
        number("tool.radius_mm", &self.tool.radius_mm, TINY..=1000.0)?;
        number("path.scallop_mm", &self.path.scallop_mm, TINY..=0.5 * self.tool.radius_mm)?;
        self.path.check(Stage::Job)?;
        self.channel.check(Stage::Job)?;
        self.machine.check(Stage::Job)?;
        self.schedule.check(Stage::Job)?;
        self.feed.check(Stage::Job)?;
        self.verify.check(Stage::Job)?;
        self.post.check(Stage::Job)?;
        self.section.check(Stage::Job)?;
        for f in self.fixture.iter().chain(&self.stock) {
            f.check(Stage::Job)?;
        }
        self.tool.validate()?;
        if let Some(second) = &self.tool_2 {
            number("tool_2.radius_mm", &second.radius_mm, 2.0 * self.path.scallop_mm..=1000.0)?;
            second.validate().map_err(super::tool::of_second)?;
        }
        self.chip()?;
        self.orientation.check(Stage::Job)?;
        self.pinch.iter().try_for_each(|p| p.check(Stage::Job))?;
        if let Some(wheel) = &self.wheel {
            wheel.validate()?;
        } else if !self.orientation.kind.goes_round() {
            let message =
                "orientation.kind is not cone, but the job has no section wheel, and its model is no whole wheel";
            return Err(Error::usage(Stage::Job, message)
                .advise("give wheel.blades and wheel.axis, or leave orientation.kind out"));
        }
        self.check_fit()?;
        for (key, is_set) in [(self.feed.curve_key(), self.feed.smooth), ("channel.sweep_b", self.channel.sweep_b)] {
            if is_set && !self.orientation.kind.goes_round() {
                let message =
                    format!("{key} is for one cone of tool axes, orientation.kind asks for one at each location");
                return Err(Error::usage(Stage::Job, message).advise(format!("leave out {key} or orientation.kind")));
            }
        }
        if self.path.kind == PathKind::HubRows {
            self.check_rows()?;
        }
        if !self.tool.is_ball() {
            self.check_cornered()?;
        }
        if self.region.end_mm.is_some_and(|end| end >= self.region.start_mm) {
            let (a, b) = (self.region.start_mm, self.region.end_mm.unwrap_or_default());
            return Err(Error::usage(
                Stage::Job,
                format!(
                    "region.end_mm ({b}) must be less than region.start_mm ({a}): the helix runs down to the platform"
                ),
            ));
        }
        if self.post.control.is_empty() && self.post.files.is_empty() {
            return Err(Error::usage(Stage::Job, "post.control is empty, it must name at least one control"));
        }
        Ok(())
    }

    /// What a fit wants of the rest of the job.
    fn check_fit(&self) -> Result<()> {
        let Some(fit_mm) = self.feed.fit_mm else { return Ok(()) };
        if !self.feed.smooth {
            let message = format!("feed.fit_mm is {fit_mm}, which asks for a smooth curve, but feed.smooth is false");
            return Err(Error::usage(Stage::Job, message).advise("leave out feed.smooth or feed.fit_mm"));
        }
        let (gouge_mm, chord_mm) = (self.verify.gouge_mm, self.path.chord_mm);
        // The moves between places of the curve are checked too: they are off it by the chord.
        let most_mm = gouge_mm - chord_mm;
        if fit_mm > most_mm + TINY {
            let message = format!(
                "feed.fit_mm is {fit_mm}, it must be at most {most_mm:.4}: verify.gouge_mm ({gouge_mm}) less path.chord_mm ({chord_mm})"
            );
            return Err(Error::usage(Stage::Job, message).advise("allow more with verify.gouge_mm, or fit closer"));
        }
        Ok(())
    }

    /// What rows over a hub want of the rest of the job.
    fn check_rows(&self) -> Result<()> {
        let wants = |what: &str, advice: &str| {
            Err(Error::usage(Stage::Job, format!("path.kind is hub-rows, {what}")).advise(advice))
        };
        if self.orientation.kind != OrientationKind::FiveAxis {
            return wants("which five axes mill", "set orientation.kind to five-axis");
        }
        if !self.tool.is_ball() {
            return wants("but the tool is no ball-end cutter", "leave out tool.corner_radius_mm");
        }
        if self.region.end_mm.is_some() || !self.region.end_faces.is_empty() {
            return wants(
                "but the region ends at a height or at faces of the blade: rows go over the hub, from the one blade to the next",
                "leave out region.end_mm and region.end_faces",
            );
        }
        if self.path.compare {
            return wants("but path.compare asks for paths that go round the blade", "leave out path.compare");
        }
        Ok(())
    }

    /// What is done with ball-end cutters only.
    fn check_cornered(&self) -> Result<()> {
        let of_balls = [
            (!self.orientation.kind.goes_round(), "orientation.kind other than cone"),
            (self.feed.smooth, self.feed.curve_key()),
            (self.path.compare, "path.compare"),
            (self.channel.prove_moves, "channel.prove_moves, and schedules along a wall,"),
            (self.channel.exact_ends, "channel.exact_ends"),
        ];
        for (is_asked, what) in of_balls {
            if is_asked {
                let corner = self.tool.corner_mm();
                let message = format!("{what} is for ball-end cutters, but tool.corner_radius_mm is {corner}");
                return Err(Error::usage(Stage::Job, message).advise("leave it out, or take a ball"));
            }
        }
        if self.channel.contact_angle_min_deg >= self.channel.contact_angle_max_deg
            || self.channel.contact_angle_max_deg > 90.0
        {
            let [least, most] = [self.channel.contact_angle_min_deg, self.channel.contact_angle_max_deg];
            let message = format!(
                "a cutter with a corner is to lean by {least}° to {most}°: the first must be less than the second, and that at most 90°"
            );
            return Err(Error::usage(Stage::Job, message)
                .advise("change channel.contact_angle_min_deg or channel.contact_angle_max_deg"));
        }
        Ok(())
    }

    /// What the teeth may cut; `None` where the job says nothing of it.
    ///
    /// # Errors
    /// `Usage` naming key, value and limits.
    pub fn chip(&self) -> Result<Option<Chip>> {
        self.cut.map(|cut| Chip::of(&cut, &self.tool, self.post.spindle_rpm)).transpose()
    }

    /// The job as the text of a job file.
    ///
    /// # Errors
    /// `InputOutput` if a path is not Unicode.
    pub fn to_toml(&self) -> Result<String> {
        toml::to_string(self)
            .map_err(|e| Error::io(Stage::Job, format!("the resolved job cannot be written as TOML: {e}")))
    }
}
