//! The closing line of a command.

use crate::program::Folder;

#[test]
#[ignore = "long"]
fn a_run_ends_with_a_line_about_its_file() {
    let folder = Folder::new();
    let end = ["--set", "integrator.end=1", "--set", "output.every=7"];
    let simulate = |more: &[&str]| {
        folder.heavytop(&[&["simulate", "--out", "a.csv"], &end[..], more].concat())
    };
    let run = simulate(&[]);
    let said = run.stderr();
    // The steps 0, 7, ..., 49 and the last one.
    assert_eq!(folder.read("a.csv").lines().count(), 1 + 9);
    assert!(said.starts_with("heavytop: done: 9 rows in a.csv; largest deviations"), "{said}");
    assert!(said.contains(" h ") && said.contains(" f1 ") && said.ends_with(" s\n"), "{said}");
    assert_eq!((run.code(), said.lines().count(), run.stdout()), (0, 1, String::new()));
    // What was left out is named.
    assert!(said.contains("; by collective, gauss-8, step 0.02 s, to 1 s; "), "{said}");
    // The summary in JSON says the same, and --quiet nothing.
    let json = simulate(&["--json"]);
    assert!(json.stdout().contains("\"rows\": 9") && json.stderr().is_empty());
    assert!(simulate(&["--quiet"]).stderr().is_empty());

    let page = folder.heavytop(&[&["animate", "--out", "a.html"], &end[..]].concat());
    let said = page.stderr();
    assert!(said.starts_with("heavytop: done: 9 frames to t = 1 s, in a.html; "), "{said}");
    assert!(said.contains("; by collective, gauss-8, step 0.02 s, to 1 s; "), "{said}");
    // A command whose summary goes to stdout says on stderr that it is done, and the time.
    let small =
        ["section", "--out", "a", "--set", "section.starts=2", "--set", "section.crossings=3"];
    let section = folder.heavytop(&small);
    let said = section.stderr();
    assert!(said.starts_with("heavytop: done; ") && said.ends_with(" s\n"), "{said}");
    assert!(section.stdout().ends_with("picture and table are in a\n"));
    assert!(folder.heavytop(&[&small[..], &["--quiet"]].concat()).stderr().is_empty());

    // Every command that opens a body names what it takes from elsewhere.
    folder.write("body.toml", "body.inertia = [2, 2, 1.5]");
    for command in [
        "simulate body.toml --out b.csv --set integrator.end=1",
        "animate body.toml --out b.html --set integrator.end=1",
        "section body.toml --out b --set section.starts=2 --set section.crossings=3",
        "bench body.toml --tops 2 --only Gauss-12",
    ] {
        let run = folder.heavytop(&command.split(' ').collect::<Vec<_>>());
        let said = run.stderr();
        assert_eq!(run.code(), 0, "{command}: {said}");
        assert!(said.contains("heavytop: left out, and taken from "), "{command}: {said}");
        assert!(said.contains("body.weight_moment = 1.0"), "{command}: {said}");
    }

    // Negative control: a run that fails has no such line.
    let fail = ["--set", "integrator.step=0.5", "--set", "integrator.scheme=lobatto-iiia-iiib-4"];
    let failed = simulate(&fail);
    assert_eq!(failed.code(), 1);
    assert!(!failed.stderr().contains("done"), "{}", failed.stderr());
}
