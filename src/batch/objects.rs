//! Results in an object store that speaks S3.
//!
//! An object appears whole or not at all; a folder does not. So `member.json` is taken away before
//! a member is written anew, and put there last: the files that it names are then there. A member
//! is made in a temporary folder of this machine. Two processes must not work on the same shard,
//! which nothing here prevents.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use object_store::aws::AmazonS3Builder;
use object_store::path::Path as Key;
use object_store::{ObjectStore, ObjectStoreExt, PutPayload};
use tokio::runtime::{Builder, Runtime};

use super::record::Record;
use super::store::{RECORD, Store, trouble};
use crate::error::{Error, Result, Stage};
use crate::files;

/// An object store with a prefix.
pub(super) struct Objects {
    store: Arc<dyn ObjectStore>,
    prefix: Key,
    runtime: Runtime,
    scratch: tempfile::TempDir,
}

fn refused(what: &str, key: &str, e: object_store::Error) -> Error {
    // The store's own words can run over many lines.
    let why = e.to_string().split_whitespace().collect::<Vec<_>>().join(" ");
    Error::io(Stage::Output, format!("cannot {what} {key}: {why}"))
        .advise("check bucket, endpoint and keys (AWS_ENDPOINT, AWS_REGION, AWS_ACCESS_KEY_ID …); what is done is kept")
        .caused_by(e)
}

impl Objects {
    /// `s3://BUCKET/PREFIX`; endpoint, region and keys from the environment, by the names that all
    /// S3 tools use.
    pub(super) fn s3(url: &str) -> Result<Self> {
        let wrong = |m: String| Error::usage(Stage::Batch, m).advise("as in s3://bucket/families/one");
        let rest = url.strip_prefix("s3://").unwrap_or(url).trim_end_matches('/');
        let (bucket, prefix) = rest.split_once('/').unwrap_or((rest, ""));
        if bucket.is_empty() {
            return Err(wrong(format!("{url} names no bucket")));
        }
        // The client has no TLS of its own (see Cargo.toml); one that is installed already stays.
        let _ = rustls::crypto::ring::default_provider().install_default();
        let store = AmazonS3Builder::from_env().with_bucket_name(bucket).build();
        let store = store.map_err(|e| refused("open", url, e))?;
        Self::new(Arc::new(store), prefix)
    }

    /// Any store.
    pub(super) fn new(store: Arc<dyn ObjectStore>, prefix: &str) -> Result<Self> {
        let scratch = tempfile::Builder::new().prefix("bladewright-").tempdir();
        let scratch = scratch.map_err(|e| trouble("cannot write in", &std::env::temp_dir(), e))?;
        let runtime = Builder::new_current_thread().enable_all().build();
        let runtime = runtime.map_err(|e| trouble("cannot start the client of", Path::new("the object store"), e))?;
        Ok(Objects { store, prefix: Key::from(prefix), runtime, scratch })
    }

    fn key(&self, path: &str) -> Key {
        path.split('/').fold(self.prefix.clone(), |key, part| key.join(part))
    }

    fn put(&self, path: &str, content: Vec<u8>) -> Result<()> {
        let key = self.key(path);
        let put = self.store.put(&key, PutPayload::from(content));
        self.runtime.block_on(put).map(|_| ()).map_err(|e| refused("write", path, e))
    }

    fn delete(&self, path: &str) -> Result<()> {
        match self.runtime.block_on(async { self.store.delete(&self.key(path)).await }) {
            Err(object_store::Error::NotFound { .. }) | Ok(()) => Ok(()),
            Err(e) => Err(refused("remove", path, e)),
        }
    }
}

impl Store for Objects {
    fn read(&self, path: &str) -> Result<Option<Vec<u8>>> {
        let get = async { self.store.get(&self.key(path)).await?.bytes().await };
        match self.runtime.block_on(get) {
            Ok(bytes) => Ok(Some(bytes.to_vec())),
            Err(object_store::Error::NotFound { .. }) => Ok(None),
            Err(e) => Err(refused("read", path, e)),
        }
    }

    fn write(&self, path: &str, content: &[u8]) -> Result<()> {
        self.put(path, content.to_vec())
    }

    fn workshop(&self, name: &str) -> Result<PathBuf> {
        self.sweep(name)?;
        let folder = self.scratch.path().join(name);
        std::fs::create_dir_all(&folder).map_err(|e| trouble("cannot make the folder", &folder, e))?;
        Ok(folder)
    }

    fn take_in(&self, record: &Record, old: Option<&Record>) -> Result<()> {
        let (name, folder) = (&record.name, self.scratch.path().join(&record.name));
        let object = |file: &str| format!("members/{name}/{file}");
        self.delete(&object(RECORD))?;
        for file in record.files.keys().map(String::as_str).chain([RECORD]) {
            let path = folder.join(file);
            let content = files::read(&path, files::LONG).map_err(|e| trouble("cannot read", &path, e))?;
            if file == RECORD {
                for gone in old.iter().flat_map(|o| o.files.keys()).filter(|f| !record.files.contains_key(*f)) {
                    self.delete(&object(gone))?;
                }
            }
            self.put(&object(file), content)?;
        }
        self.sweep(name)
    }

    fn sweep(&self, name: &str) -> Result<()> {
        let folder = self.scratch.path().join(name);
        match std::fs::remove_dir_all(&folder) {
            Err(e) if e.kind() != std::io::ErrorKind::NotFound => Err(trouble("cannot remove", &folder, e)),
            _ => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use std::collections::BTreeMap;

    use super::*;
    use object_store::memory::InMemory;

    fn member(store: &Objects, name: &str, files: &[(&str, &str)]) -> Record {
        let folder = store.workshop(name).unwrap();
        let mut record = Record::missing(name, "m", &BTreeMap::new());
        for (file, text) in files {
            std::fs::write(folder.join(file), text).unwrap();
            record.files.insert((*file).into(), blake3::hash(text.as_bytes()).to_hex().to_string());
        }
        std::fs::write(folder.join(RECORD), serde_json::to_vec(&record).unwrap()).unwrap();
        record
    }

    #[test]
    fn a_member_is_replaced_with_nothing_of_the_old_one_left() {
        let memory: Arc<dyn ObjectStore> = Arc::new(InMemory::new());
        let store = Objects::new(Arc::clone(&memory), "families/one").unwrap();
        assert_eq!(store.read("members/a b/member.json").unwrap(), None);
        let old = member(&store, "a b", &[("x.txt", "1"), ("y.txt", "2")]);
        store.take_in(&old, None).unwrap();
        let new = member(&store, "a b", &[("x.txt", "3")]);
        store.take_in(&new, Some(&old)).unwrap();
        assert_eq!(store.read("members/a b/x.txt").unwrap().unwrap(), b"3");
        assert_eq!(store.read("members/a b/y.txt").unwrap(), None);
        let told: Record = serde_json::from_slice(&store.read("members/a b/member.json").unwrap().unwrap()).unwrap();
        assert_eq!(told, new);
        assert!(!store.scratch.path().join("a b").exists());
        // Another process sees the same under the same prefix, and nothing under another.
        let other = Objects::new(Arc::clone(&memory), "families/one").unwrap();
        assert!(other.read("members/a b/x.txt").unwrap().is_some());
        assert!(Objects::new(memory, "families").unwrap().read("members/a b/x.txt").unwrap().is_none());
    }

    #[test]
    fn a_place_without_a_bucket_is_refused() {
        assert!(Objects::s3("s3:///x").is_err_and(|e| e.message.contains("no bucket")));
    }
}
