//! The order of a Runge–Kutta method, from its coefficients.

use crate::rooted_trees::{Branch, Stem, grow};

/// The largest order for which trees are compared. Beyond it the simplifying assumptions are tested.
const TREE_ORDERS: usize = 8;

/// The largest value of an order condition on rounded coefficients that counts as zero.
const TOLERANCE: f64 = 1e-12;

/// Returns the order of a Runge–Kutta method.
///
/// Up to order 8 the conditions of all rooted trees, Σ b_i Φ_i(τ) γ(τ) = 1, are tested. For methods that meet them all,
/// Butcher's simplifying assumptions B(p), C(η), D(ζ) give the order min(p, η+ζ+1, 2η+2).
///
/// Source: Hairer, Lubich & Wanner, *Geometric Numerical Integration*, 2nd ed., Thm. III.1.5;
/// Hairer & Wanner, *Solving Ordinary Differential Equations II*, Thm. IV.5.1.
pub(crate) fn order_of(a: &[f64], b: &[f64], c: &[f64]) -> usize {
    match tree_order(&[(a, b)]) {
        TREE_ORDERS => TREE_ORDERS.max(simplified_order(a, b, c)),
        order => order,
    }
}

/// The coefficients (a, b) of a Runge–Kutta method.
type Coefficients<'a> = (&'a [f64], &'a [f64]);

