//! The law `pinning`, far out along fibres: who moves states there keeps them where a workspace is pinned.

use super::faulty_integrators::Deaf;
use crate::laws::integrator_laws::STEP;
use crate::sites::collective_sites::Bodies;
use crate::support::{broken, laws};
use collective_integrators::*;
use lie_poisson::*;
use momentum_map::{Cotangent, PARTICLE};
use nalgebra::{Vector1, Vector2, Vector3};

/// The field ẋ = 1, ẏ = −y, of which M(x, y) = y sees y alone, with x moved back to 0; and faults of its pins.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Moving {
    Pins,
    PinsNever,
    PinsOneStep,
    PinsUntilItForgets,
}

impl Integrator for Moving {
    type State = Vector2<f64>;
    type Momentum = Vector1<f64>;
    /// Whether it is pinned.
    type Workspace = bool;

    fn workspace(&self) -> bool {
        false
    }

    fn step(
        &self,
        z: &Vector2<f64>,
        step: f64,
        pinned: &mut bool,
    ) -> Result<Step<Vector2<f64>>, StepError> {
        StepError::check_start(z, step)?;
        let start = if *pinned || z.x.abs() < 100.0 { z.x } else { 0.0 };
        *pinned &= *self != Self::PinsOneStep;
        Step { point: Vector2::new(start + step, z.y * (-step).exp()), iterations: 0 }.finite()
    }

    fn forget(&self, pinned: &mut bool) {
        *pinned &= *self != Self::PinsUntilItForgets;
    }

    fn pin(&self, pinned: &mut bool) {
        *pinned = *self != Self::PinsNever;
    }

    fn momentum(&self, z: &Vector2<f64>) -> Vector1<f64> {
        Vector1::new(z.y)
    }
}

#[test]
fn faults_of_pins_are_seen() {
    let far = [Vector2::new(1000.0, 0.7), Vector2::new(-300.0, -0.2)];
    for integrator in
        [Moving::Pins, Moving::PinsNever, Moving::PinsOneStep, Moving::PinsUntilItForgets]
    {
        let report = laws::integrator(&integrator, &far, STEP).unwrap();
        let expected: &[&str] = if integrator == Moving::Pins { &[] } else { &["pinning"] };
        assert_eq!(broken(&report), expected, "{integrator:?}");
    }
}

/// Asserts that an integrator stays far out along a fibre when it is pinned, and that it moves otherwise.
fn stays_when_pinned<I: Integrator>(name: &str, integrator: I, far: I::State) {
    let residual = |report: laws::Report| report.residual("pinning").unwrap();
    let states = [far];
    let pinned = residual(laws::integrator(&integrator, &states, STEP).unwrap());
    assert!(pinned < 1e-15, "{name}: {pinned:e}");
    let deaf = residual(laws::integrator(&Deaf(integrator), &states, STEP).unwrap());
    assert!(deaf > 0.5, "{name}: {deaf:e}");
}

/// A rigid motion, with h(l, p) = ½|l|² + l·p + ½ (e₁·p)².
#[derive(Clone, Copy)]
struct Screw;

impl Energy for Screw {
    type Space = LiePoisson<Se3>;

    fn energy<T: Real>(&self, Covector(Pair(l, p)): &Se3Dual<T>) -> T {
        l.dot(l) * 0.5 + l.dot(p) + p.x * p.x * 0.5
    }
}

#[test]
#[ignore = "long"]
fn collective_integrators_stay_when_they_are_pinned() {
    let gauss = || RungeKutta::gauss(2).unwrap();
    let (q, p) = (Vector3::new(0.3, -1.0, 0.7), Vector3::new(0.9, 0.4, -0.5));
    let far = Cotangent::new(q + p * 1000.0, Covector(p));
    let collective = || Collective::new(gauss(), PARTICLE, Automatic(Screw));
    stays_when_pinned("one stage after the other", collective(), far);
    stays_when_pinned("stages in lanes", StagesInLanes::widest(collective()), far);
    stays_when_pinned("compensated", collective().compensated(), Pair(far, far.scaled(0.0)));
    let composed = Composition::new(RungeKutta::implicit_midpoint(), Substeps::suzuki4());
    stays_when_pinned("composed", Collective::new(composed, PARTICLE, Automatic(Screw)), far);
    let sites = CollectiveSites::new(gauss(), PARTICLE, Bodies);
    stays_when_pinned("sites", sites, Sites::new(vec![far, far]));
}
