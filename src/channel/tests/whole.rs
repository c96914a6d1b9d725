//! Whole paths.

use std::f64::consts::{PI, TAU};

use proptest::prelude::*;
use proptest::test_runner::TestRunner;

use super::super::forbidden::MOVE_TOLERANCES;
use super::super::{ChannelOptions, Leans, Surroundings, part, plan, plan_or_gaps, proven};
use super::brute::cases;
use super::location::open_options;
use super::world::{banana, blade, ellipse, helix, least_margin, on_platform, tool};
use crate::artifact::channel::Binding;
use crate::artifact::{Channel, Cone, Cones, Sweep, Toolpath};
use crate::error::{Bound, ErrorKind, Infeasible};
use crate::geometry::mesh::Mesh;
use crate::geometry::{Point, Vector};
use crate::observe::Silent;

#[test]
fn an_ellipse_gives_one_wide_channel_that_grows_by_a_turn() {
    let outline = ellipse(20.0, 8.0);
    let blade = on_platform(&outline, 100, 40.0);
    let path = helix(&outline, 4.0, 60, 2, 12.0, 0.4);
    let o = ChannelOptions::default();
    let channel = plan(&blade, &tool(4.0, 4.0), &path, &o, &Silent).unwrap();
    assert_eq!(channel.rows.len(), path.locations.len());
    assert_eq!(channel.chains, 1);
    for (i, row) in channel.rows.iter().enumerate() {
        assert!(row.theta_max - row.theta_min > 1.5, "{i}: {row:?}");
        assert!(row.hull_min >= row.theta_min && row.hull_max <= row.theta_max && row.hull_min <= row.hull_max);
        let later = &channel.rows.get(i + 60);
        if let Some(later) = later {
            assert!((later.theta_min - row.theta_min - TAU).abs() < 0.05);
        }
    }
    // No tool position in the channel comes nearer than the clearance: the walls and between them.
    for row in (0..path.locations.len()).step_by(31) {
        let (r, l) = (&channel.rows[row], &path.locations[row]);
        for f in [0.0, 0.3, 1.0] {
            let theta = r.theta_min + f * (r.theta_max - r.theta_min);
            let m = least_margin(&blade.part.mesh, &tool(4.0, 4.0), (0.1, 1.0), path.cone(0), &l.centre, theta);
            assert!(m > -1e-9, "row {row}: {m}");
        }
    }
}

/// Walls stay, hulls are those of the rows that are left: what is before and behind asks nothing of
/// them any more.
#[test]
fn a_part_of_a_channel_has_hulls_of_its_own() {
    let outline = ellipse(20.0, 8.0);
    let blade = on_platform(&outline, 100, 40.0);
    let path = helix(&outline, 4.0, 60, 2, 12.0, 0.4);
    let whole = plan(&blade, &tool(4.0, 4.0), &path, &ChannelOptions::default(), &Silent).unwrap();
    let [first, last] = [17, whole.rows.len() - 25];
    let own = part(&whole, [first, last]);
    assert_eq!(own.rows.len(), last - first + 1);
    let mut low = f64::NEG_INFINITY;
    for (row, was) in own.rows.iter().zip(&whole.rows[first..]) {
        assert_eq!((row.theta_min, row.theta_max), (was.theta_min, was.theta_max));
        low = row.theta_min.max(low);
        assert_eq!(row.hull_min, low);
        assert!(row.hull_min <= was.hull_min && row.hull_max >= was.hull_max);
    }
    let width = |k: usize| own.rows[k].hull_max - own.rows[k].hull_min;
    assert!((0..own.rows.len()).all(|k| width(k) >= width(own.narrowest_row)));
}

#[test]
fn a_concave_side_narrows_the_monotone_channel() {
    let outline = banana(40.0, 1.0, 4.0);
    let blade = on_platform(&outline, 150, 60.0);
    let path = helix(&outline, 4.0, 120, 2, 12.0, 0.4);
    let channel = plan(&blade, &tool(4.0, 3.0), &path, &ChannelOptions::default(), &Silent).unwrap();
    // Not monotone as it is, monotone in its hulls.
    assert!(channel.rows.windows(2).any(|w| w[1].theta_max < w[0].theta_max - 1e-3));
    assert!(channel.rows.windows(2).all(|w| w[1].hull_max >= w[0].hull_max && w[1].hull_min >= w[0].hull_min));
    // Ends are bound by the part somewhere, and the paper's limits hold constant on the concave
    // side.
    assert!(channel.rows.iter().any(|r| matches!(r.binds_max, Binding::Part { .. })));
    let held = channel.rows.windows(2).filter(|w| w[0].tangent_max == w[1].tangent_max).count();
    assert!(held > 30, "{held}");
    let span = channel.rows[120].tangent_max - channel.rows[0].tangent_max;
    assert!((span - TAU).abs() < 1e-3, "{span}");
}

