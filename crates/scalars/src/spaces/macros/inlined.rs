//! How macros for other crates mark a function for inlining: [`inlined!`].

/// Marks every function for inlining if this crate was compiled with optimisation.
///
/// An attribute that the other crate decides about would have to be explained to every user, and without it a vector
/// of their own would lose its registers. `docs/architecture.md` explains why the mark depends on the optimisation.
#[doc(hidden)]
#[macro_export]
#[cfg(optimised)]
macro_rules! inlined {
    ($($(#[$meta:meta])* fn $name:ident $arguments:tt $(-> $result:ty)? $body:block)*) => {$(
        $(#[$meta])*
        #[inline(always)]
        fn $name $arguments $(-> $result)? $body
    )*};
}

/// Marks no function for inlining, since this crate was compiled without optimisation.
#[doc(hidden)]
#[macro_export]
#[cfg(not(optimised))]
macro_rules! inlined {
    ($($function:tt)*) => { $($function)* };
}
