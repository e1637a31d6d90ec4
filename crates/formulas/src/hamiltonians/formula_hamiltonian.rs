//! A formula as a Hamiltonian on the dual of a Lie algebra: [`FormulaHamiltonian`].

use super::formula::Formula;
use crate::names::vocabulary::Vocabulary;
use crate::text::formula_error::{FormulaError, Problem};
use core::fmt;
use core::marker::PhantomData;
use lie_poisson::{Hamiltonian, LieAlgebra, LiePoisson, Momentum, Real, Vector};

/// The Hamiltonian of a [`Formula`] in the coordinates of 𝔤∗, over every scalar.
///
/// # Example
/// The free rigid body, dΠ/dt = Π × Ω with Ω = dh(Π):
/// ```
/// use lie_poisson::{Covector, Hamiltonian, LiePoisson, PoissonSpace, So3};
/// use lie_poisson_formulas::{FormulaHamiltonian, Parameters, Vocabulary};
/// use nalgebra::Vector3;
///
/// let names = Vocabulary::of(&So3, &Parameters::new())?;
/// let h = FormulaHamiltonian::<So3>::new("(Pi1^2 + Pi2^2/2 + Pi3^2/4)/2", &names)?;
/// let pi = Covector(Vector3::new(1.0, 2.0, 4.0));
/// let omega = h.differential(&pi);
/// assert_eq!(omega, Vector3::new(1.0, 1.0, 1.0));
/// let rate = LiePoisson::minus(So3).hamiltonian_vector(&pi, &omega);
/// assert_eq!(rate, Covector(pi.0.cross(&omega)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct FormulaHamiltonian<A> {
    formula: Formula,
    algebra: PhantomData<fn() -> A>,
}

impl<A: LieAlgebra> FormulaHamiltonian<A> {
    /// Creates the Hamiltonian from a text.
    ///
    /// # Errors
    /// Returns [`FormulaError`] if [`Formula::new`] refuses the text, or if the number of coordinates in `names`
    /// differs from the dimension of the algebra.
    pub fn new(text: &str, names: &Vocabulary) -> Result<Self, FormulaError> {
        let problem = Self::wrong_dimension(names);
        match problem {
            Some(problem) => Err(FormulaError::new(0..text.len(), problem)),
            None => Ok(Self { formula: Formula::new(text, names)?, algebra: PhantomData }),
        }
    }

    /// Creates the Hamiltonian from a formula.
    ///
    /// # Errors
    /// Returns [`FormulaError`] if the number of coordinates of the formula differs from the dimension of the
    /// algebra.
    pub fn of(formula: &Formula) -> Result<Self, FormulaError> {
        match Self::wrong_dimension(formula.names()) {
            Some(problem) => Err(FormulaError::new(0..0, problem)),
            None => Ok(Self { formula: formula.clone(), algebra: PhantomData }),
        }
    }

    fn wrong_dimension(names: &Vocabulary) -> Option<Problem> {
        let (formula, space) = (names.coordinates().dimension(), A::Element::<f64>::DIM);
        (formula != space).then_some(Problem::WrongDimension { formula, space })
    }

    /// Returns the formula of the Hamiltonian.
    #[must_use]
    pub const fn formula(&self) -> &Formula {
        &self.formula
    }
}

impl<A: LieAlgebra, T: Real> Hamiltonian<LiePoisson<A>, T> for FormulaHamiltonian<A> {
    #[inline]
    fn value(&self, mu: &Momentum<A, T>) -> T {
        self.formula.value(mu)
    }

    #[cfg_attr(optimised, inline(always))]
    fn differential(&self, mu: &Momentum<A, T>) -> A::Element<T> {
        // With derivatives it costs much more than a call.
        if T::from_f64(0.0).without_derivative().is_some() {
            differential_apart::<A, T>(&self.formula, mu)
        } else {
            self.formula.differential(mu)
        }
    }

    /// Returns D²h(μ)·v, which is formed symbolically from the text, as dh is.
    #[inline]
    fn hessian(&self, mu: &Momentum<A, T>, v: &Momentum<A, T>) -> Option<A::Element<T>> {
        Some(self.formula.second_derivative(mu, v))
    }
}

/// Returns dh in code that is compiled once for each algebra and scalar, and not at each place where a step needs it.
#[inline(never)]
fn differential_apart<A: LieAlgebra, T: Real>(
    formula: &Formula,
    mu: &Momentum<A, T>,
) -> A::Element<T> {
    formula.differential(mu)
}

impl<A> Clone for FormulaHamiltonian<A> {
    fn clone(&self) -> Self {
        Self { formula: self.formula.clone(), algebra: PhantomData }
    }
}

impl<A> PartialEq for FormulaHamiltonian<A> {
    fn eq(&self, other: &Self) -> bool {
        self.formula == other.formula
    }
}

impl<A> fmt::Debug for FormulaHamiltonian<A> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("FormulaHamiltonian").field(&self.formula.to_string()).finish()
    }
}

impl<A> fmt::Display for FormulaHamiltonian<A> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.formula.fmt(f)
    }
}
