//! The systems of the literature, each with what its scheme promises to conserve.

use collective_integrators::{Collective, RungeKutta, Scheme, Start};
use core::array::from_fn;
use heavytop::*;
use lie_poisson::*;
use momentum_map::{Cotangent, Lift};
use momentum_map::{
    CotangentBundle, HOPF, Identity, PowerMap, ProductMap, QuadraticMomentumMap, Side, So3OnC2,
};
use nalgebra::{Matrix3, SVector, Vector3};

/// The largest deviation of each function from its initial value over a collective trajectory.
fn drifts<M, H, F, const K: usize>(
    scheme: &RungeKutta,
    map: M,
    hamiltonian: H,
    start: &Point<M::Target>,
    (step, steps): (f64, usize),
    functions: F,
) -> [f64; K]
where
    M: Lift,
    H: Hamiltonian<M::Target>,
    F: Fn(&H, &Point<M::Target>) -> [f64; K],
{
    let integrator = Collective::new(scheme.clone(), map, hamiltonian);
    let h = &integrator.system().hamiltonian;
    let initial = functions(h, start);
    let mut worst = [0.0_f64; K];
    for sample in integrator.trajectory(start, step).unwrap().take(steps + 1) {
        let values = functions(h, &sample.unwrap().momentum);
        worst = from_fn(|k| larger(worst[k], (values[k] - initial[k]).abs()));
    }
    worst
}

/// Casimirs and momentum maps of affine symmetries are quadratic: a Gauss method conserves them
/// to the round-off of this many steps.
const ROUND_OFF: f64 = 1e-12;

fn schemes() -> [RungeKutta; 2] {
    [RungeKutta::implicit_midpoint(), RungeKutta::gauss(3).unwrap()]
}

/// What a symplectic scheme of order p may do to the energy: bounded by C hᵖ, C of size 1 here.
fn energy_bound(scheme: &RungeKutta, step: f64) -> f64 {
    step.powi(scheme.order() as i32) + ROUND_OFF
}

fn kirchhoff() -> Kirchhoff {
    let a = Matrix3::new(0.9, 0.1, 0.0, 0.1, 0.6, 0.05, 0.0, 0.05, 0.4);
    let b = Matrix3::new(0.1, -0.05, 0.02, 0.0, 0.08, 0.1, -0.07, 0.0, 0.03);
    let c = Matrix3::new(0.5, 0.0, 0.1, 0.0, 0.7, -0.1, 0.1, -0.1, 0.3);
    Kirchhoff::new(a, b, c).unwrap()
}

#[test]
fn kirchhoffs_body_conserves_energy_and_casimirs() {
    let start = Se3Dual::new(Vector3::new(0.4, -0.8, 0.6), Vector3::new(0.5, 0.3, -0.9));
    for scheme in schemes() {
        let [energy, square, level] =
            drifts(&scheme, SpinorRealisation, kirchhoff(), &start, (0.1, 1000), |h, mu| {
                let Covector(Pair(pi, p)) = mu;
                [h.value(mu), p.dot(p), pi.dot(p)]
            });
        assert!(square < ROUND_OFF && level < ROUND_OFF, "{square:e} {level:e}");
        assert!(energy < energy_bound(&scheme, 0.1), "{energy:e}");
    }
}

#[test]
fn kirchhoffs_parameters_are_checked() {
    let one = Matrix3::identity();
    let skew = Matrix3::new(1.0, 0.1, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0);
    assert!(matches!(Kirchhoff::new(skew, one * 0.1, one), Err(TopError::NotSymmetric { .. })));
    assert!(matches!(Kirchhoff::new(one, one * 1.5, one), Err(TopError::NotPositive { .. })));
    assert!(matches!(Kirchhoff::new(one * f64::NAN, one, one), Err(TopError::NotFinite { .. })));
}

