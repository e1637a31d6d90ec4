//! §4.2–4.3: the symmetries of the collective Hamiltonian and their momenta J₁, J₂, J₃.

use heavytop::{HeavyTop, Invariant, SpinorPoint, SpinorRealisation};
use lie_poisson::{
    Covector, DualNumber, LieAlgebra, LieGroup, Pair, PoissonSpace, Real, Se3Dual, Vector,
    derivative_part, differential, map_coordinates,
};
use momentum_map::{CotangentLift, FibreSymmetry, GroupAction, MomentumMap, PoissonMap, Side};
use nalgebra::{Vector1, Vector2, Vector3};
use num_complex::Complex;
use proptest::prelude::*;
use workspace_tests::{OneForm, assert_close, assert_near, persistent, point, tops};

/// The round-off of a few products of numbers up to 20.
const ROUND_OFF: f64 = 1e-14;

const M: SpinorRealisation = SpinorRealisation;

/// The Lie algebra R of the circle.
#[derive(Clone)]
struct Line;

impl LieAlgebra for Line {
    type Element<T: Real> = Vector1<T>;

    fn bracket<T: Real>(&self, _: &Vector1<T>, _: &Vector1<T>) -> Vector1<T> {
        Vector1::zeros()
    }
}

/// The circle group S¹ = {e^{iθ}}, defined with the public interface alone.
#[derive(Clone)]
struct Circle;

impl LieGroup for Circle {
    type Algebra = Line;
    type Element<T: Real> = Vector1<Complex<T>>;

    fn algebra(&self) -> Line {
        Line
    }

    fn identity<T: Real>(&self) -> Vector1<Complex<T>> {
        Vector1::new(Complex { re: T::one(), im: T::zero() })
    }

    fn compose<T: Real>(
        &self,
        g: &Vector1<Complex<T>>,
        h: &Vector1<Complex<T>>,
    ) -> Vector1<Complex<T>> {
        Vector1::new(g.x * h.x)
    }

    fn inverse<T: Real>(&self, g: &Vector1<Complex<T>>) -> Vector1<Complex<T>> {
        Vector1::new(g.x.conj())
    }

    fn exp<T: Real>(&self, angle: &Vector1<T>) -> Vector1<Complex<T>> {
        let square = angle.x * angle.x;
        Vector1::new(Complex { re: square.stumpff(0), im: angle.x * square.stumpff(1) })
    }

    fn adjoint<T: Real>(&self, _: &Vector1<Complex<T>>, xi: &Vector1<T>) -> Vector1<T> {
        *xi
    }
}

/// The action of e^{iθ} on C²: (e^{iθ}χ₁, e^{iθ}χ₂), or (e^{iθ}χ₁, e^{−iθ}χ₂) if `opposite`.
#[derive(Clone)]
struct Phase {
    opposite: bool,
}

impl GroupAction for Phase {
    type Group = Circle;
    type Space = lie_poisson::ComplexSpace<2>;
    const SIDE: Side = Side::Left;

    fn group(&self) -> Circle {
        Circle
    }

    fn space(&self) -> Self::Space {
        lie_poisson::ComplexSpace
    }

    fn act<T: Real>(
        &self,
        g: &Vector1<Complex<T>>,
        chi: &Vector2<Complex<T>>,
    ) -> Vector2<Complex<T>> {
        let second = if self.opposite { g.x.conj() } else { g.x };
        Vector2::new(g.x * chi.x, second * chi.y)
    }
}

/// Returns the invariant J₃ = Im(χ₂ψ̄₂ − χ₁ψ̄₁).
fn j3<T: Real>(z: &SpinorPoint<T>) -> T {
    let (chi, psi) = (&z.q, &z.p.0);
    (chi.y * psi.y.conj() - chi.x * psi.x.conj()).im
}

fn rotated<T: Real>(action: &Phase, angle: T, z: &SpinorPoint<T>) -> SpinorPoint<T> {
    let g = Circle.exp(&Vector1::new(angle));
    CotangentLift(action.clone()).act::<T>(&g, z)
}

