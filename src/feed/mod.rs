//! Feed: from path and schedule to the motion of the machine's axes over time.
//!
//! In: [`Toolpath`], [`Schedule`], [`Machine`], [`FeedOptions`]. Out: [`AxisMotion`], the fastest
//! motion along the path that keeps the programmed feed of the ball centre and every axis' velocity
//! and acceleration, from rest to rest.
//!
//! ## Equations
//! The machine's inverse kinematics give axis positions `q` at the cutter locations; a natural
//! cubic spline over the arc length `s` of ball centres gives `q(s)`, twice continuously
//! differentiable. With `x = ṡ²` and `u = s̈`
//!
//! ```text
//! |q'| √x ≤ v_max,      |q' u + q'' x| ≤ a_max,      √x ≤ feed,      dx/ds = 2u
//! ```
//!
//! all limits are linear in `(x, u)`. The fastest profile is found by reachability analysis (Pham
//! and Pham 2018, "A new approach to time-optimal path parameterization based on reachability
//! analysis", IEEE T-RO 34(3)): backwards the greatest `x` from which the end can still be reached,
//! forwards the greatest `u` that stays below it (`topp` module). `u` is constant between
//! locations. Unlike the published scheme, which imposes the limits at the locations only, they are
//! imposed on the Bernstein coefficients of every interval, which bound it as a whole.
//!
//! On a programmed curve ([`ProgrammedCurve`]) `q(s)` is what the kinematics make of ball centre
//! and θ on it, as polynomials of degree 5 (`curve` module), and `s` is its parameter.
//!
//! With limits of jerk (the default) `w = u'` is constant between points of a grid instead, `u` and
//! so every axis' acceleration is continuous, and the least time is found by an interior-point
//! method, stretch by stretch (`jerk` module).
//!
//! Further limits of ṡ: the *contact point* is not to run faster over the part than the programmed
//! feed (in a concave corner of radius `r` it runs `r/(r − R)` times as fast as the ball centre),
//! and the *tool tip's chord*: over one period `T` of the control's interpolation a path of
//! curvature κ is left by `κ (v T)²/8`, which is kept below the chord tolerance.
//!
//! ## Guarantees
//! On the spline, at every location and anywhere between two, no limit of feed, velocity,
//! acceleration or (where limited) jerk is exceeded by more than rounding (1e-6 relative): what is
//! left of the solver's tolerance is taken out by running the whole slower. Same output for any
//! number of threads; time and memory are linear in the number of locations. Within jerk a bound is
//! proved: no motion on the grid takes less time by more than a share (`jerk::bound`), and a
//! warning gives that share where it is large.
//!
//! ## Limits of the method
//! Where the path has a corner (a crease of the level set, where a ball leaves a fillet uncut) the
//! spline rounds it within about one interval and its great derivatives slow the motion there, as
//! the machine itself would have to. Without limits of jerk the profile is exactly the fastest for
//! the spline; with them it is, up to the solver's tolerance, the fastest near it among profiles
//! with constant `w` between points of the grid. That problem is not convex, and the bound is that
//! of a convex one: on smooth paths both agree within some thousandths, where noise moves the axes
//! to and fro at every location within some hundredths; between locations a hundred times nearer
//! than others it may be a fifth or more.
//!
//! ## Failure
//! Kind `Usage` for bad options or inputs that do not belong together.

mod caps;
mod curve;
mod jerk;
mod peaks;
mod settings;
mod topp;

use crate::artifact::toolpath::CHORD_MM;
use crate::artifact::{Axes, AxisMotion, AxisRows, Cone, ProgrammedCurve, Schedule, Toolpath, motion};
use crate::error::{Error, Result, Stage};
use crate::machine::Machine;
use crate::numerics::spline::CubicSpline;
use crate::observe::{Doubt, Observer, Warning};
use crate::parallel;
use crate::settings::with_settings;

use caps::Caps;
use curve::{AxisCurve, Programmed};

