//! Runge–Kutta methods: order, symplecticity, symmetry, quadratic invariants, each measured.

use crate::support::*;
use collective_integrators::*;
use lie_poisson::Vector;

#[test]
fn runge_kutta_methods_keep_their_promises() {
    let gauss = |s| RungeKutta::gauss(s).unwrap();
    let dirk = RungeKutta::symplectic_dirk(Substeps::kahan_li6().fractions()).unwrap();
    let methods: [(&str, RungeKutta, usize, bool); 9] = [
        ("implicit midpoint", RungeKutta::implicit_midpoint(), 2, true),
        ("Gauss 2", gauss(2), 4, true),
        ("Gauss 3", gauss(3), 6, true),
        ("Qin–Zhang", RungeKutta::qin_zhang(), 2, true),
        ("Sanz-Serna–Abia", RungeKutta::sanz_serna_abia(), 4, true),
        ("DIRK 6", dirk, 6, true),
        ("explicit midpoint", RungeKutta::explicit_midpoint(), 2, false),
        ("RK4", RungeKutta::rk4(), 4, false),
        ("DOP853", RungeKutta::dop853(), 8, false),
    ];
    for (name, method, order, geometric) in methods {
        assert_eq!(method.order(), order, "{name}");
        assert_eq!((method.is_symplectic(), method.is_symmetric()), (geometric, geometric));
        assert_eq!(method.preserves_quadratic_invariants(), geometric, "{name}");
        keeps_its_promises(&method, name);
    }
}

/// Σ b = 1, Σ b c = 1/2 and Σ b a c = 1/6 hold. The tree with two equal branches asks for Σ b c² = 1/3, which is 1/4.
#[test]
fn trees_with_equal_branches_have_conditions_too() {
    let weights = [0.0, 0.5, 0.5];
    let mut matrix = [0.0; 9];
    (matrix[3], matrix[6], matrix[7]) = (0.5, -1.0 / 6.0, 2.0 / 3.0);
    assert_eq!(Tableau::new(&matrix, &weights).unwrap().order(), 2);
    // Control: Kutta's method of order 3 meets all four.
    let weights = [1.0, 4.0, 1.0].map(|b| b / 6.0);
    (matrix[3], matrix[6], matrix[7]) = (0.5, -1.0, 2.0);
    assert_eq!(Tableau::new(&matrix, &weights).unwrap().order(), 3);
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
