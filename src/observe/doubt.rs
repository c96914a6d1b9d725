//! What a warning says, as data: the sentence is made of it.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::Remark;
use crate::error::{Along, EndReason, Infeasible, LeadReason, WhyLeft, WhyNone, turn_number};

/// Surface that a ball does not go to.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LeftOver {
    /// Which surface, e.g. `fillet`.
    pub of: String,
    /// Share of it that the ball goes to.
    pub share: f64,
    /// Area of all of it, mm².
    pub area_mm2: f64,
    /// Where it is tightest, model frame, mm.
    pub tightest_mm: Option<[f64; 3]>,
}

/// What the reader of a result should know.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case", tag = "what")]
pub enum Doubt {
    /// No tool is sold that sticks out as far as the part asks for.
    StickOutTooShort {
        /// Farthest point of the part from the blade axis, mm.
        reach_mm: f64,
        /// Stick-out that it asks for, mm.
        wanted_mm: f64,
        /// Ball radius, mm.
        radius_mm: f64,
        /// Stick-out that is taken, mm.
        stickout_mm: f64,
    },
    /// Not even the smallest ball has room at some of the wall.
    NoRoomAtWall {
        /// Share of the wall that it goes to.
        share: f64,
        /// Its radius, mm.
        radius_mm: f64,
        /// Where it is tightest, model frame, mm.
        tightest_mm: Option<[f64; 3]>,
    },
    /// The ball that the part asks for is not sold long enough.
    BallNotLongEnough {
        /// Radius of that ball, mm; `None`: less than what is taken.
        wanted_mm: Option<f64>,
        /// Radius that is taken, mm.
        radius_mm: f64,
        /// What it leaves.
        left: Vec<LeftOver>,
    },
    /// The airfoil asks for a smaller ball than is sold long enough.
    AirfoilTooThin {
        /// Greatest radius that it asks for, mm.
        most_mm: f64,
        /// That radius over the chord.
        share_of_chord: f64,
        /// Chord, mm.
        chord_mm: f64,
        /// Its height, mm.
        height_mm: f64,
        /// Radius that is taken, mm.
        radius_mm: f64,
    },
    /// The ball that was given does not go to all of the surface.
    BallTooLarge {
        /// Its radius, mm.
        radius_mm: f64,
        /// What it leaves.
        left: Vec<LeftOver>,
        /// Radius of a ball that would go, mm.
        fits_mm: Option<f64>,
    },
    /// The linear axes do not reach the feed even together.
    FeedOutOfReach {
        /// Feed of the job, mm/min.
        feed_mm_min: f64,
        /// Greatest velocities of X, Y and Z, mm/min.
        linear_mm_min: [f64; 3],
    },
    /// Openings that no part of the tool can meet.
    OpeningsOutOfReach {
        /// How many.
        count: usize,
        /// Width of the widest, mm.
        widest_mm: f64,
        /// Heights that the tool takes, mm.
        heights_mm: [f64; 2],
    },
    /// Openings into which the ball does not sink.
    OpeningsTooNarrow {
        /// How many.
        count: usize,
        /// Width of the widest, mm.
        widest_mm: f64,
    },
    /// There is no section at a height.
    NoSection {
        /// Height, mm.
        height_mm: f64,
        /// How wide the part is open there, mm.
        open_mm: f64,
    },
    /// Loops of a section are left out.
    LoopsLeftOut {
        /// Height, mm.
        height_mm: f64,
        /// How many.
        count: usize,
    },
    /// A section goes straight over gaps.
    SectionBridged {
        /// Height, mm.
        height_mm: f64,
        /// Width of the widest gap, mm.
        widest_mm: f64,
    },
    /// A kind of path cannot be laid to be compared with.
    NoPathToCompare {
        /// Name of the kind.
        kind: String,
        /// Why, in one sentence.
        reason: String,
        /// The same as data.
        why: Option<Box<Infeasible>>,
    },
    /// Single teeth leave high marks along the feed.
    FeedMarks {
        /// Their height, mm.
        mark_mm: f64,
        /// Height without a warning, mm.
        most_mm: f64,
        /// Feed per tooth that leaves it, mm.
        fz_mm: f64,
        /// Feed that has it, mm/min.
        feed_mm_min: f64,
    },
    /// Two tools go round a blade that is thin for the couple of their forces.
    NothingHeld {
        /// Least thickness of a section over its chord.
        thickness_over_chord: f64,
    },
    /// The blade cannot turn at one speed all through each turn.
    NotEven {
        /// Greatest share by which it is slower than the rest of its turn.
        share: f64,
    },
    /// No speed of turning stays the same all through a turn.
    SpeedVaries {
        /// Share by which the greatest speed within a turn is over the least.
        share: f64,
        /// The least with which there is a schedule, smooth or not.
        least_share: f64,
        /// With less there is none between these two places.
        between: Option<[Along; 2]>,
    },
    /// The helix ends before the height that the job asks for.
    HelixEndsEarly {
        /// Where it ends, mm.
        height_mm: f64,
        /// Where it is to end, mm.
        asked_mm: f64,
        /// Why.
        reason: EndReason,
    },
    /// Turns laid as first-order neighbours run into one another.
    FirstOrderEnds {
        /// Turns from the end of the region up to there.
        turns: usize,
        /// Height there, mm.
        height_mm: f64,
    },
    /// The helix ends above the place where the channel closes.
    HelixEndsAbove {
        /// Where it ends, mm.
        height_mm: f64,
        /// Why there is no channel farther down.
        reason: EndReason,
        /// What to do to go on.
        advice: String,
    },
    /// The channel would close by the mesh alone.
    ChannelByExactFaces {
        /// Its walls are proven on a finer mesh; else its ends are those of the exact faces.
        proven: bool,
    },
    /// Several channels lead round the path.
    SeveralChannels {
        /// How many.
        count: usize,
    },
    /// The tool leaves the blade on the way, and comes back with another axis.
    TurnsCut {
        /// How often.
        links: usize,
        /// Turn of the first, from 0.
        turn: u32,
        /// Its place on that turn, mm.
        turn_s_mm: f64,
        /// Length of all ways through the air, mm.
        length_mm: f64,
    },
    /// The monotone channel is narrow.
    NarrowChannel {
        /// Its least width, degrees.
        width_deg: f64,
        /// Turn, from 0.
        turn: u32,
        /// Arc length from the turn's base point, mm.
        turn_s_mm: f64,
    },
    /// The quaternion schedule is none to be machined.
    QuaternionLeavesChannel {
        /// How far it is outside the channel, degrees.
        outside_deg: f64,
        /// How often it turns back.
        reversals: usize,
    },
    /// A schedule along a wall of the channel is none to be machined.
    AlongWall {
        /// How far outside the wall, degrees.
        beyond_deg: f64,
        /// How often it turns back.
        reversals: usize,
    },
    /// The schedule of fixed lead is none to be machined.
    FixedLeavesChannel {
        /// Lead, degrees.
        lead_deg: f64,
        /// Locations outside the channel.
        outside: usize,
        /// All locations.
        locations: usize,
        /// How often it turns back.
        reversals: usize,
    },
    /// The margin from the walls cannot be kept everywhere.
    MarginNotKept {
        /// Margin that is asked for, degrees.
        margin_deg: f64,
        /// Locations at which it is less.
        locations: usize,
        /// The least margin, degrees.
        least_deg: f64,
        /// Turn of the least, from 0.
        turn: u32,
        /// Arc length from the turn's base point, mm.
        turn_s_mm: f64,
    },
    /// Level stretches at base points are shorter than asked for.
    LevelShortened {
        /// How many.
        count: usize,
        /// All base points between turns.
        base_points: usize,
        /// Turn of the shortest, from 0.
        turn: u32,
        /// Its length on either side, mm.
        length_mm: f64,
    },
    /// Turns are scheduled together with the turn before.
    TurnsMerged {
        /// How many.
        count: usize,
        /// The first of them, from 0.
        first_turn: u32,
    },
    /// A lead is no arc.
    StraightLead {
        /// `lead-in` or `lead-out`.
        lead: String,
        /// Why.
        reason: LeadReason,
    },
    /// Some of the path has no smooth curve.
    NotSmoothed {
        /// Length of it, mm.
        length_mm: f64,
        /// Length of the path, mm.
        of_mm: f64,
        /// How many places.
        places: usize,
        /// Where the longest of them begins: arc length from the start of the path, mm.
        longest_at_mm: f64,
        /// Why it was left.
        why: WhyLeft,
    },
    /// The whole path stays as it is.
    NothingSmoothed {
        /// Why.
        reason: WhyNone,
    },
    /// The motion's time is not proved closely.
    RoughBound {
        /// Share of the time by which no motion on the grid takes less.
        gap: f64,
    },
    /// Single places stand out over the scallop.
    StandsOut {
        /// Share of the surface.
        share: f64,
        /// More than so many times the scallop.
        ratio: f64,
        /// The highest, mm.
        height_mm: f64,
        /// Its turn, from 0.
        turn: u32,
        /// Its place, model frame, mm.
        at_mm: [f64; 3],
    },
    /// The words of a warning whose data is not known.
    #[serde(skip)]
    Words(String),
    /// What reading the model left to be said.
    #[serde(untagged)]
    Model(Remark),
}

