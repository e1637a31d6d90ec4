//! Which steps of driven motions are Poisson maps at each time.

use collective_integrators::diagnostics::step_poisson_defect;
use collective_integrators::{Direct, Driven, DrivenField, RungeKutta, Start};
use core::marker::PhantomData;
use lie_poisson::{
    Automatic, Controlled, Covector, Diagonal, DoubleBracket, DualNumber, Energy, InTime,
    InfinitesimalAdjoint, InnerProduct, LieAlgebra, LiePoisson, Momentum, OrbitField, Pair, Point,
    Power, PowerAlgebra, ProductSpace, Real, Se3, So3, State, Time, TimeAxis, TimeDependent,
    Vector, WithBreakpoints,
};
use momentum_map::{HOPF, Lift, PoissonMap, PowerMap, Side, clebsch_realisation};
use nalgebra::Vector3;

/// A quadratic and cubic energy on the dual of any algebra, each term of which oscillates with time.
struct Oscillating<A>(PhantomData<A>);

impl<A: LieAlgebra> Energy for Oscillating<A> {
    type Space = InTime<LiePoisson<A>>;

    fn energy<T: Real>(&self, Pair(mu, Time(t)): &Point<Self::Space, T>) -> T {
        let count = <Momentum<A, T> as Vector>::DIM;
        (0..count).fold(T::zero(), |sum, i| {
            let (x, y) = (mu.coordinate(i), mu.coordinate((i + 1) % count));
            let swing = (*t * 3.0 + i as f64).cos();
            sum + x * x * (swing * 0.3 + 0.2 + 0.1 * i as f64) + x * y * swing * 0.4 + x * y * y
        })
    }
}

fn oscillating<A: LieAlgebra>() -> TimeDependent<Automatic<Oscillating<A>>> {
    TimeDependent(Automatic(Oscillating(PhantomData)))
}

/// The control law ξ = μ₂ cos t e₁, which is the gradient of no function.
struct Law;

impl<A: LieAlgebra, T: Real> OrbitField<LiePoisson<A>, T> for Law {
    fn element(&self, mu: &Momentum<A, T>, time: T) -> A::Element<T> {
        let mut xi: A::Element<T> = Vector::zero();
        xi.set_coordinate(0, mu.coordinate(1) * time.cos());
        xi
    }
}

/// The time at which the steps begin, and their size, in which the energy goes through a sixth of its period.
const TIME: f64 = 0.7;
const STEP: f64 = 0.35;

fn defect<A, I>(algebra: A, mu: Momentum<A>, integrator: &I) -> f64
where
    A: LieAlgebra,
    I: Start<DualNumber, Momentum = Point<InTime<LiePoisson<A>>, DualNumber>>,
{
    let space: InTime<LiePoisson<A>> = ProductSpace(LiePoisson::minus(algebra), TimeAxis);
    step_poisson_defect(&space, integrator, &Pair(mu, Time(TIME)), STEP).unwrap()
}

/// Derivatives by dual numbers have the error of the stages, a few ε for steps of such a size; 6e-16 is measured.
const ROUND_OFF: f64 = 1e-14;

fn require_poisson_steps<M, A>(map: M, mu: Momentum<A>)
where
    M: Lift<Target = LiePoisson<A>>,
    A: LieAlgebra,
{
    let algebra = || map.target().algebra().clone();
    for stages in [2, 3] {
        let gauss = || RungeKutta::gauss(stages).unwrap();
        let of_energy = Driven::new(gauss(), map.clone(), oscillating::<A>());
        let found = defect(algebra(), mu, &of_energy);
        assert!(found < ROUND_OFF, "{stages}: {found}");
        // A step that is divided at a breakpoint is the composition of two Poisson maps.
        let divided = WithBreakpoints::new(oscillating::<A>(), vec![TIME + 0.3 * STEP]).unwrap();
        let found = defect(algebra(), mu, &Driven::new(gauss(), map.clone(), divided));
        assert!(found < ROUND_OFF, "{stages}, divided: {found}");
        // Controls: fields that are no gradients, and the same method on the equations themselves.
        let space = map.target();
        let damped =
            DoubleBracket::new(space.clone(), oscillating::<A>(), 0.1, InnerProduct::euclidean());
        let damped = Driven::new(gauss(), map.clone(), damped.unwrap());
        let controlled = Controlled { field: oscillating::<A>(), control: Law };
        let controlled = Driven::new(gauss(), map.clone(), controlled);
        let direct = Direct::new(gauss(), DrivenField { space, field: oscillating::<A>() });
        let found = [
            defect(algebra(), mu, &damped),
            defect(algebra(), mu, &controlled),
            defect(algebra(), mu, &direct),
        ];
        assert!(found[0] > 1e-2 && found[1] > 1e-2 && found[2] > 1e-6, "{stages}: {found:?}");
    }
    // Control: an explicit method does not conserve the symplectic form.
    let explicit = Driven::new(RungeKutta::rk4(), map.clone(), oscillating::<A>());
    let found = defect(algebra(), mu, &explicit);
    assert!(found > 1e-6, "{found}");
}

#[test]
fn steps_of_a_spin_are_poisson_maps_for_energies_alone() {
    require_poisson_steps::<_, So3>(HOPF, Covector(Vector3::new(0.48, -0.6, 0.64)));
}

#[test]
fn steps_of_two_spins_are_poisson_maps_for_energies_alone() {
    let two = Power([Vector3::new(0.48, -0.6, 0.64), Vector3::new(0.1, 0.5, -0.4)]);
    require_poisson_steps::<_, PowerAlgebra<So3, 2>>(PowerMap::<_, 2>(HOPF), Covector(two));
}

/// On se(3)∗, at a momentum with Π·Γ ≠ 0, by the Clebsch map of two copies of the adjoint representation.
#[test]
fn steps_of_a_top_are_poisson_maps_for_energies_alone() {
    let copies = Diagonal::<_, 2>(InfinitesimalAdjoint(Se3::default()));
    let map = clebsch_realisation(copies, Side::Right).unwrap();
    let mu = Covector(Pair(Vector3::new(0.4, 0.2, 0.75), Vector3::new(0.6, 0.0, 0.8)));
    let midpoint = RungeKutta::implicit_midpoint;
    let of_energy = Driven::new(midpoint(), map.clone(), oscillating::<Se3>());
    let found = defect(Se3::default(), mu, &of_energy);
    assert!(found < ROUND_OFF, "{found}");
    // Control: a double bracket.
    let damped =
        DoubleBracket::new(map.target(), oscillating::<Se3>(), 0.1, InnerProduct::euclidean());
    let found = defect(Se3::default(), mu, &Driven::new(midpoint(), map, damped.unwrap()));
    assert!(found > 1e-2, "{found}");
}
