//! A system by name: [`SystemKind`].

use super::parameter::{Parameter, ParameterShape, require_parameters};
use crate::algebras::system_algebra::SystemAlgebra;
use crate::error::FormulaSystemError;
use crate::systems::formula_system::FormulaSystem;
use lie_poisson_formulas::{NameError, Parameters};
use lie_poisson_systems::KeplerOrbit;

/// The names of the rate dν/dt and of the tide GM/r³ of an ellipse in formulas.
pub(crate) const ORBIT: [&str; 2] = ["orbit_rate", "orbit_tide"];

/// The parameter of an orbit that makes it an ellipse.
pub(super) const ECCENTRICITY: &str = "eccentricity";

/// A system by name: what its parameters are, and the algebra and the Hamiltonian that they make.
///
/// # Example
/// ```
/// use lie_poisson_formula_systems::SystemKind;
/// use lie_poisson_formulas::Parameters;
/// let kind = SystemKind::named("body-with-rotors")?;
/// let parameters = Parameters::new().vector("I", &[1.0, 2.0, 3.0])?.vector("J", &[0.1, 0.2])?;
/// let body = kind.system(&parameters)?;
/// // dΠ/dt = Π × Ω; the rotors keep their angular momenta.
/// let rate = body.rate(&[1.0, 0.0, 3.0, 0.5, 0.4])?;
/// let omega = [(1.0 - 0.5) / 1.0, (0.0 - 0.4) / 2.0, 3.0 / 3.0];
/// let expected = [-3.0 * omega[1], 3.0 * omega[0] - omega[2], omega[1], 0.0, 0.0];
/// assert!(rate.iter().zip(expected).all(|(x, y)| (x - y).abs() < 1e-15));
/// assert!(kind.system(&Parameters::new()).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct SystemKind {
    /// The name of the system.
    pub name: &'static str,
    /// What the system is, in a few words.
    pub about: &'static str,
    /// The parameters.
    pub parameters: &'static [Parameter],
    /// Returns the system that values of all parameters describe, or the parameter with a value that it cannot have and what
    /// it needs.
    pub(super) describe: fn(&Given<'_>) -> Result<Description, KindError>,
    /// Returns the orbit with whose rate and tide the Hamiltonian depends on the time, if it does; `None` of systems that do not go
    /// about a centre.
    pub(super) orbit: Option<OrbitOf>,
    /// The names of coordinates that are directions in space, on which no torque acts.
    pub(crate) directions: &'static [&'static str],
    /// Another way to give a start than by the coordinates.
    pub start: Option<KindStart>,
}

/// Returns the ellipse of values of all parameters; none of a circle, on which the Hamiltonian does not depend on the time.
type OrbitOf = fn(&Given<'_>) -> Result<Option<KeplerOrbit>, KindError>;

/// A start that is not given by the coordinates, such as positions of vortices.
#[derive(Clone, Copy, Debug)]
pub struct KindStart {
    /// The names of what is given instead.
    pub given: &'static [Parameter],
    /// Returns the coordinates from the parameters of the system and from what is given.
    pub(super) coordinates: fn(&Given<'_>, &Given<'_>) -> Result<Vec<f64>, KindError>,
}

/// The reason why a value makes no system.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum KindError {
    /// The name of the value, and what it must be.
    Value(&'static str, String),
    /// The algebra or the formula is refused.
    System(Box<FormulaSystemError>),
}

impl<E: Into<FormulaSystemError>> From<E> for KindError {
    fn from(error: E) -> Self {
        Self::System(Box::new(error.into()))
    }
}

/// What the parameters of a kind describe.
pub(crate) struct Description {
    pub(crate) algebra: SystemAlgebra,
    pub(crate) hamiltonian: String,
    /// The parameters of the Hamiltonian.
    pub(crate) parameters: Parameters,
    pub(crate) has_plus_bracket: bool,
}

/// The values of all parameters, those with a default too.
pub(super) struct Given<'a> {
    all: &'static [Parameter],
    values: &'a Parameters,
}

