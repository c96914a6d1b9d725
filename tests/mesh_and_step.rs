//! A mesh gives the same path as the NURBS model that it was made of, within the mesh's tolerance.

use bladewright::artifact::region::Extent;
use bladewright::artifact::{Blade, Toolpath};
use bladewright::observe::Silent;
use bladewright::path::{self, PathOptions};
use bladewright::read::model::{self, ModelOptions};

/// What models/*.obj lie off their blades, mm (`accuracy.deflection_mm` of models/steam_root.toml).
const DEFLECTION: f64 = 0.01;

fn planned(file: &str, region: [f64; 2]) -> (Blade, Toolpath) {
    let model = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("models").join(file);
    let blade = model::load(&model, &ModelOptions::default(), &Silent).expect("the model loads");
    let options =
        PathOptions { extent: Extent::heights(Some(region[0]), Some(region[1])), ..PathOptions::new(8.0, 0.01) };
    let path = path::plan(&blade, &options, &Silent).expect("a helix");
    (blade, path)
}

#[test]
fn steam_root() {
    let ((step, exact), (obj, mesh)) =
        (planned("steam_root.step", [30.0, 26.0]), planned("steam_root.obj", [30.0, 26.0]));
    // Both find the same frame, so heights agree.
    let frames = step.model_from_blade.to_homogeneous() - obj.model_from_blade.to_homogeneous();
    assert!(frames.abs().max() < 0.1, "{frames}");
    assert!(
        (exact.turns.len() as i64 - mesh.turns.len() as i64).abs() <= 1,
        "{} {}",
        exact.turns.len(),
        mesh.turns.len()
    );
    let to_step = step.model_from_blade.inverse() * obj.model_from_blade;
    let mut worst: f64 = 0.0;
    for l in &mesh.locations {
        let centre = to_step * l.centre;
        let near = step.part.closest(&centre, f64::INFINITY).expect("a closest point");
        worst = worst.max((near.distance_mm - 8.0).abs());
    }
    // Facets lie off the faces by their deflection at most; so do balls that rest on them, along
    // the normal.
    assert!(worst <= DEFLECTION + 1e-3, "{worst}");
    // Same first turn, from the same base point.
    let (a, b) = (&exact.turns[0], &mesh.turns[0]);
    assert!((a.length_mm - b.length_mm).abs() < 0.1, "{} {}", a.length_mm, b.length_mm);
    let start = (to_step * mesh.locations[0].centre - exact.locations[0].centre).norm();
    assert!(start < 1.0, "the base points are {start} mm apart");
}
