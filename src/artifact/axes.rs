//! One value for each axis of a machine.

use std::ops::{Deref, DerefMut};

use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

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
    fn rows_of_other_lengths_differ() {
        assert_ne!(Axes::from([1.0, 0.0]), Axes::from([1.0]));
        assert_eq!(Axes::from([1.0, 3.0]).toward(&Axes::from([2.0, 5.0]), 0.5), Axes::from([1.5, 4.0]));
        assert_eq!(Axes::from([1.0, 3.0]).map(|v| v > 2.0), Axes::from([false, true]));
    }
}
