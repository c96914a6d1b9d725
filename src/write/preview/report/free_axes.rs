//! The free tool axes at some locations: maps of the sphere for the page's script.
//!
//! A map is a list of whole numbers that says what the octants of the sphere are, in their order
//! ([`sphere::octants`]): 0 is quartered ([`sphere::quarters`]), and its four quarters follow; 1 is
//! free, 2 not decided, and from 3 on it is taken by what stands at that place, less 3, in the
//! page's list of names.

use std::iter::Peekable;

use serde_json::{Value, json};

use super::ReportInput;
use super::data::rounded;
use super::pack::Pack;
use crate::artifact::channel::Binding;
use crate::artifact::sphere::{self, CellState, FreeSphere, SphereCell};
use crate::error::turn_number;
use crate::geometry::Vector;

const QUARTERED: u32 = 0;
const FREE: u32 = 1;
const OPEN: u32 = 2;
const TAKEN: u32 = 3;
/// Cells are octants quartered so often at most: 0.05° wide.
const MOST_DEPTH: u32 = 11;
/// Digits after the point of the parts of unit vectors, and of angles in radians.
const UNIT: i32 = 5;

/// The section of the page; nothing where all locations have one cone.
pub(super) fn section(input: &ReportInput) -> &'static str {
    let each = input.plan.is_some_and(|p| p.toolpath.cones.same().is_none());
    if each { include_str!("free_axes.html") } else { "" }
}

