//! Systems by kind and algebras by expression: the rows of `simulate` are those of the library, to the bit.

use crate::program::{Finished, Folder, numbers};
use heavytop::methods::{Formulation, SchemeName};
use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra, SystemKind};
use lie_poisson_formulas::Parameters;
use lie_poisson_runs::{Experiment, Pace, RunFailure, Schedule};

/// A system by kind: its name, the names of its columns, and the numbers of `parameters` and `initial` as TOML.
const KINDS: [(&str, &str, &str, &str); 10] = [
    (
        "body-in-fluid",
        "Pi1,Pi2,Pi3,P1,P2,P3,h,c1,c2",
        "inertia = [2, 2.5, 3], masses = [3, 1.5, 2]",
        "Pi = [1, 0.5, 0.2], P = [0.3, 1, 0]",
    ),
    (
        "body-with-rotors",
        "Pi1,Pi2,Pi3,l1,l2,h,c1,c2,c3",
        "I = [1, 2, 3], J = [0.1, 0.2]",
        "Pi = [0.3, 1, 0.2], l = [0.2, 0.1]",
    ),
    (
        "elliptical-vortex",
        "mu1,mu2,mu3,h,c1",
        "strength = 1, strain = 0.05",
        "a = 1.5, b = 0.5, angle = 0.3",
    ),
    (
        "gyrostat",
        "Pi1,Pi2,Pi3,Gamma1,Gamma2,Gamma3,h,c1,c2",
        "inertia = [2, 2, 1], weight = 1, center_of_mass = [0, 0, 1], rotor = [0, 0, 2]",
        "Pi = [0.5, 0, 3], Gamma = [0.6, 0, 0.8]",
    ),
    (
        "reaction-wheels",
        "Pi1,Pi2,Pi3,l1,l2,h,c1,c2,c3",
        "I = [1, 2, 3], axes = [[0, 1, 0], [3, 0, 4]], J = 0.1",
        "Omega = [0.3, 1, 0.2], speeds = [2, -3]",
    ),
    (
        "rigid-body",
        "L12,L13,L14,L23,L24,L34,h,c1,c2",
        "moments = [1, 1.5, 2, 2.5]",
        "L12 = 1, L13 = 0.2, L14 = -0.3, L23 = 0.5, L24 = 0.1, L34 = 0.7",
    ),
    (
        "satellite",
        "Pi1,Pi2,Pi3,Gamma_1_1,Gamma_1_2,Gamma_1_3,Gamma_2_1,Gamma_2_2,Gamma_2_3,h,c1,c2,c3",
        "I = [1, 1.2, 0.4], n = 1.3",
        "roll = 0.3, pitch = -0.2, relative = [0.1, 0, 0.2]",
    ),
    (
        "spin-chain",
        "S_1_1,S_1_2,S_1_3,S_2_1,S_2_2,S_2_3,S_3_1,S_3_2,S_3_3,h,c1,c2,c3",
        "spins = 3, exchange = 1, field = [0, 0, 0.2]",
        "S_1 = [1, 0, 0], S_2 = [0, 1, 0], S_3 = [0, 0.6, 0.8]",
    ),
    (
        "top-on-base",
        "Pi1,Pi2,Pi3,P1,P2,P3,Gamma1,Gamma2,Gamma3,h,c1,c2,c3",
        "inertia = [2, 2, 1], mass = 0.8, base_mass = 1.3, gravity = 9.8, center_of_mass = [0, 0, 0.5]",
        "Pi = [0.5, 0, 5], P = [0.1, 0, 0], Gamma = [0.6, 0, 0.8]",
    ),
    (
        "vortices",
        "m_1_1,m_1_2,m_1_3,m_2_1,m_2_2,m_2_3,h,c1,c2",
        "strengths = [1, -0.7]",
        "positions = [[1, 0, 0], [0, 0.6, 0.8]]",
    ),
];

fn succeeded(done: &Finished) {
    assert_eq!(done.code(), 0, "{}", done.stderr());
}

fn refused(done: &Finished) -> String {
    assert_eq!(done.code(), 2, "{}", done.stderr());
    done.stderr()
}

