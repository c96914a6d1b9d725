//! The S–θ channel: at each cutter location the angles that the whole tool may take, followed round
//! the whole path.
//!
//! **In**: a [`Blade`] (its mesh and that mesh's deflection), a [`Tool`], a [`Toolpath`] whose
//! balls do not gouge. **Out**: a [`Channel`], one row per cutter location: an interval of θ,
//! unwrapped over the path (it grows by 2π a turn, since the path runs counter-clockwise), what
//! binds its ends, its monotone hulls, and the paper's limits from tangents.
//!
//! **Method.** At each location the tool axis is one of a cone ([`crate::artifact::Cone`]), in
//! whose frame it is `a(θ) = (sin B, cos B cos θ, cos B sin θ)`: everything below is said in that
//! frame. A point of a body (the part, a fixture, the stock) forbids one or two arcs of θ in closed
//! form (`forbidden`), also when the tool's profile is inflated (`profile`); a tree of spheres and
//! boxes over the triangles and branch and bound give the union of arcs (`forbidden`, and `clear`
//! for triangles that the tool nearly touches along their plane). What is left are free intervals;
//! the permitted range of the contact angle `acos(a·n)`, the rotary axis' limits and the travel of
//! linear axes ([`crate::artifact::axis_travel`]) narrow them.
//! What cannot bind is carried from place to place (`track`). Free intervals that overlap from
//! place to place are joined to chains, and the chain whose least overlap is greatest is taken
//! (`chain`). Between places, if `prove_moves` asks for it, the same search runs over the whole
//! move (`region`, `moves`): walls are moved inwards until the straight lines between them hold.
//! Hulls: `hull_min` is the running greatest of the lower limits, `hull_max` the running least of
//! the upper limits from the end: a schedule that never turns back exists exactly where
//! `hull_min <= hull_max`, and then everywhere between them one can go on.
//!
//! **Guaranteed**: at every cutter location and every θ of its interval no point of a body's mesh
//! is nearer to taper, shank or holder than the clearance plus the mesh's deflection; with
//! `prove_moves` also at every time of the straight moves between locations, for every θ between
//! the walls, which are then straight from location to location. Without it walls are taken as
//! straight between places. Ends are at most `tolerance_rad` inside those of the exact mesh with
//! its deflection as room, also where the tool touches the part along a whole line at once; walls
//! that were moved in for the moves lie farther inside. With `exact_ends` they are at most
//! `tolerance_rad` inside those of the exact faces, but for those whose proof takes too long
//! (`tighten`), which stay as safe, and but for [`plan`] with `prove_moves`, where what the index
//! of the part lies off it is kept as room.
//!
//! **All axes**: at one place the free axes all over the sphere, not only on a cone: `sphere`.
//!
//! **Not looked at**: the ball against the part (the path's own promise; against fixtures it is:
//! `ball`), machine parts other than the holder. The contact angle and the travel of linear axes
//! are held at the places, not between.
//!
//! **Fails** with kind `Infeasible` where no chain leads round the path, or where the hulls cross;
//! the message names the turn, S, the point, the part of the tool and the face of the part.

mod advise;
mod arcs;
mod ball;
mod bound;
mod chain;
mod clear;
mod cornered;
mod discs;
mod forbidden;
mod front;
mod halved;
mod lanes;
mod moves;
mod offset;
mod options;
mod pending;
mod planes;
mod profile;
mod region;
mod report;
mod samples;
mod settings;
mod sight;
mod sphere;
mod stretches;
mod tangent;
mod tighten;
mod track;
mod tree;
mod walls;
mod windows;

use crate::artifact::channel::{Binding, ChannelRow};
use crate::artifact::{Blade, Channel, CornerPlace, Obstacle, Toolpath};
use crate::error::{Error, Result, Stage};
use crate::observe::{Doubt, Observer, Warning};
use crate::parallel;
use crate::tool::Tool;

