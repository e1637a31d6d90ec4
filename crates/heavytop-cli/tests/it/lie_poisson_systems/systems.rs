//! Lie–Poisson systems by their algebra and a formula: `[system]`.

use crate::program::{Finished, Folder, numbers};

/// The heavy top as a system, with the numbers of the program's default top.
const TOP: &str = "\
[system]
algebra = 'se(3)'
hamiltonian = '½*(Π₁²/I₁ + Π₂²/I₂ + Π₃²/I₃) + mgl*c·Γ'
parameters = { I = [2, 2, 1], mgl = 1, c = [1, 0, 0] }
initial = { Pi = [2, 3, 4], Gamma = [0.5, 0, 0.8660254037844386] }

[integrator]
end = 10
";

/// The Poincaré algebra of one space dimension by its brackets.
const POINCARE: &str = "\
[system]
coordinates = ['K', 'H', 'P']
brackets = { 'K, H' = 'P', 'K, P' = 'H' }
hamiltonian = 'K^2/2 + a*H^2'
parameters.a = 0.75
initial = { K = 0.1, H = 0.3, P = -0.2 }

[integrator]
scheme = 'gauss-8'
step = 0.05
end = 20
";

/// Returns what a command has printed, after checking that it succeeded.
fn succeeded(done: &Finished) -> String {
    assert_eq!(done.code(), 0, "{}", done.stderr());
    done.stdout()
}

/// Returns the message of a command, after checking that it was refused.
fn refused(done: &Finished) -> String {
    assert_eq!(done.code(), 2, "{}", done.stderr());
    done.stderr()
}

/// A system by name is the system of its algebra and its Hamiltonian.
#[test]
fn a_system_by_name_is_that_of_its_formulas() {
    let folder = Folder::new();
    let rest = "parameters = { I = [1, 2, 3], J = [0.1, 0.2] }\n\
                initial = { Pi = [0.3, 1, 0.2], l = [0.2, 0.1] }\n\
                [integrator]\nend = 10\n";
    folder.write("kind.toml", &format!("[system]\nkind = 'body-with-rotors'\n{rest}"));
    let scalars = rest.replace(
        "Pi = [0.3, 1, 0.2], l = [0.2, 0.1]",
        "x = 0.3, y = 1, z = 0.2, l1 = 0.2, l2 = 0.1",
    );
    let formulas = "coordinates = ['x', 'y', 'z', 'l1', 'l2']\n\
                    brackets = { 'x, y' = 'z', 'y, z' = 'x', 'z, x' = 'y' }\n\
                    hamiltonian = '(x - l1)^2/(2*I1) + (y - l2)^2/(2*I2) + z^2/(2*I3) + l1^2/(2*J1) + l2^2/(2*J2)'\n";
    folder.write("formulas.toml", &format!("[system]\n{formulas}{scalars}"));
    let told = succeeded(&folder.heavytop(&["simulate", "kind.toml", "--out", "kind.csv"]));
    succeeded(&folder.heavytop(&["simulate", "formulas.toml", "--out", "formulas.csv"]));
    let (header, rows) = numbers(&folder.read("kind.csv"));
    assert_eq!(header.join(","), "t,Pi1,Pi2,Pi3,l1,l2,h,c1,c2,c3", "{told}");
    // The vectors are scalars here, of which each converges by itself: the same to rounding.
    let (_, expected) = numbers(&folder.read("formulas.csv"));
    for (row, expected) in rows.iter().zip(&expected) {
        assert!(
            row.iter().zip(expected).all(|(x, y)| (x - y).abs() < 1e-13),
            "{row:?} {expected:?}"
        );
    }
    assert_eq!(rows.len(), expected.len());
    // What is wrong is named.
    folder.write("few.toml", "[system]\nkind = 'body-with-rotors'\nparameters.I = [1, 2, 3]\n");
    let said = refused(&folder.heavytop(&["simulate", "few.toml", "--out", "few.csv"]));
    assert!(
        said.contains("body-with-rotors: J is missing. It takes") && said.contains("kg m²"),
        "{said}"
    );
    folder.write("other.toml", "[system]\nkind = 'body-with-rotor'\n");
    let said = refused(&folder.heavytop(&["simulate", "other.toml", "--out", "few.csv"]));
    assert!(said.contains("there is no system body-with-rotor; there are body-in-fluid"), "{said}");
}

