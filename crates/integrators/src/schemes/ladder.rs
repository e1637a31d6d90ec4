//! Steps of explicit Runge–Kutta methods each of whose stages needs no more than the one before it: [`Ladder`].

use crate::tableaux::tableau::Tableau;
use crate::vector_field::VectorField;
use lie_poisson::{Real, State};

/// The size of a state, in bytes, above which there is nothing to gain.
const LARGEST: usize = 512;

/// The coefficients of an explicit method with the stages `k_i = f(z + h a_i k_(i−1))`, such as the classical one of order 4.
///
/// Each `a_i` is a power of two, so that a step has the bits of the general way through the stages.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Ladder {
    /// The pairs `(a_i, b_i)`; the first `a_i` is 0.
    rungs: Vec<(f64, f64)>,
}

impl Ladder {
    /// Returns the coefficients of a method; `None` if it is of another kind, or has low parts.
    pub(crate) fn new(tableau: &Tableau) -> Option<Self> {
        let is_plain = tableau.weights_low().is_empty() && tableau.row_low(0).is_empty();
        let rung = |(i, row): (usize, &[f64])| {
            let a = i.checked_sub(1).map_or(0.0, |before| row[before]);
            let is_alone = row.iter().enumerate().all(|(j, &x)| x == 0.0 || j + 1 == i);
            // The mantissa of 0 and of a power of two.
            (is_alone && a.to_bits().trailing_zeros() >= 52).then_some(a)
        };
        let a: Option<Vec<_>> = tableau.rows().enumerate().map(rung).collect();
        let rungs = a.filter(|_| is_plain)?.into_iter().zip(tableau.weights().iter().copied());
        Some(Self { rungs: rungs.collect() })
    }

    /// Returns Σ `b_i k_i`; `None` for states that are large or on the heap.
    ///
    /// The field is called at one place, to be inlined there: z, a stage and the sum of a small state stay in registers.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn sum<T: Real, F: VectorField<T>>(
        &self,
        field: &F,
        z: &F::Point,
        step: f64,
    ) -> Option<F::Point> {
        if size_of::<<F::Point as State>::Pool>() > 0 || size_of::<F::Point>() > LARGEST {
            return None;
        }
        let (mut sum, mut k, mut stage) = (z.zeros_like(), z.zeros_like(), z.clone());
        for &(a, b) in &self.rungs {
            stage.assign(z);
            stage.add_multiple(T::from_f64(step * a), &k);
            field.at_into(&stage, &mut k);
            sum.add_multiple(T::from_f64(b), &k);
        }
        Some(sum)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::Ladder;
    use crate::schemes::runge_kutta::RungeKutta;
    use crate::schemes::scheme::Scheme;
    use crate::tableaux::tableau::Tableau;
    use crate::vector_field::from_fn;
    use lie_poisson::{Sites, State};
    use nalgebra::{Vector1, Vector2};

    /// A state on the heap takes the general way through the stages.
    /// A state on the heap takes the general way through the stages.
    #[test]
    fn it_has_the_bits_of_the_general_step() {
        let heun = Tableau::new(&[0.0, 0.0, 1.0, 0.0], &[0.5, 0.5]).unwrap();
        for method in [RungeKutta::rk4(), RungeKutta::explicit_midpoint(), RungeKutta::new(heun)] {
            assert!(Ladder::new(method.tableau()).is_some());
            let small = from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x.sin()));
            let large = from_fn(|z: &Sites<Vector1<f64>>| {
                Sites::new(vec![z[1], Vector1::new(-z[0].x.sin())])
            });
            for (h, start) in [(0.3, Vector2::new(0.7, -0.2)), (1e-3, Vector2::new(-2.0, 3.0))] {
                let sites = Sites::new(vec![Vector1::new(start.x), Vector1::new(start.y)]);
                let end = method.step(&small, &start, h, &mut method.workspace()).unwrap().point;
                let other = method.step(&large, &sites, h, &mut method.workspace()).unwrap().point;
                assert_eq!([end.x, end.y], [other.coordinate(0), other.coordinate(1)]);
                assert!((end - start).norm() > 1e-4);
            }
        }
    }

    #[test]
    fn other_methods_have_another_way() {
        let eighths = [
            [0.0, 0.0, 0.0, 0.0],
            [1.0 / 3.0, 0.0, 0.0, 0.0],
            [-1.0 / 3.0, 1.0, 0.0, 0.0],
            [1.0, -1.0, 1.0, 0.0],
        ];
        let eighths = Tableau::new(eighths.as_flattened(), &[0.125, 0.375, 0.375, 0.125]).unwrap();
        assert_eq!((eighths.order(), Ladder::new(&eighths)), (4, None));
        // Its factor 2/3 is no power of two.
        let ralston = Tableau::new(&[0.0, 0.0, 2.0 / 3.0, 0.0], &[0.25, 0.75]).unwrap();
        assert_eq!((ralston.order(), Ladder::new(&ralston)), (2, None));
        assert_eq!(Ladder::new(RungeKutta::dop853().tableau()), None);
        assert_eq!(Ladder::new(RungeKutta::implicit_midpoint().tableau()), None);
        // Low parts of the weights count.
        let rk4 = RungeKutta::rk4().tableau().clone();
        let low = rk4.clone().with_low_parts(&[0.0; 16], &[1e-3, 0.0, 0.0, 0.0]).unwrap();
        assert_eq!(Ladder::new(&low), None);
        let field = from_fn(|z: &Vector1<f64>| -z);
        let end = |tableau| {
            let (method, one) = (RungeKutta::new(tableau), Vector1::new(1.0));
            method.step(&field, &one, 0.1, &mut method.workspace()).unwrap().point.x
        };
        assert!((end(low) - end(rk4) + 1e-4).abs() < 1e-15);
    }
}
