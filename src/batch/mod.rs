//! Families of blades: many jobs from one file, on all cores, resumable, in shards.
//!
//! In: a [`Family`] (a family file worked out into members) and a place for results. Out: a folder
//! for every member with the files of a run, and tables, a Parquet file and a page over all of
//! them.
//!
//! ```text
//! family file -> FamilyFile -> Family -> addresses -> what is left to do -> members, side by side -> records -> tables, page
//! ```
//!
//! Guaranteed:
//! * **The same family leaves the same bytes**, on any number of threads, in any number of shards,
//!   however often it was killed and started again, whichever stages were taken over from earlier
//!   runs. `log/` alone, with times, memory and locks, is different every time.
//! * **Nothing is half-written**: a member's folder appears in one step, whole ([`store`](self)).
//! * **Nothing is computed twice**: a member is known by the hash of what it is computed from
//!   (`address.rs`); stages whose inputs have not changed are taken over ([`crate::run::reuse`]).
//! * **A member that fails harms no other**: its stage and reason stand in the tables. What stops
//!   everything is only what would stop every member: a full disk, an unwritable folder, Ctrl-C.
//!
//! Limits: memory is shared out by an estimate from the model's size and the scallop, not measured.
//! Programs built from the same sources are taken for the same, whatever machine they were built
//! for.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::Mutex;

mod address;
mod columns;
mod crew;
mod design;
pub mod file;
mod member;
mod members;
mod memory;
mod models;
#[cfg(feature = "s3")]
mod objects;
mod page;
mod picture;
mod place;
mod record;
mod shard;
mod store;
mod table;
mod tables;
#[cfg(test)]
mod tests;
mod worker;

pub use file::{FamilyFile, schema};
pub use member::{BladeSource, Member};
pub use members::Family;
pub use picture::Picture;
pub use record::{Record, Status};
pub use shard::Shard;
pub use worker::Effort;

use crate::error::{Error, ErrorKind, Result, Stage};
use crate::observe::{Observer, Silent};
use crate::parallel;
use address::{Address, Contents, Estimate};
use crew::{Means, Task};
use store::{RECORD, Store};
use worker::Work;

/// How to work on a family.
#[derive(Clone, Copy, Debug)]
pub struct BatchOptions {
    /// Threads; 0: as many as the current rayon pool has.
    pub threads: usize,
    /// Memory to share out, MiB; `None`: 80 % of what is available.
    pub memory_mib: Option<u64>,
    /// The part to work on.
    pub shard: Shard,
    /// Work on members that failed before, and on no others.
    pub retry: bool,
}

impl Default for BatchOptions {
    fn default() -> Self {
        BatchOptions { threads: 0, memory_mib: None, shard: Shard::ALL, retry: false }
    }
}

/// Receives a family's progress while it is worked on. All methods may be called from any thread.
pub trait Watch: Sync {
    /// Work begins: so many members are to be computed, so many are kept.
    fn begins(&self, _to_do: usize, _kept: usize) {}
    /// A member begins; its stages speak to the observer returned.
    fn member(&self, _name: &str) -> Box<dyn Observer + '_> {
        Box::new(Silent)
    }
    /// A member has ended.
    fn ended(&self, _record: &Record, _effort: &Effort) {}
    /// True when the user has asked to stop.
    fn cancelled(&self) -> bool {
        false
    }
}

impl Watch for Silent {}

/// What became of a family.
#[derive(Clone, Debug)]
pub struct Done {
    /// Members of this part, in the order of the family; those that were not reached are `Missing`.
    pub records: Vec<Record>,
    /// Number of members computed now.
    pub computed: usize,
    /// The user asked to stop.
    pub cancelled: bool,
    /// Tables and page, relative to the place of results; none where only a part of the family was
    /// worked on.
    pub files: Vec<String>,
}

impl Done {
    /// The worst exit code of all members: 130 where it was cancelled, 4 where a member is missing.
    pub fn exit_code(&self) -> u8 {
        if self.cancelled {
            return ErrorKind::Cancelled.exit_code();
        }
        let code = |r: &Record| match r.status {
            Status::Missing => ErrorKind::InputOutput.exit_code(),
            _ => r.exit_code,
        };
        self.records.iter().map(code).max().unwrap_or(0)
    }
}

