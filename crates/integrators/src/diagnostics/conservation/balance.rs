//! Laws of balance along a run: [`Balance`].

use crate::error::IntegrationError;
use crate::integrators::trajectories::integrator::Integrator;
use lie_poisson::larger;

/// The positive nodes of Gauss's quadrature with eight nodes on [−1, 1], and their weights.
const GAUSS: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_5),
    (0.960_289_856_497_536_3, 0.101_228_536_290_376_3),
];

/// Returns the eight nodes on [0, 1], and their weights.
fn nodes() -> impl Iterator<Item = (f64, f64)> {
    let both = |(x, w): (f64, f64)| [(0.5 - 0.5 * x, 0.5 * w), (0.5 + 0.5 * x, 0.5 * w)];
    GAUSS.into_iter().flat_map(both)
}

/// The law of balance dC/dt = R(μ) of a quantity C along a run, in the unit of C.
///
/// A torque F, dμ/dt = Λ(μ) dh + F(μ, t), changes every quantity at the rate
///
/// ```text
/// dC/dt = ⟨dC, F⟩ for a Casimir,    dh/dt = ⟨F, dh⟩ for the energy,
/// ```
///
/// and a double bracket lowers the energy at the rate θ |ad∗_dh μ|². What is left, the defect, is the error of the method: of
/// order hᵖ for a method of order p, and round-off for a method that keeps the law. For R = 0 it is the deviation of a
/// conserved quantity.
///
/// # Example
/// A rigid body in a viscous fluid, F = −cΠ, loses |Π|² at the rate 2c|Π|²:
/// ```
/// use collective_integrators::diagnostics::Balance;
/// use collective_integrators::{Direct, RungeKutta, from_fn};
/// use nalgebra::Vector3;
/// let omega = |pi: &Vector3<f64>| pi.component_div(&Vector3::new(1.0, 2.0, 3.0));
/// let body = from_fn(move |pi: &Vector3<f64>| pi.cross(&omega(pi)) - pi * 0.1);
/// let run = |h, steps| {
///     let (start, body) = (Vector3::new(1.0, 0.2, 2.0), Direct::new(RungeKutta::rk4(), body));
///     Balance::of_run(&body, start, (h, steps), |pi| pi.norm_squared(), |pi| -0.2 * pi.norm_squared())
/// };
/// let (coarse, fine) = (run(0.2, 50)?, run(0.1, 100)?);
/// assert!((fine.change / fine.supplied - 1.0).abs() < 1e-5);
/// assert!(coarse.defect > 12.0 * fine.defect); // 2⁴ for a method of order 4
/// # Ok::<(), collective_integrators::IntegrationError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Balance {
    /// The change of C from the beginning of the run to its end.
    pub change: f64,
    /// The integral of R over the run.
    pub supplied: f64,
    /// The largest |C(t) − C(0) − ∫R dt| at the ends of the steps; NaN if one of them is NaN.
    pub defect: f64,
}

impl Balance {
    /// Measures the balance of C = `quantity(μ)` with R = `rate(μ)` along a run of `steps` steps of a size. For a motion that
    /// depends on time, the momenta μ contain the time.
    ///
    /// The integral over a step is Gauss's quadrature, over momenta after parts of the step. Steps should end where R jumps, as it
    /// does with the input of a table.
    ///
    /// # Errors
    /// Returns the error of a step that fails, or of a part of it.
    pub fn of_run<I: Integrator>(
        integrator: &I,
        start: I::State,
        (step, steps): (f64, u64),
        quantity: impl Fn(&I::Momentum) -> f64,
        rate: impl Fn(&I::Momentum) -> f64,
    ) -> Result<Self, IntegrationError> {
        let (quantities, rates) = (|mu: &_| vec![quantity(mu)], |mu: &_| vec![rate(mu)]);
        let whole = |_| Some(vec![1.0]);
        let found = Self::all_of_run(integrator, start, (step, steps), (quantities, rates), whole)?;
        let found = found.and_then(|all| all.first().copied());
        Ok(found.unwrap_or(Self::NONE))
    }

    /// The balance of no step.
    const NONE: Self = Self { change: 0.0, supplied: 0.0, defect: 0.0 };

    /// Measures the balances of several quantities, as [`of_run`](Self::of_run) does that of one. Before each step `smooth` is told how
    /// many have been made, and returns the ends of the parts in which the rates are smooth, as fractions of the step, of which 1 is
    /// the last; or `None` to end the measurement, which is then without a result.
    ///
    /// # Errors
    /// As [`of_run`](Self::of_run).
    pub fn all_of_run<I: Integrator>(
        integrator: &I,
        start: I::State,
        (step, steps): (f64, u64),
        (quantities, rates): (impl Fn(&I::Momentum) -> Vec<f64>, impl Fn(&I::Momentum) -> Vec<f64>),
        mut smooth: impl FnMut(u64) -> Option<Vec<f64>>,
    ) -> Result<Option<Vec<Self>>, IntegrationError> {
        let (mut workspace, mut parts) = (integrator.workspace(), integrator.workspace());
        let first = quantities(&integrator.momentum(&start));
        let (mut balances, mut state) = (vec![Self::NONE; first.len()], start);
        for made in 0..steps {
            let failed = |source| IntegrationError::after(made, step, source);
            let Some(ends) = smooth(made) else { return Ok(None) };
            let begins = core::iter::once(0.0).chain(ends.iter().copied());
            for (begin, end) in begins.zip(&ends) {
                let length = end - begin;
                for (node, weight) in nodes() {
                    integrator.forget(&mut parts);
                    let part = (begin + node * length) * step;
                    let within = integrator.step(&state, part, &mut parts).map_err(failed)?;
                    let rates = rates(&integrator.momentum(&within.point));
                    for (balance, rate) in balances.iter_mut().zip(rates) {
                        balance.supplied += step * length * weight * rate;
                    }
                }
            }
            integrator.step_in_place(&mut state, step, &mut workspace).map_err(failed)?;
            let now = quantities(&integrator.momentum(&state));
            for ((balance, now), first) in balances.iter_mut().zip(now).zip(&first) {
                balance.change = now - first;
                balance.defect = larger(balance.defect, (balance.change - balance.supplied).abs());
            }
        }
        Ok(Some(balances))
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::nodes;
    use crate::tableaux::tableau::Tableau;

    #[test]
    fn the_nodes_are_those_of_gauss() {
        let gauss = Tableau::gauss(8).unwrap();
        let expected: Vec<_> = gauss.nodes().iter().zip(gauss.weights()).collect();
        for (node, weight) in nodes() {
            let near = |(c, b): &(&f64, &f64)| (*c - node).abs() + (*b - weight).abs() < 1e-15;
            assert_eq!(expected.iter().filter(|found| near(found)).count(), 1, "{node}");
        }
    }
}
