//! Errors of `[system]`: why a configuration describes no Lie–Poisson system.

use super::open_keys::keys_of_open;
use lie_poisson_formula_systems::{FormulaSystemError, StructureTableError, SystemKind};
use lie_poisson_formulas::{NameError, Problem};
use lie_poisson_runs::ArrayKind;
use std::path::PathBuf;
use thiserror::Error;

/// The reason why a configuration describes no Lie–Poisson system.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum SystemTableError {
    /// A command for tops got a system.
    #[error(
        "only simulate, events, section, sweep and ensemble run a system; the other commands are for tops"
    )]
    CommandOfTops,
    /// A table of tops stands beside the system.
    #[error("a system has no [{0}], which is of tops: its keys are in [system]")]
    Top(&'static str),
    /// A key is missing.
    #[error("{0} is missing")]
    Missing(&'static str),
    /// There are several algebras: by name, of brackets, of structure constants.
    #[error(
        "write one of algebra, coordinates with brackets, and structure_constants with or without coordinates"
    )]
    TwoAlgebras,
    /// The matrices of a representation stand beside those of momenta.
    #[error("write representation or momenta, not both")]
    TwoRealisations,
    /// A system by name has an algebra or a Hamiltonian of its own.
    #[error("a kind has its algebra and its Hamiltonian: write neither, or leave out kind")]
    TwoSystems,
    /// A command whose formulas are of coordinates got a system of arrays.
    #[error(
        "{kind} has no section and no events here: it is an array, whose coordinates have no names in formulas; use \
         simulate, sweep or ensemble, or Python for events"
    )]
    OnlySimulated {
        /// The name of the kind of system.
        kind: &'static str,
    },
    /// The start is given twice.
    #[error("write initial or initial_file, not both")]
    TwoStarts,
    /// A system by formula has its start in a file.
    #[error("initial_file is of systems of arrays: write the coordinates in initial")]
    NoStartFile,
    /// The file of the start is not the one with which the run began.
    #[error("{} has changed since the run began", path.display())]
    OtherStart {
        /// The path of the file.
        path: PathBuf,
    },
    /// The structure constants are no table of a Lie algebra.
    #[error("structure_constants")]
    StructureConstants(#[source] StructureTableError),
    /// A name cannot be that of a parameter.
    #[error("{table}.{name}")]
    Parameter {
        /// The table of the name: parameters, or initial.
        table: &'static str,
        /// The name of the parameter.
        name: String,
        /// The error of the name.
        source: NameError,
    },
    /// There is no such system, no such method for it, or no such initial state.
    #[error(transparent)]
    Formula(#[from] FormulaSystemError),
    /// A coordinate has the name of a column that the output of the command has beside the coordinates.
    #[error(
        "the output would have two columns or arrays with the name {name}: rename the coordinate"
    )]
    SameColumn {
        /// The name of both columns.
        name: String,
    },
    /// A command that follows closed systems alone got a table of open ones.
    #[error(
        "[{table}] is for tops and systems by formula in simulate, events, section, sweep and ensemble; a spin-lattice has [inputs], \
         [drive], [damping] and [noise], and a sphere-fluid [damping], [noise] and [torque], in simulate and ensemble; other commands, \
         and other systems of arrays, have no forces"
    )]
    OpenTable {
        /// The name of the table.
        table: &'static str,
    },
    /// A key of the tables of forces is of other systems.
    #[error("{key} is of other systems: {has}")]
    OtherKey {
        /// The path of the key.
        key: String,
        /// The keys that systems of this kind have.
        has: &'static str,
    },
    /// A table of formulas has none.
    #[error("[{table}] has no formulas")]
    NoForces {
        /// The name of the table.
        table: &'static str,
    },
    /// A key of a table is missing.
    #[error("{key} is missing in [{table}]")]
    MissingKey {
        /// The name of the table.
        table: String,
        /// The key, and what it may be.
        key: &'static str,
    },
    /// The table of an input is given twice.
    #[error("[inputs.{input}] has file, or times and values, not both")]
    TwoTables {
        /// The name of the input.
        input: String,
    },
    /// An input would do nothing.
    #[error("no formula names the input {input}")]
    UnnamedInput {
        /// The name of the input.
        input: String,
    },
    /// There is no noise in `[noise]`, or more than one.
    #[error(
        "[noise] has one of temperature, which goes with [damping], strength, with or without inner_product, and fields"
    )]
    OneNoise,
    /// A column that is written on request is of tops that nothing drives, damps, shakes or forces.
    #[error("the column {column} is of tops that nothing drives, damps, shakes or forces")]
    ColumnOfClosed {
        /// The name of the column.
        column: &'static str,
    },
    /// A thin rod has no inverse inertia matrix.
    #[error("a thin rod, with a moment of 0, is not driven, damped, shaken or forced here")]
    OpenRod,
    /// The attitude of a system that is no body is asked for.
    #[error("a system has no attitude")]
    NoAttitude,
    /// A column is asked for that only tops have.
    #[error(
        "the column {column} is one of tops: a system has its coordinates and what it conserves"
    )]
    ColumnOfTops {
        /// The name of the column.
        column: &'static str,
    },
}

