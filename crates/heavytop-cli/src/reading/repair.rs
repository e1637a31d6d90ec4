//! Repairs: the keys to which a refusal refers, and what to write instead.

use crate::configuration::{Config, Integration};
use crate::errors::{Error, SweepError, SystemTableError};
use crate::vocabulary::brief::number;
use heavytop::methods::MethodError;
use heavytop::{SectionError, TopError};
use lie_poisson_formula_systems::FormulaSystemError;
use lie_poisson_runs::RunFailure;

/// A key that may be at fault, and what to write there.
pub(super) type Repair = (String, String);

/// Returns the keys to which the refusal refers, the likeliest first, each with a repair.
pub(super) fn repairs(error: &Error, config: &Config) -> Vec<Repair> {
    let repair = |key: &str, note: String| (key.to_string(), note);
    match error {
        Error::Body(top) => vec![of_vector("body", top, config.body.center_of_mass)],
        Error::InputFile { name, .. } => {
            vec![repair(&format!("inputs.{name}.file"), String::new())]
        }
        Error::CentralMoments => {
            let note = "write mass and length too, or moments about the support".to_string();
            vec![repair("body.inertia_about", note)]
        }
        Error::Spin(TopError::RodSpin { axis, .. }) => {
            let note = "write 0.0".to_string();
            vec![repair(&format!("initial.angular_momentum[{axis}]"), note)]
        }
        Error::Vertical(TopError::NotUnit { name: "attitude", .. }) => {
            let note = "write a quaternion of length 1, or `normalise = true`".to_string();
            vec![repair("initial.attitude", note)]
        }
        Error::Vertical(top) => vec![of_vector("initial", top, config.initial.direction())],
        Error::Start(_) if config.system.is_some() => vec![repair("system.initial", String::new())],
        Error::AzimuthAlone => vec![repair("initial.azimuth", "write both".into())],
        Error::OutOfRange { name, range, .. } => vec![repair(name, format!("must be {range}"))],
        Error::TooManyPoints { .. } => ["section.starts", "section.crossings"]
            .map(|key| repair(key, "write less".into()))
            .to_vec(),
        Error::Run(RunFailure::BrokenStep { before, after, .. }) => {
            let ends = [*before, *after].into_iter().filter(|end| *end != 0.0).map(number);
            let ends = ends.collect::<Vec<_>>().join(" or ");
            let step = "does not divide the end".to_string();
            vec![repair("integrator.end", format!("write {ends}")), repair("integrator.step", step)]
        }
        Error::Run(RunFailure::OppositeEnd { step, end }) => vec![
            repair("integrator.end", format!("write {}", number(-end))),
            repair("integrator.step", format!("write {}", number(-step))),
        ],
        Error::Run(RunFailure::TooManySteps { steps, most }) => too_long(steps / most, config),
        Error::Run(RunFailure::AbsurdStep { step, angle, most }) => {
            let bound = step * most / angle;
            let note = match bound {
                0.0.. => format!("write at most {bound:.3e}"),
                ..0.0 => format!("write at least {bound:.3e}"),
                _ => "write less".into(),
            };
            let fast = "the motion is too fast for the step".to_string();
            vec![
                repair("integrator.step", note),
                repair("system.initial", fast.clone()),
                repair("initial.angular_momentum", fast.clone()),
                repair("initial.angular_velocity", fast.clone()),
                repair("body.inertia", fast),
            ]
        }
        Error::Method(MethodError::NoSuchPair { formulation, .. }) => {
            let schemes = formulation.schemes().map(|scheme| format!("`{}`", scheme.name()));
            let first = schemes.take(1).collect::<String>();
            vec![
                repair("integrator.scheme", format!("write {first}, or another of its schemes")),
                repair("integrator.formulation", format!("write `scheme` too, such as {first}")),
            ]
        }
        Error::UnknownLength => {
            let note = "write `mass`, `gravity` and `length` instead".to_string();
            vec![repair("body.weight_moment", note), repair("output.columns", "".into())]
        }
        Error::ColumnOfAttitude { .. } => vec![
            repair("integrator.formulation", "write `collective`, `reduced` or `splitting`".into()),
            repair("output.columns", "leave it out".into()),
        ],
        Error::Run(RunFailure::NoAttitude { .. }) => vec![
            repair("output.attitude", "write false, or choose another formulation".into()),
            repair("integrator.formulation", "write `collective`, `reduced` or `splitting`".into()),
        ],
        Error::System(system) => of_system(system),
        Error::Section(section) => of_section(section),
        Error::SystemSection(error) => of_system_section(error),
        Error::NoEvents => vec![repair("events", "add the key".into())],
        Error::EventFunction { number, .. } => {
            vec![repair(&format!("events.functions[{number}]"), String::new())]
        }
        Error::UnknownSurface(_) => vec![repair("section.surface", String::new())],
        Error::NoSurface => vec![repair("section", "add the key".into())],
        Error::NoisyFunction { key, .. } => {
            vec![repair(key, "write a function of t alone".into())]
        }
        Error::SectionKey { key, .. } => {
            vec![repair(&format!("section.{key}"), "remove the key".into())]
        }
        Error::PlaneLimits { axis, .. } => {
            vec![repair(&format!("section.limits.{axis}"), "write [from, to]".into())]
        }
        Error::NeverCrosses { state, .. } => {
            let key = format!("section.states[{}]", state.saturating_sub(1));
            vec![repair(&key, String::new()), repair("section.surface", String::new())]
        }
        Error::Sweep(sweep) => of_sweep(sweep, config),
        _ => Vec::new(),
    }
}

