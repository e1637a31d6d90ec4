//! The same steps on each instruction set of this processor: where bits differ, and by how much.

use collective_integrators::Start;
use heavytop::HeavyTop;
use heavytop::methods::{Formulation, Method, Scheme, Task};
use lie_poisson::{InstructionSet, Se3Dual, Vector, larger};
use nalgebra::Vector3;

const STEP: f64 = 0.02;
const STEPS: usize = 1000;

/// Kovalevskaya's top where the paper starts it.
fn top() -> (HeavyTop, Se3Dual) {
    let start = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.5, 0.0, 0.75_f64.sqrt()));
    (HeavyTop::kovalevskaya(1.0, 1.0).unwrap(), start)
}

/// The states after each step.
struct States(Se3Dual);

impl Task for States {
    type Output = Vec<Se3Dual>;

    fn perform<I: Start<State: Vector, Momentum = Se3Dual>>(self, integrator: &I) -> Vec<Se3Dual> {
        let run = integrator.trajectory(&self.0, STEP).unwrap().skip(1).take(STEPS);
        run.map(|sample| sample.unwrap().momentum).collect()
    }
}

fn states(method: Method) -> Vec<Se3Dual> {
    let (top, start) = top();
    method.integrate(&top, States(start)).unwrap()
}

fn bits(states: &[Se3Dual]) -> Vec<[u64; 6]> {
    let coordinate = |mu: &Se3Dual, i| mu.coordinate(i).to_bits();
    states.iter().map(|mu| core::array::from_fn(|i| coordinate(mu, i))).collect()
}

/// Returns all methods for tops whose stages are solved to round-off.
fn methods() -> impl Iterator<Item = Method> {
    Formulation::NAMES.iter().flat_map(|&(_, formulation)| {
        let schemes = formulation.schemes();
        schemes.map(move |scheme| Method::new(formulation, scheme, 0.0).unwrap())
    })
}

/// Returns the largest distance up to a step, in roundings of the largest coordinate: 2⁻⁵³ of it.
fn roundings(a: &[Se3Dual], b: &[Se3Dual], steps: usize) -> f64 {
    let distances = a.iter().zip(b).take(steps).map(|(a, b)| (*a - *b).max_abs() / a.max_abs());
    distances.fold(0.0, larger) / (f64::EPSILON / 2.0)
}

/// All sets with fused multiply-add have the same bits, and the portable one has others for the two kernels alone.
#[test]
fn bits_depend_on_fusion_alone_and_only_in_the_kernels() {
    let mut fused_methods = Vec::new();
    for method in methods() {
        let native = bits(&states(method));
        for set in InstructionSet::available() {
            let method = method.with_instructions(set).unwrap();
            // A run on the fastest set is a run on any set that rounds as it does.
            let alike = method.is_fused() == method_of(method).is_fused();
            assert_eq!(bits(&states(method)) == native, alike, "{method:?} on {set}");
        }
        if method.is_fused() {
            fused_methods.push((method.formulation(), method.scheme()));
        }
    }
    let gauss = |stages| (Formulation::Collective, Scheme::Gauss(stages));
    let mut kernels: Vec<_> = [2, 3, 4, 5, 6, 8].map(gauss).into();
    kernels.push((Formulation::Reduced, Scheme::ImplicitMidpoint));
    let any = InstructionSet::detected() != InstructionSet::Portable;
    assert_eq!(fused_methods, if any { kernels } else { Vec::new() });
}

/// Returns the same method on the instructions that are fastest here.
fn method_of(method: Method) -> Method {
    Method::new(method.formulation(), method.scheme(), 0.0).unwrap()
}

/// The steps on two sets are equally good roundings of the same map: they differ by some roundings in the first step, and
/// by what the motion makes of these in the following ones. The bounds are four times what was found.
#[test]
fn with_and_without_fusion_the_steps_differ_by_roundings() {
    for method in methods().filter(Method::is_fused) {
        let fused = states(method);
        let portable = states(method.with_instructions(InstructionSet::Portable).unwrap());
        let after = [1, 100, STEPS].map(|steps| roundings(&fused, &portable, steps));
        println!("{} {}: {after:.1?}", method.formulation(), method.scheme());
        assert!(after[0] <= 16.0 && after[1] <= 400.0 && after[2] <= 40_000.0, "{after:?}");
        assert!(after[2] > 0.0);
    }
}

/// Lanes that are not available are refused.
#[test]
fn missing_instructions_are_refused() {
    for set in InstructionSet::ALL {
        let method = Method::new(Formulation::Collective, Scheme::Gauss(2), 0.0).unwrap();
        let refused = method.with_instructions(set);
        assert_eq!(refused.is_ok(), set.is_available(), "{set}");
    }
}
