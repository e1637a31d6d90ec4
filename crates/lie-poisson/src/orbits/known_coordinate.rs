//! Coordinates whose rates are known, and their axes: `axis_of_known_coordinate!`.

/// Implements [`Vector`](generic_scalars::Vector) for a structure of one number whose rate is known before the stages of a step
/// are, and [`PoissonSpace`](crate::PoissonSpace) with the bracket 0 for the axis of these numbers.
///
/// No iteration for stages waits for such a number: the difference of two of them has the size 0. Its own size and its
/// finiteness are those of any number.
macro_rules! axis_of_known_coordinate {
    ($axis:ty, $coordinate:ident) => {
        impl<T: generic_scalars::Real> generic_scalars::State for $coordinate<T> {
            type Scalar = T;
            type Blocks = (T,);
            type Shape = ();
            type Pool = ();

            #[cfg_attr(optimised, inline(always))]
            fn dimension(&self) -> usize {
                1
            }

            #[cfg_attr(optimised, inline(always))]
            fn shape(&self) {}

            #[cfg_attr(optimised, inline(always))]
            fn zeros_of((): &()) -> Self {
                Self(T::zero())
            }

            #[cfg_attr(optimised, inline(always))]
            fn coordinate(&self, i: usize) -> T {
                if i == 0 { self.0 } else { T::zero() }
            }

            #[cfg_attr(optimised, inline(always))]
            fn set_coordinate(&mut self, i: usize, x: T) {
                if i == 0 {
                    self.0 = x;
                }
            }

            #[cfg_attr(optimised, inline(always))]
            fn scale_in_place(&mut self, s: T) {
                self.0 *= s;
            }

            #[cfg_attr(optimised, inline(always))]
            fn add_multiple(&mut self, s: T, x: &Self) {
                self.0 += s * x.0;
            }

            #[cfg_attr(optimised, inline(always))]
            fn measure_difference(&self, _: &Self, _: &mut (T,), _: &mut T) {}
        }

        generic_scalars::vector_operators!([T: generic_scalars::Real] $coordinate<T>);

        impl<T: generic_scalars::Real> generic_scalars::Vector for $coordinate<T> {
            type Dual = generic_scalars::Covector<Self>;
            const DIM: usize = 1;

            #[cfg_attr(optimised, inline(always))]
            fn from_coordinates(mut f: impl FnMut(usize) -> T) -> Self {
                Self(f(0))
            }
        }

        impl generic_scalars::VectorSpace for $axis {
            type Point<T: generic_scalars::Real> = $coordinate<T>;
        }

        impl $crate::PoissonSpace for $axis {
            #[cfg_attr(optimised, inline(always))]
            fn hamiltonian_vector<T: generic_scalars::Real>(
                &self,
                _: &$coordinate<T>,
                _: &generic_scalars::Covector<$coordinate<T>>,
            ) -> $coordinate<T> {
                $coordinate(T::zero())
            }
        }
    };
}
pub(super) use axis_of_known_coordinate;