impl SystemTableError {
    /// Returns where the error is: `[system]`, or the tables beside it.
    #[must_use]
    pub fn table(&self) -> &'static str {
        match self {
            Self::OpenTable { .. }
            | Self::OtherKey { .. }
            | Self::NoForces { .. }
            | Self::MissingKey { .. }
            | Self::TwoTables { .. }
            | Self::UnnamedInput { .. }
            | Self::OneNoise
            | Self::ColumnOfClosed { .. }
            | Self::OpenRod
            | Self::Formula(FormulaSystemError::Open(_)) => "forces",
            Self::Formula(FormulaSystemError::KindValue { name, .. })
                if key_of_forces(name).is_some() =>
            {
                "forces"
            }
            _ => "[system]",
        }
    }

    /// Returns the keys that may be at fault, the likeliest first, each with what to write there.
    #[must_use]
    pub fn keys(&self) -> Vec<(String, &'static str)> {
        let key = |key: &str, note| vec![(key.to_owned(), note)];
        match self {
            Self::CommandOfTops => {
                key("system", "use simulate, events, section, sweep or ensemble")
            }
            Self::Top(table) => key(table, "remove the table"),
            Self::Missing(_) => key("system", "add the key"),
            Self::TwoAlgebras => ["brackets", "structure_constants", "coordinates", "algebra", ""]
                .map(|other| (below_system(other), "leave out all but one"))
                .to_vec(),
            Self::TwoSystems => [
                "hamiltonian",
                "algebra",
                "brackets",
                "structure_constants",
                "bracket",
                "representation",
                "representations",
                "momenta",
                "kind",
            ]
            .map(|other| (below_system(other), "leave it out"))
            .to_vec(),
            Self::TwoRealisations => key("system.momenta", "leave one of them out"),
            Self::OnlySimulated { .. } => key("system.kind", "use simulate, sweep or ensemble"),
            Self::TwoStarts | Self::NoStartFile | Self::OtherStart { .. } => {
                key("system.initial_file", "")
            }
            Self::StructureConstants(_) => key("system.structure_constants", ""),
            Self::SameColumn { .. } => key("system.coordinates", "choose another name"),
            Self::Parameter { table, name, .. } => vec![(format!("system.{table}.{name}"), "")],
            Self::Formula(error) => keys_of(error),
            Self::OpenTable { table } => key(table, "remove the table"),
            Self::OtherKey { key: path, .. } => key(path, "leave it out"),
            Self::NoForces { table } => key(table, "write formulas, or remove the table"),
            Self::MissingKey { table, .. } => key(table, "add the key"),
            Self::TwoTables { input } => {
                vec![(format!("inputs.{input}.file"), "leave it out, or times and values")]
            }
            Self::UnnamedInput { input } => {
                vec![(format!("inputs.{input}"), "name it in a formula, or remove the table")]
            }
            Self::OneNoise => key("noise", "write one of them"),
            Self::ColumnOfClosed { .. } => key("output.columns", "leave it out"),
            Self::OpenRod => key("body.inertia", ""),
            Self::NoAttitude => key("output.attitude", "write false, or leave it out"),
            Self::ColumnOfTops { .. } => key("output.columns", "leave it out"),
        }
    }
}