#[test]
fn turning_the_part_turns_the_channel() {
    let outline = banana(40.0, 0.8, 4.0);
    let turned = |t: f64| {
        let (p, n) = outline(t);
        ([-p[1], p[0]], [-n[1], n[0]])
    };
    let o = ChannelOptions::default();
    let t = tool(4.0, 3.0);
    let a = plan(&on_platform(&outline, 80, 60.0), &t, &helix(&outline, 4.0, 50, 1, 12.0, 0.4), &o, &Silent).unwrap();
    let b = plan(&on_platform(&turned, 80, 60.0), &t, &helix(&turned, 4.0, 50, 1, 12.0, 0.4), &o, &Silent).unwrap();
    let shift = ((b.rows[0].theta_min - a.rows[0].theta_min) / (PI / 2.0)).round() * PI / 2.0;
    for (r, q) in a.rows.iter().zip(&b.rows) {
        assert!((q.theta_min - r.theta_min - shift).abs() < 3.0 * o.settings.tolerance_deg.to_radians());
        assert!((q.theta_max - r.theta_max - shift).abs() < 3.0 * o.settings.tolerance_deg.to_radians());
    }
}

#[test]
fn the_same_on_one_thread_and_on_three() {
    let outline = banana(40.0, 1.0, 4.0);
    let blade = on_platform(&outline, 80, 60.0);
    let path = helix(&outline, 4.0, 50, 2, 12.0, 0.4);
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| plan(&blade, &tool(4.0, 3.0), &path, &ChannelOptions::default(), &Silent)).unwrap()
    };
    assert_eq!(on(1), on(3));
}

#[test]
fn a_holder_too_near_the_platform_is_named() {
    let outline = ellipse(20.0, 8.0);
    let blade = on_platform(&outline, 100, 80.0);
    let path = helix(&outline, 4.0, 60, 1, 6.0, 0.4);
    let mut t = tool(4.0, 3.0);
    t.stickout_mm = 14.0;
    let e = plan(&blade, &t, &path, &ChannelOptions::default(), &Silent).unwrap_err();
    assert_eq!(e.kind, ErrorKind::Infeasible);
    assert!(e.message.contains("holder 1 against group 1"), "{e}");
    // The same as data.
    let Some(Infeasible::NoFreeAngle { at, at_start: true, bounds, .. }) = e.infeasible.as_deref() else {
        panic!("{:?}", e.infeasible)
    };
    assert!((at.location, at.turn, at.height_mm) == (0, 0, 6.0), "{at:?}");
    assert!(bounds.contains(&Bound::Part { tool: "holder 1".into(), face: "group 1".into() }), "{bounds:?}");
    assert!(e.advice.unwrap().contains("stick out"));
}

#[test]
fn a_pocket_too_bent_for_a_monotone_schedule_is_named() {
    // The strip bends by 180°: on its inner side the axis would have to turn back by more than the
    // channel is wide.
    let outline = banana(30.0, 3.1, 3.0);
    let blade = on_platform(&outline, 100, 60.0);
    let path = helix(&outline, 2.0, 60, 1, 12.0, 0.4);
    let mut t = tool(2.0, 2.0);
    t.holder.clear();
    t.stickout_mm = 80.0;
    let e = plan(&blade, &t, &path, &ChannelOptions::default(), &Silent).map(|_| ()).unwrap_err();
    assert_eq!(e.kind, ErrorKind::Infeasible);
    assert!(e.message.contains("turning back") || e.message.contains("no angle"), "{e}");
    match e.infeasible.as_deref() {
        Some(Infeasible::WallsCross { lower_at, lower_deg, upper_at, upper_deg, .. }) => {
            assert!(lower_at.location < upper_at.location && lower_deg > upper_deg, "{e:?}");
        }
        other => assert!(matches!(other, Some(Infeasible::NoFreeAngle { .. })), "{other:?}"),
    }
}

