//! `heavytop simulate`: what it refuses, and how runs fail.

use crate::program::{Folder, heavytop, numbers};

/// Wrong configurations, and texts in the messages about them.
const WRONG: &[(&str, &str)] = &[
    ("[body]\nmass = 1.0\nmas = 2.0", "a.toml, line 3, column 1: unknown key `mas`"),
    ("[body]\nmas = 2.0", "; did you mean `mass`?"),
    ("[body]\nintertia = 2.0", "; did you mean `inertia`?"),
    ("[integrator]\nscheme = 'gaus-4'", "; did you mean `gauss-4`?"),
    ("\n[bodi]", "a.toml, line 2, column 2: unknown key `bodi`"),
    (
        "[body]\n\nmass = 'heavy'",
        "a.toml, line 3, column 8: body.mass: invalid type: string \"heavy\", expected a number",
    ),
    (
        "[body]\ninertia = [1.0, 1.0]",
        "a.toml, line 2, column 11: body.inertia: invalid length 2, expected an array of length 3",
    ),
    (
        "[body]\ninertia = [1, 2, 3, 4]",
        "a.toml, line 2, column 11: body.inertia: invalid length 4, expected an array of length 3",
    ),
    (
        "body.inertia = [1, 2, true]",
        "line 1, column 23: body.inertia[2]: invalid type: boolean `true`, expected a number",
    ),
    ("body = 3", "line 1, column 8: body: invalid type: integer `3`, expected a table"),
    (
        "noise.rule = 3",
        "line 1, column 14: noise.rule: invalid type: integer `3`, expected a string",
    ),
    // An array has no keys, whose places would have to be guessed.
    ("output = [5]", "line 1, column 10: output: invalid type: sequence, expected a table"),
    (
        "sweep.axes = [['body.mass', 1.0]]",
        "sweep.axes[0]: invalid type: sequence, expected a table",
    ),
    (
        "[output]\nevery = 1.5",
        "a.toml, line 2, column 9: output.every: invalid type: floating point `1.5`, expected a whole number from 0 to 9223372036854775807",
    ),
    (
        "output.every = 1e308",
        "output.every: invalid type: floating point `1e308`, expected a whole number",
    ),
    (
        "[output]\nevery = -1",
        "a.toml, line 2, column 9: output.every: invalid value: integer `-1`, expected a whole number from 0 to",
    ),
    (
        "sweep.axes = [{ parameter = 'body.mass' }, { from = 1 }]",
        "line 1, column 44: sweep.axes[1]: missing key `parameter`",
    ),
    (
        "sweep.axes = [{ parameter = 'body.mass', to = 'x' }]",
        "line 1, column 47: sweep.axes[0].to: invalid type: string \"x\", expected a number",
    ),
    (
        "[output]\nevery = 99999999999999999999",
        "floating point `100000000000000000000.0`, expected a whole number from 0 to",
    ),
    ("[body\nmass = 1", "a.toml, line 1, column 6: "),
    (
        "[integrator]\nscheme = 'euler'",
        "line 2, column 10: integrator.scheme: unknown scheme `euler`; there are implicit-midpoint, spherical-midpoint, gauss-4, gauss-6, gauss-8, gauss-10, gauss-12, gauss-16, explicit-midpoint, rk4",
    ),
    (
        "integrator.formulation = 'x'",
        "line 1, column 26: integrator.formulation: unknown formulation `x`; there are collective, reduced, direct, splitting",
    ),
    (
        "integrator.formulation = 'splitting'",
        "splitting has no scheme gauss-8; it has strang, yoshida-4, suzuki-4, yoshida-6, kahan-li-6, kahan-li-8",
    ),
    ("initial.vertical = [0.5, 0.0, 0.8]", "[initial] vertical must be a unit vector"),
    ("initial.vertical = [nan, 0.0, 1.0]", "[initial] vertical must be a unit vector"),
    ("initial.angular_momentum = [1, inf, 0]", "angular_momentum must be finite, got inf"),
    ("initial.angular_momentum = [1e308, 1e308, 1e308]", "turns the motion by about inf rad"),
    ("body.center_of_mass = [1, 1, 0]", "[body] center_of_mass must be a unit vector"),
    ("body.inertia = [2, -2, 1]", "[body] inertia[1] must not be negative, got -2"),
    (
        "body.inertia = [2, 2, 0]",
        "[body] inertia[2] = 0 is a thin rod, whose centre of mass lies on it",
    ),
    ("body.inertia = [2, 0, 0]", "[body] inertia[1] must be positive, got 0"),
    ("body.weight_moment = -1", "[body] weight_moment must not be negative, got -1"),
    (
        "[body]\nweight_moment = 1\nmass = 2",
        "`weight_moment` excludes `mass`, `gravity` and `length`",
    ),
    (
        "body.inertia_about = 'centre'",
        "unknown variant `centre`, expected `support` or `center-of-mass`",
    ),
    ("body.inertia = [2, 2, 5]", "[body] principal moments must obey the triangle inequality: 5"),
    ("body.mass = 0", "[body] mass must be positive, got 0"),
    ("body.mass = -1e308", "[body] mass must not be negative, got -1e308\n"),
    ("body.inertia = [1e308, 1, 1e-300]", "inequality: 1e308 is more than 1.0 + 1e-300\n"),
    ("body.gravity = -9.81", "[body] gravity must not be negative, got -9.81"),
    ("integrator.step = 0", "step must be finite and different from 0, got 0"),
    ("integrator.step = nan", "step must be finite and different from 0, got NaN"),
    ("integrator.end = 0", "end must be finite and different from 0, got 0"),
    (
        "integrator = { step = -0.02, end = 1 }",
        "steps of -0.02 s do not reach end = 1: a run backward in time has an end before 0",
    ),
    ("integrator.end = -99.99", "the nearest ends are -99.98 and -100"),
    ("integrator.step = 1e-300", "more than 1e12"),
    ("integrator = { step = 1e10, end = 1e10 }", "turns the motion by about 5.387e10 rad"),
    ("integrator.step = 1e300", "a step of 1e300 s turns the motion by about 5.387e300 rad"),
    ("integrator.end = -1e300", "more than 1e12"),
    ("integrator = { step = -1e10, end = -1e10 }", "turns the motion by about 5.387e10 rad"),
    ("initial.angular_momentum = [1e160, 0, 0]", "turns the motion by about"),
    ("integrator.step = 0.03", "the nearest ends are 99.99 and 100.02"),
    ("integrator = { step = 0.5, end = 1.0000001 }", "the nearest ends are 1 and 1.5"),
    ("integrator.tolerance = -1e-9", "tolerance must be finite and not negative"),
    ("output.every = 0", "every must be at least 1, got 0"),
    (
        "output.attitude = 1",
        "line 1, column 19: output.attitude: invalid type: integer `1`, expected a boolean",
    ),
    (
        "integrator.formulation = 'direct'\noutput.attitude = true",
        "direct has no attitude: its six equations do not determine it; collective, reduced and splitting have one",
    ),
];