/// Works on a family, or on a part of it, and writes tables and page where it is the whole.
///
/// # Errors
/// Those that are no member's: results that cannot be written, an output folder that holds the
/// models, another process at work on the same part. What is done is kept.
pub fn run(family: &Family, out: &str, options: &BatchOptions, watch: &dyn Watch) -> Result<Done> {
    let plan = BatchPlan::new(family, options.shard)?;
    let store = place::open(out, family, &options.shard.label())?;
    let known = plan.known(&*store)?;
    let to_do: Vec<usize> =
        parallel::filter(plan.mine.iter().copied(), |k| plan.is_due(*k, known.get(k), options, &*store));
    watch.begins(to_do.len(), plan.mine.len() - to_do.len());
    let made = Mutex::new(BTreeMap::new());
    let work = |k: usize, threads: usize| {
        let (member, address) = (&family.members[k], &plan.addresses[&k]);
        let helper = plan.leader(k).filter(|l| *l != k).map(|l| family.members[l].name.as_str());
        let observer = Stoppable { inner: watch.member(&member.name), watch };
        let work = Work { store: &*store, member, key: &address.key, old: known.get(&k), helper, threads };
        let (record, effort) = match worker::compute(&work, &observer) {
            Err(e) if e.kind == ErrorKind::Cancelled => return store.sweep(&member.name),
            other => other?,
        };
        watch.ended(&record, &effort);
        made.lock().unwrap_or_else(std::sync::PoisonError::into_inner).insert(k, record);
        Ok(())
    };
    crew::run(plan.tasks(&to_do), plan.means(options), &|| watch.cancelled(), &work)?;
    let made = made.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
    let computed = made.len();
    let records: Vec<Record> = plan.mine.iter().map(|k| plan.current(*k, made.get(k).or(known.get(k)))).collect();
    for r in &records {
        store.sweep(&r.name)?;
    }
    let files = if options.shard.is_all() { write(family, &records, &*store)? } else { Vec::new() };
    Ok(Done { records, computed, cancelled: watch.cancelled() && computed < to_do.len(), files })
}

/// Tables and page of a family whose members were worked on in parts, wherever that was.
///
/// # Errors
/// Results that cannot be read or written.
pub fn merge(family: &Family, out: &str) -> Result<Done> {
    let plan = BatchPlan::new(family, Shard::ALL)?;
    let store = place::open(out, family, "merge")?;
    let known = plan.known(&*store)?;
    let records: Vec<Record> = plan.mine.iter().map(|k| plan.current(*k, known.get(k))).collect();
    let files = write(family, &records, &*store)?;
    Ok(Done { records, computed: 0, cancelled: false, files })
}

/// A member of a family before it is computed, for looking at a family.
#[derive(Clone, Debug)]
pub struct Listed {
    /// Its name.
    pub name: String,
    /// Likely effort, in an arbitrary unit.
    pub cost: f64,
    /// Likely memory, MiB.
    pub memory_mib: u64,
}

/// Members of a part, with what they are likely to cost.
///
/// # Errors
/// A job that cannot be written.
pub fn list(family: &Family, shard: Shard) -> Result<Vec<Listed>> {
    let plan = BatchPlan::new(family, shard)?;
    let row = |k: &usize| {
        let e = plan.estimates[*k];
        Listed { name: family.members[*k].name.clone(), cost: e.cost, memory_mib: e.memory_mib }
    };
    Ok(plan.mine.iter().map(row).collect())
}

/// Which members are to be planned. Members are known by their number in the family.
struct BatchPlan<'a> {
    family: &'a Family,
    /// Members of this part.
    mine: Vec<usize>,
    addresses: BTreeMap<usize, Address>,
    estimates: Vec<Estimate>,
    /// The first of this part's members that share path and channel, by what they share.
    leaders: BTreeMap<String, usize>,
}

impl<'a> BatchPlan<'a> {
    fn new(family: &'a Family, shard: Shard) -> Result<Self> {
        let contents = Contents::default();
        let estimates: Vec<Estimate> = family.members.iter().map(|m| address::estimate(m, &contents)).collect();
        let mine = shard.pick(&estimates.iter().map(|e| e.cost).collect::<Vec<_>>());
        let (mut addresses, mut leaders) = (BTreeMap::new(), BTreeMap::new());
        for k in &mine {
            let address = address::address(&family.members[*k], &contents)?;
            leaders.entry(address.group.clone()).or_insert(*k);
            addresses.insert(*k, address);
        }
        Ok(BatchPlan { family, mine, addresses, estimates, leaders })
    }

