//! A plan in memory: its numbers, figures, checks and programs.

use std::path::{Path, PathBuf};

use bladewright::artifact::program::Control;
use bladewright::artifact::toolpath::CutterLocation;
use bladewright::artifact::{AxisMotion, AxisRows, Plan, Program};
use bladewright::error::{Error, ErrorKind, Result, Stage};
use bladewright::geometry::{Point, Vector};
use bladewright::machine::Axis;
use bladewright::run::{self, Outcome, inputs};
use bladewright::verify::{Verdict, Verified};
use bladewright::write::post::Dialect;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};

use super::call;
use super::error::raised;

/// One of the tables of a motion.
type Column = fn(&AxisMotion) -> &AxisRows;

/// A plan that was made.
#[pyclass(frozen)]
pub struct Planned {
    outcome: Outcome,
}

impl Planned {
    /// Of a run that went to its end.
    pub fn new(outcome: Outcome) -> Self {
        Planned { outcome }
    }

    fn verdict(&self) -> Result<&Verdict<Plan>> {
        let none = || Error::usage(Stage::Feed, "planning ended before the motion");
        self.outcome.verdict.as_ref().ok_or_else(none)
    }

    fn plan(&self, py: Python<'_>) -> PyResult<&Plan> {
        Ok(self.verdict().map_err(|e| raised(py, &e))?.value())
    }
}

/// Numbers as the bytes of an array.
fn numbers(py: Python<'_>, values: impl Iterator<Item = f64>) -> Bound<'_, PyBytes> {
    PyBytes::new(py, &values.flat_map(f64::to_ne_bytes).collect::<Vec<u8>>())
}

/// A value as JSON.
fn json(py: Python<'_>, value: &impl serde::Serialize) -> PyResult<String> {
    run::json_compact(value).map_err(|e| raised(py, &e))
}

#[pymethods]
impl Planned {
    /// Cutter locations by name, as the bytes of arrays of 64-bit numbers in the model frame.
    fn locations<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let (plan, to_model) = (self.plan(py)?, &self.outcome.setup.blade.model_from_blade);
        let path = &plan.toolpath;
        let at = &path.locations;
        let turns: Vec<u8> = at.iter().flat_map(|l| i64::from(l.turn).to_ne_bytes()).collect();
        let points = |f: fn(&_) -> Point| numbers(py, at.iter().flat_map(move |l| xyz((to_model * f(l)).coords)));
        let stands = path.stands(&plan.schedule.theta).enumerate();
        let tool_axes = stands.map(|(k, stand)| to_model * path.cone(k).tool_axis(stand.theta));
        let rows = &plan.channel.rows;
        let out = PyDict::new(py);
        out.set_item("turn", PyBytes::new(py, &turns))?;
        out.set_item("turn_s_mm", numbers(py, at.iter().map(|l| l.turn_s_mm)))?;
        out.set_item("s_mm", numbers(py, at.iter().map(|l| l.s_mm)))?;
        out.set_item("centre_mm", points(|l: &CutterLocation| l.centre))?;
        out.set_item("contact_mm", points(|l: &CutterLocation| l.contact))?;
        out.set_item("normal", numbers(py, at.iter().flat_map(|l| xyz(to_model * l.normal))))?;
        out.set_item("axis", numbers(py, tool_axes.flat_map(xyz)))?;
        out.set_item("theta_rad", numbers(py, plan.schedule.theta.iter().copied()))?;
        out.set_item("theta_min_rad", numbers(py, rows.iter().map(|r| r.theta_min)))?;
        out.set_item("theta_max_rad", numbers(py, rows.iter().map(|r| r.theta_max)))?;
        out.set_item("feed_mm_min", numbers(py, plan.motion.feed.iter().map(|f| f * 60.0)))?;
        Ok(out)
    }

    /// Axis motion by name: names, units, and the bytes of arrays; leads stand before and behind.
    fn axes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let (plan, axes) = (self.plan(py)?, self.outcome.setup.machine.axes());
        let [before, after] = &plan.leads;
        let parts = [&before.motion, &plan.motion, &after.motion];
        let out = PyDict::new(py);
        out.set_item("names", axes.iter().map(|a| a.name.as_str()).collect::<Vec<_>>())?;
        out.set_item("units", axes.iter().map(Axis::unit).collect::<Vec<_>>())?;
        out.set_item("first_location", before.motion.t_s.len())?;
        out.set_item("time_s", numbers(py, parts.iter().flat_map(|m| m.t_s.iter().copied())))?;
        let columns: [(&str, Column); 4] = [
            ("position", |m| &m.position),
            ("velocity", |m| &m.velocity),
            ("acceleration", |m| &m.acceleration),
            ("jerk", |m| &m.jerk),
        ];
        for (name, of) in columns {
            let values = parts.iter().flat_map(|m| (0..m.t_s.len()).map(move |k| of(m).get(k)));
            let shown = |row: Option<&[f64]>| {
                let value = |(i, a): (usize, &Axis)| row.and_then(|r| r.get(i)).map_or(f64::NAN, |v| a.shown(*v));
                axes.iter().enumerate().map(value).collect::<Vec<f64>>()
            };
            out.set_item(name, numbers(py, values.flat_map(shown)))?;
        }
        Ok(out)
    }

    /// Machining time, s.
    fn time_s(&self, py: Python<'_>) -> PyResult<f64> {
        Ok(self.plan(py)?.motion.time_s)
    }

    /// The figures, as JSON.
    fn summary(&self, py: Python<'_>) -> PyResult<String> {
        json(py, &self.outcome.summary)
    }

    /// What the checks found, as JSON.
    fn report(&self, py: Python<'_>) -> PyResult<String> {
        json(py, &self.outcome.report)
    }

    /// What the user should know, as JSON.
    fn warnings(&self, py: Python<'_>) -> PyResult<String> {
        json(py, &self.outcome.warnings)
    }

    /// The job with every default, as a job file.
    fn job(&self, py: Python<'_>) -> PyResult<String> {
        self.outcome.setup.job.to_toml().map_err(|e| raised(py, &e))
    }

    /// The tool, and why it is this one.
    fn tool(&self) -> (String, String) {
        let tool = &self.outcome.setup.tool;
        (tool.in_words(), tool.why.clone())
    }

    /// Files that were written.
    fn files(&self) -> Vec<PathBuf> {
        self.outcome.files.clone()
    }

    /// A program for a control, or by an own post file: its file name and its text.
    fn program(&self, py: Python<'_>, control: PathBuf) -> PyResult<(String, String)> {
        call::run(py, None, None, |_| {
            let program = self.post(&dialect(&control)?)?;
            Ok((program.file_name, program.text))
        })
    }
}