fn energy(top: &HeavyTop, z: &SpinorPoint) -> f64 {
    Invariant::Energy.value(top, &M.apply(z))
}

/// Returns the velocity d/ds flow(s) at s = 0.
fn velocity(
    flow: impl Fn(DualNumber, &SpinorPoint<DualNumber>) -> SpinorPoint<DualNumber>,
    z: &SpinorPoint,
) -> SpinorPoint {
    let z = map_coordinates(z, DualNumber::constant);
    derivative_part(&flow(DualNumber::variable(0.0), &z))
}

fn top(
    make: impl FnOnce() -> Result<HeavyTop, heavytop::TopError>,
) -> Result<HeavyTop, TestCaseError> {
    make().map_err(|e| TestCaseError::fail(e.to_string()))
}

proptest! {
    #![proptest_config(persistent())]

    /// M, and with it H of any top, is invariant under χ + bψ and under the common phase.
    #[test]
    fn the_fibre_flows_leave_m_alone(z in point::<SpinorPoint>(), s in -3.0..3.0_f64) {
        let generic = top(tops::generic)?;
        for index in 0..SpinorRealisation::COUNT {
            let moved = M.flow(index, s, &z);
            // χ + bψ is up to 12 long, and b‖ψ‖² cancels.
            assert_near(&M.apply(&moved), &M.apply(&z), 3e-14);
            assert_close(energy(&generic, &moved), energy(&generic, &z), 1e-13);
            // The flows are one-parameter groups, which commute.
            let twice = M.flow(index, 0.5 * s, &M.flow(index, 0.5 * s, &z));
            assert_near(&twice, &moved, ROUND_OFF);
            let other = 1 - index;
            assert_near(
                &M.flow(other, 0.7, &moved),
                &M.flow(index, s, &M.flow(other, 0.7, &z)),
                ROUND_OFF,
            );
        }
    }

    /// The Hamiltonian vector fields of J₁ and J₂ generate the flows.
    #[test]
    fn the_momenta_generate_the_flows(z in point::<SpinorPoint>()) {
        for index in 0..SpinorRealisation::COUNT {
            let dj = differential(|z| M.momentum::<DualNumber>(index, z), &z);
            let field = M.source().hamiltonian_vector::<f64>(&z, &dj);
            assert_near(&field, &velocity(|s, z| M.flow(index, s, z), &z), ROUND_OFF);
        }
        let dj = differential(j3::<DualNumber>, &z);
        let field = M.source().hamiltonian_vector::<f64>(&z, &dj);
        let axial = Phase { opposite: true };
        assert_near(&field, &velocity(|s, z| rotated(&axial, s, z), &z), ROUND_OFF);
        // v ψ_i ∂/∂χ_i = v p_j ∂/∂q_j
        let slide = velocity(|s, z| M.flow(0, s, z), &z);
        assert_near(&slide.q, &z.p.0, 0.0);
        assert_near(&slide.p, &Covector(Vector2::zeros()), 0.0);
    }

    /// J₂ and J₃ are the momentum maps of the cotangent-lifted circle actions, derived.
    #[test]
    fn the_circle_actions_have_these_momentum_maps(z in point::<SpinorPoint>(), s in -3.0..3.0_f64) {
        let [common, axial] = [false, true].map(|opposite| Phase { opposite });
        let derived = |action: &Phase| MomentumMap(action.clone()).apply::<f64>(&z).0.x;
        assert_close(derived(&common), M.momentum(1, &z), ROUND_OFF);
        assert_close(derived(&axial), j3(&z), ROUND_OFF);
        assert_near(&rotated(&common, s, &z), &M.flow(1, s, &z), ROUND_OFF);
        for action in [&common, &axial] {
            let lift = |z: &SpinorPoint<DualNumber>| rotated(action, DualNumber::constant(s), z);
            prop_assert!(OneForm::Theta1.defect(lift, &z) <= ROUND_OFF);
        }
    }

    /// The momenta give the invariants: F₁ = 4J₁² = f₁∘M, F₂ = J₁J₂ = f₂∘M, F₃ = ½J₃ = f₃∘M.
    #[test]
    fn the_momenta_are_the_known_invariants(z in point::<SpinorPoint>()) {
        let top = top(tops::paper)?;
        let (j1, j2) = (M.momentum(0, &z), M.momentum(1, &z));
        let (chi, psi) = (z.q, z.p.0);
        assert_close(j1, 0.5 * psi.norm_squared(), 1e-15);
        assert_close(j2, -psi.dotc(&chi).im, ROUND_OFF);
        let f = |invariant: Invariant| invariant.value(&top, &M.apply(&z));
        assert_close(4.0 * j1 * j1, f(Invariant::VerticalSquared), ROUND_OFF);
        assert_close(psi.norm_squared().powi(2), f(Invariant::VerticalSquared), ROUND_OFF);
        // The bound is for 24 products of four numbers up to 3.
        assert_close(j1 * j2, f(Invariant::VerticalMomentum), 5e-14);
        assert_close(0.5 * j3(&z), f(Invariant::AxialMomentum), ROUND_OFF);
    }

    /// Θ₂ is invariant under χ + bψ; erratum 2: J₁ = Θ₂·v, while Θ₁·v is twice as much.
    #[test]
    fn j1_belongs_to_theta_2(z in point::<SpinorPoint>(), b in -3.0..3.0_f64) {
        let flow = |z: &SpinorPoint<DualNumber>| M.flow(0, DualNumber::constant(b), z);
        prop_assert!(OneForm::Theta2.defect(flow, &z) <= 3e-14);
        let generator = velocity(|s, z| M.flow(0, s, z), &z);
        assert_close(OneForm::Theta2.at(&z, &generator), M.momentum(0, &z), ROUND_OFF);
        assert_close(OneForm::Theta1.at(&z, &generator), z.p.0.norm_squared(), ROUND_OFF);
    }

    /// §4.3: H_L is invariant under the axial rotation, which turns Π and Γ about e₃.
    #[test]
    fn a_lagrange_top_has_the_axial_symmetry(z in point::<SpinorPoint>(), s in -3.0..3.0_f64) {
        let lagrange = top(|| HeavyTop::lagrange(1.5, 0.8, 2.0))?;
        let moved = rotated(&Phase { opposite: true }, s, &z);
        assert_close(energy(&lagrange, &moved), energy(&lagrange, &z), 1e-13);
        let turn = nalgebra::Rotation3::from_axis_angle(&Vector3::z_axis(), -2.0 * s);
        let Covector(Pair(pi, gamma)) = M.apply(&z);
        assert_near(&M.apply(&moved), &Se3Dual::new(turn * pi, turn * gamma), ROUND_OFF);
    }
}

