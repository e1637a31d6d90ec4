//! Trajectories with any number of tangent vectors: [`TangentFrame`].

use super::carrier::Carrier;
use crate::chaos::tangent_integrator::{MomentumOf, StateOf, TangentIntegrator, VariationalError};
use lie_poisson::State;

/// A state with tangent vectors whose number is known only when the program runs. Otherwise it is a
/// [`VariationalFlow`](crate::VariationalFlow), which says what is advanced, and how lengths are measured.
///
/// # Example
/// All Lyapunov exponents of a saddle ẋ = x, ẏ = −2y:
/// ```
/// use collective_integrators::{Direct, RungeKutta, TangentFrame, VectorField};
/// use lie_poisson::Real;
/// use nalgebra::Vector2;
/// struct Saddle;
/// impl<T: Real> VectorField<T> for Saddle {
///     type Point = Vector2<T>;
///     fn at(&self, z: &Vector2<T>) -> Vector2<T> {
///         Vector2::new(z.x, z.y * -2.0)
///     }
/// }
/// let gauss = Direct::new(RungeKutta::gauss(2)?, Saddle);
/// let mut frame = TangentFrame::generic(&gauss, Vector2::new(1e-3, 1.0), (2, 2), 0.01);
/// frame.orthonormalise()?;
/// let mut sums = [0.0; 2];
/// for _ in 0..500 {
///     frame.advance()?;
///     for (sum, stretch) in sums.iter_mut().zip(frame.orthonormalise()?) {
///         *sum += stretch.ln();
///     }
/// }
/// // finding the direction of growth costs a stretch of about ln √2
/// assert!((sums[0] / 5.0 - 1.0).abs() < 0.2 && (sums[0] + sums[1] + 5.0).abs() < 1e-8);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct TangentFrame<'a, I>
where
    I: TangentIntegrator,
{
    carrier: Carrier<'a, I>,
    tangents: Vec<StateOf<I>>,
    spare: Vec<StateOf<I>>,
    lengths: Vec<f64>,
}

impl<'a, I> TangentFrame<'a, I>
where
    I: TangentIntegrator,
{
    /// Creates a frame of `count` vectors without symmetry at t = 0, as
    /// [`VariationalFlow::generic`](crate::VariationalFlow::generic) does, with steps of size `step`.
    pub fn generic(
        integrator: &'a I,
        state: StateOf<I>,
        (count, dimension): (usize, usize),
        step: f64,
    ) -> Self {
        let mut tangents: Vec<_> = (0..count).map(|_| state.zeros_like()).collect();
        let mut spare = tangents.clone();
        let carrier = Carrier::new(integrator, state, step, count > 0);
        carrier.begin(dimension, &mut tangents, &mut spare);
        Self { carrier, tangents, spare, lengths: vec![0.0; count] }
    }

    /// Returns the number of steps made.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.carrier.steps
    }

    /// Returns the time t, which is the number of steps times h.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.carrier.time()
    }

    /// Returns the momentum μ of the state.
    #[must_use]
    pub fn momentum(&self) -> MomentumOf<I> {
        self.carrier.momentum()
    }

    /// Returns the tangent vectors.
    #[must_use]
    pub fn tangents(&self) -> &[StateOf<I>] {
        &self.tangents
    }

    /// Returns the tangent vectors of μ as [`VariationalFlow::directions`](crate::VariationalFlow::directions) does.
    ///
    /// # Errors
    /// Returns its errors.
    pub fn directions(&self) -> Result<Vec<MomentumOf<I>>, VariationalError> {
        let direction = self.carrier.directions()?;
        Ok(self.tangents.iter().map(direction).collect())
    }

    /// Advances the state and the tangent vectors by one step.
    ///
    /// # Errors
    /// Returns those of [`VariationalFlow::advance`](crate::VariationalFlow::advance). In these cases nothing is changed.
    pub fn advance(&mut self) -> Result<(), VariationalError> {
        self.carrier.advance(&self.tangents, &mut self.spare)?;
        core::mem::swap(&mut self.tangents, &mut self.spare);
        Ok(())
    }

    /// Orthonormalises the tangent vectors by the Gram–Schmidt process, and returns the lengths r_ii > 0.
    ///
    /// # Errors
    /// Returns those of [`VariationalFlow::orthonormalise`](crate::VariationalFlow::orthonormalise). More vectors than the
    /// state has dimensions are always dependent.
    pub fn orthonormalise(&mut self) -> Result<&[f64], VariationalError> {
        self.carrier.orthonormalise(&mut self.tangents, &mut self.spare, &mut self.lengths)?;
        Ok(&self.lengths)
    }

    /// Scales each tangent vector so that its image has the length 1, and returns the previous lengths, as
    /// [`VariationalFlow::normalise`](crate::VariationalFlow::normalise) does.
    ///
    /// # Errors
    /// Returns its errors.
    pub fn normalise(&mut self) -> Result<&[f64], VariationalError> {
        self.carrier.normalise(&mut self.tangents, &mut self.lengths)?;
        Ok(&self.lengths)
    }
}

#[cfg(test)]
mod tests {
    use super::TangentFrame;
    use crate::chaos::tangent_integrator::VariationalError;
    use crate::chaos::tangents::variational_flow::VariationalFlow;
    use crate::integrators::direct::Direct;
    use crate::schemes::runge_kutta::RungeKutta;
    use crate::vector_field::VectorField;
    use lie_poisson::Real;
    use nalgebra::Vector3;

    /// The free motion of a rigid body.
    struct Body;

    impl<T: Real> VectorField<T> for Body {
        type Point = Vector3<T>;

        fn at(&self, z: &Vector3<T>) -> Vector3<T> {
            Vector3::new(z.y * z.z * -0.2, z.z * z.x * 0.7, z.x * z.y * -0.5)
        }
    }

    #[test]
    fn a_frame_is_a_flow_with_as_many_vectors_to_the_last_bit() -> Result<(), VariationalError> {
        let midpoint = Direct::new(RungeKutta::implicit_midpoint(), Body);
        let start = Vector3::new(1.0, 0.2, -0.7);
        let mut flow = VariationalFlow::<_, 3>::generic(&midpoint, start, 3, 0.1);
        let mut frame = TangentFrame::generic(&midpoint, start, (3, 3), 0.1);
        for _ in 0..20 {
            assert_eq!(frame.orthonormalise()?, flow.orthonormalise()?);
            frame.advance()?;
            flow.advance()?;
        }
        assert_eq!((frame.tangents(), frame.momentum()), (&flow.tangents()[..], *flow.state()));
        assert_eq!((frame.steps(), frame.time()), (flow.steps(), flow.time()));
        assert_eq!(frame.normalise()?, flow.normalise()?);
        assert_eq!(frame.directions()?, flow.directions()?);
        // one vector more than there are dimensions
        let mut more = TangentFrame::generic(&midpoint, start, (4, 3), 0.1);
        let refused = more.orthonormalise().map(<[f64]>::to_vec);
        assert!(matches!(refused, Err(VariationalError::Dependent { index: 3, .. })));
        Ok(())
    }
}