#[test]
fn impossible_options_are_usage_errors() {
    let outline = ellipse(20.0, 8.0);
    let blade = on_platform(&outline, 40, 40.0);
    let path = helix(&outline, 4.0, 30, 1, 12.0, 0.4);
    for o in [
        ChannelOptions::default().with(|s| s.clearance_mm = -1.0),
        ChannelOptions::default().with(|s| s.contact_angle_min_deg = 100.0),
        ChannelOptions::default().with(|s| s.tolerance_deg = 0.0),
    ] {
        let e = plan(&blade, &tool(4.0, 3.0), &path, &o, &Silent).unwrap_err();
        assert_eq!(e.kind, ErrorKind::Usage);
    }
    let one_short = vec![Cone::about_blade(0.1), Cone::about_blade(0.2)];
    for cones in [Cones::about_blade(f64::NAN), Cones::about_blade(1.5), Cones::along(one_short)] {
        let (path, o) = (path.clone().with_cones(cones), ChannelOptions::default());
        let e = plan(&blade, &tool(4.0, 3.0), &path, &o, &Silent).unwrap_err();
        assert_eq!(e.kind, ErrorKind::Usage);
    }
}

#[test]
fn walls_hold_between_locations() {
    let outline = banana(40.0, 1.0, 4.0);
    let blade = on_platform(&outline, 90, 60.0);
    // Coarse: about 2 mm from location to location, round the ends up to 40 degrees of the normal.
    let path = helix(&outline, 4.0, 45, 1, 12.0, 0.4);
    let (o, t) = (ChannelOptions::default().with(|s| s.prove_moves = true), tool(4.0, 5.0));
    let channel = plan(&blade, &t, &path, &o, &Silent).unwrap();
    for i in (0..path.locations.len() - 1).step_by(4) {
        let (a, b) = (&channel.rows[i], &channel.rows[i + 1]);
        for time in [0.3, 0.5, 0.8] {
            let from = path.locations[i].centre;
            let centre = from + (path.locations[i + 1].centre - from) * time;
            let mix = |x: f64, y: f64| x + time * (y - x);
            for theta in [mix(a.theta_min, b.theta_min), mix(a.theta_max, b.theta_max)] {
                let m = least_margin(&blade.part.mesh, &t, (0.1, 1.0), path.cone(0), &centre, theta);
                assert!(m > -1e-9, "after location {i}, time {time}: {m}");
            }
        }
    }
}

/// A square post along the blade axis with the given middle.
fn post(y: f64, z: f64) -> crate::geometry::mesh::Mesh {
    let mut mesh = crate::geometry::mesh::Mesh::default();
    let w = 3.0;
    super::world::prism(&[[y - w, z - w], [y + w, z - w], [y + w, z + w], [y - w, z + w]], [-20.0, 80.0], 0, &mut mesh);
    mesh
}

fn fixture(mesh: crate::geometry::mesh::Mesh, cut_by_the_tool: bool) -> crate::artifact::Obstacle {
    crate::artifact::Obstacle {
        name: "fixture post.stl".into(),
        part: crate::geometry::part::Part::from_mesh(mesh),
        clearance_mm: 0.5,
        holder_clearance_mm: 0.5,
        cut_by_the_tool,
        of_the_wheel: false,
        copies: Vec::new(),
    }
}

#[test]
fn a_fixture_binds_where_it_stands_and_the_stock_only_for_the_holder() {
    use super::super::{Surroundings, intervals, plan_among};
    let outline = ellipse(20.0, 8.0);
    let blade = on_platform(&outline, 60, 40.0);
    let path = helix(&outline, 4.0, 60, 1, 12.0, 0.4);
    let (o, t) = (ChannelOptions::default(), tool(4.0, 3.0));
    // Beyond the nose, where only some angles meet it.
    let fixtures = [fixture(post(40.0, 22.0), false)];
    let among = Surroundings::new(&blade, &fixtures, 4.0).unwrap();
    let channel = plan_among(&among, &t, &path, &o, &Silent).unwrap();
    let named = |b: &Binding| matches!(b, Binding::Fixture { name, .. } if name == "fixture post.stl");
    assert!(channel.rows.iter().any(|r| named(&r.binds_min) || named(&r.binds_max)));
    for (r, l) in channel.rows.iter().zip(&path.locations) {
        for theta in [r.theta_min, r.theta_max] {
            let m = least_margin(&fixtures[0].part.mesh, &t, (0.5, 0.5), path.cone(0), &l.centre, theta);
            assert!(m > -1e-9, "{m}");
        }
    }
    // As stock, it is met by the holder alone: never more is taken.
    let stock = [fixture(post(40.0, 22.0), true)];
    let among_stock = Surroundings::new(&blade, &stock, 4.0).unwrap();
    let width = |s: &Surroundings| {
        let all = intervals(s, &t, &path, &o, &Silent).unwrap();
        all.iter().flatten().map(|f| f.theta_max - f.theta_min).sum::<f64>()
    };
    assert!(width(&among_stock) > width(&among) + 0.1);
    // On the path of the ball, or all round it, there is nothing to turn to.
    let on_it = [fixture(post(27.0, 0.0), false)];
    let e = plan_among(&Surroundings::new(&blade, &on_it, 4.0).unwrap(), &t, &path, &o, &Silent).unwrap_err();
    assert!(e.kind == ErrorKind::Infeasible && e.message.contains("the tool starts in collision"), "{e}");
}

