//! `heavytop sweep` of a Lie–Poisson system: rows as of `simulate`, interruptions, members that fail, and refusals.

use crate::commands::sweep::{column, failures, rows};
use crate::program::{Folder, numbers};
use parquet::record::Row;

/// A body in a fluid whose energy is not quadratic; a sweep over 24 × 25 runs, in three tiles.
const BODY: &str = "\
[system]
algebra = 'se(3)'
hamiltonian = '(Pi1^2/I1 + Pi2^2/I2 + Pi3^2/I3 + Gamma1^2 + Gamma2^2/2 + k*Gamma3^4)/2'
parameters = { I = [1, 2, 3], k = 0.25 }
initial = { Pi = [1, 0.5, 0.3], Gamma = [0.6, 0, 0.8] }

[sweep]
observables = ['final-state', 'invariant-drift', 'megno', 'lyapunov', 'sali']
axes = [{ parameter = 'system.parameters.I[1]', from = 1.5, to = 2.5, count = 24 },
        { parameter = 'system.initial.Pi[2]', from = 0, to = 1, count = 25 }]

[integrator]
scheme = 'gauss-4'
step = 0.1
end = 1.0
";

/// The Poincaré algebra of one space dimension; a multiplies its brackets, b is in the Hamiltonian alone.
const POINCARE: &str = "\
[system]
coordinates = ['K', 'H', 'P']
brackets = { 'K, H' = 'a*P', 'K, P' = 'H' }
hamiltonian = 'K^2/2 + b*H^2'
parameters = { a = 1, b = 0.75 }
initial = { K = 0.1, H = 0.3, P = -0.2 }

[integrator]
scheme = 'gauss-8'
step = 0.05
end = 2
";

/// Runs the sweep of a configuration into a folder, and returns the rows of its table.
fn swept(folder: &Folder, text: &str, out: &str) -> Vec<Row> {
    folder.write("swept.toml", text);
    let run = folder.heavytop(&["sweep", "swept.toml", "--out", out]);
    assert_eq!((run.code(), run.complaints().as_str()), (0, ""));
    rows(folder, &format!("{out}/sweep.parquet"))
}

/// Returns the value of a column in a row.
fn cell(row: &Row, name: &str) -> f64 {
    column(std::slice::from_ref(row), name)[0].unwrap()
}

/// Returns the table of `simulate` with these assignments.
fn simulated(folder: &Folder, text: &str, assignments: &[String]) -> (Vec<String>, Vec<Vec<f64>>) {
    folder.write("simulated.toml", text);
    let set = assignments.iter().flat_map(|assignment| ["--set", assignment]);
    let arguments = ["simulate", "simulated.toml", "--out", "simulated.csv"];
    let run = folder.heavytop(&arguments.into_iter().chain(set).collect::<Vec<_>>());
    assert_eq!(run.code(), 0, "{}", run.stderr());
    numbers(&folder.read("simulated.csv"))
}

/// Returns the largest deviation of a column from its first number.
fn deviation((header, table): &(Vec<String>, Vec<Vec<f64>>), name: &str) -> f64 {
    let place = header.iter().position(|column| column == name).unwrap();
    table.iter().map(|row| (row[place] - table[0][place]).abs()).fold(0.0, f64::max)
}

