//! The measurement of a motion, whatever its integrator.

use super::course::Course;
use crate::Error;
use crate::configuration::Observable;
use collective_integrators::{
    Integrator, Megno, Start, TangentIntegrator, VariationalError, VariationalFlow,
    smaller_alignment_index,
};
use heavytop::methods::{Formulation, SchemeName};
use lie_poisson::Vector;

/// The measurements along a motion, besides those of its tangent vectors.
pub(super) trait Gauge<M> {
    /// Takes notice of the momentum after a step, at a time (s).
    fn observe(&mut self, time: f64, momentum: &M);

    /// Returns the values of the columns of an observable that needs no tangent vectors, at the end of the motion.
    fn values(&self, observable: Observable, end: &M) -> Vec<Option<f64>>;
}

/// Follows the motion from a start, and returns the values of the columns of all observables. `method` is the one of the
/// integrator; coordinates from `dimension` on are none of the system.
///
/// # Errors
/// If no state represents the start, or the motion cannot be followed to the end.
pub(super) fn measure<I, G>(
    integrator: &I,
    (start, dimension): (&<I as Integrator>::Momentum, usize),
    gauge: G,
    course: &Course,
    (formulation, scheme): (Formulation, SchemeName),
) -> Result<Vec<Option<f64>>, Error>
where
    I: Start<State: Vector, Momentum: Vector<Scalar = f64>> + TangentIntegrator,
    G: Gauge<<I as Integrator>::Momentum>,
{
    let state = Start::<f64>::start(integrator, start)?;
    // A tangent vector costs more than the state: there are as many as the observables need.
    let measured = match course.tangents() {
        2 => follow::<I, G, 2>(integrator, (state, dimension), gauge, course),
        1 => follow::<I, G, 1>(integrator, (state, dimension), gauge, course),
        _ => follow::<I, G, 0>(integrator, (state, dimension), gauge, course),
    };
    measured.map_err(|failure| match failure {
        VariationalError::Integration(source) => {
            Error::Integration { formulation: formulation.name(), scheme: scheme.name(), source }
        }
        lost => Error::Tangent(lost),
    })
}

/// Makes all steps of a motion with K tangent vectors.
fn follow<I, G, const K: usize>(
    integrator: &I,
    (state, dimension): (<I as Integrator>::State, usize),
    mut gauge: G,
    course: &Course,
) -> Result<Vec<Option<f64>>, VariationalError>
where
    I: Start<State: Vector, Momentum: Vector<Scalar = f64>> + TangentIntegrator,
    G: Gauge<<I as Integrator>::Momentum>,
{
    let (dimension, step) = (tangent_dimension::<I>(dimension), course.schedule.step);
    let mut flow = VariationalFlow::<_, K>::generic(integrator, state, dimension, step);
    // Sums of ln(δ_k/δ_{k−1}) over the growth δ of the first tangent vector.
    let (mut megno, mut growth) = (Megno::default(), 0.0);
    // Lengths at the start do not count as stretches.
    flow.normalise()?;
    while flow.steps() < course.schedule.steps {
        flow.advance()?;
        let stretches = flow.normalise()?;
        gauge.observe(flow.time(), &flow.momentum());
        if let Some(stretch) = stretches.first() {
            megno.observe(*stretch);
            growth += stretch.ln();
        }
    }
    let end = flow.momentum();
    let growths = Growths {
        lyapunov: growth / flow.time().abs(),
        megno: megno.mean(),
        alignment: flow.directions()?.first_chunk().map(smaller_alignment_index),
    };
    Ok(growths.columns(&course.observables, &|observable| gauge.values(observable, &end)))
}

/// How tangent vectors have grown, at the end of a motion.
struct Growths {
    lyapunov: f64,
    megno: f64,
    /// The smaller alignment index, of two tangent vectors or more.
    alignment: Option<f64>,
}

impl Growths {
    /// Returns the values of the columns of all observables; `others` has those that need no tangent vectors.
    ///
    /// This is apart from [`follow`] so that it is compiled once, and not for every integrator.
    fn columns(
        &self,
        observables: &[Observable],
        others: &dyn Fn(Observable) -> Vec<Option<f64>>,
    ) -> Vec<Option<f64>> {
        let values = |observable: &Observable| match observable {
            Observable::Lyapunov => vec![Some(self.lyapunov)],
            Observable::Megno => vec![Some(self.megno)],
            Observable::Sali => vec![self.alignment],
            other => others(*other),
        };
        observables.iter().flat_map(values).collect()
    }
}

/// Returns the number of coordinates in which tangent vectors differ from zero. Where states are momenta, those that
/// complete the system stay zero.
fn tangent_dimension<I>(dimension: usize) -> usize
where
    I: Integrator<State: Vector<Scalar = f64>, Momentum: Vector>,
{
    let width = <<I as Integrator>::State as Vector>::DIM;
    let are_momenta = width == <<I as Integrator>::Momentum as Vector>::DIM;
    if are_momenta { dimension } else { width }
}

#[cfg(test)]
mod tests {
    use super::*;
    use collective_integrators::{Collective, LiftFree, RungeKutta};
    use heavytop::{HeavyTop, SpinorRealisation};
    use momentum_map::DualQuaternions;

    #[test]
    fn tangent_vectors_are_zero_along_what_completes_a_system() {
        type Free = LiftFree<RungeKutta, DualQuaternions, HeavyTop>;
        type Lifted = Collective<RungeKutta, SpinorRealisation, HeavyTop>;
        assert_eq!(tangent_dimension::<Free>(4), 4);
        // Control: a point of T*C² has no such coordinates.
        assert_eq!(tangent_dimension::<Lifted>(4), 8);
    }
}