pub use advise::{Advice, CornerAdvice, Farthest, Leans, advise, sweep_b};
pub use offset::{LeastTravel, least_travel};
pub use options::ChannelOptions;
pub use settings::{ChannelKeys, ChannelSettings};
pub use sphere::{sphere, spheres};

use arcs::Witness;
use forbidden::{Free, ObstacleBody, ObstacleScene};
use profile::ToolProfile;
use samples::Sample;
use tree::SphereTree;

/// The free intervals of each place.
type Layers = Vec<Vec<Free>>;

/// Everything that is in the tool's way, indexed once for a tool's radius: channels for several
/// tools, angles or paths follow.
pub struct Surroundings<'a> {
    blade: &'a Blade,
    obstacles: &'a [Obstacle],
    trees: Vec<SphereTree>,
    /// What the part's tree may lie off the part, mm.
    part_off_mm: f64,
}

/// Greatest lean of a tool axis: at 90° it is along the axis of its cone, and θ places nothing.
const MOST_LEAN_DEG: f64 = 85.0;

/// Where the part has exact faces, its tree is finer than its mesh by so much that an end bound at
/// a lever of the ball's radius is off by this, rad.
const FINE_RAD: f64 = 5e-5;
/// Triangles of that finer tree, about.
const FINE_MOST: usize = 250_000;

/// How often the way between two places is halved where their free angles have nothing in common.
const MOST_HALVINGS: usize = 6;

/// With a wider free interval a place needs no finer index, rad.
pub const NARROW_RAD: f64 = 0.05;

impl<'a> Surroundings<'a> {
    /// Indexes the part and the obstacles; `radius_mm` is the ball's radius, which only decides how
    /// finely large triangles are cut.
    ///
    /// # Errors
    /// Kind `Usage`: a mesh is empty or not finite.
    pub fn new(blade: &'a Blade, obstacles: &'a [Obstacle], radius_mm: f64) -> Result<Self> {
        let bodies = std::iter::once(("the part", &blade.part.mesh, &[][..]));
        let others = obstacles.iter().map(|o| (o.name.as_str(), &o.part.mesh, &o.copies[..]));
        let bodies: Vec<_> = bodies.chain(others).collect();
        for (name, mesh, _) in &bodies {
            let bad = |m: &str| Err(Error::usage(Stage::Channel, format!("{name} has {m}")));
            if mesh.triangles.is_empty() {
                return bad("no triangles");
            }
            if !mesh.points.iter().all(|p| p.coords.iter().all(|c| c.is_finite())) {
                return bad("points that are not finite");
            }
        }
        let trees = parallel::map(&bodies, |(_, mesh, copies)| SphereTree::of_copies(mesh, copies, 0.5 * radius_mm));
        Ok(Surroundings { blade, obstacles, trees, part_off_mm: blade.part.deflection_mm })
    }

    /// The same with a finer index of the part, where that has exact faces: for
    /// [`ChannelSettings::exact_ends`], which is then much faster, and with which moves can be
    /// proven but for what the index lies off the faces.
    #[must_use]
    pub fn finer(mut self, radius_mm: f64) -> Self {
        let fine = self.blade.part.fine(FINE_RAD * radius_mm, FINE_MOST);
        let fine = fine.filter(|f| f.deflection_mm < self.part_off_mm);
        if let (Some(tree), Some(f)) = (self.trees.first_mut(), fine) {
            *tree = SphereTree::of(&f.corners, &f.parents, 0.5 * radius_mm);
            self.part_off_mm = f.deflection_mm;
        }
        self
    }

    /// Share of the tolerance that the search may use up: half of it is left for what the tree lies
    /// off exact faces.
    fn share(&self, options: &ChannelOptions) -> f64 {
        if options.settings.exact_ends && self.part_off_mm > 0.0 { 0.5 } else { 1.0 }
    }

    /// What the search keeps to.
    fn for_search(&self, options: &ChannelOptions) -> ChannelOptions {
        options.clone().with(|s| s.tolerance_deg *= self.share(options))
    }