#[test]
#[ignore = "long"]
fn a_row_has_the_bits_of_simulate() {
    let folder = Folder::new();
    for formulation in ["collective", "reduced", "direct"] {
        let text = BODY.replace("scheme", &format!("formulation = '{formulation}'\nscheme"));
        let text = text.replace("count = 24", "count = 3").replace("count = 25", "count = 3");
        // Steps with tangent vectors differ by rounding errors.
        let text = text.replace(", 'megno', 'lyapunov', 'sali'", "");
        let rows = swept(&folder, &text, formulation);
        assert_eq!(rows.len(), 9);
        for number in [1, 8] {
            let row = &rows[number];
            let names = ["system.parameters.I[1]", "system.initial.Pi[2]"];
            let set = names.map(|name| format!("{name}={:?}", cell(row, name)));
            let run = simulated(&folder, &text, &set);
            let end = |name: &str| {
                run.1.last().unwrap()[run.0.iter().position(|column| column == name).unwrap()]
            };
            for name in ["Pi1", "Pi2", "Pi3", "Gamma1", "Gamma2", "Gamma3"] {
                assert_eq!(cell(row, name), end(name), "{formulation} {number} {name}");
                // Control: another member ends elsewhere.
                assert_ne!(cell(&rows[number - 1], name), end(name), "{formulation} {name}");
            }
            for name in ["h", "c1", "c2"] {
                let drift = cell(row, &format!("drift_{name}"));
                assert_eq!(drift, deviation(&run, name), "{formulation} {number} {name}");
            }
            // In ten steps the energy changes by the error of a method of order 4, the Casimirs by a few roundings of 1.
            let [h, c1, c2] = ["drift_h", "drift_c1", "drift_c2"].map(|name| cell(row, name));
            assert!(h > 1e-12 && c1 < 2e-15 && c2 < 2e-15, "{formulation}: {h:e} {c1:e} {c2:e}");
        }
    }
}

/// A top as a system has the tangent vectors of the top.
#[test]
fn a_top_as_a_system_has_the_indicators_of_the_top() {
    let folder = Folder::new();
    let sweep = |parameter: &str| {
        format!(
            "[sweep]\nobservables = ['megno', 'lyapunov', 'sali', 'invariant-drift']\n\
             axes = [{{ parameter = '{parameter}', from = 1, to = 3, count = 5 }}]\n\
             [integrator]\nend = 5\n"
        )
    };
    let system = "[system]\nalgebra = 'se(3)'\n\
        hamiltonian = '½*(Π₁²/I₁ + Π₂²/I₂ + Π₃²/I₃) + c·Γ'\n\
        parameters = { I = [2, 2, 1], c = [1, 0, 0] }\n\
        initial = { Pi = [2, 3, 4], Gamma = [0.5, 0, 0.8660254037844386] }\n";
    let system = swept(&folder, &format!("{system}{}", sweep("system.parameters.I[1]")), "system");
    let top = swept(&folder, &sweep("body.inertia[1]"), "top");
    for name in ["megno", "lyapunov", "sali"] {
        let (system, top) = (column(&system, name), column(&top, name));
        for (system, top) in system.iter().zip(&top) {
            let (system, top) = (system.unwrap(), top.unwrap());
            // The energies are rounded differently, and the differences grow along 5 s.
            assert!((system - top).abs() < 1e-9 * top.abs().max(1.0), "{name}: {system} {top}");
        }
        // Control: another moment has another value.
        assert!((system[0].unwrap() - top[4].unwrap()).abs() > 1e-3, "{name}");
    }
}

#[test]
#[ignore = "long"]
fn no_bit_depends_on_the_number_of_threads_or_on_an_interruption() {
    let folder = Folder::new();
    folder.write("a.toml", BODY);
    for threads in ["1", "3"] {
        let run = folder.heavytop_on(threads, &["sweep", "a.toml", "--out", threads]);
        assert_eq!((run.code(), run.complaints().as_str()), (0, ""));
        let said = run.stdout();
        assert!(said.contains("600 runs, each by reduced, gauss-4, step 0.1 s, to 1 s"), "{said}");
        assert!(said.contains("c1 = Pi·Gamma\nc2 = |Gamma|^2\n"), "{said}");
    }
    // A folder blocks the unfinished file of a map: all tiles are finished, and stay. One of them is torn.
    std::fs::create_dir_all(folder.path("cut/megno.svg.partial")).unwrap();
    assert_eq!(folder.heavytop(&["sweep", "a.toml", "--out", "cut"]).code(), 1);
    std::fs::remove_dir(folder.path("cut/megno.svg.partial")).unwrap();
    let tile = folder.path("cut/sweep.partial/0000001");
    let text = std::fs::read_to_string(&tile).unwrap();
    std::fs::write(&tile, &text[..text.len() / 2]).unwrap();
    // It needs to be said whether the tiles are used, and those of another parameter are not.
    let refused = folder.heavytop(&["sweep", "a.toml", "--out", "cut"]);
    assert_eq!(refused.code(), 2, "{}", refused.stderr());
    let other = ["sweep", "a.toml", "--out", "cut", "--resume", "--set", "system.parameters.k=2"];
    let refused = folder.heavytop(&other);
    assert_eq!(refused.code(), 2, "{}", refused.stderr());
    assert!(refused.stderr().contains("[system] parameters"), "{}", refused.stderr());
    let resumed = folder.heavytop(&["sweep", "a.toml", "--out", "cut", "--resume"]);
    assert_eq!((resumed.code(), resumed.complaints().as_str()), (0, ""));
    folder.write("b.toml", &BODY.replace("to = 1, count", "to = 1.1, count"));
    assert_eq!(folder.heavytop(&["sweep", "b.toml", "--out", "other"]).code(), 0);
    for file in ["sweep.parquet", "megno.svg", "megno.png", "drift_c2.png", "Gamma3.svg"] {
        let read = |name: &str| std::fs::read(folder.path(name).join(file)).unwrap();
        assert!(read("1") == read("3") && read("1") == read("cut"), "{file}");
        // Control: other runs give other bytes.
        assert!(read("1") != read("other"), "{file}");
    }
    assert!(!folder.path("cut/sweep.partial").exists());
}

