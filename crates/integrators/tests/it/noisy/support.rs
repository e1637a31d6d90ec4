//! Fields, noise and ensembles of the tests.

use collective_integrators::{BrownianPaths, Noisy, RungeKutta, Start};
use lie_poisson::{
    Autonomous, Covector, Differential, DoubleBracket, Energy, Hamiltonian, InnerProduct,
    IsotropicNoise, LiePoisson, Noise, OrbitField, Pair, PathNumber, Point, PoissonSpace, Real,
    So3, Time,
};
use momentum_map::Lift;
use nalgebra::Vector3;
use std::thread;

/// The field ξ = e₃ times a rate.
#[derive(Clone, Copy, Debug)]
pub struct Axial(pub f64);

impl<T: Real> OrbitField<LiePoisson<So3>, T> for Axial {
    fn element(&self, _: &Covector<Vector3<T>>, _: T) -> Vector3<T> {
        Vector3::new(T::zero(), T::zero(), T::from_f64(self.0))
    }
}

pub fn isotropic(strength: f64) -> IsotropicNoise {
    IsotropicNoise { inner_product: InnerProduct::euclidean(), strength }
}

/// The same noise, which says that it is constant or not.
#[derive(Clone, Debug)]
pub struct Told {
    pub noise: IsotropicNoise,
    pub is_constant: bool,
}

impl<P: PoissonSpace, T: Real> Noise<P, T> for Told {
    fn count(&self) -> usize {
        Noise::<P, T>::count(&self.noise)
    }

    fn element(&self, mu: &Point<P, T>, time: T, weights: &[T]) -> Differential<P, T> {
        Noise::<P, T>::element(&self.noise, mu, time, weights)
    }

    fn is_constant(&self) -> bool {
        self.is_constant
    }

    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        Noise::<P, T>::next_break(&self.noise, time, forward)
    }
}

/// The axis of [`AboutAxis`].
pub const AXIS: Vector3<f64> = Vector3::new(0.6, 0.0, 0.8);

/// One field of noise of a strength, along an axis that is not that of [`Axial`].
#[derive(Clone, Copy, Debug)]
pub struct AboutAxis(pub f64);

impl<T: Real> Noise<LiePoisson<So3>, T> for AboutAxis {
    fn count(&self) -> usize {
        1
    }

    fn element(&self, _: &Covector<Vector3<T>>, _: T, weights: &[T]) -> Vector3<T> {
        AXIS.map(T::from_f64) * (weights[0] * self.0)
    }

    fn is_constant(&self) -> bool {
        true
    }
}

/// A momentum, the number of its path, and the time.
pub type OnPath<P> = Pair<P, Pair<PathNumber, Time>>;

/// Returns a momentum on a path, at time 0.
pub fn on_path<P>(mu: P, path: u64) -> OnPath<P> {
    Pair(mu, Pair(PathNumber(path as f64), Time(0.0)))
}

/// Langevin's dynamics of a Hamiltonian at a temperature.
pub type Langevin<M, P, H> = Noisy<RungeKutta, M, DoubleBracket<P, Autonomous<H>>, IsotropicNoise>;

/// Returns Langevin's dynamics by the midpoint rule.
pub fn langevin<M, P, H>(
    (map, space, h): (M, P, H),
    (friction, temperature): (f64, f64),
    paths: BrownianPaths,
) -> Langevin<M, P, H>
where
    M: Lift<Target = P>,
    P: PoissonSpace,
    H: Hamiltonian<P>,
{
    let inner_product = InnerProduct::euclidean();
    let noise = IsotropicNoise::thermal(inner_product.clone(), (friction, temperature));
    let field = DoubleBracket::new(space, Autonomous(h), friction, inner_product).unwrap();
    Noisy::new(RungeKutta::implicit_midpoint(), map, field, noise.unwrap(), paths)
}

/// Follows many paths from a start on two threads, and returns the means of what `measure` makes of their ends, with the
/// standard errors. The paths of one thread are summed in their order.
pub fn means<I, P, const K: usize>(
    noisy: &I,
    start: P,
    (count, step, steps): (u64, f64, u64),
    measure: impl Fn(&P) -> [f64; K] + Sync,
) -> [(f64, f64); K]
where
    I: Start<Momentum = OnPath<P>> + Sync,
    P: Clone + Sync,
{
    let half = |paths: core::ops::Range<u64>| {
        let (mut workspace, mut sums) = (noisy.workspace(), [[0.0; 2]; K]);
        for path in paths {
            let mut state = noisy.start(&on_path(start.clone(), path)).unwrap();
            noisy.advance(&mut state, step, 0..steps, &mut workspace).unwrap();
            for (sum, x) in sums.iter_mut().zip(measure(&noisy.momentum(&state).0)) {
                *sum = [sum[0] + x, sum[1] + x * x];
            }
        }
        sums
    };
    let middle = count / 2;
    let [first, second] = thread::scope(|scope| {
        let both = [scope.spawn(|| half(0..middle)), scope.spawn(|| half(middle..count))];
        both.map(|one| one.join().unwrap())
    });
    let number = count as f64;
    core::array::from_fn(|k| {
        let [sum, squares] = [0, 1].map(|i| (first[k][i] + second[k][i]) / number);
        (sum, ((squares - sum * sum) / (number - 1.0)).sqrt())
    })
}

/// h = −B s₃ with the field B.
#[derive(Clone, Copy)]
pub struct InField(pub f64);

impl Energy for InField {
    type Space = LiePoisson<So3>;

    fn energy<T: Real>(&self, Covector(s): &Point<Self::Space, T>) -> T {
        s.z * -self.0
    }
}
