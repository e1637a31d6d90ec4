//! [`Vector`] for matrices of real and of complex numbers; products with constant matrices over every scalar.

use crate::numbers::mask::Mask;
use crate::numbers::real::Real;
use crate::spaces::covector::Covector;
use crate::spaces::state::State;
use crate::spaces::vector::Vector;
use nalgebra::{ArrayStorage, SMatrix, SVector, Vector3};
use num_complex::Complex;

/// The operations in place that nalgebra has as operators.
macro_rules! operations_by_operators {
    () => {
        #[cfg_attr(optimised, inline(always))]
        fn dimension(&self) -> usize {
            Self::DIM
        }

        #[cfg_attr(optimised, inline(always))]
        fn shape(&self) {}

        #[cfg_attr(optimised, inline(always))]
        fn zeros_of((): &()) -> Self {
            Self::zero()
        }

        #[cfg_attr(optimised, inline(always))]
        fn assign(&mut self, x: &Self) {
            *self = *x;
        }

        #[cfg_attr(optimised, inline(always))]
        fn move_from(&mut self, other: &mut Self) {
            *self = *other;
        }

        #[cfg_attr(optimised, inline(always))]
        fn set_zero(&mut self) {
            *self = Self::zero();
        }

        #[cfg_attr(optimised, inline(always))]
        fn add_in_place(&mut self, x: &Self) {
            *self += *x;
        }

        #[cfg_attr(optimised, inline(always))]
        fn subtract_in_place(&mut self, x: &Self) {
            *self -= *x;
        }

        #[cfg_attr(optimised, inline(always))]
        fn subtract_from(&mut self, x: &Self) {
            *self = *x - *self;
        }

        #[cfg_attr(optimised, inline(always))]
        fn negate_in_place(&mut self) {
            *self = -*self;
        }

        #[cfg_attr(optimised, inline(always))]
        fn set_coordinates(&mut self, f: impl Fn(usize) -> T) {
            *self = Self::from_coordinates(f);
        }

        #[cfg_attr(optimised, inline(always))]
        fn replace_where(&mut self, mask: <T as Real>::Mask, x: &Self) {
            *self = Vector::select(mask, x, self);
        }

        #[cfg_attr(optimised, inline(always))]
        fn is_finite(&self) -> bool {
            self.max_norm().at_most(T::from_f64(f64::MAX)).all()
        }

        #[cfg_attr(optimised, inline(always))]
        fn add_multiple(&mut self, s: T, x: &Self) {
            let mut product = *x;
            product.scale_in_place(s);
            *self += product;
        }
    };
}

impl<T: Real, const R: usize, const C: usize> State for SMatrix<T, R, C> {
    type Scalar = T;
    type Blocks = (T,);
    type Shape = ();
    type Pool = ();

    operations_by_operators!();

    #[cfg_attr(optimised, inline(always))]
    fn coordinate(&self, i: usize) -> T {
        match self.as_slice().get(i) {
            Some(x) => *x,
            None => T::zero(),
        }
    }

    #[cfg_attr(optimised, inline(always))]
    fn set_coordinate(&mut self, i: usize, x: T) {
        if let Some(coordinate) = self.as_mut_slice().get_mut(i) {
            *coordinate = x;
        }
    }

    #[cfg_attr(optimised, inline(always))]
    fn scale_in_place(&mut self, s: T) {
        for x in self.as_mut_slice() {
            *x *= s;
        }
    }
}

impl<T: Real, const R: usize, const C: usize> Vector for SMatrix<T, R, C> {
    type Dual = Covector<Self>;
    const DIM: usize = R * C;

    #[cfg_attr(optimised, inline(always))]
    fn from_coordinates(mut f: impl FnMut(usize) -> T) -> Self {
        let mut matrix = Self::from_array_storage(ArrayStorage([[T::zero(); R]; C]));
        // nalgebra stores by columns, which is the order of the coordinates.
        for (i, x) in matrix.as_mut_slice().iter_mut().enumerate() {
            *x = f(i);
        }
        matrix
    }
}

impl<T: Real, const R: usize, const C: usize> State for SMatrix<Complex<T>, R, C> {
    type Scalar = T;
    type Blocks = (T,);
    type Shape = ();
    type Pool = ();

    operations_by_operators!();

    #[cfg_attr(optimised, inline(always))]
    fn coordinate(&self, i: usize) -> T {
        match self.as_slice().get(i / 2) {
            Some(z) if i.is_multiple_of(2) => z.re,
            Some(z) => z.im,
            None => T::zero(),
        }
    }

