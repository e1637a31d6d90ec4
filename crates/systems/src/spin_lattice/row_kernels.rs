//! The formulas of the spherical midpoint method for one row of a lattice of spins, on SIMD lanes.

use crate::spin_lattice::stencil::{BLOCK, Block, Spins, Stencil};
use lie_poisson::Real;
use lie_poisson::generic_scalars::Lanes;

/// The largest change and size of the rates in each lane, with the sum of the changes, which keeps a NaN that they lose.
#[derive(Clone, Copy)]
pub(crate) struct Progress<T> {
    change: T,
    size: T,
    sum: T,
}

impl<T: Lanes> Progress<T> {
    /// Returns that of no rate.
    #[inline(always)]
    pub(crate) fn zero() -> Self {
        let zero = T::from_f64(0.0);
        Self { change: zero, size: zero, sum: zero }
    }

    /// Includes a component of rates and its value before.
    #[inline(always)]
    fn include(&mut self, rate: T, before: T) {
        let change = (rate - before).magnitude();
        self.change = change.maximum(self.change);
        self.size = rate.magnitude().maximum(self.size);
        self.sum += change;
    }

    /// Returns the largest change and the largest size over all lanes, or NaN.
    #[inline(always)]
    pub(crate) fn largest(self) -> [f64; 2] {
        let sum = self.sum.max_abs();
        if sum.is_nan() { [sum; 2] } else { [self.change.max_abs(), self.size.max_abs()] }
    }
}

/// Returns the x, y and z of consecutive spins, in blocks, from a place in a row of `width` numbers on.
#[inline(always)]
pub(crate) fn three(all: &[f64], from: usize, width: usize, blocks: usize) -> [&[Block]; 3] {
    [0, 1, 2].map(|c| {
        let rest = all.get(from + c * width..).unwrap_or_default();
        rest.as_chunks().0.get(..blocks).unwrap_or_default()
    })
}

/// Computes the midpoints m = |w| u/|u|, u = w + (h/2) k, of a row.
#[inline(always)]
pub(crate) fn middles<T: Lanes>(
    w: &[Spins],
    k: &[Spins],
    half_step: f64,
    [m_x, m_y, m_z]: [&mut [Block]; 3],
) {
    let half_step = T::from_f64(half_step);
    let m = m_x.iter_mut().zip(m_y).zip(m_z);
    for ((Spins(w), Spins(k)), ((m_x, m_y), m_z)) in w.iter().zip(k).zip(m) {
        for i in (0..BLOCK).step_by(T::COUNT) {
            let w = [T::load(&w[0][i..]), T::load(&w[1][i..]), T::load(&w[2][i..])];
            let x = T::load(&k[0][i..]).multiply_add(half_step, w[0]);
            let y = T::load(&k[1][i..]).multiply_add(half_step, w[1]);
            let z = T::load(&k[2][i..]).multiply_add(half_step, w[2]);
            let factor = Real::sqrt(square(&w) / square(&[x, y, z]));
            (x * factor).store(&mut m_x[i..]);
            (y * factor).store(&mut m_y[i..]);
            (z * factor).store(&mut m_z[i..]);
        }
    }
}

#[inline(always)]
fn square<T: Lanes>(v: &[T; 3]) -> T {
    v[0].multiply_add(v[0], v[1].multiply_add(v[1], v[2] * v[2]))
}

/// Adds J (a + b) to the fields, for the spins a and b at both ends of bonds.
#[inline(always)]
pub(crate) fn add_bonds<T: Lanes>(
    fields: &mut [Spins],
    constant: f64,
    a: [&[Block]; 3],
    b: [&[Block]; 3],
) {
    let constant = T::from_f64(constant);
    for c in 0..3 {
        for ((Spins(sum), a), b) in fields.iter_mut().zip(a[c]).zip(b[c]) {
            for i in (0..BLOCK).step_by(T::COUNT) {
                let ends = T::load(&a[i..]) + T::load(&b[i..]);
                ends.multiply_add(constant, T::load(&sum[c][i..])).store(&mut sum[c][i..]);
            }
        }
    }
}

/// Completes the fields H of a block by the anisotropy, and writes the rates m × H. They are zero in the padding, where
/// `mask` is zero instead of one.
#[inline(always)]
pub(crate) fn rates<T: Lanes>(
    stencil: &Stencil,
    (m, Spins(fields)): ([&Block; 3], &Spins),
    mask: Option<&Block>,
    (Spins(k), Spins(next)): (&Spins, &mut Spins),
    progress: &mut Progress<T>,
) {
    for i in (0..BLOCK).step_by(T::COUNT) {
        let m = [T::load(&m[0][i..]), T::load(&m[1][i..]), T::load(&m[2][i..])];
        let mut h = [T::load(&fields[0][i..]), T::load(&fields[1][i..]), T::load(&fields[2][i..])];
        if stencil.twice_anisotropy != 0.0 {
            add_anisotropy(stencil, &m, &mut h);
        }
        let mut rate = cross(&m, &h);
        if let Some(mask) = mask {
            // A product would keep a NaN that an earlier step has left beyond the row.
            let (inside, zero) = (T::from_f64(1.0).at_most(T::load(&mask[i..])), T::from_f64(0.0));
            for rate in &mut rate {
                *rate = T::select(inside, *rate, zero);
            }
        }
        for c in 0..3 {
            progress.include(rate[c], T::load(&k[c][i..]));
            rate[c].store(&mut next[c][i..]);
        }
    }
}

/// Returns a × b.
#[inline(always)]
fn cross<T: Lanes>(a: &[T; 3], b: &[T; 3]) -> [T; 3] {
    [
        a[1].multiply_subtract(b[2], a[2] * b[1]),
        a[2].multiply_subtract(b[0], a[0] * b[2]),
        a[0].multiply_subtract(b[1], a[1] * b[0]),
    ]
}

/// Adds 2K (a·m) a to the field.
#[inline(always)]
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