#[test]
fn members_keep_the_casimirs_of_their_own_algebras() {
    let folder = Folder::new();
    let sweep = |parameter: &str, to: f64| {
        format!(
            "{POINCARE}[sweep]\nobservables = ['invariant-drift', 'final-state']\n\
             axes = [{{ parameter = 'system.parameters.{parameter}', from = 0, to = {to}, count = 3 }}]"
        )
    };
    // The Casimir is H² − a P².
    let of_brackets = swept(&folder, &sweep("a", 2.0), "brackets");
    assert!(failures(&of_brackets).iter().all(Option::is_none));
    assert!(column(&of_brackets, "drift_c1").iter().all(|drift| drift.unwrap() < 1e-14));
    // Control: at a = 2 the Casimir of a = 1 is none.
    let end = &of_brackets[2];
    assert!((cell(end, "H").powi(2) - cell(end, "P").powi(2) - 0.05).abs() > 1e-3);
    // The row of a member is that of `simulate`, whose algebra is read anew.
    let run = simulated(&folder, POINCARE, &["system.parameters.a=2".into()]);
    assert_eq!(run.0.join(","), "t,K,H,P,h,c1");
    assert_eq!(run.1.last().unwrap()[1..4], ["K", "H", "P"].map(|name| cell(end, name)));
    assert_eq!(cell(end, "drift_h"), deviation(&run, "h"));
    let of_hamiltonian = swept(&folder, &sweep("b", 1.5), "hamiltonian");
    assert!(column(&of_hamiltonian, "drift_c1").iter().all(|drift| drift.unwrap() < 1e-14));
    // Casimirs are told where all members have the same.
    let has = |out: &str| {
        let bytes = std::fs::read(folder.path(out).join("sweep.parquet")).unwrap();
        bytes.windows(9).any(|part| part == b"H^2 - P^2")
    };
    assert!(has("hamiltonian") && !has("brackets"));
}

/// Decimal constants have Casimirs as whole ones do. Whether a Casimir is a polynomial may depend on a parameter: x²y is
/// one, and x^2.55 y is none; then the cell is empty, and the run is there all the same.
#[test]
fn no_member_is_refused_for_its_constants() {
    let folder = Folder::new();
    let axis = |text: &str, parameter: &str, from: f64, to: f64, count: u32| {
        format!(
            "{text}[sweep]\nobservables = ['invariant-drift', 'final-state']\n\
             axes = [{{ parameter = 'system.parameters.{parameter}', from = {from}, to = {to}, count = {count} }}]"
        )
    };
    let decimals = swept(&folder, &axis(POINCARE, "a", 0.987_654_321, 7.1, 7), "decimals");
    assert!(failures(&decimals).iter().all(Option::is_none));
    let drifts = column(&decimals, "drift_c1");
    assert!(drifts[0].unwrap() < 1e-14, "{drifts:?}");
    assert!(drifts.iter().all(|drift| drift.is_some()), "{drifts:?}");
    let squeeze = "[system]\ncoordinates = ['a', 'x', 'y']\nbrackets = { 'a, x' = 'x', 'a, y' = '-q*y' }\n\
        hamiltonian = 'a^2/2 + x^2 + y^2'\nparameters.q = 2\ninitial = { a = 0.1, x = 0.3, y = 0.2 }\n\
        [integrator]\nstep = 0.05\nend = 1\n";
    let rates = swept(&folder, &axis(squeeze, "q", 2.0, 2.55, 2), "rates");
    assert!(failures(&rates).iter().all(Option::is_none));
    let drifts = column(&rates, "drift_c1");
    assert!(drifts[0].is_some_and(|drift| drift < 1e-10) && drifts[1].is_none(), "{drifts:?}");
    assert!(column(&rates, "x").iter().all(Option::is_some));
}

