//! The channel in figures: against the published limits from tangents, and against B.

use super::{ReportInput, escape, number};
use crate::artifact::Plan;
use crate::artifact::channel::{Binding, ChannelRow};
use crate::error::turn_number;
use crate::write::draw;

/// What a limit from tangents is off by, over all locations.
#[derive(Debug, Default, PartialEq)]
struct Compared {
    /// Locations at which it lies outside the true wall: there the tool would collide.
    outside: usize,
    /// Farthest outside, degrees, and where.
    outside_most: f64,
    outside_row: usize,
    /// Locations at which it lies inside the true wall by more than a degree.
    timid: usize,
    /// Farthest inside, degrees, and where.
    timid_most: f64,
    timid_row: usize,
}

/// Degrees from which a limit counts as too timid.
const TIMID_DEG: f64 = 1.0;

/// `beyond` gives the degrees by which a row's limit lies outside the wall.
fn compare(rows: &[ChannelRow], tolerance_deg: f64, beyond: impl Fn(&ChannelRow) -> f64) -> Compared {
    let mut c = Compared::default();
    for (i, row) in rows.iter().enumerate() {
        let by = beyond(row).to_degrees();
        c.outside += usize::from(by > tolerance_deg);
        c.timid += usize::from(by < -TIMID_DEG);
        if by > c.outside_most {
            (c.outside_most, c.outside_row) = (by, i);
        }
        if -by > c.timid_most {
            (c.timid_most, c.timid_row) = (-by, i);
        }
    }
    c
}

/// The section of the page; nothing without a plan.
pub(super) fn section(input: &ReportInput) -> String {
    let Some(plan) = input.plan else { return String::new() };
    format!(
        "<section id=\"walls\"><h2>Channel</h2>\n{}{}{}</section>\n",
        limits(plan),
        tangents(plan),
        against_b(input)
    )
}

/// What the walls come from.
fn limits(plan: &Plan) -> String {
    let mut names: Vec<(String, usize)> = Vec::new();
    for b in plan.channel.rows.iter().flat_map(|r| [&r.binds_min, &r.binds_max]) {
        let name = match b {
            Binding::Part { tool, .. } => format!("{tool} against the part"),
            Binding::Fixture { name, tool, .. } => format!("{tool} against {name}"),
            Binding::AxisLimit => "rotary axis".into(),
            Binding::Travel { axis } => format!("travel of {axis}"),
            Binding::ContactAngle => "contact angle".into(),
            Binding::Free => "nothing".into(),
        };
        match names.iter_mut().find(|(n, _)| *n == name) {
            Some((_, count)) => *count += 1,
            None => names.push((name, 1)),
        }
    }
    names.sort_by(|a, b| b.1.cmp(&a.1).then(a.0.cmp(&b.0)));
    let all = 2 * plan.channel.rows.len();
    let share = |n: usize| number(100.0 * n as f64 / all.max(1) as f64);
    let said: Vec<String> = names.iter().map(|(n, c)| format!("{} {} %", escape(n), share(*c))).collect();
    format!(
        "<p>Walls are bound by: {}. Separate channels round the path: {}; the widest is taken.</p>\n",
        said.join(", "),
        plan.channel.chains
    )
}

fn tangents(plan: &Plan) -> String {
    let rows = &plan.channel.rows;
    let tolerance = plan.channel.tolerance_rad.to_degrees();
    let place = |row: usize| {
        let l = plan.toolpath.locations.get(row);
        l.map_or_else(String::new, |l| format!("turn {}, S = {} mm", turn_number(l.turn), number(l.turn_s_mm)))
    };
    let mut body = String::new();
    for (name, c) in [
        ("lower", compare(rows, tolerance, |r| r.theta_min - r.tangent_min)),
        ("upper", compare(rows, tolerance, |r| r.tangent_max - r.theta_max)),
    ] {
        let cell = |count: usize, most: f64, row: usize| {
            let where_to = if count > 0 { format!("{}° at {}", number(most), place(row)) } else { "–".into() };
            format!(
                "<td class=\"n\">{count} ({} %)</td><td>{where_to}</td>",
                number(100.0 * count as f64 / rows.len().max(1) as f64)
            )
        };
        body.push_str(&format!(
            "<tr><th scope=\"row\">{name} limit</th>{}{}</tr>\n",
            cell(c.outside, c.outside_most, c.outside_row),
            cell(c.timid, c.timid_most, c.timid_row)
        ));
    }
    let mean =
        |f: fn(&ChannelRow) -> f64| number(rows.iter().map(f).sum::<f64>().to_degrees() / rows.len().max(1) as f64);
    format!(
        "<h3>Beside limits from tangents</h3><p>Limits as the S–θ method was published, from the path's tangents \
         and the taper alone, against the whole tool among the whole part. Mean width: {}° from tangents, {}° in truth. Where a limit lies outside the true wall \
         the tool would have come too near; where it lies more than {TIMID_DEG}° inside, room is given away.</p>\n\
         <div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Limits from tangents\"><table><thead><tr>\
         <th scope=\"col\">From tangents</th><th scope=\"col\" class=\"n\">Locations outside</th><th scope=\"col\">Farthest</th>\
         <th scope=\"col\" class=\"n\">Locations too timid</th><th scope=\"col\">Farthest</th></tr></thead><tbody>{body}</tbody>\
         </table></div>\n",
        mean(|r| r.tangent_max - r.tangent_min),
        mean(|r| r.theta_max - r.theta_min),
    )
}

fn against_b(input: &ReportInput) -> String {
    let svg = draw::widths_inline(input.widths);
    if svg.is_empty() {
        return String::new();
    }
    let widest = input.widths.iter().filter(|w| w.is_open()).max_by(|a, b| {
        a.monotone_deg
            .unwrap_or(f64::NAN)
            .total_cmp(&b.monotone_deg.unwrap_or(f64::NAN))
            .then(b.b_deg.total_cmp(&a.b_deg))
    });
    let best = widest.map_or_else(
        || "The channel is closed at all of them.".to_owned(),
        |w| {
            let width = number(w.monotone_deg.unwrap_or(f64::NAN));
            format!("Widest between the monotone hulls: {width}° at B = {}°.", number(w.b_deg))
        },
    );
    format!(
        "<h3>Against B</h3><p>Width at the narrowest place with the head at other angles, on this path. {best} Shaded: \
         no channel, or none without turning back.</p>\n{svg}"
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    #[test]
    fn limits_outside_and_inside_are_counted_where_they_are() {
        let mut plan = sample::plan(1, 12);
        for r in &mut plan.channel.rows {
            (r.tangent_min, r.tangent_max) = (r.theta_min, r.theta_max);
        }
        plan.channel.rows[4].tangent_max += 0.1;
        plan.channel.rows[7].tangent_max -= 0.2;
        let c = compare(&plan.channel.rows, 0.01, |r| r.tangent_max - r.theta_max);
        assert_eq!((c.outside, c.outside_row, c.timid, c.timid_row), (1, 4, 1, 7));
        assert!(
            (c.outside_most - 0.1f64.to_degrees()).abs() < 1e-9 && (c.timid_most - 0.2f64.to_degrees()).abs() < 1e-9
        );
        let text = tangents(&plan);
        assert!(text.contains("1 (7.692 %)"), "{text}");
    }
}
