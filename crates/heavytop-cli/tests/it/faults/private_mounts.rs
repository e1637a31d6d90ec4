//! Mounts that only one command sees.
#![cfg(unix)]

use crate::program::{Finished, heavytop};
use std::path::Path;
use std::process::Command;

/// Mounts something by a shell command, and then runs `heavytop` by another, which finds it with its arguments in `$@`.
///
/// Nobody else sees the mount, and it ends with the command. The superuser needs no name space of users, others do.
/// Returns `None`, with a message, where neither may mount.
pub fn with_mount(folder: &Path, mount: &str, then: &str, arguments: &[&str]) -> Option<Finished> {
    let script = format!("{mount} && echo mounted && {{ {then}\n}}");
    let run = |name_spaces: &str| {
        let mut command = Command::new("unshare");
        command.args([name_spaces, "sh", "-c", &script, "sh", heavytop()]);
        let done = command.args(arguments).current_dir(folder).output();
        done.ok().map(Finished::of).filter(|run| run.stdout().starts_with("mounted\n"))
    };
    let run = run("-m").or_else(|| run("-rm"));
    if run.is_none() {
        println!("skipped: nothing can be mounted here");
    }
    run
}
