//! The formulas of an open system: [`OpenNames`].

use super::named_inputs::NamedInputs;
use super::spin_terms::require_spins;
use crate::algebras::system_algebra::SystemAlgebra;
use crate::catalogue::system_kind::SystemKind;
use crate::error::FormulaSystemError;
use crate::open_system_error::OpenSystemError;
use crate::systems::formula_system::FormulaSystem;
use lie_poisson::InnerProduct;
use lie_poisson_formulas::{Formula, Parameters, Vocabulary};

/// The names that formulas of an open system may use, and the formulas in them.
///
/// # Example
/// ```
/// use lie_poisson_formula_systems::{NamedInputs, OpenNames, SystemAlgebra};
/// use lie_poisson_formulas::Parameters;
/// let algebra = SystemAlgebra::named("so(3)")?;
/// let names = OpenNames::new(algebra, &NamedInputs::default(), Parameters::new().number("B", 2.0)?)?;
/// let (spin, in_time) = names.system("-B*(Pi3 + sin(t)*Pi1)")?;
/// assert_eq!(spin.invariants(&[0.5, 0.0, 1.0])?, [-2.0]); // as it is at t = 0
/// assert_eq!(in_time.map(|h| h.value_at(&[0.5, 0.0, 1.0, 1.0])), Some(-2.0 * (1.0 + 0.5 * 1.0_f64.sin())));
/// assert_eq!(names.system("-B*Pi3")?.1, None);
/// let torque = names.element("torque", [("Pi", vec!["0".into(), "0".into(), "cos(t)".into()])])?;
/// assert_eq!(torque[2].value_at(&[0.0, 0.0, 0.0, 0.0]), 1.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct OpenNames {
    algebra: SystemAlgebra,
    parameters: Parameters,
    /// The parameters with the time and the inputs as they are at t = 0.
    frozen: Parameters,
    vocabulary: Vocabulary,
    /// The names of coordinates that are directions in space.
    directions: &'static [&'static str],
}

impl OpenNames {
    /// Creates the names of an algebra: its coordinates, the time `t`, inputs and parameters.
    ///
    /// # Errors
    /// Returns [`OpenSystemError::InputName`] for an input whose name cannot be one, or is there already.
    pub fn new(
        algebra: SystemAlgebra,
        inputs: &NamedInputs,
        parameters: Parameters,
    ) -> Result<Self, OpenSystemError> {
        let vocabulary = inputs.vocabulary(&algebra, &parameters)?;
        let frozen = inputs.frozen(parameters.clone())?;
        Ok(Self { algebra, parameters, frozen, vocabulary, directions: &[] })
    }

