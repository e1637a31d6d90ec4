//! The Poincaré section of a system on a level set of its conserved quantities: [`SystemSection`].

use super::level_set::Level;
use super::start_search::StartSearch;
use crate::error::FormulaSystemError;
use crate::systems::formula_system::FormulaSystem;
use collective_integrators::Direction;
use lie_poisson_formulas::{Formula, Parameters, Vocabulary};

/// The states on a surface F(μ) = c at which h and the Casimirs have given values, with the direction of the crossings.
///
/// If F is an angle, such as `atan2(Gamma2, Gamma1)`, the surface is where F equals c up to a multiple of its
/// [period](Formula::period), so that every c is passed once per turn, and the jump of F is not on the surface.
///
/// # Example
/// Kirchhoff's body in a fluid, where P₃ = 0:
/// ```
/// use collective_integrators::Direction;
/// use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra, SystemSection};
/// use lie_poisson_formulas::Parameters;
/// let text = "(Pi1^2 + Pi2^2/2 + Pi3^2/3 + Gamma1^2 + Gamma2^2/2 + Gamma3^2/3)/2";
/// let body = FormulaSystem::new(SystemAlgebra::named("se(3)")?, text, &Parameters::new())?;
/// let body = body.with_found_casimirs()?;
/// let state = [1.0, 0.5, 0.3, 0.6, 0.0, 0.8];
/// let section = SystemSection::new(&body, "Gamma3", &Parameters::new(), (0.0, Direction::Up))?;
/// let level = body.invariants(&state)?;
/// for start in section.starts(&state, &level, 5, 0)? {
///     assert!(section.value(&start).abs() < 1e-15);
///     for (value, level) in body.invariants(&start)?.iter().zip(&level) {
///         assert!((value - level).abs() < 1e-14);
///     }
///     assert!(body.rate(&start)?[5] > 0.0);
/// }
/// # Ok::<(), lie_poisson_formula_systems::FormulaSystemError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SystemSection {
    system: FormulaSystem,
    surface: Formula,
    level: f64,
    direction: Direction,
    axes: [Formula; 2],
}

impl SystemSection {
    /// Creates the section of a system by the surface where a formula has a level, with the directions of the crossings
    /// that count. Its axes are the first two coordinates, apart from one that the surface fixes.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::Surface`] if the text is not a formula, [`FormulaSystemError::Level`] if the level
    /// is not finite, and [`FormulaSystemError::NoAxes`] if the algebra has too few coordinates.
    pub fn new(
        system: &FormulaSystem,
        surface: &str,
        parameters: &Parameters,
        (level, direction): (f64, Direction),
    ) -> Result<Self, FormulaSystemError> {
        let names = system.algebra().vocabulary(parameters)?;
        let surface = Formula::new(surface, &names).map_err(FormulaSystemError::Surface)?;
        if !level.is_finite() {
            return Err(FormulaSystemError::Level { value: level });
        }
        let dimension = system.algebra().dimension();
        let fixed = surface.to_string();
        let mut free = system.algebra().coordinates().names().filter(|name| *name != fixed);
        let (Some(x), Some(y)) = (free.next(), free.next()) else {
            return Err(FormulaSystemError::NoAxes { dimension });
        };
        let axes = axes([&x, &y], &names)?;
        Ok(Self { system: system.clone(), surface, level, direction, axes })
    }

    /// Returns the section with the given axes, the formulas over which it is drawn.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::Axis`] if a text is not a formula.
    pub fn with_axes(
        self,
        texts: [&str; 2],
        parameters: &Parameters,
    ) -> Result<Self, FormulaSystemError> {
        let axes = axes(texts, &self.system.algebra().vocabulary(parameters)?)?;
        Ok(Self { axes, ..self })
    }

    /// Returns the axes, the formulas over which the section is drawn.
    #[must_use]
    pub const fn axes(&self) -> &[Formula; 2] {
        &self.axes
    }

    /// Returns the values of the axes at a state, or NaN if the length of the state is not the dimension.
    #[must_use]
    pub fn plane(&self, state: &[f64]) -> [f64; 2] {
        let [x, y] = &self.axes;
        [x.value_at(state), y.value_at(state)]
    }

