//! Checkpoints from which no run goes on.

use super::refused;
use crate::program::Folder;
use heavytop_cli::Error;
use heavytop_cli::commands::simulate::{Checkpoint, SimulateOptions, simulate};
use heavytop_cli::configuration::Config;
use std::collections::BTreeSet;
use std::sync::atomic::AtomicBool;

/// Changes of a line of a checkpoint: its key, the new value, and the error.
const CHANGES: [(&str, &str, &str); 4] = [
    ("version", "\"0.0.1\"", "CheckpointError::Version"),
    ("instructions", "\"others\"", "CheckpointError::Instructions"),
    ("step", "7", "CheckpointError::Impossible"),
    ("checksum", "1", "CheckpointError::OtherRows"),
];

pub fn errors() -> BTreeSet<String> {
    let folder = Folder::new();
    let (out, kept) = (folder.path("a.csv"), folder.path("a.csv.checkpoint"));
    let config = Config::default();
    let stop = AtomicBool::new(true);
    let stopped = SimulateOptions { stop: Some(&stop), ..SimulateOptions::default() };
    let mut found = vec![refused("Error::Interrupted", simulate(&config, &out, &stopped))];
    found.push(refused("Error::Unfinished", simulate(&config, &out, &SimulateOptions::default())));

    let text = folder.read("a.csv.checkpoint");
    let resume = |config: &Config, name: &str| -> Result<(), Error> {
        let checkpoint = Checkpoint::read(&kept)?;
        let options = SimulateOptions { resume: Some(&checkpoint), ..SimulateOptions::default() };
        simulate(config, &folder.path(name), &options).map(drop)
    };
    for (key, value, expected) in CHANGES {
        let contents = text.split_once('\n').unwrap().1;
        let line = contents.lines().find(|line| line.starts_with(&format!("{key} = "))).unwrap();
        let changed = contents.replacen(&format!("{line}\n"), &format!("{key} = {value}\n"), 1);
        let checksum = crc32fast::hash(changed.as_bytes());
        folder.write("a.csv.checkpoint", &format!("heavytop-checkpoint {checksum:08x}\n{changed}"));
        found.push(refused(expected, resume(&config, "a.csv")));
    }
    folder.write("a.csv.checkpoint", &text.replace("step", "stop"));
    found.push(refused("CheckpointError::Damaged", resume(&config, "a.csv")));
    folder.write("a.csv.checkpoint", "integrator.end = 50");
    found.push(refused("CheckpointError::NoCheckpoint", resume(&config, "a.csv")));
    folder.write("a.csv.checkpoint", &text);
    let other = toml::from_str("integrator.end = 50").unwrap();
    found.push(refused("CheckpointError::Configuration", resume(&other, "a.csv")));
    found.push(refused("CheckpointError::Format", resume(&config, "a.npz")));
    found.push(refused("CheckpointError::Rows", resume(&config, "b.csv")));
    // Control: the checkpoint is accepted by its own run.
    resume(&config, "a.csv").unwrap();
    found.push(refused("CheckpointError::Read", resume(&config, "a.csv")));
    found.into_iter().flatten().collect()
}
