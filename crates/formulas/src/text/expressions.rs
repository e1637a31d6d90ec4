//! Formulas that a program builds, without text: [`Expressions`].

use super::formula_error::{FormulaError, Problem};
use super::suggestion::closest_name;
use super::syntax::{Function, Operator, Part, Syntax};
use super::token::Comparison;
use crate::names::letters::canonical;

/// The parts of a formula that a program builds, each in terms of earlier parts.
///
/// A part may be used any number of times and is computed once. A program that traces a function or writes formulas
/// therefore needs no text, in which a part would be repeated for each of its uses. Adding a part returns an
/// [`Expression`], which stands for the part. [`Formula::of_expressions`](crate::Formula::of_expressions) creates the
/// formula.
///
/// # Example
/// The parts Π₁, Π₂, s₀ = Π₁ + Π₂ and sₖ₊₁ = sₖ² up to s₃₀ are 33 in number. As a text, s₃₀ would have 2³⁰ sums:
/// ```
/// use lie_poisson::So3;
/// use lie_poisson_formulas::{Expressions, Formula, Parameters, Vocabulary};
/// use nalgebra::Vector3;
/// let names = Vocabulary::of(&So3, &Parameters::new())?;
/// let mut parts = Expressions::new();
/// let (x, y) = (parts.name("Pi1"), parts.name("Pi2"));
/// let mut s = parts.add(x, y);
/// for _ in 0..30 {
///     s = parts.multiply(s, s);
/// }
/// let h = Formula::of_expressions(&parts, s, &names)?;
/// assert_eq!(h.value(&Vector3::new(0.25, 0.75, 5.0)), 1.0);
/// // the derivative of x^n at 1
/// let slope = h.differential(&Vector3::new(0.25, 0.75, 5.0)).0;
/// assert_eq!(slope, Vector3::new(1.0, 1.0, 0.0) * 2.0_f64.powi(30));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Expressions {
    syntax: Syntax,
}

/// The handle of a part that was added to [`Expressions`]. It has a meaning only for the object that returned it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Expression(usize);

impl Expressions {
    /// Creates an empty builder.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a constant number.
    pub fn number(&mut self, value: f64) -> Expression {
        self.part(Part::Number(value))
    }

    /// Adds a coordinate or a parameter, or a vector of them, by its name.
    pub fn name(&mut self, name: &str) -> Expression {
        Expression(self.syntax.add_name(canonical(name), 0..0))
    }

    /// Adds x + y, of two scalars or two vectors.
    pub fn add(&mut self, x: Expression, y: Expression) -> Expression {
        self.binary(Operator::Add, x, y)
    }

    /// Adds x − y, of two scalars or two vectors.
    pub fn subtract(&mut self, x: Expression, y: Expression) -> Expression {
        self.binary(Operator::Subtract, x, y)
    }

    /// Adds the product x y, in which one factor may be a vector.
    pub fn multiply(&mut self, x: Expression, y: Expression) -> Expression {
        self.binary(Operator::Multiply, x, y)
    }

    /// Adds x/y for a scalar y.
    pub fn divide(&mut self, x: Expression, y: Expression) -> Expression {
        self.binary(Operator::Divide, x, y)
    }

    /// Adds the power xʸ of scalars.
    pub fn power(&mut self, x: Expression, y: Expression) -> Expression {
        self.binary(Operator::Power, x, y)
    }

    /// Adds the inner product x·y of vectors.
    pub fn dot(&mut self, x: Expression, y: Expression) -> Expression {
        self.binary(Operator::Dot, x, y)
    }

    /// Adds the cross product x×y of vectors of dimension 3.
    pub fn cross(&mut self, x: Expression, y: Expression) -> Expression {
        self.binary(Operator::Cross, x, y)
    }

    /// Adds the negative −x, of a scalar or a vector.
    pub fn negate(&mut self, x: Expression) -> Expression {
        self.part(Part::Negate(x.0))
    }

    /// Adds |x|, of a scalar or a vector.
    pub fn norm(&mut self, x: Expression) -> Expression {
        self.part(Part::Norm(x.0))
    }

    /// Adds a component of a vector. Components count from 1, as in formulas.
    pub fn component(&mut self, x: Expression, index: usize) -> Expression {
        self.part(Part::Component(x.0, index))
    }

    /// Adds y where x ≥ 0, and z where x < 0, of a scalar x and of two scalars or two vectors. Derivatives are those of the
    /// chosen part, even where the other has none. Where x is not a number, neither is the result.
    pub fn choose(&mut self, x: Expression, y: Expression, z: Expression) -> Expression {
        let zero = self.number(0.0);
        self.part(Part::Choose(Comparison::AtLeast, [x.0, zero.0, y.0, z.0]))
    }

    /// Adds a function of scalars, by its name in [formulas](crate#the-language), such as `sin`.
    ///
    /// # Errors
    /// Returns [`FormulaError`] if there is no such function, or if the number of arguments is wrong.
    pub fn call(
        &mut self,
        function: &str,
        arguments: &[Expression],
    ) -> Result<Expression, FormulaError> {
        let name = function.to_owned();
        let fail = |problem| Err(FormulaError::new(0..0, problem));
        let named = Function::NAMES.iter().find(|(known, _)| *known == function);
        let Some(&(_, function)) = named else {
            let known = Function::NAMES.iter().map(|(name, _)| *name);
            let suggestion = closest_name(&name, known);
            return fail(Problem::UnknownFunction { name, suggestion });
        };
        let (expected, found) = (function.arguments(), arguments.len());
        match *arguments {
            [x] if expected == 1 => Ok(self.part(Part::Call(function, [x.0, x.0]))),
            [x, y] if expected == 2 => Ok(self.part(Part::Call(function, [x.0, y.0]))),
            _ => fail(Problem::WrongArgumentCount { name, expected, found }),
        }
    }

    fn binary(&mut self, operator: Operator, x: Expression, y: Expression) -> Expression {
        self.part(Part::Binary(operator, x.0, y.0))
    }

    fn part(&mut self, part: Part) -> Expression {
        Expression(self.syntax.add(part, 0..0))
    }

    /// Returns the syntax tree of a part.
    pub(crate) fn syntax_of(&self, Expression(place): Expression) -> Result<Syntax, FormulaError> {
        self.syntax.up_to(place).ok_or_else(|| FormulaError::new(0..0, Problem::Empty))
    }
}
