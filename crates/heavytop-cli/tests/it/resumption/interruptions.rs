//! Commands that cannot be resumed, after Ctrl-C: they leave no file.
#![cfg(unix)]

use crate::program::Folder;
use std::process::Command;
use std::thread::sleep;
use std::time::Duration;

#[test]
#[ignore = "a fault, which .ci/run makes"]
fn ctrl_c_leaves_no_file() {
    for (arguments, configuration, begun) in [
        (&["animate", "a.toml", "--out", "a.html"][..], "integrator.end = 1e5", "a.html.partial"),
        (&["reproduce", "--out", "a", "--end", "1e5"], "", "a/trajectories.csv.partial"),
        (&["compare", "a.toml", "--out", "a"], "", "a/work-precision.csv.partial"),
    ] {
        let folder = Folder::new();
        folder.write("a.toml", configuration);
        let mut child = folder.start(arguments);
        while !folder.path(begun).exists() && child.try_wait().unwrap().is_none() {
            sleep(Duration::from_millis(1));
        }
        sleep(Duration::from_millis(100));
        let id = child.id().to_string();
        assert!(Command::new("kill").args(["-INT", &id]).status().unwrap().success());
        let done = child.wait_with_output().unwrap();
        let said = String::from_utf8(done.stderr).unwrap();
        assert_eq!((done.status.code(), said.as_str()), (Some(130), "heavytop: interrupted\n"));
        // The folder was created and is empty.
        let is_file = |name: &String| folder.path(name).is_file();
        assert_eq!(folder.names().into_iter().filter(is_file).collect::<Vec<_>>(), ["a.toml"]);
        if folder.path("a").exists() {
            assert_eq!(std::fs::read_dir(folder.path("a")).unwrap().count(), 0, "{arguments:?}");
        }
    }
}
