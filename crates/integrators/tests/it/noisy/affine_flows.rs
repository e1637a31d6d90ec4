//! Flows of affine fields, and with them those of constant noise, against closed forms.

use super::support::{AXIS, AboutAxis, Axial, Told, isotropic, on_path};
use collective_integrators::{
    BrownianPaths, Integrator, NoiseRule, Noisy, RungeKutta, Start, StepError, affine_flow,
};
use lie_poisson::generic_scalars::{DefaultLanes, Lanes};
use lie_poisson::{
    Covector, Differential, DualNumber, LieGroup, LiePoisson, OrbitField, Pair, Point,
    PoissonSpace, Real, RealSpace, SE3, SL2, Se3, Se3Dual, State, Vector, derivative_part,
    map_coordinates,
};
use momentum_map::{
    GroupAction, HOPF, MomentumMap, PARTICLE, PoissonMap, PowerMap, Side, SourcePoint,
};
use nalgebra::{Matrix2, Matrix3, Rotation3, Vector1, Vector3};

fn flow<V: State>(field: impl Fn(&V) -> V, time: f64, z: &V) -> V {
    let mut z = z.clone();
    affine_flow(|v, rate| *rate = field(v), time, &mut z).unwrap();
    z
}

/// Turns by any angle: each of its parts, of a radian and more, has some rounding errors.
#[test]
fn turns_are_exact_for_every_angle() {
    let z = Vector3::new(0.3, -0.5, 0.7);
    for angle in [0.0, 1e-300, 1e-9, 0.3, 2.0, 2.5, -3.0, 20.0, 1e3] {
        let turned = flow(|v: &Vector3<f64>| AXIS.cross(v), angle, &z);
        let exact = Rotation3::new(AXIS * angle) * z;
        let allowed = 3e-16 * (4.0 + f64::abs(angle));
        assert!((turned - exact).norm() < allowed, "{angle}: {:e}", (turned - exact).norm());
        assert!((turned.norm() - z.norm()).abs() < allowed);
        // Control: the sum without its term of order 2.
        let short = z + AXIS.cross(&z) * angle;
        assert!(angle.abs() < 0.1 || (short - exact).norm() > 1e-3);
    }
}

/// Fields that grow, that move, and that have powers of all kinds.
#[test]
fn other_flows_are_exact() {
    let grow = |v: &Vector3<f64>| Vector3::new(v.x * 3.0, v.y * -2.0, v.z);
    let z = Vector3::new(0.3, -0.5, 0.7);
    let grown = flow(grow, 1.5, &z);
    let exact = Vector3::new(0.3 * 4.5_f64.exp(), -0.5 * (-3.0_f64).exp(), 0.7 * 1.5_f64.exp());
    assert!((grown - exact).component_div(&exact).amax() < 1e-14, "{grown} {exact}");
    // x' = y, y' = z, z' = 2 from the origin, in units of any size.
    for unit in [1.0, 1e100, 1e-100] {
        let chain = |v: &Vector3<f64>| Vector3::new(v.y, v.z, 2.0 * unit);
        let moved = flow(chain, 3.0, &Vector3::zeros()) / unit;
        assert!((moved - Vector3::new(9.0, 9.0, 6.0)).norm() < 1e-14, "{moved}");
    }
}

/// exp(sξ) acts on se(3)∗ by Π ↦ Rᵀ(Π + Γ × a), Γ ↦ RᵀΓ, also where Γ × b = 0 at first and Π is at rest.
#[test]
fn coadjoint_flows_are_those_of_the_group() {
    let space = LiePoisson::minus(Se3::default());
    let xi = Pair(Vector3::new(0.3, -0.2, 0.5), Vector3::new(0.1, 0.7, -0.4));
    for mu in [
        Se3Dual::new(Vector3::new(0.2, 0.4, -0.3), Vector3::new(0.6, 0.0, 0.8)),
        Se3Dual::new(Vector3::zeros(), xi.1),
        Se3Dual::new(Vector3::zeros(), Vector3::zeros()),
    ] {
        let step = 1.7;
        let moved = flow(|mu: &Se3Dual| space.hamiltonian_vector::<f64>(mu, &xi), step, &mu);
        let g = SE3::default().exp(&xi.scaled(step));
        let rotation: Matrix3<f64> = g.0.transpose();
        let Covector(Pair(pi, gamma)) = mu;
        let exact = Se3Dual::new(rotation * (pi + gamma.cross(&g.1)), rotation * gamma);
        assert!((moved - exact).max_abs() < 1e-15, "{moved:?} {exact:?}");
    }
}