#[test]
fn a_top_as_a_system_moves_as_the_top() {
    let folder = Folder::new();
    for formulation in ["collective", "reduced", "direct"] {
        let method = format!("formulation = '{formulation}'\nscheme = 'gauss-8'\n");
        folder.write("system.toml", &format!("{TOP}{method}"));
        folder.write("top.toml", &format!("[integrator]\nend = 10\n{method}"));
        succeeded(&folder.heavytop(&["simulate", "system.toml", "--out", "system.csv"]));
        succeeded(&folder.heavytop(&["simulate", "top.toml", "--out", "top.csv"]));
        let (header, rows) = numbers(&folder.read("system.csv"));
        let expected = "t,Pi1,Pi2,Pi3,Gamma1,Gamma2,Gamma3,h,c1,c2";
        assert_eq!(header.join(","), expected);
        let (_, top) = numbers(&folder.read("top.csv"));
        assert_eq!(rows.len(), top.len());
        for (row, top) in rows.iter().zip(&top) {
            // The energies are rounded differently, and the differences grow along 10 s.
            let state = row.iter().zip(top).take(8);
            assert!(state.clone().all(|(a, b)| (a - b).abs() < 1e-10), "{row:?} {top:?}");
            // c1 = Π·Γ and c2 = |Γ|²; the top has |Γ|² before Π·Γ.
            assert!((row[8] - top[9]).abs() < 1e-10 && (row[9] - top[8]).abs() < 1e-10);
        }
    }
}

#[test]
fn an_algebra_from_brackets_conserves_the_casimirs_that_are_found() {
    let folder = Folder::new();
    folder.write("poincare.toml", POINCARE);
    let done = folder.heavytop(&["simulate", "poincare.toml", "--out", "out.csv", "--json"]);
    let summary: serde_json::Value = serde_json::from_str(&succeeded(&done)).unwrap();
    assert_eq!(summary["casimirs"]["c1"], "H^2 - P^2");
    assert_eq!(summary["formulation"], "direct");
    // Gauss–Legendre methods conserve quadratic invariants, and have order 8 for the energy.
    assert!(summary["deviations"]["c1"].as_f64().unwrap() < 1e-13);
    let (header, rows) = numbers(&folder.read("out.csv"));
    assert_eq!(header.join(","), "t,K,H,P,h,c1");
    assert_eq!(rows.len(), 401);
    assert!((rows[0][4] - (0.005 + 0.75 * 0.09)).abs() < 1e-16);
    let last = [1, 2, 3].map(|i| rows[400][i]);
    assert!((last[1].powi(2) - last[2].powi(2) - 0.05).abs() < 1e-13);
}

/// The Clebsch map of the Poincaré algebra has its odd powers, so that the mass is kept to round-off.
#[test]
fn collective_runs_of_an_algebra_from_brackets_keep_the_casimir() {
    let folder = Folder::new();
    folder.write("poincare.toml", POINCARE);
    let run = |formulation: &str, out: &str| {
        let set = format!("integrator.formulation={formulation}");
        let arguments = ["simulate", "poincare.toml", "--out", out, "--json", "--set", &set];
        let summary = succeeded(&folder.heavytop(&arguments));
        serde_json::from_str::<serde_json::Value>(&summary).unwrap()
    };
    let [collective, direct] =
        ["collective", "direct"].map(|name| run(name, &format!("{name}.csv")));
    assert_eq!(collective["formulation"], "collective");
    assert!(collective["deviations"]["c1"].as_f64().unwrap() < 1e-13);
    // Both have order 8: the errors at t = 20 are far below 1e-9.
    for name in ["K", "H", "P"] {
        let [a, b] = [&collective, &direct].map(|summary| summary["last"][name].as_f64().unwrap());
        assert!((a - b).abs() < 1e-9, "{name}: {a} {b}");
    }
}

