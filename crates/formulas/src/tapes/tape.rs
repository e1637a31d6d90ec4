//! A list of instructions that computes numbers from coordinates: [`Tape`].

use super::allocation::{Allocation, SIZES, allocate};
use super::instruction::{Binary, Instruction, Operation};
use super::linear::{Affine, Others, linear};
use super::selection::select;
use crate::graphs::graph::{Graph, Id};
use crate::text::formula_error::Problem;
use lie_poisson::{Real, Vector, euclidean_norm};
use nalgebra::Vector2;
use smallvec::SmallVec;

/// The largest number of linear results that are passed on without the registers, which need no storage on the heap.
const FEW: usize = 64;

/// Instructions without branches or loops, which are the same for every scalar.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Tape {
    /// The number of coordinates x, which are in the first registers. The results are in the registers that follow.
    inputs: usize,
    /// The i-th result before the first instruction, as a function of the coordinate that belongs to it.
    results: Box<[Affine]>,
    /// What other coordinates add to the results; nothing if none does. Coordinates that are found by their index are not in
    /// the registers of the processor.
    others: Box<[Others]>,
    instructions: Box<[Instruction<u16>]>,
    /// The numbers that are in further registers before the first instruction.
    numbers: Box<[(u16, f64)]>,
    /// The number of registers, one of [`SIZES`].
    size: usize,
}

impl Tape {
    /// Creates the tape that computes the roots of a graph from `inputs` coordinates.
    ///
    /// The coordinate that belongs to the i-th root has the index `first` + i. A root that is a sum of a multiple of it, of
    /// those of a few others and of a constant needs no instruction.
    pub(crate) fn new(
        graph: &Graph,
        roots: &[Id],
        inputs: usize,
        first: usize,
    ) -> Result<Self, Problem> {
        let (graph, roots) = graph.without_powers(roots);
        let known = (first..).zip(&roots).map(|(input, &root)| linear(&graph, root, input));
        let known: Vec<_> = known.collect();
        let left = roots.iter().zip(&known);
        let left: Vec<_> = left.map(|(&root, known)| known.is_none().then_some(root)).collect();
        let selected = select(&graph, &left.iter().flatten().copied().collect::<Vec<_>>());
        let allocation = allocate(&graph, &selected, &left, inputs)?;
        let Allocation { instructions, numbers, size } = allocation;
        let known = known.into_iter().map(Option::unwrap_or_default);
        let (results, others): (Vec<Affine>, Vec<Others>) = known.unzip();
        let is_diagonal = others.iter().all(Others::is_empty);
        Ok(Self {
            inputs,
            results: results.into(),
            others: if is_diagonal { [].into() } else { others.into() },
            instructions: instructions.into(),
            numbers: numbers.into(),
            size,
        })
    }

    /// Returns whether the code for wide registers has the evaluation inlined, as it has up to the last size but one.
    pub(crate) fn pays_in_wide_registers(&self) -> bool {
        self.size <= SIZES[4]
    }

    /// Returns the number of instructions.
    #[cfg(test)]
    fn len(&self) -> usize {
        self.instructions.len()
    }

