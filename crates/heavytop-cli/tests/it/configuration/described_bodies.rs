//! The table `[body]`: moments about which point, matrices, thin rods, and what is left out.

use crate::program::Folder;
use nalgebra::{Matrix3, Rotation3, Vector3};

/// A run to t = 2 s of a configuration without `[integrator]`, in which nothing is left out.
fn run(folder: &Folder, text: &str) -> (Vec<Vec<f64>>, String) {
    let integrator = "\n[integrator]\nscheme = 'gauss-8'\nstep = 0.02\nend = 2\n";
    folder.write("a.toml", &format!("{text}{integrator}"));
    let run = folder.heavytop(&["simulate", "a.toml", "--out", "a.csv"]);
    assert_eq!(run.code(), 0, "{text}\n{}", run.stderr());
    let rows = folder.read("a.csv");
    let numbers = |line: &str| line.split(',').map(|x| x.parse().unwrap()).collect();
    (rows.lines().skip(1).map(numbers).collect(), run.stderr())
}

const START: &str =
    "\n[initial]\nangular_momentum = [0.5, 1.2, -0.8]\nvertical = [0.6, 0.0, 0.8]\n";

/// A laboratory gyroscope whose moments are those about its own centre.
const GYROSCOPE: &str = "[body]\ninertia = [2e-4, 2e-4, 3e-4]\nmass = 0.5\ngravity = 9.81\nlength = 0.04\n\
                         center_of_mass = [0, 0, 1]\n[initial]\nangular_momentum = [0, 0, 0.03]\n\
                         vertical = [0.6, 0, 0.8]\n[integrator]\nscheme = 'gauss-8'\nstep = 1e-3\nend = 0.01\n";

#[test]
#[ignore = "long"]
fn impossible_moments_are_told_by_every_command() {
    let folder = Folder::new();
    folder.write("a.toml", GYROSCOPE);
    let axis = "sweep.axes=[{parameter='initial.angular_momentum[0]', from=0, to=1e-3, count=2}]";
    let small = ["section.starts=1", "section.crossings=1", "section.longest=0.1"];
    let small = small.iter().flat_map(|key| ["--set", key]);
    let commands: [(&str, Vec<&str>); 5] = [
        ("a.csv", vec!["simulate"]),
        ("a.html", vec!["animate"]),
        ("compare", vec!["compare"]),
        ("section", ["section"].into_iter().chain(small).collect()),
        ("sweep", vec!["sweep", "--set", axis]),
    ];
    for (out, command) in commands {
        let run = folder.heavytop(&[&command[..], &["a.toml", "--out", out]].concat());
        let text = run.stderr();
        assert_eq!(run.code(), 0, "{text}");
        for part in ["warning: [body] no body has these moments", "0.0008", "inertia_about"] {
            assert!(text.contains(part), "{command:?}: {text}");
        }
        // The controls: about the centre of mass they are those of a body; a product of all three tells nothing of one.
        let central = ["--set", "body.inertia_about=center-of-mass"];
        let product = ["--set", "body.weight_moment=0.2"];
        if command[0] == "compare" {
            // It takes the longest by far.
            continue;
        }
        for (number, control) in [central, product].into_iter().enumerate() {
            let out = format!("{number}{out}");
            let run =
                folder.heavytop(&[&command[..], &["a.toml", "--out", &out], &control].concat());
            assert_eq!(run.code(), 0, "{}", run.stderr());
            assert!(!run.stderr().contains("no body"), "{control:?}: {}", run.stderr());
        }
    }
    // The tops by name fix m g l alone, and say so.
    for preset in
        ["kovalevskaya", "lagrange", "euler", "goryachev-chaplygin", "multibody-benchmark"]
    {
        let end = ["--set", "integrator.end=0.1", "--set", "integrator.step=0.0125"];
        let run = folder
            .heavytop(&[&["simulate", "--preset", preset, "--out", "b.csv"], &end[..]].concat());
        assert!(!run.stderr().contains("warning: [body]"), "{preset}: {}", run.stderr());
        let text = folder.heavytop(&["init", "--preset", preset]).stdout();
        let is_product = text.contains("\nweight_moment = ");
        assert_eq!(is_product, preset != "multibody-benchmark", "{text}");
        assert!(text.contains("about the support"), "{text}");
    }
}

