//! A Lie–Poisson system whose Hamiltonian is a formula: [`FormulaSystem`].

use crate::algebras::system_algebra::SystemAlgebra;
use crate::casimirs::casimir::{Casimir, ScalarFunction};
use crate::casimirs::completion::Casimirs;
use crate::error::FormulaSystemError;
use lie_poisson_formulas::{
    Expression, Expressions, Formula, FormulaError, Parameters, StructureEntry, ValueError,
    Vocabulary, find_casimirs_of_table,
};

/// A Lie algebra 𝔤, a Hamiltonian h on its dual as a formula, and Casimirs of 𝔤.
///
/// The bracket is the minus bracket: dμ/dt = ad∗_ξ μ with ξ = dh(μ), in coordinates dμ_i/dt = Σ_jk c_jik ξ_j μ_k
/// with the structure constants [e_i, e_j] = Σ_k c_ijk e_k; or the [plus bracket](Self::with_plus_bracket).
///
/// # Example
/// The free relativistic rotor, with the Casimir of mass:
/// ```
/// use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra};
/// use lie_poisson_formulas::{Coordinates, Parameters};
/// let parameters = Parameters::new().number("a", 0.75)?;
/// let brackets = [("K, H", "P"), ("K, P", "H")];
/// let algebra = SystemAlgebra::of_brackets(Coordinates::scalars(["K", "H", "P"])?, brackets, &parameters)?;
/// let rotor = FormulaSystem::new(algebra, "K^2/2 + a*H^2 + P^2/2", &parameters)?.with_found_casimirs()?;
/// assert_eq!(rotor.casimirs()[0].to_string(), "H^2 - P^2");
/// assert_eq!(rotor.invariants(&[1.0, 2.0, 1.0])?, [4.0, 3.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct FormulaSystem {
    algebra: SystemAlgebra,
    hamiltonian: Formula,
    /// Whether the bracket is the plus bracket.
    is_plus: bool,
    /// The Hamiltonian of the motion with the minus bracket, in the coordinates of the completed algebra.
    motion: Formula,
    casimirs: Vec<Casimir>,
    degrees: Vec<u8>,
    missing: Option<usize>,
}

impl FormulaSystem {
    /// Creates the system of a Hamiltonian in the coordinates of the algebra and in parameters, without Casimirs.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::Parameters`] if a parameter has the name of a coordinate, and
    /// [`FormulaSystemError::Hamiltonian`] if the text is not a formula.
    pub fn new(
        algebra: SystemAlgebra,
        hamiltonian: &str,
        parameters: &Parameters,
    ) -> Result<Self, FormulaSystemError> {
        Self::of(algebra, parameters, |names| Formula::new(hamiltonian, names))
    }

    /// Creates the system of a Hamiltonian that a program has built, in the coordinates of the algebra and in
    /// parameters, without Casimirs.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::Parameters`] if a parameter has the name of a coordinate, and
    /// [`FormulaSystemError::Hamiltonian`] if the expression is not a scalar in these names.
    ///
    /// # Example
    /// ```
    /// use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra};
    /// use lie_poisson_formulas::{Expressions, Parameters};
    /// let mut parts = Expressions::new();
    /// let pi = parts.name("Pi");
    /// let square = parts.dot(pi, pi);
    /// let body = FormulaSystem::of_expressions(SystemAlgebra::named("so(3)")?, &parts, square, &Parameters::new())?;
    /// assert_eq!(body.invariants(&[1.0, 2.0, 2.0])?, [9.0]);
    /// # Ok::<(), lie_poisson_formula_systems::FormulaSystemError>(())
    /// ```
    pub fn of_expressions(
        algebra: SystemAlgebra,
        expressions: &Expressions,
        hamiltonian: Expression,
        parameters: &Parameters,
    ) -> Result<Self, FormulaSystemError> {
        Self::of(algebra, parameters, |names| {
            Formula::of_expressions(expressions, hamiltonian, names)
        })
    }

    fn of(
        algebra: SystemAlgebra,
        parameters: &Parameters,
        hamiltonian: impl Fn(&Vocabulary) -> Result<Formula, FormulaError>,
    ) -> Result<Self, FormulaSystemError> {
        let formula = |names| hamiltonian(&names).map_err(FormulaSystemError::Hamiltonian);
        let hamiltonian = formula(algebra.vocabulary(parameters)?)?;
        let motion = if algebra.width() == algebra.dimension() {
            hamiltonian.clone()
        } else {
            formula(algebra.completed(parameters).map_err(FormulaSystemError::Parameters)?)?
        };
        Ok(Self {
            algebra,
            hamiltonian,
            is_plus: false,
            motion,
            casimirs: Vec::new(),
            degrees: Vec::new(),
            missing: None,
        })
    }

