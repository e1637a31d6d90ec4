//! The operators of small vectors: [`vector_operators!`].

/// Implements the operators `+`, `−` and their assignments for a small [`State`](crate::State) by its operations in place, as
/// [`Vector`](crate::Vector) requires.
///
/// The arguments are the generic parameters of the implementation in brackets and the type.
///
/// # Example
/// ```
/// use generic_scalars::{Covector, Real, Vector, state_of_parts, vector_operators};
/// use nalgebra::{Vector1, Vector3};
///
/// /// The angular velocity of a body and the speed of a rotor in it.
/// #[derive(Clone, Copy, Debug, PartialEq)]
/// struct Gyrostat<T: Real> { body: Vector3<T>, rotor: Vector1<T> }
///
/// state_of_parts!([T: Real] Gyrostat<T>, T, body: Vector3<T>, rotor: Vector1<T>);
/// vector_operators!([T: Real] Gyrostat<T>);
/// impl<T: Real> Vector for Gyrostat<T> {
///     type Dual = Covector<Self>;
///     const DIM: usize = 4;
///     fn from_coordinates(mut f: impl FnMut(usize) -> T) -> Self {
///         Self { body: Vector3::new(f(0), f(1), f(2)), rotor: Vector1::new(f(3)) }
///     }
/// }
///
/// let x = Gyrostat { body: Vector3::z(), rotor: Vector1::new(50.0) };
/// assert_eq!((x + x - x.scaled(3.0)).rotor.x, -50.0);
/// ```
#[macro_export]
macro_rules! vector_operators {
    ([$($parameters:tt)*] $type:ty) => {
        $crate::vector_operators!(@operator [$($parameters)*] $type, Add, add, AddAssign, add_assign, add_in_place);
        $crate::vector_operators!(@operator [$($parameters)*] $type, Sub, sub, SubAssign, sub_assign, subtract_in_place);

        impl<$($parameters)*> ::core::ops::Neg for $type {
            type Output = Self;
            $crate::inlined! {
                fn neg(mut self) -> Self {
                    $crate::State::negate_in_place(&mut self);
                    self
                }
            }
        }
    };
    (@operator [$($parameters:tt)*] $type:ty, $trait:ident, $by_value:ident, $assign:ident, $assigning:ident, $in_place:ident) => {
        impl<$($parameters)*> ::core::ops::$trait for $type {
            type Output = Self;
            $crate::inlined! {
                fn $by_value(mut self, x: Self) -> Self {
                    $crate::State::$in_place(&mut self, &x);
                    self
                }
            }
        }

        impl<$($parameters)*> ::core::ops::$assign for $type {
            $crate::inlined! {
                fn $assigning(&mut self, x: Self) {
                    $crate::State::$in_place(self, &x);
                }
            }
        }
    };
}
