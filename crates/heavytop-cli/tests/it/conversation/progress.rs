//! The progress bar, as a terminal shows it.

use crate::program::{Folder, heavytop, in_terminal};

/// Returns the lines that a terminal of 80 columns shows one after the other, without control sequences.
fn drawn(said: &str) -> Vec<String> {
    let mut lines = Vec::new();
    for piece in said.split(['\r', '\n']) {
        let mut line = String::new();
        let mut characters = piece.chars();
        while let Some(c) = characters.next() {
            if c != '\u{1b}' {
                line.push(c);
            } else if let Some('[') = characters.next() {
                // A sequence ends with a letter.
                let _ = characters.find(|c| c.is_ascii_alphabetic());
            }
        }
        lines.push(line);
    }
    lines
}

#[test]
#[ignore = "long"]
fn a_bar_shows_from_the_first_second_on_and_fits_the_terminal() {
    let heavytop = heavytop();
    let long = "--set integrator.scheme=gauss-16 --set integrator.end=1e5 --set output.every=1000";
    // Each takes seconds, also in a release.
    for (command, kind) in [
        (format!("simulate {long} --out a.csv"), "/5.0M steps"),
        ("sweep --set integrator.end=30 --out map --threads 1".into(), "/1024 tops"),
    ] {
        let folder = Folder::new();
        // By exec, so that no shell is left that reports the end by a signal in the line of the bar.
        let limited = format!("stty cols 80; exec timeout -s KILL 30 {heavytop} {command}");
        let Some(said) = in_terminal(&folder, &limited, "") else { return };
        let bars: Vec<String> = drawn(&said).into_iter().filter(|l| l.contains(kind)).collect();
        assert!(!bars.is_empty(), "{said:?}");
        for bar in bars {
            assert!(bar.chars().count() <= 80 && bar.contains("left"), "{bar:?}");
        }
        // Negative control: --quiet hides it.
        let quiet =
            format!("stty cols 80; exec timeout -s KILL 2 {heavytop} {command} --quiet --restart");
        let said = in_terminal(&folder, &quiet, "").unwrap();
        assert!(!said.contains(kind), "{said:?}");
    }
}
