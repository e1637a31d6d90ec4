//! The order of a Runge–Kutta method, from its coefficients.

/// Trees are compared up to this order; beyond it the simplifying assumptions speak.
const TREE_ORDERS: usize = 8;

/// How far an order condition on rounded coefficients may be from zero.
const TOLERANCE: f64 = 1e-12;

/// The order of the method.
///
/// Up to order 8 by the conditions of all rooted trees, Σ b_i Φ_i(τ) γ(τ) = 1; for methods that
/// meet them all, by Butcher's simplifying assumptions B(p), C(η), D(ζ), which give the order
/// min(p, η+ζ+1, 2η+2).
///
/// Source: Hairer, Lubich & Wanner, *Geometric Numerical Integration*, 2nd ed., Thm. III.1.5;
/// Hairer & Wanner, *Solving Ordinary Differential Equations II*, Thm. IV.5.1.
pub(crate) fn order_of(a: &[f64], b: &[f64], c: &[f64]) -> usize {
    match tree_order(a, b) {
        TREE_ORDERS => TREE_ORDERS.max(simplified_order(a, b, c)),
        order => order,
    }
}

/// A rooted tree with its density γ and the vector Φ_i of its elementary weights at the stages.
struct Tree {
    order: usize,
    density: f64,
    /// Σ_j a_ij Φ_j: the factor that the tree gives to a parent at stage i.
    as_branch: Vec<f64>,
}

fn tree_order(a: &[f64], b: &[f64]) -> usize {
    let mut trees: Vec<Tree> = Vec::new();
    for order in 1..=TREE_ORDERS {
        let mut grown = Vec::new();
        let stem = (1.0, vec![1.0; b.len()]);
        if !grow(&trees, order, order - 1, trees.len(), &stem, a, b, &mut grown) {
            return order - 1;
        }
        trees.append(&mut grown);
    }
    TREE_ORDERS
}

/// Adds branches from `trees[..last]` until `missing` vertices are used up; false as soon as a
/// finished tree breaks its order condition.
#[allow(clippy::too_many_arguments)]
fn grow(
    trees: &[Tree],
    order: usize,
    missing: usize,
    last: usize,
    (density, weights): &(f64, Vec<f64>),
    a: &[f64],
    b: &[f64],
    grown: &mut Vec<Tree>,
) -> bool {
    if missing == 0 {
        let density = density * order as f64;
        let sum: f64 = b.iter().zip(weights).map(|(b, w)| b * w).sum();
        let branch = |row: &[f64]| row.iter().zip(weights).map(|(a, w)| a * w).sum();
        let as_branch = a.chunks_exact(b.len()).map(branch).collect();
        grown.push(Tree { order, density, as_branch });
        return (sum * density - 1.0).abs() <= TOLERANCE;
    }
    (0..last).filter(|&n| trees[n].order <= missing).all(|n| {
        let tree = &trees[n];
        let product = weights.iter().zip(&tree.as_branch).map(|(w, t)| w * t).collect();
        let stem = (density * tree.density, product);
        grow(trees, order, missing - tree.order, n + 1, &stem, a, b, grown)
    })
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
    use crate::{RungeKutta, Tableau};

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
        // Kutta's third-order method, and with two weights exchanged.
        let a = [0.0, 0.0, 0.0, 0.5, 0.0, 0.0, -1.0, 2.0, 0.0];
        assert_eq!(order(&a, &[1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0]), Ok(3));
        assert_eq!(order(&a, &[4.0 / 6.0, 1.0 / 6.0, 1.0 / 6.0]), Ok(1));
    }
}
