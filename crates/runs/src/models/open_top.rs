//! The model of a top that is driven, damped, noisy or forced: [`OpenTop`].

use super::conserved::Conserved;
use super::model::Model;
use crate::error::RunFailure;
use collective_integrators::diagnostics::SystemScales;
use collective_integrators::{AnyIntegrator, AnyTangents};
use core::ops::Range;
use heavytop::attitude_of_vertical;
use heavytop::methods::Method;
use lie_poisson::Quaternion;
use lie_poisson_formula_systems::OpenSystem;
use nalgebra::Vector3;

/// The energy and the Casimirs of a top, in the order of tops.
struct Quantities<'a>(&'a OpenSystem);

impl Conserved for Quantities<'_> {
    fn names(&self) -> Vec<String> {
        ["h", "f1", "f2"].map(String::from).to_vec()
    }

    fn is_kept(&self, name: &str) -> bool {
        match name {
            "h" => self.0.keeps_energy(),
            // A torque turns the body, and the vertical is a direction whatever the body does.
            "f1" => true,
            _ => self.0.keeps_casimirs(),
        }
    }

    fn append(&self, time: f64, momentum: &[f64], values: &mut Vec<f64>) {
        let (pi, gamma) = momentum.split_at_checked(3).unwrap_or_default();
        values.extend([self.0.energy(momentum, time), dot(gamma, gamma), dot(pi, gamma)]);
    }

    fn without_value(&self, time: f64, momentum: &[f64]) -> String {
        format!("a conserved quantity has no finite value; h is {}", self.0.energy(momentum, time))
    }
}

fn dot(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| x * y).sum()
}

/// A rigid body about a support as an open system on se(3)∗, in the axes of the users. Its conserved quantities have the names of
/// those of tops, h, f1 = |Γ|² and f2 = Π·Γ.
#[derive(Clone, Debug, PartialEq)]
pub struct OpenTop {
    /// The system, whose algebra is `se(3)` with the coordinates Π and Γ.
    pub system: OpenSystem,
    /// The attitude at the start; `None` for the shortest rotation of Γ to the vertical.
    pub initial_attitude: Option<Quaternion>,
}

impl SystemScales for OpenTop {
    fn blocks(&self) -> Vec<Range<usize>> {
        self.system.blocks()
    }

    fn differential(&self, mu: &[f64]) -> Vec<f64> {
        self.system.differential(mu)
    }

    fn fastest_rate(&self, mu: &[f64]) -> f64 {
        self.system.fastest_rate(mu)
    }
}

impl Model for OpenTop {
    fn algebra_name(&self) -> String {
        self.system.algebra_name()
    }

    fn coordinates(&self) -> Vec<(String, Vec<String>)> {
        self.system.coordinates()
    }

    fn conserved(&self, _start: &[f64]) -> Box<dyn Conserved + '_> {
        Box::new(Quantities(&self.system))
    }

    fn tangent_integrator(
        &self,
        method: &Method,
        start: &[f64],
    ) -> Result<AnyIntegrator<dyn AnyTangents>, RunFailure> {
        Model::tangent_integrator(&self.system, method, start)
    }

    fn integrator_with_attitude(
        &self,
        method: &Method,
        start: &[f64],
    ) -> Result<AnyIntegrator, RunFailure> {
        let attitude = self.initial_attitude.unwrap_or_else(|| {
            let gamma = |i: usize| start.get(3 + i).copied().unwrap_or(f64::NAN);
            attitude_of_vertical(&Vector3::from_fn(|i, _| gamma(i)))
        });
        Ok(self.system.integrator_with_attitude(method, start, attitude)?)
    }

    fn order(&self, method: &Method) -> u16 {
        self.system.order(method)
    }

    fn noise_angle(&self, start: &[f64], step: f64) -> Option<f64> {
        self.system.noise_angle(start, step)
    }

    fn move_path(&self, state: &mut [f64], on: u64) {
        self.system.move_path(state, on);
    }

    fn noise(&self) -> Option<(u64, u64)> {
        self.system.noise()
    }

    fn append_inputs(&self, time: f64, x: &mut Vec<f64>) {
        self.system.append_inputs(time, x);
    }

    fn supplied_rates(&self, time: f64, momentum: &[f64]) -> Option<Vec<f64>> {
        let energy = *Model::supplied_rates(&self.system, time, momentum)?.first()?;
        let rate = self.system.rate(momentum, time).ok()?;
        let ((pi, gamma), (torque, turning)) =
            (momentum.split_at_checked(3)?, rate.split_at_checked(3)?);
        Some(vec![energy, 2.0 * dot(gamma, turning), dot(torque, gamma) + dot(pi, turning)])
    }

    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        self.system.next_break(time, forward)
    }

    fn descends(&self, method: &Method, _start: &[f64]) -> Result<bool, RunFailure> {
        Ok(self.system.descends(method)?)
    }
}