    /// Free intervals of all places within the axes' limits: of the exact faces where that
    /// is asked for.
    fn layers(
        &self,
        tool: &Tool,
        scene: &ObstacleScene,
        (samples, path): (&[Sample], &Toolpath),
        observer: &dyn Observer,
    ) -> Result<Vec<Vec<Free>>> {
        let options = scene.options;
        let mut layers = match tool.is_ball() {
            true => track::free_everywhere(scene, samples, observer)?,
            false => cornered::layers(self, tool, options, (samples, path), observer)?,
        };
        if options.settings.exact_ends {
            let room = [options.settings.clearance_mm, options.settings.holder_clearance_mm];
            let profile = ToolProfile::new(tool, room, self.blade.part.off_own_mm());
            let tolerance = options.settings.tolerance_deg.to_radians() / self.share(options);
            let ends = tighten::ExactEnds { part: &self.blade.part, profile, tolerance };
            ends.tighten(scene, (samples, path), &mut layers, observer)?;
        }
        within_axes(options, samples, tool.disc_radius_mm(), &mut layers);
        Ok(layers)
    }

    /// Why no angle is free at a place.
    fn closed(
        &self,
        tool: &Tool,
        options: &ChannelOptions,
        (reporter, layers): (&report::Reporter, &[Vec<Free>]),
        at: usize,
    ) -> Error {
        if tool.is_ball() {
            return reporter.closed(layers, at);
        }
        // A place where nothing is free comes before one where angles do not join: it says what
        // would do.
        let mut taken = (0..layers.len()).filter(|k| layers[*k].is_empty()).peekable();
        let first = taken.peek().copied();
        let said = match first {
            Some(_) => taken.find_map(|k| cornered::closed(self, tool, options, (reporter, k))),
            None => cornered::apart(layers, reporter, at),
        };
        said.unwrap_or_else(|| reporter.closed(layers, first.unwrap_or(at)))
    }

    fn scene<'s>(&'s self, tool: &Tool, options: &'s ChannelOptions) -> ObstacleScene<'s> {
        self.scene_with(tool, options, 0.0)
    }

    /// As [`Self::scene`], the tool keeping clear by so much more, mm.
    fn scene_with<'s>(&'s self, tool: &Tool, options: &'s ChannelOptions, more_mm: f64) -> ObstacleScene<'s> {
        let part = &self.blade.part;
        let mut bodies = Vec::new();
        let mut trees = self.trees.iter();
        if let Some(tree) = trees.next() {
            let room = [options.settings.clearance_mm, options.settings.holder_clearance_mm];
            let profile = ToolProfile::new(tool, room.map(|mm| mm + more_mm), self.part_off_mm);
            bodies.push(ObstacleBody { name: "part", mesh: &part.mesh, tree, profile });
        }
        for (o, tree) in self.obstacles.iter().zip(trees) {
            let room = [o.clearance_mm, o.holder_clearance_mm].map(|mm| mm + more_mm);
            let whole = ToolProfile::new(tool, room, o.part.deflection_mm);
            let profile = if o.cut_by_the_tool { whole.holder() } else { whole };
            bodies.push(ObstacleBody { name: &o.name, mesh: &o.part.mesh, tree, profile });
        }
        ObstacleScene { bodies, options }
    }
}

/// A free interval at a cutter location, rad, unwrapped about the surface normal's azimuth, and
/// what ends it.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct FreeInterval {
    /// Least θ.
    pub theta_min: f64,
    /// Greatest θ.
    pub theta_max: f64,
    /// What limits `theta_min`.
    pub binds_min: Binding,
    /// What limits `theta_max`.
    pub binds_max: Binding,
}

