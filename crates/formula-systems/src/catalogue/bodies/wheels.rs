//! What bodies with reaction wheels share: [`Wheels`].

use crate::algebras::system_algebra::SystemAlgebra;
use crate::catalogue::parameter::Parameter;
use crate::catalogue::system_kind::{Given, KindError, Sign};
use crate::error::FormulaSystemError;
use lie_poisson_formulas::{NameError, Parameters};
use nalgebra::Vector3;

/// The parameter of the axes.
pub(super) const AXES: Parameter =
    Parameter::list("axes", "of the wheels in the body, three numbers each, of any length but 0");

/// The parameter of the moments about the axes.
pub(super) const MOMENTS: Parameter =
    Parameter::number_or_list("J", "moments of the wheels about their axes, kg m²");

/// The speeds of a start.
pub(super) const SPEEDS: Parameter =
    Parameter::list("speeds", "of the wheels against the body, rad/s");

/// Balanced wheels with the unit vectors a_k along their axes, and with the moments J_k about these. The angular momenta l_k about
/// the axes, against the stars, are coordinates of R^N.
pub(super) struct Wheels {
    axes: Vec<Vector3<f64>>,
    moments: Vec<f64>,
}

impl Wheels {
    /// Returns the wheels of the parameters `axes` and `J`; none if neither is given.
    pub(super) fn of(given: &Given<'_>) -> Result<Self, KindError> {
        let (rows, moments) = (given.values(AXES.name), given.values(MOMENTS.name));
        if rows.len() % 3 != 0 {
            let needed = format!("three numbers for each wheel, got {}", rows.len());
            return Err(KindError::Value(AXES.name, needed));
        }
        given.require(MOMENTS.name, Sign::Positive)?;
        let count = rows.len() / 3;
        let moments = match moments.as_slice() {
            [one] => vec![*one; count],
            all if all.len() == count => moments,
            all => {
                let needed = format!("a number for each of {count} axes, got {}", all.len());
                return Err(KindError::Value(MOMENTS.name, needed));
            }
        };
        if count == 0 && given.has(MOMENTS.name) {
            return Err(KindError::Value(AXES.name, "given where there is J".into()));
        }
        let unit = |row: &[f64]| {
            let axis = Vector3::from_iterator(row.iter().copied());
            // A length is measured in the largest component, so that its square is finite.
            let unit = (axis / axis.amax()).normalize();
            let needed = || format!("of a length that is not 0, got {row:?}");
            let is_unit = unit.iter().all(|x| x.is_finite());
            if is_unit { Ok(unit) } else { Err(KindError::Value(AXES.name, needed())) }
        };
        let axes = rows.chunks(3).map(unit).collect::<Result<_, _>>()?;
        Ok(Self { axes, moments })
    }

    pub(super) fn are_none(&self) -> bool {
        self.axes.is_empty()
    }

    /// Returns the algebra of a body with its wheels, for the symbols of the coordinates of the body.
    pub(super) fn algebra(
        &self,
        body: &str,
        symbols: &[&str],
    ) -> Result<SystemAlgebra, FormulaSystemError> {
        if self.are_none() {
            return SystemAlgebra::named(body);
        }
        let algebra = SystemAlgebra::named(&format!("{body} + R{}", self.axes.len()))?;
        algebra.with_symbols(&[symbols, &["l"]].concat())
    }

    /// Returns the kinetic energy Σ_i (Π_i − Σ_k a_ki l_k)²/(2 I_i) + Σ_k l_k²/(2 J_k) as a formula.
    pub(super) fn energy(&self) -> String {
        if self.are_none() {
            return "sum(Pi[i]^2/I[i])/2".into();
        }
        let along = (1..=self.axes.len()).map(|k| format!(" - axis_{k}[i]*l{k}"));
        let along: String = along.collect();
        format!("sum((Pi[i]{along})^2/I[i])/2 + sum(l[k]^2/J[k])/2")
    }

    /// Returns what the wheels add to Γ·IΓ, Σ_k J_k (a_k·Γ)², as a formula.
    pub(super) fn added_moment(&self, direction: &str) -> String {
        let term = |k: usize| format!(" + J{k}*(axis_{k}·{direction})^2");
        (1..=self.axes.len()).map(term).collect()
    }

    /// Returns parameters with those of the wheels.
    pub(super) fn parameters(&self, all: Parameters) -> Result<Parameters, NameError> {
        if self.are_none() {
            return Ok(all);
        }
        let with_axis = |all: Parameters, (k, axis): (usize, &Vector3<f64>)| {
            all.vector(&format!("axis_{k}"), axis.as_slice())
        };
        (1..).zip(&self.axes).try_fold(all.vector(MOMENTS.name, &self.moments)?, with_axis)
    }

    /// Returns Π = I Ω + Σ a_k l_k and l_k = J_k (a_k·Ω + s_k) for the speeds s_k of a start.
    pub(super) fn momenta(
        &self,
        inertia: &[f64],
        omega: Vector3<f64>,
        start: &Given<'_>,
    ) -> Result<(Vector3<f64>, Vec<f64>), KindError> {
        let given = start.values(SPEEDS.name);
        let speeds = match (given.len(), self.axes.len()) {
            (0, count) => vec![0.0; count],
            (found, count) if found == count => given,
            (found, count) => {
                let needed = format!("a number for each of {count} wheels, got {found}");
                return Err(KindError::Value(SPEEDS.name, needed));
            }
        };
        let wheels = self.axes.iter().zip(&self.moments).zip(speeds);
        let l: Vec<f64> =
            wheels.map(|((axis, moment), speed)| moment * (axis.dot(&omega) + speed)).collect();
        let body = omega.zip_map(&Vector3::from_iterator(inertia.iter().copied()), |w, i| w * i);
        let pi = self.axes.iter().zip(&l).fold(body, |sum, (axis, l)| sum + axis * *l);
        Ok((pi, l))
    }
}
