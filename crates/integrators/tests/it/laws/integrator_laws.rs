//! The law suites of schemes, integrators and batches, which every type of the crate obeys. The modules `faulty_schemes`
//! and `faulty_integrators` have something for each law that breaks it.
//!
//! The other tests of schemes run [`laws::scheme`] too, by `keeps_its_promises`.

use crate::support::{ROUND_OFF, field, keeps_its_promises, laws, start};
use collective_integrators::*;
use core::ops::Range;
use core::sync::atomic::{AtomicUsize, Ordering};
use lie_poisson::*;
use momentum_map::{Cotangent, HOPF, Quaternions};
use nalgebra::{Vector1, Vector2, Vector3};

/// A rigid body with h(Π) = ½Π₁² + Π₂² + ³⁄₁₀ Π₁Π₃.
#[derive(Clone, Copy)]
pub(crate) struct Body;

impl Energy for Body {
    type Space = LiePoisson<So3>;
    fn energy<T: Real>(&self, Covector(pi): &Covector<Vector3<T>>) -> T {
        pi.x * pi.x * 0.5 + pi.y * pi.y + pi.x * pi.z * 0.3
    }
}

type Momentum = Covector<Vector3<f64>>;

pub(crate) fn momenta() -> [Momentum; 2] {
    [Vector3::new(0.6, 0.0, 0.8), Vector3::new(1.0, -0.5, 1.3)].map(Covector)
}

/// The energy of two copies of so(3)∗, for the spherical midpoint method.
#[derive(Clone, Copy)]
struct Spins;

impl Energy for Spins {
    type Space = LiePoisson<PowerAlgebra<So3, 2>>;
    fn energy<T: Real>(&self, Covector(Power([s, t])): &Covector<Power<Vector3<T>, 2>>) -> T {
        s.dot(t) * 0.7 + s.x * s.x * 0.5 + t.y * t.z
    }
}

/// The flows of the two parts of dq/dt = p, dp/dt = −q − q³.
#[derive(Clone, Copy)]
struct Spring;

impl<T: Real> ExactFlows<T> for Spring {
    type Point = Vector2<T>;
    const COUNT: usize = 2;
    fn flow(&self, index: usize, t: f64, z: &Vector2<T>) -> Vector2<T> {
        match index {
            0 => Vector2::new(z.x + z.y * t, z.y),
            1 => Vector2::new(z.x, z.y - (z.x + z.x * z.x * z.x) * t),
            _ => *z,
        }
    }
}

pub(crate) fn points() -> [Vector2<f64>; 2] {
    [Vector2::new(0.7, -0.2), Vector2::new(-0.3, 0.9)]
}

/// The size of the steps.
pub(crate) const STEP: f64 = 0.1;

#[test]
fn the_generic_system_of_the_suites_obeys_those_of_hamiltonians() {
    let system = Automatic(laws::GenericSystem);
    let report = lie_poisson::laws::hamiltonian(&system, &[start(), -start()]);
    report.unwrap().check(ROUND_OFF).unwrap();
}

#[test]
#[ignore = "long"]
fn schemes_of_high_order_obey_their_laws() {
    for stages in 4..=8 {
        laws::scheme(&RungeKutta::gauss(stages).unwrap()).check(ROUND_OFF).unwrap();
    }
    for stages in 2..=4 {
        let lobatto = RungeKutta::new(Tableau::lobatto_iiia(stages).unwrap());
        keeps_its_promises(&lobatto, "Lobatto IIIA");
    }
    let tenth = Substeps::sofroniou_spaletta10();
    laws::scheme(&Composition::new(RungeKutta::implicit_midpoint(), tenth))
        .check(ROUND_OFF)
        .unwrap();
}

#[test]
fn schemes_that_say_so_are_equivariant() {
    let semiexplicit = Tableau::semiexplicit(&Substeps::yoshida4()).unwrap();
    let methods = [
        RungeKutta::explicit_midpoint(),
        RungeKutta::rk4(),
        RungeKutta::dop853(),
        RungeKutta::gauss(3).unwrap(),
        RungeKutta::qin_zhang(),
        RungeKutta::new(semiexplicit),
        RungeKutta::new(Tableau::lobatto_iiia(3).unwrap()),
    ];
    for method in methods {
        laws::equivariant_scheme(&method).check(ROUND_OFF).unwrap();
        let composed = Composition::new(method, Substeps::suzuki4());
        laws::equivariant_scheme(&composed).check(ROUND_OFF).unwrap();
    }
}

/// Checks the laws of an integrator over `f64` and over SIMD lanes.
fn integrator_laws<I, V>(integrator: I, momenta: &[V])
where
    I: Start<f64, State: Vector, Momentum = V>,
    Laned<I>: BatchIntegrator<Member = <I as Integrator>::State>,
    V: Vector<Scalar = f64>,
{
    laws::start(&integrator, momenta, STEP).unwrap().check(ROUND_OFF).unwrap();
    let start = |mu: &V| Start::<f64>::start(&integrator, mu).unwrap();
    let members: Vec<_> = momenta.iter().map(start).collect();
    let failing = members[0].scaled(f64::NAN);
    let batch = Laned::widest(integrator);
    laws::batch(&batch, &members, &failing, STEP).unwrap().check(0.0).unwrap();
}

