//! The law suites of schemes, integrators and batches: every type of the crate obeys its laws, and each law rejects
//! something that breaks it.
//!
//! The other tests of schemes run [`laws::scheme`] too, by `keeps_its_promises`.

use crate::support::{ROUND_OFF, field, keeps_its_promises, laws, start};
use collective_integrators::*;
use core::ops::Range;
use lie_poisson::*;
use momentum_map::{HOPF, LiftError, Quaternions};
use nalgebra::{Vector1, Vector2, Vector3};

/// A rigid body with h(Π) = ½Π₁² + Π₂² + ³⁄₁₀ Π₁Π₃.
#[derive(Clone, Copy)]
struct Body;

impl Energy for Body {
    type Space = LiePoisson<So3>;
    fn energy<T: Real>(&self, Covector(pi): &Covector<Vector3<T>>) -> T {
        pi.x * pi.x * 0.5 + pi.y * pi.y + pi.x * pi.z * 0.3
    }
}

type Momentum = Covector<Vector3<f64>>;

fn momenta() -> [Momentum; 2] {
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

fn points() -> [Vector2<f64>; 2] {
    [Vector2::new(0.7, -0.2), Vector2::new(-0.3, 0.9)]
}

/// The size of the steps.
const STEP: f64 = 0.1;

#[test]
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
        laws::equivariance(&method).check(ROUND_OFF).unwrap();
        let composed = Composition::new(method, Substeps::suzuki4());
        laws::equivariance(&composed).check(ROUND_OFF).unwrap();
    }
}

/// Checks the laws of an integrator over `f64` and over SIMD lanes.
fn integrator_laws<I, V>(integrator: I, momenta: &[V])
where
    I: Start<f64, State: Vector, Momentum = V> + Integrator<DefaultLanes, State: Vector> + Sync,
    V: Vector<Scalar = f64>,
{
    laws::start(&integrator, momenta, STEP).unwrap().check(ROUND_OFF).unwrap();
    let start = |mu: &V| Start::<f64>::start(&integrator, mu).unwrap();
    let members: Vec<_> = momenta.iter().map(start).collect();
    let failing = members[0].scaled(f64::NAN);
    let batch = Laned::new(integrator);
    laws::batch(&batch, &members, &failing, STEP).unwrap().check(0.0).unwrap();
}

#[test]
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
struct BlowUp;

impl<T: Real> VectorField<T> for BlowUp {
    type Point = Vector1<T>;
    fn at(&self, x: &Vector1<T>) -> Vector1<T> {
        x.component_mul(x)
    }
}

#[test]
fn a_member_that_fails_after_some_steps() {
    let batch = Laned::new(Direct::new(RungeKutta::implicit_midpoint(), BlowUp));
    let (members, failing) = ([-1.0, 0.001, -0.3].map(Vector1::new), Vector1::new(1.0));
    let mut failed_at = Vec::new();
    let mut report = |_, error: IntegrationError| failed_at.push(error.step);
    batch.advance(&mut [failing], STEP, 0..20, &mut batch.workspace(), &mut report);
    assert!(failed_at.len() == 1 && failed_at[0] > 1, "{failed_at:?}");
    laws::batch(&batch, &members, &failing, STEP).unwrap().check(0.0).unwrap();
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

/// Returns the laws that do not hold in a report.
fn broken(report: &laws::Report) -> Vec<&'static str> {
    let residuals = report.residuals().iter();
    residuals
        .filter(|(_, residual)| residual.is_nan() || *residual > ROUND_OFF)
        .map(|(law, _)| *law)
        .collect()
}

/// The explicit midpoint rule with a fault.
#[derive(Clone, Copy, Debug, PartialEq)]
enum FaultyScheme {
    MovesAtRest,
    HasAnotherStep,
    RefinesElsewhere,
    ClaimsOrderThree,
    ClaimsSymmetry,
    ClaimsSymplecticity,
    ClaimsQuadraticInvariants,
    Remembers,
    MixesLanes,
    HidesFailures,
    AdvancesElsewhere,
    AdvancesBeforeFailure,
}

/// Returns z with `little` added to its first coordinate.
fn shifted<V: State>(z: &V, little: f64) -> V {
    let mut shifted = z.clone();
    shifted.set_entry(0, z.entry(0) + little);
    shifted
}

/// Returns the largest coordinate of a vector, over all lanes.
fn largest<V: State>(z: &V) -> f64 {
    (0..z.dimension()).fold(0.0, |largest, i| larger(largest, z.entry(i).max_abs()))
}