#[test]
fn formats_name_the_casimirs() {
    let folder = Folder::new();
    folder.write("poincare.toml", POINCARE);
    succeeded(&folder.heavytop(&["simulate", "poincare.toml", "--out", "out.npz"]));
    succeeded(&folder.heavytop(&["simulate", "poincare.toml", "--out", "out.parquet"]));
    let names: Vec<u8> = std::fs::read(folder.path("out.npz")).unwrap();
    for name in ["K.npy", "h.npy", "c1.npy"] {
        assert!(names.windows(name.len()).any(|part| part == name.as_bytes()), "{name}");
    }
    let parquet = std::fs::read(folder.path("out.parquet")).unwrap();
    assert!(parquet.windows(9).any(|part| part == b"H^2 - P^2"));
}

/// A configuration, the quoted line, the marked text and the message.
const REFUSED: &[(&str, &str, &str, &str)] = &[
    (
        "hamiltonian = 'Pi1^2 + Pj2'\nalgebra = 'so(3)'",
        "hamiltonian = 'Pi1^2 + Pj2'",
        "Pj2",
        "there is no `Pj2`; did you mean `Pi2`?",
    ),
    (
        "hamiltonian = 'Pi1 +* 2'\nalgebra = 'so(3)'",
        "hamiltonian = 'Pi1 +* 2'",
        "*",
        "a number, a name or `(` is missing here; found `*`",
    ),
    ("algebra = 'so4'\nhamiltonian = 'x'", "algebra = 'so4'", "'so4'", "there is no algebra"),
    (
        "coordinates = ['x', 'y']\nhamiltonian = 'x'\nbrackets = { 'x, y' = 'x*y' }",
        "brackets = { 'x, y' = 'x*y' }",
        "'x*y'",
        "a bracket is a sum of multiples of coordinates",
    ),
    (
        "coordinates = ['x', 'y', 'z']\nhamiltonian = 'x'\nbrackets = { 'x, y' = 'z', 'y, z' = 'z', 'x, z' = 'y' }",
        "brackets = { 'x, y' = 'z', 'y, z' = 'z', 'x, z' = 'y' }",
        "{ 'x, y' = 'z', 'y, z' = 'z', 'x, z' = 'y' }",
        "the Jacobi identity fails",
    ),
    (
        "algebra = 'so(3)'\nhamiltonian = 'Pi1'\ninitial = { Pi = [1, 2] }",
        "initial = { Pi = [1, 2] }",
        "[1, 2]",
        "an array of 3 numbers",
    ),
    (
        "algebra = 'so(3)'\nhamiltonian = 'Pi1'\ninitial = { Pi1 = 1, Pi3 = 2 }",
        "initial = { Pi1 = 1, Pi3 = 2 }",
        "{ Pi1 = 1, Pi3 = 2 }",
        "no value for Pi2",
    ),
    (
        "algebra = 'so(3)'\nhamiltonian = 'k*Pi1'\nparameters.k = inf",
        "parameters.k = inf",
        "inf",
        "not a finite number",
    ),
];

#[test]
fn refusals_mark_the_place() {
    let folder = Folder::new();
    for (text, line, marked, message) in REFUSED {
        folder.write("wrong.toml", &format!("[system]\n{text}\n"));
        let error = refused(&folder.heavytop(&["simulate", "wrong.toml", "--out", "out.csv"]));
        assert!(error.contains(message), "{error}");
        let quoted = error.lines().find(|quoted| quoted.ends_with(line));
        let indent = quoted.unwrap_or_else(|| panic!("{error}")).find(line).unwrap();
        let marks = error.lines().rfind(|below| below.contains('^')).unwrap();
        let place = line.find(marked).unwrap();
        assert_eq!(marks.find('^'), Some(indent + place), "{error}");
        assert_eq!(marks.matches('^').count(), marked.chars().count(), "{error}");
        assert_eq!(folder.names(), ["wrong.toml"]);
    }
}

