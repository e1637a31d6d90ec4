//! Infinitesimal rotations of spinors, in components.

use lie_poisson::Lanes;

/// Returns the spinor i(w·σ)u + v.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn infinitesimal_rotation<T: Lanes>(w: &[T; 3], u: [T; 4], v: [T; 4]) -> [T; 4] {
    let ([w1, w2, w3], [u1, u2, u3, u4]) = (*w, u);
    [
        w2.multiply_add(u3, w1.negative_multiply_add(u4, w3.negative_multiply_add(u2, v[0]))),
        w2.multiply_add(u4, w1.multiply_add(u3, w3.multiply_add(u1, v[1]))),
        w3.multiply_add(u4, w2.negative_multiply_add(u1, w1.negative_multiply_add(u2, v[2]))),
        w3.negative_multiply_add(u3, w2.negative_multiply_add(u2, w1.multiply_add(u1, v[3]))),
    ]
}