pub use caps::least_time;
pub use peaks::{AxisPeaks, peaks, peaks_on};
pub use settings::{FeedKeys, FeedSettings};

/// Locations that one thread takes at least.
const PER_THREAD: usize = 1024;
/// A motion for which no closer bound is proved gets a warning, as a share of its time.
const LARGE_GAP: f64 = 0.05;

/// Options of [`plan`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FeedOptions {
    /// What the job says of it; `lead_radius_mm` is not looked at.
    pub settings: FeedSettings,
    /// From the ball centre to the spindle's gauge line, mm ([`crate::tool::Tool::length_mm`]).
    pub gauge_length_mm: f64,
    /// Keep every axis' jerk within its limit.
    pub limit_jerk: bool,
    /// Greatest distance between the tool tip's path and its chord over one period of the control,
    /// mm.
    pub chord_mm: f64,
    /// Period of the control's interpolation, s. Default 0.002: what common controls have or
    /// better.
    pub period_s: f64,
    /// Keep the contact point's speed over the part within the programmed feed, too.
    pub limit_contact: bool,
    /// Greatest speed of the contact point over the part where that is less than the programmed
    /// feed, mm/s: what the chip allows.
    pub contact_mm_s: Option<f64>,
    /// Find a time that no motion is shorter than, too; takes about a tenth of the work.
    pub bounded: bool,
}

with_settings!(FeedOptions, FeedSettings);

impl FeedOptions {
    /// All limits in force, the usual chord over 0.002 s.
    pub fn new(feed_mm_min: f64, gauge_length_mm: f64) -> Self {
        FeedOptions {
            settings: FeedSettings { feed_mm_min, ..FeedSettings::default() },
            gauge_length_mm,
            limit_jerk: true,
            chord_mm: CHORD_MM,
            period_s: 0.002,
            limit_contact: true,
            contact_mm_s: None,
            bounded: true,
        }
    }

    fn validate(&self) -> Result<()> {
        let bad = |m: String| Err(Error::usage(Stage::Feed, m));
        self.settings.check(Stage::Feed)?;
        if !(self.gauge_length_mm >= 0.0 && self.gauge_length_mm.is_finite()) {
            return bad(format!("the tool's length is {} mm, it must be at least 0", self.gauge_length_mm));
        }
        if !(self.chord_mm > 0.0 && self.period_s > 0.0 && (self.chord_mm + self.period_s).is_finite()) {
            return bad(format!(
                "the chord ({} mm) and the period ({} s) must be greater than 0",
                self.chord_mm, self.period_s
            ));
        }
        Ok(())
    }
}

/// The fastest motion; see the module's page.
///
/// # Errors
/// Kind `Usage`: a bad option, fewer than three locations, arc lengths that do not rise, path and
/// schedule of different length, values that are not numbers. `Cancelled`.
pub fn plan(
    path: &Toolpath,
    schedule: &Schedule,
    machine: &Machine,
    options: &FeedOptions,
    observer: &dyn Observer,
) -> Result<AxisMotion> {
    plan_on(path, schedule, None, machine, options, observer)
}

/// As [`plan`]; on the curve that a path was given, one row of which belongs to each location.
///
/// # Errors
/// As [`plan`], and where the curve has not as many rows as the path, or its parameters do not
/// rise.
pub fn plan_on(
    path: &Toolpath,
    schedule: &Schedule,
    on: Option<&ProgrammedCurve>,
    machine: &Machine,
    options: &FeedOptions,
    observer: &dyn Observer,
) -> Result<AxisMotion> {
    let (motion, gap) = plan_with_bound(path, schedule, on, machine, options, observer)?;
    if let Some(gap) = gap.filter(|g| *g > LARGE_GAP) {
        observer.warn(Warning { stage: Stage::Feed, doubt: Doubt::RoughBound { gap } });
    }
    Ok(motion)
}