    #[cfg_attr(optimised, inline(always))]
    fn set_coordinate(&mut self, i: usize, x: T) {
        match self.as_mut_slice().get_mut(i / 2) {
            Some(z) if i.is_multiple_of(2) => z.re = x,
            Some(z) => z.im = x,
            None => {}
        }
    }

    #[cfg_attr(optimised, inline(always))]
    fn scale_in_place(&mut self, s: T) {
        for z in self.as_mut_slice() {
            *z = Complex { re: z.re * s, im: z.im * s };
        }
    }
}

impl<T: Real, const R: usize, const C: usize> Vector for SMatrix<Complex<T>, R, C> {
    type Dual = Covector<Self>;
    const DIM: usize = 2 * R * C;

    #[cfg_attr(optimised, inline(always))]
    fn from_coordinates(mut f: impl FnMut(usize) -> T) -> Self {
        let zero = Complex { re: T::zero(), im: T::zero() };
        let mut matrix = Self::from_array_storage(ArrayStorage([[zero; R]; C]));
        for (i, z) in matrix.as_mut_slice().iter_mut().enumerate() {
            *z = Complex { re: f(2 * i), im: f(2 * i + 1) };
        }
        matrix
    }
}

/// Returns the cross product u×v over any scalar.
///
/// The result is bit-identical to that of nalgebra. The compiler inlines the function in code for every register, as
/// [`LaneTask`] requires of fast code.
///
/// [`LaneTask`]: crate::LaneTask
///
/// # Example
/// ```
/// use generic_scalars::cross;
/// use nalgebra::Vector3;
/// assert_eq!(cross(&Vector3::new(1.0, 2.0, 3.0), &Vector3::new(4.0, 5.0, 6.0)), Vector3::new(-3.0, 6.0, -3.0));
/// ```
#[must_use]
#[cfg_attr(optimised, inline(always))]
pub fn cross<T: Real>(u: &Vector3<T>, v: &Vector3<T>) -> Vector3<T> {
    Vector3::new(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x)
}

/// Returns the dot product u·v over any scalar, as [`cross`] returns the cross product.
///
/// # Example
/// ```
/// use generic_scalars::dot;
/// use nalgebra::Vector3;
/// assert_eq!(dot(&Vector3::new(1.0, 2.0, 3.0), &Vector3::new(4.0, 5.0, 6.0)), 32.0);
/// ```
#[must_use]
#[cfg_attr(optimised, inline(always))]
pub fn dot<T: Real>(u: &Vector3<T>, v: &Vector3<T>) -> T {
    u.x * v.x + u.y * v.y + u.z * v.z
}

/// Returns the product A v of a constant matrix and a vector over any scalar.
///
/// nalgebra multiplies only matrices of the same scalar. If a constant matrix were converted to the scalar of v, the
/// product would also multiply by its zero derivatives.
///
/// # Example
/// ```
/// use generic_scalars::{DualNumber, Real, constant_times};
/// use nalgebra::{Matrix2x3, Vector3};
/// let a = Matrix2x3::new(1.0, 2.0, 3.0, 4.0, 5.0, 6.0);
/// assert_eq!(constant_times(&a, &Vector3::new(1.0, 0.0, -1.0)), a * Vector3::new(1.0, 0.0, -1.0));
/// // the derivative by the second component is the second column
/// let v = Vector3::new(DualNumber::from_f64(1.0), DualNumber::variable(0.0), DualNumber::from_f64(-1.0));
/// assert_eq!(constant_times(&a, &v).map(|x| x.derivative()), a.column(1));
/// ```
#[must_use]
#[cfg_attr(optimised, inline(always))]
pub fn constant_times<T: Real, const R: usize, const C: usize>(
    a: &SMatrix<f64, R, C>,
    v: &SVector<T, C>,
) -> SVector<T, R> {
    let mut product = SVector::<T, R>::from_array_storage(ArrayStorage([[T::zero(); R]; 1]));
    for (i, x) in product.as_mut_slice().iter_mut().enumerate() {
        *x = sum_of_products(
            C,
            #[cfg_attr(optimised, inline(always))]
            |j| v[j] * a[(i, j)],
        );
    }
    product
}