/// I_support = I_cm + m l² (1 − ccᵀ), for a centre of mass on an axis and for one on none.
#[test]
fn moments_about_the_centre_of_mass_are_moved_to_the_support() {
    let folder = Folder::new();
    let body = |moments: &str, about: &str| {
        let text = format!(
            "[body]\ninertia = {moments}\ninertia_about = '{about}'\nmass = 2\ngravity = 3\nlength = 0.5\n\
             center_of_mass = [0.48, 0.6, 0.64]\n{START}"
        );
        run(&folder, &text).0
    };
    let c = Vector3::new(0.48, 0.6, 0.64);
    let moved = Matrix3::from_diagonal(&Vector3::new(1.0, 1.2, 1.5))
        + (Matrix3::identity() - c * c.transpose()) * 0.5;
    let rows: Vec<_> =
        moved.row_iter().map(|row| format!("{:?}", row.iter().collect::<Vec<_>>())).collect();
    let (central, support) = (
        body("[1, 1.2, 1.5]", "center-of-mass"),
        body(&format!("[{}]", rows.join(",")), "support"),
    );
    for (one, other) in central.iter().zip(&support) {
        assert!(one.iter().zip(other).all(|(a, b)| (a - b).abs() < 1e-13), "{one:?} {other:?}");
    }
    // The control: about the support they are another body's.
    let other = body("[1, 1.2, 1.5]", "support");
    assert!((central[100][1] - other[100][1]).abs() > 1e-3);
    // Without the mass and the length there is nothing to move them by.
    for keys in ["inertia_about = 'center-of-mass'", "inertia_about = 'center-of-mass'\nmass = 2"] {
        folder.write("b.toml", &format!("[body]\n{keys}"));
        let run = folder.heavytop(&["simulate", "b.toml", "--out", "b.csv"]);
        assert_eq!(run.code(), 2, "{}", run.stderr());
        assert!(run.stderr().contains("needs mass and length"), "{}", run.stderr());
    }
}

