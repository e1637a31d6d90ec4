//! Lyapunov exponents of a trajectory.

use crate::chaos::tangent_integrator::{TangentIntegrator, VariationalError};
use crate::chaos::tangents::variational_flow::VariationalFlow;
use crate::integrators::trajectories::integrator::Integrator;
use lie_poisson::State;

/// The first K Lyapunov exponents of a trajectory up to the time t. In the limit they are in decreasing order:
///
/// ```text
/// λ_i(t) = (1/|t − t₀|) Σ ln r_ii
/// ```
///
/// The sum runs over the steps from t₀ on. The stretch r_ii is the length of the component of the i-th tangent vector
/// orthogonal to the preceding vectors. Lengths and angles are those of [`VariationalFlow::orthonormalise`], which do
/// not depend on units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exponents<S, const K: usize> {
    /// The number of steps made.
    pub step: u64,
    /// The time t, which is `step` times the step size.
    pub time: f64,
    /// The state z(t) of the trajectory.
    pub state: S,
    /// The exponents λ_i(t), per unit of time.
    pub exponents: [f64; K],
}

/// The Lyapunov exponents of a trajectory as an endless iterator, with one item per step.
///
/// Select items by `nth`, `step_by` and `take`. Once a step fails, every further item is the same error, as in a
/// [`Trajectory`](crate::Trajectory).
///
/// The exponents are those of the discrete map, divided by |h|. For a [`Collective`](crate::Collective) integrator the
/// map is that of P, so that the exponents along the fibres are among them. They converge slowly, at best as 1/t. For an integrable
/// system they tend to zero as (ln t)/t. With DIM exponents their sum is ln |det DΦ_t|/|t|, where Φ_t is the map over the
/// whole time t. The sum is zero for a
/// Poisson integrator that conserves the Casimirs of a unimodular 𝔤∗, such as so(3)∗ or se(3)∗. For negative steps, the
/// exponents are those of the reversed motion. For small states the iterator allocates nothing after its creation; for
/// states on the heap it allocates the states of its items.
///
/// Source: G. Benettin, L. Galgani, A. Giorgilli & J.-M. Strelcyn, *Lyapunov characteristic
/// exponents for smooth dynamical systems and for Hamiltonian systems; a method for computing all
/// of them*, Meccanica 15 (1980).
///
/// # Example
/// A saddle ẋ = x, ẏ = −2y:
/// ```
/// use collective_integrators::{Direct, LyapunovExponents, RungeKutta, VectorField};
/// use lie_poisson::Real;
/// use nalgebra::Vector2;
/// struct Saddle;
/// impl<T: Real> VectorField<T> for Saddle {
///     type Point = Vector2<T>;
///     fn at(&self, z: &Vector2<T>) -> Vector2<T> {
///         Vector2::new(z.x, z.y * -2.0)
///     }
/// }
/// let rk4 = Direct::new(RungeKutta::rk4(), Saddle);
/// let mut spectrum = LyapunovExponents::<_, 2>::new(&rk4, Vector2::new(1e-3, 1.0), 0.01);
/// if let Some(last) = spectrum.nth(499) {
///     let [first, second] = last?.exponents;
///     assert!((first - 1.0).abs() < 1e-8 && (second + 2.0).abs() < 1e-8);
/// }
/// # Ok::<(), collective_integrators::VariationalError>(())
/// ```
pub struct LyapunovExponents<'a, I, const K: usize>
where
    I: TangentIntegrator,
{
    flow: VariationalFlow<'a, I, K>,
    start: u64,
    sums: [f64; K],
    upcoming: NextStretch,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum NextStretch {
    First,
    Next,
    Failed(VariationalError),
}

/// The iterator for the largest Lyapunov exponent: [`LyapunovExponents`] with one tangent vector.
pub type MaximalLyapunovExponent<'a, I> = LyapunovExponents<'a, I, 1>;

impl<'a, I, const K: usize> LyapunovExponents<'a, I, K>
where
    I: TangentIntegrator,
{
    /// Starts at a state, with the first K basis vectors as tangent vectors.
    ///
    /// If the basis vectors are special directions of the system, choose others with [`from_flow`](Self::from_flow).
    pub fn new(integrator: &'a I, state: <I as Integrator>::State, step: f64) -> Self {
        let tangents = core::array::from_fn(|i| {
            let mut basis = state.zeros_like();
            basis.set_coordinate(i, 1.0);
            basis
        });
        Self::from_flow(VariationalFlow::new(integrator, state, tangents, step))
    }

    /// Starts at a state with independent tangent vectors.
    ///
    /// The exponents count only the steps made from here on. To leave out a transient, advance the flow first.
    pub fn from_flow(flow: VariationalFlow<'a, I, K>) -> Self {
        let start = flow.steps();
        Self { flow, start, sums: [0.0; K], upcoming: NextStretch::First }
    }

    /// Returns the flow at the time of the last item: the state with its tangent vectors.
    pub fn flow(&self) -> &VariationalFlow<'a, I, K> {
        &self.flow
    }

    fn advance(&mut self) -> Result<Exponents<<I as Integrator>::State, K>, VariationalError> {
        match self.upcoming {
            NextStretch::Failed(error) => return Err(error),
            // The initial lengths are not stretches.
            NextStretch::First => {
                self.flow.orthonormalise()?;
            }
            NextStretch::Next => {}
        }
        self.flow.advance()?;
        for (sum, length) in self.sums.iter_mut().zip(self.flow.orthonormalise()?) {
            *sum += length.ln();
        }
        let (steps, step) = (self.flow.steps(), self.flow.step_size());
        let elapsed = (steps - self.start) as f64 * step.abs();
        let exponents = self.sums.map(|sum| sum / elapsed);
        if !elapsed.is_finite() || exponents.iter().any(|exponent| !exponent.is_finite()) {
            return Err(VariationalError::StepSize { steps: steps - self.start, step });
        }
        Ok(Exponents {
            step: steps,
            time: self.flow.time(),
            state: self.flow.state().clone(),
            exponents,
        })
    }
}

