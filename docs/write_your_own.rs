//! Write your own collective integrator: an algebra, an action, a Hamiltonian.
//!
//! The Poincaré group of space-time with one space dimension acts on R² ∋ (t, x); from that alone
//! we get Lie–Poisson integrators on the dual of its algebra, for any energy h(K, H, P) of boost
//! momentum K, energy H and momentum P. The Casimir is the mass H² − P². Run with
//! `cargo test --package workspace-tests write_your_own`.

use collective_integrators::{Collective, Integrator, RungeKutta};
use lie_poisson::laws::{lie_algebra, lie_group};
use lie_poisson::*;
use momentum_map::laws::{cotangent_lift, equivariance, group_action, poisson_map};
use momentum_map::*;
use nalgebra::{Vector2, Vector3};
type Phase<T> = Cotangent<Vector2<T>>;

/// The algebra, its group and the action, all in one.
#[derive(Clone)]
pub struct Poincare;
/// Boosts commute with each other, and mix the two translations: [K, H] = P, [K, P] = H.
impl LieAlgebra for Poincare {
    type Element<T: Real> = Vector3<T>; // (boost, time translation, space translation)
    fn bracket<T: Real>(&self, xi: &Vector3<T>, eta: &Vector3<T>) -> Vector3<T> {
        Vector3::new(T::zero(), xi.x * eta.z - eta.x * xi.z, xi.x * eta.y - eta.x * xi.y)
    }
}

/// A Lorentz boost by the rapidity θ. Stumpff functions at −θ² are hyperbolic functions of θ.
fn boost<T: Real>(theta: T, v: Vector2<T>) -> Vector2<T> {
    let (cosh, sinh) = ((-theta * theta).stumpff(0), theta * (-theta * theta).stumpff(1));
    Vector2::new(v.x * cosh + v.y * sinh, v.x * sinh + v.y * cosh)
}

/// (θ, a): the map q ↦ Λ(θ) q + a.
impl LieGroup for Poincare {
    type Algebra = Self;
    type Element<T: Real> = Vector3<T>;
    fn algebra(&self) -> Self {
        Poincare
    }
    fn compose<T: Real>(&self, g: &Vector3<T>, h: &Vector3<T>) -> Vector3<T> {
        let moved = boost(g.x, h.yz());
        Vector3::new(g.x + h.x, g.y + moved.x, g.z + moved.y)
    }
    fn inverse<T: Real>(&self, g: &Vector3<T>) -> Vector3<T> {
        let back = boost(-g.x, g.yz());
        Vector3::new(-g.x, -back.x, -back.y)
    }
    fn exp<T: Real>(&self, xi: &Vector3<T>) -> Vector3<T> {
        let x = -xi.x * xi.x;
        let (even, odd) = (x.stumpff(1), xi.x * x.stumpff(2));
        Vector3::new(xi.x, xi.y * even + xi.z * odd, xi.y * odd + xi.z * even)
    }
    fn adjoint<T: Real>(&self, g: &Vector3<T>, xi: &Vector3<T>) -> Vector3<T> {
        let moved = boost(g.x, xi.yz());
        Vector3::new(xi.x, moved.x - xi.x * g.z, moved.y - xi.x * g.y)
    }
}

/// An energy, one formula for all scalars; its differential is taken by dual numbers.
pub struct Rotor;
impl Energy for Rotor {
    type Space = LiePoisson<Poincare>;
    fn energy<T: Real>(&self, Covector(j): &Covector<Vector3<T>>) -> T {
        j.x * j.x * 0.5 + j.y * j.y + j.z * j.z * 0.5 + j.x * j.z * 0.3 + j.y
    }
}

/// The right action q ↦ Λ(−θ)(q − a). First stage: `act`, from which all else follows. Second stage,
/// for speed: `momentum` and `lifted_generator` by hand. The laws compare the two.
impl GroupAction for Poincare {
    type Group = Self;
    type Space = RealSpace<2>;
    const SIDE: Side = Side::Right;
    fn group(&self) -> Self {
        Poincare
    }
    fn space(&self) -> RealSpace<2> {
        RealSpace
    }
    fn act<T: Real>(&self, g: &Vector3<T>, q: &Vector2<T>) -> Vector2<T> {
        boost(-g.x, q - g.yz())
    }
    fn momentum<T: Real>(&self, z: &Phase<T>) -> Covector<Vector3<T>> {
        let (q, Covector(p)) = (&z.q, &z.p);
        Covector(-Vector3::new(p.x * q.y + p.y * q.x, p.x, p.y))
    }
    fn lifted_generator<T: Real>(&self, xi: &Vector3<T>, z: &Phase<T>) -> Phase<T> {
        Cotangent::new(-(z.q.yx() * xi.x + xi.yz()), Covector(z.p.0.yx() * xi.x))
    }
}

#[test]
fn the_laws_hold() -> Result<(), Box<dyn std::error::Error>> {
    let samples = [Vector3::new(0.3, -0.7, 0.5), Vector3::new(-0.6, 0.2, 0.9)];
    let points = samples.map(|s| Cotangent::new(s.xy(), Covector(s.zx())));
    lie_algebra(&Poincare, &samples)?.check(1e-14)?;
    lie_group(&Poincare, &samples)?.check(1e-14)?;
    group_action(&Poincare, &samples, &samples.map(|s| s.xy()))?.check(1e-14)?;
    cotangent_lift(&Poincare, &samples, &points)?.check(1e-14)?;
    equivariance(&Poincare, &samples, &points)?.check(1e-14)?;
    Ok(poisson_map(&MomentumMap(Poincare), &points)?.check(1e-14)?)
}

#[test]
fn the_mass_is_conserved_to_round_off() -> Result<(), Box<dyn std::error::Error>> {
    let gauss = Collective::new(RungeKutta::gauss(3)?, MomentumMap(Poincare), Automatic(Rotor));
    let start = Cotangent::new(Vector2::new(0.4, -0.2), Covector(Vector2::new(0.3, 0.8)));
    let (first, mass) = (Poincare.momentum(&start), |j: &Vector3<f64>| j.y * j.y - j.z * j.z);
    for sample in gauss.trajectory_from(start, 0.05).take(20_001) {
        let j = sample?.momentum;
        assert!((mass(&j.0) - mass(&first.0)).abs() < 1e-12);
        assert!((Rotor.energy(&j) - Rotor.energy(&first)).abs() < 1e-8); // of order 6
    }
    Ok(())
}
