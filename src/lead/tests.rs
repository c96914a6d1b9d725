#![allow(clippy::unwrap_used)]
use super::*;
use crate::artifact::plan::Stretch;
use crate::sample;

fn options() -> LeadOptions {
    LeadOptions { radius_mm: 4.0 }
}

/// On the sample's cylinder everything is known: the ball centres run on a helix of radius 25 and
/// slope 0.5 mm a turn.
#[test]
fn arcs_are_circles_that_touch_the_path_and_lie_across_it() {
    let plan = sample::plan(2, 720);
    for (end, row) in [(End::In, 0), (End::Out, 1440)] {
        let l = plan.toolpath.locations[row];
        let slope = 0.5 / std::f64::consts::TAU;
        let along = Vector::new(slope, -25.0 * l.normal.z, 25.0 * l.normal.y).normalize();
        let all = candidates(&plan.toolpath, &plan.schedule, end, &options());
        // The tool axis leads along the path and leans by 5 degrees: across the path it is the
        // normal's direction.
        assert_eq!(all.len(), 9);
        for lead in &all {
            let (r, n) = (lead.radius_mm, lead.centres.len());
            // The row next to the path first.
            let at = |k: usize| if end == End::In { lead.centres[n - 1 - k] } else { lead.centres[k] };
            let sign = if end == End::In { -1.0 } else { 1.0 };
            let far = at(n - 1) - l.centre;
            let d = (far - along * far.dot(&along)).normalize();
            assert!(d.dot(&l.normal) > 0.8 && (far.dot(&d) - r * (1.0 - lead.angle_rad.cos())).abs() < 1e-4);
            let middle = l.centre + d * r;
            let step = lead.angle_rad / n as f64;
            for k in 0..n {
                assert!(((at(k) - middle).norm() - r).abs() < 1e-3, "{end:?} {k}");
            }
            // The first chord leaves the tangent by half a step.
            let chord = (at(0) - l.centre).normalize() * sign;
            assert!((chord.dot(&along).clamp(-1.0, 1.0).acos() - 0.5 * step).abs() < 1e-3);
            // Chords sag by less than the tolerance.
            assert!(r * (1.0 - (0.5 * step).cos()) < plan.toolpath.chord_mm);
        }
    }
}

#[test]
fn the_tool_axis_goes_on_turning_and_comes_to_rest() {
    let plan = sample::plan(2, 720);
    let rate = (plan.schedule.theta[1] - plan.schedule.theta[0]) / plan.toolpath.locations[1].s_mm;
    for end in [End::In, End::Out] {
        for lead in candidates(&plan.toolpath, &plan.schedule, end, &options()) {
            let mut theta = lead.theta.clone();
            theta.push(plan.schedule.theta[0]);
            if end == End::Out {
                theta = [vec![*plan.schedule.theta.last().unwrap()], lead.theta.clone()].concat();
            }
            assert!(theta.windows(2).all(|w| w[1] >= w[0]), "{end:?} {theta:?}");
            // Half the way at the full rate, or the most that is allowed.
            let turned = theta.last().unwrap() - theta[0];
            let expected = (0.5 * rate * lead.radius_mm * lead.angle_rad).min(MOST_TURN_RAD);
            assert!((turned - expected).abs() < 1e-6, "{turned} {expected}");
        }
    }
}

#[test]
fn a_motion_comes_apart_as_it_was_put_together() {
    let plan = sample::with_leads(sample::plan(2, 90));
    let rows: Vec<_> = plan.rows().collect();
    let [before, after] = &plan.leads;
    assert!(before.is_arc() && after.is_arc());
    assert_eq!(rows.len(), before.centres.len() + 181 + after.centres.len());
    assert_eq!(rows.len(), plan.axes().count());
    assert!(rows.windows(2).all(|w| w[1].t_s > w[0].t_s) && rows[0].t_s == 0.0);
    assert_eq!((rows[0].stretch, rows[rows.len() - 1].stretch), (Stretch::LeadIn, Stretch::LeadOut));
    let turns = rows.iter().filter(|r| r.stretch == Stretch::Turn(1)).count();
    assert_eq!(turns, 91);
    let (path, schedule) = extended(&plan.toolpath, &plan.schedule, &plan.leads);
    assert!(path.locations.windows(2).all(|w| w[1].s_mm > w[0].s_mm));
    for ((l, theta), row) in path.locations.iter().zip(&schedule.theta).zip(&rows) {
        assert_eq!((l.centre, *theta), (row.stand.centre, row.stand.theta));
        // The arc length is that of the rows but for chords.
    }
    let way: f64 = path.locations.windows(2).map(|w| (w[1].centre - w[0].centre).norm()).sum();
    let said = path.locations.last().unwrap().s_mm - path.locations[0].s_mm;
    assert!((way / said - 1.0).abs() < 1e-3, "{way} {said}");
}

#[test]
fn a_path_without_a_tangent_has_no_arc() {
    let mut plan = sample::plan(1, 12);
    plan.toolpath.locations.truncate(2);
    plan.schedule.theta.truncate(2);
    assert!(candidates(&plan.toolpath, &plan.schedule, End::In, &options()).is_empty());
    let mut plan = sample::plan(1, 12);
    plan.toolpath.locations[0].centre.x = f64::NAN;
    assert!(candidates(&plan.toolpath, &plan.schedule, End::In, &options()).is_empty());
}
