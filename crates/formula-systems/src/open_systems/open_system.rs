//! A system by formula that is open: [`OpenSystem`].

use super::open_terms::OpenTerms;
use crate::casimirs::casimir::{Casimir, ScalarFunction};
use crate::error::FormulaSystemError;
use crate::open_system_error::OpenSystemError;
use crate::realisations::generic_point::generic;
use crate::systems::formula_system::FormulaSystem;
use collective_integrators::BrownianPaths;
use lie_poisson::DualNumber;
use lie_poisson_formulas::Formula;

/// A Lie–Poisson system that is driven, damped, noisy or forced, as its [`OpenTerms`] say.
///
/// Without a torque each motion stays on its coadjoint orbit: the Casimirs are conserved, to round-off by the collective
/// formulation; h is not. A torque changes the Casimirs, too, and is for the direct formulation.
///
/// # Example
/// A spin in a field along e₃ that is damped, dΠ/dt = Π × Ω + ½ Π × (Π × Ω) with h = −Π₃, turns towards e₃; and the same one at a
/// temperature.
/// ```
/// use collective_integrators::{AnyState, NoiseRule, Start};
/// use lie_poisson::InnerProduct;
/// use lie_poisson_formula_systems::{Damping, FormulaSystem, NoiseFields, NoiseTerms, OpenSystem, OpenTerms, SystemAlgebra};
/// use lie_poisson_formulas::Parameters;
///
/// let spin = FormulaSystem::new(SystemAlgebra::named("so(3)")?, "-Pi3", &Parameters::new())?.with_found_casimirs()?;
/// let damping = Some(Damping::DoubleBracket { friction: 0.5, inner_product: InnerProduct::euclidean() });
/// let terms = OpenTerms { damping, ..OpenTerms::default() };
/// let damped = OpenSystem::new(spin.clone(), terms.clone(), 0.1)?;
/// let start = [1.0, 0.0, 0.0];
/// let method = damped.method("collective".parse()?, "gauss-8".parse()?, 0.0)?;
/// let end = damped.tangent_integrator(&method, &start)?.after(&AnyState::from_slice(&start), 0.1, 100)?.momentum;
/// assert!((end.as_slice()[2] - 5.0_f64.tanh()).abs() < 1e-9); // tanh(t/2)
///
/// let fields = NoiseFields::thermal(terms.damping.as_ref(), 2.0)?; // kT = 2
/// let noise = Some(NoiseTerms { fields, seed: 1, path: 0, rule: NoiseRule::Together, interval: None, bound: None });
/// let warm = OpenSystem::new(spin, OpenTerms { noise, ..terms }, 0.1)?;
/// let end = warm.tangent_integrator(&method, &start)?.after(&AnyState::from_slice(&start), 0.1, 100)?.momentum;
/// let length: f64 = end.as_slice().iter().map(|x| x * x).sum();
/// assert!((length - 1.0).abs() < 1e-13);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct OpenSystem {
    base: FormulaSystem,
    terms: OpenTerms,
    interval: f64,
    /// The paths of the noise, if there is noise.
    paths: Option<BrownianPaths>,
}

impl OpenSystem {
    /// Creates the open system of an algebra with its Casimirs. The Hamiltonian is that of the terms, or, if they have none,
    /// that of `base`. The step is that of runs.
    ///
    /// # Errors
    /// Returns [`OpenSystemError`] if the terms do not fit the algebra, and for steps below 0 at a temperature, which has no way back:
    /// friction with noise in its inner product.
    pub fn new(base: FormulaSystem, terms: OpenTerms, step: f64) -> Result<Self, OpenSystemError> {
        terms.require_sane(base.algebra())?;
        if let Some(friction) = terms.thermal_friction() {
            OpenSystemError::require_forward(friction, step)?;
        }
        // Runs backward count the same intervals.
        let of_noise = terms.noise.as_ref().and_then(|noise| noise.interval);
        let interval = of_noise.unwrap_or(step.abs());
        let paths = match &terms.noise {
            None => None,
            Some(noise) => {
                let (path, least) = (noise.path, step.abs() / Self::MOST_INTERVALS);
                if path >= Self::PATHS {
                    return Err(OpenSystemError::PathNumber { path, most: Self::PATHS });
                }
                if interval < least {
                    return Err(OpenSystemError::ShortInterval { interval, least });
                }
                let paths = BrownianPaths::new(noise.seed, interval)?;
                Some(match noise.bound {
                    None => paths,
                    Some(bound) => paths.with_bound(bound)?,
                })
            }
        };
        Ok(Self { base, terms, interval, paths })
    }

    /// Returns the algebra with its Casimirs, and the Hamiltonian as it is at the time 0.
    #[must_use]
    pub const fn base(&self) -> &FormulaSystem {
        &self.base
    }

    /// Returns what makes the system an open one.
    #[must_use]
    pub const fn terms(&self) -> &OpenTerms {
        &self.terms
    }

    /// The number of paths of a noise that are told apart, by a coordinate of the state.
    pub const PATHS: u64 = 1 << 53;

    /// The most intervals of a noise in a step, each of which has random numbers of its own.
    pub const MOST_INTERVALS: f64 = 1e4;