/// Returns the order of a partitioned method, which has a Runge–Kutta method with the same number of stages for each
/// part of the variables.
///
/// The conditions of all trees whose vertices are coloured by the parts are tested, up to order 8.
///
/// Source: Hairer, Lubich & Wanner, Thm. III.2.5.
pub(crate) fn tree_order(parts: &[Coefficients<'_>]) -> usize {
    let stages = parts.first().map_or(0, |(_, b)| b.len());
    // The weight at stage i is the factor Σ_j a_ij Φ_j, with the matrix a of the root's colour.
    let mut trees: Vec<Branch<f64>> = Vec::new();
    for order in 1..=TREE_ORDERS {
        let mut grown = Vec::new();
        let stem = Stem { missing: order - 1, last: trees.len(), density: order as f64 };
        // The weights at the stages do not depend on the colour of the root.
        let all_hold =
            grow(&trees, &stem, &vec![1.0; stages], |w, x| w * x, &mut |weights, density| {
                let dot = |x: &[f64]| -> f64 { x.iter().zip(weights).map(|(x, w)| x * w).sum() };
                parts.iter().all(|(a, b)| {
                    let at_stages = a.chunks_exact(b.len()).map(dot).collect();
                    grown.push(Branch { order, density, at_stages });
                    (dot(b) * density - 1.0).abs() <= TOLERANCE
                })
            });
        if !all_hold {
            return order - 1;
        }
        trees.append(&mut grown);
    }
    TREE_ORDERS
}

fn simplified_order(a: &[f64], b: &[f64], c: &[f64]) -> usize {
    let s = b.len();
    let power = |x: f64, k: usize| x.powi(k as i32);
    let holds = |x: f64| x.abs() <= TOLERANCE;
    let quadrature = |k: usize| {
        let sum: f64 = (0..s).map(|i| b[i] * power(c[i], k - 1)).sum();
        holds(sum * k as f64 - 1.0)
    };
    let collocation = |k: usize| {
        (0..s).all(|i| {
            let sum: f64 = (0..s).map(|j| a[i * s + j] * power(c[j], k - 1)).sum();
            holds(sum * k as f64 - power(c[i], k))
        })
    };
    let transposed = |k: usize| {
        (0..s).all(|j| {
            let sum: f64 = (0..s).map(|i| b[i] * power(c[i], k - 1) * a[i * s + j]).sum();
            holds(sum * k as f64 - b[j] * (1.0 - power(c[j], k)))
        })
    };
    let longest =
        |condition: &dyn Fn(usize) -> bool| (1..=2 * s).take_while(|&k| condition(k)).count();
    let (p, eta, zeta) = (longest(&quadrature), longest(&collocation), longest(&transposed));
    p.min(eta + zeta + 1).min(2 * eta + 2)
}

#[cfg(test)]
mod tests {
    use crate::schemes::runge_kutta::RungeKutta;
    use crate::tableaux::tableau::Tableau;

    #[test]
    fn orders_are_computed() {
        let order = |scheme: &RungeKutta| scheme.tableau().order();
        assert_eq!(order(&RungeKutta::explicit_midpoint()), 2);
        assert_eq!(order(&RungeKutta::implicit_midpoint()), 2);
        assert_eq!(order(&RungeKutta::rk4()), 4);
        for s in 1..=12 {
            assert_eq!(RungeKutta::gauss(s).map(|g| order(&g)), Ok(2 * s));
        }
    }

    #[test]
    fn a_wrong_coefficient_costs_order() {
        let order = |a: &[f64], b: &[f64]| Tableau::new(a, b).map(|t| t.order());
        assert_eq!(order(&[0.4], &[1.0]), Ok(1));
        assert_eq!(order(&[0.5], &[0.9]), Ok(0));
        // Kutta's third-order method, and the same with two weights exchanged.
        let a = [0.0, 0.0, 0.0, 0.5, 0.0, 0.0, -1.0, 2.0, 0.0];
        assert_eq!(order(&a, &[1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0]), Ok(3));
        assert_eq!(order(&a, &[4.0 / 6.0, 1.0 / 6.0, 1.0 / 6.0]), Ok(1));
    }

    /// Returns the tableau of Gauss with 6 stages and ε P_i(2c_m − 1) P_j(2c_n − 1) b_n added to a_mn.
    ///
    /// This keeps B(12), and those conditions of C and D that hold up to η = j and ζ = i.
    fn disturbed(i: usize, j: usize) -> Result<Tableau, crate::SchemeError> {
        let legendre = |n: usize, c: f64| {
            let x = 2.0 * c - 1.0;
            let next = |(p, q): (f64, f64), k: usize| {
                let k = k as f64;
                (q, ((2.0 * k + 1.0) * x * q - k * p) / (k + 1.0))
            };
            (0..n).fold((0.0, 1.0), next).1
        };
        let gauss = Tableau::gauss(6)?;
        let (b, c) = (gauss.weights(), gauss.nodes());
        let change = |n: usize| 0.3 * legendre(i, c[n / 6]) * legendre(j, c[n % 6]) * b[n % 6];
        let a: Vec<f64> = gauss.matrix().iter().zip(0..).map(|(a, n)| a + change(n)).collect();
        Tableau::new(&a, b)
    }

    /// Each of the three numbers in min(p, η+ζ+1, 2η+2) determines the order once. The comparison is with the first
    /// order condition that fails, which is that of a tree without branches or of one with two.
    #[test]
    fn orders_beyond_the_trees_that_are_compared() {
        let apply = |t: &Tableau, v: &[f64]| -> Vec<f64> {
            t.rows().map(|row| row.iter().zip(v).map(|(a, v)| a * v).sum()).collect()
        };
        let mean =
            |t: &Tableau, v: &[f64]| -> f64 { t.weights().iter().zip(v).map(|(b, v)| b * v).sum() };
        let holds = |x: f64| (x - 1.0).abs() < 1e-10;
        // bᵀ Aⁿ⁻¹ 1 n! = 1
        let tall = |t: &Tableau| {
            let (mut v, mut factorial) = (vec![1.0; 6], 1.0);
            (1..=13_u32).position(|n| {
                factorial *= f64::from(n);
                let failed = !holds(mean(t, &v) * factorial);
                v = apply(t, &v);
                failed
            })
        };
        // Σ b_i (Σ_j a_ij c_j³)² 9·4² = 1, of 9 vertices
        let forked = |t: &Tableau| {
            let cubes: Vec<f64> = t.nodes().iter().map(|c| c.powi(3)).collect();
            let squares: Vec<f64> = apply(t, &cubes).iter().map(|x| x * x).collect();
            holds(mean(t, &squares) * 144.0)
        };
        let gauss = Tableau::gauss(6);
        assert!(gauss.is_ok_and(|t| t.order() == 12 && tall(&t) == Some(12) && forked(&t)));
        let cases =
            [(5, 5, 11), (4, 5, 10), (5, 4, 10), (4, 4, 9), (3, 5, 9), (3, 4, 8), (2, 5, 8)];
        for (i, j, order) in cases {
            let tableau = disturbed(i, j);
            assert!(
                tableau.is_ok_and(|t| t.order() == order && tall(&t) == Some(order)),
                "{i} {j}"
            );
        }
        // 2η + 2 = 8 < η + ζ + 1: the tall trees have order 9, and the fork shows that the order is 8.
        let tableau = disturbed(5, 3);
        assert!(tableau.is_ok_and(|t| t.order() == 8 && tall(&t) == Some(9) && !forked(&t)));
    }
}