#[test]
fn limits_of_the_rotary_axis_bind_and_close() {
    let outline = ellipse(20.0, 8.0);
    let blade = on_platform(&outline, 60, 40.0);
    let path = helix(&outline, 4.0, 60, 1, 12.0, 0.4);
    let t = tool(4.0, 3.0);
    let wide = plan(&blade, &t, &path, &ChannelOptions::default(), &Silent).unwrap();
    let least = wide.rows[0].theta_min + 0.3;
    let limited =
        |greatest: f64| ChannelOptions { theta_limits_rad: Some([least, greatest]), ..ChannelOptions::default() };
    let channel = plan(&blade, &t, &path, &limited(20.0), &Silent).unwrap();
    assert!((channel.rows[0].theta_min - least).abs() < 1e-9);
    assert_eq!(channel.rows[0].binds_min, Binding::AxisLimit);
    let e = plan(&blade, &t, &path, &limited(2.0), &Silent).unwrap_err();
    assert!(e.message.contains("rotary axis"), "{e}");
}

#[test]
fn advice_opens_what_is_closed_and_widths_follow_b() {
    use super::super::{Surroundings, advise, sweep_b};
    let outline = ellipse(20.0, 8.0);
    let blade = on_platform(&outline, 40, 60.0);
    let path = helix(&outline, 4.0, 40, 1, 6.0, 0.4);
    let mut t = tool(4.0, 3.0);
    t.stickout_mm = 14.0;
    let around = Surroundings::new(&blade, &[], 4.0).unwrap();
    let o = ChannelOptions::default();
    let found = advise(&around, &t, &path, &o, &[0.0, 10.0, 20.0, 30.0, 40.0], &Silent).unwrap();
    assert!(!found.now.is_open());
    let least = found.least_stickout_mm.unwrap();
    t.stickout_mm = least + 0.5;
    assert!(plan(&blade, &t, &path, &o, &Silent).is_ok(), "{least}");
    t.stickout_mm = least - 1.0;
    assert!(plan(&blade, &t, &path, &o, &Silent).is_err(), "{least}");
    let radii = found.holder_radii_mm.unwrap();
    t.stickout_mm = 14.0;
    assert!(radii[0] < t.holder[0].radius_mm);
    t.holder[0].radius_mm = 0.98 * radii[0];
    assert!(plan(&blade, &t, &path, &o, &Silent).is_ok(), "{radii:?}");
    let widths = sweep_b(&around, &t, &path, &o, Leans { b_deg: &[-10.0, 5.0], places: 100 }, &Silent).unwrap();
    assert_eq!(widths[1].b_deg, 5.0);
    assert!(widths[1].narrowest_deg.unwrap() >= widths[1].monotone_deg.unwrap());
}