#[test]
fn methods_that_do_not_exist_are_refused() {
    let folder = Folder::new();
    folder.write("poincare.toml", POINCARE);
    folder.write("top.toml", TOP);
    let is_refused = |file: &str, key: &str, message: &str| {
        let set = format!("integrator.{key}");
        let out = ["simulate", file, "--out", "out.csv", "--set", &set];
        let error = refused(&folder.heavytop(&out));
        assert!(error.contains(message), "{error}");
    };
    is_refused("poincare.toml", "formulation=reduced", "it has collective and direct");
    is_refused("top.toml", "formulation=splitting", "it has collective, reduced and direct");
    is_refused("top.toml", "scheme=stormer-verlet", "collective has implicit-midpoint");
    for (key, message) in [
        ("body.mass=2", "a system has no [body]"),
        ("initial.vertical=[0, 0, 1]", "a system has no [initial]"),
        ("output.attitude=true", "a system has no attitude"),
    ] {
        let out = ["simulate", "top.toml", "--out", "out.csv", "--set", key];
        let error = refused(&folder.heavytop(&out));
        assert!(error.contains(message), "{error}");
    }
    for command in ["compare", "animate"] {
        let error = refused(&folder.heavytop(&[command, "top.toml", "--out", "page.html"]));
        assert!(
            error.contains("simulate, events, section, sweep and ensemble run a system"),
            "{error}"
        );
    }
}

#[test]
fn steps_that_are_not_poisson_are_warned_of() {
    let folder = Folder::new();
    // [x, z] = x and [y, z] = 2y: the cube of ad z is no multiple of it
    let text = "[system]\ncoordinates = ['x', 'y', 'z']\nbrackets = { 'x, z' = 'x', 'y, z' = '2*y' }\n\
                hamiltonian = 'x^2 + y^2 + z^2'\ninitial = { x = 0.1, y = 0.3, z = -0.2 }\n\
                [integrator]\nformulation = 'collective'\nend = 1\n";
    folder.write("solvable.toml", text);
    folder.write("poincare.toml", POINCARE);
    let run = |file: &str| {
        let set = "integrator.formulation=collective";
        // Tables of different coordinates do not replace one another.
        let run = folder.heavytop(&["simulate", file, "--out", "out.csv", "--set", set, "--force"]);
        assert_eq!(run.code(), 0, "{}", run.stderr());
        run.stderr()
    };
    let warned = run("solvable.toml");
    let warnings =
        warned.lines().filter(|line| line.starts_with("heavytop: warning: the steps of"));
    assert_eq!(warnings.count(), 1, "{warned}");
    assert!(warned.contains("; the steps are not Poisson maps; largest deviations"), "{warned}");
    assert!(!run("poincare.toml").contains("not Poisson"));
}

#[test]
fn an_interrupted_run_of_a_system_continues_byte_for_byte() {
    use heavytop_cli::commands::simulate::{Checkpoint, SimulateOptions, simulate};
    use heavytop_cli::configuration::Config;
    use std::sync::atomic::AtomicBool;
    let folder = Folder::new();
    let mut config: Config = toml::from_str(TOP).unwrap();
    config.integrator.end = Some(40.0);
    let run =
        |name: &str, options: &SimulateOptions<'_>| simulate(&config, &folder.path(name), options);
    let whole = run("whole.csv", &SimulateOptions::default()).unwrap();
    let stop = AtomicBool::new(true);
    let stopped = run("parts.csv", &SimulateOptions { stop: Some(&stop), ..Default::default() });
    assert_eq!(stopped.unwrap_err().exit_code(), 130);
    // A run that shall stop does so after step 0. One that continues, and shall stop before its error is estimated, stays
    // where it is: without the estimate its output would be another.
    let checkpoint = || Checkpoint::read(&folder.path("parts.csv.checkpoint")).unwrap();
    let (first, stop) = (checkpoint(), Some(&stop));
    let again = SimulateOptions { resume: Some(&first), stop, ..Default::default() };
    assert_eq!(run("parts.csv", &again).unwrap_err().exit_code(), 130);
    let second = checkpoint();
    assert_eq!((first.saved().step, second.saved().step), (0, 0));
    let resume = Some(&second);
    let resumed = run("parts.csv", &SimulateOptions { resume, ..Default::default() }).unwrap();
    assert_eq!(folder.read("parts.csv"), folder.read("whole.csv"));
    assert_eq!(resumed.error_estimate, whole.error_estimate);
    assert_eq!(resumed.deviations, whole.deviations);
}

/// so(4) by the momenta M of three planes and N of the other three: [Mᵢ, Mⱼ] = Mₖ, [Mᵢ, Nⱼ] = Nₖ, [Nᵢ, Nⱼ] = Mₖ.
const SO4: &str = "\
i, j, k, value
1, 2, 3, 1
2, 3, 1, 1
3, 1, 2, 1
1, 5, 6, 1
1, 6, 5, -1
2, 6, 4, 1
2, 4, 6, -1
3, 4, 5, 1
3, 5, 4, -1
4, 5, 3, 1
5, 6, 1, 1
6, 4, 2, 1
";

