//! The names of formulas of open systems, and the inputs among them: [`NamedInputs`].

use crate::algebras::system_algebra::SystemAlgebra;
use crate::catalogue::system_kind::ORBIT;
use crate::error::FormulaSystemError;
use crate::open_system_error::OpenSystemError;
use lie_poisson::{InputTable, Real};
use lie_poisson_formulas::{Coordinates, Parameters, Vocabulary};
use lie_poisson_systems::KeplerOrbit;

/// Inputs u(t) by tables, whose names formulas may use beside the coordinates and the time `t`; and, of a system on an ellipse, the
/// rate dν/dt and the tide GM/r³ of its orbit, `orbit_rate` (rad/s) and `orbit_tide` (1/s²).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct NamedInputs {
    tables: Vec<(String, InputTable)>,
    orbit: Option<KeplerOrbit>,
}

impl NamedInputs {
    /// The name of the time in formulas.
    pub const TIME: &str = "t";

    /// Creates the inputs of these names.
    #[must_use]
    pub const fn new(tables: Vec<(String, InputTable)>) -> Self {
        Self { tables, orbit: None }
    }

    /// Returns the inputs with the rate and the tide of an orbit, if there is one.
    ///
    /// # Example
    /// On an ellipse the tide is strongest at the pericentre, where it is n²/(1 − e)³:
    /// ```
    /// use lie_poisson_formula_systems::{NamedInputs, SystemKind};
    /// use lie_poisson_formulas::Parameters;
    /// let given = Parameters::new().vector("I", &[2.0, 3.0, 1.5])?.number("n", 2.0)?.number("eccentricity", 0.5)?;
    /// let inputs = NamedInputs::default().with_orbit(SystemKind::named("satellite")?.orbit(&given)?);
    /// let mut x: Vec<f64> = Vec::new();
    /// inputs.append(0.0, &mut x); // the time, the rate and the tide
    /// assert!(x[0] == 0.0 && (x[1] - 2.0 * 0.75_f64.sqrt() / 0.25).abs() < 1e-14 && (x[2] - 32.0).abs() < 1e-13);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn with_orbit(self, orbit: Option<KeplerOrbit>) -> Self {
        Self { orbit, ..self }
    }

    /// Returns the names of the inputs, in their order.
    fn names(&self) -> impl Iterator<Item = &str> {
        let of_orbit = self.orbit.iter().flat_map(|_| ORBIT);
        self.tables.iter().map(|(name, _)| name.as_str()).chain(of_orbit)
    }

    /// Returns the names for formulas of an open system on an algebra: its coordinates, `t`, the inputs and the parameters.
    ///
    /// # Errors
    /// Returns [`OpenSystemError::InputName`] for a name that cannot be one or is there already.
    pub fn vocabulary(
        &self,
        algebra: &SystemAlgebra,
        parameters: &Parameters,
    ) -> Result<Vocabulary, OpenSystemError> {
        self.vocabulary_after(algebra.coordinates().clone(), parameters)
    }

    /// Returns the names for formulas in the time alone: `t` and the inputs.
    ///
    /// # Errors
    /// Returns [`OpenSystemError::InputName`] for a name that cannot be one or is there already.
    pub fn vocabulary_of_time(&self) -> Result<Vocabulary, OpenSystemError> {
        self.vocabulary_after(Coordinates::new(), &Parameters::new())
    }

    /// Returns the names of coordinates, then `t`, the inputs and the parameters.
    fn vocabulary_after(
        &self,
        mut coordinates: Coordinates,
        parameters: &Parameters,
    ) -> Result<Vocabulary, OpenSystemError> {
        let wrong = |name: &str, reason| match name {
            Self::TIME => OpenSystemError::TimeName,
            _ => OpenSystemError::InputName { name: name.into(), reason },
        };
        for name in [Self::TIME].into_iter().chain(self.names()) {
            coordinates = coordinates.scalar(name).map_err(|reason| wrong(name, reason))?;
            Vocabulary::new(&coordinates, parameters).map_err(|reason| wrong(name, reason))?;
        }
        Vocabulary::new(&coordinates, parameters).map_err(|reason| wrong(Self::TIME, reason))
    }

    /// Returns the names for functions of a system's momentum and the time, such as those of events: as
    /// [`vocabulary`](Self::vocabulary), but without the time where the system itself gives the name `t` to something else.
    ///
    /// # Errors
    /// If another name cannot be one or is there already.
    pub fn vocabulary_of_functions(
        &self,
        algebra: &SystemAlgebra,
        parameters: &Parameters,
    ) -> Result<Vocabulary, FormulaSystemError> {
        match self.vocabulary(algebra, parameters) {
            Err(OpenSystemError::TimeName) => algebra.vocabulary(parameters),
            names => Ok(names?),
        }
    }

    /// Returns the parameters with the time and the inputs as numbers, which are those of the time 0: for the system as it is
    /// then.
    ///
    /// # Errors
    /// Returns [`OpenSystemError::InputName`] for a name that cannot be one or is there already.
    pub fn frozen(&self, parameters: Parameters) -> Result<Parameters, OpenSystemError> {
        let wrong = |name: &str, reason| OpenSystemError::InputName { name: name.into(), reason };
        let timed = parameters.number(Self::TIME, 0.0).map_err(|_| OpenSystemError::TimeName)?;
        let of_tables = self.tables.iter().map(|(_, table)| {
            let first = table.breakpoints().first().copied().unwrap_or(0.0);
            table.at(first.max(0.0))
        });
        let of_orbit = self.orbit.iter().flat_map(|orbit| [orbit.rate(0.0), orbit.tide(0.0)]);
        self.names().zip(of_tables.chain(of_orbit)).try_fold(timed, |all, (name, value)| {
            all.number(name, value).map_err(|reason| wrong(name, reason))
        })
    }

    /// Checks that the tables reach from 0 to the end of a run.
    ///
    /// # Errors
    /// Returns [`OpenSystemError::Input`], which names the input and the times.
    pub fn require_until(&self, end: f64) -> Result<(), OpenSystemError> {
        let (begin, end) = (end.min(0.0), end.max(0.0));
        self.tables.iter().try_for_each(|(name, table)| {
            let refused = |reason| OpenSystemError::Input { name: name.clone(), reason };
            table.require_until(begin, end).map_err(refused)
        })
    }

    /// Appends the time and the values of the inputs to the coordinates of a momentum. A time that misses the end of a table by
    /// rounding is the end.
    pub fn append<T: Real>(&self, time: T, x: &mut impl Extend<T>) {
        x.extend([time]);
        for (_, table) in &self.tables {
            let time = time.lane_by_lane(time, |time, _| inside(table, time)) + derivative_of(time);
            x.extend([table.at(time)]);
        }
        if let Some(orbit) = &self.orbit {
            let [[rate, _], [tide, _]] = orbit.rate_and_tide(time);
            x.extend([rate, tide]);
        }
    }

    /// Returns the times of all tables, and that of the pericentre, where a satellite is fastest.
    pub fn times(&self) -> impl Iterator<Item = f64> {
        let times = self.tables.iter().flat_map(|(_, table)| table.breakpoints().iter().copied());
        times.chain(self.orbit.iter().map(KeplerOrbit::pericentre))
    }

    /// Returns the next time of a table strictly after a time, or strictly before it if `forward` is false, at which an input may
    /// jump.
    #[must_use]
    pub fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        let breaks = self.tables.iter().filter_map(|(_, table)| table.next_break(time, forward));
        match forward {
            true => breaks.reduce(f64::min),
            false => breaks.reduce(f64::max),
        }
    }
}

/// Returns the time in a table that is nearest to a time, if it misses it by rounding alone.
fn inside(table: &InputTable, time: f64) -> f64 {
    let breaks = table.breakpoints();
    let (Some(first), Some(last)) = (breaks.first(), breaks.last()) else { return time };
    let nearest = time.clamp(*first, *last);
    let rounding = 1e-9 * (last - first);
    if (nearest - time).abs() <= rounding { nearest } else { time }
}

/// Returns x − value(x): 0 with the derivative of x.
fn derivative_of<T: Real>(x: T) -> T {
    x - x.lane_by_lane(x, |x, _| x)
}
