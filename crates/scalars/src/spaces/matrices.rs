//! [`Vector`] for matrices of real and of complex numbers.

use crate::{Covector, Real, Vector, state_by_value};
use nalgebra::SMatrix;
use num_complex::Complex;

state_by_value!([T: Real, const R: usize, const C: usize] SMatrix<T, R, C>, T, (T,));

impl<T: Real, const R: usize, const C: usize> Vector for SMatrix<T, R, C> {
    type Dual = Covector<Self>;
    const DIM: usize = R * C;

    #[inline]
    fn from_coordinates(mut f: impl FnMut(usize) -> T) -> Self {
        let mut matrix = Self::zeros();
        // nalgebra stores by columns, which is the order of the coordinates.
        for (i, x) in matrix.as_mut_slice().iter_mut().enumerate() {
            *x = f(i);
        }
        matrix
    }

    #[inline]
    fn coordinate(&self, i: usize) -> T {
        self.as_slice().get(i).copied().unwrap_or_else(T::zero)
    }

    #[inline]
    fn scaled(&self, s: T) -> Self {
        self.map(|x| x * s)
    }
}

state_by_value!([T: Real, const R: usize, const C: usize] SMatrix<Complex<T>, R, C>, T, (T,));

impl<T: Real, const R: usize, const C: usize> Vector for SMatrix<Complex<T>, R, C> {
    type Dual = Covector<Self>;
    const DIM: usize = 2 * R * C;

    #[inline]
    fn from_coordinates(mut f: impl FnMut(usize) -> T) -> Self {
        let mut matrix = Self::zeros();
        for (i, z) in matrix.as_mut_slice().iter_mut().enumerate() {
            *z = Complex { re: f(2 * i), im: f(2 * i + 1) };
        }
        matrix
    }

    #[inline]
    fn coordinate(&self, i: usize) -> T {
        let z = self.as_slice().get(i / 2);
        z.map_or_else(T::zero, |z| if i.is_multiple_of(2) { z.re } else { z.im })
    }

    #[inline]
    fn scaled(&self, s: T) -> Self {
        self.map(|z| Complex { re: z.re * s, im: z.im * s })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Pair, Power};
    use nalgebra::{Matrix2, Vector2, Vector3};

    fn coordinates_are_a_basis<V: Vector<Scalar = f64>>() {
        let v = V::from_coordinates(|i| i as f64 + 1.0);
        let mut sum = V::zero();
        for i in 0..V::DIM {
            assert_eq!(v.coordinate(i), i as f64 + 1.0);
            assert_eq!(V::basis(i).pairing(&V::Dual::basis(i)), 1.0);
            sum.add_scaled(v.coordinate(i), &V::basis(i));
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