#[test]
fn structure_constants_come_from_a_file_beside_the_configuration() {
    let folder = Folder::new();
    std::fs::create_dir(folder.path("bodies")).unwrap();
    folder.write("bodies/so4.csv", SO4);
    let text = "[system]\nstructure_constants = 'so4.csv'\nhamiltonian = 'mu1^2 + mu2^2/2 + mu4^2/3 + mu5*mu6'\n\
                initial.mu = [1, 0.5, 0.2, -0.3, 0.4, 0.1]\n[integrator]\nscheme = 'gauss-8'\nend = 2\n";
    folder.write("bodies/body.toml", text);
    let run = ["simulate", "bodies/body.toml", "--out", "body.csv", "--json"];
    let summary = succeeded(&folder.heavytop(&run));
    assert!(summary.contains("mu1*mu4 + mu2*mu5 + mu3*mu6") && summary.contains("|mu|^2"));
    // The same table within the configuration, as metadata and checkpoints contain it.
    let inner = text.replace("'so4.csv'", &format!("'''\n{SO4}'''"));
    folder.write("inner.toml", &inner);
    succeeded(&folder.heavytop(&["simulate", "inner.toml", "--out", "inner.csv"]));
    assert_eq!(folder.read("body.csv"), folder.read("inner.csv"));
    // Negative controls: a wrong line, no Lie algebra, and no file.
    let is_refused = |message: &str| {
        let error =
            refused(&folder.heavytop(&["simulate", "bodies/body.toml", "--out", "out.csv"]));
        assert!(error.contains(message) && error.contains("bodies/body.toml, line 2"), "{error}");
        assert!(!folder.names().contains(&"out.csv".into()));
    };
    folder.write("bodies/so4.csv", &SO4.replace("5, 6, 1, 1", "5, 6, 1, l"));
    is_refused("structure_constants: line 12: the value `l` is not a finite number");
    folder.write("bodies/so4.csv", &SO4.replace("5, 6, 1, 1", "5, 6, 1, -1"));
    is_refused("the Jacobi identity fails for e");
    std::fs::remove_file(folder.path("bodies/so4.csv")).unwrap();
    is_refused("cannot read bodies/so4.csv");
}

/// The systems in the help run as they are written there. Those of the guide run with the tests of the Python package.
#[test]
#[ignore = "long"]
fn the_systems_of_the_help_run() {
    let folder = Folder::new();
    let help = folder.heavytop(&["simulate", "--help"]).stdout();
    let systems = help.split("  [system]\n").skip(1).map(|text| text.split("\n\n").next().unwrap());
    let is_whole = |text: &&str| ["hamiltonian = ", "kind = "].iter().any(|key| text.contains(key));
    let mut count = 0;
    for text in systems.filter(is_whole) {
        folder.write("system.toml", &format!("[system]\n{text}"));
        let run = ["simulate", "system.toml", "--out", "system.csv", "--force"];
        succeeded(&folder.heavytop(&[&run[..], &["--set", "integrator.end=2"]].concat()));
        count += 1;
    }
    assert_eq!(count, 5);
}

