//! File locks, by which each file has one writer.

use same_file::Handle;
use std::fs::{File, TryLockError};
use std::io;
use std::path::Path;
use std::thread::sleep;
use std::time::Duration;

/// How often a lock that another run has is tried again, and after how long.
const LOOKS: u32 = 10;
const BETWEEN_LOOKS: Duration = Duration::from_millis(5);

/// Opens the file for reading and writing, and takes its lock.
///
/// If the file does not exist, it is created if `make` says so. Its contents stay.
///
/// The lock is advisory, and held by the operating system. It ends when the file is closed, and with the process,
/// however the process ends: a run that was killed blocks no other run.
///
/// # Errors
/// [`io::ErrorKind::ResourceBusy`] if another run has the lock; or the file cannot be opened.
pub(crate) fn open(path: &Path, make: bool) -> io::Result<File> {
    let mut options = File::options();
    let options = options.read(true).write(true).create(make).truncate(false);
    let mut looks = LOOKS;
    loop {
        let file = options.open(path)?;
        match file.try_lock() {
            Ok(()) if is_at(&file, path)? => return Ok(file),
            // Another run has renamed or removed the file since it was opened, and is done with it.
            Ok(()) => {}
            // Another run may be looking whether the file is locked, which locks it for a moment.
            Err(TryLockError::WouldBlock) if looks > 0 => {
                looks -= 1;
                sleep(BETWEEN_LOOKS);
            }
            Err(TryLockError::WouldBlock) => {
                let busy = "another run is writing it";
                return Err(io::Error::new(io::ErrorKind::ResourceBusy, busy));
            }
            // Some network file systems have no locks: runs continue there, and nothing keeps them apart.
            Err(TryLockError::Error(_)) => return Ok(file),
        }
    }
}

/// Returns whether another run has the lock of a file. A file that cannot be opened, or a system without locks, has none.
pub(crate) fn is_held(path: &Path) -> bool {
    File::open(path)
        .is_ok_and(|file| matches!(file.try_lock_shared(), Err(TryLockError::WouldBlock)))
}

/// Returns whether the file still has this name.
fn is_at(file: &File, path: &Path) -> io::Result<bool> {
    match Handle::from_path(path) {
        Ok(there) => Ok(Handle::from_file(file.try_clone()?)? == there),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(false),
        Err(error) => Err(error),
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn one_at_a_time_opens_a_file_and_its_contents_stay() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        std::fs::write(&path, "old").unwrap();
        let first = open(&path, true).unwrap();
        assert_eq!(open(&path, true).unwrap_err().kind(), io::ErrorKind::ResourceBusy);
        assert!(is_held(&path));
        assert_eq!(std::fs::read(&path).unwrap(), b"old");
        drop(first);
        assert!(!is_held(&path) && !is_held(&folder.path().join("b")));
        assert!(open(&path, true).is_ok());
    }

    /// A run that looks whether a file is locked has its lock for a moment, and does not keep another one out.
    #[test]
    fn who_only_looks_keeps_nobody_out() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        let looking = File::create(&path).unwrap();
        looking.try_lock_shared().unwrap();
        let opened = std::thread::scope(|scope| {
            let opened = scope.spawn(|| open(&path, true).map(drop));
            sleep(BETWEEN_LOOKS);
            looking.unlock().unwrap();
            opened.join().unwrap()
        });
        assert!(opened.is_ok(), "{opened:?}");
    }

    /// A file that was renamed does not block its old name.
    #[test]
    fn a_file_that_was_renamed_does_not_keep_its_old_name() {
        let folder = tempfile::tempdir().unwrap();
        let [path, new] = ["a", "b"].map(|name| folder.path().join(name));
        let first = open(&path, true).unwrap();
        std::fs::rename(&path, &new).unwrap();
        assert!(!is_at(&first, &path).unwrap());
        assert!(open(&path, true).is_ok());
        assert!(!is_at(&first, &path).unwrap() && is_at(&first, &new).unwrap());
        assert_eq!(
            open(&folder.path().join("c"), false).unwrap_err().kind(),
            io::ErrorKind::NotFound
        );
    }
}