/// Returns the parameters of an inline table.
fn parameters(text: &str) -> Parameters {
    let table: toml::Table = toml::from_str(&format!("all = {{ {text} }}")).unwrap();
    let number =
        |value: &toml::Value| value.as_float().or_else(|| value.as_integer().map(|n| n as f64));
    fn flat(value: &toml::Value) -> Vec<toml::Value> {
        match value {
            toml::Value::Array(rows) => rows.iter().flat_map(flat).collect(),
            one => vec![one.clone()],
        }
    }
    table["all"].as_table().unwrap().iter().fold(Parameters::new(), |all, (name, value)| {
        match number(value) {
            Some(one) => all.number(name, one).unwrap(),
            None => {
                let values: Vec<f64> = flat(value).iter().filter_map(number).collect();
                all.vector(name, &values).unwrap()
            }
        }
    })
}

/// Returns the rows of a run of a system by its default method.
fn rows(model: FormulaSystem, start: Vec<f64>) -> Vec<Vec<f64>> {
    let algebra = model.algebra();
    let method = algebra.method(algebra.default_formulation(), SchemeName::Gauss(4), 0.0).unwrap();
    let pace = Pace { schedule: Schedule::new(0.05, 2.0).unwrap(), every: 10 };
    let run = Experiment { model, start, method, pace, attitude: false };
    let mut rows = Vec::new();
    run.follow(None, |moment| -> Result<(), RunFailure> {
        rows.push(moment.row.to_vec());
        Ok(())
    })
    .unwrap();
    rows
}

const PACE: &str = "[integrator]\nstep = 0.05\nend = 2\n[output]\nevery = 10\n";

#[test]
fn every_kind_has_the_bits_of_the_library() {
    assert_eq!(
        KINDS.map(|(name, ..)| name),
        SystemKind::ALL.iter().map(|kind| kind.name).collect::<Vec<_>>()[..]
    );
    let folder = Folder::new();
    for (name, columns, given, initial) in KINDS {
        let text = format!(
            "[system]\nkind = '{name}'\nparameters = {{ {given} }}\ninitial = {{ {initial} }}\n{PACE}"
        );
        folder.write("kind.toml", &text);
        succeeded(&folder.heavytop(&["simulate", "kind.toml", "--out", "kind.csv", "--force"]));
        let (header, found) = numbers(&folder.read("kind.csv"));
        assert_eq!(header.join(","), format!("t,{columns}"));
        let kind = SystemKind::named(name).unwrap();
        let (given, initial) = (parameters(given), parameters(initial));
        let system = kind.system(&given).unwrap();
        let start = kind.coordinates(&given, &initial).unwrap_or_else(|| {
            let names: Vec<&str> = initial.shapes().map(|(name, _)| name).collect();
            let values = names.iter().map(|name| (*name, initial.values(name).unwrap()));
            system.algebra().state(values)
        });
        assert_eq!(found, rows(system, start.unwrap()), "{name}");
        // What a kind needs is told where it is missing.
        folder.write("bare.toml", &format!("[system]\nkind = '{name}'\n"));
        let said = refused(&folder.heavytop(&["simulate", "bare.toml", "--out", "bare.csv"]));
        assert!(kind.parameters.iter().all(|own| said.contains(own.name)), "{said}");
    }
}

#[test]
fn an_algebra_by_expression_with_other_symbols_and_the_plus_bracket() {
    let folder = Folder::new();
    let text = |bracket: &str| {
        format!(
            "[system]\nalgebra = 'so(3)^3'\ncoordinates = ['S']\nhamiltonian = '-sum(S[i]·S[i+1]) - S3[3]'\n{bracket}\
             initial = {{ S_1 = [1, 0, 0], S_2 = [0, 1, 0], S_3 = [0, 0.6, 0.8] }}\n{PACE}"
        )
    };
    let run = |bracket: &str| {
        folder.write("spins.toml", &text(bracket));
        succeeded(&folder.heavytop(&["simulate", "spins.toml", "--out", "spins.csv", "--force"]));
        numbers(&folder.read("spins.csv")).1
    };
    let system = |is_plus: bool| {
        let algebra = SystemAlgebra::named("so(3)^3").unwrap().with_symbols(&["S"]).unwrap();
        assert_eq!(algebra.default_formulation(), Formulation::Collective);
        let system =
            FormulaSystem::new(algebra, "-sum(S[i]·S[i+1]) - S3[3]", &Parameters::new()).unwrap();
        let system = if is_plus { system.with_plus_bracket().unwrap() } else { system };
        system.with_found_casimirs().unwrap()
    };
    let start = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.6, 0.8]].concat();
    let plus = run("bracket = 'plus'\n");
    assert_eq!(plus, rows(system(true), start.clone()));
    let minus = run("");
    assert_eq!(minus, rows(system(false), start));
    assert_eq!(minus, run("bracket = 'minus'\n"));
    // Control: the two brackets move the spins in opposite directions.
    assert_ne!(plus, minus);
}

