//! Compositions: order, symplecticity, symmetry, quadratic invariants, each measured.

use crate::support::*;
use collective_integrators::*;

#[test]
#[ignore = "long"]
fn compositions_of_the_midpoint_rule_keep_their_promises() {
    let sets: [(&str, Substeps); 9] = [
        ("Yoshida 4", Substeps::yoshida4()),
        ("Suzuki 4", Substeps::suzuki4()),
        ("McLachlan 4", Substeps::mclachlan4()),
        ("Yoshida 6", Substeps::yoshida6()),
        ("McLachlan 6", Substeps::mclachlan6()),
        ("Kahan–Li 6", Substeps::kahan_li6()),
        ("Yoshida 8", Substeps::yoshida8()),
        ("McLachlan 8", Substeps::mclachlan8()),
        ("Kahan–Li 8", Substeps::kahan_li8()),
    ];
    for (name, substeps) in sets {
        let scheme = Composition::new(RungeKutta::implicit_midpoint(), substeps);
        keeps_its_promises(&scheme, name);
        assert!(scheme.is_symplectic() && scheme.is_symmetric());
        assert!(scheme.preserves_quadratic_invariants());
    }
}

#[test]
#[ignore = "long"]
fn other_bases_are_raised_by_two() {
    let gauss = Composition::new(RungeKutta::gauss(2).unwrap(), Substeps::triple_jump(4).unwrap());
    assert_eq!(gauss.order(), 6);
    keeps_its_promises(&gauss, "two-stage Gauss, triple jump");
    // Compositions may be nested.
    let nested = Composition::new(
        Composition::new(RungeKutta::implicit_midpoint(), Substeps::suzuki(2).unwrap()),
        Substeps::suzuki(4).unwrap(),
    );
    assert_eq!(nested.order(), 6);
    keeps_its_promises(&nested, "Suzuki's fractal of Suzuki's fractal");
}

/// Negative controls: without symmetry of the base or of the substeps the order is lower, and no composition of a
/// method that is not symplectic is symplectic.
#[test]
fn a_composition_is_no_better_than_its_base() {
    let explicit = Composition::new(RungeKutta::explicit_midpoint(), Substeps::yoshida4());
    assert_eq!(explicit.order(), 3);
    keeps_its_promises(&explicit, "explicit midpoint");
    assert!(!explicit.is_symplectic() && !explicit.is_symmetric());
    assert!(!explicit.preserves_quadratic_invariants());
    let lopsided = Substeps::new(&[0.3, 0.7]).unwrap();
    let lopsided = Composition::new(RungeKutta::implicit_midpoint(), lopsided);
    assert_eq!((lopsided.order(), lopsided.is_symmetric()), (2, false));
    keeps_its_promises(&lopsided, "lopsided midpoint");
}

#[test]
fn a_substep_that_fails_fails_the_step() {
    let blow_up = from_fn(|z: &nalgebra::Vector1<f64>| z.map(|x| x * x * 1e6));
    let scheme = Composition::new(RungeKutta::implicit_midpoint(), Substeps::yoshida4());
    let step = scheme.step(&blow_up, &nalgebra::Vector1::new(1.0), 1.0, &mut scheme.workspace());
    assert!(matches!(step, Err(StepError::NotConverged { .. })));
}
