//! The keys at fault where the tables of an open system are wrong.

use collective_integrators::BrownianError;
use lie_poisson::DissipationError;
use lie_poisson_formula_systems::OpenSystemError;

/// Returns the keys that may be at fault, the likeliest first, each with what to write there.
pub(super) fn keys_of_open(error: &OpenSystemError) -> Vec<(String, &'static str)> {
    use OpenSystemError as E;
    let key = |key: &str, note| vec![(key.to_owned(), note)];
    match error {
        E::InputName { name, .. } => key(&format!("inputs.{name}"), "choose another name"),
        E::TimeName => ["system.parameters.t", "system.coordinates"]
            .map(|key| (key.into(), "choose another name"))
            .to_vec(),
        E::PathNumber { .. } => key("noise.path", ""),
        E::ShortInterval { .. } => key("noise.interval", ""),
        E::Input { name, .. } => key(&format!("inputs.{name}"), ""),
        E::Formula { what, .. } | E::Count { what, .. } => keys_of_formula(what),
        E::NoCoordinate { what, name, .. } if !what.contains(' ') => {
            key(&format!("{what}.{name}"), "")
        }
        E::NoCoordinate { .. } => key("noise.fields", ""),
        E::TorqueOnDirection { name, .. } => key(&format!("torque.{name}"), "leave it out"),
        E::InnerProduct(_) | E::InnerProductSize { .. } => {
            ["damping.inner_product", "noise.inner_product"].map(|key| (key.into(), "")).to_vec()
        }
        E::NoInnerProduct { .. } => {
            ["damping", "noise"].map(|key| (key.into(), "add inner_product")).to_vec()
        }
        E::Dissipation(DissipationError::Friction { .. }) => {
            key("damping.friction", "write 0 or more")
        }
        E::Dissipation(DissipationError::Temperature { .. }) => {
            key("noise.temperature", "write 0 or more")
        }
        E::Brownian(BrownianError::Bound { .. }) => key("noise.bound", "write 1 or more"),
        E::Brownian(_) => {
            ["noise.interval", "integrator.step"].map(|key| (key.into(), "")).to_vec()
        }
        E::Strength { .. } => key("noise.strength", "write 0 or more"),
        E::TemperatureAlone => key("noise.temperature", "add [damping], or write strength"),
        E::TemperatureWithoutFriction { .. } => {
            vec![
                ("damping.friction".into(), "write more than 0, or leave noise.temperature out"),
                ("noise.temperature".into(), "write 0, or leave it out"),
            ]
        }
        E::BackAtTemperature { .. } => vec![
            ("integrator.end".into(), "write an end above 0"),
            ("integrator.step".into(), "write a step above 0"),
        ],
        E::NoSpins { .. } => key("damping.form", "leave it out"),
        _ => Vec::new(),
    }
}

/// Returns the keys of a formula that is for "torque Pi2", say, or "noise field 1 Pi".
fn keys_of_formula(what: &str) -> Vec<(String, &'static str)> {
    let mut words = what.split(' ');
    let (table, name) = (words.next().unwrap_or_default(), words.next_back().unwrap_or_default());
    let vector = name.trim_end_matches(|c: char| c.is_ascii_digit());
    let below = match table {
        "noise" => vec!["noise.fields".into(), "noise".into()],
        _ => vec![format!("{table}.{name}"), format!("{table}.{vector}"), table.into()],
    };
    below.into_iter().map(|key: String| (key, "")).collect()
}
