//! The setup and tool sheet: what stands at the machine before the program runs, on one printed
//! page.

use super::figures::{self, table};
use super::{ReportInput, escape, figure, number};
use crate::artifact::obstacle::Obstacle;
use crate::artifact::{Blade, Plan};
use crate::machine::{Axis, Machine, Provenance};
use crate::tool::Tool;

/// The section of the page; its style prints it on a page of its own.
pub(super) fn section(input: &ReportInput) -> String {
    format!(
        "<section id=\"sheet\"><h2>Setup and tool</h2>\n<p class=\"hint\"><button type=\"button\" id=\"print-sheet\">Print this sheet \
         alone</button></p>\n<div class=\"pair\"><div>{}{}</div><div>{}</div></div>\n{}{}</section>\n",
        part(input),
        zero(&Zero { blade: input.blade, machine: input.machine, obstacles: input.obstacles, lean: lean(input) }),
        tool(input),
        limits(input.machine),
        figures::cycles(input)
    )
}

/// A table of names and what they are.
pub(super) fn list(label: &str, rows: &[(&str, String)]) -> String {
    let row = |(name, value): &(&str, String)| format!("<tr><th scope=\"row\">{name}</th><td>{value}</td></tr>");
    let body: String = rows.iter().filter(|(_, value)| !value.is_empty()).map(row).collect();
    format!("<h3>{label}</h3><table class=\"plain\"><tbody>{body}</tbody></table>\n")
}

fn part(input: &ReportInput) -> String {
    let of_model = |label: &str| input.provenance.iter().find(|(l, _)| l == label).map(|(_, v)| escape(v));
    let summary = |pointer: &str| figure(&input.summary, pointer);
    let region = match input.plan {
        Some(_) => format!(
            "{} at {} to {} mm along the blade axis",
            input.tool.centre_name(),
            summary("/region_x_mm/0"),
            summary("/region_x_mm/1")
        ),
        None => String::new(),
    };
    let has_stock =
        input.summary.json.pointer("/stock_mm").and_then(serde_json::Value::as_f64).is_some_and(|s| s > 0.0);
    let stock = if has_stock { format!("{} mm stay on the part", summary("/stock_mm")) } else { String::new() };
    list(
        "Part",
        &[
            ("Blade", escape(&input.blade.name)),
            ("Model", of_model("Model").unwrap_or_default()),
            ("BLAKE3", of_model("BLAKE3 of the model").map(|h| format!("<code>{h}</code>")).unwrap_or_default()),
            ("Region", region),
            ("Stock", stock),
            ("Program", input.program.map(|p| escape(&p.file_name)).unwrap_or_default()),
        ],
    )
}

fn vector(v: impl IntoIterator<Item = f64>) -> String {
    // Adding 0 turns -0 into 0.
    let all: Vec<String> = v.into_iter().map(|v| number((v * 1e6).round() / 1e6 + 0.0).replace('-', "−")).collect();
    format!("({})", all.join(", "))
}

/// How far the tool leans, in words; nothing without a plan.
fn lean(input: &ReportInput) -> String {
    let words = |p: &Plan| {
        let [least, most] = p.leans_rad().map(f64::to_degrees);
        if least == most {
            format!("tool leans {}° towards the tip where the path begins", number(least)).replace('-', "−")
        } else {
            format!("tool leans {least:.1}° to {most:.1}° towards the tip along the path").replace('-', "−")
        }
    };
    input.plan.map(words).unwrap_or_default()
}

/// What the zero point and the clamping follow from.
pub(super) struct Zero<'a> {
    /// The blade.
    pub(super) blade: &'a Blade,
    /// The machine.
    pub(super) machine: &'a Machine,
    /// Fixtures and stock.
    pub(super) obstacles: &'a [Obstacle],
    /// How the tool leans, in words.
    pub(super) lean: String,
}