/// A rotated body, with a rotated centre of mass and start, has the rotated motion; the run says which axes it found.
#[test]
fn a_matrix_moves_in_its_own_axes() {
    let folder = Folder::new();
    let rotation = Rotation3::from_euler_angles(0.4, -1.1, 2.3).into_inner();
    let list = |v: &Vector3<f64>| format!("{:?}", v.iter().collect::<Vec<_>>());
    let body = |inertia: &str, c: &Vector3<f64>, v: &Vector3<f64>, g: &Vector3<f64>| {
        let text = format!(
            "[body]\ninertia = {inertia}\nweight_moment = 1.3\ncenter_of_mass = {}\nnormalise = true\n\
             [initial]\nangular_velocity = {}\nvertical = {}\nnormalise = true\n[output]\nattitude = true\n",
            list(c),
            list(v),
            list(g)
        );
        run(&folder, &text)
    };
    let (c, v, g) =
        (Vector3::new(0.48, 0.6, 0.64), Vector3::new(0.5, 1.2, -0.8), Vector3::new(0.6, 0.0, 0.8));
    for moments in [[1.0, 1.7, 2.2], [2.0, 2.0, 1.0], [1.4, 1.4, 1.4]] {
        let diagonal = Matrix3::from_diagonal(&Vector3::from(moments));
        let matrix = rotation * diagonal * rotation.transpose();
        let rows: Vec<_> =
            matrix.row_iter().map(|row| format!("{:?}", row.iter().collect::<Vec<_>>())).collect();
        let (plain, _) = body(&format!("{moments:?}"), &c, &v, &g);
        let turned = [c, v, g].map(|u| rotation * u);
        let (rotated, told) =
            body(&format!("[{}]", rows.join(",")), &turned[0], &turned[1], &turned[2]);
        assert!(
            moments == [1.4; 3] || told.contains("the principal moments about the support are"),
            "{told}"
        );
        for (one, other) in plain.iter().zip(&rotated) {
            for part in [1, 4] {
                let [a, b] =
                    [one, other].map(|row| Vector3::new(row[part], row[part + 1], row[part + 2]));
                assert!((rotation * a - b).amax() < 1e-13, "{moments:?}: {one:?} {other:?}");
            }
            // The energy, |Γ|² and Π·Γ do not depend on the axes.
            assert!((7..10).all(|i| (one[i] - other[i]).abs() < 1e-13), "{one:?} {other:?}");
            // The attitude R has Γ = Rᵀe₃ in the same axes.
            let q = &other[other.len() - 4..];
            let row = Vector3::new(
                2.0 * (q[1] * q[3] - q[0] * q[2]),
                2.0 * (q[2] * q[3] + q[0] * q[1]),
                1.0 - 2.0 * (q[1] * q[1] + q[2] * q[2]),
            );
            assert!((row - Vector3::new(other[4], other[5], other[6])).amax() < 1e-12, "{other:?}");
        }
    }
    for (inertia, part) in [
        ("[[2, 0.1, 0], [0.2, 2, 0], [0, 0, 1]]", "inertia[0][1] = 0.1, but inertia[1][0] = 0.2"),
        ("[[2, 0, 0], [0, 2, 0]]", "invalid length 2"),
        ("[[2, 0, 0], 2, 1]", "moments and rows are mixed"),
        ("[[1, 3, 0], [3, 1, 0], [0, 0, 1]]", "inertia"),
    ] {
        folder.write("b.toml", &format!("body.inertia = {inertia}"));
        let run = folder.heavytop(&["simulate", "b.toml", "--out", "b.csv"]);
        assert_eq!(run.code(), 2, "{inertia}: {}", run.stderr());
        assert!(run.stderr().contains(part), "{inertia}: {}", run.stderr());
    }
}

/// The section of a rotated body by a coordinate of its own axes is that of the body.
#[test]
#[ignore = "long"]
fn a_section_fixes_a_coordinate_of_the_axes_of_the_table() {
    let folder = Folder::new();
    // A quarter turn about e₃ makes the new Γ₁ of −Γ₂.
    let section = |text: &str, surface: &str, out: &str| {
        folder.write(
            "s.toml",
            &format!("{text}\n[section]\nenergy = 2\nvertical_momentum = 0.3\nsurface = '{surface}'\nstarts = 4\ncrossings = 5"),
        );
        let run = folder.heavytop(&["section", "s.toml", "--out", out]);
        assert_eq!(run.code(), 0, "{}", run.stderr());
        let rows = folder.read(&format!("{out}/section.csv"));
        let numbers = |line: &str| line.split(',').map(|x| x.parse().unwrap()).collect();
        rows.lines().skip(1).map(numbers).collect::<Vec<Vec<f64>>>()
    };
    let tilted = "[body]\ninertia = [[1.5, 0.3, 0], [0.3, 1.2, 0.1], [0, 0.1, 1]]\nweight_moment = 1\n\
                  center_of_mass = [0.6, 0, 0.8]";
    let matrix = Matrix3::new(1.5, 0.3, 0.0, 0.3, 1.2, 0.1, 0.0, 0.1, 1.0).try_inverse().unwrap();
    for (surface, column) in [("Gamma1", 6), ("Gamma3", 8), ("Pi2", 4)] {
        let rows = section(tilted, surface, surface);
        assert!(rows.len() > 20);
        for row in rows {
            let (pi, gamma) =
                (Vector3::new(row[3], row[4], row[5]), Vector3::new(row[6], row[7], row[8]));
            let energy = 0.5 * pi.dot(&(matrix * pi)) + 0.6 * gamma.x + 0.8 * gamma.z;
            assert!((energy - 2.0).abs() < 1e-8 && (pi.dot(&gamma) - 0.3).abs() < 1e-12, "{row:?}");
            assert!(row[column].abs() < 1e-12, "{surface}: {row:?}");
        }
    }
}