#[test]
fn the_gyrostat_conserves_energy_and_casimirs() {
    let top = HeavyTop::kovalevskaya(1.0, 1.0).unwrap();
    let gyrostat = Gyrostat::new(top, Vector3::new(0.1, -0.2, 0.7)).unwrap();
    let start = Se3Dual::new(Vector3::new(0.4, -0.8, 0.6), Vector3::new(0.6, 0.0, -0.8));
    for scheme in schemes() {
        let [energy, square, level] =
            drifts(&scheme, SpinorRealisation, gyrostat, &start, (0.05, 1000), |h, mu| {
                [h.value(mu), mu.0.1.dot(&mu.0.1), mu.0.0.dot(&mu.0.1)]
            });
        assert!(square < ROUND_OFF && level < ROUND_OFF, "{square:e} {level:e}");
        assert!(energy < energy_bound(&scheme, 0.05), "{energy:e}");
    }
    assert!(Gyrostat::new(top, Vector3::new(f64::INFINITY, 0.0, 0.0)).is_err());
}

#[test]
fn goryachev_and_chaplygins_integral_holds_on_its_level_alone() {
    let top = HeavyTop::goryachev_chaplygin(1.0, 1.0).unwrap();
    let gauss = RungeKutta::gauss(6).unwrap();
    let drift = |gamma: Vector3<f64>| {
        let start = Se3Dual::new(Vector3::new(1.0, 2.0, 3.0), gamma);
        let [drift] = drifts(&gauss, SpinorRealisation, top, &start, (0.05, 500), |h, mu| {
            [Invariant::GoryachevChaplygin.value(h, mu)]
        });
        drift
    };
    let on_level = Vector3::new(3.0, 0.0, -1.0) / 10.0_f64.sqrt();
    assert!(drift(on_level) < 1e-11, "{:e}", drift(on_level));
    assert!(drift(Vector3::z()) > 1.0);
}

#[test]
fn vortices_conserve_energy_spheres_and_the_moment_of_vorticity() {
    let vortices = PointVortices::new([1.0, -0.7, 1.5, 0.4]).unwrap();
    let positions = [
        Vector3::new(1.0, 0.2, -0.3),
        Vector3::new(-0.4, 1.0, 0.5),
        Vector3::new(0.1, -0.8, 0.7),
        Vector3::new(-0.5, -0.2, -1.0),
    ]
    .map(|x| x.normalize());
    let start = vortices.momentum(&positions);
    let map = PowerMap::<_, 4>(HOPF);
    for scheme in schemes() {
        let [energy, spheres, x, y, z] =
            drifts(&scheme, map, vortices, &start, (0.1, 500), |h, m| {
                let sum: Vector3<f64> = m.0.0.iter().sum();
                let spheres = m.0.0.iter().map(Vector3::norm_squared).sum();
                [h.value(m), spheres, sum.x, sum.y, sum.z]
            });
        for drift in [spheres, x, y, z] {
            assert!(drift < ROUND_OFF, "{drift:e}");
        }
        assert!(energy < energy_bound(&scheme, 0.1), "{energy:e}");
    }
    assert!(PointVortices::new([1.0, 0.0]).is_err() && PointVortices::new([f64::NAN]).is_err());
}

#[test]
fn vortex_equations_are_bogomolovs() {
    let strengths = [1.0, -0.7, 1.5];
    let vortices = PointVortices::new(strengths).unwrap();
    let x = [Vector3::x(), Vector3::new(0.0, 0.6, 0.8), Vector3::new(-0.8, 0.0, 0.6)];
    let m = vortices.momentum(&x);
    let space = LiePoisson::minus(PowerAlgebra::<_, 3>(So3));
    let rate = space.hamiltonian_vector(&m, &vortices.differential(&m)).0.0;
    for i in 0..3 {
        let term = |j: usize| {
            x[j].cross(&x[i]) * strengths[j]
                / (4.0 * core::f64::consts::PI * (1.0 - x[i].dot(&x[j])))
        };
        let expected: Vector3<f64> = (0..3).filter(|&j| j != i).map(term).sum();
        assert!((rate[i] / strengths[i] - expected).norm() < 1e-15);
    }
}