#[test]
fn members_that_fail_say_so_and_harm_no_other() {
    let folder = Folder::new();
    let axis = |parameter: &str, from: f64, to: f64, count: u32| {
        format!(
            "[sweep]\nobservables = ['final-state']\naxes = [{{ parameter = '{parameter}', \
             from = {from}, to = {to}, count = {count} }}]\n[integrator]"
        )
    };
    let body = |sweep: &str| {
        let (system, rest) = BODY.split_once("[sweep]").unwrap();
        format!("{system}{sweep}{}", rest.split_once("[integrator]").unwrap().1)
    };
    // The moment I₂ is −1, 0 or 1: at 0 there is no Hamiltonian.
    let table = swept(&folder, &body(&axis("system.parameters.I[1]", -1.0, 1.0, 3)), "a");
    let reasons = failures(&table);
    assert!(reasons[0].is_none() && reasons[2].is_none(), "{reasons:?}");
    let expected = "[system] hamiltonian: the divisor is 0";
    assert!(reasons[1].as_ref().is_some_and(|reason| reason.contains(expected)), "{reasons:?}");
    let alone = swept(&folder, &body(&axis("system.parameters.I[1]", 1.0, 1.0, 1)), "b");
    let ends = |row: &Row| ["Pi1", "Pi2", "Pi3", "Gamma1"].map(|name| cell(row, name));
    assert_eq!(ends(&table[2]), ends(&alone[0]));
    assert_eq!(column(&table, "Pi1")[1], None);

    // Without brackets every coordinate is a Casimir.
    let flat = POINCARE.replace("'K, P' = 'H'", "'K, P' = 'a*H'");
    let flat = flat.replace("[integrator]", &axis("system.parameters.a", 0.0, 1.0, 2));
    let reasons = failures(&swept(&folder, &flat, "c"));
    let expected = "it has 3 Casimirs, and the system with the configured parameters 1";
    assert!(reasons[0].as_ref().is_some_and(|reason| reason.contains(expected)), "{reasons:?}");
    assert_eq!(reasons[1], None);

    folder.write("all.toml", &body(&axis("system.parameters.I[1]", 0.0, 0.0, 2)));
    let run = folder.heavytop(&["sweep", "all.toml", "--out", "d"]);
    assert_eq!(run.code(), 1, "{}", run.stderr());
    assert!(run.stderr().contains("all 2 runs failed; the first: "), "{}", run.stderr());
    assert!(run.stderr().ends_with("d/sweep.parquet.partial\n"), "{}", run.stderr());
}

#[test]
#[ignore = "long"]
fn a_dry_run_and_a_summary_tell_of_runs() {
    let folder = Folder::new();
    folder.write("a.toml", BODY);
    let run = folder.heavytop(&["sweep", "a.toml", "--out", "here", "--dry-run"]);
    assert_eq!(run.code(), 0, "{}", run.stderr());
    assert!(run.stdout().contains("600 runs of 10 steps"), "{}", run.stdout());
    assert_eq!(folder.names(), ["a.toml"]);
    let summary = |arguments: &[&str]| -> serde_json::Value {
        let run = folder.heavytop(&[arguments, &["--out", "here", "--json"]].concat());
        assert_eq!(run.code(), 0, "{}", run.stderr());
        serde_json::from_str(&run.stdout()).unwrap()
    };
    let of_system = summary(&["sweep", "a.toml"]);
    assert_eq!(of_system["runs"], 600);
    assert_eq!(of_system["casimirs"]["c2"], "|Gamma|^2");
    assert!(of_system.get("tops").is_none());
    let of_tops = summary(&["sweep", "--set", "integrator.end=0.1"]);
    assert_eq!((&of_tops["tops"], &of_tops["runs"]), (&1024.into(), &1024.into()));
    assert!(of_tops.get("casimirs").is_none());
}

