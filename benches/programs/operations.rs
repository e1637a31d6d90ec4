//! Counts the operations on real numbers in a step of each general integrator, by a scalar that counts:
//!
//! ```text
//! cargo run --release -p measurements --bin operations
//! ```
//!
//! Iterations are counted as they occur, on Kovalevskaya's top from the paper's start, over the last quarter of a run
//! of 4096 steps.

use collective_integrators::{Collective, Direct, HamiltonianField, LiftFree, RungeKutta, Start};
use core::ops::{
    Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign,
};
use heavytop::{HeavyTop, ReducedMidpoint, SpinorRealisation};
use lie_poisson::num_traits::{Num, One, Zero};
use lie_poisson::{LiePoisson, Real, Se3, Se3Dual};
use momentum_map::DualQuaternions;
use nalgebra::Vector3;
use std::cell::Cell;
use std::error::Error;
use std::thread::LocalKey;

type Counter = LocalKey<Cell<u64>>;

thread_local! {
    static SUMS: Cell<u64> = const { Cell::new(0) };
    static PRODUCTS: Cell<u64> = const { Cell::new(0) };
    static QUOTIENTS: Cell<u64> = const { Cell::new(0) };
    /// The number of comparisons, choices, magnitudes and changes of sign.
    static OTHERS: Cell<u64> = const { Cell::new(0) };
}

fn count(counter: &'static Counter) {
    counter.set(counter.get() + 1);
}

/// A number that counts the operations on it.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Counted(f64);

macro_rules! operators {
    ($($trait:ident $method:ident $assign:ident $assign_method:ident $counter:ident $operator:tt;)*) => {$(
        impl $trait for Counted {
            type Output = Self;
            fn $method(self, rhs: Self) -> Self {
                count(&$counter);
                Self(self.0 $operator rhs.0)
            }
        }
        impl $trait<f64> for Counted {
            type Output = Self;
            fn $method(self, rhs: f64) -> Self {
                count(&$counter);
                Self(self.0 $operator rhs)
            }
        }
        impl $assign for Counted {
            fn $assign_method(&mut self, rhs: Self) {
                *self = *self $operator rhs;
            }
        }
    )*};
}
operators! {
    Add add AddAssign add_assign SUMS +;
    Sub sub SubAssign sub_assign SUMS -;
    Mul mul MulAssign mul_assign PRODUCTS *;
    Div div DivAssign div_assign QUOTIENTS /;
    Rem rem RemAssign rem_assign QUOTIENTS %;
}

impl Neg for Counted {
    type Output = Self;
    fn neg(self) -> Self {
        count(&OTHERS);
        Self(-self.0)
    }
}

impl Zero for Counted {
    fn zero() -> Self {
        Self(0.0)
    }
    fn is_zero(&self) -> bool {
        self.0 == 0.0
    }
}

impl One for Counted {
    fn one() -> Self {
        Self(1.0)
    }
}

impl Num for Counted {
    type FromStrRadixErr = <f64 as Num>::FromStrRadixErr;
    fn from_str_radix(text: &str, radix: u32) -> Result<Self, Self::FromStrRadixErr> {
        <f64 as Num>::from_str_radix(text, radix).map(Self)
    }
}

impl Real for Counted {
    type Mask = bool;

    fn from_f64(x: f64) -> Self {
        Self(x)
    }
    fn sqrt(self) -> Self {
        count(&QUOTIENTS);
        Self(self.0.sqrt())
    }
    fn ln(self) -> Self {
        Self(self.0.ln())
    }
    fn atan2(self, x: Self) -> Self {
        Self(self.0.atan2(x.0))
    }
    fn exp(self) -> Self {
        Self(self.0.exp())
    }
    fn sin(self) -> Self {
        Self(self.0.sin())
    }
    fn cos(self) -> Self {
        Self(self.0.cos())
    }
    fn tanh(self) -> Self {
        Self(self.0.tanh())
    }
    fn stumpff(self, order: u32) -> Self {
        Self(self.0.stumpff(order))
    }
    fn at_most(self, bound: Self) -> bool {
        count(&OTHERS);
        self.0 <= bound.0
    }
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        count(&OTHERS);
        if mask { yes } else { no }
    }
    fn magnitude(self) -> Self {
        count(&OTHERS);
        Self(self.0.abs())
    }
    fn maximum(self, other: Self) -> Self {
        count(&OTHERS);
        Self(Real::maximum(self.0, other.0))
    }
    fn max_abs(self) -> f64 {
        count(&OTHERS);
        self.0.abs()
    }
}

/// Prints a row of the table.
fn row<I>(name: &str, integrator: &I, step: f64) -> Result<(), Box<dyn Error>>
where
    I: Start<Counted, Momentum = Se3Dual<Counted>>,
{
    const STEPS: u64 = 4096;
    const COUNTED: u64 = STEPS / 4;
    let [pi, gamma] = [[2.0, 3.0, 4.0], [0.5, 0.0, 0.75_f64.sqrt()]];
    let start = Se3Dual::new(Vector3::from(pi.map(Counted)), Vector3::from(gamma.map(Counted)));
    let (mut state, mut workspace) = (integrator.start(&start)?, integrator.workspace());
    let mut iterations = 0;
    for n in 0..STEPS {
        if n == STEPS - COUNTED {
            iterations = 0;
            for counter in [&SUMS, &PRODUCTS, &QUOTIENTS, &OTHERS] {
                counter.set(0);
            }
        }
        let next = integrator.step(&state, step, &mut workspace)?;
        (state, iterations) = (next.point, iterations + next.iterations as u64);
    }
    let counts = [&PRODUCTS, &SUMS, &QUOTIENTS, &OTHERS].map(|counter| counter.get());
    let [products, sums, quotients, others] = counts.map(|count| count as f64 / COUNTED as f64);
    let sweeps = iterations as f64 / COUNTED as f64;
    println!("| {name} | {sweeps:.2} | {products:.0} | {sums:.0} | {quotients:.1} | {others:.0} |");
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let top = HeavyTop::kovalevskaya(1.0, 1.0)?;
    println!("| a step of | sweeps | products | sums | quotients | others |");
    println!("|---|--:|--:|--:|--:|--:|");
    let gauss = || RungeKutta::gauss(8);
    row(
        "`Collective`, Gauss-16, h = 1/4",
        &Collective::new(gauss()?, SpinorRealisation, top),
        0.25,
    )?;
    row(
        "`LiftFree`, Gauss-16, h = 1/3",
        &LiftFree::new(gauss()?, DualQuaternions, top),
        1.0 / 3.0,
    )?;
    let midpoint = LiftFree::new(RungeKutta::implicit_midpoint(), DualQuaternions, top);
    row("`LiftFree`, midpoint, h = 1/100", &midpoint, 0.01)?;
    row("`ReducedMidpoint`, h = 1/100", &ReducedMidpoint::new(top), 0.01)?;
    let field = HamiltonianField { space: LiePoisson::minus(Se3::default()), hamiltonian: top };
    row("`Direct`, RK4, h = 1/100", &Direct::new(RungeKutta::rk4(), field), 0.01)
}