/// Twelve unit vectors in general position.
fn spins() -> Spins<12> {
    Covector(Power(from_fn(|i| {
        let i = i as f64;
        Vector3::new((1.3 * i).cos(), (2.1 * i + 0.4).sin(), (0.7 * i).sin() - 0.3).normalize()
    })))
}

#[test]
fn the_chain_conserves_the_total_spin_where_it_is_isotropic() {
    let map = PowerMap::<_, 12>(QuadraticMomentumMap::new(So3OnC2, Side::Left));
    let total = |h: &HeisenbergChain<12>, s: &Spins<12>| {
        let sum: Vector3<f64> = s.0.0.iter().sum();
        [h.value(s), sum.x, sum.y, sum.z]
    };
    for scheme in schemes() {
        let isotropic = HeisenbergChain::new(1.0, Vector3::zeros()).unwrap();
        let [energy, x, y, z] = drifts(&scheme, map, isotropic, &spins(), (0.05, 500), total);
        assert!(larger(larger(x, y), z) < ROUND_OFF, "{x:e} {y:e} {z:e}");
        assert!(energy < energy_bound(&scheme, 0.05), "{energy:e}");
        let field = HeisenbergChain::new(1.0, Vector3::z()).unwrap();
        let [energy, x, _, z] = drifts(&scheme, map, field, &spins(), (0.05, 500), total);
        assert!(z < ROUND_OFF && x > 0.1, "only the component along the field is conserved");
        assert!(energy < energy_bound(&scheme, 0.05), "{energy:e}");
    }
}

#[test]
fn spins_precess_to_the_right_about_a_field() {
    // Bracket {s_a, s_b} = ε_abc s_c and h = −B·s: ṡ = s × B, Larmor precession.
    let chain = HeisenbergChain::<1>::new(0.0, Vector3::z()).unwrap();
    let space = LiePoisson::plus(PowerAlgebra::<_, 1>(So3));
    let s = Covector(Power([Vector3::<f64>::x()]));
    let rate = space.hamiltonian_vector(&s, &chain.differential(&s));
    assert_eq!(rate.0.0[0], Vector3::x().cross(&Vector3::z()));
}

#[test]
fn the_spin_lattice_conserves_both_momenta() {
    const N: usize = 6;
    let lattice = SpinLattice::<N>::new(1.0, 2.0, 1.0, 0.5).unwrap();
    let map = ProductMap(
        PowerMap::<_, N>(QuadraticMomentumMap::new(So3OnC2, Side::Left)),
        Identity(CotangentBundle(RealSpace::<N>)),
    );
    let s = spins().0.0;
    let q = SVector::from_fn(|i, _| 0.1 * (i as f64).cos());
    let p = SVector::from_fn(|i, _| 0.2 * (2.0 * i as f64).sin());
    let start = Pair(Covector(Power(from_fn(|i| s[i]))), Cotangent::new(q, Covector(p)));
    for scheme in schemes() {
        let [energy, x, y, z, p] =
            drifts(&scheme, map, Automatic(lattice), &start, (0.05, 200), |h, state| {
                let sum: Vector3<f64> = state.0.0.0.iter().sum();
                [h.value(state), sum.x, sum.y, sum.z, state.1.p.0.sum()]
            });
        assert!(larger(larger(x, y), larger(z, p)) < ROUND_OFF, "{x:e} {y:e} {z:e} {p:e}");
        assert!(energy < energy_bound(&scheme, 0.05), "{energy:e}");
    }
}

#[test]
fn an_explicit_method_conserves_none_of_it() {
    let rk4 = RungeKutta::rk4();
    let isotropic = HeisenbergChain::new(1.0, Vector3::zeros()).unwrap();
    let map = PowerMap::<_, 12>(QuadraticMomentumMap::new(So3OnC2, Side::Left));
    let [length] = drifts(&rk4, map, isotropic, &spins(), (0.1, 500), |_, s| [s.0.0[0].norm()]);
    assert!(length > 1e3 * ROUND_OFF, "{length:e}");
}
