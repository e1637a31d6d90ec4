//! Schemes that break one law each, which the law suite rejects.

use crate::support::{broken, laws};
use collective_integrators::*;
use lie_poisson::*;

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
    shifted.set_coordinate(0, z.coordinate(0) + little);
    shifted
}

/// Returns the largest coordinate of a vector, over all lanes.
fn largest<V: State>(z: &V) -> f64 {
    (0..z.dimension()).fold(0.0, |largest, i| larger(largest, z.coordinate(i).max_abs()))
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
        (z, _): (&F::Point, &F::Point),
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

    fn forget<V: State>(&self, _: &mut u32) {}

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

    fn forget<V: State>(&self, (): &mut ()) {}

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
    assert!(laws::equivariant_scheme(&verlet).residual("equivariance").unwrap() > 1e-4);
}

/// A scheme that contains another one, and does not pass on the call to forget.
#[derive(Clone)]
struct Deaf<S>(S);

impl<S: Scheme> Scheme for Deaf<S> {
    type Workspace<V: State> = S::Workspace<V>;

    fn workspace<V: State>(&self) -> S::Workspace<V> {
        self.0.workspace()
    }

    fn increment<T: Real, F: VectorField<T>>(
        &self,
        field: &F,
        z: &F::Point,
        step: f64,
        workspace: &mut S::Workspace<F::Point>,
    ) -> Result<Step<F::Point>, StepError> {
        self.0.increment(field, z, step, workspace)
    }

    fn forget<V: State>(&self, _: &mut S::Workspace<V>) {}

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

/// A method that remembers stages begins anew by itself from another point, so that the law continues from the last one.
#[test]
fn a_scheme_that_does_not_forget_is_seen() {
    for stages in 1..=4 {
        let gauss = RungeKutta::gauss(stages).unwrap();
        let forgetting = |report: &laws::Report| report.residual("forgetting").unwrap();
        assert!(forgetting(&laws::scheme(&Deaf(gauss.clone()))) >= 1.0, "{stages}");
        assert_eq!(forgetting(&laws::scheme(&gauss)), 0.0, "{stages}");
    }
}
