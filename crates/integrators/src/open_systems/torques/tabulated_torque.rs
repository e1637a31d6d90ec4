//! Torques that follow tables of inputs: [`TabulatedTorque`].

use crate::error::StepError;
use crate::open_systems::torqued::TorqueFlow;
use lie_poisson::{InputTable, Inputs, Pair, Real, State, Time};

/// The torque F(t) = Σ uᵢ(t) fᵢ of [inputs](Inputs) uᵢ along fixed torques fᵢ, for momenta (μ, t) with the time.
///
/// The inputs are [tables](InputTable), held, linear or by splines. While the torque acts, the time is frozen, so that its flow
/// is μ ↦ μ + hF(t). [`Torqued`](crate::Torqued) divides its steps at the times of the tables, where an input or a
/// derivative of it jumps, and sees in each part the polynomials of that part alone.
///
/// The torques have the type `D` over the numbers `f64`, and as many coordinates as μ. Outside a table the torque is NaN, so that
/// a step there fails with [`StepError::NotFinite`]; [`Inputs::require_until`] tells before a run.
///
/// # Example
/// A thruster that burns along e₁ from t = 1 to t = 3 gives the momentum 2 · 0.4, to a body that does not turn otherwise:
/// ```
/// use collective_integrators::{Driven, RungeKutta, Start, TabulatedTorque, Torqued};
/// use lie_poisson::{
///     Autonomous, Covector, InputTable, Inputs, Interpolation, LiePoisson, Pair, So3, Time, from_closure,
/// };
/// use momentum_map::HOPF;
/// use nalgebra::Vector3;
/// let ball = from_closure::<LiePoisson<So3>, _>(|Covector(pi)| pi.dot(pi) * 0.5);
/// let burns = InputTable::new(vec![0.0, 1.0, 3.0, 4.0], vec![0.0, 0.4, 0.0, 0.0], Interpolation::Constant)?;
/// let thruster = Inputs::new(vec![(Covector(Vector3::<f64>::x()), burns)])?;
/// assert!(thruster.require_until(0.0, 5.0).is_err());
/// let orbits = Driven::new(RungeKutta::implicit_midpoint(), HOPF, Autonomous(ball));
/// let start = Pair(Covector(Vector3::z()), Time(0.0));
/// let end = Torqued::new(orbits, TabulatedTorque(thruster)).after(&start, 4.0 / 7.0, 7)?.momentum.0.0;
/// assert!((end - Vector3::new(0.8, 0.0, 1.0)).norm() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct TabulatedTorque<D>(pub Inputs<D>);

impl<D: State<Scalar = f64>> TabulatedTorque<D> {
    /// Adds h Σ uᵢ fᵢ, with the inputs as a function of their tables.
    fn add<V: State>(
        &self,
        mu: &mut V,
        step: f64,
        input: impl Fn(&InputTable) -> V::Scalar,
    ) -> Result<(), StepError> {
        for (torque, table) in self.0.iter() {
            StepError::check_dimension(mu, torque.dimension())?;
            let impulse = input(table) * V::Scalar::from_f64(step);
            for i in 0..mu.dimension() {
                let change = impulse * V::Scalar::from_f64(torque.coordinate(i));
                mu.set_coordinate(i, mu.coordinate(i) + change);
            }
        }
        Ok(())
    }
}

impl<D, V, T> TorqueFlow<Pair<V, Time<T>>> for TabulatedTorque<D>
where
    D: State<Scalar = f64>,
    V: State<Scalar = T>,
    T: Real,
    Pair<V, Time<T>>: State<Scalar = T>,
{
    /// Adds hF(t).
    ///
    /// # Errors
    /// Returns [`StepError::Dimension`] if μ has not as many coordinates as a torque.
    fn flow(&self, Pair(mu, time): &mut Pair<V, Time<T>>, step: f64) -> Result<(), StepError> {
        self.add(mu, step, |table| table.at(time.0))
    }

    fn time(&self, Pair(_, time): &Pair<V, Time<T>>) -> Option<T> {
        Some(time.0)
    }

    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        self.0.next_break(time, forward)
    }

    /// Adds hF(t), with each input by the polynomial of the interval in which the time `inside` lies.
    ///
    /// # Errors
    /// Returns [`StepError::Dimension`] if μ has not as many coordinates as a torque.
    fn flow_near(
        &self,
        Pair(mu, time): &mut Pair<V, Time<T>>,
        step: f64,
        inside: T,
    ) -> Result<(), StepError> {
        self.add(mu, step, |table| table.continued(inside, time.0))
    }
}