/// All free intervals at every cutter location, to `tolerance_rad`: before one chain is chosen and
/// moves are looked at.
///
/// # Errors
/// As [`plan`], but a location without a free angle is no error: its list is empty.
pub fn intervals(
    surroundings: &Surroundings,
    tool: &Tool,
    path: &Toolpath,
    options: &ChannelOptions,
    observer: &dyn Observer,
) -> Result<Vec<Vec<FreeInterval>>> {
    check_input(tool, path, options)?;
    let for_search = surroundings.for_search(options);
    let scene = surroundings.scene(tool, &for_search);
    // Places between two locations have no row of their own.
    let samples: Vec<Sample> =
        samples::along(path, f64::INFINITY, options.sweep).into_iter().filter(|s| s.fraction == 0.0).collect();
    let layers = surroundings.layers(tool, &scene, (&samples, path), observer)?;
    let named = |f: &Free| FreeInterval {
        theta_min: f.lo,
        theta_max: f.hi,
        binds_min: walls::binding(f.lo_by, &scene),
        binds_max: walls::binding(f.hi_by, &scene),
    };
    Ok(layers.iter().map(|layer| layer.iter().map(named).collect()).collect())
}

/// What free angles of neighbouring places have to have in common, rad.
fn least_overlap(options: &ChannelOptions) -> f64 {
    2.0 * options.settings.tolerance_deg.to_radians()
}

/// The channel within walls at all places of a path, rad, for θ that never falls.
///
/// # Errors
/// A place whose upper wall is below a lower one before it.
pub fn of_walls(walls: &[[f64; 2]], tolerance_rad: f64) -> std::result::Result<Channel, usize> {
    let row = |[theta_min, theta_max]: &[f64; 2]| ChannelRow {
        theta_min: *theta_min,
        theta_max: *theta_max,
        hull_min: *theta_min,
        hull_max: *theta_max,
        tangent_min: *theta_min,
        tangent_max: *theta_max,
        binds_min: Binding::Free,
        binds_max: Binding::Free,
    };
    let (mut rows, sweep): (Vec<ChannelRow>, _) = (walls.iter().map(row).collect(), crate::artifact::Sweep::Round);
    let narrowest_row = walls::hulls(&mut rows, sweep).map_err(|crossing| crossing.high_row)?;
    Ok(Channel { tolerance_rad, sweep, rows, narrowest_row, chains: 1, proven_at: Vec::new() })
}

/// The channel of a tool path among the part alone.
///
/// # Errors
/// Kind `Usage` for impossible options or tool, `Infeasible` where there is no channel or no
/// monotone schedule in it, `Cancelled`.
pub fn plan(
    blade: &Blade,
    tool: &Tool,
    path: &Toolpath,
    options: &ChannelOptions,
    observer: &dyn Observer,
) -> Result<Channel> {
    plan_among(&Surroundings::new(blade, &[], tool.radius_mm)?, tool, path, options, observer)
}

/// The channel of a tool path among the part and all obstacles.
///
/// # Errors
/// As [`plan`].
pub fn plan_among(
    surroundings: &Surroundings,
    tool: &Tool,
    path: &Toolpath,
    options: &ChannelOptions,
    observer: &dyn Observer,
) -> Result<Channel> {
    plan_with(surroundings, (None, &mut Vec::new()), tool, path, options, observer)
}

/// As [`plan_among`]; where there is no channel, `closes` gets every location at which it closes:
/// where no angle is free, or where those that are free have nothing in common with any to which a
/// chain has led since the last such location. Where there is none of these, every location at
/// which straight walls leave nothing.
///
/// # Errors
/// As [`plan`].
pub fn plan_or_gaps(
    surroundings: &Surroundings,
    tool: &Tool,
    path: &Toolpath,
    options: &ChannelOptions,
    closes: &mut Vec<usize>,
    observer: &dyn Observer,
) -> Result<Channel> {
    plan_with(surroundings, (None, closes), tool, path, options, observer)
}

/// A finer index, made where it is asked for.
pub type FinerIndex<'s, 'b> = &'s dyn Fn() -> Result<&'s Surroundings<'b>>;