/// As [`plan`], without its warning; and within jerk a share of the time: no motion on the grid
/// takes less by more.
///
/// # Errors
/// As [`plan`].
pub fn plan_with_bound(
    path: &Toolpath,
    schedule: &Schedule,
    on: Option<&ProgrammedCurve>,
    machine: &Machine,
    options: &FeedOptions,
    observer: &dyn Observer,
) -> Result<(AxisMotion, Option<f64>)> {
    let (curve, rates) = axis_curve(path, schedule, on, machine, options)?;
    let mut squares = caps::of_path(path, schedule, options);
    // Of the ball centre's speed; by the parameter it goes a little faster or slower.
    squares.iter_mut().zip(&rates).for_each(|(cap, rate)| *cap /= rate * rate);
    let turning = caps::rates(path, schedule).map(|of| (machine.turning_axis(), of));
    let caps = Caps { squares, turning };
    let (motion, gap) = fastest(&curve, &caps, machine, options, observer)?;
    Ok((if rates.is_empty() { motion } else { with_feeds(motion, path) }, gap))
}

/// As [`plan`], with a greatest speed of the ball centre in each interval between locations, mm/s,
/// in place of the programmed feed and the contact: what the lines of a program ask for.
///
/// # Errors
/// As [`plan`], and where there is not one speed over 0 for each interval.
pub fn plan_at(
    path: &Toolpath,
    schedule: &Schedule,
    speeds_mm_s: &[f64],
    machine: &Machine,
    options: &FeedOptions,
    observer: &dyn Observer,
) -> Result<AxisMotion> {
    let options = FeedOptions { limit_contact: false, ..at_speeds(path.locations.len(), speeds_mm_s, options)? };
    let (curve, _) = axis_curve(path, schedule, None, machine, &options)?;
    let mut squares = caps::of_path(path, schedule, &options);
    squares.iter_mut().zip(speeds_mm_s).for_each(|(cap, speed)| *cap = cap.min(speed * speed));
    fastest(&curve, &squares.into(), machine, &options, observer).map(|(motion, _)| motion)
}

/// The fastest motion along positions of all axes over a parameter (mm), with a greatest speed of
/// the parameter in each interval, mm/s: rows of two tools. It begins and ends at rest; feeds are
/// the parameter's.
///
/// # Errors
/// As [`plan_at`].
pub fn plan_positions(
    s_mm: &[f64],
    positions: &AxisRows,
    speeds_mm_s: &[f64],
    machine: &Machine,
    options: &FeedOptions,
    observer: &dyn Observer,
) -> Result<AxisMotion> {
    let options = at_speeds(s_mm.len(), speeds_mm_s, options)?;
    options.validate()?;
    let spline = spline_over(s_mm, positions)?;
    let squares: Vec<f64> = speeds_mm_s.iter().map(|v| v * v).collect();
    fastest(&spline.into(), &squares.into(), machine, &options, observer).map(|(motion, _)| motion)
}

/// Options with the greatest of the speeds of all intervals between so many locations as the feed.
fn at_speeds(locations: usize, speeds_mm_s: &[f64], options: &FeedOptions) -> Result<FeedOptions> {
    if speeds_mm_s.len() + 1 != locations || speeds_mm_s.iter().any(|v| !(v.is_finite() && *v > 0.0)) {
        return Err(Error::usage(Stage::Feed, "each interval between locations needs a speed over 0"));
    }
    let most_mm_min = 60.0 * speeds_mm_s.iter().fold(0.0f64, |m, v| m.max(*v));
    Ok(options.with(|s| s.feed_mm_min = most_mm_min))
}

/// The axes over arc length.
fn spline_over(s_mm: &[f64], rows: &AxisRows) -> Result<CubicSpline> {
    motion::smooth(s_mm, rows).map_err(|e| {
        Error::usage(Stage::Feed, format!("the axes' positions are no function of arc length: {e}"))
            .advise("locations must have rising arc lengths and finite coordinates")
    })
}

