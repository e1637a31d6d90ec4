//! A rigid body in four dimensions.

use super::{Body, Start, cross, rk4};
use collective_integrators::{Collective, RungeKutta};
use lie_poisson::{
    Covector, Hamiltonian, LiePoisson, Pair, ProductAlgebra, Real, So3, VectorSpace,
};
use momentum_map::{Cotangent, CotangentBundle, PoissonMap};
use nalgebra::Vector3;
use std::error::Error;

/// Two vectors: ξ = (α, β) ∈ so(4) = so(3) × so(3), and a point of R³ × R³.
type Two<T> = Pair<Vector3<T>, Vector3<T>>;

/// R³ × R³.
#[derive(Clone, Copy)]
pub struct TwoVectors;

impl VectorSpace for TwoVectors {
    type Point<T: Real> = Two<T>;
}

/// The angular momenta (q₁×p₁, q₂×p₂) of T∗(R³ × R³), with the plus bracket.
#[derive(Clone, Copy)]
pub struct AngularMomenta;

impl PoissonMap for AngularMomenta {
    type Source = CotangentBundle<TwoVectors>;
    type Target = LiePoisson<ProductAlgebra<So3, So3>>;

    fn source(&self) -> Self::Source {
        CotangentBundle(TwoVectors)
    }

    fn target(&self) -> Self::Target {
        LiePoisson::plus(ProductAlgebra(So3, So3))
    }

    #[inline]
    fn apply<T: Real>(&self, z: &Cotangent<Two<T>>) -> Covector<Two<T>> {
        let (q, Covector(p)) = (&z.q, &z.p);
        Covector(Pair(q.0.cross(&p.0), q.1.cross(&p.1)))
    }

    #[inline]
    fn generator<T: Real>(&self, xi: &Two<T>, z: &Cotangent<Two<T>>) -> Cotangent<Two<T>> {
        let turned = |v: &Two<T>| Pair(xi.0.cross(&v.0), xi.1.cross(&v.1));
        Cotangent::new(turned(&z.q), Covector(turned(&z.p.0)))
    }
}

/// The free rigid body, h = ½ Σ M_ij²/(J_i + J_j).
///
/// The coordinates are a = (L + K)/2 and b = (L − K)/2, with L_i = M_jk and K_i = M_i4:
///
/// ```text
/// h = ½ Σ_i (a_i + b_i)²/(J_j + J_k) + ½ Σ_i (a_i − b_i)²/(J_i + J_4)
/// ```
#[derive(Clone, Copy)]
pub struct RigidBody {
    /// The numbers 1/(J_j + J_k).
    spatial: Vector3<f64>,
    /// The numbers 1/(J_i + J_4).
    mixed: Vector3<f64>,
}

impl RigidBody {
    /// Creates the body with J = (2, 1.5, 1, 0.7).
    pub fn new() -> Self {
        let (j, last) = (Vector3::new(2.0, 1.5, 1.0), 0.7);
        Self { spatial: j.map(|x| 1.0 / (j.sum() - x)), mixed: j.map(|x| 1.0 / (x + last)) }
    }
}

impl<T: Real> Hamiltonian<LiePoisson<ProductAlgebra<So3, So3>>, T> for RigidBody {
    fn value(&self, Covector(Pair(a, b)): &Covector<Two<T>>) -> T {
        let spatial = (a + b).zip_map(&self.spatial, |x, inverse| x * x * inverse).sum();
        (spatial + (a - b).zip_map(&self.mixed, |x, inverse| x * x * inverse).sum()) * 0.5
    }

    #[inline]
    fn differential(&self, Covector(Pair(a, b)): &Covector<Two<T>>) -> Two<T> {
        let spatial = (a + b).zip_map(&self.spatial, |x, inverse| x * inverse);
        let mixed = (a - b).zip_map(&self.mixed, |x, inverse| x * inverse);
        Pair(spatial + mixed, spatial - mixed)
    }
}

impl Body for RigidBody {
    type Map = AngularMomenta;
    type Energy = Self;

    fn gauss4(&self) -> Result<Start<Self>, Box<dyn Error>> {
        let q = Pair(Vector3::new(0.3, -1.0, 0.7), Vector3::new(0.9, 0.4, -0.5));
        let p = Pair(Vector3::new(1.1, 0.2, -0.6), Vector3::new(-0.3, 0.8, 1.0));
        let gauss = Collective::new(RungeKutta::gauss(2)?, AngularMomenta, *self);
        Ok((gauss, Cotangent::new(q, Covector(p))))
    }

    /// The equations are da/dt = ∂h/∂a × a and db/dt = ∂h/∂b × b.
    fn rk4(&self, mu: &mut [f64], steps: u64) -> Option<()> {
        let (spatial, mixed): ([f64; 3], [f64; 3]) = (self.spatial.into(), self.mixed.into());
        rk4(mu, steps, |y: &[f64; 6]| {
            let [a, b] = [[y[0], y[1], y[2]], [y[3], y[4], y[5]]];
            let sum: [f64; 3] = core::array::from_fn(|i| spatial[i] * (a[i] + b[i]));
            let difference: [f64; 3] = core::array::from_fn(|i| mixed[i] * (a[i] - b[i]));
            let first = cross(core::array::from_fn(|i| sum[i] + difference[i]), a);
            let second = cross(core::array::from_fn(|i| sum[i] - difference[i]), b);
            [first[0], first[1], first[2], second[0], second[1], second[2]]
        })
    }
}