#[test]
fn what_is_no_algebra_and_no_start_is_refused() {
    let folder = Folder::new();
    let said = |text: &str| {
        folder.write("wrong.toml", text);
        refused(&folder.heavytop(&["simulate", "wrong.toml", "--out", "wrong.csv"]))
    };
    let message =
        said("[system]\nalgebra = 'so(3) + '\nhamiltonian = '1'\ninitial = { Pi = [1, 0, 0] }\n");
    assert!(
        message.contains("column 9: an algebra, such as so(3), must stand where the text ends"),
        "{message}"
    );
    assert!(message.contains("algebra = 'so(3) + '"), "{message}");
    let message =
        said("[system]\nalgebra = 'so(3)^2'\ncoordinates = ['S', 'T']\nhamiltonian = '1'\n");
    assert!(message.contains("2 symbols; the algebra has 1: Pi"), "{message}");
    let vortices = |positions: &str| {
        said(&format!(
            "[system]\nkind = 'vortices'\nparameters.strengths = [1, 2]\ninitial.positions = {positions}\n"
        ))
    };
    assert!(vortices("[[1, 0, 0]]").contains("three numbers for each of 2 vortices, got 3"));
    assert!(vortices("[[1, 0], [0, 1, 0, 0]]").contains("rows of one length"));
    assert!(vortices("[[1, 0, 0], [0, 2, 0]]").contains("the length of number 2 is 2"));
    let message = said("[system]\nkind = 'vortices'\nbracket = 'plus'\n");
    assert!(message.contains("write neither"), "{message}");
    assert!(!folder.path("wrong.csv").exists());
}

/// The members of a sweep over strengths start at the positions, whatever their strengths.
#[test]
fn a_sweep_of_strengths_keeps_the_positions() {
    let folder = Folder::new();
    let system = "[system]\nkind = 'vortices'\nparameters.strengths = [1, 1]\n\
                  initial.positions = [[1, 0, 0], [0, 1, 0]]\n[integrator]\nstep = 0.01\nend = 0.1\n";
    let sweep = "[sweep]\nobservables = ['final-state']\n[[sweep.axes]]\n\
                 parameter = 'system.parameters.strengths[0]'\nfrom = 0.5\nto = 2.5\ncount = 3\n";
    folder.write("sweep.toml", &format!("{system}{sweep}"));
    folder.write("run.toml", system);
    succeeded(&folder.heavytop(&["sweep", "sweep.toml", "--out", "sweep"]));
    let file = std::fs::File::open(folder.path("sweep/sweep.parquet")).unwrap();
    let reader = parquet::file::serialized_reader::SerializedFileReader::new(file).unwrap();
    for (row, strength) in reader.into_iter().zip([0.5, 1.5, 2.5]) {
        let row = row.unwrap();
        let cell = |name: &str| {
            let (_, field) = row.get_column_iter().find(|(column, _)| *column == name).unwrap();
            field.to_string().parse::<f64>().unwrap()
        };
        let set = format!("system.parameters.strengths=[{strength:?},1.0]");
        succeeded(&folder.heavytop(&[
            "simulate",
            "run.toml",
            "--set",
            &set,
            "--set",
            "integrator.formulation=reduced",
            "--out",
            "run.csv",
            "--force",
        ]));
        let (header, rows) = numbers(&folder.read("run.csv"));
        let last = rows.last().unwrap();
        for name in ["m_1_1", "m_2_3"] {
            let place = header.iter().position(|column| column == name).unwrap();
            assert!((cell(name) - last[place]).abs() < 1e-13, "{strength} {name}");
        }
        assert!((cell("m_1_1") - strength).abs() < 0.01);
    }
}

