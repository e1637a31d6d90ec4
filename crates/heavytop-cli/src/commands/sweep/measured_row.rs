//! The row of one top: the observables of its motion.

use super::sweep_plan::Plan;
use crate::Error;
use crate::configuration::Observable;
use collective_integrators::{
    Megno, Start, TangentIntegrator, VariationalError, VariationalFlow, smaller_alignment_index,
};
use heavytop::methods::TangentTask;
use heavytop::{HeavyTop, Invariant, Nutation};
use lie_poisson::{Se3Dual, Vector, larger};

/// The values of all observables of a top.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Row {
    /// The values of the columns of all observables; `None` where one has no value.
    pub values: Vec<Option<f64>>,
    /// The reason why the top has no values at all.
    pub failure: Option<String>,
}

impl Row {
    /// Returns the value in a column, if there is one.
    pub fn value(&self, column: usize) -> Option<f64> {
        self.values.get(column).copied().flatten()
    }
}

/// Follows the top with this number and measures its row, which depends on the plan and the number alone.
pub(super) fn measure(plan: &Plan, number: u64) -> Row {
    let values = plan.top(&plan.parameters(number)).and_then(|(top, start)| {
        plan.method.differentiate(&top, Follow { plan, top: &top, start: &start })?
    });
    match values {
        Ok(values) => {
            let finite = |value: Option<f64>| value.filter(|value| value.is_finite());
            Row { values: values.into_iter().map(finite).collect(), failure: None }
        }
        Err(failure) => Row {
            values: vec![None; plan.columns().count()],
            failure: Some(failure.message().replace('\n', " ")),
        },
    }
}

/// The task of following a top.
struct Follow<'a> {
    plan: &'a Plan,
    top: &'a HeavyTop,
    start: &'a Se3Dual,
}

impl TangentTask for Follow<'_> {
    type Output = Result<Vec<Option<f64>>, Error>;

    fn perform<I>(self, integrator: &I) -> Self::Output
    where
        I: Start<State: Vector, Momentum = Se3Dual> + TangentIntegrator,
    {
        // A tangent vector costs more than the state: there are as many as the observables need.
        let observables = &self.plan.observables;
        if observables.contains(&Observable::Sali) {
            self.follow::<I, 2>(integrator)
        } else if observables.contains(&Observable::Megno)
            || observables.contains(&Observable::Lyapunov)
        {
            self.follow::<I, 1>(integrator)
        } else {
            self.follow::<I, 0>(integrator)
        }
    }
}

impl Follow<'_> {
    fn follow<I, const K: usize>(&self, integrator: &I) -> Result<Vec<Option<f64>>, Error>
    where
        I: Start<State: Vector, Momentum = Se3Dual> + TangentIntegrator,
    {
        let Self { plan, start, .. } = self;
        let state = Start::<f64>::start(integrator, start)?;
        let tangents = core::array::from_fn(tangent);
        let mut flow =
            VariationalFlow::<_, K>::new(integrator, state, tangents, plan.schedule.step);
        let seen = self.run(&mut flow).map_err(|failure| match failure {
            VariationalError::Integration(source) => Error::Integration {
                formulation: plan.method.formulation().name(),
                scheme: plan.method.scheme().name(),
                source,
            },
            lost => Error::Tangent(lost),
        })?;
        Ok(plan.observables.iter().flat_map(|observable| seen.values(*observable, &flow)).collect())
    }

    /// Makes all steps of the run.
    fn run<I, const K: usize>(
        &self,
        flow: &mut VariationalFlow<'_, I, K>,
    ) -> Result<Seen, VariationalError>
    where
        I: Start<State: Vector, Momentum = Se3Dual> + TangentIntegrator,
    {
        let mut seen = Seen::new(self.top, self.start);
        // Lengths at the start do not count as stretches.
        flow.normalise()?;
        while flow.steps() < self.plan.schedule.steps {
            flow.advance()?;
            let stretches = flow.normalise()?;
            seen.observe(flow.time(), &flow.momentum(), stretches.first());
        }
        Ok(seen)
    }
}

/// Returns the tangent vector with this number; it has no symmetry, by Weyl's sequence.
fn tangent<V: Vector<Scalar = f64>>(number: usize) -> V {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    V::from_coordinates(|i| ((number * V::DIM + i + 1) as f64 * GOLDEN).fract() - 0.5)
}

/// The quantities that are accumulated along a motion.
struct Seen {
    top: HeavyTop,
    initial: [f64; 3],
    drift: [f64; 3],
    nutation: Nutation,
    megno: Megno,
    /// The sum `Σ ln(δ_k/δ_{k−1})` of the growth of tangent vectors.
    growth: f64,
}

const CONSERVED: [Invariant; 3] =
    [Invariant::Energy, Invariant::VerticalSquared, Invariant::VerticalMomentum];

impl Seen {
    fn new(top: &HeavyTop, start: &Se3Dual) -> Self {
        let mut nutation = Nutation::new(top);
        nutation.observe(0.0, start);
        let initial = CONSERVED.map(|invariant| invariant.value(top, start));
        Self { top: *top, initial, drift: [0.0; 3], nutation, megno: Megno::default(), growth: 0.0 }
    }

    fn observe(&mut self, time: f64, mu: &Se3Dual, stretch: Option<&f64>) {
        self.nutation.observe(time, mu);
        for ((drift, initial), invariant) in self.drift.iter_mut().zip(self.initial).zip(CONSERVED)
        {
            *drift = larger(*drift, (invariant.value(&self.top, mu) - initial).abs());
        }
        if let Some(stretch) = stretch {
            self.megno.observe(*stretch);
            self.growth += stretch.ln();
        }
    }

    fn values<I, const K: usize>(
        &self,
        observable: Observable,
        flow: &VariationalFlow<'_, I, K>,
    ) -> Vec<Option<f64>>
    where
        I: Start<State: Vector, Momentum = Se3Dual> + TangentIntegrator,
    {
        match observable {
            Observable::FinalState => {
                let mu = flow.momentum();
                (0..6).map(|i| Some(mu.coordinate(i))).collect()
            }
            Observable::InvariantDrift => self.drift.map(Some).to_vec(),
            Observable::Lyapunov => vec![Some(self.growth / flow.time())],
            Observable::Megno => vec![Some(self.megno.mean())],
            Observable::Sali => vec![flow.tangents().first_chunk().map(smaller_alignment_index)],
            Observable::RotationNumber => vec![self.nutation.rotation_number()],
            Observable::NutationAmplitude => vec![self.nutation.amplitude()],
        }
    }
}