impl Given<'_> {
    /// Returns the numbers of a parameter.
    pub(super) fn values(&self, name: &str) -> Vec<f64> {
        let own = self.all.iter().find(|own| own.name == name);
        let default = own.and_then(|own| own.default).unwrap_or_default();
        self.values.values(name).unwrap_or(default).to_vec()
    }

    /// Returns whether a parameter is given.
    pub(super) fn has(&self, name: &str) -> bool {
        self.values.values(name).is_some()
    }

    /// Returns a parameter that is a number.
    pub(super) fn number(&self, name: &str) -> f64 {
        self.values(name).first().copied().unwrap_or(f64::NAN)
    }

    /// Returns these parameters as those of a formula.
    pub(super) fn parameters(&self, names: &[&str]) -> Result<Parameters, NameError> {
        names.iter().try_fold(Parameters::new(), |all, name| {
            let is_number =
                self.all.iter().any(|own| own.name == *name && own.shape == ParameterShape::Number);
            match is_number {
                true => all.number(name, self.number(name)),
                false => all.vector(name, &self.values(name)),
            }
        })
    }

    /// Checks that the numbers of a parameter are positive, or not negative.
    pub(super) fn require(&self, name: &'static str, above: Sign) -> Result<(), KindError> {
        let allowed = |value: &f64| match above {
            Sign::Positive => *value > 0.0,
            Sign::NotNegative => *value >= 0.0,
        };
        match self.values(name).iter().find(|value| !allowed(value)) {
            None => Ok(()),
            Some(value) => {
                let needed = if above == Sign::Positive { "positive" } else { "0 or positive" };
                Err(KindError::Value(name, format!("{needed}, got {value}")))
            }
        }
    }

    /// Checks that three numbers are moments of inertia of a body: positive, and none larger than the sum of the others.
    pub(super) fn require_moments(&self, name: &'static str) -> Result<(), KindError> {
        self.require(name, Sign::Positive)?;
        let moments = self.values(name);
        let (sum, largest) =
            (moments.iter().sum::<f64>(), moments.iter().fold(0.0, |a: f64, b| a.max(*b)));
        // Rounding alone breaks no inequality.
        match largest <= (sum - largest) * (1.0 + 4.0 * f64::EPSILON) {
            true => Ok(()),
            false => {
                let needed =
                    format!("moments of a body, none above the sum of the others, got {moments:?}");
                Err(KindError::Value(name, needed))
            }
        }
    }
}

/// The sign that numbers must have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sign {
    Positive,
    NotNegative,
}

impl SystemKind {
    /// Returns the system with these parameters, and its Casimirs.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::KindParameter`] if a parameter is missing, has another number of components, or is none
    /// of the system, and [`FormulaSystemError::KindValue`] if it has a value that it cannot have, or one with which the Hamiltonian
    /// depends on the time: that is an [open system](crate::OpenNames::of_kind).
    pub fn system(&self, parameters: &Parameters) -> Result<FormulaSystem, FormulaSystemError> {
        self.require_closed(parameters)?;
        let Description { algebra, hamiltonian, parameters, has_plus_bracket } =
            self.description(parameters)?;
        let system = FormulaSystem::new(algebra, &hamiltonian, &parameters)?;
        let system = if has_plus_bracket { system.with_plus_bracket()? } else { system };
        system.with_found_casimirs()
    }

    /// Returns the system with these parameters on the algebra of one with others, whose Casimirs are not looked for again.
    ///
    /// # Errors
    /// Those of [`system`](Self::system).
    pub fn system_near(
        &self,
        base: &FormulaSystem,
        parameters: &Parameters,
    ) -> Result<FormulaSystem, FormulaSystemError> {
        self.require_closed(parameters)?;
        let near = self.description(parameters)?;
        match near.algebra == *base.algebra() {
            true => base.with_hamiltonian(&near.hamiltonian, &near.parameters),
            false => self.system(parameters),
        }
    }

