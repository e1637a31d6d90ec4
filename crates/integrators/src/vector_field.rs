//! Vector fields, which schemes integrate: [`VectorField`].

use crate::iteration::lane_problem::{LaneProblem, Outcome};
use crate::stage_frame::{OwnFrame, StageFrame};
use core::marker::PhantomData;
use lie_poisson::{
    Differential, DualNumber, Hamiltonian, Point, PoissonSpace, Real, State, derivative_part,
    map_coordinates, seed,
};

/// An autonomous vector field dz/dt = X(z) over the scalar `T`.
///
/// # Example
/// A field that is written over every scalar also works with tangent vectors and in SIMD lanes:
/// ```
/// use collective_integrators::{Direct, RungeKutta, Start, VectorField};
/// use lie_poisson::Real;
/// use nalgebra::Vector2;
///
/// struct Pendulum {
///     gravity: f64,
/// }
/// impl<T: Real> VectorField<T> for Pendulum {
///     type Point = Vector2<T>;
///     fn at(&self, z: &Vector2<T>) -> Vector2<T> {
///         Vector2::new(z.y, -z.x.sin() * self.gravity)
///     }
/// }
///
/// // At g = 9.81 small swings have the period 2π/√g.
/// let gauss = Direct::new(RungeKutta::gauss(4)?, Pendulum { gravity: 9.81 });
/// let (start, period) = (Vector2::new(1e-4, 0.0), std::f64::consts::TAU / 9.81_f64.sqrt());
/// let end = gauss.after(&start, period / 20.0, 20)?.state;
/// assert!((end - start).norm() < 1e-11);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait VectorField<T: Real = f64> {
    /// The type of the points z.
    type Point: State<Scalar = T>;

    /// Returns the value X(z) of the field.
    fn at(&self, z: &Self::Point) -> Self::Point;

    /// Writes the value X(z) of the field to a point of the space of z. The previous coordinates of this point are
    /// arbitrary.
    ///
    /// Integrators call this method. The default calls [`at`](Self::at); override it for large points, so that a step
    /// allocates nothing. If X(z) belongs to another space than z, the written value is NaN, so that a step fails.
    ///
    /// # Example
    /// The field dz/dt = −z, for as many sites as z has:
    /// ```
    /// use collective_integrators::VectorField;
    /// use lie_poisson::{Sites, State};
    /// use nalgebra::Vector1;
    /// struct Decay;
    /// impl VectorField for Decay {
    ///     type Point = Sites<Vector1<f64>>;
    ///     fn at(&self, z: &Self::Point) -> Self::Point {
    ///         let mut value = z.zeros_like();
    ///         self.at_into(z, &mut value);
    ///         value
    ///     }
    ///     fn at_into(&self, z: &Self::Point, value: &mut Self::Point) {
    ///         value.assign(z);
    ///         value.scale_in_place(-1.0);
    ///     }
    /// }
    /// let z = Sites::new(vec![Vector1::new(2.0); 3]);
    /// assert_eq!(Decay.at(&z)[2].x, -2.0);
    /// ```
    #[cfg_attr(optimised, inline(always))]
    fn at_into(&self, z: &Self::Point, value: &mut Self::Point) {
        let mut point = self.at(z);
        if point.same_shape(value) {
            value.move_from(&mut point);
        } else {
            value.set_coordinates(|_| T::from_f64(f64::NAN));
        }
    }

    /// Returns the exact derivative DX(z)·v, or `None` if it is not known.
    ///
    /// Newton's iteration for the stages of an implicit method uses it. If the derivative is not known, it uses
    /// difference quotients instead.
    #[cfg_attr(optimised, inline(always))]
    fn derivative(&self, _z: &Self::Point, _v: &Self::Point) -> Option<Self::Point> {
        None
    }

    /// Solves stage equations with one stage in each SIMD lane, or returns `None` if it does not, as the default.
    ///
    /// [`StagesInLanes`](crate::StagesInLanes) makes its steps with a field that does. A field that wraps another one
    /// passes the call on, as [`Observed`](crate::Observed) does; otherwise the stages are computed one by one.
    #[cfg_attr(optimised, inline(always))]
    fn solve_in_lanes(
        &self,
        _problem: &mut LaneProblem<'_, Self::Point>,
    ) -> Option<Outcome<Self::Point>> {
        None
    }

    /// Returns the coordinates in which the stage solver remembers stage derivatives from step to step. The default is
    /// for a field whose coordinates are the same in every step.
    ///
    /// [`LiftFree`](crate::LiftFree) makes its steps with a field that has others. A field that wraps another one passes
    /// the call on, as [`Observed`](crate::Observed) does; otherwise nothing is predicted.
    #[cfg_attr(optimised, inline(always))]
    fn stage_frame(&self) -> impl StageFrame<Self::Point>
    where
        Self: Sized,
    {
        OwnFrame
    }
}

/// A reference to a field is that field, so that a wrapper can hold one.
impl<T: Real, F: VectorField<T>> VectorField<T> for &F {
    type Point = F::Point;

    #[cfg_attr(optimised, inline(always))]
    fn at(&self, z: &F::Point) -> F::Point {
        (**self).at(z)
    }

    #[cfg_attr(optimised, inline(always))]
    fn at_into(&self, z: &F::Point, value: &mut F::Point) {
        (**self).at_into(z, value);
    }

    fn derivative(&self, z: &F::Point, v: &F::Point) -> Option<F::Point> {
        (**self).derivative(z, v)
    }