impl Planned {
    fn post(&self, dialect: &Dialect) -> Result<Program> {
        let (program, checks) = self.outcome.setup.program(dialect, self.verified()?)?;
        match checks.iter().find(|c| !c.passed) {
            None => Ok(program),
            Some(c) => Err(Error::new(
                Stage::Post,
                ErrorKind::Findings,
                format!("{} does not come back as planned when it is read: {} {}", program.file_name, c.id, c.note),
            )
            .advise("where words are rounded too much, write more digits in the post file")),
        }
    }

    fn verified(&self) -> Result<&Verified<Plan>> {
        match self.verdict()? {
            Verdict::Passed(verified) => Ok(verified),
            Verdict::Failed(_) => {
                Err(Error::new(Stage::Verify, ErrorKind::Findings, "the plan fails its checks, so it has no program")
                    .advise("mend the job and plan again, or plan with force=True"))
            }
        }
    }
}

/// A control by its name, or a post file by its path.
fn dialect(control: &Path) -> Result<Dialect> {
    if control.extension().is_some_and(|e| e.eq_ignore_ascii_case("toml")) {
        return inputs::dialect(control);
    }
    let name = control.to_string_lossy();
    let known = Control::ALL.iter().find(|c| c.to_string() == name).copied();
    let control = known.ok_or_else(|| {
        let all: Vec<String> = Control::ALL.iter().map(ToString::to_string).collect();
        Error::usage(Stage::Post, format!("`{name}` is no control"))
            .advise(format!("one of {}, or the path of a post file (.toml)", all.join(", ")))
    })?;
    Dialect::built_in(control)
}

fn xyz(v: Vector) -> [f64; 3] {
    [v.x, v.y, v.z]
}
