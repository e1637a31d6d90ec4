//! Fluids on the sphere with `[damping]`, `[torque]` and `[noise]`.

use crate::program::{Finished, Folder, numbers};

/// A fluid that is stirred and damped.
const STIRRED: &str = "\
[system]
kind = 'sphere-fluid'
parameters = { size = 8 }
initial.degrees = [2, 4]

[damping]
viscosity = 0.01
drag = 0.1

[torque]
coefficients = [[3, 0, 0.1, 0]]

[noise]
transport = { degrees = [2, 3], strength = 0.01 }
stirring = [{ degrees = [3, 4], strength = 0.1 }, { degrees = [5, 5], strength = 0.05 }]

[integrator]
step = 0.05
end = 2

[output]
every = 20
";

fn succeeded(done: &Finished) -> String {
    assert_eq!(done.code(), 0, "{}", done.stderr());
    done.stderr()
}

/// All terms have a part in the run, and the closing line tells that nothing is kept. All formats and pictures have it.
#[test]
fn every_key_matters_and_every_output_has_the_run() {
    let folder = Folder::new();
    folder.write("a.toml", STIRRED);
    let told = succeeded(&folder.heavytop(&["simulate", "a.toml", "--out", "a.csv"]));
    for part in [
        "noise of seed 1, path 0; largest changes, of what the motion does not keep, M1 ",
        "of this path; by reduced, implicit-midpoint, step 0.05 s",
    ] {
        assert!(told.contains(part), "{told}: {part}");
    }
    let (header, found) = numbers(&folder.read("a.csv"));
    assert_eq!(header[65..].join(","), "h,Z,M3,M1,M2");
    for set in [
        "damping.viscosity=0.02",
        "damping.power=2",
        "damping.drag=0.2",
        "torque.coefficients=[[3, 0, 0.2, 0]]",
        "noise.transport.strength=0.02",
        "noise.stirring=[]",
        "noise.seed=2",
        "noise.path=1",
        "noise.interval=0.1",
        "noise.bound=1",
    ] {
        let arguments = ["simulate", "a.toml", "--out", "b.csv", "--force", "--set", set];
        succeeded(&folder.heavytop(&arguments));
        let (_, other) = numbers(&folder.read("b.csv"));
        assert_ne!(other[2], found[2], "{set}");
    }
    let done = folder.heavytop(&["simulate", "a.toml", "--out", "c.npz", "--dry-run"]);
    succeeded(&done);
    assert!(done.stdout().contains("3 rows"), "{}", done.stdout());
    for (out, more) in [("a.npz", &["--check", "--json"][..]), ("a.parquet", &[])] {
        succeeded(&folder.heavytop(&[&["simulate", "a.toml", "--out", out], more].concat()));
    }
    succeeded(&folder.heavytop(&["plot", "a.npz", "--out", "a.svg"]));
    let picture = folder.read("a.svg");
    for part in ["viscosity 0.01", "drag 0.1", "noise of seed 1, path 0", "implicit-midpoint"] {
        assert!(picture.contains(part), "{part}");
    }
    // A start in an archive goes on with it.
    let next = STIRRED.replace("initial.degrees = [2, 4]", "initial_file = 'a.npz'");
    folder.write("b.toml", &next);
    succeeded(&folder.heavytop(&["simulate", "b.toml", "--out", "d.csv"]));
}

/// Of transport noise alone the enstrophy is kept to round-off, and told so; a run backward has it, too.
#[test]
fn transport_noise_keeps_the_enstrophy() {
    let folder = Folder::new();
    let (first, rest) = STIRRED.split_once("[damping]").unwrap();
    let (_, rest) = rest.split_once("[noise]").unwrap();
    let text = format!("{first}[noise]{rest}").replace("stirring", "# stirring");
    folder.write("a.toml", &text);
    for end in ["2", "-2"] {
        let end = format!("integrator.end={end}");
        let arguments = ["simulate", "a.toml", "--out", "a.csv", "--force", "--set", &end];
        let told = succeeded(&folder.heavytop(&arguments));
        assert!(told.contains("largest deviations Z ") && told.contains("keep, M1 "), "{told}");
        let (_, rows) = numbers(&folder.read("a.csv"));
        assert!((rows[2][66] - rows[0][66]).abs() < 1e-12 * rows[0][66]);
        assert!((rows[2][65] - rows[0][65]).abs() > 1e-6 * rows[0][65]);
    }
}