impl Scheme for FaultyScheme {
    type Workspace<V: State> = u32;

    fn workspace<V: State>(&self) -> u32 {
        0
    }

    fn increment<T: Real, F: VectorField<T>>(
        &self,
        field: &F,
        z: &F::Point,
        step: f64,
        made: &mut u32,
    ) -> Result<Step<F::Point>, StepError> {
        *made += 1;
        let base = RungeKutta::explicit_midpoint();
        let mut next = base.increment(field, z, step, &mut base.workspace())?;
        let little = match self {
            Self::MovesAtRest if step == 0.0 => 1e-6,
            Self::Remembers => 1e-12 * step * f64::from(*made),
            Self::MixesLanes => 1e-12 * step * largest(z),
            _ => 0.0,
        };
        next.point = shifted(&next.point, little);
        Ok(next)
    }

    fn refined_increment<T: Real, F: VectorField<T>>(
        &self,
        field: &F,
        z: &F::Point,
        step: f64,
        made: &mut u32,
    ) -> Result<Increment<F::Point>, StepError> {
        let Step { point, iterations } = self.increment(field, z, step, made)?;
        let little = if *self == Self::RefinesElsewhere { 1e-10 } else { 0.0 };
        let rest = shifted(&point.zeros_like(), little);
        Ok(Step { point: Pair(point, rest), iterations })
    }

    fn step<T: Real, F: VectorField<T>>(
        &self,
        field: &F,
        z: &F::Point,
        step: f64,
        made: &mut u32,
    ) -> Result<Step<F::Point>, StepError> {
        let Step { point, iterations } = self.increment(field, z, step, made)?;
        let little = if *self == Self::HasAnotherStep { 1e-12 * step } else { 0.0 };
        let mut end = shifted(&point, little);
        end.add_in_place(z);
        let next = Step { point: end, iterations }.finite();
        if *self == Self::HidesFailures {
            next.or(Ok(Step { point: z.clone(), iterations }))
        } else {
            next
        }
    }

    fn step_in_place<T: Real, F: VectorField<T>>(
        &self,
        field: &F,
        z: &mut F::Point,
        step: f64,
        made: &mut u32,
    ) -> Result<usize, StepError> {
        let next = self.step(field, z, step, made);
        if next.is_err() && *self == Self::AdvancesBeforeFailure {
            z.set_zero();
        }
        let Step { point, iterations } = next?;
        let little = if *self == Self::AdvancesElsewhere { 1e-12 } else { 0.0 };
        *z = shifted(&point, little);
        Ok(iterations)
    }

    fn order(&self) -> usize {
        if *self == Self::ClaimsOrderThree { 3 } else { 2 }
    }

    fn is_symplectic(&self) -> bool {
        *self == Self::ClaimsSymplecticity
    }

    fn is_symmetric(&self) -> bool {
        *self == Self::ClaimsSymmetry
    }

    fn preserves_quadratic_invariants(&self) -> bool {
        *self == Self::ClaimsQuadraticInvariants
    }
}

#[test]
fn laws_of_schemes_reject_what_breaks_them() {
    let cases: [(FaultyScheme, &str); 12] = [
        (FaultyScheme::MovesAtRest, "step of size 0"),
        (FaultyScheme::HasAnotherStep, "step and increment"),
        (FaultyScheme::RefinesElsewhere, "refined increment"),
        (FaultyScheme::ClaimsOrderThree, "order"),
        (FaultyScheme::ClaimsSymmetry, "symmetry"),
        (FaultyScheme::ClaimsSymplecticity, "symplecticity"),
        (FaultyScheme::ClaimsQuadraticInvariants, "quadratic invariants"),
        (FaultyScheme::Remembers, "forgetting"),
        (FaultyScheme::MixesLanes, "lanes"),
        (FaultyScheme::HidesFailures, "refusal"),
        (FaultyScheme::AdvancesElsewhere, "step in place"),
        (FaultyScheme::AdvancesBeforeFailure, "step in place"),
    ];
    for (scheme, law) in cases {
        let report = laws::scheme(&scheme);
        assert!(broken(&report).contains(&law), "{scheme:?}");
        let others = if scheme == FaultyScheme::HidesFailures { 2 } else { 1 };
        assert_eq!(broken(&report).len(), others, "{scheme:?}");
    }
}

/// A partitioned method that wrongly claims to commute with changes of variables.
#[derive(Clone)]
struct MixesNothing(PartitionedRungeKutta<FirstHalf>);