/// Where the blade frame is: in the model, and on the machine.
pub(super) fn zero(of: &Zero) -> String {
    let (mount, place) = (&of.machine.mount, &of.blade.model_from_blade);
    let directions = place.rotation.to_rotation_matrix();
    let column = |k: usize| vector(directions.matrix().column(k).iter().copied());
    let axes = of.machine.axes();
    let turning = &axes[of.machine.turning_axis()].name;
    let clamped = format!(
        "turned by {}° about its axis (right-hand rule), root to tip along {}, while the rotary axes read 0",
        number(mount.clamping_deg).replace('-', "−"),
        mount.along.map_or_else(|| "machine +X".into(), |along| format!("machine {}", vector(along)))
    );
    let obstacles: Vec<String> = of.obstacles.iter().map(|o| escape(&o.name)).collect();
    list(
        "Zero point and clamping",
        &[
            ("Zero, model", format!("{} mm", vector(place.translation.vector.iter().copied()))),
            ("x, y there", format!("{}, {}; x runs from root to tip", column(0), column(1))),
            ("Zero, machine", format!("{} mm while {turning} = 0", vector(mount.offset_mm))),
            ("Clamped", clamped),
            ("Head", of.lean.clone()),
            ("In the way", obstacles.join(", ")),
        ],
    )
}

fn tool(input: &ReportInput) -> String {
    let asked = input.program.and_then(|p| p.asked.first());
    let number_of = asked.map(|a| format!("T{}", a.tool_number)).unwrap_or_default();
    let spindle = asked.map(|a| format!("{} 1/min", number(a.spindle_rpm))).unwrap_or_default();
    one_tool("Tool", input.tool, &[("Number", number_of), ("Spindle", spindle)])
}