    /// Returns the names, of which these stand for directions in space, on which no torque acts: their lengths and the angles between
    /// them have a meaning, such as |Γ| = 1 of the vertical Γ of a top.
    #[must_use]
    pub fn with_directions(self, directions: &'static [&'static str]) -> Self {
        Self { directions, ..self }
    }

    /// Returns the system by name with these parameters as it is at t = 0, with its Casimirs; the names for formulas; and the
    /// Hamiltonian if it depends on the time, with the rate and the tide of the orbit that the inputs must have then. The Casimirs of an
    /// algebra that is the same as that of `near` are not looked for again.
    ///
    /// # Errors
    /// Those of [`SystemKind::system`], but for a Hamiltonian that depends on the time, and those of [`new`](Self::new).
    pub fn of_kind(
        kind: &SystemKind,
        parameters: Parameters,
        inputs: &NamedInputs,
        near: Option<&FormulaSystem>,
    ) -> Result<(FormulaSystem, Self, Option<Formula>), FormulaSystemError> {
        if kind.orbit(&parameters)?.is_none() {
            let base = match near {
                Some(near) => kind.system_near(near, &parameters)?,
                None => kind.system(&parameters)?,
            };
            let named = kind.with_circle(parameters)?;
            let names = Self::new(base.algebra().clone(), inputs, named)?;
            return Ok((base, names.with_directions(kind.directions), None));
        }
        let own = kind.description(&parameters)?;
        let names = Self::new(own.algebra.clone(), inputs, parameters)?;
        let names = names.with_directions(kind.directions);
        let of_formula = Self::new(own.algebra, inputs, own.parameters)?;
        if let Some(near) = near.filter(|near| *near.algebra() == of_formula.algebra) {
            let (base, hamiltonian) = of_formula.system_near(near, &own.hamiltonian)?;
            return Ok((base, names, hamiltonian));
        }
        let (base, hamiltonian) = of_formula.system(&own.hamiltonian)?;
        let base = if own.has_plus_bracket { base.with_plus_bracket()? } else { base };
        Ok((base.with_found_casimirs()?, names, hamiltonian))
    }

    /// Returns the names: the coordinates are followed by `t` and the inputs.
    #[must_use]
    pub const fn vocabulary(&self) -> &Vocabulary {
        &self.vocabulary
    }

    /// Returns the system of a Hamiltonian as it is at t = 0, without Casimirs, and the Hamiltonian if it depends on the time
    /// or on an input.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::Hamiltonian`] if the text is not a formula in these names.
    pub fn system(
        &self,
        hamiltonian: &str,
    ) -> Result<(FormulaSystem, Option<Formula>), FormulaSystemError> {
        let in_time = Formula::new(hamiltonian, &self.vocabulary);
        let in_time = in_time.map_err(FormulaSystemError::Hamiltonian)?;
        self.system_by(in_time, |parameters| {
            FormulaSystem::new(self.algebra.clone(), hamiltonian, parameters)
        })
    }

    /// As [`system`](Self::system), with the algebra, the sign of the bracket and the Casimirs of another system.
    ///
    /// # Errors
    /// As [`system`](Self::system).
    pub fn system_near(
        &self,
        base: &FormulaSystem,
        hamiltonian: &str,
    ) -> Result<(FormulaSystem, Option<Formula>), FormulaSystemError> {
        let in_time = Formula::new(hamiltonian, &self.vocabulary);
        let in_time = in_time.map_err(FormulaSystemError::Hamiltonian)?;
        self.system_by(in_time, |parameters| base.with_hamiltonian(hamiltonian, parameters))
    }

    /// As [`system`](Self::system), for a Hamiltonian that is made in some other way: `in_time` is the formula in these names, and
    /// `system` makes the system with parameters, of which some may have the names of the time and of inputs.
    ///
    /// # Errors
    /// That of `system`, if it fails even where the time and the inputs are parameters.
    pub fn system_by(
        &self,
        in_time: Formula,
        system: impl Fn(&Parameters) -> Result<FormulaSystem, FormulaSystemError>,
    ) -> Result<(FormulaSystem, Option<Formula>), FormulaSystemError> {
        match system(&self.parameters) {
            Ok(system) => Ok((system, None)),
            Err(_) => Ok((system(&self.frozen)?, Some(in_time))),
        }
    }

    /// Returns a formula of a text.
    ///
    /// # Errors
    /// Returns [`OpenSystemError::Formula`], which says what the formula is for.
    pub fn formula(&self, what: &str, text: &str) -> Result<Formula, OpenSystemError> {
        let formula = Formula::new(text, &self.vocabulary);
        formula.map_err(|reason| OpenSystemError::Formula {
            what: what.into(),
            reason: Box::new(reason),
        })
    }

    /// Checks that the algebra is that of spins, so(3) or a sum of several, for forms of damping that are of them.
    ///
    /// # Errors
    /// Returns [`OpenSystemError::NoSpins`] if it is not.
    pub fn require_spins(&self) -> Result<(), OpenSystemError> {
        require_spins(&self.algebra)
    }

    /// Returns the inner product of a matrix on the dual of the algebra, by its rows one after the other. Without one it is the unit
    /// matrix, if all coordinates are those of one vector, or scalars of their own.
    ///
    /// # Errors
    /// Returns [`OpenSystemError::InnerProduct`] if the matrix is none of an inner product, and
    /// [`OpenSystemError::NoInnerProduct`] if there is none for several vectors.
    pub fn inner_product(&self, rows: Option<&[f64]>) -> Result<InnerProduct, OpenSystemError> {
        if let Some(rows) = rows {
            return Ok(InnerProduct::new(rows)?);
        }
        let groups = self.algebra.coordinates().groups();
        let vectors =
            groups.filter(|(_, places)| places.len() > 1).map(|(name, _)| name.to_owned());
        let vectors: Vec<String> = vectors.collect();
        let dimension = self.algebra.dimension();
        match vectors.len() {
            0 | 1 => Ok(InnerProduct::euclidean()),
            _ => Err(OpenSystemError::NoInnerProduct { dimension, vectors }),
        }
    }

    /// Checks that a torque, with a formula for each coordinate, is 0 on [directions](Self::with_directions) in space.
    ///
    /// # Errors
    /// Returns [`OpenSystemError::TorqueOnDirection`], which names one on which it acts, and the coordinates that may have formulas.
    ///
    /// # Example
    /// ```
    /// use lie_poisson_formula_systems::{NamedInputs, OpenNames, SystemKind};
    /// use lie_poisson_formulas::Parameters;
    /// let given = Parameters::new().vector("I", &[2.0, 3.0, 1.5])?.number("n", 1e-3)?;
    /// let (_, names, _) = OpenNames::of_kind(SystemKind::named("satellite")?, given, &NamedInputs::default(), None)?;
    /// let on = |name| names.element("torque", [(name, vec!["0".into(), "0.1".into(), "0".into()])]);
    /// assert!(names.require_torque(&on("Pi")?).is_ok());
    /// let refused = names.require_torque(&on("Gamma_1")?).unwrap_err();
    /// assert_eq!(refused.to_string(), "a torque has formulas for Pi alone: Gamma_1 is a direction in space");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn require_torque(&self, torque: &[Formula]) -> Result<(), OpenSystemError> {
        let coordinates = self.algebra.coordinates();
        let acts = |name: &&&str| {
            let mut places = coordinates.places(name).into_iter().flatten();
            places.any(|place| torque.get(place).is_some_and(|formula| !is_zero(formula)))
        };
        let Some(name) = self.directions.iter().find(acts) else { return Ok(()) };
        let names = coordinates.groups().map(|(name, _)| name);
        let momenta = names.filter(|name| !self.directions.contains(name)).map(str::to_owned);
        Err(OpenSystemError::TorqueOnDirection {
            name: (*name).to_owned(),
            momenta: momenta.collect(),
        })
    }

    /// Returns formulas for all coordinates, of those for vectors or scalars of coordinates by name; what is left out is 0.
    ///
    /// # Errors
    /// Returns [`OpenSystemError::Formula`] for a text that is no formula, [`OpenSystemError::NoCoordinate`] for a name that no
    /// coordinates have, and [`OpenSystemError::Count`] for another number of formulas than coordinates have the name.
    pub fn element<'a>(
        &self,
        what: &str,
        parts: impl IntoIterator<Item = (&'a str, Vec<String>)>,
    ) -> Result<Vec<Formula>, OpenSystemError> {
        let coordinates = self.algebra.coordinates();
        let mut all = vec![self.formula(what, "0")?; self.algebra.dimension()];
        for (name, texts) in parts {
            let Some(places) = coordinates.places(name) else {
                let names = coordinates.groups().map(|(name, _)| name.to_owned()).collect();
                return Err(OpenSystemError::NoCoordinate {
                    what: what.into(),
                    name: name.into(),
                    names,
                });
            };
            let (expected, found) = (places.len(), texts.len());
            if expected != found {
                let what = format!("{what} {name}");
                return Err(OpenSystemError::Count { what, expected, found });
            }
            let which = |i: usize| {
                if expected == 1 {
                    format!("{what} {name}")
                } else {
                    format!("{what} {name}{}", i + 1)
                }
            };
            for (i, (text, place)) in texts.iter().zip(places).enumerate() {
                if let Some(entry) = all.get_mut(place) {
                    *entry = self.formula(&which(i), text)?;
                }
            }
        }
        Ok(all)
    }
}

/// Returns whether a formula is the number 0.
fn is_zero(formula: &Formula) -> bool {
    let count = formula.dimension();
    !(0..count).any(|i| formula.depends_on(i)) && formula.value_at(&vec![0.0; count]) == 0.0
}
