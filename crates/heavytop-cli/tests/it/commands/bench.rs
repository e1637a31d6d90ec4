//! `heavytop bench`: the table of times and errors, and the problem file.

use crate::program::Folder;

#[test]
fn errors_and_times_are_told_of_what_was_asked_for() {
    let folder = Folder::new();
    let run = folder.heavytop(&["bench", "--only", "collective Gauss-12", "--tops", "2", "--json"]);
    assert_eq!((run.code(), run.stderr()), (0, String::new()));
    let told: serde_json::Value = serde_json::from_str(&run.stdout()).unwrap();
    let runs = told["runs"].as_array().unwrap();
    assert_eq!(runs.len(), 1);
    assert_eq!((&runs[0]["setting"], &runs[0]["steps"]), (&"h = 0.125".into(), &8000.into()));
    // The errors of the method and of the reference, 1e-14 each, grow up to t = 10.
    assert!(runs[0]["error_10"].as_f64().unwrap() < 1e-12, "{told}");
    assert!(runs[0]["seconds"].as_f64().unwrap() > 0.0);
}

#[test]
fn a_problem_in_a_file_has_its_own_references() {
    let folder = Folder::new();
    // Lagrange's sleeping top stays where it is; the second reference says otherwise.
    let problem = "2 2 1 1 0 0 1 20\n0 0 4 0 0 1 0 0 4 0 0 1 0 0 4 0 0 1.5\n";
    folder.write("sleeping.txt", problem);
    let run =
        folder.heavytop(&["bench", "--problem", "sleeping.txt", "--only", "Gauss-12", "--json"]);
    let told: serde_json::Value = serde_json::from_str(&run.stdout()).unwrap();
    assert!(told["runs"][0]["error_10"].as_f64().unwrap() < 1e-14, "{told}");
    assert!((told["runs"][0]["error_end"].as_f64().unwrap() - 0.5).abs() < 1e-14, "{told}");
    // Relative to the largest |Γ| of the problem, 1.5.
    let relative = told["runs"][0]["relative_error_end"].as_f64().unwrap();
    assert!((relative - 1.0 / 3.0).abs() < 1e-14, "{told}");

    for (wrong, why) in [
        ("2 2 1 1 0 0 1 20\n", "no top"),
        ("2 2 1 1 0 0 1 20\n0 0 4 0 0 1\n", "line 2"),
        ("2 2 1 1 0 0 x 20\n", "`x` is no number"),
        ("2 2 1 1 0 0 1 5\n0 0 4 0 0 1 0 0 4 0 0 1 0 0 4 0 0 1\n", "more than 10"),
    ] {
        folder.write("wrong.txt", wrong);
        let run = folder.heavytop(&["bench", "--problem", "wrong.txt"]);
        assert_eq!(run.code(), 2);
        assert!(run.stderr().contains(why), "{}", run.stderr());
    }
}

#[test]
fn wrong_requests_are_refused() {
    let folder = Folder::new();
    for (arguments, message) in [
        (
            &["--only", "Gaus-12", "--tops", "2"][..],
            "no integrator has `Gaus-12` in its name; there are",
        ),
        (&["--only", "Gaus-12", "--tops", "2"], "heavytop collective Gauss-12, "),
        (&["--tops", "1"], "tops must be at least 2 and at most 1e9, got 1"),
        (
            &["--tops", "1000000000001"],
            "tops must be at least 2 and at most 1e9, got 1000000000001",
        ),
        (&["--tops", "-1"], "invalid value '-1' for '--tops <COUNT>'"),
        (&["--threads", "0"], "threads must be at least 1 and at most 1024, got 0"),
        (&["--threads", "1025"], "threads must be at least 1 and at most 1024, got 1025"),
    ] {
        let run = folder.heavytop(&[&["bench"], arguments].concat());
        assert_eq!((run.code(), run.stdout()), (2, String::new()), "{arguments:?}");
        assert!(run.stderr().contains(message), "{arguments:?}: {}", run.stderr());
    }
}
