//! Checkpoints: sealed contents that no run has written, and the steps that follow them.

use super::configuration::first_steps;
use crate::case_file::case_file;
use heavytop_cli::Error;
use heavytop_cli::commands::simulate::Checkpoint;

/// Returns the file: the bytes as they are if the first is a zero, and otherwise under a title with their checksum.
fn sealed(case: &[u8]) -> Vec<u8> {
    match case.split_first() {
        Some((0, contents)) => contents.to_vec(),
        _ => {
            let title = format!("heavytop-checkpoint {:08x}\n", crc32fast::hash(case));
            [title.as_bytes(), case].concat()
        }
    }
}

pub(super) fn run(case: &[u8]) {
    let checkpoint = match Checkpoint::read(&case_file("case.checkpoint", &sealed(case))) {
        Ok(checkpoint) => checkpoint,
        Err(error) => {
            assert!(matches!(error, Error::Checkpoint { .. }), "{}", error.message());
            return;
        }
    };
    // The checks of `simulate` before it continues are left out, so that more states are tried.
    let config = checkpoint.configuration();
    let _ = first_steps(config);
    let saved = checkpoint.saved();
    let Ok(None) = config.system_experiment() else { return };
    let Ok(mut experiment) = config.experiment() else { return };
    experiment.every = 1;
    experiment.schedule.steps = experiment.schedule.steps.min(saved.step.saturating_add(2));
    let finite = saved.state.iter().all(|x| x.is_finite());
    let _ = experiment.follow(Some(&saved), |moment| {
        let sizes = [moment.momentum.0.0.amax(), moment.momentum.0.1.amax()];
        assert!(!finite || sizes.iter().all(|size| size.is_finite()), "{sizes:?}");
        Ok(())
    });
}