impl Doubt {
    /// There is data besides the words.
    pub fn has_data(&self) -> bool {
        !matches!(self, Doubt::Words(_))
    }
}

/// `, tightest at (…) mm in the model`; nothing where there is no such place.
pub fn tightest(at_mm: &Option<[f64; 3]>) -> String {
    at_mm.map_or_else(String::new, |[x, y, z]| format!(", tightest at ({x:.3}, {y:.3}, {z:.3}) mm in the model"))
}

fn in_words(left: &[LeftOver]) -> String {
    let one = |l: &LeftOver| {
        let missed = 1.0 - l.share;
        let (percent, area_mm2) = (100.0 * missed, missed * l.area_mm2);
        format!("{percent:.1} % of the {} (about {area_mm2:.0} mm²{})", l.of, tightest(&l.tightest_mm))
    };
    left.iter().map(one).collect::<Vec<_>>().join(" and ")
}

impl fmt::Display for Doubt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Doubt::StickOutTooShort { reach_mm, wanted_mm, radius_mm, stickout_mm } => write!(
                f,
                "the part reaches {reach_mm:.1} mm from the blade axis, for which the tool would have to stick out \
                 {wanted_mm} mm; a ball of {radius_mm} mm is sold for {stickout_mm} mm at most, which is taken: the \
                 holder may come near the part"
            ),
            Doubt::NoRoomAtWall { share, radius_mm, tightest_mm } => write!(
                f,
                "at {:.1} % of the wall near the platform not even a ball of {radius_mm} mm has room{}: slits or \
                 damage there have no say in the choice of the tool",
                100.0 * (1.0 - share),
                tightest(tightest_mm)
            ),
            Doubt::BallNotLongEnough { wanted_mm: Some(wanted_mm), radius_mm, left } => write!(
                f,
                "wall and fillet ask for a ball of {wanted_mm} mm, which is not sold long enough; a ball of \
                 {radius_mm} mm does not go to {}: leave that to a second operation with a smaller ball",
                in_words(left)
            ),
            Doubt::BallNotLongEnough { wanted_mm: None, radius_mm, left } => write!(
                f,
                "wall and fillet ask for less than a ball of {radius_mm} mm, the smallest that is sold long enough, \
                 which does not go to {}: leave that to a second operation with a smaller ball",
                in_words(left)
            ),
            Doubt::AirfoilTooThin { most_mm, share_of_chord, chord_mm, height_mm, radius_mm } => write!(
                f,
                "the airfoil asks for a ball below {most_mm:.2} mm, {:.0} % of its chord of {chord_mm:.3} mm at height \
                 {height_mm:.1} mm; {radius_mm} mm is the smallest that is sold long enough",
                100.0 * share_of_chord
            ),
            Doubt::BallTooLarge { radius_mm, left, fits_mm } => {
                let other = fits_mm.map_or_else(String::new, |r| format!("; a ball of {r} mm would"));
                write!(
                    f,
                    "the ball of {radius_mm} mm is too large for this blade: it does not go to {}{other}; what it \
                     leaves is for a second operation with a smaller ball",
                    in_words(left)
                )
            }
            Doubt::FeedOutOfReach { feed_mm_min, linear_mm_min: [x, y, z] } => write!(
                f,
                "feed.feed_mm_min is {feed_mm_min} mm/min, more than the machine's linear axes reach together (X \
                 {x:.0}, Y {y:.0}, Z {z:.0} mm/min): the axes decide the feed everywhere, and figures at full feed \
                 mean nothing"
            ),
            Doubt::OpeningsOutOfReach { count, widest_mm, heights_mm: [lo, hi] } => write!(
                f,
                "{count} openings out of the tool's reach (x = {lo:.2} to {hi:.2} mm along the blade axis), the widest \
                 {widest_mm:.3} mm"
            ),
            Doubt::OpeningsTooNarrow { count, widest_mm } => {
                write!(f, "{count} openings too narrow for the ball to sink in, the widest {widest_mm:.3} mm")
            }
            Doubt::NoSection { height_mm, open_mm } => write!(
                f,
                "there is no section at {height_mm:.3} mm: the part is open there, by {open_mm:.3} mm at the widest; \
                 the others are written"
            ),
            Doubt::LoopsLeftOut { height_mm, count } => {
                write!(f, "the section at {height_mm:.3} mm has {count} hole(s) or open chain(s), left out")
            }
            Doubt::SectionBridged { height_mm, widest_mm } => write!(
                f,
                "the section at {height_mm:.3} mm is drawn straight over gaps of the part, {widest_mm:.3} mm at the \
                 widest"
            ),
            Doubt::NoPathToCompare { kind, reason, .. } => {
                write!(f, "no {kind} path over the same region to compare with: {reason}")
            }
            Doubt::FeedMarks { mark_mm, most_mm, fz_mm, feed_mm_min } => write!(
                f,
                "single teeth leave marks of {mark_mm:.5} mm along the feed, over {most_mm:.5} mm: {fz_mm:.4} mm per tooth would \
                 do, {feed_mm_min:.0} mm/min"
            ),
            Doubt::NothingHeld { thickness_over_chord } => write!(
                f,
                "the blade is {:.1} % of its chord thick, and a double helix does not hold it: the forces of both tools \
                 twist it; rows of opposite places do hold it",
                100.0 * thickness_over_chord
            ),
            Doubt::NotEven { share } => write!(
                f,
                "the blade does not turn evenly: the linear axes hold it up by {:.2} % of its speed in some places, however \
                 slowly it turns",
                100.0 * share
            ),
            Doubt::SpeedVaries { share, least_share, between } => {
                let [most, least] = [share, least_share].map(|s| 100.0 * s);
                write!(f, "the speed of turning varies by up to {most:.1} % within a turn, ")?;
                match between {
                    Some([from, to]) => write!(
                        f,
                        "by {least:.1} % at least: cut.fz_mm and cut.chip_mm leave no one speed from turn {}, S = {:.2} mm to turn {}, \
                         S = {:.2} mm",
                        turn_number(from.turn),
                        from.turn_s_mm,
                        turn_number(to.turn),
                        to.turn_s_mm
                    ),
                    None => f.write_str("since cut.fz_mm and cut.chip_mm leave no smooth schedule that turns evenly"),
                }
            }
            Doubt::HelixEndsEarly { height_mm, asked_mm, reason } => write!(
                f,
                "the helix ends at height {height_mm:.3} mm instead of region.end_mm = {asked_mm} mm: {reason}"
            ),
            Doubt::FirstOrderEnds { turns, height_mm } => write!(
                f,
                "first-order neighbours run into one another at height {height_mm:.3} mm, after {turns} turns from the \
                 end of the region up: the path begins there"
            ),
            Doubt::HelixEndsAbove { height_mm, reason, advice } => {
                write!(f, "the helix ends at height {height_mm:.3} mm, since farther down {reason}; to go on: {advice}")
            }
            Doubt::ChannelByExactFaces { proven } => write!(
                f,
                "the channel is so narrow that the mesh's deflection would close it: {} (channel.exact_ends)",
                if *proven { "its walls are proven on a finer one" } else { "its ends are those of the exact faces" }
            ),
            Doubt::SeveralChannels { count } => write!(
                f,
                "{count} separate channels lead round the path; taken is the one whose narrowest place is widest"
            ),
            Doubt::TurnsCut { links, turn, turn_s_mm, length_mm } => write!(
                f,
                "no tool axis leads on along the blade at {links} places, first at turn {}, S = {turn_s_mm:.2} mm: there \
                 the tool leaves the blade along its axis and comes back with another, {length_mm:.0} mm through the air \
                 in all",
                turn_number(*turn)
            ),
            Doubt::NarrowChannel { width_deg, turn, turn_s_mm } => write!(
                f,
                "the monotone channel is only {width_deg:.3}° wide at turn {}, S = {turn_s_mm:.3} mm: the schedule \
                 has little room there",
                turn_number(*turn)
            ),
            Doubt::QuaternionLeavesChannel { outside_deg, reversals } => write!(
                f,
                "the quaternion schedule leaves the channel by up to {outside_deg:.3} deg and turns back {reversals} \
                 times; it is a baseline to compare with, not to be machined"
            ),
            Doubt::AlongWall { beyond_deg, reversals } => {
                let outside = if *beyond_deg == 0.0 { String::new() } else { format!(", {beyond_deg}° outside it") };
                write!(
                    f,
                    "the schedule runs along a wall of the channel{outside}, to try the channel: it turns back \
                     {reversals} times and is not to be machined"
                )
            }
            Doubt::FixedLeavesChannel { lead_deg, outside, locations, reversals } => write!(
                f,
                "the fixed schedule (lead {lead_deg} deg) is outside the channel at {outside} of {locations} locations \
                 and turns back {reversals} times; it is a baseline to compare with, not to be machined"
            ),
            Doubt::MarginNotKept { margin_deg, locations, least_deg, turn, turn_s_mm } => write!(
                f,
                "the channel is narrower than four margins of {margin_deg:.3} deg at {locations} locations; there a \
                 quarter of its width is kept, least {least_deg:.6} deg at turn {}, S = {turn_s_mm:.3} mm",
                turn_number(*turn)
            ),
            Doubt::LevelShortened { count, base_points, turn, length_mm } => write!(
                f,
                "the level stretch at {count} of {base_points} base points had to be shortened to fit the channel, \
                 most at turn {} to {length_mm:.3} mm on either side; rotary acceleration is greater there",
                turn_number(*turn)
            ),
            Doubt::TurnsMerged { count, first_turn } => write!(
                f,
                "{count} turns are scheduled together with the turn before, first turn {}: they are short \
                 outer turns or the channel holds no level stretch at their base points",
                turn_number(*first_turn)
            ),
            Doubt::StraightLead { lead, reason } => write!(f, "the {lead} is straight along the tool axis: {reason}"),
            Doubt::NotSmoothed { length_mm, of_mm, places, longest_at_mm, why } => write!(
                f,
                "{length_mm:.1} of {of_mm:.1} mm of the path ({:.2} %) stay as they are, without a smooth curve, in \
                 {places} places; the longest begins {longest_at_mm:.1} mm from the start of the path: {why}",
                100.0 * length_mm / of_mm
            ),
            Doubt::NothingSmoothed { reason } => {
                write!(f, "the path stays as it is, although the job asks for a smooth curve: {reason}")
            }
            Doubt::RoughBound { gap } => write!(
                f,
                "the motion keeps all limits; on the grid of its locations none that does takes less time by more than \
                 {:.1} %, and no closer bound is proved, since the axes' positions are rough along the path",
                100.0 * gap
            ),
            Doubt::StandsOut { share, ratio, height_mm, turn, at_mm: [x, y, z] } => {
                let (percent, number) = (100.0 * share, turn_number(*turn));
                let part = if percent < 0.005 { "under 0.01 %".to_owned() } else { format!("{percent:.2} %") };
                write!(
                    f,
                    "{part} of the surface stands more than {ratio} times the scallop high, the most {height_mm:.4} mm \
                     at turn {number}, ({x:.3}, {y:.3}, {z:.3}) mm in the model: see the scallop map there, and machine \
                     it again, or take a smaller scallop or ball"
                )
            }
            Doubt::Words(text) => f.write_str(text),
            Doubt::Model(remark) => remark.fmt(f),
        }
    }
}
