//! The formulas of the spherical midpoint method for one row of a lattice of spins, on SIMD lanes.

use crate::spin_lattice::stencil::{BLOCK, Spins, Stencil};
use lie_poisson::Real;
use lie_poisson::generic_scalars::Lanes;

/// The largest change and size of the rates in each lane, with the sum of the changes. The sum keeps a NaN that the
/// maxima lose.
#[derive(Clone, Copy)]
pub(crate) struct Progress<T> {
    change: T,
    size: T,
    sum: T,
}

impl<T: Lanes> Progress<T> {
    /// Returns the progress before any rate is included.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn zero() -> Self {
        let zero = T::from_f64(0.0);
        Self { change: zero, size: zero, sum: zero }
    }

    /// Includes a component of rates and its value before.
    #[cfg_attr(optimised, inline(always))]
    fn include(&mut self, rate: T, before: T) {
        let change = (rate - before).magnitude();
        self.change = change.maximum(self.change);
        self.size = rate.magnitude().maximum(self.size);
        self.sum += change;
    }

    /// Returns the largest change and the largest size over all lanes, or NaN.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn largest(self) -> [f64; 2] {
        let sum = self.sum.max_abs();
        if sum.is_nan() { [sum; 2] } else { [self.change.max_abs(), self.size.max_abs()] }
    }
}

/// Computes the midpoints m = |w| u/|u|, u = w + (h/2) k, of a row.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn middles<T: Lanes>(w: &[Spins], k: &[Spins], half_step: f64, m: &mut [Spins]) {
    let half_step = T::from_f64(half_step);
    for ((Spins(w), Spins(k)), Spins(m)) in w.iter().zip(k).zip(m) {
        for i in (0..BLOCK).step_by(T::COUNT) {
            let w = [T::load(&w[0][i..]), T::load(&w[1][i..]), T::load(&w[2][i..])];
            let x = T::load(&k[0][i..]).multiply_add(half_step, w[0]);
            let y = T::load(&k[1][i..]).multiply_add(half_step, w[1]);
            let z = T::load(&k[2][i..]).multiply_add(half_step, w[2]);
            let factor = Real::sqrt(square(&w) / square(&[x, y, z]));
            (x * factor).store(&mut m[0][i..]);
            (y * factor).store(&mut m[1][i..]);
            (z * factor).store(&mut m[2][i..]);
        }
    }
}

#[cfg_attr(optimised, inline(always))]
fn square<T: Lanes>(v: &[T; 3]) -> T {
    v[0].multiply_add(v[0], v[1].multiply_add(v[1], v[2] * v[2]))
}

/// The two ends of a bond of each spin.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Ends {
    /// The distances of the two ends from the block of the spin, in blocks of midpoints.
    pub(crate) distances: [isize; 2],
    /// The exchange constant J.
    pub(crate) constant: f64,
}

/// A row of spins.
#[derive(Clone, Copy)]
pub(crate) struct Row<'a> {
    /// The midpoints m of this row and of all others that its bonds reach.
    pub(crate) midpoints: &'a [Spins],
    /// The place of its first block among them.
    pub(crate) first: usize,
    /// Its rates in the sweep before.
    pub(crate) k: &'a [Spins],
}

/// Writes the rates m × H of a row. They are zero in the padding.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn rates<T: Lanes>(
    stencil: &Stencil,
    row: Row<'_>,
    ends: &[Ends],
    next: &mut [Spins],
    progress: &mut Progress<T>,
) {
    for (block, (Spins(k), Spins(next))) in row.k.iter().zip(next).enumerate() {
        let at = row.first + block;
        let Spins(m) = &row.midpoints[at];
        for i in (0..BLOCK).step_by(T::COUNT) {
            let m = [T::load(&m[0][i..]), T::load(&m[1][i..]), T::load(&m[2][i..])];
            let mut h = exchange(stencil, row.midpoints, ends, (at, i));
            if stencil.twice_anisotropy != 0.0 {
                add_anisotropy(stencil, &m, &mut h);
            }
            let mut rate = cross(&m, &h);
            if let Some(mask) = stencil.masks.get(block) {
                clear_padding(&T::load(&mask[i..]), &mut rate);
            }
            for c in 0..3 {
                progress.include(rate[c], T::load(&k[c][i..]));
                rate[c].store(&mut next[c][i..]);
            }
        }
    }
}

/// Returns B and the exchange terms Σ J (a + b) of the field H of the spins from lane `i` of a block on, for the spins
/// a and b at both ends of each bond.
#[cfg_attr(optimised, inline(always))]
fn exchange<T: Lanes>(
    stencil: &Stencil,
    midpoints: &[Spins],
    ends: &[Ends],
    (at, i): (usize, usize),
) -> [T; 3] {
    let b = stencil.field;
    let mut h = [T::from_f64(b.x), T::from_f64(b.y), T::from_f64(b.z)];
    for Ends { distances: [to, from], constant } in ends {
        let Spins(to) = &midpoints[at.wrapping_add_signed(*to)];
        let Spins(from) = &midpoints[at.wrapping_add_signed(*from)];
        let constant = T::from_f64(*constant);
        for c in 0..3 {
            let ends = T::load(&to[c][i..]) + T::load(&from[c][i..]);
            h[c] = ends.multiply_add(constant, h[c]);
        }
    }
    h
}

/// Replaces rates by zero where the mask is zero instead of one.
#[cfg_attr(optimised, inline(always))]
fn clear_padding<T: Lanes>(mask: &T, rates: &mut [T; 3]) {
    // A product would keep a NaN that an earlier step has left beyond the row.
    let (inside, zero) = (T::from_f64(1.0).at_most(*mask), T::from_f64(0.0));
    for rate in rates {
        *rate = T::select(inside, *rate, zero);
    }
}

/// Returns a × b.
#[cfg_attr(optimised, inline(always))]
fn cross<T: Lanes>(a: &[T; 3], b: &[T; 3]) -> [T; 3] {
    [
        a[1].multiply_subtract(b[2], a[2] * b[1]),
        a[2].multiply_subtract(b[0], a[0] * b[2]),
        a[0].multiply_subtract(b[1], a[1] * b[0]),
    ]
}

/// Adds 2K (a·m) a to the field.
#[cfg_attr(optimised, inline(always))]
fn add_anisotropy<T: Lanes>(stencil: &Stencil, m: &[T; 3], field: &mut [T; 3]) {
    let a = stencil.axis;
    let a = [T::from_f64(a.x), T::from_f64(a.y), T::from_f64(a.z)];
    let along = a[0].multiply_add(m[0], a[1].multiply_add(m[1], a[2] * m[2]));
    let along = along * T::from_f64(stencil.twice_anisotropy);
    *field = [
        along.multiply_add(a[0], field[0]),
        along.multiply_add(a[1], field[1]),
        along.multiply_add(a[2], field[2]),
    ];
}