impl Equivariant for MixesNothing {}

impl Scheme for MixesNothing {
    type Workspace<V: State> = ();

    fn workspace<V: State>(&self) {}

    fn increment<T: Real, F: VectorField<T>>(
        &self,
        field: &F,
        z: &F::Point,
        step: f64,
        (): &mut (),
    ) -> Result<Step<F::Point>, StepError> {
        self.0.increment(field, z, step, &mut self.0.workspace())
    }

    fn order(&self) -> usize {
        self.0.order()
    }

    fn is_symplectic(&self) -> bool {
        self.0.is_symplectic()
    }

    fn is_symmetric(&self) -> bool {
        self.0.is_symmetric()
    }
}

#[test]
fn the_law_of_equivariance_rejects_what_breaks_it() {
    let verlet = MixesNothing(PartitionedRungeKutta::kick_drift_kick());
    assert_eq!(broken(&laws::scheme(&verlet)), [""; 0]);
    assert!(laws::equivariance(&verlet).residual("equivariance").unwrap() > 1e-4);
}

/// Rotations of the plane by the angle h, with a fault.
#[derive(Clone, Copy, Debug, PartialEq)]
enum FaultyIntegrator {
    None,
    MovesAtRest,
    Remembers,
    ReturnsNaN,
    MiscountsSamples,
    StartsElsewhere,
    BeginsLater,
    StopsLater,
    StartsAnywhere,
    AdvancesElsewhere,
}

impl Integrator for FaultyIntegrator {
    type State = Vector2<f64>;
    type Momentum = Vector2<f64>;
    type Workspace = u32;

    fn workspace(&self) -> u32 {
        0
    }

    fn step(
        &self,
        z: &Vector2<f64>,
        step: f64,
        made: &mut u32,
    ) -> Result<Step<Vector2<f64>>, StepError> {
        *made += 1;
        let angle = match self {
            Self::MovesAtRest => step + 1e-6,
            Self::Remembers => step * f64::from(*made),
            _ => step,
        };
        let (sin, cos) = angle.sin_cos();
        let point = Vector2::new(z.x * cos + z.y * sin, z.y * cos - z.x * sin);
        let next = Step { point, iterations: 0 };
        if *self == Self::ReturnsNaN { Ok(next) } else { next.finite() }
    }

    fn step_in_place(
        &self,
        z: &mut Vector2<f64>,
        step: f64,
        made: &mut u32,
    ) -> Result<usize, StepError> {
        let scale = if *self == Self::AdvancesElsewhere { 2.0 } else { 1.0 };
        let Step { point, iterations } = self.step(&(*z * scale), step, made)?;
        *z = point;
        Ok(iterations)
    }

    fn momentum(&self, z: &Vector2<f64>) -> Vector2<f64> {
        *z
    }

    fn trajectory_from(&self, z: Vector2<f64>, step: f64) -> Trajectory<'_, Self> {
        self.trajectory_resumed(z, u64::from(*self == Self::MiscountsSamples), step)
    }
}

impl Start for FaultyIntegrator {
    fn start(&self, mu: &Vector2<f64>) -> Result<Vector2<f64>, LiftError> {
        Ok(if *self == Self::StartsElsewhere { mu * 1.001 } else { *mu })
    }

    fn trajectory(&self, mu: &Vector2<f64>, step: f64) -> Result<Trajectory<'_, Self>, RunError> {
        if *self != Self::StartsAnywhere {
            let refused = |source| IntegrationError::after(0, step, source);
            StepError::check_start(mu, step).map_err(refused)?;
        }
        let start = if *self == Self::BeginsLater { mu * 2.0 } else { self.start(mu)? };
        Ok(self.trajectory_from(start, step))
    }

    fn after(&self, mu: &Vector2<f64>, step: f64, steps: u64) -> Result<SampleOf<Self>, RunError> {
        let place = if *self == Self::StopsLater { steps + 1 } else { steps };
        let sample = self.trajectory(mu, step)?.nth(place as usize);
        Ok(sample.unwrap_or(Err(IntegrationError::after(steps, step, StepError::Uncountable)))?)
    }
}

