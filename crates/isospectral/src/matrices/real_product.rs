//! Products of real matrices, by the crate `gemm-f64`: [`real_product`].

use core::ops::Range;
use gemm_common::Parallelism;
use gemm_f64::gemm::f64::get_gemm_fn;

/// The right factor of a product.
#[derive(Clone, Copy)]
pub(super) enum Right<'a> {
    /// B itself.
    Plain(&'a [f64]),
    /// The transpose of B.
    Transposed(&'a [f64]),
}

/// Writes a part of the product a A B of N×N matrices, each column by column: the first `rows` rows, in these columns.
/// Nothing is written if a matrix does not have N² entries, or the part is larger than the product.
#[allow(unsafe_code)] // the library takes pointers
pub(super) fn real_product(
    size: usize,
    (rows, columns): (usize, Range<usize>),
    product: &mut [f64],
    (a, left, right): (f64, &[f64], Right<'_>),
) {
    let entries = size.checked_mul(size);
    let (b, down, across) = match right {
        Right::Plain(b) => (b, 1, size),
        Right::Transposed(b) => (b, size, 1),
    };
    let are_whole = [left.len(), b.len(), product.len()].iter().all(|len| Some(*len) == entries);
    let is_part = rows <= size && columns.start < columns.end && columns.end <= size;
    if !are_whole || !is_part || rows == 0 {
        return;
    }
    let count = columns.len();
    // Distances in memory: no matrix has more than `isize::MAX` entries.
    let [size_as_step, down, across] = [size, down, across].map(|step| step as isize);
    // SAFETY: the columns from `columns.start` to `columns.end` of the product and of B, and the first rows of A, lie within
    // the slices, whose lengths are N², since entry (j, k) is at j + N k and j, k < N; the product is borrowed alone, and
    // is written before it is read, since `read_dst` is false.
    unsafe {
        get_gemm_fn()(
            rows,
            count,
            size,
            product.as_mut_ptr().add(size * columns.start),
            size_as_step,
            1,
            false,
            left.as_ptr(),
            size_as_step,
            1,
            b.as_ptr().add(columns.start * across.unsigned_abs()),
            across,
            down,
            0.0,
            a,
            false,
            false,
            false,
            Parallelism::None,
        );
    }
}
