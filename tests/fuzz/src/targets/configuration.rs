//! Configurations: what is read from TOML, and the first steps of the run that it asks for.

use crate::case_file::case_file;
use heavytop_cli::Error;
use heavytop_cli::configuration::Config;
use heavytop_cli::reading::Sources;

/// The number of samples that are computed of a run.
const SAMPLES: usize = 3;

/// Reads the text as the program does: from a file.
fn read(text: &[u8]) -> Result<Sources, Error> {
    Sources::read(None, Some(&case_file("case.toml", text)), &[])
}

pub(super) fn run(case: &[u8]) {
    let sources = match read(case) {
        Err(error) => return assert_refused(&error),
        Ok(sources) => sources,
    };
    let config = sources.config();
    assert_reads_back(config);
    if let Err(error) = first_steps(config) {
        assert_explained(&sources.locate(error));
    }
}

/// Asserts that an error says in words what is wrong.
fn assert_explained(error: &Error) {
    let message = error.message();
    assert!(!message.trim().is_empty() && matches!(error.exit_code(), 1 | 2), "{message}");
    assert!(!message.contains(char::is_control) || message.contains('\n'), "{message:?}");
}

/// Asserts that an error says what is wrong, and that nothing was begun.
fn assert_refused(error: &Error) {
    assert_explained(error);
    assert_eq!(error.exit_code(), 2, "{}", error.message());
}

/// Asserts that the configuration as TOML is the same configuration.
fn assert_reads_back(config: &Config) {
    let Ok(text) = config.to_toml() else { return };
    let Ok(again) = read(text.as_bytes()) else { panic!("cannot be read again:\n{text}") };
    // Texts are compared, so that NaN equals itself.
    assert_eq!(again.config().to_toml().ok().as_deref(), Some(&*text));
}

/// Computes the first steps of the run. Each state must be finite.
pub(super) fn first_steps(config: &Config) -> Result<(), Error> {
    let mut seen = 0;
    let mut see = |numbers: &[f64]| {
        assert!(numbers.iter().all(|x| x.is_finite()), "{numbers:?}");
        seen += 1;
        if seen == SAMPLES { Err(enough()) } else { Ok(()) }
    };
    let mut run = config.run()?;
    run.pace.every = 1;
    let width = 1 + run.coordinates().iter().map(|(_, columns)| columns.len()).sum::<usize>();
    let outcome = run.follow(None, |moment| see(moment.row.get(..width).unwrap_or_default()));
    match outcome {
        Err(Error::NoCommand { names, .. }) if names.is_empty() => Ok(()),
        outcome => outcome,
    }
}

/// Returns the error by which a run is ended that has gone far enough; no command fails with it.
fn enough() -> Error {
    Error::NoCommand { name: String::new(), names: Vec::new() }
}