/// A quantity without a value is an error that names the formula, the part without a value, and the state; before the
/// run if it is at the start.
#[test]
fn a_quantity_without_a_value_is_an_error() {
    let folder = Folder::new();
    let body = |hamiltonian: &str, initial: &str| {
        format!(
            "[system]\nalgebra = 'so(3)'\nhamiltonian = '{hamiltonian}'\ninitial.Pi = {initial}\n\
             [integrator]\nstep = 0.1\nend = 1\n"
        )
    };
    for (hamiltonian, initial, said) in [
        (
            "ln(Pi1 - 5)",
            "[1, 0, 0]",
            "ln(Pi1 - 5) has no value at Pi1 = 1, Pi2 = 0, Pi3 = 0, where ln(Pi1 - 5) is not a number",
        ),
        (
            "sqrt(Pi1^2 + Pi2^2) + Pi3",
            "[0, 0, 1]",
            "sqrt(Pi1^2 + Pi2^2) + Pi3 has no derivative at Pi1 = 0, Pi2 = 0, Pi3 = 1, where that of \
             sqrt(Pi1^2 + Pi2^2) with respect to Pi1 is not a number",
        ),
    ] {
        folder.write("a.toml", &body(hamiltonian, initial));
        let run = folder.heavytop(&["simulate", "a.toml", "--out", "a.csv"]);
        assert_eq!(run.code(), 2, "{}", run.stderr());
        assert!(run.stderr().contains(said), "{}", run.stderr());
        assert_eq!(folder.names(), ["a.toml"]);
    }
    // Powers of lengths have a derivative at 0.
    let at_zero = body("|Pi|^1.5 + Pi3", "[0, 0, 0]");
    folder.write("a.toml", &at_zero.replace("step", "formulation = 'direct'\nstep"));
    let run = folder.heavytop(&["simulate", "a.toml", "--out", "a.csv"]);
    assert_eq!((run.code(), run.complaints().as_str()), (0, ""));
    // y = eᵗ comes to the end of the logarithm at t = ln 2 = 0.69: the rows before are kept.
    let growing = "[system]\ncoordinates = ['x', 'y']\nbrackets = { 'x, y' = 'y' }\n\
        hamiltonian = 'x + 1e-9*ln(2 - y)'\ninitial = { x = 0, y = 1 }\n\
        [integrator]\nformulation = 'direct'\nscheme = 'rk4'\nstep = 0.1\nend = 1\n";
    folder.write("b.toml", growing);
    let run = folder.heavytop(&["simulate", "b.toml", "--out", "b.csv"]);
    assert_eq!(run.code(), 1, "{}", run.stderr());
    let said = "where ln(2 - y) is not a number";
    assert!(run.stderr().contains(said) && run.stderr().contains("t = 0.7"), "{}", run.stderr());
    assert_eq!(folder.read("b.csv.partial").lines().count(), 1 + 7);
    // Behind a checkpoint, too: the run would fail there again, and there is nothing to resume.
    folder.write("c.toml", &growing.replace("step = 0.1", "step = 0.0005"));
    for out in ["c.csv", "c.npz"] {
        let always = ["--checkpoint-interval", "0"];
        let run = folder.heavytop(&[&["simulate", "c.toml", "--out", out], &always[..]].concat());
        assert_eq!(run.code(), 1, "{}", run.stderr());
        let kept = format!("; what was computed until then is in {out}.partial\n");
        assert!(run.stderr().ends_with(&kept), "{}", run.stderr());
        assert!(!run.stderr().contains("--resume"), "{}", run.stderr());
        assert!(!folder.path(&format!("{out}.checkpoint")).exists());
    }
    // The last row is before t = ln 2.
    assert_eq!(folder.read("c.csv.partial").lines().count(), 1 + 1 + 1386);
}

/// A coordinate that has the name of another column or array is refused before the run, in every format.
#[test]
fn columns_have_different_names() {
    let folder = Folder::new();
    let system = |name: &str| {
        format!(
            "[system]\ncoordinates = ['{name}', 'b', 'c']\n\
             brackets = {{ '{name}, b' = 'c', 'b, c' = '{name}', 'c, {name}' = 'b' }}\n\
             hamiltonian = '{name}^2 + b^2/2'\ninitial = {{ {name} = 1, b = 0.5, c = 0.2 }}\n\
             [integrator]\nend = 1\n"
        )
    };
    for name in ["h", "t", "c1"] {
        folder.write("a.toml", &system(name));
        for out in ["a.csv", "a.npz", "a.parquet"] {
            let run = folder.heavytop(&["simulate", "a.toml", "--out", out]);
            assert_eq!(run.code(), 2, "{}", run.stderr());
            let said = format!("two columns or arrays with the name {name}");
            assert!(run.stderr().contains(&said), "{}", run.stderr());
        }
        assert_eq!(folder.names(), ["a.toml"]);
    }
    // Control: other names, and those of columns that this algebra does not have.
    for name in ["a", "x", "c2"] {
        folder.write("a.toml", &system(name));
        let run = folder.heavytop(&["simulate", "a.toml", "--out", "a.npz"]);
        assert_eq!((run.code(), run.complaints().as_str()), (0, ""), "{name}");
    }
}
