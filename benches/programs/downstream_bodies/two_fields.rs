//! A rigid body in two constant fields, such as gravity and a magnetic field.

use super::{Body, Start, cross, rk4};
use collective_integrators::{Collective, RungeKutta};
use lie_poisson::{
    Covector, Diagonal, Hamiltonian, LiePoisson, Pair, Power, Real, SO3OnR3, SemidirectAlgebra,
    VectorSpace,
};
use momentum_map::{Cotangent, CotangentBundle, PoissonMap};
use nalgebra::Vector3;
use std::error::Error;

/// Two vectors, one for each field.
type Fields<T> = Power<Vector3<T>, 2>;

/// An element (ω, v₁, v₂) of se(3) ⋉ R³ = so(3) ⋉ (R³)², and the coordinates (Π, Γ₁, Γ₂) of a covector.
type Motion<T> = Pair<Vector3<T>, Fields<T>>;

/// The algebra so(3) ⋉ (R³)².
type Algebra = SemidirectAlgebra<Diagonal<SO3OnR3, 2>>;

/// (R³)².
#[derive(Clone, Copy)]
pub struct TwoVectors;

impl VectorSpace for TwoVectors {
    type Point<T: Real> = Fields<T>;
}

/// The momentum (Σ pᵢ×qᵢ, −p) of the right action of the motions on T∗(R³)², with the minus bracket.
#[derive(Clone, Copy)]
pub struct TwoParticles;

impl PoissonMap for TwoParticles {
    type Source = CotangentBundle<TwoVectors>;
    type Target = LiePoisson<Algebra>;

    fn source(&self) -> Self::Source {
        CotangentBundle(TwoVectors)
    }

    fn target(&self) -> Self::Target {
        LiePoisson::minus(SemidirectAlgebra(Diagonal(SO3OnR3)))
    }

    #[inline]
    fn apply<T: Real>(&self, z: &Cotangent<Fields<T>>) -> Covector<Motion<T>> {
        let (Power(q), Covector(p)) = (z.q, z.p);
        Covector(Pair(p.0[0].cross(&q[0]) + p.0[1].cross(&q[1]), -p))
    }

    #[inline]
    fn generator<T: Real>(&self, xi: &Motion<T>, z: &Cotangent<Fields<T>>) -> Cotangent<Fields<T>> {
        let back = |v: Fields<T>| Power::from_factors(|n| v.0[n].cross(&xi.0));
        Cotangent::new(back(z.q) - xi.1, Covector(back(z.p.0)))
    }
}

/// The body with h = ½ Π·I⁻¹Π + c₁·Γ₁ + c₂·Γ₂.
#[derive(Clone, Copy)]
pub struct BodyInTwoFields {
    inverse: Vector3<f64>,
    torques: [Vector3<f64>; 2],
}

impl BodyInTwoFields {
    /// Creates the body with I = (2, 1.5, 1), c₁ = (1, 0, 0) and c₂ = (0, 0.5, 0.3).
    pub fn new() -> Self {
        let inverse = Vector3::new(2.0, 1.5, 1.0).map(|x: f64| 1.0 / x);
        Self { inverse, torques: [Vector3::x(), Vector3::new(0.0, 0.5, 0.3)] }
    }
}

impl<T: Real> Hamiltonian<LiePoisson<Algebra>, T> for BodyInTwoFields {
    fn value(&self, Covector(Pair(pi, gamma)): &Covector<Motion<T>>) -> T {
        let kinetic = pi.zip_map(&self.inverse, |x, inverse| x * x * inverse).sum() * 0.5;
        let [first, second] = [0, 1].map(|i| gamma.0[i].zip_map(&self.torques[i], |x, c| x * c));
        kinetic + first.sum() + second.sum()
    }

    #[inline]
    fn differential(&self, Covector(Pair(pi, _)): &Covector<Motion<T>>) -> Motion<T> {
        let torques = Power::from_factors(|n| self.torques[n].map(T::from_f64));
        Pair(pi.zip_map(&self.inverse, |x, inverse| x * inverse), torques)
    }
}

impl Body for BodyInTwoFields {
    type Map = TwoParticles;
    type Energy = Self;

    fn gauss4(&self) -> Result<Start<Self>, Box<dyn Error>> {
        let q = Power([Vector3::new(0.3, -1.0, 0.7), Vector3::new(0.9, 0.4, -0.5)]);
        let p = Power([Vector3::new(0.6, 0.0, -0.8), Vector3::new(0.0, 1.0, 0.0)]);
        let gauss = Collective::new(RungeKutta::gauss(2)?, TwoParticles, *self);
        Ok((gauss, Cotangent::new(q, Covector(p))))
    }

    /// The equations are dΠ/dt = Π×Ω + Σ Γᵢ×cᵢ and dΓᵢ/dt = Γᵢ×Ω.
    fn rk4(&self, mu: &mut [f64], steps: u64) -> Option<()> {
        let inverse: [f64; 3] = self.inverse.into();
        let [c, d]: [[f64; 3]; 2] = self.torques.map(Into::into);
        rk4(mu, steps, |y: &[f64; 9]| {
            let pi = [y[0], y[1], y[2]];
            let fields = [[y[3], y[4], y[5]], [y[6], y[7], y[8]]];
            let omega = core::array::from_fn(|i| inverse[i] * pi[i]);
            let parts = [cross(pi, omega), cross(fields[0], c), cross(fields[1], d)];
            let [first, second] = fields.map(|field| cross(field, omega));
            core::array::from_fn(|i| match i {
                0..3 => parts[0][i] + parts[1][i] + parts[2][i],
                3..6 => first[i - 3],
                _ => second[i - 6],
            })
        })
    }
}