/// The fastest motion along a curve, its speed in each interval capped, and within jerk
/// what its bound leaves open.
fn fastest(
    curve: &AxisCurve,
    caps: &Caps,
    machine: &Machine,
    options: &FeedOptions,
    observer: &dyn Observer,
) -> Result<(AxisMotion, Option<f64>)> {
    let (axes, count) = (machine.axes(), caps.squares.len() + 1);
    observer.check(Stage::Feed)?;
    observer.progress(Stage::Feed, 0, count);
    if options.limit_jerk {
        let limits = jerk::Limits::from_fn(axes.len(), |k| {
            let l = axes[k].limits;
            [l.velocity, l.acceleration, l.jerk]
        });
        let wanted = (options.settings.feed_mm_min / 60.0, options.bounded);
        let profile = jerk::fastest(curve, &limits, wanted, caps, observer);
        observer.check(Stage::Feed)?;
        let profile = profile.ok_or_else(|| {
            Error::usage(
                Stage::Feed,
                "the axes' positions change too abruptly along the path to be followed at any speed",
            )
        })?;
        observer.progress(Stage::Feed, count, count);
        return Ok((motion_within_jerk(curve, &profile), options.bounded.then_some(profile.gap)));
    }
    let limits: Vec<_> = axes.iter().map(|a| [a.limits.velocity, a.limits.acceleration]).collect();
    let profile = topp::fastest(curve, &limits, caps, observer)?;
    observer.progress(Stage::Feed, count, count);
    Ok((motion_within_acceleration(curve, &profile), None))
}

/// Feeds over the lengths of the path, where its parameter is another.
fn with_feeds(mut motion: AxisMotion, path: &Toolpath) -> AxisMotion {
    let l = &path.locations;
    for i in 1..motion.feed.len() {
        motion.feed[i] = (l[i].centre - l[i - 1].centre).norm() / (motion.t_s[i] - motion.t_s[i - 1]);
    }
    motion.feed[0] = motion.feed[1];
    motion
}

/// Axis positions over the arc length of ball centres, or over the curve's parameter; and how fast
/// the ball centre goes by that in each interval, none where it is arc length.
fn axis_curve(
    path: &Toolpath,
    schedule: &Schedule,
    on: Option<&ProgrammedCurve>,
    machine: &Machine,
    options: &FeedOptions,
) -> Result<(AxisCurve, Vec<f64>)> {
    options.validate()?;
    let (n, m) = (path.locations.len(), schedule.theta.len());
    if n != m {
        return Err(Error::usage(Stage::Feed, format!("the path has {n} locations but the schedule {m}")));
    }
    if n < 3 {
        return Err(Error::usage(Stage::Feed, format!("the path has {n} locations, at least 3 are needed")));
    }
    if let Some(rows) = on.map(|c| c.rows.len()).filter(|rows| *rows != n) {
        return Err(Error::usage(Stage::Feed, format!("the path has {n} locations but the curve {rows} rows")));
    }
    let s: Vec<f64> = match on {
        Some(curve) => curve.rows.iter().map(|r| r.s_mm).collect(),
        None => path.locations.iter().map(|l| l.s_mm).collect(),
    };
    let wrong = |c: &Cone| c.lean_rad.is_nan() || c.lean_rad.abs() >= std::f64::consts::FRAC_PI_2;
    if let Some(cone) = (0..n).map(|k| path.cone(k)).find(wrong) {
        let deg = cone.lean_rad.to_degrees();
        return Err(Error::usage(Stage::Feed, format!("B is {deg} deg, it must be between -90 and 90")));
    }
    let rows = machine.along(path.stands(&schedule.theta), options.gauge_length_mm);
    let spline = spline_over(&s, &rows)?;
    let Some(curve) = on else { return Ok((spline.into(), Vec::new())) };
    let programmed = Programmed { curve, path, schedule, machine, gauge_length_mm: options.gauge_length_mm };
    let rates = programmed.rates();
    let on = AxisCurve::on(spline, rows, &programmed)
        .ok_or_else(|| Error::usage(Stage::Feed, "the linear axes do not reach all places along the curve"))?;
    Ok((on, rates))
}

