//! Code for a dimension that is known only when the program runs: [`for_dimension`].

/// Code that is generic over a dimension N.
pub trait DimensionTask {
    /// The type of the result.
    type Output;

    /// Runs the code for the dimension N.
    fn run<const N: usize>(self) -> Self::Output;
}

/// Runs code for a dimension from 1 to 15, and returns `None` for any other.
///
/// # Example
/// ```
/// use lie_poisson::RealSpace;
/// use lie_poisson_formulas::{DimensionTask, NamedAlgebra, for_dimension};
///
/// /// Names the last coordinate of Rᴺ.
/// struct LastName;
/// impl DimensionTask for LastName {
///     type Output = Option<String>;
///     fn run<const N: usize>(self) -> Option<String> {
///         RealSpace::<N>.coordinates().ok()?.names().last()
///     }
/// }
/// assert_eq!(for_dimension(4, LastName), Some(Some("p4".to_owned())));
/// assert_eq!(for_dimension(16, LastName), None);
/// ```
pub fn for_dimension<F: DimensionTask>(dimension: usize, task: F) -> Option<F::Output> {
    macro_rules! dispatch {
        ($($n:literal)*) => {
            match dimension {
                $($n => Some(task.run::<$n>()),)*
                _ => None,
            }
        };
    }
    dispatch!(1 2 3 4 5 6 7 8 9 10 11 12 13 14 15)
}