/// Returns the repairs of a run that is so many times too long. The end is at fault, unless the step is farther from its
/// usual value.
fn too_long(times: f64, config: &Config) -> Vec<Repair> {
    let times = number(times.ceil());
    let usual = Integration::default();
    let Integration { step, end, .. } = config.integrator.or(usual);
    let mut repairs = vec![
        ("integrator.end".to_string(), format!("write {times} times less")),
        ("section.longest".to_string(), format!("write {times} times less")),
        ("integrator.step".to_string(), format!("write {times} times as much, or more")),
    ];
    if usual.step / step.abs() > end.abs() / usual.end {
        repairs.reverse();
    }
    repairs
}

/// Returns the repair of a number in a table, or of its unit vector.
fn of_vector(table: &str, error: &TopError, vector: [f64; 3]) -> Repair {
    let (name, note) = match error {
        TopError::NotFinite { name, .. } => (*name, "write a finite number".into()),
        TopError::NotPositive { name, .. } => (*name, "write a number above 0".into()),
        TopError::Negative { name, value } => (*name, format!("write {}", number(-value))),
        TopError::OutOfRange { name, least, greatest, .. } => {
            (*name, format!("write {} to {}", number(*least), number(*greatest)))
        }
        TopError::Triangle { first, second, .. } => {
            ("inertia", format!("the largest must be at most {}", number(first + second)))
        }
        TopError::NotUnit { name, length, .. } => (*name, unit(vector, *length)),
        TopError::ImpossibleBody { .. } => ("inertia", "no body has these moments".into()),
        TopError::NotSymmetric { mirrored, .. } => {
            ("inertia", format!("write {} in both places", number(*mirrored)))
        }
        TopError::RodCenter { axis, .. } => {
            ("center_of_mass", format!("write a unit vector along axis {}", axis + 1))
        }
        _ => ("", String::new()),
    };
    (format!("{table}.{name}"), note)
}

/// Offers the vector of length 1 in the same direction.
fn unit(vector: [f64; 3], length: f64) -> String {
    if length > 0.0 && length.is_finite() {
        let [x, y, z] = vector.map(|x| x / length);
        format!("write [{x:?}, {y:?}, {z:?}], or `normalise = true`")
    } else {
        "write a vector of length 1, such as [0.0, 0.0, 1.0]".into()
    }
}

fn of_system(error: &SystemTableError) -> Vec<Repair> {
    error.keys().into_iter().map(|(key, note)| (key, note.to_owned())).collect()
}

fn of_section(error: &SectionError) -> Vec<Repair> {
    let repair = |key: &str, note: String| (format!("section.{key}"), note);
    match error {
        SectionError::NotFinite { name, .. } => vec![repair(name, "write a finite number".into())],
        SectionError::NoSuchVertical { .. } => {
            vec![repair("level", "write more than -1 and less than 1".into())]
        }
        SectionError::Empty { least, .. } => {
            vec![repair("energy", format!("write more than {}", number(*least)))]
        }
        SectionError::TooSmall { .. } => {
            vec![repair("energy", "write more".into()), repair("starts", "write fewer".into())]
        }
        _ => Vec::new(),
    }
}

fn of_system_section(error: &FormulaSystemError) -> Vec<Repair> {
    let key = match error {
        FormulaSystemError::Surface(_) => "surface".into(),
        FormulaSystemError::Axis { axis, .. } => format!("axes[{axis}]"),
        FormulaSystemError::Level { .. } => "level".into(),
        FormulaSystemError::TooSmall { .. } => "surface".into(),
        _ => "states".into(),
    };
    vec![(format!("section.{key}"), String::new())]
}

fn of_sweep(error: &SweepError, config: &Config) -> Vec<Repair> {
    let repair = |key: &str, note: &str| (format!("sweep.{key}"), note.to_string());
    let of_axis = |parameter: &str, note: &str| {
        let axes = config.sweep.iter().filter_map(|sweep| sweep.axes.as_ref());
        let place = axes.flatten().position(|axis| axis.parameter.name() == parameter);
        place.map(|place| repair(&format!("axes[{place}].parameter"), note)).into_iter().collect()
    };
    match error {
        SweepError::NoObservables => vec![repair("observables", "write one, such as [\"megno\"]")],
        SweepError::Twice => vec![repair("observables", "name each once")],
        SweepError::Count => {
            vec![
                repair("count", "write 1 or more for random axes"),
                repair("axes", "random axes need `count`"),
            ]
        }
        SweepError::TooMany { most, .. } => {
            vec![repair("axes", &format!("the counts must multiply to at most {most:e}"))]
        }
        SweepError::Velocity { .. } => {
            let note = "write `angular_momentum`, or vary another number".to_string();
            vec![("initial.angular_velocity".into(), note)]
        }
        SweepError::Momentum { axis } => of_axis(axis, "write `initial.angular_velocity` too"),
        SweepError::Matrix { axis } => of_axis(axis, "vary another number"),
        SweepError::Weight { axis } => of_axis(axis, "vary body.weight_moment"),
        SweepError::OfTops { .. } | SweepError::OfClosed { .. } => {
            vec![repair("observables", "leave it out")]
        }
        SweepError::Lifted { .. } => {
            vec![("integrator.formulation".into(), "write \"direct\"".into())]
        }
        SweepError::OfAnother { parameter, .. } => of_axis(parameter, "vary another number"),
        SweepError::NoParameter { parameter, .. } => of_axis(parameter, ""),
        SweepError::NoVector { parameter } => of_axis(parameter, "write it without [ ]"),
        SweepError::Index { parameter, most, .. } => {
            of_axis(parameter, &format!("write an index from 0 to {most}"))
        }
        SweepError::SameColumn { .. } => vec![repair("observables", "")],
        SweepError::NoAxes => vec![repair("axes", "add a table [[sweep.axes]]")],
        _ => vec![repair("axes", "")],
    }
}