/// A tool with its outline, and what else is said of it.
pub(super) fn one_tool(label: &str, t: &Tool, more: &[(&'static str, String)]) -> String {
    let centre = t.centre_name();
    let mut rows = more.to_vec();
    rows.extend([
        if t.is_ball() {
            ("Ball end", format!("R {} mm", number(t.radius_mm)))
        } else {
            ("Cutter", format!("R {} mm, corner R {} mm", number(t.radius_mm), number(t.corner_mm())))
        },
        ("Taper", format!("{}° half angle", number(t.taper_deg))),
        ("Shank", format!("R {} mm", number(t.shank_radius_mm))),
        (
            "Stick-out",
            format!(
                "{} mm from the {centre}, {} from the tip",
                number(t.stickout_mm),
                number(t.stickout_mm + t.corner_mm())
            ),
        ),
    ]);
    let holder = |h: &crate::tool::HolderStage| format!("R {} × {} mm", number(h.radius_mm), number(h.length_mm));
    rows.push(("Holder", t.holder.iter().map(holder).collect::<Vec<_>>().join(", then ")));
    rows.push((
        "Gauge length",
        format!(
            "{} mm from the {centre}, {} from the tip",
            number(t.length_mm()),
            number(t.length_mm() + t.corner_mm())
        ),
    ));
    format!("{}{}", list(label, &rows), drawing(t))
}

/// The tool's outline, the tip to the left, to scale.
fn drawing(tool: &Tool) -> String {
    let segments = tool.segments();
    let widest = segments.iter().map(|s| s.r0.max(s.r1)).fold(tool.radius_mm, f64::max);
    let (r, disc, taper) = (tool.corner_mm(), tool.disc_radius_mm(), tool.taper_deg.to_radians());
    let side = |sign: f64| -> Vec<String> {
        segments
            .iter()
            .flat_map(|s| [[s.z0, s.r0], [s.z1, s.r1]])
            .map(|[z, r]| format!("{z:.3} {:.3}", sign * r))
            .collect()
    };
    let mut below = side(1.0);
    below.reverse();
    // From below the axis over the tip, which lies a ball's or corner's radius to the left, and up
    // both sides.
    let end = if tool.is_ball() {
        let [x, y] = [-r * taper.sin(), r * taper.cos()];
        format!("M{x:.3} {y:.3}A{r:.3} {r:.3} 0 0 1 {:.3} 0A{r:.3} {r:.3} 0 0 1 {x:.3} {:.3}", -r, -y)
    } else {
        let [x, y] = [r * taper.sin(), disc + r * taper.cos()];
        format!(
            "M{x:.3} {y:.3}A{r:.3} {r:.3} 0 0 1 {tip:.3} {disc:.3}L{tip:.3} {:.3}A{r:.3} {r:.3} 0 0 1 {x:.3} {:.3}",
            -disc,
            -y,
            tip = -r
        )
    };
    let path = format!("{end}L{}L{}Z", side(-1.0).join("L"), below.join("L"));
    let (length, margin) = (tool.length_mm(), 0.06 * widest);
    format!(
        "<svg class=\"tool\" role=\"img\" aria-label=\"Outline of the tool in its holder, to scale\" viewBox=\"{:.3} {:.3} {:.3} {:.3}\">\
         <path d=\"{path}\" vector-effect=\"non-scaling-stroke\"/><path class=\"end\" d=\"M{s:.3} {:.3}V{:.3}M0 {:.3}V{:.3}\" \
         vector-effect=\"non-scaling-stroke\"/></svg>\n",
        -r - margin,
        -widest - margin,
        length + r + 2.0 * margin,
        2.0 * (widest + margin),
        -widest,
        widest,
        -tool.radius_mm,
        tool.radius_mm,
        s = tool.stickout_mm,
    )
}

/// How far and how fast the axes go.
pub(super) fn limits(machine: &Machine) -> String {
    let line = |axis: &Axis| {
        let (l, scale) = (axis.limits, axis.scale());
        let shown = |v: f64| number(v * scale).replace('-', "−");
        let travel = l.travel.map_or_else(|| "unlimited".into(), |[lo, hi]| format!("{} to {}", shown(lo), shown(hi)));
        let from = if l.provenance == Provenance::Assumed { "assumed" } else { "measured" };
        let cells = if axis.is_missing {
            ["none: the tool stands at 0", "", "", "", ""].map(String::from)
        } else {
            [travel, shown(l.velocity), shown(l.acceleration), shown(l.jerk), from.into()]
        };
        let cells: String = cells.iter().map(|c| format!("<td class=\"n\">{c}</td>")).collect();
        format!("<tr><th scope=\"row\">{}, {}</th>{cells}</tr>\n", escape(&axis.name), axis.sign())
    };
    let body: String = machine.axes().iter().map(line).collect();
    let head = [
        ("Axis", false),
        ("travel", true),
        ("velocity, /s", true),
        ("acceleration, /s²", true),
        ("jerk, /s³", true),
        ("limits", true),
    ];
    format!("<h3>Machine {}</h3>\n{}", escape(&machine.name), table("Limits of the machine", &head, &body))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    #[test]
    fn the_outline_reaches_from_the_tip_to_the_end_of_the_holder() {
        let tool = sample::tool();
        let text = drawing(&tool);
        assert!(text.contains(&format!("A{r:.3} {r:.3} 0 0 1 {:.3} 0A", -tool.radius_mm, r = tool.radius_mm)));
        let widest = tool.holder.iter().map(|h| h.radius_mm).fold(tool.shank_radius_mm, f64::max);
        assert!(text.contains(&format!("L{:.3} {:.3}L", tool.length_mm(), -widest)), "{text}");
        assert!(!text.contains("NaN"));
        // A flat bottom between two arcs that end where the cone begins.
        let bull = Tool { radius_mm: 8.0, corner_radius_mm: Some(2.0), ..tool };
        let first = bull.segments().remove(0);
        let begins =
            format!("M{z:.3} {r:.3}A2.000 2.000 0 0 1 -2.000 6.000L-2.000 -6.000A", z = first.z0, r = first.r0);
        assert!(drawing(&bull).contains(&begins), "{}", drawing(&bull));
    }
}