/// The maps, and which of them is nearest to each of the path's `picked` locations; `null` where
/// there are none.
pub(super) fn data(input: &ReportInput, picked: &[usize], pack: &mut Pack) -> Value {
    let (Some(plan), Some(along)) = (input.plan, input.free_axes) else { return Value::Null };
    let mut names: Vec<(&'static str, String)> = Vec::new();
    let mut maps = Vec::new();
    for (row, sphere) in &along.maps {
        let (location, range) = (plan.toolpath.locations.get(*row), plan.channel.rows.get(*row));
        let (Some(l), Some(range), Some(theta)) = (location, range, plan.schedule.theta.get(*row)) else { continue };
        let cells = tree(sphere, |k| code(input, sphere.bindings.get(k as usize), &mut names));
        let (cone, triple) = (plan.toolpath.cone(*row), |v: &Vector| json!([0, 1, 2].map(|k| rounded(v[k], UNIT))));
        maps.push(json!({
            "s": rounded(l.s_mm, 3), "turn": turn_number(l.turn), "turn_s": rounded(l.turn_s_mm, 3),
            "at": [rounded(l.centre.x, 3), rounded(l.centre.y, 3), rounded(l.centre.z, 3)],
            "normal": triple(&l.normal), "cells": pack.list(0, cells.into_iter().map(f64::from)),
            "axis": triple(&cone.axis), "reference": triple(&cone.reference), "lean": rounded(cone.lean_rad, UNIT),
            "theta": json!([range.theta_min, range.theta_max, *theta].map(|t| rounded(t, UNIT))),
        }));
    }
    if maps.len() != along.maps.len() || maps.is_empty() {
        return Value::Null;
    }
    let nearest = picked.iter().map(|k| along.nearest.get(*k).map_or(f64::NAN, |m| *m as f64));
    json!({ "names": names, "maps": maps, "nearest": pack.list(0, nearest) })
}

/// The number of what takes a cell. Names are added as they come: a kind for the colour, and words.
fn code(input: &ReportInput, by: Option<&Binding>, names: &mut Vec<(&'static str, String)>) -> u32 {
    let of_the_wheel = |name: &str| input.obstacles.iter().any(|o| o.name == name && o.of_the_wheel);
    let name = match by {
        Some(Binding::Part { tool, .. }) => ("blade", format!("{tool} against the part")),
        Some(Binding::Fixture { name, tool, .. }) => {
            (if of_the_wheel(name) { "wheel" } else { "fixture" }, format!("{tool} against {name}"))
        }
        Some(Binding::ContactAngle) => ("contact", "contact angle".to_owned()),
        Some(Binding::AxisLimit) => ("machine", "out of the machine's reach".to_owned()),
        Some(Binding::Travel { axis }) => ("machine", format!("travel of {axis}")),
        Some(Binding::Free) | None => ("other", "not known".to_owned()),
    };
    let k = names.iter().position(|n| *n == name).unwrap_or_else(|| {
        names.push(name);
        names.len() - 1
    });
    TAKEN + k as u32
}

/// A sphere as whole numbers; quarters that are all alike become one. Empty where its cells are no
/// quarters of the octants in order.
fn tree(sphere: &FreeSphere, mut code: impl FnMut(u32) -> u32) -> Vec<u32> {
    let coded = sphere.cells.iter().map(|cell| match cell.state {
        CellState::Free => (cell, FREE),
        CellState::Open => (cell, OPEN),
        CellState::Taken(k) => (cell, code(k)),
    });
    let (mut out, mut left) = (Vec::new(), coded.peekable());
    let whole = sphere::octants().iter().all(|corners| branch(&mut out, corners, MOST_DEPTH, &mut left));
    if whole && left.next().is_none() { out } else { Vec::new() }
}

/// Adds what a triangle is by the cells that are left, and whether they cover it.
fn branch<'a>(
    out: &mut Vec<u32>,
    corners: &[Vector; 3],
    depth: u32,
    left: &mut Peekable<impl Iterator<Item = (&'a SphereCell, u32)>>,
) -> bool {
    if let Some((_, code)) = left.next_if(|(cell, _)| cell.corners == *corners) {
        out.push(code);
        return true;
    }
    if depth == 0 || left.peek().is_none() {
        return false;
    }
    let first = out.len();
    out.push(QUARTERED);
    let whole = sphere::quarters(corners).iter().all(|quarter| branch(out, quarter, depth - 1, left));
    if let [_, a, b, c, d] = out[first..]
        && a != QUARTERED
        && [b, c, d] == [a; 3]
    {
        out.truncate(first);
        out.push(a);
    }
    whole
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What a map says of an axis, read as the page's script reads it.
    fn said(map: &[u32], axis: &Vector) -> u32 {
        fn of(map: &mut std::slice::Iter<u32>, corners: &[Vector; 3], axis: &Vector) -> Option<u32> {
            let code = *map.next().expect("a cell");
            if code != QUARTERED {
                return SphereCell { corners: *corners, state: CellState::Free }.holds(axis).then_some(code);
            }
            sphere::quarters(corners).iter().map(|q| of(map, q, axis)).fold(None, Option::or)
        }
        let mut left = map.iter();
        let found = sphere::octants().iter().map(|o| of(&mut left, o, axis)).fold(None, Option::or);
        assert!(left.next().is_none());
        found.expect("a cell that holds it")
    }

    fn cells(depth: u32, corners: [Vector; 3], state: &dyn Fn(&Vector) -> CellState) -> Vec<SphereCell> {
        let middle = (corners[0] + corners[1] + corners[2]).normalize();
        let same = corners.iter().all(|c| state(c) == state(&middle));
        if depth == 0 || (same && depth < 4) {
            return vec![SphereCell { corners, state: state(&middle) }];
        }
        sphere::quarters(&corners).into_iter().flat_map(|q| cells(depth - 1, q, state)).collect()
    }

    #[test]
    fn a_map_says_of_every_axis_what_the_sphere_says() {
        let state = |a: &Vector| match (a.dot(&Vector::new(0.6, 0.8, 0.0)), a.z) {
            (c, _) if c > 0.5 => CellState::Free,
            (c, _) if c > 0.4 => CellState::Open,
            (_, z) => CellState::Taken(u32::from(z > 0.0)),
        };
        let all: Vec<SphereCell> = sphere::octants().into_iter().flat_map(|o| cells(6, o, &state)).collect();
        let sphere = FreeSphere { cells: all, bindings: vec![Binding::ContactAngle, Binding::AxisLimit] };
        let map = tree(&sphere, |k| TAKEN + k);
        assert!(map.len() < sphere.cells.len(), "{} of {}", map.len(), sphere.cells.len());
        for k in 0..400 {
            let (z, round) = (1.0 - (2.0 * f64::from(k) + 1.0) / 400.0, 2.399_963 * f64::from(k));
            let across = (1.0f64 - z * z).sqrt();
            let axis = Vector::new(across * round.cos(), across * round.sin(), z);
            let want = match sphere.cell_at(&axis).expect("a cell").state {
                CellState::Free => FREE,
                CellState::Open => OPEN,
                CellState::Taken(k) => TAKEN + k,
            };
            assert_eq!(said(&map, &axis), want, "{axis:?}");
        }
    }

    #[test]
    fn cells_that_cover_no_sphere_make_no_map() {
        let octants = sphere::octants().map(|corners| SphereCell { corners, state: CellState::Free });
        let sphere = |cells: &[SphereCell]| FreeSphere { cells: cells.to_vec(), bindings: Vec::new() };
        assert_eq!(tree(&sphere(&octants), |_| TAKEN), [FREE; 8]);
        assert!(tree(&sphere(&octants[..7]), |_| TAKEN).is_empty());
        assert!(tree(&sphere(&octants[1..]), |_| TAKEN).is_empty());
        assert!(tree(&sphere(&[&octants[..], &octants[..1]].concat()), |_| TAKEN).is_empty());
        assert!(tree(&FreeSphere::default(), |_| TAKEN).is_empty());
    }
}