    /// Computes the results at `inputs` coordinates as a vector; NaN if the tape has another number of coordinates or
    /// results. The coordinate that belongs to the i-th result is `own(i)`.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn vector<V: Vector>(
        &self,
        inputs: usize,
        input: impl Fn(usize) -> V::Scalar,
        own: impl Fn(usize) -> V::Scalar,
    ) -> V {
        let results = self.results.get(..V::DIM).filter(|_| self.inputs == inputs);
        match results.filter(|_| self.instructions.is_empty()) {
            Some(affine) => match self.others.get(..V::DIM) {
                None => V::from_coordinates(
                    #[cfg_attr(optimised, inline(always))]
                    |i| affine[i].at(own(i)),
                ),
                Some(others) => V::from_coordinates(
                    #[cfg_attr(optimised, inline(always))]
                    |i| others[i].added_to(affine[i].at(own(i)), &input),
                ),
            },
            None => self.evaluate((inputs, V::DIM), input, own, |results| {
                V::from_coordinates(|i| result(results, i))
            }),
        }
    }

    /// Computes as many results as there are coordinates in a slice, and writes those for which there is room. The i-th
    /// coordinate belongs to the i-th result. The results are NaN if the tape has another number of coordinates.
    pub(crate) fn write(&self, z: &[f64], out: &mut [f64]) {
        let input = |i: usize| z.get(i).copied().unwrap_or(f64::NAN);
        let count = z.len();
        self.evaluate((count, count), input, input, |results| {
            out.iter_mut().enumerate().for_each(|(i, out)| *out = result(results, i));
        });
    }

    /// Computes the first result at `inputs` coordinates; NaN if the tape has another number of coordinates.
    #[inline]
    pub(crate) fn scalar<T: Real>(&self, inputs: usize, input: impl Fn(usize) -> T) -> T {
        self.evaluate((inputs, 1), &input, &input, |results| result(results, 0))
    }

    /// Computes the results at `inputs` coordinates and passes them on.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn pass<T: Real, R>(
        &self,
        counts: (usize, usize),
        input: impl Fn(usize) -> T,
        own: impl Fn(usize) -> T,
        mut results: impl FnMut(&[T]) -> R,
    ) -> R {
        let affine = self.results.get(..counts.1).filter(|affine| affine.len() <= FEW);
        match affine.filter(|_| self.instructions.is_empty() && self.inputs == counts.0) {
            Some(affine) => {
                let mut all = SmallVec::<[T; FEW]>::new();
                all.resize(affine.len(), T::zero());
                for (i, (sum, affine)) in all.iter_mut().zip(affine).enumerate() {
                    *sum = affine.at(own(i));
                }
                for (sum, others) in all.iter_mut().zip(&*self.others) {
                    *sum = others.added_to(*sum, &input);
                }
                results(&all)
            }
            None => self.evaluate(counts, input, own, results),
        }
    }

    /// Computes the results at `inputs` coordinates and passes the first `outputs` of them on; none if the tape has
    /// another number of coordinates.
    ///
    /// The registers are an array on the stack, of the smallest of six sizes that suffices, or of three for SIMD
    /// lanes in wide registers. Nothing is allocated.
    #[cfg_attr(optimised, inline(always))]
    fn evaluate<T: Real, R>(
        &self,
        counts: (usize, usize),
        input: impl Fn(usize) -> T,
        own: impl Fn(usize) -> T,
        mut results: impl FnMut(&[T]) -> R,
    ) -> R {
        let mut fill = filling(
            #[cfg_attr(optimised, inline(always))]
            |inputs, values| {
                for (i, register) in inputs.iter_mut().enumerate() {
                    *register = input(i);
                }
                for (i, register) in values.iter_mut().enumerate() {
                    *register = own(i);
                }
            },
        );
        // Only code that is inlined into the code for wide registers can use their instructions.
        match self.size {
            16 if !T::HAS_SLOW_PATHS => {
                self.evaluate_in::<T, R, { SIZES[0] }>(counts, fill, results)
            }
            32 | 64 if !T::HAS_SLOW_PATHS => {
                self.evaluate_in::<T, R, { SIZES[2] }>(counts, fill, results)
            }
            256 | 1024 if !T::HAS_SLOW_PATHS => {
                self.evaluate_in::<T, R, { SIZES[4] }>(counts, fill, results)
            }
            _ => {
                let mut value = None;
                self.evaluate_apart(counts, &mut fill, &mut |found| value = Some(results(found)));
                value.unwrap_or_else(|| results(&[]))
            }
        }
    }

    /// Evaluates in code that is compiled once for each scalar, and not for each caller.
    #[inline(never)]
    fn evaluate_apart<T: Real>(
        &self,
        counts: (usize, usize),
        fill: &mut dyn FnMut(&mut [T], &mut [T]),
        results: &mut dyn FnMut(&[T]),
    ) {
        match self.size {
            16 => self.evaluate_in::<T, (), { SIZES[0] }>(counts, fill, results),
            32 => self.evaluate_in::<T, (), { SIZES[1] }>(counts, fill, results),
            64 => self.evaluate_in::<T, (), { SIZES[2] }>(counts, fill, results),
            256 => self.evaluate_in::<T, (), { SIZES[3] }>(counts, fill, results),
            8192 => self.evaluate_in::<T, (), { SIZES[5] }>(counts, fill, results),
            _ => self.evaluate_in::<T, (), { SIZES[4] }>(counts, fill, results),
        }
    }

    /// Evaluates in registers of which `fill` writes the coordinates, and those that belong to the results.
    #[cfg_attr(optimised, inline(always))]
    fn evaluate_in<T: Real, R, const SIZE: usize>(
        &self,
        (inputs, outputs): (usize, usize),
        mut fill: impl FnMut(&mut [T], &mut [T]),
        mut results: impl FnMut(&[T]) -> R,
    ) -> R {
        let mut registers = [T::from_f64(0.0); SIZE];
        let affine = self.results.get(..outputs).filter(|_| inputs == self.inputs);
        let end = inputs + outputs;
        let (Some(affine), Some((first, others))) =
            (affine, registers.get_mut(..end).map(|all| all.split_at_mut(inputs)))
        else {
            return results(&[]);
        };
        fill(first, others);
        for (register, affine) in others.iter_mut().zip(affine) {
            *register = affine.at(*register);
        }
        for (sum, others) in others.iter_mut().zip(&*self.others) {
            *sum = others.added_to(*sum, |i| first[i]);
        }
        for &(register, number) in &*self.numbers {
            registers[usize::from(register) % SIZE] = T::from_f64(number);
        }
        for instruction in &*self.instructions {
            instruction.execute(&mut registers);
        }
        results(registers.get(inputs..end).unwrap_or_default())
    }
}

/// Returns a function that fills registers, whose attribute needs a place where there may be one.
#[cfg_attr(optimised, inline(always))]
const fn filling<T, F: FnMut(&mut [T], &mut [T])>(fill: F) -> F {
    fill
}