/// Negative controls at one generic point: Θ₁ is not invariant under χ + bψ, so that its pairing is not a momentum
/// map; the axial rotation changes M, and H of a generic top; a flow that is not along the fibre changes M.
#[test]
fn other_forms_flows_and_tops_lack_the_symmetry() -> Result<(), TestCaseError> {
    let x = [0.3, -1.1, 0.7, 1.9, -0.4, 1.3, 0.8, -2.1];
    let z = SpinorPoint::from_coordinates(|i| x[i]);
    let flow = |z: &SpinorPoint<DualNumber>| M.flow(0, DualNumber::constant(0.5), z);
    assert!(OneForm::Theta1.defect(flow, &z) > 0.1);
    let moved = rotated(&Phase { opposite: true }, 0.5, &z);
    assert!((M.apply(&moved) - M.apply(&z)).max_abs() > 0.1);
    let generic = top(tops::generic)?;
    assert!((energy(&generic, &moved) - energy(&generic, &z)).abs() > 0.1);
    let mut along = z;
    along.p.0 += z.q.map(|x| x * 0.5);
    assert!((M.apply(&along) - M.apply(&z)).max_abs() > 0.1);
    assert_eq!(M.flow(2, 1.0, &z), z);
    assert_eq!(M.momentum(2, &z), 0.0);
    Ok(())
}