/// As [`plan_among`] for a ball, but a finer index of the same things ([`Surroundings::finer`])
/// decides where hardly anything is free ([`NARROW_RAD`]) and where walls cross: it lies less off
/// the part.
///
/// # Errors
/// As [`plan`].
pub fn plan_among_finer(
    surroundings: &Surroundings,
    finer: FinerIndex,
    tool: &Tool,
    path: &Toolpath,
    options: &ChannelOptions,
    observer: &dyn Observer,
) -> Result<Channel> {
    tool.ball_only("channels are made by two indices")?;
    plan_with(surroundings, (Some(finer), &mut Vec::new()), tool, path, options, observer)
}

fn plan_with(
    surroundings: &Surroundings,
    (finer, closes): (Option<FinerIndex>, &mut Vec<usize>),
    tool: &Tool,
    path: &Toolpath,
    options: &ChannelOptions,
    observer: &dyn Observer,
) -> Result<Channel> {
    check_input(tool, path, options)?;
    ball::check(path, surroundings.blade, surroundings.obstacles)?;
    let for_search = surroundings.for_search(options);
    let scene = surroundings.scene(tool, &for_search);
    // What moves are proven against, the index, gives the ends then: one that lay farther out would
    // only be moved in again, and its neighbours with it.
    let free_at = |samples: &[Sample]| match options.settings.prove_moves {
        true => layers(&scene, samples, observer),
        false => surroundings.layers(tool, &scene, (samples, path), observer),
    };
    let least = least_overlap(options);
    let (samples, mut layers) = joined(path, samples_of(tool, path, options), (least, options.sweep), &free_at)?;
    // Places at which the finer index is to decide, and those at which it has.
    let mut asked = if finer.is_some() { narrow(&layers) } else { Vec::new() };
    let mut by_finer = vec![false; samples.len()];
    let reporter =
        report::Reporter { blade: surroundings.blade, path, scene: &scene, samples: &samples, is_start: true };
    let (mut rows, narrowest_row, count) = loop {
        if let Some(finer) = finer.filter(|_| !asked.is_empty()) {
            widened(&mut layers, &scene, &finer()?.scene(tool, &for_search), (&asked, &samples), observer)?;
            asked.iter().for_each(|k| by_finer[*k] = true);
        }
        let chain = chain::widest(&layers, least).map_err(|c| {
            closes.extend(chain::gaps(&layers, least).into_iter().map(|k| samples[k].row));
            closes.dedup();
            surroundings.closed(tool, options, (&reporter, &layers), c.at)
        })?;
        let chosen: Vec<&Free> = layers.iter().zip(&chain.chosen).filter_map(|(l, &k)| l.get(k)).collect();
        let mut lifts = Vec::new();
        if options.settings.prove_moves || !options.prove_at.is_empty() {
            let wanted =
                |i: usize| options.settings.prove_moves || options.prove_at.binary_search(&samples[i - 1].row).is_ok();
            let found = moves::lifts(&scene, &samples, &chosen, wanted, observer)?;
            lifts = found.map_err(|i| reporter.closed_between(chosen[i], chosen[i + 1], i))?;
        }
        let mut rows = walls::rows(&samples, &moves::moved_in(&chosen, &lifts), &scene);
        if let Some(row) = rows.iter().position(|r| r.theta_min > r.theta_max) {
            closes.extend((0..rows.len()).filter(|k| rows[*k].theta_min > rows[*k].theta_max));
            let i = samples.iter().position(|s| s.row == row).unwrap_or(0).min(chosen.len().saturating_sub(2));
            return Err(reporter.closed_between(chosen[i], chosen[i + 1], i));
        }
        match walls::hulls(&mut rows, options.sweep) {
            Ok(narrowest_row) => break (rows, narrowest_row, chain.count),
            Err(crossing) => {
                // Walls that cross by the usual index may not by the finer one.
                let crossing_rows = walls::crossing_rows(&rows);
                let crosses = |k: &usize| crossing_rows.binary_search(&samples[*k].row).is_ok();
                asked = (0..samples.len()).filter(|k| !by_finer[*k] && crosses(k)).collect();
                if finer.is_none() || asked.is_empty() {
                    return Err(reporter.crossing(&rows, crossing));
                }
            }
        }
    };
    let azimuths = samples::azimuths(path, options.sweep);
    for (row, (least, greatest)) in rows.iter_mut().zip(tangent::limits(path, tool.taper_deg.to_radians(), &azimuths)) {
        (row.tangent_min, row.tangent_max) = (least, greatest);
    }
    warn_if_narrow(&rows, narrowest_row, path, observer);
    if count > 1 {
        let doubt = Doubt::SeveralChannels { count };
        observer.warn(Warning { stage: Stage::Channel, doubt });
    }
    Ok(Channel {
        tolerance_rad: options.settings.tolerance_deg.to_radians(),
        sweep: options.sweep,
        rows,
        narrowest_row,
        chains: count,
        proven_at: options.prove_at.clone(),
    })
}