#[test]
fn wrong_requests_are_refused_and_nothing_is_written() {
    let folder = Folder::new();
    let is_refused = |text: &str, message: &str| {
        folder.write("a.toml", text);
        let run = folder.heavytop(&["sweep", "a.toml", "--out", "made"]);
        assert_eq!(run.code(), 2, "{text}: {}", run.stderr());
        assert!(run.stderr().contains(message), "{text}: {}", run.stderr());
        assert_eq!((run.messages(), folder.names()), (1, vec!["a.toml".into()]));
    };
    let with = |parameter: &str| BODY.replace("system.parameters.I[1]", parameter);
    for (parameter, message) in [
        ("system.parameters.kk", "there is no system.parameters.kk; system.parameters has I, k"),
        ("system.parameters.I", "the axis system.parameters.I needs an index from 0 to 2\n"),
        (
            "system.parameters.I[3]",
            "the axis system.parameters.I[3] needs an index from 0 to 2, got 3\n",
        ),
        ("system.parameters.k[0]", "the axis system.parameters.k[0] needs no index"),
        ("system.initial.Gama1", "the coordinates are Pi1, Pi2, Pi3, Gamma1, Gamma2, Gamma3"),
        ("system.initial.Gama1", "did you mean `Gamma1`?"),
        ("system.initial.Gamma[3]", "needs an index from 0 to 2, got 3"),
        ("system.initial.Pi3", "the axes system.initial.Pi3 and system.initial.Pi[2] set the same"),
        ("system.hamiltonian", "unknown parameter `system.hamiltonian`; a system has"),
        ("body.mass", "the axis body.mass is of a top"),
    ] {
        is_refused(&with(parameter), message);
    }
    // The message quotes the axis at fault.
    is_refused(&with("system.parameters.I[3]"), "a.toml, line 9, column ");
    for (from, to, message) in [
        ("'sali'", "'rotation-number'", "the observable rotation-number is of a top; a system has"),
        ("'sali'", "'sali', 'sali'", "must not name one twice"),
        ("step = 0.1", "step = 0.3", "not a whole number of steps"),
        (
            "scheme =",
            "formulation = 'splitting'\nscheme =",
            "it has collective, reduced and direct",
        ),
        ("Pi1^2/I1", "Pi1^2/J1", "there is no `J1`"),
        ("Gamma = [0.6, 0, 0.8]", "Gamma1 = 0.6", "initial has no value for Gamma2, Gamma3"),
        ("[sweep]", "[body]\nmass = 2\n[sweep]", "a system has no [body]"),
        ("k = 0.25", "k = nan", "not a finite number"),
        ("count = 25 }", "count = 25, normalise = true }", "no normalise"),
    ] {
        assert!(BODY.contains(from));
        is_refused(&BODY.replace(from, to), message);
    }
    // The parameters of a top do not vary in a system by themselves.
    let (system, _) = BODY.split_once("axes = ").unwrap();
    is_refused(system, "[sweep] axes must have at least one axis");
    is_refused(
        "sweep.axes = [{ parameter = 'system.parameters.k', uniform = [1, 2] }]\nsweep.count = 2",
        "the axis system.parameters.k is of [system], and there is none here",
    );
    // A coordinate may have the name of another column.
    let named = POINCARE.replace('K', "failure").replace(
        "[integrator]",
        "[sweep]\nobservables = ['final-state']\ncount = 2\n\
         axes = [{ parameter = 'system.initial.H', uniform = [0, 1] }]\n[integrator]",
    );
    is_refused(&named, "two columns would have the name failure");
}
