//! Numbers and choices from the bytes of a case.

use nalgebra::Vector3;

/// Numbers at which formulas branch, overflow or lose digits.
const SPECIAL: [f64; 16] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::MIN_POSITIVE,
    5e-324,
    f64::MAX,
    f64::MIN,
    f64::EPSILON,
    1e154,
    1e-154,
    1e308,
    1e-308,
];

/// The bytes of a case that are still to be read. Behind their end there are zeros.
pub(crate) struct Input<'a>(&'a [u8]);

impl<'a> Input<'a> {
    pub(crate) fn new(bytes: &'a [u8]) -> Self {
        Self(bytes)
    }

    pub(crate) fn byte(&mut self) -> u8 {
        let Some((first, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        *first
    }

    /// Returns a number below `count`.
    pub(crate) fn choice(&mut self, count: usize) -> usize {
        usize::from(self.byte()) % count
    }

    fn bytes<const N: usize>(&mut self) -> [u8; N] {
        [(); N].map(|()| self.byte())
    }

    /// Returns an ordinary number in [−8, 8).
    pub(crate) fn ordinary(&mut self) -> f64 {
        f64::from(i16::from_le_bytes(self.bytes())) / 4096.0
    }

    /// Returns a power of ten from 1e−154 to 1e154, or with equal probability 1.
    pub(crate) fn scale(&mut self) -> f64 {
        let exponent = i32::from(self.byte()) - 128;
        if exponent < 0 { 1.0 } else { 10.0_f64.powi((exponent - 64) * 154 / 64) }
    }

    /// Returns any number: an ordinary one in half of the cases.
    pub(crate) fn number(&mut self) -> f64 {
        match self.byte() % 8 {
            0 => f64::from_le_bytes(self.bytes()),
            1 => SPECIAL[self.choice(SPECIAL.len())],
            2 => self.scale(),
            3 => self.ordinary() * self.scale(),
            _ => self.ordinary(),
        }
    }

    pub(crate) fn numbers<const N: usize>(&mut self) -> [f64; N] {
        [(); N].map(|()| self.number())
    }

    pub(crate) fn vector(&mut self) -> Vector3<f64> {
        Vector3::from(self.numbers())
    }

    /// Returns a vector of ordinary numbers in common units.
    pub(crate) fn ordinary_vector(&mut self) -> Vector3<f64> {
        let scale = self.scale();
        Vector3::from([(); 3].map(|()| self.ordinary() * scale))
    }

    /// Returns moments of inertia: those of three masses on the axes in most cases, and any numbers in the others.
    pub(crate) fn moments(&mut self) -> Vector3<f64> {
        if self.choice(8) == 0 {
            return self.vector();
        }
        let masses = self.ordinary_vector().map(f64::abs);
        masses.map(|mass| masses.sum() - mass)
    }

    /// Returns a vector of length 1 in most cases, and any vector in the others.
    pub(crate) fn direction(&mut self) -> Vector3<f64> {
        match self.choice(8) {
            0 => self.vector(),
            axis @ 1..=3 => Vector3::ith(axis - 1, 1.0),
            _ => Vector3::from([(); 3].map(|()| self.ordinary())).normalize(),
        }
    }
}