#[test]
fn what_is_wrong_is_said_in_one_message_and_nothing_is_written() {
    for (text, message) in WRONG {
        let folder = Folder::new();
        folder.write("a.toml", text);
        let run = folder.heavytop(&["simulate", "a.toml", "--out", "a.csv"]);
        let said = run.stderr();
        assert_eq!(run.code(), 2, "{text}: {said}");
        assert!(said.contains(message), "{text}: {said}");
        assert_eq!(run.messages(), 1, "{text}: {said}");
        assert!(said.lines().count() <= 4, "{text}: {said}");
        assert_eq!(folder.names(), ["a.toml"], "{text}");
    }
}

/// A message is short, however long the thing is that it is about.
#[test]
#[ignore = "long"]
fn what_is_long_is_said_in_a_few_words() {
    let long = "x".repeat(500_000);
    let many = "x ".repeat(250_000);
    for (text, parts) in [
        (
            format!("body.mass = '{long}'"),
            ["body.mass: invalid type: string \"xx", "…\", expected a number"],
        ),
        (
            format!("body.mass = '{many}'"),
            ["body.mass: invalid type: string \"x x", ", expected a number"],
        ),
        (format!("body.{long} = 1"), ["unknown key `xx", "…`, expected one of `inertia`"]),
        (format!("integrator.scheme = '{long}'"), ["unknown scheme `xx", "…`; there are implicit"]),
        (format!("body.mass = {}", "9".repeat(500_000)), ["line 1, column 13: ", "overflow"]),
        // A message does not control the terminal.
        ("body.\"\\u001b[2J\" = 1".into(), ["unknown key `\\u{1b}[2J`", "expected one of"]),
    ] {
        let folder = Folder::new();
        folder.write("a.toml", &text);
        let run = folder.heavytop(&["simulate", "a.toml", "--out", "a.csv"]);
        let said = run.stderr();
        assert_eq!(run.code(), 2);
        assert!(parts.iter().all(|part| said.contains(part)), "{said}");
        assert!(said.chars().count() < 1000 && said.lines().count() == 4, "{said}");
        assert!(said.lines().skip(1).all(|line| line.chars().count() < 160), "{said}");
    }
}