#[test]
fn a_thin_rod_runs_without_spin() {
    let folder = Folder::new();
    let body = "[body]\ninertia = [0.12, 0.12, 0]\nmass = 1\ngravity = 9.81\nlength = 0.3\n\
                center_of_mass = [0, 0, 1]\n";
    let start = "[initial]\nangular_momentum = [0.1, 0.2, 0]\nvertical = [0.6, 0, -0.8]\n";
    let (rows, told) = run(&folder, &format!("{body}{start}"));
    assert!(!told.contains("warning"), "{told}");
    assert!(rows.iter().all(|row| row[3].abs() < 1e-14), "{rows:?}");
    for (start, part) in [
        ("angular_momentum = [0.1, 0.2, 0.3]", "no angular momentum about itself, got 0.3"),
        ("angular_velocity = [1, 2, 3]", "angular_velocity must be at right angles to a thin rod"),
    ] {
        folder.write("b.toml", &format!("{body}[initial]\n{start}\nvertical = [0.6, 0, -0.8]"));
        let run = folder.heavytop(&["simulate", "b.toml", "--out", "b.csv"]);
        assert_eq!(run.code(), 2, "{}", run.stderr());
        assert!(run.stderr().contains(part), "{}", run.stderr());
    }
}

/// What a run says after its closing line.
fn told(folder: &Folder, arguments: &[&str]) -> String {
    let run = folder.heavytop(arguments);
    assert_eq!(run.code(), 0, "{}", run.stderr());
    run.stderr()
}

#[test]
#[ignore = "long"]
fn values_that_are_left_out_are_told() {
    let folder = Folder::new();
    let short = ["--set", "integrator.end=0.1", "--set", "integrator.step=0.0125"];
    folder.write(
        "a.toml",
        "[body]\ninertia = [2, 1.5, 1]\nmass = 1\nlength = 0.1\n[initial]\nangular_velocity = [1, 2, 3]\n\
         inclination = '30 deg'",
    );
    let simulate = |more: &[&str], out: &str| {
        told(&folder, &[&["simulate", "a.toml", "--out", out], more, &short[..]].concat())
    };
    let text = simulate(&[], "a.npz");
    let line = "left out, and taken from the paper's top: body.center_of_mass = [1.0, 0.0, 0.0], body.gravity = 1.0";
    assert!(text.contains(line) && !text.contains("initial."), "{text}");
    let bytes = std::fs::read(folder.path("a.npz")).unwrap();
    let metadata = String::from_utf8_lossy(&bytes).replace('\0', "");
    assert!(
        metadata.contains(
            r#""left_out":["body.center_of_mass = [1.0, 0.0, 0.0]","body.gravity = 1.0"]"#
        )
    );
    // With a preset they are those of the preset.
    let text = simulate(&["--preset", "multibody-benchmark"], "b.csv");
    assert!(text.contains("taken from the preset multibody-benchmark"), "{text}");
    assert!(text.contains("body.gravity = 9.81"), "{text}");
    // A table that is opened by an option alone, and the other table, which is not.
    let text = told(
        &folder,
        &[&["simulate", "--out", "c.csv", "--set", "body.gravity=9.81"], &short[..]].concat(),
    );
    for part in
        ["body.mass = 1.0", "initial.angular_momentum = [2.0, 3.0, 4.0]", "initial.vertical"]
    {
        assert!(text.contains(part), "{text}");
    }
    // The summary has them, too; and a run of a whole top says nothing.
    let run = folder
        .heavytop(&[&["simulate", "a.toml", "--out", "d.csv", "--json"], &short[..]].concat());
    assert!(
        run.stdout().contains("\"left_out\"") && run.stdout().contains("\"taken_from\""),
        "{}",
        run.stdout()
    );
    for whole in [&["--preset", "lagrange"][..], &[]] {
        let text = told(&folder, &[&["simulate", "--out", "e.csv"], whole, &short[..]].concat());
        assert!(!text.contains("left out"), "{text}");
    }
    // The other commands.
    let axis =
        "sweep.axes=[{parameter='initial.vertical.azimuth', from='0 deg', to='90 deg', count=2}]";
    let commands: [(&str, &[&str]); 4] = [
        ("animate", &["--out", "a.html"]),
        ("compare", &["--out", "compare", "--end", "0.1"]),
        (
            "section",
            &["--out", "section", "--set", "section.starts=1", "--set", "section.crossings=1"],
        ),
        ("sweep", &["--out", "sweep", "--set", axis]),
    ];
    for (command, arguments) in commands {
        let text = told(&folder, &[&[command, "a.toml"], arguments, &short[..]].concat());
        assert!(text.contains("body.gravity = 1.0"), "{command}: {text}");
    }
}

