//! Runge–Kutta methods: order, symplecticity, symmetry, quadratic invariants, each measured.

use crate::support::*;
use collective_integrators::*;
use lie_poisson::Vector;

#[test]
fn runge_kutta_methods_keep_their_promises() {
    let gauss = |s| RungeKutta::gauss(s).unwrap();
    let dirk = RungeKutta::symplectic_dirk(Substeps::kahan_li6().fractions()).unwrap();
    let methods: [(&str, RungeKutta, usize, bool, &[usize]); 9] = [
        ("implicit midpoint", RungeKutta::implicit_midpoint(), 2, true, &[20, 40, 80]),
        ("Gauss 2", gauss(2), 4, true, &[10, 15, 20, 30]),
        ("Gauss 3", gauss(3), 6, true, &[5, 6, 8, 10, 12]),
        ("Qin–Zhang", RungeKutta::qin_zhang(), 2, true, &[20, 40, 80]),
        ("Sanz-Serna–Abia", RungeKutta::sanz_serna_abia(), 4, true, &[20, 30, 40, 60, 80]),
        ("DIRK 6", dirk, 6, true, &[8, 10, 12, 16, 20]),
        ("explicit midpoint", RungeKutta::explicit_midpoint(), 2, false, &[20, 40, 80]),
        ("RK4", RungeKutta::rk4(), 4, false, &[10, 15, 20, 30]),
        ("DOP853", RungeKutta::dop853(), 8, false, &[4, 5, 6, 7, 8]),
    ];
    for (name, method, order, geometric, counts) in methods {
        assert_eq!(method.order(), order, "{name}");
        assert_eq!((method.is_symplectic(), method.is_symmetric()), (geometric, geometric));
        assert_eq!(method.preserves_quadratic_invariants(), geometric, "{name}");
        if order < 8 {
            keeps_its_promises(&method, counts, name);
            let defect = quadratic_defect(&method, 0.2);
            assert_eq!(defect < ROUND_OFF, geometric, "{name}: {defect:e}");
        } else {
            let measured = measured_order(&method, counts);
            assert!((measured - 8.0).abs() < 0.5, "{measured}");
            assert!(symplectic_defect(&method, 0.5) > 1e3 * ROUND_OFF);
            assert!(symmetry_defect(&method, 0.5) > 1e3 * ROUND_OFF);
        }
    }
}

#[test]
fn a_diagonally_implicit_method_is_a_composition() {
    let substeps = Substeps::mclachlan8();
    let dirk = RungeKutta::symplectic_dirk(substeps.fractions()).unwrap();
    let composed = Composition::new(RungeKutta::implicit_midpoint(), substeps);
    let difference =
        advance(&dirk, &field(), start(), 0.2, 1) - advance(&composed, &field(), start(), 0.2, 1);
    assert!(difference.max_abs() < ROUND_OFF, "{difference:?}");
}
