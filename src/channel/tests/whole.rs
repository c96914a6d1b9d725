//! Whole paths.

use std::f64::consts::{PI, TAU};

use super::super::{ChannelOptions, plan};
use super::world::{banana, ellipse, helix, least_margin, on_platform, tool};
use crate::artifact::channel::Binding;
use crate::error::ErrorKind;
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
            let m = least_margin(&blade.part.mesh, &tool(4.0, 4.0), (0.1, 1.0), o.b_rad, &l.centre, theta);
            assert!(m > -1e-9, "row {row}: {m}");
        }
    }
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
    // Ends are bound by the part somewhere, and the paper's limits hold constant on the concave side.
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
        assert!((q.theta_min - r.theta_min - shift).abs() < 3.0 * o.tolerance_rad);
        assert!((q.theta_max - r.theta_max - shift).abs() < 3.0 * o.tolerance_rad);
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
    assert!(e.message.contains("holder 1") && e.message.contains("face"), "{e}");
    assert!(e.advice.unwrap().contains("stick out"));
}

#[test]
fn a_pocket_too_bent_for_a_monotone_schedule_is_named() {
    // The strip bends by 180°: on its inner side the axis would have to turn back by more than the channel is wide.
    let outline = banana(30.0, 3.1, 3.0);
    let blade = on_platform(&outline, 100, 60.0);
    let path = helix(&outline, 2.0, 60, 1, 12.0, 0.4);
    let mut t = tool(2.0, 2.0);
    t.holder.clear();
    t.stickout_mm = 80.0;
    let e = plan(&blade, &t, &path, &ChannelOptions::default(), &Silent).map(|_| ()).unwrap_err();
    assert_eq!(e.kind, ErrorKind::Infeasible);
    assert!(e.message.contains("turning back") || e.message.contains("no angle"), "{e}");
}

#[test]
fn impossible_options_are_usage_errors() {
    let outline = ellipse(20.0, 8.0);
    let blade = on_platform(&outline, 40, 40.0);
    let path = helix(&outline, 4.0, 30, 1, 12.0, 0.4);
    for o in [
        ChannelOptions { clearance_mm: -1.0, ..ChannelOptions::default() },
        ChannelOptions { contact_angle_min_rad: 2.0, ..ChannelOptions::default() },
        ChannelOptions { tolerance_rad: 0.0, ..ChannelOptions::default() },
        ChannelOptions { b_rad: f64::NAN, ..ChannelOptions::default() },
    ] {
        let e = plan(&blade, &tool(4.0, 3.0), &path, &o, &Silent).unwrap_err();
        assert_eq!(e.kind, ErrorKind::Usage);
    }
}
