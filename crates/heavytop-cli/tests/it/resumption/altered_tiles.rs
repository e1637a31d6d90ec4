//! `heavytop section` and `heavytop sweep` with tiles that were altered: they are refused, or made again.
#![cfg(unix)]

use super::tiles::{SECTION, SWEEP, SYSTEM_SWEEP, interrupted};
use std::thread::sleep;
use std::time::Duration;

/// A run that was killed while it removed its tiles may have left some of them.
#[test]
#[ignore = "a fault, which .ci/run makes"]
fn tiles_of_another_run_are_not_taken() {
    for case in [SECTION, SWEEP, SYSTEM_SWEEP] {
        let folder = case.folder();
        let mut child = folder.start(&[case.command, "b.toml", "--out", "cut"]);
        let tile = case.tiles(&folder).join("0000001");
        while !tile.exists() && child.try_wait().unwrap().is_none() {
            sleep(Duration::from_millis(1));
        }
        let _ = child.kill();
        child.wait().unwrap();
        if !tile.exists() {
            continue;
        }
        std::fs::remove_file(case.tiles(&folder).join("identity")).unwrap();
        let run = folder.heavytop(&[case.command, "a.toml", "--out", "cut"]);
        assert_eq!((run.code(), run.complaints().as_str()), (0, ""));
        case.assert_same_bytes(&folder);
    }
}

#[test]
#[ignore = "a fault, which .ci/run makes"]
fn a_damaged_identity_is_refused() {
    for case in [SECTION, SWEEP, SYSTEM_SWEEP] {
        let folder = case.folder();
        let title = "heavytop-tiles 00000000\n";
        std::fs::create_dir_all(case.tiles(&folder)).unwrap();
        for (identity, message) in [
            ("", "it is damaged, or no checkpoint: it ends early"),
            (title, "it is damaged, or no checkpoint: "),
            (
                "heavytop-tiles 6c0d35ab\nversion = \"0.0.1\"\n",
                "version 0.0.1 made it, and this is ",
            ),
        ] {
            let path = case.tiles(&folder).join("identity");
            let sealed = match identity.split_once('\n') {
                Some((_, contents)) if !contents.is_empty() => {
                    format!(
                        "heavytop-tiles {:08x}\n{contents}",
                        crc32fast::hash(contents.as_bytes())
                    )
                }
                _ => identity.into(),
            };
            std::fs::write(&path, &sealed).unwrap();
            let run = folder.heavytop(&[case.command, "a.toml", "--out", "cut", "--resume"]);
            assert_eq!(run.code(), 2, "{}", run.stderr());
            assert!(run.stderr().contains(message), "{}", run.stderr());
            assert!(run.stderr().ends_with("; start anew with --restart\n"), "{}", run.stderr());
            assert_eq!(std::fs::read_to_string(&path).unwrap(), sealed);
        }
        // A file that is not text counts as damaged, too; and the advice in the message helps.
        std::fs::write(case.tiles(&folder).join("identity"), b"heavytop-tiles \xff\xfe").unwrap();
        let run = folder.heavytop(&[case.command, "a.toml", "--out", "cut", "--resume"]);
        assert_eq!(run.code(), 2, "{}", run.stderr());
        assert!(run.stderr().contains("it is damaged, or no checkpoint"), "{}", run.stderr());
        let run = folder.heavytop(&[case.command, "a.toml", "--out", "cut", "--restart"]);
        assert_eq!((run.code(), run.complaints().as_str()), (0, ""));
        case.assert_same_bytes(&folder);
    }
}

/// As if the run had begun on a processor with other instructions.
#[test]
#[ignore = "a fault, which .ci/run makes"]
fn tiles_with_other_last_digits_are_refused() {
    for case in [SECTION, SWEEP, SYSTEM_SWEEP] {
        let folder = interrupted(&case);
        let path = case.tiles(&folder).join("identity");
        let identity = std::fs::read_to_string(&path).unwrap();
        let contents = identity.split_once('\n').unwrap().1.replace("\"portable\"", "\"others\"");
        let checksum = crc32fast::hash(contents.as_bytes());
        std::fs::write(&path, format!("heavytop-tiles {checksum:08x}\n{contents}")).unwrap();
        let run = folder.heavytop(&[case.command, "a.toml", "--out", "cut", "--resume"]);
        let expected = "it is of a run on the instructions others, and this processor would go on \
                        with portable, to other last digits; start anew with --restart\n";
        assert!(run.code() == 2 && run.stderr().ends_with(expected), "{}", run.stderr());
    }
}

#[test]
#[ignore = "a fault, which .ci/run makes"]
fn tiles_that_were_swapped_are_made_again() {
    for case in [SECTION, SWEEP, SYSTEM_SWEEP] {
        let folder = interrupted(&case);
        let [first, second] = ["0000000", "0000001"].map(|name| case.tiles(&folder).join(name));
        let bytes = std::fs::read(&first).unwrap();
        std::fs::rename(&second, &first).unwrap();
        std::fs::write(&second, bytes).unwrap();
        let resumed = folder.heavytop(&[case.command, "a.toml", "--out", "cut", "--resume"]);
        assert_eq!((resumed.code(), resumed.complaints().as_str()), (0, ""));
        case.assert_same_bytes(&folder);
    }
}

/// A tile lacks its last line, or has it twice, with the checksum of its present contents.
#[test]
#[ignore = "a fault, which .ci/run makes"]
fn tiles_that_are_whole_and_not_what_they_should_be_are_made_again() {
    for case in [SECTION, SWEEP, SYSTEM_SWEEP] {
        let folder = interrupted(&case);
        for (name, times) in [("0000000", 0), ("0000001", 2)] {
            let path = case.tiles(&folder).join(name);
            let tile = std::fs::read_to_string(&path).unwrap();
            let (title, contents) = tile.split_once('\n').unwrap();
            let (start, _) = title.rsplit_once(' ').unwrap();
            let start_of_last = contents.trim_end().rfind('\n').unwrap() + 1;
            // Of a section's tile only the lines of the start are left: it would have fewer returns.
            let kept = if case.command == "section" && times == 0 {
                ""
            } else {
                &contents[..start_of_last]
            };
            let changed = kept.to_owned() + &contents[start_of_last..].repeat(times);
            let checksum = crc32fast::hash(changed.as_bytes());
            std::fs::write(&path, format!("{start} {checksum:08x}\n{changed}")).unwrap();
        }
        let resumed = folder.heavytop(&[case.command, "a.toml", "--out", "cut", "--resume"]);
        assert_eq!((resumed.code(), resumed.complaints().as_str()), (0, ""));
        case.assert_same_bytes(&folder);
    }
}
