//! The files of a command, which get their names together.

use super::output::Output;
use crate::errors::Error;
use std::io::Write;
use std::path::Path;

/// The finished files of a command: all of them get their names, or none.
///
/// So a full disk leaves no new figure beside an old table. Only a kill between two of the last system calls can: each
/// file is complete even then.
#[derive(Debug, Default)]
pub(crate) struct OutputSet {
    finished: Vec<Output>,
}

impl OutputSet {
    /// Adds a file, and writes its last bytes.
    ///
    /// # Errors
    /// If they cannot be written.
    pub fn push(&mut self, mut output: Output) -> Result<(), Error> {
        output.finish()?;
        self.finished.push(output);
        Ok(())
    }

    /// Writes a file with these contents, at the end of a run.
    ///
    /// # Errors
    /// [`Error::Write`] if the file cannot be created or written: at the end it is too late to refuse the request.
    pub fn add(&mut self, path: &Path, contents: &[u8]) -> Result<(), Error> {
        let mut output = Output::create(path).map_err(Error::too_late)?;
        output.write(|writer| writer.write_all(contents))?;
        self.push(output)
    }

    /// Gives all files their names.
    ///
    /// # Errors
    /// If a file cannot be renamed.
    pub fn complete(self) -> Result<(), Error> {
        self.finished.into_iter().try_for_each(Output::complete)
    }

    /// Gives all files their names if the run that wrote them succeeded, that of its table last.
    ///
    /// If the run failed underway, the table is kept as [`Output::conclude`] says, and the other files are removed.
    ///
    /// # Errors
    /// The reason why the run or the completion failed, and the path of the partial table.
    pub fn conclude<T>(self, mut table: Output, outcome: Result<T, Error>) -> Result<T, Error> {
        let outcome = outcome.and_then(|value| {
            table.finish()?;
            self.complete().map(|()| value)
        });
        table.conclude(outcome)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn a_file_that_cannot_be_written_leaves_the_others_as_they_were() {
        let folder = tempfile::tempdir().unwrap();
        let [first, second] = ["a", "b"].map(|name| folder.path().join(name));
        let read = |path: &Path| std::fs::read_to_string(path).ok();
        let write = |to: &Path| {
            let mut set = OutputSet::default();
            set.add(&first, b"new")?;
            set.add(to, b"new")?;
            // Neither file has its name before the end.
            assert_eq!((read(&first).as_deref(), read(&second)), (Some("old"), None));
            set.complete()
        };
        std::fs::write(&first, "old").unwrap();
        assert!(write(&folder.path().join("missing/b")).is_err());
        assert_eq!(read(&first).as_deref(), Some("old"));
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
        write(&second).unwrap();
        assert_eq!(
            [&first, &second].map(|path| read(path)),
            [Some("new".into()), Some("new".into())]
        );
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 2);
    }
}
