//! Rational numbers as a scalar, for exact checks of identities.

use core::ops::{
    Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign,
};
use lie_poisson::Real;
use num_rational::Ratio;
use num_traits::{Num, One, Signed, ToPrimitive, Zero};

/// A rational number with 128-bit numerator and denominator; overflow panics.
///
/// Polynomial formulas run on it without rounding. Roots and transcendental functions have no
/// rational value, and panic: a test that reaches one is not polynomial.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rational(pub Ratio<i128>);

impl Rational {
    /// Creates the fraction n/d.
    #[must_use]
    pub fn new(n: i128, d: i128) -> Self {
        Self(Ratio::new(n, d))
    }
}

/// Returns a double as the fraction that it is; panics if it is not one of moderate size.
fn exact(x: f64) -> Ratio<i128> {
    let mut denominator = 1_i128;
    let mut scaled = x;
    while scaled.fract() != 0.0 {
        scaled *= 2.0;
        denominator *= 2;
        assert!(denominator < 1 << 80, "{x} is no fraction of moderate size");
    }
    assert!(scaled.abs() < 1e15, "{x} is no fraction of moderate size");
    Ratio::new(scaled as i128, denominator)
}

macro_rules! operator {
    ($($trait:ident $method:ident $assign:ident $assign_method:ident $operator:tt),*) => {$(
        impl $trait for Rational {
            type Output = Self;
            fn $method(self, rhs: Self) -> Self {
                Self(self.0 $operator rhs.0)
            }
        }
        impl $trait<f64> for Rational {
            type Output = Self;
            fn $method(self, rhs: f64) -> Self {
                Self(self.0 $operator exact(rhs))
            }
        }
        impl $assign for Rational {
            fn $assign_method(&mut self, rhs: Self) {
                self.0 = self.0 $operator rhs.0;
            }
        }
    )*};
}
operator!(Add add AddAssign add_assign +, Sub sub SubAssign sub_assign -,
          Mul mul MulAssign mul_assign *, Div div DivAssign div_assign /,
          Rem rem RemAssign rem_assign %);

impl Neg for Rational {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Zero for Rational {
    fn zero() -> Self {
        Self(Ratio::zero())
    }
    fn is_zero(&self) -> bool {
        self.0.is_zero()
    }
}

impl One for Rational {
    fn one() -> Self {
        Self(Ratio::one())
    }
}

impl Num for Rational {
    type FromStrRadixErr = <Ratio<i128> as Num>::FromStrRadixErr;
    fn from_str_radix(text: &str, radix: u32) -> Result<Self, Self::FromStrRadixErr> {
        Ratio::from_str_radix(text, radix).map(Self)
    }
}

impl Real for Rational {
    type Mask = bool;

    fn from_f64(x: f64) -> Self {
        Self(exact(x))
    }

    fn sqrt(self) -> Self {
        unimplemented!("√{} is not rational in general", self.0)
    }

    fn ln(self) -> Self {
        unimplemented!("ln {} is not rational", self.0)
    }

    fn atan2(self, x: Self) -> Self {
        unimplemented!("the angle of ({}, {}) is not rational", x.0, self.0)
    }

    fn exp(self) -> Self {
        unimplemented!("exp {} is not rational in general", self.0)
    }

    fn sin(self) -> Self {
        unimplemented!("sin {} is not rational in general", self.0)
    }

    fn cos(self) -> Self {
        unimplemented!("cos {} is not rational in general", self.0)
    }

    fn tanh(self) -> Self {
        unimplemented!("tanh {} is not rational in general", self.0)
    }

    /// Returns 1/k! at 0, the only argument at which the value is rational.
    fn stumpff(self, order: u32) -> Self {
        assert!(self.is_zero(), "c_{order}({}) is not rational", self.0);
        Self(Ratio::new(1, (1..=i128::from(order)).product()))
    }

    fn at_most(self, bound: Self) -> bool {
        self.0 <= bound.0
    }

    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }

    fn magnitude(self) -> Self {
        Self(self.0.abs())
    }

    fn max_abs(self) -> f64 {
        let size = self.0.abs();
        size.numer().to_f64().unwrap_or(f64::NAN) / size.denom().to_f64().unwrap_or(f64::NAN)
    }
}

/// Returns vectors with small rational coordinates, no two alike.
pub fn rational_samples<V: lie_poisson::Vector<Scalar = Rational>>(count: usize) -> Vec<V> {
    let mut state = 7_i128;
    let mut next = move || {
        state = (state * 16_807) % 2_147_483_647;
        Rational::new(state % 13 - 6, 1 + state / 13 % 5)
    };
    (0..count).map(|_| V::from_coordinates(|_| next())).collect()
}