/// Returns one of the results, or NaN if there is none.
#[cfg_attr(optimised, inline(always))]
fn result<T: Real>(results: &[T], i: usize) -> T {
    results.get(i).copied().unwrap_or_else(|| T::from_f64(f64::NAN))
}

/// Returns a function of two numbers.
#[inline]
fn of_two<T: Real>(function: Binary, a: T, b: T) -> T {
    match function {
        Binary::Angle => a.atan2(b),
        Binary::Hypotenuse => euclidean_norm(&Vector2::new(a, b)),
    }
}

impl Instruction<u16> {
    #[cfg_attr(optimised, inline(always))]
    fn execute<T: Real, const SIZE: usize>(&self, registers: &mut [T; SIZE]) {
        // SIZE is a power of two above every register; the remainder saves the bounds check.
        let place = |register: u16| usize::from(register) % SIZE;
        let [a, b, c] = self.operands;
        let a = registers[place(a)];
        let b = || registers[place(b)];
        let result = match self.operation {
            Operation::Copy => a,
            Operation::Add => a + b(),
            Operation::Subtract => a - b(),
            Operation::Multiply => a * b(),
            Operation::MultiplyAdd => a * b() + registers[place(c)],
            Operation::Scale(number) => a * number,
            Operation::ScaleProduct(number) => a * b() * number,
            Operation::ScaleAdd(number) => a * number + b(),
            Operation::Offset(number) => a + number,
            Operation::Divide => a / b(),
            Operation::Negate => -a,
            Operation::Power(n) => a.powi(n),
            Operation::Function(function) => function.apply(a),
            Operation::OfTwo(function) => of_two(function, a, b()),
            Operation::Choose => {
                // A condition that is not a number holds nowhere, and neither does its contrary.
                let otherwise = (-a).select_nonnegative(registers[place(c)], a * f64::NAN);
                a.select_nonnegative(b(), otherwise)
            }
        };
        registers[place(self.target)] = result;
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::graphs::elaboration::elaborate;
    use crate::names::coordinates::Coordinates;
    use crate::names::parameters::Parameters;
    use crate::names::vocabulary::Vocabulary;
    use crate::text::parsing::parser::parse;

    /// Returns the numbers of instructions of the value, the gradient and the second derivative.
    fn lengths(text: &str) -> [usize; 3] {
        let coordinates = Coordinates::new().vector("Pi", 3).unwrap().vector("Gamma", 3).unwrap();
        let parameters = Parameters::new().vector("I", &[2.0, 3.0, 4.0]).unwrap();
        let names = Vocabulary::new(&coordinates, &parameters).unwrap();
        let mut graph = Graph::default();
        let value = elaborate(&parse(text, &names).unwrap(), &names, &mut graph).unwrap();
        let gradient = graph.gradient(value, 6);
        let tangents = graph.tangents(&gradient, 6);
        let roots = [(vec![value], 6), (gradient, 6), (tangents, 12)];
        roots.map(|(roots, inputs)| Tape::new(&graph, &roots, inputs, inputs - 6).unwrap().len())
    }

    #[test]
    fn derivatives_of_quadratic_forms_are_a_few_products() {
        // dh = (Π₁/I₁, Π₂/I₂, Π₃/I₃, c): each a multiple of its own coordinate and a constant
        let top = "0.5*(Pi1^2/I1 + Pi2^2/I2 + Pi3^2/I3) + 1.5*Gamma1 + 0*Gamma2";
        assert_eq!(lengths(top)[1..], [0, 0]);
        // dh = (0.6 Π₁ + 0.1 Π₂, 0.1 Π₁ + 2 Π₂, 0, …)
        assert_eq!(lengths("0.3*Pi1^2 + 0.1*Pi1*Pi2 + Pi2^2")[1..], [0, 0]);
        // h = ½ Π₁Π₂ is one instruction, and exp(−Γ₃²) needs one before exp, its slope −2 exp(−Γ₃²) Γ₃ one after it
        assert_eq!(lengths("0.5*(Pi1*Pi2)")[0], 1);
        assert_eq!(lengths("exp(-Gamma3^2)")[..2], [2, 3]);
        // dh = (Γ, Π)
        assert_eq!(lengths("Pi·Gamma"), [3, 0, 0]);
        // the length of Γ is computed once for all slopes, and 2Γᵢ is added by the instruction that multiplies
        let length = lengths("1/|Gamma|^3")[1];
        assert!(lengths("|Gamma|^2 + 1/|Gamma|^3")[1] <= length + 3);
        assert!(length < 16, "{length}");
    }

    #[test]
    fn another_number_of_coordinates_has_no_results() {
        let mut graph = Graph::default();
        let root = graph.input(1);
        let tape = Tape::new(&graph, &[root], 2, 0).unwrap();
        let value = |inputs: usize| tape.scalar(inputs, |i| i as f64);
        assert_eq!(value(2), 1.0);
        assert!(value(1).is_nan() && value(3).is_nan());
    }
}
