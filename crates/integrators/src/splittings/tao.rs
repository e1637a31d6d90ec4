//! Tao's method in an extended phase space: [`TaoFlows`].

use crate::schemes::polarisation::Polarisation;
use crate::splittings::exact_flows::ExactFlows;
use crate::vector_field::VectorField;
use core::marker::PhantomData;
use lie_poisson::{Pair, Real, State};

/// The three exact flows of Tao's method for Hamiltonians that do not separate.
///
/// The phase space is doubled to pairs of (q, p) and (x, y), coupled with strength ω by the extended Hamiltonian K:
///
/// ```text
/// K = H(q, y) + H(x, p) + ω (|q − x|² + |p − y|²)/2
/// φ_1(t): p −= t H_q(q, y),  x += t H_p(q, y)
/// φ_2(t): q += t H_p(x, p),  y −= t H_q(x, p)
/// φ_3(t): (q − x) + i(p − y) turns by the angle −2ωt, sums unchanged
/// ```
///
/// [`Splitting::strang`](crate::Splitting::strang) of these flows is Tao's method of order 2. It is explicit,
/// symmetric, and symplectic on the doubled space, for any ω. It is not a map of the original space: the two copies
/// drift apart, and fibres are not carried to fibres. The copies stay close for a long time only if ω is large enough.
/// The coupling needs the [`Polarisation`] P.
///
/// Source: M. Tao, *Explicit symplectic approximation of nonseparable Hamiltonians: algorithm and
/// long time performance*, Phys. Rev. E 94 (2016).
///
/// # Example
/// ```
/// use collective_integrators::{Alternating, Splitting, Start, TaoFlows, from_fn};
/// use nalgebra::Vector2;
/// // H = ½(q² + 1)(p² + 1)
/// let field = from_fn(|z: &Vector2<f64>| {
///     Vector2::new((z.x * z.x + 1.0) * z.y, -z.x * (z.y * z.y + 1.0))
/// });
/// let flows = TaoFlows::<_, Alternating>::new(field, 20.0);
/// let z = Vector2::new(-1.0, 0.0);
/// let energy = |z: &Vector2<f64>| 0.5 * (z.x * z.x + 1.0) * (z.y * z.y + 1.0);
/// for sample in Splitting::strang(flows).trajectory(&TaoFlows::copied(z), 0.01)?.take(1000) {
///     assert!((energy(&sample?.state.0) - energy(&z)).abs() < 1e-3);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TaoFlows<F, P> {
    field: F,
    binding: f64,
    polarisation: PhantomData<P>,
}

impl<F, P: Polarisation> TaoFlows<F, P> {
    /// Creates the flows for the Hamiltonian vector field X_H, coupled with strength ω ≥ 0 in units of 1/time.
    pub const fn new(field: F, binding: f64) -> Self {
        Self { field, binding, polarisation: PhantomData }
    }
}

impl TaoFlows<(), ()> {
    /// Returns two copies of z, from which a trajectory starts.
    pub const fn copied<V: Copy>(z: V) -> Pair<V, V> {
        Pair(z, z)
    }
}

impl<T: Real, F: VectorField<T>, P: Polarisation> ExactFlows<T> for TaoFlows<F, P> {
    type Point = Pair<F::Point, F::Point>;
    const COUNT: usize = 3;

    fn flow(&self, index: usize, time: f64, z: &Self::Point) -> Self::Point {
        let (mut end, mut pool) = (z.clone(), Default::default());
        self.flow_in_place(index, time, &mut end, &mut pool);
        end
    }

    #[inline]
    fn flow_in_place(
        &self,
        index: usize,
        time: f64,
        Pair(first, second): &mut Self::Point,
        (pool, _): &mut <Self::Point as State>::Pool,
    ) {
        match index {
            0 => self.kick::<T>(time, first, second, pool),
            1 => self.kick::<T>(time, second, first, pool),
            2 => {
                let (sin, cos) = (2.0 * self.binding * time).sin_cos();
                let [mut apart, mut turned] = [(); 2].map(|()| F::Point::take(pool, first));
                apart.assign(first);
                apart.subtract_in_place(second);
                turn::<P, F::Point>(&apart, sin, cos, &mut turned);
                first.add_in_place(second);
                second.assign(first);
                first.add_in_place(&turned);
                second.subtract_in_place(&turned);
                first.scale_in_place(T::from_f64(0.5));
                second.scale_in_place(T::from_f64(0.5));
                apart.give(pool);
                turned.give(pool);
            }
            _ => {}
        }
    }
}

impl<F, P: Polarisation> TaoFlows<F, P> {
    /// Adds t X(q, y) to (q, p) and (x, y), the momenta to `first` = (q, p) and the positions to `second` = (x, y).
    #[inline]
    fn kick<T: Real>(
        &self,
        time: f64,
        first: &mut F::Point,
        second: &mut F::Point,
        pool: &mut <F::Point as State>::Pool,
    ) where
        F: VectorField<T>,
    {
        let [mut mixed, mut change, mut part] = [(); 3].map(|()| F::Point::take(pool, first));
        P::splice_into(first, second, &mut mixed);
        self.field.at_into(&mixed, &mut change);
        change.scale_in_place(T::from_f64(time));
        mixed.set_zero();
        P::splice_into(&mixed, &change, &mut part);
        first.add_in_place(&part);
        P::splice_into(&change, &mixed, &mut part);
        second.add_in_place(&part);
        for point in [mixed, change, part] {
            point.give(pool);
        }
    }
}

/// Writes the rotated point (q cos + p sin, p cos − q sin).
#[inline]
fn turn<P: Polarisation, V: State>(z: &V, sin: f64, cos: f64, turned: &mut V) {
    let dimension = z.dimension();
    turned.set_coordinates(|i| {
        let sin = if P::is_position(i, dimension) { sin } else { -sin };
        z.coordinate(i) * cos + z.coordinate(P::conjugate(i, dimension)) * sin
    });
}
