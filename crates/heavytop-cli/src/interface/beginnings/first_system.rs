//! The command `init --kind`: a configuration of a system by name, or of one with forces, with comments, to begin with.

use super::first_configuration::write_new;
use super::first_forces::WITH_FORCES;
use crate::errors::{Error, SystemTableError};
use crate::files::Kind;
use lie_poisson_formula_systems::{FormulaSystemError, Parameter, SystemKind};
use lie_poisson_runs::ArrayKind;
use std::path::Path;

/// How a configuration is recognised that nobody has edited since.
const KIND: Kind<'_> = Kind {
    name: "configuration as init writes it",
    first: b"# A system for the program heavytop:",
    is_whole: |head, _| {
        Ok(names().any(|name| text(name).is_some_and(|text| text.as_bytes() == head)))
    },
};

/// A system to begin with: the values of its parameters and of its start that are written, step and end.
struct Template {
    kind: &'static str,
    parameters: &'static [(&'static str, &'static str)],
    initial: &'static [(&'static str, &'static str)],
    times: [f64; 2],
}

const TEMPLATES: [Template; 13] = [
    Template {
        kind: "body-in-fluid",
        parameters: &[("inertia", "[1, 2, 3]"), ("masses", "[1, 2, 4]")],
        initial: &[("Pi", "[1, 0.5, 0.3]"), ("P", "[0.6, 0, 0.8]")],
        times: [0.02, 50.0],
    },
    Template {
        kind: "body-with-rotors",
        parameters: &[("I", "[1, 2, 3]"), ("J", "[0.1, 0.2]")],
        initial: &[("Pi", "[0.3, 1, 0.2]"), ("l", "[0.2, 0.1]")],
        times: [0.05, 50.0],
    },
    Template {
        kind: "elliptical-vortex",
        parameters: &[("strength", "1"), ("strain", "0.05")],
        initial: &[("a", "1.5"), ("b", "0.5"), ("angle", "0.3")],
        times: [0.05, 50.0],
    },
    Template {
        kind: "gyrostat",
        parameters: &[
            ("inertia", "[2, 2, 1]"),
            ("weight", "1"),
            ("center_of_mass", "[0, 0, 1]"),
            ("rotor", "[0, 0, 2]"),
        ],
        initial: &[("Pi", "[0.5, 0, 3]"), ("Gamma", "[0.6, 0, 0.8]")],
        times: [0.02, 50.0],
    },
    Template {
        kind: "reaction-wheels",
        parameters: &[
            ("I", "[3, 2, 1.5]"),
            ("axes", "[[1, 0, 0], [0, 1, 0], [0, 0, 1]]"),
            ("J", "0.1"),
        ],
        initial: &[("Omega", "[0.1, 0.3, 0.2]"), ("speeds", "[0, 0, 10]")],
        times: [0.1, 60.0],
    },
    Template {
        kind: "rigid-body",
        parameters: &[("moments", "[1, 1.5, 2, 2.5]")],
        initial: &[
            ("L12", "1"),
            ("L13", "0.2"),
            ("L14", "-0.3"),
            ("L23", "0.5"),
            ("L24", "0.1"),
            ("L34", "0.7"),
        ],
        times: [0.05, 50.0],
    },
    Template {
        kind: "satellite",
        parameters: &[("I", "[1, 1.2, 0.4]"), ("n", "0.001")],
        initial: &[("pitch", "0.3"), ("roll", "0.1")],
        times: [60.0, 48_000.0],
    },
    Template {
        kind: "sphere-fluid",
        parameters: &[("size", "32")],
        initial: &[("degrees", "[2, 8]"), ("rms", "1"), ("seed", "1")],
        times: [0.02, 20.0],
    },
    Template {
        kind: "spin-chain",
        parameters: &[("spins", "4"), ("exchange", "1")],
        initial: &[
            ("S_1", "[0.3, 0, 0.9]"),
            ("S_2", "[0, 0.3, 0.9]"),
            ("S_3", "[-0.3, 0, 0.9]"),
            ("S_4", "[0, -0.3, 0.9]"),
        ],
        times: [0.05, 50.0],
    },
    Template {
        kind: "spin-lattice",
        parameters: &[("shape", "[24, 24]"), ("exchange", "1"), ("anisotropy", "0.2")],
        initial: &[
            ("direction", "[0, 0, 1]"),
            ("waves", "[1, 0]"),
            ("cone", "0.4"),
            ("tilt", "0.1"),
            ("seed", "1"),
        ],
        times: [0.05, 20.0],
    },
    Template {
        kind: "top-on-base",
        parameters: &[
            ("inertia", "[2, 2, 1]"),
            ("mass", "0.8"),
            ("base_mass", "1.3"),
            ("gravity", "9.8"),
            ("center_of_mass", "[0, 0, 0.5]"),
        ],
        initial: &[("Pi", "[0.5, 0, 5]"), ("P", "[0.1, 0, 0]"), ("Gamma", "[0.6, 0, 0.8]")],
        times: [0.02, 50.0],
    },
    Template {
        kind: "vibrating-lattice",
        parameters: &[("atoms", "64"), ("exchange", "1"), ("coupling", "0.3")],
        initial: &[("waves", "[2]"), ("cone", "0.5"), ("tilt", "0.1"), ("seed", "1")],
        times: [0.05, 50.0],
    },
    Template {
        kind: "vortices",
        parameters: &[("strengths", "[1, 1, -0.5]")],
        initial: &[("positions", "[[1, 0, 0], [0, 1, 0], [0, 0, 1]]")],
        times: [0.05, 100.0],
    },
];

