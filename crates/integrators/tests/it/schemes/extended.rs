//! Methods in a doubled phase space: Tao's method, and the semiexplicit method with its projection.

use crate::support::*;
use collective_integrators::*;
use lie_poisson::*;
use momentum_map::SymplecticSpace;

fn semiexplicit(substeps: &Substeps) -> RungeKutta {
    RungeKutta::new(Tableau::semiexplicit(substeps).unwrap())
}

#[test]
#[ignore = "long"]
fn semiexplicit_methods_keep_their_promises() {
    let once = Substeps::new(&[1.0]).unwrap();
    let cases: [(&str, Substeps); 4] = [
        ("semiexplicit 2", once),
        ("semiexplicit 4", Substeps::yoshida4()),
        ("semiexplicit 6", Substeps::kahan_li6()),
        ("semiexplicit 8", Substeps::kahan_li8()),
    ];
    for (name, substeps) in cases {
        let method = semiexplicit(&substeps);
        keeps_its_promises(&method, name);
        assert!(method.is_symplectic() && method.preserves_quadratic_invariants());
    }
}

/// Makes one step as the authors define it, with q and p, in the doubled space, by iteration on μ.
fn projected(substeps: &Substeps, z: Z, step: f64) -> Z {
    let splice = FirstHalf::splice::<Z>;
    let zero = Z::zero();
    let mut mu = Z::zero();
    let mut result = z;
    for _ in 0..100 {
        let (mut first, mut second) = (z + mu, z - mu);
        let a = |t: f64, first: &mut Z, second: &mut Z| {
            let x = field().at(&splice(first, second)).scaled(t);
            *first += splice(&zero, &x);
            *second += splice(&x, &zero);
        };
        let b = |t: f64, first: &mut Z, second: &mut Z| {
            let x = field().at(&splice(second, first)).scaled(t);
            *first += splice(&x, &zero);
            *second += splice(&zero, &x);
        };
        for gamma in substeps.fractions() {
            a(0.5 * gamma * step, &mut first, &mut second);
            b(gamma * step, &mut first, &mut second);
            a(0.5 * gamma * step, &mut first, &mut second);
        }
        let defect = (first + mu) - (second - mu);
        result = (first + second).scaled(0.5);
        mu -= defect.scaled(0.25);
    }
    result
}

#[test]
fn the_tableau_is_the_projected_extended_method() {
    for substeps in [Substeps::new(&[1.0]).unwrap(), Substeps::yoshida4(), Substeps::kahan_li6()] {
        let tableau = advance(&semiexplicit(&substeps), &field(), start(), 0.2, 1);
        let difference = (tableau - projected(&substeps, start(), 0.2)).max_abs();
        // Some forty evaluations have rounding errors.
        assert!(difference < 2e-15, "{difference:e}");
    }
}

#[test]
fn taos_method_is_symplectic_on_the_doubled_space() {
    let flows = TaoFlows::<_, FirstHalf>::new(field(), 10.0);
    let strang = Splitting::strang(flows);
    let raised = Composition::new(strang, Substeps::kahan_li6());
    let copies = TaoFlows::copied(start());
    let run = |n: usize, six: bool| {
        let h = 1.0 / n as f64;
        (0..n).fold(copies, |z, _| {
            let step = if six {
                raised.step(&z, h, &mut Default::default())
            } else {
                strang.step(&z, h, &mut Default::default())
            };
            step.unwrap().point
        })
    };
    let exact = advance(&RungeKutta::gauss(8).unwrap(), &field(), start(), 1.0, 40);
    for (six, counts, order) in [(false, [80, 160, 320, 640], 2.0), (true, [48, 56, 64, 80], 6.0)] {
        let error =
            |&n: &usize| (1.0 / n as f64, (run(n, six) - TaoFlows::copied(exact)).max_abs());
        let errors: Vec<_> = counts.iter().map(error).collect();
        let measured = fitted_order(&errors, 1e-13).unwrap();
        assert!((measured - order).abs() < 0.4, "{measured} {errors:?}");
    }
    let back = strang.step(
        &strang.step(&copies, 0.1, &mut Default::default()).unwrap().point,
        -0.1,
        &mut Default::default(),
    );
    assert!((back.unwrap().point - copies).max_abs() < ROUND_OFF);

    // The form is dq∧dp + dx∧dy, and the two copies are apart.
    let z = Pair(start(), start().scaled(0.9));
    let column = |i: usize| -> Pair<Z, Z> {
        let seeded: Pair<Z<DualNumber>, Z<DualNumber>> = seed(&z, &Vector::basis(i));
        derivative_part(&strang.step(&seeded, 0.1, &mut Default::default()).unwrap().point)
    };
    let form = |u: &Pair<Z, Z>, v: &Pair<Z, Z>| {
        phase().symplectic_form::<f64>(&u.0, &v.0) + phase().symplectic_form::<f64>(&u.1, &v.1)
    };
    for i in 0..8 {
        for j in 0..i {
            let flat = form(&Vector::basis(i), &Vector::basis(j));
            assert!((form(&column(i), &column(j)) - flat).abs() < ROUND_OFF);
        }
    }
    // The copies part: the method is no map of the original space.
    let Pair(first, second) = run(20, false);
    assert!((first - second).max_abs() > 1e-6);
}