/// A file that has no end is not read to its end.
#[test]
#[cfg(unix)]
fn an_endless_file_is_refused() {
    let folder = Folder::new();
    let endless = "it has more than 1048576 bytes\n";
    for (arguments, message) in [
        (&["simulate", "/dev/zero", "--out", "a.csv"][..], endless),
        (&["sweep", "/dev/zero", "--out", "a"], endless),
        (
            &["simulate", "--out", "a.csv", "--resume", "/dev/zero"],
            "it has more than 16777216 bytes",
        ),
        (&["bench", "--problem", "/dev/zero"], "…` is no number\n"),
    ] {
        let run = folder.heavytop(arguments);
        assert_eq!(run.code(), 2, "{arguments:?}");
        assert!(run.stderr().contains(message), "{}", run.stderr());
        assert!(folder.names().is_empty());
    }
    // A file of exactly a mebibyte is accepted.
    folder.write("a.toml", &format!("integrator.end = 0.1\n#{}", " ".repeat((1 << 20) - 22)));
    assert_eq!(folder.path("a.toml").metadata().unwrap().len(), 1 << 20);
    assert_eq!(folder.heavytop(&["simulate", "a.toml", "--out", "a.csv"]).code(), 0);
}

#[test]
fn an_end_that_is_whole_to_nine_digits_is_accepted() {
    let folder = Folder::new();
    folder.write("a.toml", "integrator = { step = 0.5, end = 1.0000000005 }");
    assert_eq!(folder.heavytop(&["simulate", "a.toml", "--out", "a.csv"]).code(), 0);
    assert_eq!(numbers(&folder.read("a.csv")).1.len(), 3);
}

#[test]
fn names_that_cannot_be_written_are_refused_before_the_run() {
    for (out, message) in [
        ("missing/a.csv", "cannot create missing/a.csv: No such file"),
        ("missing/a.npz", "cannot create missing/a.npz: No such file"),
        ("a.xlsx", "cannot write a.xlsx: the name must end in .csv, .npz or .parquet"),
        ("a", "cannot write a: the name must end in .csv"),
        (".", "the name must end in .csv"),
        ("folder.csv", "cannot create folder.csv: is a directory"),
    ] {
        let folder = Folder::new();
        std::fs::create_dir(folder.path("folder.csv")).unwrap();
        let run = folder.heavytop(&["simulate", "--out", out]);
        assert_eq!(run.code(), 2, "{out}");
        assert!(run.stderr().contains(message), "{out}: {}", run.stderr());
        assert_eq!(folder.names(), ["folder.csv"], "{out}");
    }
}

#[test]
fn a_missing_configuration_and_wrong_arguments_are_refused() {
    for arguments in [
        &["simulate", "missing.toml", "--out", "a.csv"][..],
        &["simulate"],
        &["simulate", "--out", "a.csv", "--fast"],
        &["simulate", "--out", "a.csv", "--preset", "kovalevski"],
        &["simulate", "--out", "a.csv", "--checkpoint-interval", "-1"],
        &["simulate", "--out", "a.csv", "--checkpoint-interval", "nan"],
        &["simulate", "--out", "a.csv", "--resume", "a.csv.checkpoint"],
        &["completions", "tcl"],
        &["levitate"],
        &[],
    ] {
        let folder = Folder::new();
        let run = folder.heavytop(arguments);
        assert_eq!(run.code(), 2, "{arguments:?}");
        assert!(!run.stderr().is_empty());
        assert!(folder.names().is_empty());
    }
}

/// γ grows as e^{0.64 t}, so that it overflows at t = 1100.
#[test]
#[ignore = "long"]
fn a_motion_to_infinity_ends_with_an_error_that_says_so() {
    let folder = Folder::new();
    let system = "system = { algebra = 'sl(2)', hamiltonian = 'alpha^2/2 + 0.3*beta*gamma + 0.1*beta^2', \
                  initial = { alpha = 0.3, beta = 0.5, gamma = -0.2 } }\n";
    for formulation in ["direct", "collective"] {
        let integrator =
            format!("integrator = {{ formulation = '{formulation}', step = 0.25, end = 1500 }}");
        folder.write("a.toml", &format!("{system}{integrator}"));
        let run = folder.heavytop(&["simulate", "a.toml", "--out", "a.csv", "--force"]);
        let said = run.stderr();
        assert_eq!(run.code(), 1, "{said}");
        assert!(said.contains("the motion goes to infinity there"), "{said}");
        assert!(numbers(&folder.read("a.csv.partial")).1.len() > 4000);
    }
}