/// A channel with the moves of [`ChannelOptions::prove_at`] proven too, and its walls there moved
/// in. All other walls stay: what is known of the channel is not looked for again. `None` where
/// walls that hold for the moves leave nothing.
///
/// # Errors
/// Kind `Usage` for impossible options or tool; `Cancelled`.
pub fn proven(
    surroundings: &Surroundings,
    tool: &Tool,
    (path, channel): (&Toolpath, &Channel),
    options: &ChannelOptions,
    observer: &dyn Observer,
) -> Result<Option<Channel>> {
    check_input(tool, path, options)?;
    let for_search = surroundings.for_search(options);
    let scene = surroundings.scene(tool, &for_search);
    let samples = samples_of(tool, path, options);
    let one = |row: &usize| {
        let of_move = samples.partition_point(|s| s.row < *row)..=samples.partition_point(|s| s.row <= *row);
        let places = samples.get(of_move).unwrap_or_default().to_vec();
        let free_at = |places: &[Sample]| surroundings.layers(tool, &scene, (places, path), observer);
        let (places, layers) = joined(path, places, (least_overlap(options), options.sweep), &free_at)?;
        let within = |(place, layer): (&Sample, &Vec<Free>)| walls::within(&channel.rows, place, layer);
        let chosen: Vec<Free> = places.iter().zip(&layers).map_while(within).collect();
        if chosen.len() < places.len() {
            return Ok(None);
        }
        let chosen: Vec<&Free> = chosen.iter().collect();
        let lifts = moves::lifts(&scene, &places, &chosen, |_| true, observer)?.ok();
        Ok(lifts.map(|lifts| (moves::moved_in(&chosen, &lifts), places)))
    };
    let Some(moved) = parallel::try_map(&options.prove_at, one)?.into_iter().collect::<Option<Vec<_>>>() else {
        return Ok(None);
    };
    let mut rows = channel.rows.clone();
    for (walls, places) in &moved {
        walls::narrow(&mut rows, (places, walls), &scene);
    }
    let mut proven_at = [&channel.proven_at[..], &options.prove_at].concat();
    proven_at.sort_unstable();
    proven_at.dedup();
    let leaves_room = rows.iter().all(|r| r.theta_min <= r.theta_max);
    let narrowest_row = walls::hulls(&mut rows, options.sweep).ok().filter(|_| leaves_room);
    Ok(narrowest_row.map(|narrowest_row| Channel { rows, narrowest_row, proven_at, ..channel.clone() }))
}

/// The channel of a part of its path: of the rows from one to another.
pub fn part(channel: &Channel, [first, last]: [usize; 2]) -> Channel {
    let mut rows = channel.rows.get(first..=last).unwrap_or_default().to_vec();
    // Walls of fewer rows are nowhere nearer to one another.
    let narrowest_row = walls::hulls(&mut rows, channel.sweep).unwrap_or(0);
    let proven_at = channel.proven_at.iter().filter_map(|k| k.checked_sub(first).filter(|k| k + first < last));
    Channel { narrowest_row, proven_at: proven_at.collect(), rows, ..channel.clone() }
}