    /// Returns the system with the plus bracket, dμ/dt = −ad∗_ξ μ: that of right-invariant systems, and of spins with
    /// ds/dt = s × B for h = −B·s.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::Hamiltonian`] if the Hamiltonian is as large as a formula may be.
    ///
    /// # Example
    /// ```
    /// use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra};
    /// use lie_poisson_formulas::Parameters;
    /// let spin = FormulaSystem::new(SystemAlgebra::named("so(3)")?, "-2*Pi3", &Parameters::new())?;
    /// let spin = spin.with_plus_bracket()?;
    /// assert_eq!(spin.rate(&[1.0, 0.0, 0.0])?, [0.0, -2.0, 0.0]); // s × B
    /// # Ok::<(), lie_poisson_formula_systems::FormulaSystemError>(())
    /// ```
    pub fn with_plus_bracket(self) -> Result<Self, FormulaSystemError> {
        if self.is_plus {
            return Ok(self);
        }
        let motion = self.motion.negated().map_err(FormulaSystemError::Hamiltonian)?;
        Ok(Self { is_plus: true, motion, ..self })
    }

    /// Returns whether the bracket is the plus bracket.
    #[must_use]
    pub const fn has_plus_bracket(&self) -> bool {
        self.is_plus
    }

    /// Returns the system with its Casimirs: the polynomials that
    /// [`find_casimirs`](lie_poisson_formulas::find_casimirs) finds from the structure constants, and as long as some are
    /// missing, those of the direct summands that are [named](SystemAlgebra::named) algebras of matrices, so(p, q) ⋉ Rⁿ with
    /// n = p + q and one vector, such as se(n), or sl(n, R) ⋉ Rⁿ.
    ///
    /// Those of matrices are invariants of X(μ) = Σ_ab μ_a G^ab E_b, where E_a are the matrices of the summand and G^ab is the
    /// inverse of the trace form G_ab = tr(E_a E_b): X(μ) is the matrix of the algebra with tr(X(μ) ξ) = ⟨μ, ξ⟩, which makes
    /// μ ↦ X(μ) equivariant. They are printed by short texts, in which `X(mu_2)` is the matrix of the summand with these
    /// coordinates if there are others:
    ///
    /// | text | Casimir | of |
    /// |---|---|---|
    /// | `tr X^k` | tr Xᵏ | so(n), so(p,q), sl(n,R), gl(n), sp(2n,R); su(n) for even k |
    /// | `tr J X^k` | tr(J Xᵏ) with the product J with i | su(n) for odd k, on Cⁿ = R²ⁿ: −2 Im tr Xᵏ of the complex matrix |
    /// | `Pf X` | the Pfaffian of ηX with the form η, of degree m | so(p,q), p + q = 2m |
    /// | <code>&#124;Gamma ∧ L^k&#124;^2</code> | the square of Γ ∧ L^∧k with η, of degree 2k + 2 | se(n), so(p,q) ⋉ Rn, 2k + 1 < n |
    /// | `Gamma ∧ L^m` | the one component of Γ ∧ L^∧m, of degree m + 1 | the same for n = 2m + 1 |
    /// | `det(Gamma, Gamma X, …)` | det(Γ, ΓX, …, ΓXⁿ⁻¹) with rows, of degree n (n + 1)/2 | sl(n,R) ⋉ Rn |
    ///
    /// Here Γ = Σ Γ_i eⁱ and L = Σ_(i<j) L_ij eⁱ∧eʲ are forms. A translation adds a product Γ ∧ v to L, so that Γ ∧ L^∧k stays
    /// the same, and a rotation turns it. Its square is the sum of the squares of its components at i₀ < … < i_2k with the
    /// signs η_i₀ ⋯ η_i_2k; in so(3,1) ⋉ R⁴ it is, but for its sign, that of the vector of Pauli and Lubański for k = 1. The
    /// name of the vector tells the summand.
    ///
    /// They are taken in the order of their degrees, and one whose differential at a generic point is a combination of those
    /// before is left out. They are [formulas](Casimir::formula) up to so(14), su(9), sl(11, R), gl(11) and sp(12, R), and
    /// so(p, q) ⋉ Rⁿ up to n = 11. Beyond these, up to the [largest dimension](SystemAlgebra::MOST_DIMENSIONS), and for
    /// sl(n, R) ⋉ Rⁿ with n > 2, they are computed from the matrices. None of these algebras has
    /// [missing](Self::missing_casimirs) ones. Wedge products with high powers of L lose digits: in 22 dimensions up to half.
    ///
    /// Sources: A. M. Perelomov & V. S. Popov, *Casimir operators for semisimple Lie groups*, Math. USSR Izv. 2 (1968), for
    /// the traces; C. Chevalley, *Invariants of finite groups generated by reflections*, Amer. J. Math. 77 (1955), for the
    /// number of them and their degrees; M. Perroud, *The fundamental invariants of inhomogeneous classical groups*, J. Math.
    /// Phys. 24 (1983), for the wedge products.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::Casimirs`] if the structure constants of the algebra do not allow a search.
    ///
    /// # Example
    /// ```
    /// use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra};
    /// use lie_poisson_formulas::Parameters;
    /// let body = FormulaSystem::new(SystemAlgebra::named("so(8)")?, "L12^2", &Parameters::new())?.with_found_casimirs()?;
    /// let texts: Vec<String> = body.casimirs().iter().skip(1).map(ToString::to_string).collect();
    /// assert_eq!(texts, ["tr X^4", "Pf X", "tr X^6"]);
    /// assert_eq!((body.casimir_degrees(), body.missing_casimirs()), (&[2, 4, 4, 6][..], Some(0)));
    /// # Ok::<(), lie_poisson_formula_systems::FormulaSystemError>(())
    /// ```
    pub fn with_found_casimirs(self) -> Result<Self, FormulaSystemError> {
        let found = find_casimirs_of_table(self.algebra.table(), self.algebra.coordinates())?;
        let names = self.algebra.vocabulary(&Parameters::new())?;
        let Casimirs { all, missing } =
            Casimirs::found(&found).completed(&self.algebra.summands, &names);
        let (degrees, casimirs) = all.into_iter().unzip();
        Ok(Self { casimirs, degrees, missing: Some(missing), ..self })
    }

