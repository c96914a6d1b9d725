//! A family in parts that know nothing of one another.

use crate::error::{Error, Result, Stage};

/// Part `index` of `count`, from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    index: usize,
    count: usize,
}

impl Shard {
    /// The whole family.
    pub const ALL: Shard = Shard { index: 1, count: 1 };

    /// A part.
    ///
    /// # Errors
    /// `Usage` where there is no such part.
    pub fn new(index: usize, count: usize) -> Result<Self> {
        if (1..=count).contains(&index) && count <= 100_000 {
            return Ok(Shard { index, count });
        }
        Err(Error::usage(Stage::Batch, format!("there is no shard {index} of {count}"))
            .advise("count from 1, as in 1/4"))
    }

    /// Whether this is the whole family.
    pub fn is_all(self) -> bool {
        self.count == 1
    }

    /// As in the names of locks.
    pub(super) fn label(self) -> String {
        if self.is_all() { "all".into() } else { format!("shard-{}-of-{}", self.index, self.count) }
    }

    /// Numbers of the members of this part. The costliest first, each goes to the part with least
    /// cost so far (the first of several): every process comes to the same division, and no part
    /// costs more than 4/3 of the best division plus one member.
    pub(super) fn pick(self, costs: &[f64]) -> Vec<usize> {
        let mut order: Vec<usize> = (0..costs.len()).collect();
        order.sort_by(|a, b| costs[*b].total_cmp(&costs[*a]).then(a.cmp(b)));
        let mut loads = vec![0.0f64; self.count];
        let mut mine = Vec::new();
        for k in order {
            let least = (0..loads.len()).min_by(|a, b| loads[*a].total_cmp(&loads[*b])).unwrap_or(0);
            loads[least] += costs[k];
            if least + 1 == self.index {
                mine.push(k);
            }
        }
        mine.sort_unstable();
        mine
    }
}

impl std::str::FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> std::result::Result<Self, String> {
        let parts = text.split_once('/').and_then(|(i, n)| Some((i.trim().parse().ok()?, n.trim().parse().ok()?)));
        let (index, count) = parts.ok_or("give part and count, as in 1/4")?;
        Shard::new(index, count).map_err(|e| format!("{}; count from 1, as in 1/4", e.message))
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn shards_divide_a_family(costs in proptest::collection::vec(0.1f64..10.0, 0..60), count in 1usize..9) {
            let parts: Vec<Vec<usize>> = (1..=count).map(|i| Shard::new(i, count).unwrap().pick(&costs)).collect();
            let mut all: Vec<usize> = parts.concat();
            all.sort_unstable();
            prop_assert_eq!(all, (0..costs.len()).collect::<Vec<_>>());
            let load = |p: &Vec<usize>| p.iter().map(|k| costs[*k]).sum::<f64>();
            let (total, greatest) = (costs.iter().sum::<f64>(), costs.iter().copied().fold(0.0, f64::max));
            for p in &parts {
                prop_assert!(load(p) <= total / count as f64 + greatest + 1e-9);
            }
        }
    }

    #[test]
    fn shards_as_typed() {
        assert_eq!("2/4".parse::<Shard>().unwrap(), Shard::new(2, 4).unwrap());
        for bad in ["0/4", "5/4", "1", "a/b", "1/0", "-1/2", ""] {
            assert!(bad.parse::<Shard>().is_err(), "{bad}");
        }
    }
}
