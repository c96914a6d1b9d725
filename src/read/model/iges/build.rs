//! The B-rep as it grows: its faces and edges, those of the body under way, and how much the file
//! may make of itself.

use std::collections::BTreeMap;

use super::file::{Entity, File};
use super::surfaces::Carrier;
use crate::error::Result;
use crate::geometry::brep::{Brep, Coedge, Edge, Face, FaceName};
use crate::geometry::nurbs::NurbsSurface;

/// The B-rep as it grows.
pub struct Build<'f> {
    /// The file.
    pub file: &'f File<'f>,
    /// What has been built, mm.
    pub brep: Brep,
    /// Solids, shells placed, and one for all loose faces.
    pub bodies: usize,
    poles_left: usize,
    /// Edges of the body under way, by list and index.
    known: BTreeMap<(usize, i64), usize>,
}

impl<'f> Build<'f> {
    /// Nothing yet.
    pub fn new(file: &'f File<'f>) -> Self {
        let poles_left = file.most_poles();
        Build { file, brep: Brep::default(), bodies: 0, poles_left, known: BTreeMap::new() }
    }

    /// Adds edges; the index of the first.
    ///
    /// # Errors
    /// A curve that cannot be evaluated; more control points than a file of this size can need.
    pub fn push_edges(&mut self, owner: &Entity, edges: Vec<Edge>) -> Result<usize> {
        let base = self.brep.edges.len();
        for e in edges {
            e.curve.validate().map_err(|m| self.file.error(owner, format!("has a broken edge: {}", m.message)))?;
            self.spend(owner, e.curve.points.len())?;
            self.brep.edges.push(e);
        }
        Ok(base)
    }

    /// Adds a face.
    ///
    /// # Errors
    /// More control points than a file of this size can need.
    pub fn push_face(
        &mut self,
        e: &Entity,
        c: &Carrier,
        surface: NurbsSurface,
        loops: Vec<Vec<Coedge>>,
        reversed: bool,
    ) -> Result<()> {
        self.spend(e, surface.points.len())?;
        let name = FaceName::Listed(self.brep.faces.len() + 1, e.line);
        self.brep.faces.push(Face { name, kind: c.kind, surface, reversed, loops });
        Ok(())
    }

    fn spend(&mut self, e: &Entity, poles: usize) -> Result<()> {
        self.poles_left = self
            .poles_left
            .checked_sub(poles)
            .ok_or_else(|| self.file.error(e, "makes more of the file than a model of its size can need"))?;
        Ok(())
    }

    /// Begins a body: it shares no edges with those before.
    pub fn begin_body(&mut self) {
        self.known.clear();
    }

    /// Edges so far.
    pub fn edges(&self) -> &[Edge] {
        &self.brep.edges
    }

    /// The edge of a list in the body under way.
    pub fn known_edge(&self, list: usize, index: i64) -> Option<usize> {
        self.known.get(&(list, index)).copied()
    }

    /// Keeps the edge of a list for the body under way.
    pub fn remember_edge(&mut self, list: usize, index: i64, edge: usize) {
        self.known.insert((list, index), edge);
    }
}