impl<I, const K: usize> Iterator for LyapunovExponents<'_, I, K>
where
    I: TangentIntegrator,
{
    type Item = Result<Exponents<<I as Integrator>::State, K>, VariationalError>;

    fn next(&mut self) -> Option<Self::Item> {
        let item = self.advance();
        self.upcoming =
            item.as_ref().map_or_else(|e| NextStretch::Failed(*e), |_| NextStretch::Next);
        Some(item)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integrators::direct::Direct;
    use crate::schemes::runge_kutta::RungeKutta;
    use crate::vector_field::VectorField;
    use lie_poisson::Real;
    use nalgebra::Vector2;

    /// The field ẋ = a y, ẏ = a x, with the exponents ±a.
    struct Hyperbolic(f64);

    impl<T: Real> VectorField<T> for Hyperbolic {
        type Point = Vector2<T>;

        fn at(&self, z: &Vector2<T>) -> Vector2<T> {
            Vector2::new(z.y * self.0, z.x * self.0)
        }
    }

    #[test]
    fn the_spectrum_of_a_linear_map_is_that_of_its_matrix() {
        // one step of the midpoint rule multiplies by (1 ± ah/2)/(1 ∓ ah/2), forwards and backwards
        let midpoint = Direct::new(RungeKutta::implicit_midpoint(), Hyperbolic(0.8));
        let start = Vector2::new(1e-200, 0.0);
        for step in [0.25, -0.25] {
            let mut spectrum = LyapunovExponents::<_, 2>::new(&midpoint, start, step);
            let last = spectrum.nth(999);
            let exact = (1.1_f64 / 0.9).ln() / 0.25;
            // finding the direction of growth costs at most ln √2
            let near = |e: [f64; 2]| (e[0] - exact).abs() < 2e-3 && (e[0] + e[1]).abs() < 1e-13;
            assert!(last.is_some_and(|l| l.is_ok_and(|l| near(l.exponents))));
        }
    }

    #[test]
    fn exponents_need_time_to_pass() {
        let midpoint = Direct::new(RungeKutta::implicit_midpoint(), Hyperbolic(0.8));
        let first = |step: f64| {
            let mut spectrum = LyapunovExponents::<_, 2>::new(&midpoint, Vector2::x(), step);
            spectrum.next().unwrap_or(Err(VariationalError::StepSize { steps: 0, step }))
        };
        for step in [0.0, -0.0] {
            let refused = VariationalError::StepSize { steps: 1, step };
            assert_eq!(first(step).err(), Some(refused));
        }
        for step in [f64::NAN, f64::INFINITY] {
            let refused = |e| matches!(e, VariationalError::Integration(e) if e.step == 1);
            assert!(first(step).is_err_and(refused), "{step}");
        }
        // the stretch of a step as short as this is 1, and ln 1 = 0
        assert!(first(1e-300).is_ok_and(|e| e.exponents == [0.0; 2]));
    }

    #[test]
    fn more_vectors_than_dimensions_are_an_error_that_stays() {
        let midpoint = Direct::new(RungeKutta::implicit_midpoint(), Hyperbolic(0.8));
        let mut spectrum = LyapunovExponents::<_, 3>::new(&midpoint, Vector2::x(), 0.1);
        let dependent = |e| matches!(e, Err(VariationalError::Dependent { index: 2, .. }));
        assert!(spectrum.next().is_some_and(dependent) && spectrum.nth(5).is_some_and(dependent));
        let mut nan = MaximalLyapunovExponent::new(&midpoint, Vector2::x() * f64::NAN, 0.1);
        assert!(nan.nth(3).is_some_and(|e| e.is_err()));
    }
}
