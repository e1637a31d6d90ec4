//! Checkpoints: sealed contents that no run has written, and the steps that follow them.

use super::configuration::first_steps;
use heavytop_cli::Error;
use heavytop_cli::commands::simulate::Checkpoint;
use std::cell::OnceCell;
use std::fs;
use tempfile::TempDir;

thread_local! {
    static FOLDER: OnceCell<Option<TempDir>> = const { OnceCell::new() };
}

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

fn read(file: &[u8]) -> Option<Result<Checkpoint, Error>> {
    FOLDER.with(|folder| {
        let folder = folder.get_or_init(|| tempfile::tempdir().ok()).as_ref()?;
        let path = folder.path().join("case.checkpoint");
        fs::write(&path, file).ok()?;
        Some(Checkpoint::read(&path))
    })
}

pub(super) fn run(case: &[u8]) {
    let checkpoint = match read(&sealed(case)) {
        None => return,
        Some(Err(error)) => {
            assert!(matches!(error, Error::Checkpoint { .. }), "{}", error.message());
            return;
        }
        Some(Ok(checkpoint)) => checkpoint,
    };
    // What a run would check before it continues is not of importance here: none may panic.
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