/// An interrupted run goes on to the same bytes, and the number of threads does not matter; nor does it for an
/// ensemble.
#[test]
fn a_path_has_the_same_bytes_on_any_number_of_threads() {
    let folder = Folder::new();
    folder
        .write("a.toml", &STIRRED.replace("size = 8", "size = 40").replace("end = 2", "end = 0.2"));
    let bytes = |name: &str| std::fs::read(folder.path(name)).unwrap();
    for (threads, out) in [("1", "one.npz"), ("4", "four.npz")] {
        succeeded(&folder.heavytop_on(threads, &["simulate", "a.toml", "--out", out]));
    }
    assert!(bytes("one.npz") == bytes("four.npz"));
    folder.write("b.toml", STIRRED);
    for (threads, out) in [("1", "one.csv"), ("4", "four.csv")] {
        let arguments = ["ensemble", "b.toml", "--paths", "6", "--out", out];
        let told = succeeded(&folder.heavytop_on(threads, &arguments));
        assert!(told.contains("at the end h ") && told.contains(", Z "), "{told}");
    }
    assert_eq!(folder.read("one.csv"), folder.read("four.csv"));
}

#[test]
fn errors_name_the_value_the_bound_and_the_line() {
    let folder = Folder::new();
    let damping = "viscosity = 0.01\ndrag = 0.1";
    let shell = "{ degrees = [2, 3], strength = 0.01 }";
    for (old, new, parts) in [
        (
            "viscosity = 0.01",
            "viscosity = -1",
            &["0 or a positive number, got -1", "viscosity = -1"][..],
        ),
        (
            "drag = 0.1",
            "drag = nan",
            &["drag must be 0 or a positive number, got NaN", "drag = nan"],
        ),
        ("drag = 0.1", "power = 0", &["a whole number from 1 to 32, got 0", "power = 0"]),
        ("drag = 0.1", "power = 1.5", &["power"]),
        (damping, "", &["viscosity or drag is missing in [damping]"]),
        (damping, "drag = 1\npower = 2", &["viscosity is missing in [damping]"]),
        (
            damping,
            "friction = 1",
            &[
                "damping.friction is of other systems: a sphere-fluid has viscosity",
                "^ leave it out",
            ],
        ),
        (damping, "drag = 1\nform = 'gilbert'", &["damping.form is of other systems"]),
        ("end = 2", "end = -2", &["0 backward in time", "got 0.01", "viscosity = 0.01"]),
        (
            "[[3, 0, 0.1, 0]]",
            "[[8, 0, 0.1, 0]]",
            &["degrees l from 1 to 7", "got l = 8", "coefficients ="],
        ),
        ("[[3, 0, 0.1, 0]]", "[[3, 0, 0.1, 1]]", &["real for m = 0, got im = 1"]),
        ("[[3, 0, 0.1, 0]]", "[[3, 0, 0.1]]", &["rows [l, m, re, im] of numbers"]),
        (
            "[[3, 0, 0.1, 0]]",
            "[]",
            &["coefficients, of rows [l, m, re, im], is missing in [torque]"],
        ),
        ("[[3, 0, 0.1, 0]]", "'cos(t)'", &["coefficients, of rows [l, m, re, im], is missing"]),
        ("coefficients = [[3, 0, 0.1, 0]]", "omega = 1", &["torque.omega is of other systems"]),
        (
            shell,
            "{ degrees = [3, 2], strength = 1 }",
            &["degrees from 1 to 7", "got [3, 2]", "transport ="],
        ),
        (shell, "{ degrees = [2, 3], strength = -1 }", &["0 or positive, got -1"]),
        (shell, "{ degrees = [2, 3] }", &["strength is missing in [noise.transport]"]),
        (shell, "{ strength = 1 }", &["degrees is missing in [noise.transport]"]),
        (shell, "0.1", &["expected a shell, such as { degrees = [8, 10]"]),
        (shell, "{ degrees = [2, 3], strength = 1, l = 3 }", &["unknown key `l`"]),
        (shell, "[[2, 3], 1]", &["transport[0]: invalid type: sequence, expected a table"]),
        ("transport =", "temperature = 1\ntransport =", &["noise.temperature is of other systems"]),
        ("transport =", "strength = 1\ntransport =", &["noise.strength is of other systems"]),
        ("transport =", "rule = 'alternating'\ntransport =", &["noise.rule is of other systems"]),
        ("transport =", "bound = 0.5\ntransport =", &["1 standard deviation or more"]),
        ("transport =", "interval = 1e-9\ntransport =", &["must be at least 0.000005"]),
        (
            "[noise]",
            "[drive]\nomega = 1\n[noise]",
            &["[drive] is for tops", "a sphere-fluid [damping], [noise] and [torque]"],
        ),
        (
            "step = 0.05",
            "step = 0.05\nscheme = 'gauss-8'",
            &[
                "friction, forces or noise has no reduced gauss-8; reduced has implicit-midpoint",
                "^^",
            ],
        ),
        (
            "step = 0.05",
            "step = 0.05\nformulation = 'direct'",
            &["has no direct implicit-midpoint; it has reduced implicit-midpoint"],
        ),
        ("step = 0.05\nend = 2", "step = 200\nend = 200", &["it must be at most 100"]),
    ] {
        let text = STIRRED.replace(old, new);
        assert_ne!(text, STIRRED, "{old}");
        folder.write("a.toml", &text);
        let done = folder.heavytop(&["simulate", "a.toml", "--out", "a.csv"]);
        let told = done.stderr();
        assert_eq!(done.code(), 2, "{new}: {told}");
        assert!(parts.iter().all(|part| told.contains(part)), "{new}: {told}");
        assert_eq!(folder.names(), ["a.toml"], "{new}");
    }
    let (_, noise) = STIRRED.split_once("[noise]").unwrap();
    let (noise, _) = noise.split_once("[integrator]").unwrap();
    // The keys of fluids are of no other system.
    let ring = "[system]\nkind = 'spin-lattice'\nparameters = { shape = [4], exchange = 1 }\ninitial.tilt = 1\n";
    for (text, part) in [
        (
            format!("{ring}[damping]\nviscosity = 1"),
            "damping.viscosity is of other systems: a spin-lattice",
        ),
        (
            format!("{ring}[damping]\nfriction = 1\n[noise]{noise}"),
            "noise.transport is of other systems",
        ),
        (format!("{ring}[torque]\ncoefficients = [[1, 0, 1, 0]]"), "[torque] is for tops"),
        ("[damping]\nviscosity = 1".into(), "damping.viscosity is of other systems: tops"),
        (format!("[noise]{noise}"), "noise.transport is of other systems: tops"),
        ("[torque]\nPi = [[1, 0, 1, 0]]".into(), "torque"),
    ] {
        folder.write("a.toml", &text);
        let done = folder.heavytop(&["simulate", "a.toml", "--out", "a.csv"]);
        let told = done.stderr();
        assert!(done.code() == 2 && told.contains(part), "{text}: {told}");
    }
    folder.write("a.toml", STIRRED);
    for command in ["sweep", "section", "events"] {
        let done = folder.heavytop(&[command, "a.toml", "--out", "a"]);
        assert!(done.code() == 2 && folder.names() == ["a.toml"], "{}", done.stderr());
    }
}