#[test]
#[ignore = "long"]
fn schemes_applied_to_the_equations() {
    let (z, direct) = (start(), |scheme| Direct::new(scheme, field()));
    integrator_laws(direct(RungeKutta::rk4()), &[z, -z]);
    integrator_laws(direct(RungeKutta::gauss(2).unwrap()), &[z, -z]);
    integrator_laws(direct(RungeKutta::gauss(2).unwrap()).compensated(), &[z, -z]);
    let lobatto = PartitionedRungeKutta::<FirstHalf>::lobatto_iiia_iiib(3).unwrap();
    integrator_laws(Direct::new(lobatto, field()), &[z, -z]);
    let composed = Composition::new(RungeKutta::implicit_midpoint(), Substeps::suzuki4());
    integrator_laws(Direct::new(composed, field()).compensated(), &[z, -z]);
}

#[test]
#[ignore = "long"]
fn collective_integrators_with_and_without_a_lift() {
    let gauss = || RungeKutta::gauss(2).unwrap();
    let collective = || Collective::new(gauss(), HOPF, Automatic(Body));
    let lift_free = || LiftFree::new(gauss(), Quaternions, Automatic(Body));
    integrator_laws(collective(), &momenta());
    integrator_laws(collective().compensated(), &momenta());
    integrator_laws(lift_free(), &momenta());
    integrator_laws(lift_free().compensated(), &momenta());
    let composed = Composition::new(RungeKutta::implicit_midpoint(), Substeps::suzuki4());
    integrator_laws(LiftFree::new(composed.clone(), Quaternions, Automatic(Body)), &momenta());
    integrator_laws(Collective::new(composed, HOPF, Automatic(Body)), &momenta());
    let verlet = PartitionedRungeKutta::<Alternating>::kick_drift_kick();
    let on_phase_space = Collective::that_does_not_descend(verlet, HOPF, Automatic(Body));
    integrator_laws(on_phase_space, &momenta());
}

#[test]
fn splittings_and_the_spherical_midpoint_method() {
    integrator_laws(Splitting::lie_trotter(Spring), &points());
    integrator_laws(Splitting::strang(Spring), &points());
    integrator_laws(Composition::new(Splitting::strang(Spring), Substeps::kahan_li6()), &points());
    let alternating = Splitting::alternating(Spring, AlternatingSubsteps::blanes_moan6());
    integrator_laws(alternating, &points());
    let tao = TaoFlows::<_, FirstHalf>::new(field(), 10.0);
    integrator_laws(Splitting::strang(tao), &[TaoFlows::copied(start())]);
    let space = LiePoisson::minus(PowerAlgebra::<_, 2>(So3));
    let field = HamiltonianField { space, hamiltonian: Automatic(Spins) };
    let spins = Covector(Power([Vector3::new(0.6, 0.0, 0.8), Vector3::new(-0.5, 0.7, 1.1)]));
    integrator_laws(SphericalMidpoint::new(field), &[spins]);
}

/// The vector field ẋ = x², whose solution is infinite at t = 1/x.
#[derive(Clone, Copy)]
struct BlowUp;

impl<T: Real> VectorField<T> for BlowUp {
    type Point = Vector1<T>;
    fn at(&self, x: &Vector1<T>) -> Vector1<T> {
        x.component_mul(x)
    }
}

#[test]
fn a_member_that_fails_after_some_steps() {
    // The second method predicts its stages from the steps before: neither the prediction nor the field solves them.
    for scheme in [RungeKutta::implicit_midpoint(), RungeKutta::gauss(2).unwrap()] {
        let batch = Laned::widest(Direct::new(scheme, BlowUp));
        let (members, failing) = ([-1.0, 0.001, -0.3].map(Vector1::new), Vector1::new(1.0));
        let mut failed_at = Vec::new();
        let mut report = |_, error: IntegrationError| failed_at.push(error.step);
        batch.advance(&mut [failing], STEP, 0..20, &mut batch.workspace(), &mut report);
        assert!(failed_at.len() == 1 && failed_at[0] > 1, "{failed_at:?}");
        laws::batch(&batch, &members, &failing, STEP).unwrap().check(0.0).unwrap();
    }
}

