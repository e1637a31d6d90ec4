//! Steps of explicit Runge–Kutta methods with four stages, for small states: [`four_stages`].

use crate::tableaux::tableau::Tableau;
use crate::vector_field::VectorField;
use lie_poisson::{Real, State};

/// The size of a state, in bytes, above which there is nothing to gain, and four of them are much for a stack.
const LARGEST: usize = 512;

/// Returns Σ_i b_i k_i for an explicit method with four stages, such as the classical one; `None` for another number of
/// stages, for coefficients with low parts, and for states that are large or on the heap.
///
/// The stages are written out one by one, so that small states stay in registers.
#[inline]
pub(crate) fn four_stages<T: Real, F: VectorField<T>>(
    tableau: &Tableau,
    field: &F,
    z: &F::Point,
    step: f64,
) -> Option<F::Point> {
    let is_small = size_of::<<F::Point as State>::Pool>() == 0 && size_of::<F::Point>() <= LARGEST;
    if !is_small || !tableau.weights_low().is_empty() {
        return None;
    }
    let &[_, _, _, _, a10, _, _, _, a20, a21, _, _, a30, a31, a32, _] = tableau.matrix() else {
        return None;
    };
    let &[b0, b1, b2, b3] = tableau.weights() else { return None };
    let at = |point: &F::Point| {
        let mut value = z.zeros_like();
        field.at_into(point, &mut value);
        value
    };
    let k0 = at(z);
    let k1 = at(&moved(z, [(step * a10, &k0)]));
    let k2 = at(&moved(z, [(step * a20, &k0), (step * a21, &k1)]));
    let k3 = at(&moved(z, [(step * a30, &k0), (step * a31, &k1), (step * a32, &k2)]));
    let mut sum = k0;
    sum.scale_in_place(T::from_f64(b0));
    Some(moved(&sum, [(b1, &k1), (b2, &k2), (b3, &k3)]))
}

/// Returns z + Σ_j a_j k_j, the newest term last: the others need not wait for it.
#[cfg_attr(optimised, inline(always))]
fn moved<V: State, const N: usize>(z: &V, terms: [(f64, &V); N]) -> V {
    let mut point = z.clone();
    for (a, k) in terms {
        point.add_multiple(V::Scalar::from_f64(a), k);
    }
    point
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::four_stages;
    use crate::schemes::runge_kutta::RungeKutta;
    use crate::schemes::scheme::Scheme;
    use crate::vector_field::from_fn;
    use lie_poisson::{Sites, State};
    use nalgebra::{Vector1, Vector2};

    /// A state on the heap takes the general way through the stages.
    #[test]
    fn it_is_the_general_step() {
        let eighths = [
            [0.0, 0.0, 0.0, 0.0],
            [1.0 / 3.0, 0.0, 0.0, 0.0],
            [-1.0 / 3.0, 1.0, 0.0, 0.0],
            [1.0, -1.0, 1.0, 0.0],
        ];
        let weights = [0.125, 0.375, 0.375, 0.125];
        let eighths = crate::Tableau::new(eighths.as_flattened(), &weights).unwrap();
        assert_eq!(eighths.order(), 4);
        for method in [RungeKutta::rk4(), RungeKutta::new(eighths)] {
            let small = from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x.sin()));
            let large = from_fn(|z: &Sites<Vector1<f64>>| {
                Sites::new(vec![z[1], Vector1::new(-z[0].x.sin())])
            });
            for (h, start) in [(0.3, Vector2::new(0.7, -0.2)), (1e-3, Vector2::new(-2.0, 3.0))] {
                let sites = Sites::new(vec![Vector1::new(start.x), Vector1::new(start.y)]);
                let end = method.step(&small, &start, h, &mut method.workspace()).unwrap().point;
                let other = method.step(&large, &sites, h, &mut method.workspace()).unwrap().point;
                for i in 0..2 {
                    // A rounding of h a_ij k_j and one of the sum for each of the ten terms.
                    let bound = 10.0 * f64::EPSILON * start.amax();
                    assert!((end[i] - other.coordinate(i)).abs() <= bound, "{end} {other:?}");
                    // Control: the step is far above the bound.
                    assert!((end[i] - start[i]).abs() > 1e9 * bound, "{end}");
                }
            }
        }
    }

    #[test]
    fn other_numbers_of_stages_have_another_way() {
        let field = from_fn(|z: &Vector1<f64>| -z);
        let one = Vector1::new(1.0);
        let sum = |method: RungeKutta| four_stages(method.tableau(), &field, &one, 0.1);
        assert!(sum(RungeKutta::explicit_midpoint()).is_none());
        assert!(sum(RungeKutta::dop853()).is_none());
        assert!(sum(RungeKutta::rk4()).is_some_and(|sum| sum.x < 0.0));
        // Low parts of the weights count.
        let rk4 = RungeKutta::rk4().tableau().clone();
        let low = rk4.clone().with_low_parts(&[0.0; 16], &[1e-3, 0.0, 0.0, 0.0]).unwrap();
        let end = |tableau| {
            let method = RungeKutta::new(tableau);
            method.step(&field, &one, 0.1, &mut method.workspace()).unwrap().point.x
        };
        assert!((end(low) - end(rk4) + 1e-4).abs() < 1e-15);
    }
}
