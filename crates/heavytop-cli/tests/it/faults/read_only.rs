//! Folders that are read-only.
#![cfg(unix)]

use super::private_mounts::with_mount;
use crate::program::{Finished, Folder};
use crate::writing::{WRITING, Writing, contents};
use std::fs::{self, Permissions};
use std::os::unix::fs::PermissionsExt;

/// Runs the command where the folder and those below are read-only; `None`, with a message, where that cannot be had.
///
/// Permissions do not bind the superuser, for whom the folder is mounted read-only.
fn read_only(folder: &Folder, writing: &Writing) -> Option<Finished> {
    // The folder of the files, if there are old ones, and the one above it.
    let of_files = folder.path(writing.files[0]).parent().unwrap().to_path_buf();
    let below = [of_files, folder.path(".")].into_iter().filter(|path| path.exists());
    let below: Vec<_> = below.collect();
    let permit = |mode| {
        below
            .iter()
            .for_each(|path| fs::set_permissions(path, Permissions::from_mode(mode)).unwrap());
    };
    permit(0o555);
    let binds = fs::write(folder.path("probe"), "").is_err();
    let run = if binds {
        Some(writing.run(folder, &[]))
    } else {
        fs::remove_file(folder.path("probe")).unwrap();
        mounted_read_only(folder, writing)
    };
    permit(0o755);
    run
}

fn mounted_read_only(folder: &Folder, writing: &Writing) -> Option<Finished> {
    let mount = "mount --bind . . && mount -o remount,bind,ro .";
    with_mount(&folder.path("."), mount, "cd \"$PWD\" && exec \"$@\"", writing.arguments)
}

#[test]
#[ignore = "a fault, which .ci/run makes"]
fn a_read_only_folder_is_refused_and_stays_as_it_is() {
    for writing in &WRITING {
        for folder in [Folder::new(), writing.with_old_files()] {
            let before = contents(&folder);
            let Some(run) = read_only(&folder, writing) else { return };
            let said = run.stderr();
            assert_eq!((run.code(), said.lines().count()), (2, 1), "{writing}: {said}");
            assert!(said.starts_with("heavytop: cannot create "), "{writing}: {said}");
            let reasons = [": Read-only file system", ": Permission denied"];
            assert!(reasons.iter().any(|reason| said.contains(reason)), "{writing}: {said}");
            // The message names the file, or the folder that could not be made.
            let out = writing.files[0].split('/').next().unwrap();
            assert!(said.contains(out), "{writing}: {said}");
            assert!(contents(&folder) == before, "{writing} has changed the folder");
        }
        // Control: it is the folder that was at fault.
        if writing.repeats {
            writing.assert_repeats(&writing.with_old_files(), &[]);
        }
    }
}