/// A body along the vectors (q, p) of R³, with the momentum q × p.
#[test]
fn a_realisation_of_ones_own_makes_the_collective_steps() {
    let folder = Folder::new();
    let body = "[system]\nalgebra = 'so(3)'\nhamiltonian = 'Pi1^2 + Pi2^2/2 + 0.3*Pi3^2 + 0.1*Pi1^4'\n\
                initial = { Pi = [0.6, 0.8, 0.3] }\n";
    let end =
        "[integrator]\nformulation = 'collective'\nscheme = 'gauss-4'\nstep = 0.1\nend = 50\n";
    // Π = q × p
    let matrices = "representation = [[[0,0,0],[0,0,-1],[0,1,0]], [[0,0,1],[0,0,0],[-1,0,0]], [[0,-1,0],[1,0,0],[0,0,0]]]\n";
    let last = |text: &str, out: &str| {
        folder.write("a.toml", text);
        let run = folder.heavytop(&["simulate", "a.toml", "--out", out]);
        assert_eq!((run.code(), run.complaints().as_str()), (0, ""), "{}", run.stderr());
        numbers(&folder.read(out)).1
    };
    let own = last(&format!("{body}{matrices}{end}"), "own.csv");
    let hopf = last(&format!("{body}{end}"), "hopf.csv");
    // Both keep |Π|² to round-off of 500 steps; they are other maps, of one order.
    let casimir = |rows: &[Vec<f64>]| {
        let of = |row: &Vec<f64>| row[1] * row[1] + row[2] * row[2] + row[3] * row[3];
        rows.iter().map(|row| (of(row) - of(&rows[0])).abs()).fold(0.0, f64::max)
    };
    assert!(
        casimir(&own) < 1e-13 && casimir(&hopf) < 1e-13,
        "{} {}",
        casimir(&own),
        casimir(&hopf)
    );
    let apart = (0..3).map(|i| (own[100][i + 1] - hopf[100][i + 1]).abs()).fold(0.0, f64::max);
    assert!(apart > 1e-12 && apart < 1e-3, "{apart}");
    for (given, said) in [
        (matrices.replace("[0,0,-1]", "[0,0,-2]"), "realisation:"),
        (matrices.replace("[0,0,-1]", "[0,-1]"), "the rows of matrix 1 have different lengths"),
        ("representation = [[[0,-1],[1,0]]]\n".into(), "realisation:"),
        (format!("{matrices}momenta = [[[0,1],[1,0]]]\n"), "representation or momenta, not both"),
        ("momenta = [[[0,1],[2,0]]]\n".into(), "matrix 1 is not symmetric"),
    ] {
        folder.write("wrong.toml", &format!("{body}{given}{end}"));
        let run = folder.heavytop(&["simulate", "wrong.toml", "--out", "none.csv"]);
        assert!(run.code() == 2 && run.stderr().contains(said), "{said}: {}", run.stderr());
        assert!(run.stderr().contains("wrong.toml, line "), "{}", run.stderr());
    }
}

/// An ellipse that a strain stretches without end: its area is the difference of squares that grow exponentially.
#[test]
fn a_run_that_has_used_up_its_digits_says_so() {
    let folder = Folder::new();
    let text = "[system]\nkind = 'elliptical-vortex'\nparameters = { strength = 2, strain = 0.4, rotation = 0.05 }\n\
                initial = { a = 2, b = 1, angle = 0.3 }\n[integrator]\nstep = 0.05\n";
    folder.write("a.toml", text);
    let run = |end: &str| {
        let set = format!("integrator.end={end}");
        let run =
            folder.heavytop(&["simulate", "a.toml", "--out", "a.csv", "--force", "--set", &set]);
        assert_eq!(run.code(), 0, "{}", run.stderr());
        let rows = numbers(&folder.read("a.csv")).1;
        let area = (rows.last().unwrap()[5] - rows[0][5]).abs() / rows[0][5].abs();
        (run.stderr(), area)
    };
    // At t = 5 the area is right, and nothing is said; at t = 19 it is not.
    let (said, area) = run("5");
    assert!(area < 1e-9 && !said.contains("warning"), "{said} {area}");
    let (said, area) = run("19");
    assert!(said.contains("c1, of size 4.0e0, is at the end a difference of terms of "), "{said}");
    assert!(area > 1e-6, "{area}");
}