    /// Returns the values of the axes at a state.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::NoFiniteValue`] if an axis has no finite value.
    pub fn checked_plane(&self, state: &[f64]) -> Result<[f64; 2], FormulaSystemError> {
        let [x, y] = &self.axes;
        Ok([x.checked_value(state)?, y.checked_value(state)?])
    }

    /// Returns the system of which this is a section.
    #[must_use]
    pub const fn system(&self) -> &FormulaSystem {
        &self.system
    }

    /// Returns the formula of the surface.
    #[must_use]
    pub const fn surface(&self) -> &Formula {
        &self.surface
    }

    /// Returns the level c of the surface F(μ) = c, in the unit of F.
    #[must_use]
    pub const fn level(&self) -> f64 {
        self.level
    }

    /// Returns the directions of the crossings that count.
    #[must_use]
    pub const fn direction(&self) -> Direction {
        self.direction
    }

    /// Returns F(μ) − c at a state, or NaN if the length of the state is not the dimension. For an angle F it is the
    /// difference of least size, between −½ and ½ periods.
    #[must_use]
    pub fn value(&self, state: &[f64]) -> f64 {
        self.on_surface().difference(state)
    }

    /// Returns the period of F if it is an angle. [`Events::modulo`](collective_integrators::Events::modulo) takes it.
    #[must_use]
    pub fn period(&self) -> Option<f64> {
        self.surface.period()
    }

    fn on_surface(&self) -> Level<'_> {
        Level { period: self.period(), ..Level::new(&self.surface, self.level) }
    }

    /// Returns states of the section, where h and the Casimirs have the values `levels`: h first, then the Casimirs in
    /// their order.
    ///
    /// All states lie on one coadjoint orbit: that of `state`, also if some Casimirs are no polynomials or are unknown,
    /// or if the Casimirs alone do not tell the orbit from others, as on the two sheets of a hyperboloid. If the levels of
    /// the Casimirs are not those of `state`, it is the orbit of the nearest state that has them.
    ///
    /// Each state begins with a random guess that is projected to the section. On so(3)∗ and se(3)∗ the guess has the size
    /// of `state`; on other spaces it is a random motion of `state` along its orbit, μ ↦ exp(ad∗_ξ) μ, and so are the
    /// steps of the projection. A state that crosses the surface in the wrong direction, or not at all, does not count.
    /// The seed determines the sequence, and a longer one begins with the states of a shorter one. The size of each vector
    /// in `state` serves as its unit: if the vectors are given in other units, the starts are the same states in these
    /// units. All coordinates that are numbers have one common unit.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::StateLength`] if the length of `state` is not the dimension,
    /// [`FormulaSystemError::Level`] if a level is not finite, [`FormulaSystemError::UnknownOrbit`] if the levels of the
    /// Casimirs are not those of `state` and do not determine an orbit, and [`FormulaSystemError::TooSmall`] if too few
    /// guesses lead to a state of the section.
    pub fn starts(
        &self,
        state: &[f64],
        levels: &[f64],
        count: usize,
        seed: u64,
    ) -> Result<Vec<Vec<f64>>, FormulaSystemError> {
        let search = StartSearch::new(&self.system, self.on_surface(), state, levels)?;
        search.starts(count, seed, |state| self.crosses(state))
    }

    /// Returns whether the motion through a state crosses the surface in a direction that counts.
    fn crosses(&self, state: &[f64]) -> Result<bool, FormulaSystemError> {
        let slopes = self.surface.differential_at(state);
        let rate: f64 =
            self.system.rate(state)?.iter().zip(slopes).map(|(rate, slope)| rate * slope).sum();
        Ok(match self.direction {
            Direction::Up => rate > 0.0,
            Direction::Down => rate < 0.0,
            Direction::Both => rate != 0.0,
        })
    }
}

/// Returns the formulas of two axes.
fn axes(texts: [&str; 2], names: &Vocabulary) -> Result<[Formula; 2], FormulaSystemError> {
    let axis = |axis: usize| {
        Formula::new(texts[axis], names)
            .map_err(|problem| FormulaSystemError::Axis { axis, problem })
    };
    Ok([axis(0)?, axis(1)?])
}