#[test]
fn laws_of_integrators_reject_what_breaks_them() {
    let cases: [(FaultyIntegrator, &[&str]); 10] = [
        (FaultyIntegrator::None, &[]),
        (FaultyIntegrator::MovesAtRest, &["step of size 0"]),
        (FaultyIntegrator::Remembers, &["forgetting", "resumption"]),
        (FaultyIntegrator::ReturnsNaN, &["refusal"]),
        (FaultyIntegrator::MiscountsSamples, &["first sample", "after", "samples"]),
        (FaultyIntegrator::StartsElsewhere, &["start"]),
        (FaultyIntegrator::BeginsLater, &["first sample"]),
        (FaultyIntegrator::StopsLater, &["after"]),
        (FaultyIntegrator::StartsAnywhere, &["refusal"]),
        (FaultyIntegrator::AdvancesElsewhere, &["step in place"]),
    ];
    for (integrator, expected) in cases {
        let report = laws::start(&integrator, &points(), STEP).unwrap();
        assert_eq!(broken(&report), expected, "{integrator:?}");
    }
}

/// The map x ↦ (1 + h) x for many x, with a fault.
#[derive(Clone, Copy, Debug, PartialEq)]
enum FaultyBatch {
    None,
    CountsMembers,
    CountsPlaces,
    LooksAtNeighbours,
    Remembers,
    ReportsTwice,
    ReportsNothing,
    ReportsAnotherStep,
    StopsForAll,
}

impl BatchIntegrator for FaultyBatch {
    type Member = f64;
    type Workspace = u32;

    fn workspace(&self) -> u32 {
        0
    }

    fn advance(
        &self,
        members: &mut [f64],
        step: f64,
        steps: Range<u64>,
        calls: &mut u32,
        failed: &mut dyn FnMut(usize, IntegrationError),
    ) {
        *calls += 1;
        let (count, largest) = (members.len(), members.iter().fold(0.0, |a: f64, b| a.max(*b)));
        if *self == Self::StopsForAll && members.iter().any(|x| !x.is_finite()) {
            return failed(members.iter().position(|x| !x.is_finite()).unwrap(), at(1, step));
        }
        for (place, x) in members.iter_mut().enumerate() {
            let little = match self {
                Self::CountsMembers => count as f64,
                Self::CountsPlaces => place as f64,
                Self::LooksAtNeighbours => largest,
                Self::Remembers => f64::from(*calls),
                _ => 0.0,
            };
            if x.is_finite() {
                steps.clone().for_each(|_| *x *= 1.0 + step * (1.0 + 1e-6 * little));
                continue;
            }
            match self {
                Self::ReportsNothing => {}
                Self::ReportsAnotherStep => failed(place, at(1 + count as u64, step)),
                _ => failed(place, at(1, step)),
            }
            if *self == Self::ReportsTwice {
                failed(place, at(1, step));
            }
        }
    }
}

/// Returns the error of the step with this number.
fn at(number: u64, step: f64) -> IntegrationError {
    IntegrationError::after(number - 1, step, StepError::NotFinite)
}

#[test]
fn laws_of_batches_reject_what_breaks_them() {
    let cases: [(FaultyBatch, &[&str]); 9] = [
        (FaultyBatch::None, &[]),
        (FaultyBatch::CountsMembers, &["number", "neighbours", "isolation"]),
        (FaultyBatch::CountsPlaces, &["place", "neighbours", "isolation"]),
        (FaultyBatch::LooksAtNeighbours, &["neighbours", "isolation", "resumption"]),
        (FaultyBatch::Remembers, &["resumption"]),
        (FaultyBatch::ReportsTwice, &["report"]),
        (FaultyBatch::ReportsNothing, &["report"]),
        (FaultyBatch::ReportsAnotherStep, &["report"]),
        (FaultyBatch::StopsForAll, &["isolation"]),
    ];
    for (batch, expected) in cases {
        let report = laws::batch(&batch, &[1.0, 0.5, -0.7], &f64::NAN, 1e-3).unwrap();
        let found = broken(&report);
        assert!(found.len() == expected.len(), "{batch:?}: {found:?}");
        assert!(expected.iter().all(|law| found.contains(law)), "{batch:?}: {found:?}");
    }
}

#[test]
fn no_samples_no_report() {
    let sound = FaultyIntegrator::None;
    assert!(laws::integrator(&sound, &[], STEP).is_err());
    assert!(laws::start(&sound, &[], STEP).is_err());
    assert!(laws::invariants(&sound, &[], STEP, &[&|z| z.x]).is_err());
    assert!(laws::invariants(&sound, &points(), STEP, &[]).is_err());
    assert!(laws::batch(&FaultyBatch::None, &[], &f64::NAN, STEP).is_err());
}
