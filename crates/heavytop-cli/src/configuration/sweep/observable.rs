//! The observables: what a sweep measures about each motion.

use super::column::Column;
use crate::vocabulary::named::{by_name, name_of};
use serde::{Deserialize, Serialize};

/// A quantity of one or more numbers that describes the motion of a top or of another system.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(try_from = "String", into = "&'static str")]
pub enum Observable {
    /// The state at the end: (Π, Γ) of a top.
    FinalState,
    /// The largest deviations of h and of the Casimirs, f₁ and f₂ for a top, over all steps.
    InvariantDrift,
    /// These deviations relative to the sizes of the invariants along the motion, without a unit.
    RelativeDrift,
    /// The maximal Lyapunov exponent, 1/s.
    Lyapunov,
    /// The smaller alignment index.
    Sali,
    /// The mean exponential growth factor of nearby orbits.
    Megno,
    /// For a top, the mean advance of Γ about the centre of mass in a period of nutation, in turns.
    RotationNumber,
    /// For a top, the range of the angle between centre of mass and vertical, rad.
    NutationAmplitude,
}

impl Observable {
    const NAMES: &[(&'static str, Self)] = &[
        ("final-state", Self::FinalState),
        ("invariant-drift", Self::InvariantDrift),
        ("relative-drift", Self::RelativeDrift),
        ("lyapunov", Self::Lyapunov),
        ("sali", Self::Sali),
        ("megno", Self::Megno),
        ("rotation-number", Self::RotationNumber),
        ("nutation-amplitude", Self::NutationAmplitude),
    ];

    /// Returns the name in configurations.
    #[must_use]
    pub fn name(self) -> &'static str {
        name_of(Self::NAMES, self)
    }

    /// Returns the columns of the observable for a top. Those of indicators of chaos are the same for any system.
    #[must_use]
    pub fn columns(self) -> Vec<Column> {
        let linear = |columns: &[(&str, &str)]| {
            columns.iter().map(|(name, label)| Column::linear(name, label)).collect()
        };
        let logarithmic = |columns: &[(&str, &str)]| {
            columns.iter().map(|(name, label)| Column::logarithmic(name, label)).collect()
        };
        match self {
            Self::FinalState => linear(&FINAL),
            Self::InvariantDrift => logarithmic(&DRIFT),
            Self::RelativeDrift => logarithmic(&RELATIVE_DRIFT),
            Self::Lyapunov => linear(&[("lyapunov", "maximal Lyapunov exponent (1/s)")]),
            Self::Sali => logarithmic(&[("sali", "SALI")]),
            Self::Megno => logarithmic(&[("megno", "MEGNO")]),
            Self::RotationNumber => linear(&[("rotation_number", "rotation number (turns)")]),
            Self::NutationAmplitude => {
                linear(&[("nutation_amplitude", "nutation amplitude (rad)")])
            }
        }
    }

    /// Returns the number of tangent vectors that the observable needs.
    pub(crate) fn tangents(self) -> usize {
        match self {
            Self::Sali => 2,
            Self::Lyapunov | Self::Megno => 1,
            _ => 0,
        }
    }
}

const FINAL: [(&str, &str); 6] = [
    ("Pi1", "Π₁ at the end (kg m²/s)"),
    ("Pi2", "Π₂ at the end (kg m²/s)"),
    ("Pi3", "Π₃ at the end (kg m²/s)"),
    ("Gamma1", "Γ₁ at the end"),
    ("Gamma2", "Γ₂ at the end"),
    ("Gamma3", "Γ₃ at the end"),
];

const DRIFT: [(&str, &str); 3] = [
    ("drift_h", "deviation of h (J)"),
    ("drift_f1", "deviation of |Γ|²"),
    ("drift_f2", "deviation of Π·Γ (kg m²/s)"),
];

const RELATIVE_DRIFT: [(&str, &str); 3] = [
    ("relative_drift_h", "relative deviation of h"),
    ("relative_drift_f1", "relative deviation of |Γ|²"),
    ("relative_drift_f2", "relative deviation of Π·Γ"),
];

impl From<Observable> for &'static str {
    fn from(observable: Observable) -> Self {
        observable.name()
    }
}

impl TryFrom<String> for Observable {
    type Error = String;

    fn try_from(name: String) -> Result<Self, String> {
        by_name("observable", Self::NAMES, &name)
    }
}