/// The motion of a speed profile. Accelerations are those just after each location (of the last:
/// just before).
fn motion_within_acceleration(curve: &AxisCurve, profile: &topp::Profile) -> AxisMotion {
    let s = curve.abscissae();
    let n = s.len();
    let speed: Vec<f64> = profile.x.iter().map(|x| x.sqrt()).collect();
    let mut t_s = vec![0.0; n];
    let mut feed = vec![0.0; n];
    for i in 1..n {
        // Under constant acceleration the mean speed is the mean of both.
        feed[i] = 0.5 * (speed[i - 1] + speed[i]);
        t_s[i] = t_s[i - 1] + (s[i] - s[i - 1]) / feed[i];
    }
    feed[0] = feed[1];
    let axes = curve.functions();
    let of_rows = |value: &(dyn Fn(usize, usize) -> f64 + Sync)| {
        let mut values = vec![0.0; n * axes];
        parallel::map_short(PER_THREAD, values.chunks_mut(axes).enumerate(), |(i, row)| {
            row.iter_mut().enumerate().for_each(|(k, v)| *v = value(i, k));
        });
        AxisRows::from_values(axes, values)
    };
    // Of the interval after each location, of the last before it.
    let before = |i: usize| i.min(n - 2);
    let at = |i: usize, k: usize| curve.at(before(i), k, s[i] - s[before(i)]);
    let position = of_rows(&|i, k| curve.position(i, k, at(i, k)[0]));
    let velocity = of_rows(&|i, k| at(i, k)[1] * speed[i]);
    let acceleration = of_rows(&|i, k| {
        let [_, q1, q2] = at(i, k);
        q1 * profile.u[before(i)] + q2 * profile.x[i]
    });
    let jerk = of_rows(&|i, k| {
        let [from, to] = [before(i), before(i) + 1];
        (acceleration[to][k] - acceleration[from][k]) / (t_s[to] - t_s[from])
    });
    AxisMotion { time_s: t_s[n - 1], t_s, position, velocity, acceleration, jerk, feed }
}

/// The motion of a profile with continuous acceleration, at the locations. Jerks are those just
/// after each.
fn motion_within_jerk(curve: &AxisCurve, profile: &jerk::Smooth) -> AxisMotion {
    let s = curve.abscissae();
    let (n, axes) = (s.len(), curve.functions());
    let mut out = AxisMotion {
        t_s: Vec::with_capacity(n),
        position: AxisRows::with_capacity(axes, n),
        velocity: AxisRows::with_capacity(axes, n),
        acceleration: AxisRows::with_capacity(axes, n),
        jerk: AxisRows::with_capacity(axes, n),
        feed: vec![0.0; n],
        time_s: 0.0,
    };
    let mut g = 0;
    for i in 0..n {
        while g + 1 < profile.s.len() && profile.s[g] < s[i] {
            g += 1;
        }
        let interval = i.min(n - 2);
        let d = Axes::from_fn(axes, |k| curve.at(interval, k, s[i] - s[interval]));
        let third = |k: usize| curve.third(interval, k, s[i] - s[interval]);
        let (x, u, w) = (profile.x[g], profile.u[g], profile.w.get(g).or(profile.w.last()).copied().unwrap_or(0.0));
        let v = x.sqrt();
        out.t_s.push(profile.t[g]);
        out.position.push(&Axes::from_fn(axes, |k| curve.position(i, k, d[k][0])));
        out.velocity.push(&d.map(|q| q[1] * v));
        out.acceleration.push(&d.map(|q| q[1] * u + q[2] * x));
        // At rest the jerk along the path itself is given.
        let along = if x > 0.0 { v * w } else { w };
        out.jerk.push(&Axes::from_fn(axes, |k| third(k) * x * v + 3.0 * d[k][2] * v * u + d[k][1] * along));
    }
    for i in 1..n {
        out.feed[i] = (s[i] - s[i - 1]) / (out.t_s[i] - out.t_s[i - 1]);
    }
    out.feed[0] = out.feed[1];
    out.time_s = out.t_s[n - 1];
    out
}

#[cfg(test)]
mod tests;
