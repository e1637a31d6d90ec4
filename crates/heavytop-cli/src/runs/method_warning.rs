//! Warnings about what a method does not conserve.

use heavytop::methods::{Method, Scheme};

/// Returns a warning for users about what the method does not conserve.
pub(crate) fn method_warning(method: &Method) -> Option<String> {
    matches!(method.scheme(), Scheme::Partitioned(_)).then(|| {
        format!(
            "warning: {} does not descend from T*C² to se(3)*: what comes out depends on the lift, \
             and f1 and f2 are not conserved",
            method.scheme()
        )
    })
}
