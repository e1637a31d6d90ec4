//! The manners of the command line: standard output, closed pipes, messages for machines, narrow terminals, manual pages.
#![cfg(unix)]

use crate::program::{Finished, Folder, heavytop, numbers};
use serde_json::Value;
use std::process::Command;

/// Runs a line of a shell in the folder, where `heavytop` is the program.
fn in_shell(folder: &Folder, line: &str) -> Finished {
    let line = format!("heavytop() {{ {} \"$@\"; }}; {line}", heavytop());
    Finished::of(
        Command::new("sh").args(["-c", &line]).current_dir(folder.path(".")).output().unwrap(),
    )
}

const SHORT: [&str; 2] = ["--set", "integrator.end=1"];

#[test]
fn a_minus_is_standard_output() {
    let folder = Folder::new();
    let run = folder.heavytop(&[&["simulate", "--out", "-"], &SHORT[..]].concat());
    assert_eq!((run.code(), numbers(&run.stdout()).1.len(), folder.names().len()), (0, 51, 0));
    assert!(
        run.stderr().starts_with("heavytop: done: 51 rows in standard output; "),
        "{}",
        run.stderr()
    );
    let file = folder.heavytop(&[&["simulate", "--out", "a.csv"], &SHORT[..]].concat());
    assert_eq!((file.code(), folder.read("a.csv")), (0, run.stdout()));
    let page = folder.heavytop(&[&["animate", "--out", "-"], &SHORT[..]].concat());
    assert!(page.code() == 0 && page.stdout().starts_with("<!DOCTYPE html>"));
    let text = folder.heavytop(&["init"]).stdout();
    assert_eq!(folder.heavytop(&["init", "-"]).stdout(), text);
    // What is on standard output already stays.
    let line = "(echo before; heavytop simulate --out - --quiet --set integrator.end=1) >both.csv";
    assert_eq!(in_shell(&folder, line).code(), 0);
    assert_eq!(folder.read("both.csv"), format!("before\n{}", run.stdout()));
    // The numbers and the summary for machines do not meet.
    let json = folder.heavytop(&[&["simulate", "--out", "-", "--json"], &SHORT[..]].concat());
    assert_eq!(json.stdout(), run.stdout());
    assert_eq!(serde_json::from_str::<Value>(&json.stderr()).unwrap()["rows"], 51);
    assert_eq!(folder.names(), ["a.csv", "both.csv"]);
}

#[test]
fn a_closed_pipe_is_no_failure() {
    let folder = Folder::new();
    for arguments in [
        "simulate --out - --set integrator.end=1000",
        "simulate --out /dev/stdout --set integrator.end=1000",
        "animate --out -",
        "help simulate",
        "man sweep",
        "completions zsh",
        "init",
    ] {
        let line = format!("(heavytop {arguments}; echo $? >code) | head -c 1 >/dev/null");
        let run = in_shell(&folder, &line);
        assert_eq!((run.code(), run.complaints().as_str()), (0, ""), "{arguments}");
        assert_eq!(folder.read("code"), "0\n", "{arguments}");
    }
}

#[test]
fn errors_and_warnings_are_json_where_the_summary_is() {
    let folder = Folder::new();
    folder.write("a.toml", "[body]\nmass = -1");
    let said = |arguments: &[&str]| -> (i32, Vec<Value>) {
        let run = folder.heavytop(&[arguments, &["--json"]].concat());
        assert_eq!(run.stdout(), "", "{arguments:?}");
        let lines = run.stderr();
        let objects = lines.lines().map(|line| serde_json::from_str(line).unwrap());
        (run.code(), objects.collect())
    };
    let (code, wrong) = said(&["simulate", "a.toml", "--out", "a.csv"]);
    assert_eq!((code, &wrong[0]["exit_code"], wrong.len()), (2, &2.into(), 1));
    assert_eq!(
        wrong[0]["error"],
        "a.toml, line 2, column 8: [body] mass must not be negative, got -1.0"
    );
    assert_eq!(wrong[0]["place"], serde_json::json!({ "file": "a.toml", "line": 2, "column": 8 }));
    for arguments in [
        &["simulate", "--out", "a.csv", "--preset", "kovalevski"][..],
        &["simulat"],
        &["simulate", "--out", "a.txt"],
        &["man", "simulat"],
    ] {
        let (code, objects) = said(arguments);
        assert_eq!((code, objects.len()), (2, 1), "{arguments:?}");
        assert!(objects[0]["error"].as_str().is_some_and(|text| !text.is_empty()), "{objects:?}");
    }
    let failing = "integrator={step=0.5,end=10,scheme='lobatto-iiia-iiib-4'}";
    let (code, objects) = said(&["simulate", "--out", "a.csv", "--set", failing]);
    let last = objects.last().unwrap();
    assert_eq!((code, &last["exit_code"]), (1, &1.into()));
    assert!(last["kept"].as_str().unwrap().ends_with("a.csv.partial"), "{last}");
    assert!(objects[0]["warning"].as_str().unwrap().contains("descend"), "{objects:?}");
}

