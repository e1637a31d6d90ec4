//! A list of instructions that computes numbers from coordinates: [`Tape`].

use super::allocation::{SIZES, allocate};
use super::instruction::{Instruction, Operation};
use super::selection::select;
use crate::graphs::graph::{Graph, Id};
use crate::text::formula_error::Problem;
use core::array::from_fn;
use lie_poisson::Real;

/// Instructions without branches and without loops, which are the same for every scalar.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Tape {
    instructions: Box<[Instruction<u16>]>,
    /// The numbers in the registers before the first instruction, as many as there are registers.
    numbers: Box<[f64]>,
    outputs: Box<[u16]>,
    inputs: usize,
}

/// The results of a tape.
pub(crate) struct Results<'a, T> {
    registers: &'a [T],
    outputs: &'a [u16],
}

impl<T: Real> Results<'_, T> {
    /// Returns the i-th result, or zero if there are fewer.
    #[inline(always)]
    pub(crate) fn get(&self, i: usize) -> T {
        let register = self.outputs.get(i).map(|&register| usize::from(register));
        let result = register.and_then(|register| self.registers.get(register));
        result.copied().unwrap_or_else(T::zero)
    }
}

impl Tape {
    /// Creates the tape that computes the roots of a graph from `inputs` coordinates.
    pub(crate) fn new(graph: &Graph, roots: &[Id], inputs: usize) -> Result<Self, Problem> {
        let (graph, roots) = graph.without_powers(roots);
        let allocation = allocate(&graph, &select(&graph, &roots), &roots, inputs)?;
        Ok(Self {
            instructions: allocation.instructions.into(),
            numbers: allocation.numbers.into(),
            outputs: allocation.outputs.into(),
            inputs,
        })
    }

    /// Computes the results at coordinates and passes them on.
    ///
    /// The registers are an array on the stack, of the smallest of four sizes that suffices. Nothing is allocated.
    #[inline]
    pub(crate) fn evaluate<T: Real, R>(
        &self,
        input: impl Fn(usize) -> T,
        results: impl FnOnce(&Results<'_, T>) -> R,
    ) -> R {
        match self.numbers.len() {
            16 => self.evaluate_in::<T, R, { SIZES[0] }>(input, results),
            64 => self.evaluate_in::<T, R, { SIZES[1] }>(input, results),
            256 => self.evaluate_in::<T, R, { SIZES[2] }>(input, results),
            _ => self.evaluate_in::<T, R, { SIZES[3] }>(input, results),
        }
    }

    #[inline]
    fn evaluate_in<T: Real, R, const SIZE: usize>(
        &self,
        input: impl Fn(usize) -> T,
        results: impl FnOnce(&Results<'_, T>) -> R,
    ) -> R {
        let numbers = self.numbers.first_chunk::<SIZE>().unwrap_or(&[0.0; SIZE]);
        let mut registers: [T; SIZE] = from_fn(|i| T::from_f64(numbers[i]));
        for (i, register) in registers.iter_mut().enumerate().take(self.inputs) {
            *register = input(i);
        }
        for instruction in &*self.instructions {
            instruction.execute(&mut registers);
        }
        results(&Results { registers: &registers, outputs: &self.outputs })
    }
}

impl Instruction<u16> {
    #[inline(always)]
    fn execute<T: Real, const SIZE: usize>(&self, registers: &mut [T; SIZE]) {
        // SIZE is a power of two above every register; the remainder spares the test of the index.
        let place = |register: u16| usize::from(register) % SIZE;
        let [a, b, c] = self.operands;
        let a = registers[place(a)];
        let b = || registers[place(b)];
        let result = match self.operation {
            Operation::Add => a + b(),
            Operation::Subtract => a - b(),
            Operation::Multiply => a * b(),
            Operation::MultiplyAdd => a * b() + registers[place(c)],
            Operation::Divide => a / b(),
            Operation::Negate => -a,
            Operation::Power(n) => a.powi(n),
            Operation::Function(function) => function.apply(a),
            Operation::Angle => a.atan2(b()),
        };
        registers[place(self.target)] = result;
    }
}
