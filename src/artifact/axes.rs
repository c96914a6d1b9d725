//! One value for each axis of a machine.

use std::ops::{Deref, DerefMut, Index, IndexMut, Range};

use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::packed;

/// Most axes of a machine: the workpiece's rotary axis, and two heads of X, Y, Z and one rotary
/// axis each.
pub const MOST_AXES: usize = 9;

/// One value for each axis of a machine, in the order of `Machine::axes`: positions in mm or rad,
/// unless said otherwise. In files a plain list.
#[derive(Clone, Copy)]
pub struct Axes<T = f64> {
    /// Those behind `count` are padding.
    values: [T; MOST_AXES],
    count: usize,
}

impl<T: Copy + Default> Axes<T> {
    /// As many values as a machine has axes, each from its place. More than [`MOST_AXES`] are left
    /// out.
    pub fn from_fn(count: usize, mut value: impl FnMut(usize) -> T) -> Self {
        let mut out = Self::of_default(count);
        for (k, v) in out.iter_mut().enumerate() {
            *v = value(k);
        }
        out
    }

    /// The default value for each of so many axes.
    pub fn of_default(count: usize) -> Self {
        Axes { values: [T::default(); MOST_AXES], count: count.min(MOST_AXES) }
    }

    /// Another value from each.
    #[must_use]
    pub fn map<U: Copy + Default>(&self, mut value: impl FnMut(T) -> U) -> Axes<U> {
        Axes::from_fn(self.count, |k| value(self.values[k]))
    }
}

impl Axes {
    /// The place at a share of the straight way to another, every axis evenly.
    #[must_use]
    pub fn toward(&self, to: &Axes, share: f64) -> Axes {
        Axes::from_fn(self.count, |k| self.values[k] + (to.values[k] - self.values[k]) * share)
    }
}

impl<T> Deref for Axes<T> {
    type Target = [T];
    #[inline]
    fn deref(&self) -> &[T] {
        &self.values[..self.count]
    }
}

impl<T> DerefMut for Axes<T> {
    #[inline]
    fn deref_mut(&mut self) -> &mut [T] {
        &mut self.values[..self.count]
    }
}

impl<T: Copy + Default> Default for Axes<T> {
    /// Of no axis.
    fn default() -> Self {
        Self::of_default(0)
    }
}

impl<T: Copy + Default, const N: usize> From<[T; N]> for Axes<T> {
    fn from(values: [T; N]) -> Self {
        Axes::from_fn(N, |k| values[k])
    }
}

impl From<&[f64]> for Axes {
    fn from(values: &[f64]) -> Self {
        Axes::from_fn(values.len(), |k| values[k])
    }
}

impl<T: PartialEq> PartialEq for Axes<T> {
    fn eq(&self, other: &Self) -> bool {
        **self == **other
    }
}

impl<T: std::fmt::Debug> std::fmt::Debug for Axes<T> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        (**self).fmt(f)
    }
}

impl<T: Serialize> Serialize for Axes<T> {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        (**self).serialize(to)
    }
}

impl<'a, T: Copy + Default + Deserialize<'a>> Deserialize<'a> for Axes<T> {
    fn deserialize<D: Deserializer<'a>>(from: D) -> Result<Self, D::Error> {
        let values = Vec::<T>::deserialize(from)?;
        if values.len() > MOST_AXES {
            return Err(D::Error::custom(format!("{} axes, there are at most {MOST_AXES}", values.len())));
        }
        Ok(Axes::from_fn(values.len(), |k| values[k]))
    }
}

/// Rows of one value for each axis of a machine, all of the same length.
#[derive(Clone, Default, PartialEq)]
pub struct AxisRows {
    /// Row by row.
    values: Vec<f64>,
    /// Columns; 0 only while there is no row.
    axes: usize,
}

impl AxisRows {
    /// No row yet, with room for so many.
    pub fn with_capacity(axes: usize, rows: usize) -> Self {
        AxisRows { values: Vec::with_capacity(axes * rows), axes }
    }

    /// Of values row by row, so many in each. What is left of an incomplete row is dropped.
    pub fn from_values(axes: usize, mut values: Vec<f64>) -> Self {
        values.truncate(values.len().checked_div(axes).unwrap_or(0) * axes);
        AxisRows { values, axes }
    }

    /// Columns; 0 where there is no row.
    pub fn axes(&self) -> usize {
        self.axes
    }

    /// All values, row by row.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.values.len().checked_div(self.axes).unwrap_or(0)
    }

    /// There is no row.
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// Adds a row. The first row says how many columns there are; of a later one that is longer the
    /// rest is dropped, what a shorter one lacks is not a number.
    pub fn push(&mut self, row: &[f64]) {
        if self.values.is_empty() {
            self.axes = row.len();
        }
        if row.len() == self.axes {
            return self.values.extend_from_slice(row);
        }
        self.values.extend((0..self.axes).map(|k| row.get(k).copied().unwrap_or(f64::NAN)));
    }

    /// A row; `None` where there is none.
    pub fn get(&self, row: usize) -> Option<&[f64]> {
        (row < self.len()).then(|| &self[row])
    }

    /// All rows.
    pub fn iter(&self) -> std::slice::ChunksExact<'_, f64> {
        self.values.chunks_exact(self.axes.max(1))
    }

    /// All rows, to be changed.
    pub fn iter_mut(&mut self) -> std::slice::ChunksExactMut<'_, f64> {
        self.values.chunks_exact_mut(self.axes.max(1))
    }

    /// Some of the rows; none where one of them is missing.
    #[must_use]
    pub fn part(&self, rows: Range<usize>) -> Self {
        let values = self.values.get(rows.start * self.axes..rows.end * self.axes).unwrap_or_default();
        AxisRows { values: values.to_vec(), axes: self.axes }
    }
}