#[test]
fn casimirs_are_invariants_of_collective_integrators() {
    let casimir = |Covector(pi): &Momentum| pi.norm_squared();
    let gauss = || RungeKutta::gauss(2).unwrap();
    let lift_free = LiftFree::new(gauss(), Quaternions, Automatic(Body));
    laws::invariants(&lift_free, &momenta(), STEP, &[&casimir]).unwrap().check(ROUND_OFF).unwrap();
    let collective = Collective::new(gauss(), HOPF, Automatic(Body));
    let lifts = momenta().map(|mu| collective.start(&mu).unwrap());
    laws::invariants(&collective, &lifts, STEP, &[&casimir]).unwrap().check(ROUND_OFF).unwrap();
    // Negative controls: a function that is no invariant, and a method whose steps fail.
    let energy = |mu: &Momentum| Body.energy(mu);
    let report = laws::invariants(&lift_free, &momenta(), 0.5, &[&casimir, &energy]).unwrap();
    assert!(report.residual("invariants").unwrap() > 1e-6);
    let nowhere = Direct::new(RungeKutta::rk4(), from_fn(|z: &Vector2<f64>| z * f64::NAN));
    let report = laws::invariants(&nowhere, &points(), STEP, &[&|z: &Vector2<f64>| z.x]).unwrap();
    assert!(report.residual("invariants").unwrap().is_nan());
}

/// In any unit u, the function 3x − y has the value u at (u, 2u), and changes by 3u and −2u when a coordinate is doubled.
#[test]
fn residuals_of_invariants_are_relative_to_the_largest_change() {
    for unit in [2.0_f64.powi(-20), 1.0, 2.0_f64.powi(20)] {
        let drift = from_fn(|_: &Vector2<f64>| Vector2::new(unit, 0.0));
        let direct = Direct::new(RungeKutta::explicit_midpoint(), drift);
        let start = [Vector2::new(unit, 2.0 * unit)];
        let report = laws::invariants(&direct, &start, 1.0 / 128.0, &[&|z| 3.0 * z.x - z.y]);
        // 100 steps change it by 300/128 units, without rounding.
        assert_eq!(report.unwrap().residual("invariants"), Some(100.0 / 128.0), "{unit:e}");
    }
}

/// An oscillator that counts how often it is asked for its field.
struct Counted<'a>(&'a AtomicUsize);

impl<T: Real> VectorField<T> for Counted<'_> {
    type Point = Vector2<T>;
    fn at(&self, z: &Vector2<T>) -> Vector2<T> {
        self.0.fetch_add(1, Ordering::Relaxed);
        Vector2::new(z.y, -z.x)
    }
}

/// The members of a group share each evaluation of the field.
#[test]
fn members_of_a_batch_advance_together() {
    let calls = AtomicUsize::new(0);
    let batch = Laned::new(Direct::new(RungeKutta::rk4(), Counted(&calls)));
    let mut members: Vec<_> = (1..=9).map(|x| Vector2::new(f64::from(x), 0.0)).collect();
    let mut fails = |member, error| panic!("{member}: {error}");
    batch.advance(&mut members, STEP, 0..10, &mut batch.workspace(), &mut fails);
    let groups = members.len().div_ceil(DefaultLanes::COUNT);
    // Ten steps of four stages.
    assert_eq!(calls.load(Ordering::Relaxed), groups * 10 * 4);
}

/// A kernel that counts its calls, and notes the number of lanes.
#[derive(Default)]
struct Calls {
    made: AtomicUsize,
    lanes: AtomicUsize,
}

impl LaneKernel for Calls {
    type Member = f64;

    fn together<T: Lanes>(&self, group: &mut [f64], _: f64, _: u64) -> LaneResults {
        self.made.fetch_add(1, Ordering::Relaxed);
        self.lanes.store(T::COUNT, Ordering::Relaxed);
        assert!(group.len() <= T::COUNT);
        [true; MOST_LANES]
    }

    fn alone(&self, _: &mut f64, _: f64, _: Range<u64>) -> Result<(), IntegrationError> {
        panic!("every member has a result")
    }
}

#[test]
fn a_kernel_gets_groups_that_fill_its_registers() {
    for (set, width) in InstructionSet::available().flat_map(|set| Width::ALL.map(|w| (set, w))) {
        let calls = Calls::default();
        let registers = Registers::new(set, width).unwrap();
        let mut members = [0.0; 4 * MOST_LANES + 1];
        registers.advance(&calls, &mut members, STEP, 0..1, &mut |_, _| ());
        let lanes = calls.lanes.into_inner();
        assert_eq!(calls.made.into_inner(), members.len().div_ceil(lanes), "{set} {width:?}");
    }
}

/// Hamilton's equations of the documented energy of [`laws::GenericSystem`], differentiated by hand.
#[test]
fn the_generic_system_moves_by_its_equations() {
    let (q, p) = (Vector2::new(0.7, -1.3), Vector2::new(-0.4, 0.9));
    let rate = laws::GenericSystem::field().at(&Cotangent::new(q, Covector(p)));
    let q_dot = Vector2::new((q.x * q.x + 1.0) * p.x, p.y + 0.3 * q.x * q.y);
    let p_dot = Vector2::new(
        -q.x * (p.x * p.x + 1.0) - 0.3 * q.y * p.y,
        -q.y - 0.4 * q.y.powi(3) - 0.3 * q.x * p.y,
    );
    // A few sums of numbers near 1.
    assert!((rate.q - q_dot).amax() < 1e-15, "{rate:?}");
    assert!((rate.p.0 - p_dot).amax() < 1e-15, "{rate:?}");
}