/// The scene placed anywhere in space, and the cones of its locations written about either
/// direction of their axis with references that are turned at random: the same tool axes are free.
#[test]
fn frames_do_not_matter() {
    let outline = banana(40.0, 1.0, 4.0);
    let blade = on_platform(&outline, 60, 60.0);
    let turn = |per_turn: usize| helix(&outline, 4.0, per_turn, 1, 12.0, 0.4);
    // Proofs of moves take long: fewer cases and a part of a turn do.
    for (proven, path, some) in [(false, turn(30), 8), (true, turn(30).at(&Vec::from_iter(0..10)), 4)] {
        let o = ChannelOptions::default().with(|s| s.prove_moves = proven);
        let plain = plan(&blade, &tool(4.0, 5.0), &path, &o, &Silent).unwrap();
        // An end lies within one tolerance of the true one, always inside: so do two of them of
        // one another, and no closer bound holds, since each frame stops its search elsewhere.
        // Walls are moved in for moves by what is known to `MOVE_TOLERANCES` beside.
        let tolerances = 1.0 + if proven { MOVE_TOLERANCES } else { 0.0 };
        // Rounding of what is turned.
        let room = tolerances * o.settings.tolerance_deg.to_radians() + 1e-9;
        let numbers = |range: f64| prop::array::uniform3(-range..range);
        let written = prop::collection::vec((0.0..TAU, prop::bool::ANY), path.locations.len());
        let config = ProptestConfig { cases: cases(some), failure_persistence: None, ..ProptestConfig::default() };
        let ran = TestRunner::new(config).run(&(numbers(50.0), numbers(3.0), written), |(shift, turn, written)| {
            let place = nalgebra::Isometry3::new(shift.into(), turn.into());
            let mut other = blade.clone();
            other.part = crate::geometry::part::Part::from_mesh(blade.part.mesh.clone().moved(&place));
            let mut moved = path.clone();
            for l in &mut moved.locations {
                (l.centre, l.contact, l.normal) = (place * l.centre, place * l.contact, place * l.normal);
            }
            let cones = written.iter().enumerate().map(|(k, (by, flips))| {
                let cone = path.cone(k);
                let (axis, along) = (place * cone.axis, place * cone.reference);
                // The first keeps its reference, and gives it to all others.
                let (by, flips) = if k == 0 { (0.0, false) } else { (*by, *flips) };
                let reference = nalgebra::UnitQuaternion::from_scaled_axis(axis * by) * along;
                let sign = if flips { -1.0 } else { 1.0 };
                Cone { axis: axis * sign, reference, lean_rad: cone.lean_rad * sign }
            });
            let moved = moved.with_cones(Cones::along(cones.collect()));
            let found = plan(&other, &tool(4.0, 5.0), &moved, &o, &Silent).unwrap();
            prop_assert_eq!((found.chains, found.rows.len()), (plain.chains, plain.rows.len()));
            for (k, (a, b)) in plain.rows.iter().zip(&found.rows).enumerate() {
                let pairs = [(a.theta_min, b.theta_min), (a.theta_max, b.theta_max), (a.hull_min, b.hull_min)];
                for (a, b) in pairs {
                    let axis = place * path.cone(k).tool_axis(a);
                    let off = moved.cone(k).tool_axis(b).angle(&axis);
                    prop_assert!(off <= room, "row {}: {} deg apart", k, off.to_degrees());
                }
            }
            Ok(())
        });
        ran.unwrap();
    }
}

/// Cones that wobble along the path: what is free at each place is what is free there alone.
#[test]
fn cones_may_change_along_the_path() {
    use super::super::{Surroundings, intervals};
    let outline = banana(40.0, 1.0, 4.0);
    let (blade, path) = (on_platform(&outline, 90, 60.0), helix(&outline, 4.0, 60, 2, 12.0, 0.4));
    let (o, t) = (ChannelOptions::default(), tool(4.0, 5.0));
    let wobbling = |k: usize| {
        let at = TAU * k as f64 / 60.0;
        let axis = Vector::new(1.0, 0.08 * at.cos(), 0.08 * at.sin());
        Cone::new(axis, Vector::y(), 0.1 + 0.004 * at.sin()).unwrap()
    };
    let path = path.clone().with_cones(Cones::along((0..path.locations.len()).map(wobbling).collect()));
    let around = Surroundings::new(&blade, &[], 4.0).unwrap();
    let all = intervals(&around, &t, &path, &o, &Silent).unwrap();
    for (k, found) in all.iter().enumerate().step_by(7) {
        let alone = Toolpath {
            locations: vec![path.locations[k]],
            turns: Vec::new(),
            cones: Cones::Same(path.cone(k)),
            ..path.clone()
        };
        let alone = intervals(&around, &t, &alone, &o, &Silent).unwrap().remove(0);
        assert_eq!(found.len(), alone.len(), "{k}");
        for (a, b) in found.iter().zip(&alone) {
            let turn = ((a.theta_min - b.theta_min) / TAU).round() * TAU;
            let off = (a.theta_min - b.theta_min - turn).abs().max((a.theta_max - b.theta_max - turn).abs());
            assert!(off < 1.5 * o.settings.tolerance_deg.to_radians(), "{k}: {off}");
        }
    }
    // The whole channel, its moves proven: at no time does the tool come nearer than it may.
    let path = helix(&outline, 4.0, 60, 1, 12.0, 0.4);
    let path = path.clone().with_cones(Cones::along((0..path.locations.len()).map(wobbling).collect()));
    let channel = plan(&blade, &t, &path, &o.clone().with(|s| s.prove_moves = true), &Silent).unwrap();
    let holds = |channel: &Channel, i: usize| {
        let (a, b) = (&channel.rows[i], &channel.rows[i + 1]);
        for time in [0.0, 0.3, 0.5, 0.8] {
            let from = path.locations[i].centre;
            let centre = from + (path.locations[i + 1].centre - from) * time;
            let mix = |x: f64, y: f64| x + time * (y - x);
            for theta in [mix(a.theta_min, b.theta_min), mix(a.theta_max, b.theta_max)] {
                let m = least_margin(&blade.part.mesh, &t, (0.1, 1.0), path.cones.between(i, time), &centre, theta);
                assert!(m > -1e-9, "after location {i}, time {time}: {m}");
            }
        }
    };
    (0..path.locations.len() - 1).step_by(4).for_each(|i| holds(&channel, i));
    // Some moves of a channel proven afterwards: they hold too, and no other wall moves.
    let before = plan(&blade, &t, &path, &o, &Silent).unwrap();
    let options = ChannelOptions { prove_at: vec![3, 4, 40], ..o };
    let after = proven(&around, &t, (&path, &before), &options, &Silent).unwrap().unwrap();
    assert_eq!(after.proven_at, [3, 4, 40]);
    options.prove_at.iter().for_each(|i| holds(&after, *i));
    let mut moved = 0;
    for (k, (a, b)) in before.rows.iter().zip(&after.rows).enumerate() {
        assert!(b.theta_min >= a.theta_min && b.theta_max <= a.theta_max, "{k}");
        let moves = b.theta_min > a.theta_min || b.theta_max < a.theta_max;
        assert!(!moves || [3, 4, 5, 40, 41].contains(&k), "{k}");
        moved += usize::from(moves);
    }
    assert!(moved > 0);
}

