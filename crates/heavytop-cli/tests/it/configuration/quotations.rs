//! Messages about configurations: they quote the line, mark the value, and offer a repair.

use crate::program::Folder;

/// A command, a configuration, the quoted line, the marked text and the repair.
const QUOTED: &[(&str, &str, &str, &str, &str)] = &[
    // The text is no TOML, or has wrong keys or types.
    ("simulate", "[body]\nmas = 2.0", "mas = 2.0", "mas", "did you mean `mass`?"),
    (
        "simulate",
        "[system]\nalgebra = 'so(3)'\nhamiltonian = 'Pi1'\n[initial]\nPi = [1, 0, 0]",
        "Pi = [1, 0, 0]",
        "Pi",
        "write the state of a system as initial = { ... } in [system]",
    ),
    // Without a system there is no such key in [initial], and no more to say.
    ("simulate", "[initial]\nPi = [1, 0, 0]", "Pi = [1, 0, 0]", "Pi", "there is no such key"),
    ("simulate", "body.colour = 2", "body.colour = 2", "colour", "there is no such key"),
    (
        "simulate",
        "body.mass = 'heavy' # kg",
        "body.mass = 'heavy' # kg",
        "'heavy'",
        "write a number",
    ),
    ("simulate", "output.attitude = 1", "output.attitude = 1", "1", "write a boolean"),
    (
        "simulate",
        "[integrator]\nscheme = 'gaus-4'",
        "scheme = 'gaus-4'",
        "'gaus-4'",
        "did you mean `gauss-4`?",
    ),
    // The text is no TOML, and what was meant is known.
    (
        "simulate",
        "[integrator]\nstep = 0,05",
        "step = 0,05",
        "0,05",
        "write 0.05, with a decimal point",
    ),
    ("simulate", "body.mass = 01", "body.mass = 01", "01", "write 1"),
    (
        "simulate",
        "[body]\nmass\u{a0}= 1",
        "mass\u{a0}= 1",
        "\u{a0}",
        "delete the invisible character U+00A0 (no-break space)",
    ),
    ("simulate", "body.mass = −1", "body.mass = −1", "−", "write - instead of U+2212"),
    // A system: the key at fault, and not the table.
    (
        "simulate",
        "[system]\nalgebra = 'so(3)'\nhamiltonian = ''\ninitial.Pi = [1, 0, 0]",
        "hamiltonian = ''",
        "''",
        "write a formula, such as",
    ),
    (
        "simulate",
        "[system]\nalgebra = 'so(3)'\nhamiltonian = 'Pi1'\ninitial = { Pi = [1, 0, 0], Pi1 = 2 }",
        "initial = { Pi = [1, 0, 0], Pi1 = 2 }",
        "2",
        "leave one of them out",
    ),
    (
        "simulate",
        "[system]\nalgebra = 'so(3)'\nhamiltonian = 'Pi1'\ninitial.Pi = [1, 0, 0]\n[integrator]\n\
         formulation = 'splitting'",
        "formulation = 'splitting'",
        "'splitting'",
        "",
    ),
    (
        "simulate",
        "[system]\nalgebra = 'so(3)'\nhamiltonian = 'Pi1'\ninitial.Pi = [1, 0, 0]\n[integrator]\n\
         scheme = 'stormer-verlet'",
        "scheme = 'stormer-verlet'",
        "'stormer-verlet'",
        "",
    ),
    (
        "simulate",
        "[system]\nalgebra = 'so(3)'\nhamiltonian = 'Pi1'\ninitial.Pi = [1, 0, 0]\n[output]\n\
         attitude = true",
        "attitude = true",
        "true",
        "write false, or leave it out",
    ),
    (
        "simulate",
        "[system]\nalgebra = 'so(3)'\nbrackets = { 'x, y' = 'x' }\nhamiltonian = 'x'\ninitial.x = 1",
        "brackets = { 'x, y' = 'x' }",
        "{ 'x, y' = 'x' }",
        "leave out all but one",
    ),
    // A run that is too long: its end, or its step where that is farther from the usual one.
    (
        "simulate",
        "[integrator]\nstep = 0.01\nend = 1e12",
        "end = 1e12",
        "1e12",
        "write 100 times less",
    ),
    (
        "simulate",
        "[integrator]\nstep = 1e-12\nend = 1000",
        "step = 1e-12",
        "1e-12",
        "write 1000 times as much, or more",
    ),
    // A value is out of its range.
    ("simulate", "[body]\n\ninertia = [2, -2, 1]", "inertia = [2, -2, 1]", "-2", "write 2"),
    ("animate", "body.mass = 0", "body.mass = 0", "0", "write a number above 0"),
    ("simulate", "body.gravity = -9.81", "body.gravity = -9.81", "-9.81", "write 9.81"),
    ("compare", "body.mass = inf", "body.mass = inf", "inf", "write a finite number"),
    (
        "simulate",
        "body.inertia = [2, 2, 5]",
        "body.inertia = [2, 2, 5]",
        "[2, 2, 5]",
        "the largest must be at most 4",
    ),
    (
        "simulate",
        "body.center_of_mass = [3, 4, 0]",
        "body.center_of_mass = [3, 4, 0]",
        "[3, 4, 0]",
        "write [0.6, 0.8, 0.0], or `normalise = true`",
    ),
    (
        "simulate",
        "initial.vertical = [0, 0, 2]",
        "initial.vertical = [0, 0, 2]",
        "[0, 0, 2]",
        "write [0.0, 0.0, 1.0]",
    ),
    ("simulate", "integrator.end = 1.01", "integrator.end = 1.01", "1.01", "write 1 or 1.02"),
    (
        "simulate",
        "integrator.step = 0.03",
        "integrator.step = 0.03",
        "0.03",
        "does not divide the end",
    ),
    ("simulate", "output.every = 0", "output.every = 0", "0", "must be at least 1"),
    (
        "simulate",
        "integrator.tolerance = -1",
        "integrator.tolerance = -1",
        "-1",
        "must be finite and not negative",
    ),
    (
        "simulate",
        "integrator = { step = 100, end = 100 }",
        "integrator = { step = 100, end = 100 }",
        "100",
        "write at most 1.856e1",
    ),
    (
        "simulate",
        "integrator.formulation = 'splitting'",
        "integrator.formulation = 'splitting'",
        "'splitting'",
        "write `scheme` too, such as `strang`",
    ),
    (
        "simulate",
        "[integrator]\nscheme = 'rk4'\nformulation = 'reduced'",
        "scheme = 'rk4'",
        "'rk4'",
        "write `implicit-midpoint`, or another of its schemes",
    ),
    // Two keys say the same thing.
    (
        "simulate",
        "[initial]\nangular_momentum = [1, 0, 0]\nangular_velocity = [2, 0, 0]",
        "angular_velocity = [2, 0, 0]",
        "[2, 0, 0]",
        "write one of them",
    ),
    (
        "simulate",
        "initial = { vertical = [0, 0, 1], inclination = 0.25 }",
        "initial = { vertical = [0, 0, 1], inclination = 0.25 }",
        "0.25",
        "write one of them",
    ),
    ("simulate", "[initial]\nazimuth = 1.5", "azimuth = 1.5", "1.5", "write both"),
    (
        "simulate",
        "initial.inclination = nan",
        "initial.inclination = nan",
        "nan",
        "write an angle from 0 to π",
    ),
    ("simulate", "initial.inclination = 30", "initial.inclination = 30", "30", "write \"30 deg\""),
    ("section", "section.energy = -9", "section.energy = -9", "-9", "write more than "),
    ("section", "section.starts = 0", "section.starts = 0", "0", "must be at least 1"),
    ("section", "section.level = 2", "section.level = 2", "2", "more than -1 and less than 1"),
    ("sweep", "sweep.observables = []", "sweep.observables = []", "[]", "write one, such as"),
    ("sweep", "sweep.axes = []", "sweep.axes = []", "[]", "add a table [[sweep.axes]]"),
];