#[test]
fn lanes_have_the_bits_of_single_flows_and_dual_numbers_the_derivative() {
    // Lanes that need no part, one, several, and none at all.
    let angles = [0.3, 40.0, 0.0, 2.4];
    let start = |i: usize| Vector3::new(0.3 + i as f64, -0.5, -0.0);
    let alone = |i: usize| flow(|v: &Vector3<f64>| v.cross(&(AXIS * angles[i])), 1.0, &start(i));
    let lanes = Vector3::from_fn(|j, _| DefaultLanes::from_lanes(|i| start(i)[j]));
    let axis = Vector3::from_fn(|j, _| DefaultLanes::from_lanes(|i| AXIS[j] * angles[i]));
    let together = flow(|v: &Vector3<DefaultLanes>| v.cross(&axis), 1.0, &lanes);
    for i in 0..4 {
        let lane = together.map(|x| x.lane(i));
        assert_eq!(lane.map(f64::to_bits), alone(i).map(f64::to_bits), "{i}");
    }
    let (z, v) = (start(1), Vector3::new(1e3, 2.0, 3.0));
    let seeded = Vector3::from_fn(|j, _| DualNumber::new(z[j], v[j]));
    let axis: Vector3<DualNumber> = map_coordinates(&AXIS, DualNumber::constant);
    let moved = flow(|v: &Vector3<DualNumber>| v.cross(&axis), 1.3, &seeded);
    let tangent: Vector3<f64> = derivative_part(&moved);
    assert!((tangent - flow(|v: &Vector3<f64>| v.cross(&AXIS), 1.3, &v)).norm() < 1e-12);
}

#[test]
fn what_is_not_finite_is_refused_and_the_point_is_left() {
    for (time, start) in [(f64::NAN, 1.0), (f64::INFINITY, 1.0), (1.0, f64::NAN), (1e300, 1.0)] {
        let mut z = Vector3::new(start, 2.0, 3.0);
        let before = z;
        let made = affine_flow(|v: &Vector3<f64>, rate| *rate = v.cross(&AXIS), time, &mut z);
        assert_eq!(made, Err(StepError::NotFinite), "{time} {start}");
        assert!(start.is_nan() || z == before);
    }
    let mut z = Vector3::x();
    assert!(affine_flow(|_, rate| *rate = Vector3::repeat(f64::NAN), 1.0, &mut z).is_err());
}

/// Without drift a spin turns about the axis by W(t), also in steps that turn it by many radians.
#[test]
fn a_spin_turns_about_a_fixed_axis_exactly() {
    let start = Vector3::new(0.8, 0.6, 0.0);
    for (strength, step) in [(0.5, 0.1), (3.0, 1.0), (20.0, 1.0)] {
        let paths = BrownianPaths::new(7, step).unwrap();
        let midpoint = RungeKutta::implicit_midpoint();
        let spin = Noisy::new(midpoint, HOPF, Axial(0.0), AboutAxis(strength), paths);
        let spin = spin.with_rule(NoiseRule::Alternating);
        let end = spin.after(&on_path(Covector(start), 3), step, 40).unwrap().momentum.0.0;
        // The second component is the coin.
        let mut motion = [0.0; 2];
        paths.write_increments(3, 0.0, 40.0, &mut motion);
        let exact = Rotation3::new(AXIS * (-strength * motion[0])) * start;
        // Forty steps of some roundings of their turns.
        let allowed = 1e-14 * (1.0 + strength);
        assert!((end - exact).norm() < allowed, "{strength}: {:e}", (end - exact).norm());
        assert!(motion[0].abs() > 0.1);
    }
}

/// The action of SL(2) on a line, q ↦ (aq + b)/(cq + d), whose generators are not affine.
#[derive(Clone)]
struct Projective;

impl GroupAction for Projective {
    type Group = SL2;
    type Space = RealSpace<1>;
    const SIDE: Side = Side::Left;

    fn group(&self) -> SL2 {
        SL2
    }

    fn space(&self) -> RealSpace<1> {
        RealSpace
    }

    fn act<T: Real>(&self, g: &Matrix2<T>, q: &Vector1<T>) -> Vector1<T> {
        Vector1::new((g.m11 * q.x + g.m12) / (g.m21 * q.x + g.m22))
    }
}

/// No drift.
struct Still;

impl<P: PoissonSpace, T: Real> OrbitField<P, T> for Still {
    fn element(&self, _: &Point<P, T>, _: T) -> Differential<P, T> {
        Vector::zero()
    }
}

/// Returns whether a step with noise that says that it is constant differs from that of the scheme.
fn has_flows<M: PoissonMap>(map: M) -> bool {
    let z = SourcePoint::<M>::from_coordinates(|i| 0.3 + 0.2 * i as f64);
    let paths = BrownianPaths::new(7, 0.1).unwrap();
    let [one, other] = [true, false].map(|is_constant| {
        let noise = Told { noise: isotropic(0.7), is_constant };
        let midpoint = RungeKutta::implicit_midpoint();
        let noisy = Noisy::new(midpoint, map.clone(), Still, noise, paths);
        let noisy = noisy.with_rule(NoiseRule::Alternating);
        noisy.step(&on_path(z, 2), 0.1, &mut noisy.workspace()).unwrap().point.0
    });
    assert!((one - other).max_abs() < 0.1 && (one - z).max_abs() > 1e-3);
    one != other
}

/// If the generators of the map are not affine, the scheme makes the steps.
#[test]
fn generators_that_are_not_affine_are_left_to_the_scheme() {
    assert!(has_flows(HOPF) && has_flows(PARTICLE) && has_flows(PowerMap::<_, 2>(HOPF)));
    assert!(!has_flows(MomentumMap(Projective)));
}
