//! The values of a family of tops that no axis changes, in the words of a caption.

use crate::configuration::{About, BodyConfig, Inertia, InitialConfig, Part, TopParameter};
use crate::pictures::caption::{self, number, vector_of};

/// Returns the numbers of `[body]` and `[initial]` that all tops share, where `changed` tells which ones an axis changes.
/// A vector has the symbols of the components that change.
pub(super) fn fixed_values(
    body: &BodyConfig,
    initial: &InitialConfig,
    changed: impl Fn(TopParameter) -> bool,
) -> Vec<String> {
    let mut values = Vec::new();
    values.extend(match body.inertia {
        Inertia::Principal(moments) => {
            let name = if body.inertia_about == About::Support { "I" } else { "I of the centre" };
            vector(name, "I", moments, " kg m²", |i| changed(TopParameter::Inertia(i)))
        }
        Inertia::Matrix(rows) => {
            let rows = rows.map(caption::vector);
            Some(format!("I = ({}) kg m²", rows.join(", ")))
        }
    });
    values.extend(factors(body, &changed));
    values.extend(direction("c", "c", body.center(), |part| {
        changed(TopParameter::CenterOfMass(part))
    }));
    values.extend(match initial.angular_velocity {
        // Π(0) = I Ω(0) differs from top to top if the moments do.
        Some(velocity) => {
            vector("Ω(0)", "Ω", velocity, " rad/s", |i| changed(TopParameter::AngularVelocity(i)))
        }
        None => vector("Π(0)", "Π", initial.angular_momentum, " kg m²/s", |i| {
            changed(TopParameter::AngularMomentum(i))
        }),
    });
    values.extend(direction("Γ(0)", "Γ", initial.direction(), |part| {
        changed(TopParameter::Vertical(part))
    }));
    values
}

/// Returns the weight moment, or its factors if one of them changes or they are given.
fn factors(body: &BodyConfig, changed: &impl Fn(TopParameter) -> bool) -> Vec<String> {
    let factors = [
        ("m", body.mass, "kg", TopParameter::Mass),
        ("g", body.gravity, "m/s²", TopParameter::Gravity),
        ("l", body.length, "m", TopParameter::Length),
    ];
    let is_product = !factors.iter().any(|(_, _, _, parameter)| changed(*parameter));
    match body.weight_moment {
        _ if changed(TopParameter::WeightMoment) => Vec::new(),
        Some(weight) if is_product => vec![format!("m g l = {} N m", number(weight))],
        _ => {
            let fixed = factors.into_iter().filter(|(_, _, _, parameter)| !changed(*parameter));
            let text = |(symbol, value, unit, _)| format!("{symbol} = {} {unit}", number(value));
            fixed.map(text).collect()
        }
    }
}

/// Returns the components of a vector, unless all change.
fn vector(
    name: &str,
    symbol: &str,
    components: [f64; 3],
    unit: &str,
    changed: impl Fn(usize) -> bool,
) -> Option<String> {
    let symbol = |i: usize| changed(i).then(|| format!("{symbol}{}", ["₁", "₂", "₃"][i]));
    vector_of(name, &components, symbol).map(|text| text + unit)
}

/// Returns what a unit vector keeps: components, or the angle that does not change.
fn direction(
    name: &str,
    symbol: &str,
    [x, y, z]: [f64; 3],
    changed: impl Fn(Part) -> bool,
) -> Option<String> {
    let angle = |kind: &str, value: f64| Some(format!("{kind} of {name} = {} rad", number(value)));
    match (changed(Part::Inclination), changed(Part::Azimuth)) {
        (true, true) => None,
        (true, false) => angle("azimuth", y.atan2(x)),
        (false, true) => angle("inclination", x.hypot(y).atan2(z)),
        (false, false) => vector(name, symbol, [x, y, z], "", |i| changed(Part::Component(i))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_plays_no_part_is_not_told() {
        let body = BodyConfig { center_of_mass: [3.0, 0.0, 4.0], ..BodyConfig::default() };
        let told = |body: BodyConfig, initial| fixed_values(&body, &initial, |_| false).join("; ");
        let plain = told(body, InitialConfig::default());
        assert!(
            plain.contains("c = (3, 0, 4)") && plain.contains("Π(0) = (2, 3, 4) kg m²/s"),
            "{plain}"
        );
        let initial = InitialConfig {
            angular_velocity: Some([0.0, 0.0, 5.0]),
            inclination: Some(0.0),
            ..InitialConfig::default()
        };
        let keys = told(BodyConfig { normalise: true, ..body }, initial);
        for part in ["c = (0.6, 0, 0.8)", "Ω(0) = (0, 0, 5) rad/s", "Γ(0) = (0, 0, 1)"] {
            assert!(keys.contains(part), "{keys}");
        }
        assert!(!keys.contains('Π'), "{keys}");
    }
}