/// Returns the product Aᵀ v of the transpose of a constant matrix and a vector over any scalar.
///
/// # Example
/// ```
/// use generic_scalars::constant_transpose_times;
/// use nalgebra::{Matrix2x3, Vector2, Vector3};
/// let a = Matrix2x3::new(1.0, 2.0, 3.0, 4.0, 5.0, 6.0);
/// assert_eq!(constant_transpose_times(&a, &Vector2::new(1.0, -1.0)), Vector3::new(-3.0, -3.0, -3.0));
/// ```
#[must_use]
#[cfg_attr(optimised, inline(always))]
pub fn constant_transpose_times<T: Real, const R: usize, const C: usize>(
    a: &SMatrix<f64, R, C>,
    v: &SVector<T, R>,
) -> SVector<T, C> {
    let mut product = SVector::<T, C>::from_array_storage(ArrayStorage([[T::zero(); C]; 1]));
    for (j, x) in product.as_mut_slice().iter_mut().enumerate() {
        *x = sum_of_products(
            R,
            #[cfg_attr(optimised, inline(always))]
            |i| v[i] * a[(i, j)],
        );
    }
    product
}

/// Returns the sum of the terms in order, from the first to the last, or zero if there are none.
#[cfg_attr(optimised, inline(always))]
fn sum_of_products<T: Real>(count: usize, term: impl Fn(usize) -> T) -> T {
    // A sum that starts from zero would lose the sign of −0.
    let mut sum = if count == 0 { T::zero() } else { term(0) };
    for i in 1..count {
        sum += term(i);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lanes::{DefaultLanes, Lanes};
    use crate::spaces::pair::Pair;
    use crate::spaces::power::Power;
    use nalgebra::{Matrix2, Vector2, Vector3};

    #[test]
    fn products_with_constants_are_those_of_nalgebra() {
        let a = SMatrix::<f64, 4, 3>::from_fn(|i, j| (1.3 * i as f64 - 2.1 * j as f64).sin());
        let (v, w) =
            (Vector3::new(0.3, -7.0, 1e-3), SVector::<f64, 4>::from_fn(|i, _| 0.1 + i as f64));
        for scale in [1e-30, 1.0, 1e30] {
            let a = a * scale;
            assert_eq!(constant_times(&a, &v), a * v);
            // nalgebra adds four products in another order.
            let error = (constant_transpose_times(&a, &w) - a.tr_mul(&w)).amax();
            assert!(error <= 4.0 * f64::EPSILON * a.amax() * w.amax(), "{error:e}");
            let lanes = constant_times(&a, &v.map(DefaultLanes::from_f64));
            assert_eq!(lanes.map(|x| x.lane(3)), a * v);
        }
        let empty = SMatrix::<f64, 2, 0>::zeros();
        assert_eq!(constant_times(&empty, &SVector::<f64, 0>::zeros()), Vector2::zeros());
        let spoilt = Matrix2::new(1.0, f64::NAN, 0.0, 1.0);
        assert!(constant_times(&spoilt, &Vector2::<f64>::zeros()).x.is_nan());
    }

    fn coordinates_are_a_basis<V: Vector<Scalar = f64>>() {
        let v = V::from_coordinates(|i| i as f64 + 1.0);
        let mut sum = V::zero();
        for i in 0..V::DIM {
            assert_eq!(v.coordinate(i), i as f64 + 1.0);
            assert_eq!(V::basis(i).pairing(&V::Dual::basis(i)), 1.0);
            sum.add_multiple(v.coordinate(i), &V::basis(i));
        }
        assert_eq!(sum, v);
        assert_eq!(v.coordinate(V::DIM), 0.0);
        assert_eq!(v.scaled(2.0) - v, v);
        assert_eq!((-v).max_abs(), V::DIM as f64);
        assert!(!v.scaled(f64::NAN).is_finite());
        for i in 0..V::DIM {
            // a maximum alone would lose all but the last
            let spoilt = V::from_coordinates(|j| if i == j { f64::NAN } else { v.coordinate(j) });
            assert!(spoilt.max_abs().is_nan());
        }
    }

    #[test]
    fn every_vector_type_is_its_coordinates() {
        coordinates_are_a_basis::<Vector3<f64>>();
        coordinates_are_a_basis::<Matrix2<Complex<f64>>>();
        coordinates_are_a_basis::<Covector<Vector3<f64>>>();
        coordinates_are_a_basis::<Pair<Vector2<Complex<f64>>, Covector<Vector3<f64>>>>();
        coordinates_are_a_basis::<Power<Vector3<f64>, 4>>();
    }

    #[test]
    fn complex_coordinates_alternate() {
        let chi = Vector2::new(Complex::new(1.0, 2.0), Complex::new(3.0, 4.0));
        assert_eq!([0, 1, 2, 3].map(|i| chi.coordinate(i)), [1.0, 2.0, 3.0, 4.0]);
    }
}