    /// Returns the system with the path of another number, which must be below [`PATHS`](Self::PATHS).
    #[must_use]
    pub fn on_path(self, path: u64) -> Self {
        let noise = self.terms.noise.map(|noise| super::open_terms::NoiseTerms { path, ..noise });
        Self { terms: OpenTerms { noise, ..self.terms }, ..self }
    }

    pub(super) const fn interval(&self) -> f64 {
        self.interval
    }

    pub(super) const fn paths(&self) -> Option<&BrownianPaths> {
        self.paths.as_ref()
    }

    /// Returns h(μ, t). It is NaN for a momentum of another dimension, and where an input has no value.
    #[must_use]
    pub fn energy(&self, mu: &[f64], time: f64) -> f64 {
        let Some(hamiltonian) = &self.terms.hamiltonian else {
            return self.base.hamiltonian().value_of(mu.len(), |i| mu[i]);
        };
        let mut x = mu.to_vec();
        self.terms.inputs.append(time, &mut x);
        hamiltonian.value_at(&x)
    }

    /// Returns whether a function of the coordinates, the time and the inputs depends on no coordinate. A path with noise passes any
    /// other function again and again in a time however short.
    ///
    /// # Example
    /// ```
    /// use lie_poisson_formula_systems::{FormulaSystem, NamedInputs, OpenSystem, OpenTerms, SystemAlgebra};
    /// use lie_poisson_formulas::{Formula, Parameters};
    /// let (so3, none) = (SystemAlgebra::named("so(3)")?, Parameters::new());
    /// let names = NamedInputs::default().vocabulary(&so3, &none)?;
    /// let spin = OpenSystem::new(FormulaSystem::new(so3, "Pi3", &none)?, OpenTerms::default(), 0.1)?;
    /// let [phase, height] = ["sin(2*t) + 0*Pi1", "if(Pi3 > 0, 1, 2)*t"].map(|text| Formula::new(text, &names));
    /// assert!(spin.is_of_time(&phase?) && !spin.is_of_time(&height?));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn is_of_time(&self, function: &Formula) -> bool {
        !(0..self.base.algebra().dimension()).any(|i| function.depends_on(i))
    }

    /// Returns the rates at which a motion without noise changes h and the Casimirs in their order, ⟨dC, dμ/dt⟩ and for h also ∂h/∂t: what
    /// the drive, the friction, the torque and the time in h supply.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::StateLength`] if the length of the momentum is not the dimension.
    pub fn supplied_rates(&self, mu: &[f64], time: f64) -> Result<Vec<f64>, FormulaSystemError> {
        let rate = self.rate(mu, time)?;
        let along = mu.iter().zip(&rate).map(|(mu, rate)| DualNumber::new(*mu, *rate));
        let mut x: Vec<DualNumber> = along.collect();
        let energy = match &self.terms.hamiltonian {
            Some(hamiltonian) => {
                self.terms.inputs.append(DualNumber::new(time, 1.0), &mut x);
                hamiltonian.value_of(x.len(), |i| x[i])
            }
            None => self.base.hamiltonian().value_of(x.len(), |i| x[i]),
        };
        let of_casimir = |casimir: &dyn ScalarFunction| {
            casimir.differential_at(mu).iter().zip(&rate).map(|(slope, rate)| slope * rate).sum()
        };
        let casimirs = self.base.conserved_functions().skip(1).map(of_casimir);
        Ok([energy.derivative()].into_iter().chain(casimirs).collect())
    }

    /// Returns the first time after a time, or before it, at which an input is not smooth.
    #[must_use]
    pub fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        self.terms.inputs.next_break(time, forward)
    }

    /// Returns whether h is constant along the motion.
    #[must_use]
    pub const fn keeps_energy(&self) -> bool {
        let OpenTerms { hamiltonian, drive, damping, noise, torque, .. } = &self.terms;
        hamiltonian.is_none()
            && drive.is_none()
            && damping.is_none()
            && noise.is_none()
            && torque.is_none()
    }

    /// Returns whether a Casimir is constant along the motion: without a torque, or if the torque is 0 in all coordinates on which the
    /// Casimir depends, such as that of the motors of wheels for |Π|².
    #[must_use]
    pub fn keeps_casimir(&self, casimir: &Casimir) -> bool {
        let Some(torque) = &self.terms.torque else { return true };
        let is_zero = |torque: &Formula| {
            torque.linear_form().is_some_and(|slopes| slopes.iter().all(|slope| *slope == 0.0))
        };
        let acts: Vec<bool> = torque.iter().map(|torque| !is_zero(torque)).collect();
        // At points in general a polynomial has the derivative 0 along the coordinates that it does not have.
        (0..2).all(|sample| {
            let at = generic(acts.len(), sample);
            let slopes = casimir.differential_at(at.as_slice());
            acts.iter().zip(slopes).all(|(acts, slope)| !acts || slope == 0.0)
        })
    }

    /// Returns whether all Casimirs are constant along the motion, whatever they are.
    #[must_use]
    pub const fn keeps_casimirs(&self) -> bool {
        self.terms.torque.is_none()
    }
}
