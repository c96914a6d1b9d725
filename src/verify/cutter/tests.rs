#![allow(clippy::unwrap_used)]
use super::*;
use crate::geometry::exact::tests::block;
use crate::geometry::part::Part;
use crate::observe::Silent;
use crate::sample;
use proptest::prelude::*;

/// A bull-nose cutter of radius 8 with a corner of 2 mm.
fn bull() -> Tool {
    Tool { radius_mm: 8.0, corner_radius_mm: Some(2.0), taper_deg: 0.0, shank_radius_mm: 8.0, ..sample::tool() }
}

/// x and z from 0 to 40, its top at y = 10.
fn slab() -> Part {
    Part::from_brep(block(Vector::new(40.0, 10.0, 40.0)), 0.05, &Silent).unwrap()
}

static SLAB: std::sync::LazyLock<Part> = std::sync::LazyLock::new(slab);

/// Over the middle of the top, the disc's centre so high, the axis leaning by so much towards x and
/// turned by so much about it.
fn stand(height: f64, lean: f64, theta: f64) -> Stand {
    Stand::about_blade(Point::new(20.0, 10.0 + height, 20.0), theta, lean)
}

fn gouge(part: &Part, tool: &Tool, stands: &[Stand], resolution_mm: f64) -> Gouge {
    let wanted = vec![true; stands.len() - 1];
    measure_within(&Allowed::new(part, 0.0), &SweptCutter { stands, wanted: &wanted, tool }, resolution_mm, 0.0)
}

#[test]
fn over_a_plane_depths_are_in_closed_form() {
    let (part, tool) = (slab(), bull());
    for lean in [0.05f64, 0.2, 0.6] {
        // The rim hangs 6 sin α below the centre, the corner 2 lower.
        let over = 6.0 * lean.sin() + 2.0;
        for deep in [0.005, 0.3, -0.01] {
            let mut ends = [stand(over - deep, lean, 0.0); 2];
            ends[1].centre.x += 3.0;
            let g = gouge(&part, &tool, &ends, 1e-4);
            assert!((g.found_mm - deep).abs() < 1e-8, "{lean} {deep}: {g:?}");
            assert!(g.bound_mm <= deep.max(0.0) + 3e-4_f64.max(0.021 * deep), "{g:?}");
        }
    }
    // So deep that the rim itself is in the part: more than the corner, by how deep it lies there.
    let sunk = gouge(&part, &tool, &[stand(0.3, 0.0, 0.1), stand(0.3, 0.0, 0.1)], 1e-3);
    let deep = 2.0 + 6.0 * 0.1f64.sin() - 0.3;
    assert!(sunk.found_mm <= deep + 1e-9 && sunk.found_mm > deep - 0.01, "{sunk:?} {deep}");
}

/// The axis swings through the upright: in the middle the bottom is highest, so that both ends cut
/// deepest; and about a place in between, where it is the other way round.
#[test]
fn where_the_axis_turns_the_deepest_place_is_found() {
    let (part, tool) = (slab(), bull());
    let g = gouge(&part, &tool, &[stand(2.5, -0.09, 0.0), stand(2.5, 0.1, 0.0)], 1e-4);
    let deep = 2.0 + 6.0 * 0.1f64.sin() - 2.5;
    assert!((g.found_mm - deep).abs() < 1e-8 && g.bound_mm < deep + 3e-3, "{g:?} {deep}");
    // Turning about the normal by two right angles with a lean: the rim stays as deep all the way,
    // while between the ends the centre dips on a chord of its own.
    let turned = |theta: f64| Stand { centre: Point::new(20.0 + theta, 12.0, 20.0), ..stand(0.0, 0.0, theta) };
    let g = gouge(&part, &tool, &[turned(-0.3), turned(0.2)], 1e-4);
    let deep = 6.0 * 0.3f64.sin();
    assert!((g.found_mm - deep).abs() < 1e-8 && g.bound_mm < deep + 0.02 * deep + 3e-3, "{g:?} {deep}");
}

#[test]
fn touching_and_deeper_moves_are_told() {
    let (part, tool) = (slab(), bull());
    let stands: Vec<Stand> = [3.0, 2.002, 1.99, 2.5, 2.5].map(|h| stand(h, 0.0, 0.0)).to_vec();
    let allowed = Allowed::new(&part, 0.0);
    assert_eq!(touching(&allowed, &stands, &tool, 0.05), [false, true, true, false, false]);
    let wanted = [true, true, true, true];
    let swept = SweptCutter { stands: &stands, wanted: &wanted, tool: &tool };
    assert_eq!(deeper_than(&allowed, &swept, 0.005), [1]);
    let swept = SweptCutter { wanted: &[true, false, true, true], ..swept };
    assert_eq!(deeper_than(&allowed, &swept, 0.005), [] as [usize; 0]);
    // Stock on the part counts as the part.
    let stock = Allowed::new(&part, 0.5);
    assert_eq!(touching(&stock, &stands, &tool, 0.05), [false, true, true, true, true]);
    let swept = SweptCutter { wanted: &wanted, ..swept };
    let g = measure_within(&stock, &swept, 1e-4, 0.0);
    assert!((g.found_mm - 0.51).abs() < 1e-6, "{g:?}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]
    /// The bound between two places holds beside a dense look, and what is measured is no less than
    /// what is seen there.
    #[test]
    fn nothing_is_missed_between_two_places(
        from in [0.0..40.0f64, 6.0..16.0f64, 0.0..40.0f64], by in [-3.0..3.0f64, -3.0..3.0f64, -3.0..3.0f64],
        lean in -1.0..1.0f64, theta in -1.5..1.5f64, turn in -0.3..0.3f64, tilt in prop_oneof![Just(0.0), -0.2..0.2f64],
    ) {
        let (part, tool) = (&*SLAB, bull());
        let a = Stand::about_blade(from.into(), theta, lean);
        let b = Stand::about_blade(a.centre + Vector::from(by), theta + turn, lean + tilt);
        let wanted = [true];
        let swept = SweptCutter { stands: &[a, b], wanted: &wanted, tool: &tool };
        let mut search = DiscSearch::new(part);
        let mut d = |s: f64| search.closest(&swept.disc(&a.towards(&b, s)), f64::INFINITY, 1e-5).unwrap().distance_mm;
        let (d0, d1, [way, bend]) = (d(0.0), d(1.0), swept.rates(&a, &b));
        let bound = gouge::least_between(d0, d1, (way * way + (d0.min(d1) + 2.0 * way) * bend).sqrt());
        let dense = (0..=30).map(|k| d(f64::from(k) / 30.0)).fold(f64::INFINITY, f64::min);
        prop_assert!(dense >= bound - 1e-4, "{dense} {bound}");
        let g = measure_within(&Allowed::new(part, 0.0), &swept, 1e-3, 0.0);
        prop_assert!(g.bound_mm >= 2.0 - dense - 1e-4, "{g:?} {dense}");
        if dense > 0.05 && dense < 2.0 {
            prop_assert!(g.found_mm >= 2.0 - dense - 1e-3 - 0.02 * g.found_mm, "{g:?} {dense}");
            prop_assert!(g.found_mm <= 2.0 - dense + 0.1, "{g:?} {dense}");
        }
    }
}
