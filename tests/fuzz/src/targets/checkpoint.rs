//! Checkpoints: sealed contents that no run has written, and the steps that follow them.

use super::configuration::first_steps;
use crate::case_file::case_file;
use heavytop_cli::Error;
use heavytop_cli::commands::simulate::Checkpoint;

/// The version that the cases of the corpus name.
const VERSION: &str = "version = \"0.1.0\"";

/// Returns the file: the bytes as they are if the first is a zero, and otherwise under a title with their checksum, from the
/// present version of the program where they name that of the corpus.
fn sealed(case: &[u8]) -> Vec<u8> {
    let contents = match case.split_first() {
        Some((0, contents)) => return contents.to_vec(),
        _ => match case.strip_prefix(VERSION.as_bytes()) {
            Some(rest) => {
                let version = concat!("version = \"", env!("CARGO_PKG_VERSION"), "\"");
                [version.as_bytes(), rest].concat()
            }
            None => case.to_vec(),
        },
    };
    let title = format!("heavytop-checkpoint {:08x}\n", crc32fast::hash(&contents));
    [title.as_bytes(), &contents].concat()
}

pub(super) fn run(case: &[u8]) {
    let _ = goes_on(case);
}

/// Runs the target `checkpoint`. Returns whether the file was accepted and a run went on from it.
#[must_use]
pub fn goes_on(case: &[u8]) -> bool {
    let checkpoint = match Checkpoint::read(&case_file("case.checkpoint", &sealed(case))) {
        Ok(checkpoint) => checkpoint,
        Err(error) => {
            assert!(matches!(error, Error::Checkpoint { .. }), "{}", error.message());
            return false;
        }
    };
    // The checks of `simulate` before it continues are left out, so that more states are tried.
    let config = checkpoint.configuration();
    let _ = first_steps(config);
    let saved = checkpoint.saved();
    let Ok(None) = config.system_experiment() else { return false };
    let Ok(mut experiment) = config.experiment() else { return false };
    experiment.pace.every = 1;
    let steps = &mut experiment.pace.schedule.steps;
    *steps = (*steps).min(saved.step.saturating_add(2));
    let finite = saved.state.iter().all(|x| x.is_finite());
    let mut moments = 0;
    let followed = experiment.follow(Some(&saved), |moment| {
        let state = moment.row.get(1..7).unwrap_or_default();
        assert!(!finite || state.iter().all(|x| x.is_finite()), "{state:?}");
        moments += 1;
        Ok::<_, Error>(())
    });
    followed.is_ok() && moments > 1
}
