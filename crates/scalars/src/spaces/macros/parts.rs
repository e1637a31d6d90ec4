//! Structures of one or two states: [`state_of_parts!`].

/// Implements [`State`](crate::State) for a structure whose fields are one or two states.
///
/// The arguments are the generic parameters of the implementation in brackets, the type, its scalar, and each field
/// with its type. The coordinates of the first field come first, and so do its blocks. A structure of more fields is one
/// of two, one of which is a [`Pair`](crate::Pair).
///
/// # Example
/// ```
/// use generic_scalars::{Sites, State, state_of_parts};
/// use nalgebra::Vector3;
///
/// /// Spins and the momentum of the lattice that carries them.
/// #[derive(Clone, Debug, PartialEq)]
/// struct Lattice { spins: Sites<Vector3<f64>>, momentum: Vector3<f64> }
/// state_of_parts!([] Lattice, f64, spins: Sites<Vector3<f64>>, momentum: Vector3<f64>);
///
/// let mut z = Lattice { spins: Sites::new(vec![Vector3::x(); 100]), momentum: Vector3::z() };
/// z.scale_in_place(2.0);
/// assert_eq!((z.dimension(), z.coordinate(0), z.coordinate(302)), (303, 2.0, 2.0));
/// assert_eq!((z.blocks(), z.block(299), z.block(300)), (2, 0, 1));
/// ```
#[macro_export]
macro_rules! state_of_parts {
    ([$($parameters:tt)*] $type:ty, $scalar:ty, $part:tt: $of:ty) => {
        impl<$($parameters)*> $crate::State for $type {
            type Scalar = $scalar;
            type Blocks = <$of as $crate::State>::Blocks;
            type Shape = <$of as $crate::State>::Shape;
            type Pool = <$of as $crate::State>::Pool;

            $crate::inlined! {
                fn dimension(&self) -> usize {
                    $crate::State::dimension(&self.$part)
                }

                fn shape(&self) -> Self::Shape {
                    $crate::State::shape(&self.$part)
                }

                fn zeros_of(shape: &Self::Shape) -> Self {
                    Self { $part: $crate::State::zeros_of(shape) }
                }

                fn take(pool: &mut Self::Pool, like: &Self) -> Self {
                    Self { $part: $crate::State::take(pool, &like.$part) }
                }

                fn give(self, pool: &mut Self::Pool) {
                    $crate::State::give(self.$part, pool);
                }

                fn coordinate(&self, i: usize) -> $scalar {
                    $crate::State::coordinate(&self.$part, i)
                }

                fn set_coordinate(&mut self, i: usize, x: $scalar) {
                    $crate::State::set_coordinate(&mut self.$part, i, x);
                }

                fn set_coordinates(&mut self, f: impl Fn(usize) -> $scalar) {
                    $crate::State::set_coordinates(&mut self.$part, f);
                }

                fn blocks(&self) -> usize {
                    $crate::State::blocks(&self.$part)
                }

                fn block(&self, i: usize) -> usize {
                    $crate::State::block(&self.$part, i)
                }

                fn measure(&self, largest: &mut Self::Blocks, sum: &mut $scalar) {
                    $crate::State::measure(&self.$part, largest, sum);
                }

                fn measure_difference(&self, x: &Self, largest: &mut Self::Blocks, sum: &mut $scalar) {
                    $crate::State::measure_difference(&self.$part, &x.$part, largest, sum);
                }
            }

            $crate::state_of_parts!(@in_place $scalar, $part);
        }
    };
    ([$($parameters:tt)*] $type:ty, $scalar:ty, $first:tt: $of_first:ty, $second:tt: $of_second:ty) => {
        impl<$($parameters)*> $crate::State for $type {
            type Scalar = $scalar;
            type Blocks = (<$of_first as $crate::State>::Blocks, <$of_second as $crate::State>::Blocks);
            type Shape = (<$of_first as $crate::State>::Shape, <$of_second as $crate::State>::Shape);
            type Pool = (<$of_first as $crate::State>::Pool, <$of_second as $crate::State>::Pool);

            $crate::inlined! {
                fn dimension(&self) -> usize {
                    $crate::State::dimension(&self.$first) + $crate::State::dimension(&self.$second)
                }

                fn shape(&self) -> Self::Shape {
                    ($crate::State::shape(&self.$first), $crate::State::shape(&self.$second))
                }

                fn zeros_of((first, second): &Self::Shape) -> Self {
                    let (first, second) = ($crate::State::zeros_of(first), $crate::State::zeros_of(second));
                    Self { $first: first, $second: second }
                }

                fn take(pool: &mut Self::Pool, like: &Self) -> Self {
                    let first = $crate::State::take(&mut pool.0, &like.$first);
                    let second = $crate::State::take(&mut pool.1, &like.$second);
                    Self { $first: first, $second: second }
                }

                fn give(self, pool: &mut Self::Pool) {
                    $crate::State::give(self.$first, &mut pool.0);
                    $crate::State::give(self.$second, &mut pool.1);
                }

                fn coordinate(&self, i: usize) -> $scalar {
                    match i.checked_sub($crate::State::dimension(&self.$first)) {
                        None => $crate::State::coordinate(&self.$first, i),
                        Some(i) => $crate::State::coordinate(&self.$second, i),
                    }
                }

                fn set_coordinate(&mut self, i: usize, x: $scalar) {
                    match i.checked_sub($crate::State::dimension(&self.$first)) {
                        None => $crate::State::set_coordinate(&mut self.$first, i, x),
                        Some(i) => $crate::State::set_coordinate(&mut self.$second, i, x),
                    }
                }

                fn set_coordinates(&mut self, f: impl Fn(usize) -> $scalar) {
                    let count = $crate::State::dimension(&self.$first);
                    $crate::State::set_coordinates(
                        &mut self.$first,
                        #[cfg_attr(optimised, inline(always))]
                        |i| f(i),
                    );
                    $crate::State::set_coordinates(
                        &mut self.$second,
                        #[cfg_attr(optimised, inline(always))]
                        |i| f(count + i),
                    );
                }

                /// Returns the block of a coordinate: the blocks of the first part come first.
                fn block(&self, i: usize) -> usize {
                    match i.checked_sub($crate::State::dimension(&self.$first)) {
                        None => $crate::State::block(&self.$first, i),
                        Some(i) => {
                            <$of_first as $crate::State>::BLOCKS + $crate::State::block(&self.$second, i)
                        }
                    }
                }

                fn measure(&self, largest: &mut Self::Blocks, sum: &mut $scalar) {
                    $crate::State::measure(&self.$first, &mut largest.0, sum);
                    $crate::State::measure(&self.$second, &mut largest.1, sum);
                }

                fn measure_difference(&self, x: &Self, largest: &mut Self::Blocks, sum: &mut $scalar) {
                    $crate::State::measure_difference(&self.$first, &x.$first, &mut largest.0, sum);
                    $crate::State::measure_difference(&self.$second, &x.$second, &mut largest.1, sum);
                }
            }

            $crate::state_of_parts!(@in_place $scalar, $first, $second);
        }
    };
    (@in_place $scalar:ty, $($part:tt),+) => {
        $crate::inlined! {
            fn assign(&mut self, x: &Self) {
                $($crate::State::assign(&mut self.$part, &x.$part);)+
            }

            fn move_from(&mut self, other: &mut Self) {
                $($crate::State::move_from(&mut self.$part, &mut other.$part);)+
            }

            fn set_zero(&mut self) {
                $($crate::State::set_zero(&mut self.$part);)+
            }

            fn add_in_place(&mut self, x: &Self) {
                $($crate::State::add_in_place(&mut self.$part, &x.$part);)+
            }

            fn subtract_in_place(&mut self, x: &Self) {
                $($crate::State::subtract_in_place(&mut self.$part, &x.$part);)+
            }

            fn subtract_from(&mut self, x: &Self) {
                $($crate::State::subtract_from(&mut self.$part, &x.$part);)+
            }

            fn negate_in_place(&mut self) {
                $($crate::State::negate_in_place(&mut self.$part);)+
            }

            fn scale_in_place(&mut self, s: $scalar) {
                $($crate::State::scale_in_place(&mut self.$part, s);)+
            }

            fn add_multiple(&mut self, s: $scalar, x: &Self) {
                $($crate::State::add_multiple(&mut self.$part, s, &x.$part);)+
            }

            fn replace_where(&mut self, mask: <$scalar as $crate::Real>::Mask, x: &Self) {
                $($crate::State::replace_where(&mut self.$part, mask, &x.$part);)+
            }

            fn is_finite(&self) -> bool {
                true $(& $crate::State::is_finite(&self.$part))+
            }
        }
    };
}
