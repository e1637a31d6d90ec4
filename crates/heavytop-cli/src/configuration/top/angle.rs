//! Angles with their units: `"30 deg"`, `"0.5 rad"`, or a number of radians.

use crate::vocabulary::brief::{number, text};
use serde::de::{Error, Unexpected, Visitor};
use serde::{Deserialize, Deserializer, Serialize};
use std::f64::consts::{PI, TAU};
use std::fmt;

/// A number, or an angle with its unit, as it is written in a configuration.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Quantity {
    /// A number; an angle in radians.
    Number(f64),
    /// A number and its unit, `deg` or `rad`.
    Text(String),
}

impl<'de> Deserialize<'de> for Quantity {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        from.deserialize_any(Written)
    }
}

struct Written;

impl Visitor<'_> for Written {
    type Value = Quantity;

    fn expecting(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.write_str("a number, or an angle such as \"30 deg\"")
    }

    fn visit_f64<E>(self, value: f64) -> Result<Quantity, E> {
        Ok(Quantity::Number(value))
    }

    fn visit_i64<E>(self, value: i64) -> Result<Quantity, E> {
        Ok(Quantity::Number(value as f64))
    }

    fn visit_u64<E>(self, value: u64) -> Result<Quantity, E> {
        Ok(Quantity::Number(value as f64))
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Quantity, E> {
        match with_unit(text) {
            Some(_) => Ok(Quantity::Text(text.into())),
            None => Err(E::invalid_type(Unexpected::Str(text), &self)),
        }
    }
}

/// The range of an angle.
#[derive(Clone, Copy, Debug)]
pub(in crate::configuration) struct AngleRange {
    name: &'static str,
    /// The range in words.
    pub range: &'static str,
    contains: fn(f64) -> bool,
    /// The ends of the range in words.
    least: &'static str,
    greatest: &'static str,
}

/// The range [0, π] of an inclination.
pub(in crate::configuration) const INCLINATION: AngleRange = AngleRange {
    name: "inclination",
    range: "from 0 to π",
    contains: |angle| (0.0..=PI).contains(&angle),
    least: "0",
    greatest: "π",
};

/// The range (−2π, 2π) of an azimuth.
pub(in crate::configuration) const AZIMUTH: AngleRange = AngleRange {
    name: "azimuth",
    range: "between -2π and 2π",
    contains: |angle| angle.abs() < TAU,
    least: "-2π",
    greatest: "2π",
};

impl AngleRange {
    /// Returns whether an angle, rad, is in the range.
    pub fn contains(&self, angle: f64) -> bool {
        (self.contains)(angle)
    }

    /// Returns the angle in radians.
    ///
    /// # Errors
    /// Returns what is wrong, and what to write instead, if it has no known unit or is outside the range.
    pub fn radians(&self, quantity: &Quantity) -> Result<f64, String> {
        let Self { range, least, greatest, .. } = self;
        match quantity {
            Quantity::Number(angle) if self.contains(*angle) => Ok(*angle),
            Quantity::Number(angle) if !angle.is_finite() => {
                Err(format!("must be finite, got {angle}; write an angle {range}"))
            }
            // A number that may have been meant in degrees.
            Quantity::Number(angle) => {
                let written = number(*angle);
                let is_degrees = angle.abs() >= 4.0 && self.contains(angle / 180.0 * PI);
                let repair = match is_degrees {
                    true => format!("write \"{written} deg\""),
                    false => format!("write an angle {range}, such as \"30 deg\""),
                };
                let beyond = if *angle < 0.0 { least } else { greatest };
                Err(format!("is in radians, {range}, and {written} is beyond {beyond}; {repair}"))
            }
            Quantity::Text(written) => {
                let angle = with_unit(written).ok_or_else(|| {
                    let written = text(written);
                    format!(
                        "needs a number and deg or rad, got `{written}`; write it as in \"30 deg\""
                    )
                })?;
                match self.contains(angle) {
                    true => Ok(angle),
                    false => Err(format!(
                        "must be {range}, got `{}`; write an angle {range}",
                        text(written)
                    )),
                }
            }
        }
    }

    /// Reads an angle of a table, in radians. The message of an error begins with the key.
    fn read<'de, D: Deserializer<'de>>(&self, from: D) -> Result<Option<f64>, D::Error> {
        let Some(quantity) = Option::<Quantity>::deserialize(from)? else { return Ok(None) };
        let wrong = |what: String| D::Error::custom(format!("`{}` {what}", self.name));
        self.radians(&quantity).map(Some).map_err(wrong)
    }
}

