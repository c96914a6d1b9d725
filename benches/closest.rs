//! Closest points a second, on one thread, beside parry's query to the triangles of the same part.
//!
//! `cargo bench --bench closest [-- model.step ...]`; without models those of the folder `models`;
//! MODEL@m is one in metres whatever it says. The points are spread evenly over the part's box,
//! enlarged by a fifth; and once more beside the part, within a hundredth of its size.
use std::path::{Path, PathBuf};
use std::time::Instant;

use bladewright::artifact::blade::Unit;
use bladewright::geometry::part::Part;
use bladewright::geometry::{Aabb, Point, Vector};
use bladewright::observe::Silent;
use bladewright::read::model::{self, ModelOptions};
use parry3d_f64::math::Vector as ParryVector;
use parry3d_f64::query::PointQuery;
use parry3d_f64::shape::TriMesh;

const POINTS: usize = 20_000;
const ROUNDS: usize = 5;

/// Numbers in 0..1 in a fixed order.
struct Spread(u64);

impl Spread {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}

fn everywhere(b: &Aabb) -> Vec<Point> {
    let mut s = Spread(1);
    let (middle, size) = (nalgebra::center(&b.min, &b.max), (b.max - b.min) * 1.2);
    (0..POINTS).map(|_| middle + Vector::from_fn(|k, _| size[k] * (s.next() - 0.5))).collect()
}

fn beside(part: &Part, b: &Aabb) -> Vec<Point> {
    let mut s = Spread(2);
    let off = 0.01 * b.diagonal_mm();
    let pick = |x: f64| ((x * part.mesh.triangles.len() as f64) as usize).min(part.mesh.triangles.len() - 1);
    (0..POINTS)
        .map(|_| {
            let t = pick(s.next());
            let [a, b, c] = part.mesh.corners(t);
            let (u, v) = (s.next(), s.next());
            let (u, v) = if u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
            a + (b - a) * u + (c - a) * v + part.mesh.normal(t) * (off * (2.0 * s.next() - 1.0))
        })
        .collect()
}

/// Time that this thread has spent computing, where the system tells, else wall time, s: other
/// programs must not count.
fn now(start: &Instant) -> f64 {
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let ns = told.as_deref().and_then(|t| t.split_whitespace().next()).and_then(|w| w.parse::<f64>().ok());
    ns.map_or_else(|| start.elapsed().as_secs_f64(), |n| n * 1e-9)
}

/// Queries a second: the best round of several, and a sum that keeps the work from being left out.
fn rate(points: &[Point], query: impl Fn(&Point) -> f64) -> f64 {
    let mut best = f64::INFINITY;
    let mut sum = 0.0;
    let start = Instant::now();
    for _ in 0..ROUNDS {
        let from = now(&start);
        sum += points.iter().map(&query).sum::<f64>();
        best = best.min(now(&start) - from);
    }
    assert!(sum.is_finite());
    points.len() as f64 / best
}

fn main() {
    let mut models: Vec<PathBuf> =
        std::env::args().skip(1).filter(|a| !a.starts_with("--")).map(PathBuf::from).collect();
    if models.is_empty() {
        let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("models");
        let names = ["steam_root", "compressor_twist", "turbine_camber", "prism"];
        models = names.iter().map(|n| folder.join(n).with_extension("step")).collect();
    }
    let mut out = String::from("model                           points      exact/s   parry mesh/s   ratio\n");
    for path in models {
        let name = path.file_stem().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
        let text = path.to_string_lossy();
        let (path, unit) = text.strip_suffix("@m").map_or((&*path, None), |p| (Path::new(p), Some(Unit::M)));
        let blade = match model::load(path, &ModelOptions { unit, ..ModelOptions::default() }, &Silent) {
            Ok(b) => b,
            Err(e) => {
                out += &format!("{name}: {}\n", e.message);
                continue;
            }
        };
        let part = &blade.part;
        let Some(b) = part.mesh.aabb() else { continue };
        let vertices = part.mesh.points.iter().map(|p| ParryVector::new(p.x, p.y, p.z)).collect();
        let Ok(mesh) = TriMesh::new(vertices, part.mesh.triangles.clone()) else { continue };
        for (what, points) in [("everywhere", everywhere(&b)), ("beside", beside(part, &b))] {
            let exact = rate(&points, |q| part.closest(q, f64::INFINITY).map_or(0.0, |c| c.distance_mm));
            let parry = rate(&points, |q| {
                let q = ParryVector::new(q.x, q.y, q.z);
                (mesh.project_local_point(q, false).point - q).length()
            });
            out += &format!("{name:30} {what:11} {exact:9.0} {parry:14.0} {:7.2}\n", exact / parry);
        }
    }
    use std::io::Write;
    let _ = std::io::stdout().write_all(out.as_bytes());
}