/// The places at which the channel of a path is computed.
fn samples_of(tool: &Tool, path: &Toolpath, options: &ChannelOptions) -> Vec<Sample> {
    match tool.is_ball() {
        true => samples::along(path, options.max_step_mm, options.sweep),
        false => samples::along_finely(path, options.max_step_mm, windows::TURN_RAD, options.sweep),
    }
}

/// The places with more between those where cones turn past a narrow gap: there the angles that are
/// free at one place and those at the next have nothing in common, and on the way they lead from
/// the ones to the others.
fn joined(
    path: &Toolpath,
    mut samples: Vec<Sample>,
    (least, sweep): (f64, crate::artifact::Sweep),
    free_at: &dyn Fn(&[Sample]) -> Result<Layers>,
) -> Result<(Vec<Sample>, Layers)> {
    let mut layers = free_at(&samples)?;
    for _ in 0..MOST_HALVINGS {
        let is_apart = |k: &usize| {
            let (from, to) = (&layers[k - 1], &layers[*k]);
            samples[k - 1].cone != samples[*k].cone
                && !from.is_empty()
                && !to.is_empty()
                && !chain::meet(from, to, least)
        };
        let apart: Vec<usize> = (1..samples.len()).filter(is_apart).collect();
        if apart.is_empty() {
            break;
        }
        let between: Vec<Sample> =
            apart.iter().map(|k| samples::midway(path, [&samples[k - 1], &samples[*k]], sweep)).collect();
        let of_between = free_at(&between)?;
        for ((k, sample), layer) in apart.iter().zip(between).zip(of_between).rev() {
            samples.insert(*k, sample);
            layers.insert(*k, layer);
        }
    }
    Ok((samples, layers))
}

/// Free intervals of all places within the axes' limits, of the index with what it lies off
/// the part as room.
fn layers(scene: &ObstacleScene, samples: &[Sample], observer: &dyn Observer) -> Result<Vec<Vec<Free>>> {
    let mut layers = track::free_everywhere(scene, samples, observer)?;
    within_axes(scene.options, samples, 0.0, &mut layers);
    Ok(layers)
}

/// The widest interval that is free at a place, rad.
fn widest_rad(layer: &[Free]) -> f64 {
    layer.iter().map(|f| f.hi - f.lo).fold(0.0, f64::max)
}

/// The places where hardly anything is free.
fn narrow(layers: &[Vec<Free>]) -> Vec<usize> {
    (0..layers.len()).filter(|k| widest_rad(&layers[*k]) < NARROW_RAD).collect()
}

/// Takes the free intervals of a finer index where hardly anything is free.
fn widened(
    layers: &mut [Vec<Free>],
    scene: &ObstacleScene,
    finer: &ObstacleScene,
    (narrow, samples): (&[usize], &[Sample]),
    observer: &dyn Observer,
) -> Result<()> {
    let few: Vec<Sample> = narrow.iter().filter_map(|k| samples.get(*k).copied()).collect();
    // What ends an interval is named by the piece of its triangle in the usual index.
    let named = |by: Witness| match by {
        Witness::Tool { segment, body, leaf } => {
            let bodies = finer.bodies.get(usize::from(body)).zip(scene.bodies.get(usize::from(body)));
            let leaf = bodies.and_then(|(own, to)| to.tree.leaf_of(own.tree.triangle(leaf))).unwrap_or(0);
            Witness::Tool { segment, body, leaf }
        }
        by => by,
    };
    for (k, layer) in narrow.iter().zip(self::layers(finer, &few, observer)?) {
        if let Some(own) = layers.get_mut(*k).filter(|own| widest_rad(&layer) > widest_rad(own)) {
            *own = layer.into_iter().map(|f| Free { lo_by: named(f.lo_by), hi_by: named(f.hi_by), ..f }).collect();
        }
    }
    Ok(())
}

