//! The observables: what a sweep measures about each top.

use crate::vocabulary::named::{by_name, name_of};
use serde::{Deserialize, Serialize};

/// A quantity of one or more numbers that describes the motion of a top.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(try_from = "String", into = "&'static str")]
pub enum Observable {
    /// The state (Π, Γ) at the end.
    FinalState,
    /// The largest deviations of h, f₁ and f₂ over all steps.
    InvariantDrift,
    /// The maximal Lyapunov exponent, 1/s.
    Lyapunov,
    /// The smaller alignment index.
    Sali,
    /// The mean exponential growth factor of nearby orbits.
    Megno,
    /// The mean advance of Γ about the centre of mass in a period of nutation, in turns.
    RotationNumber,
    /// The range of the angle between centre of mass and vertical, rad.
    NutationAmplitude,
}

impl Observable {
    const NAMES: &[(&'static str, Self)] = &[
        ("final-state", Self::FinalState),
        ("invariant-drift", Self::InvariantDrift),
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

    /// Returns the columns of the observable.
    #[must_use]
    pub fn columns(self) -> &'static [Column] {
        match self {
            Self::FinalState => &FINAL,
            Self::InvariantDrift => &DRIFT,
            Self::Lyapunov => &LYAPUNOV,
            Self::Sali => &SALI,
            Self::Megno => &MEGNO,
            Self::RotationNumber => &ROTATION,
            Self::NutationAmplitude => &NUTATION,
        }
    }
}

const FINAL: [Column; 6] = [
    Column::linear("Pi1", "Π₁ at the end (kg m²/s)"),
    Column::linear("Pi2", "Π₂ at the end (kg m²/s)"),
    Column::linear("Pi3", "Π₃ at the end (kg m²/s)"),
    Column::linear("Gamma1", "Γ₁ at the end"),
    Column::linear("Gamma2", "Γ₂ at the end"),
    Column::linear("Gamma3", "Γ₃ at the end"),
];

const DRIFT: [Column; 3] = [
    Column::logarithmic("drift_h", "deviation of h (J)"),
    Column::logarithmic("drift_f1", "deviation of |Γ|²"),
    Column::logarithmic("drift_f2", "deviation of Π·Γ (kg m²/s)"),
];

const LYAPUNOV: [Column; 1] = [Column::linear("lyapunov", "maximal Lyapunov exponent (1/s)")];
const SALI: [Column; 1] = [Column::logarithmic("sali", "SALI")];
const MEGNO: [Column; 1] = [Column::logarithmic("megno", "MEGNO")];
const ROTATION: [Column; 1] = [Column::linear("rotation_number", "rotation number (turns)")];
const NUTATION: [Column; 1] = [Column::linear("nutation_amplitude", "nutation amplitude (rad)")];

/// A column of the table of a sweep, and how its heat map is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Column {
    /// The name of the column, which is also that of its heat map.
    pub name: &'static str,
    /// The quantity in the column, with its unit.
    pub label: &'static str,
    /// Whether the colours follow the logarithm of the value.
    pub is_logarithmic: bool,
}

impl Column {
    const fn linear(name: &'static str, label: &'static str) -> Self {
        Self { name, label, is_logarithmic: false }
    }

    const fn logarithmic(name: &'static str, label: &'static str) -> Self {
        Self { name, label, is_logarithmic: true }
    }
}

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
