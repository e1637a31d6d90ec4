//! A fluid on the sphere with viscosity, forces and noise: [`OpenedFluid`].

use super::array_terms::{FluidTerms, HarmonicShell};
use super::noise_paths::NoisePaths;
use super::on_path::OnPath;
use super::opened::{Opened, Opening};
use crate::arrays::any_arrays::Arrays;
use crate::arrays::fluids::fluid_start::add;
use crate::arrays::fluids::sphere_fluid::SphereFluid;
use collective_integrators::{AnyIntegrator, StageSolver, VectorField};
use core::f64::consts::PI;
use lie_poisson::{State, larger};
use lie_poisson_formula_systems::FormulaSystemError;
use lie_poisson_systems::isospectral_flows::{CommutatorField, LargeSkewHermitian};
use lie_poisson_systems::{
    HarmonicNoise, StochasticFluid, SystemError, ViscousForcing, VorticityCoefficients,
};

/// The largest power of the Laplace operator in a viscosity.
const MOST_POWER: u32 = 32;

/// A fluid by the stochastic midpoint rule of [`StochasticFluid`]: h, the enstrophy and the angular momentum.
#[derive(Debug)]
pub(in crate::arrays) struct OpenedFluid {
    fluid: SphereFluid,
    method: StochasticFluid,
    /// Whether nothing but a flow, that of the fluid or of the noise, changes the vorticity.
    is_carried: bool,
}

impl OpenedFluid {
    /// Returns the fluid with its terms, for runs with steps of a size, s.
    ///
    /// # Errors
    /// If a number is not what it must be, or viscosity would act backward in time.
    pub(in crate::arrays) fn of(fluid: &SphereFluid, terms: &FluidTerms, step: f64) -> Opening {
        let forcing = forcing(fluid, terms)?;
        if step < 0.0 && terms.viscosity > 0.0 {
            let found = terms.viscosity;
            let needed = format!("0 backward in time, where it feeds small eddies, got {found}");
            return Err(refused("viscosity", needed));
        }
        let noise = terms.noise.clone().unwrap_or_default();
        let transport = shells(fluid, "transport", &noise.transport)?;
        let stirring = shells(fluid, "stirring", &noise.stirring)?;
        let is_carried = terms.force.iter().all(|[_, _, re, im]| *re == 0.0 && *im == 0.0)
            && forcing.decay_rate(1) == 0.0
            && stirring.enstrophy_injection() == 0.0;
        let paths = NoisePaths::brownian_of(terms.noise.as_ref().map(|noise| &noise.paths), step)?;
        let method = StochasticFluid::new(forcing, paths).with_transport(transport);
        let method = method.and_then(|method| method.with_stirring(stirring));
        let method = method.map_err(|error| impossible("noise", error))?;
        Ok(Box::new(Self { fluid: fluid.clone(), method, is_carried }))
    }
}

/// Returns the error of a term that is not what it must be.
const fn refused(name: &'static str, needed: String) -> FormulaSystemError {
    FormulaSystemError::KindValue { kind: FluidTerms::KIND, name, needed }
}

fn impossible(name: &'static str, error: SystemError) -> FormulaSystemError {
    refused(name, format!("possible: {error}"))
}

fn require_not_negative(name: &'static str, value: f64) -> Result<(), FormulaSystemError> {
    match value >= 0.0 && value.is_finite() {
        true => Ok(()),
        false => Err(refused(name, format!("0 or a positive number, got {value}"))),
    }
}

/// Returns the viscosity, the drag and the force.
fn forcing(fluid: &SphereFluid, terms: &FluidTerms) -> Result<ViscousForcing, FormulaSystemError> {
    let FluidTerms { viscosity, power, drag, ref force, .. } = *terms;
    require_not_negative("viscosity", viscosity)?;
    require_not_negative("drag", drag)?;
    if !(1..=MOST_POWER).contains(&power) {
        return Err(refused(
            "power",
            format!("a whole number from 1 to {MOST_POWER}, got {power}"),
        ));
    }
    if let Some(odd) = force.as_flattened().iter().find(|number| !number.is_finite()) {
        return Err(refused("torque", format!("finite, got {odd}")));
    }
    let mut rates = VorticityCoefficients::zeros(fluid.size());
    add(&mut rates, force).map_err(|needed| refused("torque", needed))?;
    ViscousForcing::new(fluid.0.clone())
        .with_viscosity(viscosity, power)
        .and_then(|forcing| forcing.with_drag(drag))
        .and_then(|forcing| forcing.with_force(&rates))
        .map_err(|error| impossible("viscosity", error))
}

/// Returns the noise of shells.
fn shells(
    fluid: &SphereFluid,
    name: &'static str,
    shells: &[HarmonicShell],
) -> Result<HarmonicNoise, FormulaSystemError> {
    let highest = fluid.size() - 1;
    shells.iter().try_fold(HarmonicNoise::none(&fluid.0), |noise, shell| {
        let HarmonicShell { degrees: [least, most], strength } = *shell;
        if !(1..=most).contains(&least) || most > highest {
            let degrees = format!("degrees from 1 to {highest}, the least first");
            return Err(refused(name, format!("of two {degrees}, got [{least}, {most}]")));
        }
        if !(strength >= 0.0 && strength.is_finite()) {
            let needed = format!("of a strength that is 0 or positive, got {strength}");
            return Err(refused(name, needed));
        }
        noise.with_shell([least, most], strength).map_err(|error| impossible(name, error))
    })
}

impl Opened for OpenedFluid {
    fn quantities(&self) -> Vec<String> {
        self.fluid.invariant_names()
    }

    fn append(&self, _time: f64, state: &[f64], values: &mut Vec<f64>) {
        self.fluid.invariants(state, values);
    }

    /// A flow keeps the enstrophy, as all Casimirs, and that of the fluid the energy and the angular momentum, too.
    fn keeps(&self, quantity: &str) -> bool {
        let is_of_fluid = self.method.transport().enstrophy_injection() == 0.0;
        self.is_carried && (is_of_fluid || quantity == "Z")
    }

    fn rate(&self, _time: f64, state: &[f64]) -> Vec<f64> {
        let w = self.fluid.matrix(state);
        let mut rate = CommutatorField::new(&self.fluid.0).at(&w);
        rate.add_in_place(&self.method.forcing().torque(&w));
        (0..rate.dimension()).map(|i| rate.coordinate(i)).collect()
    }

    /// The larger of two angles: that of eddies, half of the vorticity of the noise, and that of the matrix, twice its
    /// stream function over ħ, above some half of which stages have no solution. Both are root mean squares.
    fn noise_angle(&self, _state: &[f64], step: f64) -> f64 {
        let noise = self.method.transport();
        let stream = (noise.enstrophy_injection() / (4.0 * PI)).sqrt();
        let of_matrix = 2.0 * stream / self.fluid.0.planck_constant();
        larger(0.5 * noise.vorticity_variance().sqrt(), of_matrix) * step.abs().sqrt()
    }

    fn integrator(&self, tolerance: f64, path: u64) -> AnyIntegrator {
        let solver = StageSolver { tolerance, ..StageSolver::default() };
        let integrator = self.method.clone().with_solver(solver);
        OnPath { integrator, path }.erased(&LargeSkewHermitian::zeros(self.fluid.size()))
    }
}