#[test]
fn a_misspelt_command_gets_a_suggestion_everywhere() {
    let folder = Folder::new();
    for (arguments, expected) in [
        (&["simulat"][..], "'simulate'"),
        (&["help", "simulat"], "'simulate'"),
        (&["help", "swep"], "'sweep'"),
        (&["man", "simulat"], "did you mean `simulate`?"),
    ] {
        let run = folder.heavytop(arguments);
        assert_eq!(run.code(), 2);
        assert!(run.stderr().contains(expected), "{arguments:?}: {}", run.stderr());
    }
    // Control: what is like no command gets none.
    assert!(!folder.heavytop(&["help", "xyz"]).stderr().contains("exist"));
}

const COMMANDS: [&str; 12] = [
    "reproduce",
    "simulate",
    "compare",
    "section",
    "sweep",
    "animate",
    "bench",
    "report",
    "init",
    "man",
    "completions",
    "help",
];

#[test]
fn help_fits_the_columns() {
    let folder = Folder::new();
    let in_columns = |columns: &str, arguments: &[&str]| {
        let mut command = Command::new(heavytop());
        Finished::of(command.args(arguments).env("COLUMNS", columns).output().unwrap()).stdout()
    };
    let mut requests: Vec<Vec<&str>> =
        COMMANDS.iter().map(|command| vec!["help", command]).collect();
    requests.extend([vec!["--help"], vec!["-h"], vec!["sweep", "-h"]]);
    for request in requests {
        let help = in_columns("40", &request);
        let longest = help.lines().map(|line| line.chars().count()).max().unwrap();
        assert!(longest <= 40, "{request:?}: {help}");
        // 0 columns are no number of columns.
        assert_eq!(in_columns("0", &request), folder.heavytop(&request).stdout(), "{request:?}");
        // Where there is room the text is as it was written, and where there is no terminal.
        assert_eq!(in_columns("400", &request), folder.heavytop(&request).stdout(), "{request:?}");
    }
}

/// Examples and tables of a manual page have their lines.
#[test]
fn manual_pages_keep_examples_and_tables() {
    let folder = Folder::new();
    for command in COMMANDS {
        let line =
            format!("heavytop man {command} | MANWIDTH=80 MANPAGER=cat man --warnings -l - 2>said");
        let page = in_shell(&folder, &line);
        if page.stdout().is_empty() {
            println!("skipped: there is no man here");
            return;
        }
        assert_eq!(folder.read("said"), "", "{command}");
        let text = page.stdout();
        assert!(text.lines().all(|line| line.chars().count() <= 80), "{command}: {text}");
        assert!(!text.contains("EXTRA"), "{command}: {text}");
        if command == "simulate" {
            for line in [
                "         weight_moment = 1.0                # m g l, N m; 0 without gravity",
                "         [body]",
                "         heavytop simulate top.toml --out top.csv",
            ] {
                assert!(text.lines().any(|other| other == line), "{line:?}: {text}");
            }
            // A table of names has its texts beside them, or below.
            let npz = text.lines().position(|line| line.trim_start().starts_with(".npz")).unwrap();
            assert!(
                text.lines().nth(npz).unwrap().contains("for NumPy, the arrays t, Pi,"),
                "{text}"
            );
            assert!(text.contains("EXAMPLES\n"), "{text}");
        }
    }
}
