//! T-junctions: open edges cut where open edges of other faces end.

use crate::geometry::Point;
use crate::geometry::brep::{Brep, Coedge, Edge};

use super::curve::{ends, foot, hull, length, slack};
use super::open_edges;

/// Cuts every open edge where another one ends on it; the number of edges that were cut. Cutting is
/// exact: the pieces are ranges of the same curve.
pub fn split_at_ends(brep: &mut Brep, tolerance_mm: f64) -> usize {
    let open = open_edges(brep);
    let mut vertices: Vec<Point> = open.iter().flat_map(|e| ends(&brep.edges[*e])).collect();
    vertices.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)).then(a.z.total_cmp(&b.z)));
    let mut pieces: Vec<Vec<usize>> = vec![Vec::new(); brep.edges.len()];
    let mut cut = 0;
    for &e in &open {
        let at = cuts(&brep.edges[e], &vertices, tolerance_mm);
        if at.is_empty() {
            continue;
        }
        cut += 1;
        let edge = brep.edges[e].clone();
        let mut stops = vec![edge.t[0]];
        stops.extend(at);
        stops.push(edge.t[1]);
        for w in stops.windows(2) {
            pieces[e].push(brep.edges.len());
            brep.edges.push(Edge { curve: edge.curve.clone(), t: [w[0], w[1]] });
        }
    }
    let replaced = |c: &Coedge| -> Vec<Coedge> {
        match pieces.get(c.edge).filter(|p| !p.is_empty()) {
            None => vec![*c],
            Some(p) => {
                let mut out: Vec<Coedge> = p.iter().map(|&edge| Coedge { edge, reversed: c.reversed }).collect();
                if c.reversed {
                    out.reverse();
                }
                out
            }
        }
    };
    for one in brep.faces.iter_mut().flat_map(|f| &mut f.loops) {
        *one = one.iter().flat_map(&replaced).collect();
    }
    cut
}

/// Parameters, increasing, at which an edge passes one of the points away from its own ends.
fn cuts(edge: &Edge, vertices: &[Point], tolerance_mm: f64) -> Vec<f64> {
    let b = hull(edge);
    let off = tolerance_mm + slack(&b);
    let own = ends(edge);
    let from = vertices.partition_point(|v| v.x < b.min.x - off);
    let mut at: Vec<f64> = vertices[from..]
        .iter()
        .take_while(|v| v.x <= b.max.x + off)
        .filter(|v| (1..3).all(|k| v[k] >= b.min[k] - off && v[k] <= b.max[k] + off))
        .filter(|v| own.iter().all(|p| (p - *v).norm() > 2.0 * tolerance_mm))
        .map(|v| foot(&edge.curve, edge.t, v))
        .filter(|(_, distance_mm)| *distance_mm <= tolerance_mm)
        .map(|(t, _)| t)
        .collect();
    at.sort_by(f64::total_cmp);
    // Ends of several edges in one place cut once.
    let mut last = edge.t[0];
    at.retain(|&t| {
        let far = t > last && length(&Edge { curve: edge.curve.clone(), t: [last, t] }) > 2.0 * tolerance_mm;
        if far {
            last = t;
        }
        far
    });
    at.retain(|t| *t < edge.t[1]);
    at
}