/// Cuts off what the rotary axis does not reach, and where a linear axis would be beyond its
/// travel, with the centre of ball or disc on the tool axis.
fn within_axes(options: &ChannelOptions, samples: &[Sample], disc_radius_mm: f64, layers: &mut [Vec<Free>]) {
    if let Some([least, greatest]) = options.theta_limits_rad {
        for f in layers.iter_mut().flatten() {
            if f.lo < least {
                (f.lo, f.lo_by) = (least, Witness::Axis);
            }
            if f.hi > greatest {
                (f.hi, f.hi_by) = (greatest, Witness::Axis);
            }
        }
        layers.iter_mut().for_each(|l| l.retain(|f| f.lo < f.hi));
    }
    let least_rad = options.settings.contact_angle_min_deg.to_radians();
    for (k, travel) in (0u8..).zip(&options.travel) {
        let cut = |f: &Free, sample: &Sample| {
            let (f, by) = (*f, Witness::Travel(k));
            let left = if disc_radius_mm > 0.0 {
                let Sample { centre: corner, normal, cone, .. } = *sample;
                travel.left_of_disc(&CornerPlace { corner, normal, cone, disc_radius_mm }, [f.lo, f.hi], least_rad)
            } else {
                travel.left_of(&sample.centre, [f.lo, f.hi])
            };
            left.into_iter().map(move |([lo, hi], [lo_is_own, hi_is_own])| Free {
                lo,
                hi,
                lo_by: if lo_is_own { f.lo_by } else { by },
                hi_by: if hi_is_own { f.hi_by } else { by },
            })
        };
        for (sample, layer) in samples.iter().zip(layers.iter_mut()) {
            if disc_radius_mm > 0.0 || travel.forbidden(&sample.centre).next().is_some() {
                *layer = layer.iter().flat_map(|f| cut(f, sample)).collect();
            }
        }
    }
}

fn check_input(tool: &Tool, path: &Toolpath, options: &ChannelOptions) -> Result<()> {
    options.validate()?;
    tool.validate()?;
    let bad = |m: &str| Err(Error::usage(Stage::Channel, m));
    if !tool.is_ball() {
        let s = &options.settings;
        let proven = [
            (s.prove_moves || !options.prove_at.is_empty(), "moves of a channel are proven"),
            (s.exact_ends, "ends of a channel are found on exact faces"),
        ];
        proven.iter().filter(|(is_asked, _)| *is_asked).try_for_each(|(_, what)| tool.ball_only(what))?;
    }
    if path.locations.is_empty() {
        return bad("the tool path has no cutter locations");
    }
    let finite = |v: &nalgebra::Vector3<f64>| v.iter().all(|c| c.is_finite());
    if !path.locations.iter().all(|l| finite(&l.centre.coords) && finite(&l.normal)) {
        return bad("the tool path has locations that are not finite");
    }
    if !path.cones.fit(path.locations.len()) {
        return bad("the cones of tool axes are not finite, or not as many as the tool path has locations");
    }
    let different = if path.cones.same().is_some() { 1 } else { path.locations.len() };
    (0..different).try_for_each(|k| check_lean(path.cone(k).lean_rad))?;
    Ok(())
}

fn check_lean(lean_rad: f64) -> Result<()> {
    let deg = lean_rad.to_degrees();
    if deg.abs() <= MOST_LEAN_DEG {
        return Ok(());
    }
    let message = format!("B is {deg}°, it must lie between -{MOST_LEAN_DEG}° and {MOST_LEAN_DEG}°");
    Err(Error::usage(Stage::Channel, message))
}

/// Warns where the monotone channel is less than a degree wide.
fn warn_if_narrow(rows: &[ChannelRow], narrowest: usize, path: &Toolpath, observer: &dyn Observer) {
    let (Some(row), Some(at)) = (rows.get(narrowest), path.locations.get(narrowest)) else { return };
    let width_deg = (row.hull_max - row.hull_min).to_degrees();
    if width_deg < 1.0 {
        let doubt = Doubt::NarrowChannel { width_deg, turn: at.turn, turn_s_mm: at.turn_s_mm };
        observer.warn(Warning { stage: Stage::Channel, doubt });
    }
}

#[cfg(test)]
mod tests;