/// A factor beside a product of which the other factors are not known is refused; the product of a preset is known.
#[test]
fn a_factor_does_not_discard_a_weight_moment() {
    let folder = Folder::new();
    let short = ["--set", "integrator.end=0.1"];
    let simulate = |file: &str, more: &[&str]| {
        folder.heavytop(&[&["simulate", file, "--out", "a.csv"], &short[..], more].concat())
    };
    folder.write("product.toml", "body = { inertia = [2, 1.5, 1], weight_moment = 5 }");
    for key in ["body.mass=2", "body.gravity=9.81", "body.length=0.1"] {
        let run = simulate("product.toml", &["--set", key]);
        assert_eq!(run.code(), 2, "{}", run.stderr());
        let (factor, _) = key.split_once('=').unwrap();
        let said =
            format!("--set: `{factor}` is a factor of `body.weight_moment`, which is 5 before");
        assert!(run.stderr().contains(&said), "{}", run.stderr());
        assert!(!folder.path("a.csv").exists());
    }
    let both = ["--set", "body.weight_moment=5", "--set", "body.mass=2"];
    folder.write("empty.toml", "");
    assert_eq!(simulate("empty.toml", &both).code(), 2);
    // Controls: a product over a product, a factor of a preset, and one of a product that is that of the preset.
    let energy = |file: &str, more: &[&str]| {
        let run = simulate(file, more);
        assert_eq!(run.code(), 0, "{}", run.stderr());
        folder.read("a.csv").lines().nth(1).unwrap().split(',').nth(7).unwrap().to_owned()
    };
    folder.write("init.toml", "body.weight_moment = 1.0");
    let twice = energy("empty.toml", &["--set", "body.weight_moment=2"]);
    assert_eq!(energy("empty.toml", &["--set", "body.mass=2"]), twice);
    assert_eq!(energy("init.toml", &["--set", "body.mass=2"]), twice);
    assert_eq!(energy("init.toml", &["--set", "body.weight_moment=2"]), twice);
    assert_ne!(energy("empty.toml", &[]), twice);
}

/// An integer of more than 64 bits is a number, and what the file leaves out is told beside it.
#[test]
fn values_that_are_left_out_are_told_beside_a_large_integer() {
    let folder = Folder::new();
    let short = ["--set", "integrator.end=0.02", "--set", "integrator.step=0.01"];
    for mass in ["1000000000000000000000", "1e21"] {
        folder.write(
            "a.toml",
            &format!("body = {{ inertia = [2, 2, 1], mass = {mass}, gravity = 1e-21 }}"),
        );
        let text = told(&folder, &[&["simulate", "a.toml", "--out", "a.csv"], &short[..]].concat());
        let given = ["body.inertia = ", "body.mass = ", "body.gravity = "];
        assert!(text.contains("body.length = 1.0"), "{mass}: {text}");
        assert!(!given.iter().any(|key| text.contains(key)), "{mass}: {text}");
    }
}