/// Two plates leave a cylinder an angle of 0.8° about one line. Cones about an axis oblique to them
/// cut that line at other angles as they lean: from one location to the next by far more than is
/// free. The way between is followed, and both ends are those of the closed form.
#[test]
fn a_gap_that_is_oblique_to_the_cones_is_followed() {
    let plates = |off: f64| {
        let mut mesh = Mesh::default();
        for y in [-off, off] {
            let n = mesh.points.len() as u32;
            let corners = [[-20.0, -40.0], [20.0, -40.0], [20.0, 40.0], [-20.0, 40.0]];
            mesh.points.extend(corners.map(|[x, z]| Point::new(x, y, z)));
            mesh.triangles.extend([[n, n + 1, n + 2], [n, n + 2, n + 3]]);
        }
        blade(mesh)
    };
    let leans = [0.0, 0.2];
    let oblique = |lean: f64| Cone::new(Vector::new(0.0, 1.0, 1.0), Vector::x(), lean).unwrap();
    let few = helix(&ellipse(20.0, 8.0), 4.0, 60, 1, 6.0, 0.4).at(&[0, 1]);
    let mut path = few.with_cones(Cones::along(leans.map(oblique).to_vec()));
    for (k, l) in path.locations.iter_mut().enumerate() {
        (l.centre, l.normal) = (Point::new(0.01 * k as f64, 0.0, 0.0), Vector::x());
    }
    let options = ChannelOptions { sweep: Sweep::Swing, ..open_options() };
    let found = plan(&plates(4.3), &tool(4.0, 0.0), &path, &options, &Silent).unwrap();
    let line = |lean: f64| -lean.tan().asin();
    for (row, lean) in found.rows.iter().zip(leans) {
        let at = line(lean);
        assert!((row.theta_min..=row.theta_max).contains(&at), "{row:?} {at}");
        assert!(row.theta_max - row.theta_min < 0.02, "{row:?}");
    }
    // What is free at the ends has nothing in common.
    assert!(found.rows[0].theta_min > found.rows[1].theta_max + 0.15);
    // Where plates take the line itself, every place is a gap.
    let shut = plates(4.1);
    let e = plan(&shut, &tool(4.0, 0.0), &path, &options, &Silent).unwrap_err();
    assert_eq!(e.kind, ErrorKind::Infeasible, "{e}");
    let around = Surroundings::new(&shut, &[], 4.0).unwrap();
    let mut closes = Vec::new();
    let found = plan_or_gaps(&around, &tool(4.0, 0.0), &path, &options, &mut closes, &Silent);
    assert_eq!(found.map_err(|e| e.message), Err(e.message));
    assert_eq!(closes, [0, 1]);
}
