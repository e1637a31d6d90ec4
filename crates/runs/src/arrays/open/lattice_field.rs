//! A uniform field of a lattice by formulas in the time and in inputs: [`LatticeField`].

use lie_poisson::larger;
use lie_poisson_formula_systems::{NamedInputs, OpenSystemError};
use lie_poisson_formulas::Formula;
use lie_poisson_systems::FieldInTime;
use nalgebra::Vector3;

/// The largest number of times of tables at which a field is computed for its size.
const MOST_TIMES: usize = 64;

/// A uniform magnetic field B(t) of spins, by formulas in the time `t` and in inputs, which adds −B(t)·Σ s_i to h.
///
/// # Example
/// ```
/// use lie_poisson::{InputTable, Interpolation};
/// use lie_poisson_formula_systems::NamedInputs;
/// use lie_poisson_runs::LatticeField;
/// use lie_poisson_systems::FieldInTime;
/// let ramp = InputTable::new(vec![0.0, 2.0], vec![0.0, 1.0], Interpolation::Linear)?;
/// let inputs = NamedInputs::new(vec![("u".into(), ramp)]);
/// let field = LatticeField::new(inputs, &["2*cos(t)", "0", "u"])?;
/// assert_eq!(field.at(0.0).as_slice(), [2.0, 0.0, 0.0]);
/// assert_eq!((field.at(1.0).z, field.next_break(0.5, true)), (0.5, Some(2.0)));
/// assert!(LatticeField::new(NamedInputs::default(), &["u", "0", "0"]).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct LatticeField {
    inputs: NamedInputs,
    components: [Formula; 3],
}

impl LatticeField {
    /// Creates the field of three formulas.
    ///
    /// # Errors
    /// Returns [`OpenSystemError`] if there are not three, one of them is no formula in `t` and the inputs, or an input has a
    /// name that cannot be one.
    pub fn new<S: AsRef<str>>(inputs: NamedInputs, texts: &[S]) -> Result<Self, OpenSystemError> {
        let vocabulary = inputs.vocabulary_of_time()?;
        let formulas = (1..).zip(texts).map(|(i, text)| {
            let formula = Formula::new(text.as_ref(), &vocabulary);
            formula.map_err(|reason| OpenSystemError::Formula {
                what: format!("drive field{i}"),
                reason: Box::new(reason),
            })
        });
        Self::of_formulas(inputs, formulas.collect::<Result<_, _>>()?)
    }

    /// Creates the field of three formulas with the names of [`NamedInputs::vocabulary_of_time`].
    ///
    /// # Errors
    /// Returns [`OpenSystemError::Count`] if there are not three.
    pub fn of_formulas(
        inputs: NamedInputs,
        formulas: Vec<Formula>,
    ) -> Result<Self, OpenSystemError> {
        let found = formulas.len();
        let what = "drive field".into();
        let components = formulas.try_into();
        let components =
            components.map_err(|_| OpenSystemError::Count { what, expected: 3, found })?;
        Ok(Self { inputs, components })
    }

    /// Returns the inputs.
    #[must_use]
    pub const fn inputs(&self) -> &NamedInputs {
        &self.inputs
    }

    /// Returns the largest |B| at the time 0 and at those of the tables, or at some of many.
    pub(super) fn size(&self) -> f64 {
        let times: Vec<f64> = self.inputs.times().collect();
        let some = times.iter().step_by(times.len().div_ceil(MOST_TIMES).max(1));
        let sizes = some.chain(&[0.0]).map(|time| self.at(*time).norm());
        // Tables may begin after 0, where a backward run ends.
        sizes.filter(|size| size.is_finite()).fold(0.0, larger)
    }
}

impl FieldInTime for LatticeField {
    fn at(&self, time: f64) -> Vector3<f64> {
        let mut x = Vec::new();
        self.inputs.append(time, &mut x);
        Vector3::from(self.components.each_ref().map(|formula| formula.value_at(&x)))
    }

    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        self.inputs.next_break(time, forward)
    }
}

/// Writes the three formulas, as `[2*cos(t), 0, u]`.
impl core::fmt::Display for LatticeField {
    fn fmt(&self, to: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let [x, y, z] = &self.components;
        write!(to, "[{x}, {y}, {z}]")
    }
}
