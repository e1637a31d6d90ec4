//! Negative controls that are no [`Faulty`](momentum_map::laws::Faulty) objects: the Hopf map and the rotations of R³, each
//! with one part that is wrong.

use lie_poisson::*;
use momentum_map::*;
use nalgebra::{Matrix3, SVector, Vector2, Vector3};
use num_complex::Complex;

/// The Hopf map with one wrong part.
#[derive(Clone, PartialEq)]
pub enum FaultyHopf {
    /// The sign of a coordinate is reversed: the map is neither Poisson nor equivariant.
    Mirrored,
    /// The gauge term is z, and does not stay on the fibre.
    Gauge,
    /// The two flows are a dilation, up to second order, and a translation, which do not commute.
    Fibres,
}

impl PoissonMap for FaultyHopf {
    type Source = Symplectic<So3OnC2>;
    type Target = LiePoisson<So3>;
    fn source(&self) -> Self::Source {
        HOPF.source()
    }
    fn target(&self) -> Self::Target {
        HOPF.target()
    }
    fn apply<T: Real>(&self, z: &Vector2<Complex<T>>) -> Covector<Vector3<T>> {
        let mut pi = HOPF.apply(z);
        if *self == Self::Mirrored {
            pi.0.y = -pi.0.y;
        }
        pi
    }
    fn generator<T: Real>(&self, xi: &Vector3<T>, z: &Vector2<Complex<T>>) -> Vector2<Complex<T>> {
        HOPF.generator(xi, z)
    }
    fn pull_back<T: Real>(
        &self,
        alpha: &Vector3<T>,
        z: &Vector2<Complex<T>>,
    ) -> Covector<Vector2<Complex<T>>> {
        let alpha =
            if *self == Self::Mirrored { Vector3::new(alpha.x, -alpha.y, alpha.z) } else { *alpha };
        HOPF.pull_back(&alpha, z)
    }
    fn gauge<T: Real>(&self, z: &Vector2<Complex<T>>) -> Vector2<Complex<T>> {
        if *self == Self::Gauge { *z } else { Vector2::zeros() }
    }
}

impl FibreSymmetry for FaultyHopf {
    const COUNT: usize = 2;
    fn flow<T: Real>(&self, index: usize, s: T, z: &Vector2<Complex<T>>) -> Vector2<Complex<T>> {
        match self {
            Self::Fibres if index == 0 => z.map(|x| x.scale(T::one() + s)),
            Self::Fibres => z.map(|x| x + s),
            _ => HOPF.flow(0, s, z),
        }
    }
    fn momentum<T: Real>(&self, _: usize, z: &Vector2<Complex<T>>) -> T {
        HOPF.momentum(0, z)
    }
}

/// The rotations of R³ with one wrong part.
#[derive(Clone, PartialEq)]
pub enum FaultyRotations {
    /// The infinitesimal generator has the wrong sign.
    Generator,
    /// The infinitesimal generator is wrong for elements of so(3) below 10⁻⁷ alone.
    GeneratorNearZero,
    /// The momentum has the wrong sign.
    Momentum,
    /// The generator of the cotangent lift has the wrong sign in p.
    Lift,
    /// The maps (1 + |q|²) R q are no action: for R = 1 it is not q.
    Swollen,
}

impl GroupAction for FaultyRotations {
    type Group = SO3;
    type Space = RealSpace<3>;
    const SIDE: Side = Side::Left;
    fn group(&self) -> SO3 {
        SO3
    }
    fn space(&self) -> RealSpace<3> {
        RealSpace
    }
    fn act<T: Real>(&self, g: &Matrix3<T>, q: &Vector3<T>) -> Vector3<T> {
        if *self == Self::Swollen { g * q * (T::one() + q.dot(q)) } else { g * q }
    }
    fn infinitesimal_generator<T: Real>(&self, xi: &Vector3<T>, q: &Vector3<T>) -> Vector3<T> {
        let factor = match self {
            Self::Generator => -1.0,
            Self::GeneratorNearZero if xi.iter().all(|x| x.all_below(1e-7)) => 1.5,
            _ => 1.0,
        };
        xi.cross(q) * T::from_f64(factor)
    }
    fn momentum<T: Real>(&self, z: &Cotangent<SVector<T, 3>>) -> Covector<Vector3<T>> {
        let j = Covector(z.q.cross(&z.p.0));
        if *self == Self::Momentum { -j } else { j }
    }
    fn lifted_generator<T: Real>(
        &self,
        xi: &Vector3<T>,
        z: &Cotangent<SVector<T, 3>>,
    ) -> Cotangent<SVector<T, 3>> {
        let p = Covector(xi.cross(&z.p.0));
        Cotangent::new(xi.cross(&z.q), if *self == Self::Lift { -p } else { p })
    }
}

/// A left action that wrongly claims to be a right one.
#[derive(Clone)]
pub struct WrongSide;

impl GroupAction for WrongSide {
    type Group = SO3;
    type Space = RealSpace<3>;
    const SIDE: Side = Side::Right;
    fn group(&self) -> SO3 {
        SO3
    }
    fn space(&self) -> RealSpace<3> {
        RealSpace
    }
    fn act<T: Real>(&self, g: &Matrix3<T>, q: &Vector3<T>) -> Vector3<T> {
        g * q
    }
}