    fn leader(&self, k: usize) -> Option<usize> {
        self.leaders.get(&self.addresses.get(&k)?.group).copied()
    }

    /// Records of members as they are, whole ones that were not taken in before a kill included.
    fn known(&self, store: &dyn Store) -> Result<BTreeMap<usize, Record>> {
        let mut known = BTreeMap::new();
        for k in &self.mine {
            let name = &self.family.members[*k].name;
            let text = store.read(&format!("members/{name}/{RECORD}"))?;
            let mut record: Option<Record> = text.and_then(|t| serde_json::from_slice(&t).ok());
            if let Some(left) = store.left_over(name).filter(|r| self.addresses.get(k).is_some_and(|a| a.key == r.key))
            {
                store.take_in(&left, record.as_ref())?;
                record = Some(left);
            }
            store.sweep(name)?;
            if let Some(record) = record {
                known.insert(*k, record);
            }
        }
        Ok(known)
    }

    fn fits(&self, k: usize, record: &Record) -> bool {
        self.addresses.get(&k).is_some_and(|a| a.key == record.key)
    }

    fn is_due(&self, k: usize, record: Option<&Record>, options: &BatchOptions, store: &dyn Store) -> bool {
        match record {
            Some(r) if options.retry => r.status == Status::Failed,
            None if options.retry => false,
            Some(r) => !self.fits(k, r) || !store.whole(r),
            None => true,
        }
    }

    /// The record where it is of these inputs. What tells members apart, and where a model lies,
    /// may have been put in other words.
    fn current(&self, k: usize, record: Option<&Record>) -> Record {
        let member = &self.family.members[k];
        let model = worker::model_name(&member.source);
        match record.filter(|r| self.fits(k, r)) {
            Some(r) => Record { parameters: member.parameters.clone(), ..r.clone() },
            None => Record::missing(&member.name, &model, &member.parameters),
        }
    }

    fn tasks(&self, to_do: &[usize]) -> Vec<Task> {
        let due: BTreeSet<usize> = to_do.iter().copied().collect();
        let task = |k: &usize| Task {
            id: *k,
            cost: self.estimates[*k].cost,
            memory_mib: self.estimates[*k].memory_mib,
            after: self.leader(*k).filter(|l| l != k && due.contains(l)),
        };
        to_do.iter().map(task).collect()
    }

    fn means(&self, options: &BatchOptions) -> Means {
        let threads = if options.threads == 0 { rayon::current_num_threads() } else { options.threads };
        Means { threads, memory_mib: options.memory_mib.unwrap_or_else(memory::to_share) }
    }
}

/// A member's observer that stops when the family is to stop.
struct Stoppable<'a> {
    inner: Box<dyn Observer + 'a>,
    watch: &'a dyn Watch,
}

impl Observer for Stoppable<'_> {
    fn progress(&self, stage: Stage, done: usize, total: usize) {
        self.inner.progress(stage, done, total);
    }
    fn warn(&self, warning: crate::observe::Warning) {
        self.inner.warn(warning);
    }
    fn cancelled(&self) -> bool {
        self.watch.cancelled() || self.inner.cancelled()
    }
}

fn write(family: &Family, records: &[Record], store: &dyn Store) -> Result<Vec<String>> {
    let columns = columns::columns(records);
    let files = [
        ("family.csv", tables::csv(&columns)?),
        ("family.parquet", tables::parquet(&columns)?),
        ("family.html", page::html(&family.name, records, &columns)?.into_bytes()),
    ];
    for (name, content) in &files {
        store.write(name, content)?;
    }
    store.write("log/times.csv", &worker::times(records, store)?)?;
    Ok(files.iter().map(|f| f.0.to_owned()).collect())
}

/// The output folder must not hold the models: results would become members.
fn check_apart(out: &Path, family: &Family) -> Result<()> {
    let Ok(out) = std::fs::canonicalize(out) else { return Ok(()) };
    for m in &family.members {
        let BladeSource::Model(path) = &m.source else { continue };
        if std::fs::canonicalize(path).is_ok_and(|p| p.starts_with(&out)) {
            let what = format!(
                "{} lies in the folder of the results, {}: the family would feed on itself",
                path.display(),
                out.display()
            );
            return Err(Error::usage(Stage::Batch, what).advise("give another folder with -o"));
        }
    }
    Ok(())
}