    /// Returns the system of another Hamiltonian, or of the same one with other parameters, on the same algebra. It
    /// keeps the Casimirs, which depend on the algebra alone, without a new search.
    ///
    /// # Errors
    /// Returns the errors of [`new`](Self::new).
    ///
    /// # Example
    /// ```
    /// use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra};
    /// use lie_poisson_formulas::Parameters;
    /// let text = "a*|Pi|^2";
    /// let a = |value| Parameters::new().number("a", value);
    /// let body = FormulaSystem::new(SystemAlgebra::named("so(3)")?, text, &a(0.5)?)?.with_found_casimirs()?;
    /// let other = body.with_hamiltonian(text, &a(2.0)?)?;
    /// // h, then the Casimir |Π|²
    /// assert_eq!(body.invariants(&[1.0, 2.0, 2.0])?, [4.5, 9.0]);
    /// assert_eq!(other.invariants(&[1.0, 2.0, 2.0])?, [18.0, 9.0]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn with_hamiltonian(
        &self,
        hamiltonian: &str,
        parameters: &Parameters,
    ) -> Result<Self, FormulaSystemError> {
        let other = Self::new(self.algebra.clone(), hamiltonian, parameters)?;
        let other = if self.is_plus { other.with_plus_bracket()? } else { other };
        let (casimirs, degrees) = (self.casimirs.clone(), self.degrees.clone());
        Ok(Self { casimirs, degrees, missing: self.missing, ..other })
    }

    /// Returns the Lie algebra of the system.
    #[must_use]
    pub const fn algebra(&self) -> &SystemAlgebra {
        &self.algebra
    }

    /// Returns the Hamiltonian, in the coordinates of the algebra.
    #[must_use]
    pub const fn hamiltonian(&self) -> &Formula {
        &self.hamiltonian
    }

    /// Returns the Hamiltonian with which the minus bracket makes the motion, h or −h, in the coordinates of the algebra that
    /// is completed to its [width](SystemAlgebra::width).
    pub(crate) const fn motion(&self) -> &Formula {
        &self.motion
    }

    /// Returns the Casimirs that were found; none if they have not been searched for.
    #[must_use]
    pub fn casimirs(&self) -> &[Casimir] {
        &self.casimirs
    }

    /// Returns the degrees of the Casimirs that were found, which are homogeneous polynomials.
    #[must_use]
    pub fn casimir_degrees(&self) -> &[u8] {
        &self.degrees
    }

    /// Returns how many independent Casimirs were not found, or `None` if they have not been searched for.
    #[must_use]
    pub const fn missing_casimirs(&self) -> Option<usize> {
        self.missing
    }

    /// Returns h and then the Casimirs that were found, which are constant along the motion.
    pub fn conserved_functions(&self) -> impl Iterator<Item = &dyn ScalarFunction> {
        let casimirs = self.casimirs.iter().map(|casimir| casimir as &dyn ScalarFunction);
        core::iter::once(&self.hamiltonian as &dyn ScalarFunction).chain(casimirs)
    }

    /// Returns the values of h and of the Casimirs at a state.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::StateLength`] if the length of the state is not the dimension, and
    /// [`FormulaSystemError::NoFiniteValue`] if h or a Casimir has no finite value.
    pub fn invariants(&self, state: &[f64]) -> Result<Vec<f64>, FormulaSystemError> {
        self.require_length(state)?;
        let mut values = vec![self.hamiltonian.checked_value(state)?];
        for casimir in &self.casimirs {
            values.push(match casimir.formula() {
                Some(formula) => formula.checked_value(state)?,
                None => self.finite(casimir, state)?,
            });
        }
        Ok(values)
    }

    /// Returns the value of a Casimir that is computed, if it is finite.
    fn finite(&self, casimir: &Casimir, state: &[f64]) -> Result<f64, FormulaSystemError> {
        let value = casimir.value_at(state);
        if value.is_finite() {
            return Ok(value);
        }
        let names = self.algebra.coordinates().names().zip(state);
        let all: Vec<String> = names.map(|(name, x)| format!("{name} = {x}")).collect();
        let text = casimir.to_string();
        let state = all.join(", ");
        Err(ValueError::Value { formula: text.clone(), term: text, value, state }.into())
    }

    /// Checks that a state has the dimension of the algebra, and that h has a value and a differential there.
    pub(crate) fn require_differential(&self, state: &[f64]) -> Result<(), FormulaSystemError> {
        self.require_length(state)?;
        self.hamiltonian.checked_differential(state)?;
        Ok(())
    }

    /// Returns the rate dμ/dt = ad∗_ξ μ, ξ = dh(μ), at a state: the coordinates Σ_ik c_ijk ξ_i μ_k; with the plus bracket the
    /// negative.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::StateLength`] if the length of the state is not the dimension.
    ///
    /// # Example
    /// The free rigid body, dΠ/dt = Π × Ω:
    /// ```
    /// use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra};
    /// use lie_poisson_formulas::Parameters;
    /// let text = "(Pi1^2 + Pi2^2/2 + Pi3^2/4)/2";
    /// let body = FormulaSystem::new(SystemAlgebra::named("so(3)")?, text, &Parameters::new())?;
    /// // Ω = (1, 1, 1)
    /// assert_eq!(body.rate(&[1.0, 2.0, 4.0])?, [-2.0, 3.0, -1.0]);
    /// # Ok::<(), lie_poisson_formula_systems::FormulaSystemError>(())
    /// ```
    pub fn rate(&self, state: &[f64]) -> Result<Vec<f64>, FormulaSystemError> {
        self.require_length(state)?;
        let xi = self.hamiltonian.differential_at(state);
        let (sign, mut rate) = (if self.is_plus { -1.0 } else { 1.0 }, vec![0.0; state.len()]);
        for &StructureEntry { i, j, k, value } in self.algebra.entries() {
            let at = |v: &[f64], i: usize| v.get(i).copied().unwrap_or(f64::NAN);
            for (i, j, value) in [(i, j, value), (j, i, -value)] {
                if let Some(entry) = rate.get_mut(j) {
                    *entry += sign * value * at(&xi, i) * at(state, k);
                }
            }
        }
        Ok(rate)
    }

    /// Checks that a state has as many numbers as the algebra has dimensions.
    pub(crate) fn require_length(&self, state: &[f64]) -> Result<(), FormulaSystemError> {
        let (expected, found) = (self.algebra.dimension(), state.len());
        if expected == found {
            Ok(())
        } else {
            Err(FormulaSystemError::StateLength { expected, found })
        }
    }
}