/// Reads the inclination of a table, in radians.
pub(super) fn inclination<'de, D: Deserializer<'de>>(from: D) -> Result<Option<f64>, D::Error> {
    INCLINATION.read(from)
}

/// Reads the azimuth of a table, in radians.
pub(super) fn azimuth<'de, D: Deserializer<'de>>(from: D) -> Result<Option<f64>, D::Error> {
    AZIMUTH.read(from)
}

/// Any finite Euler angle.
const EULER_ANGLE: AngleRange = AngleRange {
    name: "euler_angles",
    range: "finite",
    contains: f64::is_finite,
    least: "-∞",
    greatest: "∞",
};

/// Reads the Euler angles (φ, θ, ψ) of a table, in radians.
pub(super) fn euler_angles<'de, D: Deserializer<'de>>(
    from: D,
) -> Result<Option<[f64; 3]>, D::Error> {
    let Some(written) = Option::<[Quantity; 3]>::deserialize(from)? else { return Ok(None) };
    let mut angles = [0.0; 3];
    for (angle, quantity) in angles.iter_mut().zip(&written) {
        *angle = EULER_ANGLE
            .radians(quantity)
            .map_err(|what| D::Error::custom(format!("`{}` {what}", EULER_ANGLE.name)))?;
    }
    Ok(Some(angles))
}

/// Returns the angle of a text with a unit, in radians.
fn with_unit(text: &str) -> Option<f64> {
    let units = [("degrees", PI / 180.0), ("deg", PI / 180.0), ("°", PI / 180.0), ("rad", 1.0)];
    let (digits, unit) =
        units.iter().find_map(|(name, unit)| Some((text.trim().strip_suffix(name)?, unit)))?;
    let value: f64 = digits.trim().parse().ok()?;
    // 180 degrees are π, to the last bit.
    value.is_finite().then_some(if *unit == 1.0 { value } else { value / 180.0 * PI })
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn angles_have_units_and_ranges() {
        let angle =
            |range: &AngleRange, written: &str| range.radians(&Quantity::Text(written.into()));
        for (written, expected) in [
            ("180 deg", PI),
            ("30deg", PI / 6.0),
            (" 90 ° ", PI / 2.0),
            ("45 degrees", PI / 4.0),
            ("0.5 rad", 0.5),
            ("0 rad", 0.0),
        ] {
            let found = angle(&INCLINATION, written).unwrap();
            assert!((found - expected).abs() <= 2e-16, "{written}: {found}");
        }
        assert_eq!(angle(&INCLINATION, "180 deg"), Ok(PI));
        assert_eq!(angle(&AZIMUTH, "-90 deg"), Ok(-PI / 2.0));
        for (written, part) in [
            ("181 deg", "must be from 0 to π, got `181 deg`"),
            ("30", "needs a number and deg or rad, got `30`"),
            ("thirty deg", "needs a number"),
            ("nan deg", "needs a number"),
            ("-1 rad", "must be from 0 to π"),
        ] {
            let refused = angle(&INCLINATION, written).unwrap_err();
            assert!(refused.contains(part), "{written}: {refused}");
        }
        assert!(angle(&AZIMUTH, "360 deg").is_err() && angle(&AZIMUTH, "359 deg").is_ok());
        let number = |range: &AngleRange, angle| range.radians(&Quantity::Number(angle));
        let refused = number(&INCLINATION, 30.0).unwrap_err();
        assert_eq!(refused, "is in radians, from 0 to π, and 30 is beyond π; write \"30 deg\"");
        // Half a turn with too few digits, and an angle on the wrong side, are no degrees.
        for angle in [3.15, -0.5, -30.0, 400.0] {
            let refused = number(&INCLINATION, angle).unwrap_err();
            assert!(
                refused.ends_with("write an angle from 0 to π, such as \"30 deg\""),
                "{refused}"
            );
        }
        assert_eq!((number(&INCLINATION, PI), number(&AZIMUTH, -6.25)), (Ok(PI), Ok(-6.25)));
        assert!(number(&AZIMUTH, TAU).is_err() && number(&INCLINATION, f64::NAN).is_err());
    }
}