#[test]
fn stages_that_do_not_converge_end_the_run_and_keep_what_there_is() {
    let folder = Folder::new();
    folder
        .write("a.toml", "integrator = { step = 0.5, end = 10.0, scheme = 'lobatto-iiia-iiib-4' }");
    let old = "t,Pi1,Pi2,Pi3,Gamma1,Gamma2,Gamma3,h,f1,f2\n0.0,1,1,1,1,0,0,3,1,1\n";
    folder.write("a.csv", old);
    let run = folder.heavytop(&["simulate", "a.toml", "--out", "a.csv"]);
    assert_eq!(run.code(), 1);
    let said = run.stderr();
    for part in ["step 1 at t = 0: ", "did not converge: residual ", "is in ", "a.csv.partial"] {
        assert!(said.contains(part), "{said}");
    }
    // The output is the warning that the scheme does not descend, and the error.
    assert_eq!(run.complaints().lines().count(), 2, "{said}");
    assert_eq!(folder.names(), ["a.csv", "a.csv.partial", "a.toml"]);
    assert_eq!(folder.read("a.csv"), old);
    assert_eq!(numbers(&folder.read("a.csv.partial")).1.len(), 1);
}

#[test]
fn a_state_that_is_not_finite_ends_the_run_and_keeps_what_there_is() {
    let folder = Folder::new();
    let integrator = "step = 2.0\nend = 100.0\nformulation = 'direct'\nscheme = 'rk4'";
    folder.write("a.toml", &format!("[integrator]\n{integrator}"));
    let run = folder.heavytop(&["simulate", "a.toml", "--out", "a.csv"]);
    assert_eq!(run.code(), 1);
    // The square |Γ|² is too large for a number before Γ is.
    assert!(run.stderr().contains("the invariant f1 is not finite"), "{}", run.stderr());
    assert_eq!(folder.names(), ["a.csv.partial", "a.toml"]);
    let (_, rows) = numbers(&folder.read("a.csv.partial"));
    assert!(!rows.is_empty() && rows.iter().flatten().all(|x| x.is_finite()));
}

#[test]
#[cfg(target_os = "linux")]
fn a_full_disk_is_reported() {
    let folder = Folder::new();
    let run = folder.heavytop(&["simulate", "--out", "/dev/full"]);
    assert_eq!(run.code(), 1);
    assert!(run.stderr().contains("cannot write /dev/full: No space left on device"));
}

#[test]
#[cfg(target_os = "linux")]
fn help_that_cannot_be_written_is_a_failure() {
    let heavytop = heavytop();
    for arguments in ["help", "--help", "--version", "help sweep", "completions bash"] {
        let script = format!("{heavytop} {arguments} >/dev/full");
        let done = std::process::Command::new("sh").args(["-c", &script]).output().unwrap();
        let said = String::from_utf8(done.stderr).unwrap();
        assert_eq!(done.status.code(), Some(1), "{arguments}: {said}");
        assert!(said.starts_with("heavytop: cannot write standard output: No space"), "{said}");
        // A reader that reads no more than the beginning has read enough.
        let script = format!("{heavytop} {arguments} | head -c 1 >/dev/null");
        let done = std::process::Command::new("sh").args(["-c", &script]).output().unwrap();
        assert!(done.status.success() && done.stderr.is_empty(), "{arguments}");
    }
}

#[test]
fn help_and_version_are_there() {
    let folder = Folder::new();
    for arguments in [
        &["--help"][..],
        &["--version"],
        &["reproduce", "--help"],
        &["simulate", "--help"],
        &["compare", "--help"],
        &["section", "--help"],
        &["animate", "--help"],
        &["completions", "--help"],
        &["completions", "bash"],
        &["completions", "zsh"],
        &["completions", "fish"],
    ] {
        let run = folder.heavytop(arguments);
        assert_eq!((run.code(), run.stderr()), (0, String::new()), "{arguments:?}");
        assert!(!run.stdout().is_empty());
    }
}