    #[cfg_attr(optimised, inline(always))]
    fn solve_in_lanes(&self, problem: &mut LaneProblem<'_, F::Point>) -> Option<Outcome<F::Point>> {
        (**self).solve_in_lanes(problem)
    }

    #[cfg_attr(optimised, inline(always))]
    fn stage_frame(&self) -> impl StageFrame<F::Point> {
        (**self).stage_frame()
    }
}

/// The Hamiltonian vector field X_h = Λ dh on a Poisson space.
///
/// On 𝔤∗ with the minus bracket it gives the Lie–Poisson equations dμ/dt = `ad*_ξ μ`, where ξ = dh(μ).
///
/// Source: Ohsawa 2019, eq. (1.1) for the heavy top; Marsden & Ratiu, *Introduction to Mechanics and Symmetry* (1999),
/// Prop. 10.7.1.
///
/// # Example
/// A free rigid body, dΠ/dt = Π × Ω:
/// ```
/// use collective_integrators::{HamiltonianField, VectorField};
/// use lie_poisson::{Automatic, Covector, Energy, LiePoisson, Momentum, Real, So3};
/// use nalgebra::Vector3;
/// struct Kinetic;
/// impl Energy for Kinetic {
///     type Space = LiePoisson<So3>;
///     fn energy<T: Real>(&self, Covector(pi): &Momentum<So3, T>) -> T {
///         (pi.x * pi.x + pi.y * pi.y * 0.5 + pi.z * pi.z * 0.25) * 0.5
///     }
/// }
/// let field = HamiltonianField { space: LiePoisson::minus(So3), hamiltonian: Automatic(Kinetic) };
/// let pi = Vector3::new(1.0, 2.0, 4.0);
/// assert_eq!(field.at(&Covector(pi)).0, pi.cross(&Vector3::new(1.0, 1.0, 1.0)));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct HamiltonianField<P, H> {
    /// The Poisson space with its bracket.
    pub space: P,
    /// The Hamiltonian function h on the space.
    pub hamiltonian: H,
}

impl<P, H, T> VectorField<T> for HamiltonianField<P, H>
where
    P: PoissonSpace,
    H: Hamiltonian<P, T>,
    T: Real,
{
    type Point = Point<P, T>;

    #[cfg_attr(optimised, inline(always))]
    fn at(&self, z: &Self::Point) -> Self::Point {
        self.space.hamiltonian_vector::<T>(z, &self.hamiltonian.differential(z))
    }

    fn derivative(&self, z: &Self::Point, v: &Self::Point) -> Option<Self::Point> {
        let moved = seed(z, v);
        let dh = dual_differential::<P, T, _>(&self.hamiltonian, &moved)?;
        Some(derivative_part(&self.space.hamiltonian_vector::<DualNumber<T>>(&moved, &dh)))
    }
}

/// Returns dh at the dual point z + ε v, which is dh(z) + ε D²h(z)·v, or `None` if the Hessian is not known.
pub(crate) fn dual_differential<P: PoissonSpace, T: Real, H: Hamiltonian<P, T>>(
    hamiltonian: &H,
    moved: &Point<P, DualNumber<T>>,
) -> Option<Differential<P, DualNumber<T>>> {
    let z: Point<P, T> = map_coordinates(moved, |x| x.value_without_derivative());
    let hessian = hamiltonian.hessian(&z, &derivative_part(moved))?;
    Some(seed(&hamiltonian.differential(&z), &hessian))
}

/// Creates the vector field that a closure computes.
///
/// ```
/// use collective_integrators::{VectorField, from_fn};
/// use nalgebra::Vector2;
/// let oscillator = from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x));
/// assert_eq!(oscillator.at(&Vector2::new(1.0, 2.0)), Vector2::new(2.0, -1.0));
/// ```
pub fn from_fn<V: State, F: Fn(&V) -> V>(field: F) -> FromFn<V, F> {
    FromFn { field, point: PhantomData }
}

/// The vector field of a closure, created by [`from_fn`].
#[derive(Clone, Copy, Debug)]
pub struct FromFn<V, F> {
    field: F,
    point: PhantomData<fn() -> V>,
}

impl<T: Real, V: State<Scalar = T>, F: Fn(&V) -> V> VectorField<T> for FromFn<V, F> {
    type Point = V;

    #[cfg_attr(optimised, inline(always))]
    fn at(&self, z: &V) -> V {
        (self.field)(z)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lie_poisson::{Automatic, Covector, Energy, LiePoisson, Real, So3};
    use nalgebra::Vector3;

    /// h(Π) = ½Π₁² + Π₂² + ³⁄₁₀ Π₁Π₃
    struct Body;

    impl Energy for Body {
        type Space = LiePoisson<So3>;
        fn energy<T: Real>(&self, Covector(pi): &Covector<Vector3<T>>) -> T {
            pi.x * pi.x * 0.5 + pi.y * pi.y + pi.x * pi.z * 0.3
        }
    }

    /// Central differences of a quadratic field are exact.
    #[test]
    fn a_hamiltonian_field_has_the_derivative_of_its_differences() {
        let field =
            HamiltonianField { space: LiePoisson::minus(So3), hamiltonian: Automatic(Body) };
        let (z, v) = (Vector3::new(0.7, -1.2, 0.4), Vector3::new(0.3, 0.9, -0.5));
        let at = |t: f64| field.at(&Covector(z + v * t)).0;
        let derivative = field.derivative(&Covector(z), &Covector(v));
        let difference = (at(0.5) - at(-0.5)).norm();
        assert!(derivative.is_some_and(|d| (d.0 - (at(0.5) - at(-0.5))).norm() < 1e-15));
        assert!(difference > 0.5);
    }
}
