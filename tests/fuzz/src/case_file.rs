//! The file of a case, for what the program reads from files.

use std::cell::OnceCell;
use std::path::PathBuf;
use tempfile::TempDir;

thread_local! {
    static FOLDER: OnceCell<TempDir> = const { OnceCell::new() };
}

/// Writes a case into a file of this name, in a folder that each thread has for itself, and returns its path.
///
/// # Panics
/// If it cannot be written, so that no case passes unread.
pub(crate) fn case_file(name: &str, case: &[u8]) -> PathBuf {
    FOLDER.with(|folder| {
        let folder = folder.get_or_init(|| {
            tempfile::tempdir().unwrap_or_else(|e| panic!("no temporary folder: {e}"))
        });
        let path = folder.path().join(name);
        match std::fs::write(&path, case) {
            Ok(()) => path,
            Err(error) => panic!("{}: {error}", path.display()),
        }
    })
}