/// Returns the path of a key of `[system]`, or that of the table.
fn below_system(key: &str) -> String {
    if key.is_empty() { "system".into() } else { format!("system.{key}") }
}

/// Returns the key of the tables of forces that gives a number of this name, if there is one.
fn key_of_forces(name: &str) -> Option<&'static str> {
    Some(match name {
        "viscosity" => "damping.viscosity",
        "power" => "damping.power",
        "drag" => "damping.drag",
        "torque" => "torque.coefficients",
        "transport" => "noise.transport",
        "stirring" => "noise.stirring",
        _ => return None,
    })
}

/// Returns the keys that may be at fault for an error of the library.
fn keys_of(error: &FormulaSystemError) -> Vec<(String, &'static str)> {
    use FormulaSystemError as E;
    let key = |key: &str, note| vec![(below_system(key), note)];
    match error {
        E::Structure(_) => key("structure_constants", ""),
        E::NoAlgebra { .. } | E::AlgebraText { .. } => key("algebra", ""),
        E::Symbols { .. } => key("coordinates", ""),
        E::Representation { name, .. } => key(&format!("representations.{name}"), ""),
        E::Realisation { .. } => {
            ["representation", "momenta"].map(|of| (below_system(of), "")).to_vec()
        }
        E::Open(error) => keys_of_open(error),
        E::NoKind { .. } => key("kind", ""),
        E::KindParameter { is_start, name, .. } => {
            let table = if *is_start { "initial" } else { "parameters" };
            [format!("{table}.{name}"), "kind".into()].map(|of| (below_system(&of), "")).to_vec()
        }
        E::KindValue { kind, name, .. } => {
            if let Some(path) = key_of_forces(name) {
                return vec![(path.to_owned(), "")];
            }
            let start = SystemKind::named(kind).ok().and_then(|kind| kind.start);
            let start = start.map(|start| start.given);
            let start = start.or_else(|| ArrayKind::named(kind).map(|kind| kind.start));
            let of_start = start.is_some_and(|start| start.iter().any(|own| own.name == *name));
            key(&format!("{}.{name}", if of_start { "initial" } else { "parameters" }), "")
        }
        E::Dimension { .. } => ["coordinates", "algebra"].map(|of| (below_system(of), "")).to_vec(),
        E::Coordinates(_) => key("coordinates", ""),
        E::Parameters(_) => key("parameters", ""),
        E::NoPair { key: pair } => key(&format!("brackets.{pair}"), "the key is a pair, \"x, y\""),
        E::Bracket { key: pair, .. } | E::NotLinear { key: pair } => {
            key(&format!("brackets.{pair}"), "")
        }
        E::Jacobi { .. } | E::Brackets(_) | E::Casimirs(_) => {
            ["brackets", "structure_constants"].map(|of| (below_system(of), "")).to_vec()
        }
        E::Hamiltonian(error) if error.problem() == &Problem::Empty => {
            key("hamiltonian", "write a formula, such as \"Pi1^2 + 2*Pi2^2\"")
        }
        E::Hamiltonian(_) => key("hamiltonian", ""),
        E::NoFiniteValue(_) => ["hamiltonian", "initial"].map(|of| (below_system(of), "")).to_vec(),
        E::NoValue { .. } => key("initial", "a value is missing"),
        E::SecondValue { name, .. } => key(&format!("initial.{name}"), "leave one of them out"),
        E::NoCoordinate { name, .. } | E::WrongValue { name, .. } => {
            key(&format!("initial.{name}"), "")
        }
        E::NoMethod { formulation, has, .. } => {
            // The message lists the schemes of a formulation that there is.
            let keys = ["integrator.formulation", "integrator.scheme"];
            let is_scheme = has.starts_with(formulation.name());
            let keys = if is_scheme { [keys[1], keys[0]] } else { keys };
            keys.map(|key| (key.into(), "")).to_vec()
        }
        _ => Vec::new(),
    }
}