#[test]
fn messages_quote_the_line_mark_the_value_and_offer_a_repair() {
    for (command, text, line, marked, repair) in QUOTED {
        let folder = Folder::new();
        folder.write("a.toml", text);
        let out = ["a.csv", "a.html"][usize::from(*command == "animate")];
        let run = folder.heavytop(&[command, "a.toml", "--out", out]);
        let said = run.stderr();
        let lines: Vec<&str> = said.lines().collect();
        assert_eq!((run.code(), lines.len()), (2, 4), "{text}: {said}");
        let number = text.lines().position(|other| other == *line).unwrap() + 1;
        assert_eq!(lines[2], format!("{number} | {line}"), "{said}");
        assert!(lines[0].contains(&format!("a.toml, line {number}, column ")), "{said}");
        // The mark is under the value, and as long.
        let from = lines[3].find('^').unwrap();
        let to = from + lines[3][from..].chars().take_while(|c| *c == '^').count() - 1;
        let under: String = lines[2].chars().skip(from).take(to + 1 - from).collect();
        assert_eq!(under, *marked, "{said}");
        assert!(lines[3][to + 1..].contains(repair), "{said}");
    }
}

/// Negative control: what no text says is not quoted.
#[test]
fn what_no_text_says_is_not_quoted() {
    let folder = Folder::new();
    folder.write("a.toml", "[body]\nmass = 2.0");
    for arguments in [
        &["simulate", "a.toml", "--out", "a.xls"][..],
        &["simulate", "a.toml", "--out", "a.csv", "--checkpoint-interval", "-1"],
        &["simulate", "missing.toml", "--out", "a.csv"],
    ] {
        let run = folder.heavytop(arguments);
        assert_eq!((run.code(), run.stderr().lines().count()), (2, 1), "{}", run.stderr());
        assert!(!run.stderr().contains('^'));
    }
}
