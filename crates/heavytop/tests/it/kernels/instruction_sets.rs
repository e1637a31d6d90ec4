//! The same steps on each instruction set of this processor: where bits differ, and by how much.

use collective_integrators::{AnyState, Start};
use heavytop::methods::{Formulation, Method, SchemeName};
use heavytop::{CollectiveGauss, HeavyTop, TopMidpoint};
use lie_poisson::{InstructionSet, Se3Dual, State, Vector, larger};
use nalgebra::Vector3;

const STEP: f64 = 0.02;

/// Kovalevskaya's top where the paper starts it.
fn top() -> (HeavyTop, Se3Dual) {
    let start = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.5, 0.0, 0.75_f64.sqrt()));
    (HeavyTop::kovalevskaya(1.0, 1.0).unwrap(), start)
}

/// Returns the states after each of so many steps.
fn states(method: Method, steps: usize) -> Vec<Se3Dual> {
    let (top, start) = top();
    let integrator = method.integrator(&top).unwrap();
    let run = integrator.trajectory(&AnyState::of(&start), STEP).unwrap().skip(1).take(steps);
    let momentum = |mu: AnyState| Vector::from_coordinates(|i| mu.as_slice()[i]);
    run.map(|sample| momentum(sample.unwrap().momentum)).collect()
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

/// What asks for instructions gets them, or the error that names them.
#[test]
fn instructions_that_the_processor_lacks_are_refused() {
    let (top, _) = top();
    for set in InstructionSet::ALL {
        let missing = (!set.is_available()).then_some(set);
        let gauss = CollectiveGauss::new(3, top).unwrap().with_instructions(set);
        assert_eq!(gauss.as_ref().err().map(|error| error.set), missing);
        assert!(gauss.is_err() || gauss.unwrap().instructions() == set);
        let midpoint = TopMidpoint::new(top).with_instructions(set);
        assert_eq!(midpoint.as_ref().err().map(|error| error.set), missing);
        assert!(midpoint.is_err() || midpoint.unwrap().instructions() == set);
    }
}

/// The sums over all methods of a formulation, and 20 steps of each, of the bits of the coordinates.
///
/// They are the same on every processor. A method that is added or changed on purpose changes the sum of its formulation.
const PORTABLE: [(&str, u64); 4] = [
    ("collective", 0x2b44_1913_58c3_0219),
    ("reduced", 0x43ef_5386_f70f_cf77),
    ("direct", 0xe931_edbf_e951_4624),
    ("splitting", 0x93a7_29ff_7bd2_30fd),
];

#[test]
fn portable_instructions_have_the_same_bits_on_every_processor() {
    let mut sums: Vec<(&str, u64)> = Vec::new();
    for &(name, formulation) in Formulation::NAMES {
        let sum = formulation.schemes().fold(0_u64, |sum, scheme| {
            let method = Method::new(formulation, scheme, 0.0).unwrap();
            let portable = method.with_instructions(InstructionSet::Portable).unwrap();
            let bits = bits(&states(portable, 20));
            bits.as_flattened().iter().fold(sum, |sum, bits| sum.rotate_left(1) ^ bits)
        });
        sums.push((name, sum));
    }
    assert_eq!(sums, PORTABLE, "{sums:#x?}");
}

/// A method says on which instruction set its bits depend.
#[test]
fn bits_are_those_of_the_instruction_set_that_the_method_names() {
    let mut kernels = Vec::new();
    for method in methods() {
        // AVX2 and AVX-512 take a while to differ; methods without a kernel never do.
        let steps = if method.instructions() == InstructionSet::Portable { 50 } else { 1000 };
        let native = bits(&states(method, steps));
        for set in InstructionSet::available() {
            let other = method.with_instructions(set).unwrap();
            // Control: on another set there are other bits.
            let alike = method.instructions() == other.instructions();
            assert_eq!(bits(&states(other, steps)) == native, alike, "{method:?} on {set}");
        }
        if method.instructions() != InstructionSet::Portable {
            kernels.push((method.formulation(), method.scheme()));
        }
    }
    let gauss = |stages| (Formulation::Collective, SchemeName::Gauss(stages));
    let mut expected: Vec<_> = [2, 3, 4, 5, 6, 8].map(gauss).into();
    expected.push((Formulation::Reduced, SchemeName::ImplicitMidpoint));
    let any = InstructionSet::detected() != InstructionSet::Portable;
    assert_eq!(kernels, if any { expected } else { Vec::new() });
}

/// The steps on two sets are equally good roundings of the same map: they differ by some roundings in the first steps, and
/// by what the motion makes of these later. The bounds are some four times what was found.
#[test]
fn on_two_instruction_sets_the_steps_differ_by_roundings() {
    let kernels = methods().filter(|method| method.instructions() != InstructionSet::Portable);
    for method in kernels {
        let on = |set| states(method.with_instructions(set).unwrap(), 1000);
        let portable = on(InstructionSet::Portable);
        for set in InstructionSet::available().skip(1) {
            let states = on(set);
            let after = [1, 100, 1000].map(|steps| roundings(&states, &portable, steps));
            println!("{} {}, {set}: {after:.1?}", method.formulation(), method.scheme());
            let bounds = [4.0, 40.0, 2000.0];
            assert!(after.iter().zip(bounds).all(|(found, bound)| *found <= bound), "{after:?}");
        }
    }
}

/// Instructions that the processor lacks are refused.
#[test]
fn missing_instructions_are_refused() {
    for set in InstructionSet::ALL {
        let method = Method::new(Formulation::Collective, SchemeName::Gauss(2), 0.0).unwrap();
        let refused = method.with_instructions(set);
        assert_eq!(refused.is_ok(), set.is_available(), "{set}");
    }
}
