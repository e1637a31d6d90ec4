//! A motion that is followed with tangent vectors: [`TangentGrowth`].

use super::schedule::Schedule;
use crate::error::RunFailure;
use crate::models::model::Model;
use collective_integrators::{
    AnyIntegrator, AnyState, AnyTangents, Megno, Start, VariationalError, VariationalFlow,
    smaller_alignment_index,
};
use heavytop::methods::Method;
use lie_poisson::State;

/// The end of a motion, and how its tangent vectors have grown.
#[derive(Clone, Debug, PartialEq)]
pub struct TangentGrowth {
    /// The momentum at the end.
    pub end: AnyState,
    /// The growth rate ln(δ(t)/δ(0))/|t| of the first tangent vector, 1/s; 0 without tangent vectors or steps.
    pub lyapunov: f64,
    /// The [mean of MEGNO](Megno::mean), the mean exponential growth of nearby orbits, of the first tangent vector. It tends
    /// to 2 for regular motions and grows with time for chaotic ones.
    pub megno: f64,
    /// The [smaller alignment index](smaller_alignment_index) of two tangent vectors.
    pub alignment: Option<f64>,
}

impl TangentGrowth {
    /// Follows a motion of a model by a method, with so many tangent vectors. Without any it makes the steps of a run, of the
    /// fastest integrator; steps with tangent vectors differ from these by rounding errors.
    ///
    /// # Errors
    /// If the model has no such integrator, and those of [`follow`](Self::follow).
    pub fn of_model(
        model: &dyn Model,
        (method, start): (&Method, &[f64]),
        schedule: Schedule,
        tangents: usize,
        observe: &mut dyn FnMut(f64, &[f64]),
    ) -> Result<Self, RunFailure> {
        let from = AnyState::from_slice(start);
        if tangents > 0 {
            let integrator = model.tangent_integrator(method, start)?;
            return Self::follow(&integrator, &from, schedule, (tangents, method), observe);
        }
        let Schedule { step, steps } = schedule;
        let integrator = model.integrator(method, start)?;
        let mut end = from.clone();
        let run = integrator.trajectory(&from, step)?.skip(1);
        for sample in run.take(usize::try_from(steps).unwrap_or(usize::MAX)) {
            let sample = sample.map_err(|error| RunFailure::of_step(method, error))?;
            observe(sample.time, sample.momentum.as_slice());
            end = sample.momentum;
        }
        Ok(Self { end, lyapunov: 0.0, megno: 0.0, alignment: None })
    }

    /// Follows a motion with 0, 1 or 2 tangent vectors; more than 2 count as 2. `observe` takes notice of the time (s) and
    /// of the momentum after each step. `method` is that of the integrator.
    ///
    /// # Errors
    /// If no state represents the start, a step fails, or the tangent vectors lose their directions.
    ///
    /// # Example
    /// A free rigid body about its middle axis: a rotation there is unstable, and its neighbours leave it at the rate
    /// √((1 − ½)(½ − ⅓)) Π₂:
    /// ```
    /// use collective_integrators::AnyState;
    /// use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra};
    /// use lie_poisson_runs::{Schedule, TangentGrowth};
    /// let algebra = SystemAlgebra::named("so(3)")?;
    /// let method = algebra.method("direct".parse()?, "gauss-8".parse()?, 0.0)?;
    /// let body = FormulaSystem::new(algebra, "(Pi1^2 + Pi2^2/2 + Pi3^2/3)/2", &Default::default())?;
    /// let start = [0.0, 1.0, 0.0];
    /// let integrator = body.tangent_integrator(&method, &start)?;
    /// let (from, schedule) = (AnyState::from_slice(&start), Schedule::new(0.1, 100.0)?);
    /// let grown = TangentGrowth::follow(&integrator, &from, schedule, (1, &method), &mut |_, _| ())?;
    /// assert!((grown.lyapunov - (1.0_f64 / 12.0).sqrt()).abs() < 0.01);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn follow(
        integrator: &AnyIntegrator<dyn AnyTangents>,
        start: &AnyState,
        schedule: Schedule,
        (tangents, method): (usize, &Method),
        observe: &mut dyn FnMut(f64, &[f64]),
    ) -> Result<Self, RunFailure> {
        let state = integrator.start(start)?;
        // Tangent vectors are zero along coordinates that complete a space of momenta to the width of its type.
        let width = integrator.tangent_dimension();
        let dimension = if integrator.states_are_momenta() { start.dimension() } else { width };
        let follow = match tangents {
            0 => follow::<0>,
            1 => follow::<1>,
            _ => follow::<2>,
        };
        follow(integrator, (state, dimension), schedule, observe).map_err(|failure| match failure {
            VariationalError::Integration(source) => RunFailure::of_step(method, source),
            lost => RunFailure::Tangent(lost),
        })
    }
}

/// Makes all steps of a motion with K tangent vectors.
fn follow<const K: usize>(
    integrator: &AnyIntegrator<dyn AnyTangents>,
    (state, dimension): (AnyState, usize),
    Schedule { step, steps }: Schedule,
    observe: &mut dyn FnMut(f64, &[f64]),
) -> Result<TangentGrowth, VariationalError> {
    let mut flow = VariationalFlow::<_, K>::generic(integrator, state, dimension, step);
    // Sums of ln(δ_k/δ_{k−1}) over the growth δ of the first tangent vector.
    let (mut megno, mut growth) = (Megno::default(), 0.0);
    // Lengths at the start do not count as stretches.
    flow.normalise()?;
    while flow.steps() < steps {
        flow.advance()?;
        let stretches = flow.normalise()?;
        observe(flow.time(), flow.momentum().as_slice());
        if let Some(stretch) = stretches.first() {
            megno.observe(*stretch);
            growth += stretch.ln();
        }
    }
    let elapsed = flow.time().abs();
    Ok(TangentGrowth {
        end: flow.momentum(),
        lyapunov: if elapsed > 0.0 { growth / elapsed } else { 0.0 },
        megno: megno.mean(),
        alignment: flow.directions()?.first_chunk().map(smaller_alignment_index),
    })
}