impl Index<usize> for AxisRows {
    type Output = [f64];
    #[inline]
    fn index(&self, row: usize) -> &[f64] {
        &self.values[row * self.axes..(row + 1) * self.axes]
    }
}

impl IndexMut<usize> for AxisRows {
    #[inline]
    fn index_mut(&mut self, row: usize) -> &mut [f64] {
        &mut self.values[row * self.axes..(row + 1) * self.axes]
    }
}

impl<'a> IntoIterator for &'a AxisRows {
    type Item = &'a [f64];
    type IntoIter = std::slice::ChunksExact<'a, f64>;
    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl<R: AsRef<[f64]>> Extend<R> for AxisRows {
    fn extend<I: IntoIterator<Item = R>>(&mut self, rows: I) {
        rows.into_iter().for_each(|row| self.push(row.as_ref()));
    }
}

impl<R: AsRef<[f64]>> FromIterator<R> for AxisRows {
    fn from_iter<I: IntoIterator<Item = R>>(rows: I) -> Self {
        let mut out = AxisRows::default();
        out.extend(rows);
        out
    }
}

impl AsRef<[f64]> for Axes {
    fn as_ref(&self) -> &[f64] {
        self
    }
}

impl std::fmt::Debug for AxisRows {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_list().entries(self.iter()).finish()
    }
}

/// In files: the number of columns, and the values row by row.
#[derive(Serialize, Deserialize)]
struct Packed {
    axes: usize,
    f64le: String,
}

impl Serialize for AxisRows {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        Packed { axes: self.axes, f64le: packed::text(&self.values) }.serialize(to)
    }
}

impl<'a> Deserialize<'a> for AxisRows {
    fn deserialize<D: Deserializer<'a>>(from: D) -> Result<Self, D::Error> {
        let Packed { axes, f64le } = Packed::deserialize(from)?;
        let values = packed::values(&f64le).map_err(D::Error::custom)?;
        if axes > MOST_AXES || values.len().checked_rem(axes).unwrap_or(values.len()) != 0 {
            let found = format!("{} values are no whole rows of {axes} axes, at most {MOST_AXES}", values.len());
            return Err(D::Error::custom(found));
        }
        Ok(AxisRows { axes: if values.is_empty() { 0 } else { axes }, values })
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn a_row_is_a_plain_list_in_files() {
        let row = Axes::from([1.0, -2.5, 0.125, 4.0]);
        let text = serde_json::to_string(&row).unwrap();
        assert_eq!(text, "[1.0,-2.5,0.125,4.0]");
        assert_eq!(serde_json::from_str::<Axes>(&text).unwrap(), row);
        let long = serde_json::to_string(&[0.0; MOST_AXES + 1]).unwrap();
        assert!(serde_json::from_str::<Axes>(&long).unwrap_err().to_string().contains("at most 9"));
    }

    #[test]
    fn rows_are_all_of_one_length_and_come_back_from_files() {
        let rows: AxisRows = [[1.0, 2.0], [3.0, 4.5], [5.0, 0.1]].into_iter().collect();
        assert_eq!((rows.len(), &rows[1], rows.get(3)), (3, [3.0, 4.5].as_slice(), None));
        assert_eq!(rows.part(1..3), [[3.0, 4.5], [5.0, 0.1]].into_iter().collect());
        assert!(rows.part(2..4).is_empty() && AxisRows::default().iter().next().is_none());
        let text = serde_json::to_string(&rows).unwrap();
        assert_eq!(serde_json::from_str::<AxisRows>(&text).unwrap(), rows);
        let none = serde_json::to_string(&AxisRows::default()).unwrap();
        assert_eq!(serde_json::from_str::<AxisRows>(&none).unwrap(), AxisRows::default());
        for axes in ["4", "0", "12"] {
            let other = text.replace("\"axes\":2", &format!("\"axes\":{axes}"));
            assert!(
                serde_json::from_str::<AxisRows>(&other).unwrap_err().to_string().contains("no whole rows"),
                "{axes}"
            );
        }
    }

    #[test]
    fn rows_of_other_lengths_differ() {
        assert_ne!(Axes::from([1.0, 0.0]), Axes::from([1.0]));
        assert_eq!(Axes::from([1.0, 3.0]).toward(&Axes::from([2.0, 5.0]), 0.5), Axes::from([1.5, 4.0]));
        assert_eq!(Axes::from([1.0, 3.0]).map(|v| v > 2.0), Axes::from([false, true]));
    }
}