/// Writes a commented configuration of a system by name into a file, or to stdout.
///
/// # Errors
/// If there is no such system, the file exists and has been edited, unless it is replaced by force; or it cannot be written.
pub(in crate::interface) fn init_system(
    kind: &str,
    file: Option<&Path>,
    force: bool,
) -> Result<(), Error> {
    let text = text(kind).ok_or_else(|| {
        let kinds = names().map(str::to_owned).collect();
        SystemTableError::from(FormulaSystemError::NoKind { name: kind.into(), kinds })
    })?;
    write_new(&text, &KIND, file, force)
}

/// Returns the names of all configurations.
fn names() -> impl Iterator<Item = &'static str> {
    let with_forces = WITH_FORCES.iter().map(|(name, _)| *name);
    TEMPLATES.iter().map(|template| template.kind).chain(with_forces)
}

/// Returns the configuration of a name.
fn text(name: &str) -> Option<String> {
    let template = TEMPLATES.iter().find(|template| template.kind == name).map(Template::text);
    let with_forces = || WITH_FORCES.iter().find(|(own, _)| *own == name);
    template.or_else(|| with_forces().map(|(_, text)| (*text).to_owned()))
}

impl Template {
    /// Returns the configuration as TOML with comments.
    fn text(&self) -> String {
        let (mut about, mut parameters, mut start): (_, &[Parameter], &[Parameter]) =
            ("", &[], &[]);
        if let Some(kind) = ArrayKind::named(self.kind) {
            (about, parameters, start) = (kind.about, kind.parameters, kind.start);
        }
        // A few vortices are a system by formula.
        if let Ok(kind) = SystemKind::named(self.kind) {
            (about, parameters) = (kind.about, kind.parameters);
            start = kind.start.map_or(&[], |start| start.given);
        }
        let [step, end] = self.times;
        format!(
            "# A system for the program heavytop: {about}.\n\
             # Run it: heavytop simulate FILE --out run.npz\n\
             # Draw it: heavytop plot run.npz --out run.png\n\n\
             [system]\nkind = \"{}\"\n\n\
             [system.parameters]\n{}\n[system.initial]\n{}\n\
             [integrator]\nstep = {step:?}\nend = {end:?}\n\n\
             [output]\nevery = 1                    # keep every n-th step, and the last\n",
            self.kind,
            lines(self.parameters, parameters),
            lines(self.initial, start)
        )
    }
}

/// Returns the lines of a table: the values that are written, and then those that may be.
fn lines(given: &[(&str, &str)], all: &[Parameter]) -> String {
    let own = |name: &str| all.iter().find(|own| own.name == name);
    let mut text = String::new();
    for (name, value) in given {
        let about = own(name).map_or(String::new(), |own| format!(" # {}", own.about));
        let line = format!("{name} = {value}");
        text += format!("{line:<28}{about}").trim_end();
        text.push('\n');
    }
    let is_given = |name: &str| given.iter().any(|(own, _)| *own == name);
    for own in all.iter().filter(|own| !is_given(own.name)) {
        let default = match own.default {
            Some([value]) => format!("{value}"),
            Some(values) if !values.is_empty() => format!("{values:?}"),
            _ => "[]".into(),
        };
        let line = format!("# {} = {default}", own.name);
        text += &format!("{line:<28} # {}\n", own.about);
    }
    text
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::configuration::Config;

    /// Every system has a template, which describes a run; its comments can be uncommented where they are no empty list.
    #[test]
    fn every_system_has_a_configuration_to_begin_with() {
        let kinds = SystemKind::ALL.iter().map(|kind| kind.name);
        for kind in kinds.chain(ArrayKind::ALL.iter().map(|kind| kind.name)) {
            let template = TEMPLATES.iter().find(|template| template.kind == kind).unwrap();
            let text = template.text();
            let config: Config = toml::from_str(&text).unwrap();
            let run = config.run().unwrap();
            assert_eq!(run.pace.schedule.end(), template.times[1], "{kind}");
            assert!(text.lines().all(|line| line.chars().count() <= 140), "{text}");
        }
        for (name, text) in WITH_FORCES {
            let run = toml::from_str::<Config>(text).unwrap().run().unwrap();
            assert!(run.pace.schedule.steps > 1, "{name}");
            assert!(text.as_bytes().starts_with(KIND.first), "{name}");
            assert!(text.lines().all(|line| line.chars().count() <= 140), "{text}");
        }
        assert!(init_system("spin-latice", None, false).is_err());
    }
}