    /// Returns the coordinates of a start that is given in the [way of the system](Self::start), or `None` if it is given by
    /// something else.
    ///
    /// # Errors
    /// Those of [`system`](Self::system), about what is given.
    pub fn coordinates(
        &self,
        parameters: &Parameters,
        given: &Parameters,
    ) -> Option<Result<Vec<f64>, FormulaSystemError>> {
        let start = self.start?;
        let shapes: Vec<_> = given.shapes().collect();
        let is_own = |name: &str| start.given.iter().any(|own| own.name == name);
        let coordinates = self.description(parameters).map(|own| own.algebra.coordinates().clone());
        let is_coordinate =
            |name: &str| coordinates.as_ref().is_ok_and(|own| own.places(name).is_some());
        let is_start = shapes.is_empty()
            || shapes.iter().any(|(name, _)| is_own(name) || !is_coordinate(name));
        is_start.then(|| {
            require_parameters((self.name, true), start.given, &shapes)?;
            let system = Given { all: self.parameters, values: parameters };
            let own = Given { all: start.given, values: given };
            (start.coordinates)(&system, &own).map_err(|error| self.refused(error))
        })
    }

    /// Returns the orbit with whose rate and tide the Hamiltonian of these parameters depends on the time; none if it does not.
    ///
    /// # Errors
    /// Those of [`system`](Self::system).
    pub fn orbit(
        &self,
        parameters: &Parameters,
    ) -> Result<Option<KeplerOrbit>, FormulaSystemError> {
        let Some(orbit) = self.orbit else { return Ok(None) };
        orbit(&self.given(parameters)?).map_err(|error| self.refused(error))
    }

    /// Returns whether the Hamiltonian depends on the time with some values of a parameter, and with others not.
    #[must_use]
    pub fn opens_with(&self, parameter: &str) -> bool {
        self.orbit.is_some() && parameter == ECCENTRICITY
    }

    /// Returns the parameters with the rate n and the tide n² of a circle about a centre, `orbit_rate` and `orbit_tide`, which are numbers
    /// then, for formulas that may be of an ellipse, too. Other parameters stay as they are.
    ///
    /// # Errors
    /// Those of [`orbit`](Self::orbit), and [`FormulaSystemError::Parameters`] if a name is there already.
    ///
    /// # Example
    /// ```
    /// use lie_poisson_formula_systems::SystemKind;
    /// use lie_poisson_formulas::Parameters;
    /// let satellite = Parameters::new().vector("I", &[2.0, 3.0, 1.5])?.number("n", 3.0)?;
    /// let named = SystemKind::named("satellite")?.with_circle(satellite)?;
    /// assert_eq!(named.values("orbit_tide"), Some(&[9.0][..]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn with_circle(&self, parameters: Parameters) -> Result<Parameters, FormulaSystemError> {
        let is_circle = self.orbit.is_some() && self.orbit(&parameters)?.is_none();
        let rate = parameters.values("n").and_then(|values| values.first().copied());
        let Some(n) = rate.filter(|_| is_circle) else { return Ok(parameters) };
        let [rate, tide] = ORBIT;
        let named = parameters.number(rate, n).and_then(|named| named.number(tide, n * n));
        named.map_err(FormulaSystemError::Parameters)
    }

    fn require_closed(&self, parameters: &Parameters) -> Result<(), FormulaSystemError> {
        let Some(orbit) = self.orbit(parameters)? else { return Ok(()) };
        let needed =
            format!("0 where nothing may depend on the time, got {}", orbit.eccentricity());
        Err(self.refused(KindError::Value(ECCENTRICITY, needed)))
    }

    /// Returns the values of all parameters, if they are those of the kind.
    fn given<'a>(&self, parameters: &'a Parameters) -> Result<Given<'a>, FormulaSystemError> {
        let shapes: Vec<_> = parameters.shapes().collect();
        require_parameters((self.name, false), self.parameters, &shapes)?;
        Ok(Given { all: self.parameters, values: parameters })
    }

    pub(crate) fn description(
        &self,
        parameters: &Parameters,
    ) -> Result<Description, FormulaSystemError> {
        (self.describe)(&self.given(parameters)?).map_err(|error| self.refused(error))
    }

    fn refused(&self, error: KindError) -> FormulaSystemError {
        match error {
            KindError::Value(name, needed) => {
                FormulaSystemError::KindValue { kind: self.name, name, needed }
            }
            KindError::System(error) => *error,
        }
    }
}
