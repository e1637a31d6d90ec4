//! The meaning of a syntax tree: the graph of a scalar, with the shapes of all parts checked.

use super::graph::{Graph, Id, Unary};
use crate::names::letters::RESERVED;
use crate::names::vocabulary::{Meaning, Vocabulary};
use crate::text::formula_error::{FormulaError, Problem, Shape};
use crate::text::suggestion::closest_name;
use crate::text::syntax::{Function, Operator, Part, Syntax};
use crate::text::token::Comparison;

/// The largest number of expressions in the graph of a formula.
const MOST_NODES: usize = 1 << 18;

/// The value of a part: a scalar or the components of a vector.
#[derive(Clone, Debug)]
enum Value {
    Scalar(Id),
    Vector(Vec<Id>),
}

impl Value {
    fn shape(&self) -> Shape {
        match self {
            Self::Scalar(_) => Shape::Scalar,
            Self::Vector(components) => Shape::Vector(components.len()),
        }
    }

    /// Returns the scalar, or an error that names the place at which a vector is not allowed.
    fn scalar(&self, place: impl FnOnce() -> String) -> Result<Id, Problem> {
        match self {
            Self::Scalar(id) => Ok(*id),
            Self::Vector(_) => Err(Problem::ScalarNeeded { place: place(), found: self.shape() }),
        }
    }
}

/// Adds the expression of a syntax tree to a graph and returns its node.
pub(crate) fn elaborate(
    syntax: &Syntax,
    names: &Vocabulary,
    graph: &mut Graph,
) -> Result<Id, FormulaError> {
    let mut values: Vec<Value> = Vec::new();
    let mut last = 0..0;
    for (part, span) in syntax.parts() {
        let fail = |problem| FormulaError::new(span.clone(), problem);
        let value = Elaboration { syntax, names, graph, values: &values }.value(part);
        let value = value.map_err(fail)?;
        let components = match &value {
            Value::Scalar(id) => core::slice::from_ref(id),
            Value::Vector(components) => components.as_slice(),
        };
        let numbers = components.iter().filter_map(|&id| graph.as_number(id));
        if let Some(value) = numbers.into_iter().find(|value| !value.is_finite()) {
            return Err(fail(Problem::NotFinite { value }));
        }
        if graph.len() > MOST_NODES {
            return Err(fail(Problem::TooLarge { needed: graph.len(), limit: MOST_NODES }));
        }
        values.push(value);
        last = span.clone();
    }
    match values.pop() {
        Some(Value::Scalar(id)) => Ok(id),
        Some(Value::Vector(components)) => {
            Err(FormulaError::new(last, Problem::NotAScalar { dimension: components.len() }))
        }
        None => Err(FormulaError::new(0..0, Problem::Empty)),
    }
}

struct Elaboration<'a> {
    syntax: &'a Syntax,
    names: &'a Vocabulary,
    graph: &'a mut Graph,
    values: &'a [Value],
}

impl Elaboration<'_> {
    /// Returns the value of a part. Other parts may use the same value.
    fn at(&self, place: usize) -> Value {
        self.values.get(place).cloned().unwrap_or(Value::Scalar(0))
    }

    fn value(&mut self, part: Part) -> Result<Value, Problem> {
        Ok(match part {
            Part::Number(value) => Value::Scalar(self.graph.number(value)),
            Part::Name(place) => return self.name(place),
            Part::Negate(x) => self.at(x).map(|x| self.graph.negate(x)),
            Part::Norm(x) => Value::Scalar(match self.at(x) {
                Value::Scalar(x) => self.graph.function(Unary::Absolute, x),
                Value::Vector(v) => {
                    let square = self.dot(&v, &v);
                    self.graph.function(Unary::Sqrt, square)
                }
            }),
            Part::Component(x, index) => {
                let value = self.at(x);
                let component = match &value {
                    Value::Vector(v) => index.checked_sub(1).and_then(|i| v.get(i)),
                    Value::Scalar(_) => None,
                };
                let missing = Problem::NoComponent { index, of: value.shape() };
                Value::Scalar(*component.ok_or(missing)?)
            }
            Part::Call(function, [x, y]) => return self.call(function, x, y).map(Value::Scalar),
            Part::Choose(comparison, parts) => return self.choose(comparison, parts),
            Part::Binary(operator, x, y) => {
                let (x, y) = (self.at(x), self.at(y));
                return self.binary(operator, x, y);
            }
        })
    }

    fn name(&mut self, place: usize) -> Result<Value, Problem> {
        let name = self.syntax.name(place);
        if name == "pi" {
            return Ok(Value::Scalar(self.graph.number(core::f64::consts::PI)));
        }
        Ok(match self.names.meaning(name) {
            Some(Meaning::Coordinate(i)) => Value::Scalar(self.graph.input(*i)),
            Some(&Meaning::Coordinates(start, dimension)) => {
                Value::Vector((start..start + dimension).map(|i| self.graph.input(i)).collect())
            }
            Some(Meaning::Number(value)) => Value::Scalar(self.graph.number(*value)),
            Some(Meaning::Numbers(values)) => {
                Value::Vector(values.iter().map(|&value| self.graph.number(value)).collect())
            }
            None => {
                let count = self.names.numbered(name);
                if count > 1 {
                    return Err(Problem::NoVector { name: name.to_owned(), count });
                }
                let known = self.names.names().chain(RESERVED.iter().copied());
                let suggestion = closest_name(name, known);
                return Err(Problem::UnknownName { name: name.to_owned(), suggestion });
            }
        })
    }

    fn call(&mut self, function: Function, x: usize, y: usize) -> Result<Id, Problem> {
        let place = || format!("`{}`", function.name());
        let x = self.at(x).scalar(place)?;
        let graph = &mut *self.graph;
        Ok(match function {
            Function::Sqrt => graph.function(Unary::Sqrt, x),
            Function::Exp => graph.function(Unary::Exp, x),
            Function::Ln => graph.function(Unary::Ln, x),
            Function::Sin => graph.function(Unary::Sin, x),
            Function::Cos => graph.function(Unary::Cos, x),
            Function::Sinh => graph.function(Unary::Sinh, x),
            Function::Cosh => graph.function(Unary::Cosh, x),
            Function::Tanh => graph.function(Unary::Tanh, x),
            Function::Tan => {
                let (sin, cos) = (graph.function(Unary::Sin, x), graph.function(Unary::Cos, x));
                graph.divide(sin, cos)
            }
            Function::Arcsin => graph.arcsine(x),
            Function::Arccos => graph.arccosine(x),
            Function::Arctan => {
                let one = graph.number(1.0);
                graph.angle(x, one)
            }
            Function::Log10 => graph.decadic_logarithm(x),
            Function::Cbrt => graph.cube_root(x),
            Function::Atan2 => {
                let y = self.at(y).scalar(place)?;
                self.graph.angle(x, y)
            }
            Function::Hypot => {
                let y = self.at(y).scalar(place)?;
                self.graph.hypotenuse(x, y)
            }
        })
    }

    fn choose(
        &mut self,
        comparison: Comparison,
        [a, b, holds, fails]: [usize; 4],
    ) -> Result<Value, Problem> {
        let place = || "`if`".to_owned();
        let (a, b) = (self.at(a).scalar(place)?, self.at(b).scalar(place)?);
        let (holds, fails) = (self.at(holds), self.at(fails));
        let (left, right) = (holds.shape(), fails.shape());
        if left != right {
            let needed = "two scalars or two vectors of one dimension";
            return Err(Problem::Mismatch { place: "`if`".to_owned(), needed, left, right });
        }
        let (above, below, is_contrary) = comparison.sides(a, b);
        let below = self.graph.negate(below);
        let difference = self.graph.add(above, below);
        Ok(holds.zip(fails, |holds, fails| match is_contrary {
            false => self.graph.choose(difference, holds, fails),
            true => self.graph.choose(difference, fails, holds),
        }))
    }

    fn binary(&mut self, operator: Operator, x: Value, y: Value) -> Result<Value, Problem> {
        let sign = match operator {
            Operator::Add => "`+`",
            Operator::Subtract => "`-`",
            Operator::Multiply => "`*`",
            Operator::Divide => "`/`",
            Operator::Dot => "`·`",
            Operator::Cross => "`×`",
            Operator::Power => "`^`",
        };
        let (left, right) = (x.shape(), y.shape());
        let mismatch = |needed| Problem::Mismatch { place: sign.to_owned(), needed, left, right };
        let graph = &mut *self.graph;
        Ok(match (operator, x, y) {
            (Operator::Add, x, y) if left == right => x.zip(y, |x, y| graph.add(x, y)),
            (Operator::Subtract, x, y) if left == right => x.zip(y, |x, y| {
                let negative = graph.negate(y);
                graph.add(x, negative)
            }),
            (Operator::Add | Operator::Subtract, ..) => {
                return Err(mismatch("two scalars or two vectors of one dimension"));
            }
            (Operator::Multiply, Value::Scalar(c), v)
            | (Operator::Multiply, v, Value::Scalar(c)) => v.map(|x| graph.multiply(c, x)),
            (Operator::Divide, _, Value::Scalar(c)) if graph.as_number(c) == Some(0.0) => {
                return Err(Problem::DivisionByZero);
            }
            (Operator::Divide, v, Value::Scalar(c)) => v.map(|x| graph.divide(x, c)),
            (Operator::Dot, Value::Vector(x), Value::Vector(y)) if x.len() == y.len() => {
                Value::Scalar(self.dot(&x, &y))
            }
            (Operator::Dot, ..) => {
                return Err(mismatch("two vectors of one dimension"));
            }
            (Operator::Cross, Value::Vector(x), Value::Vector(y)) => {
                match (x.as_slice(), y.as_slice()) {
                    (&[a, b, c], &[d, e, f]) => Value::Vector(
                        [(b, f, c, e), (c, d, a, f), (a, e, b, d)]
                            .map(|(p, q, r, s)| {
                                let (plus, minus) = (graph.multiply(p, q), graph.multiply(r, s));
                                let minus = graph.negate(minus);
                                graph.add(plus, minus)
                            })
                            .to_vec(),
                    ),
                    _ => return Err(mismatch("two vectors of dimension 3")),
                }
            }
            (Operator::Cross, ..) => return Err(mismatch("two vectors of dimension 3")),
            (Operator::Power, Value::Scalar(x), Value::Scalar(c)) => {
                Value::Scalar(match graph.as_number(c) {
                    Some(c) => graph.power(x, c),
                    // x^y = exp(y ln x)
                    None => {
                        let logarithm = graph.function(Unary::Ln, x);
                        let product = graph.multiply(c, logarithm);
                        graph.function(Unary::Exp, product)
                    }
                })
            }
            (Operator::Multiply | Operator::Divide | Operator::Power, x, y) => {
                let vector = if matches!(y, Value::Vector(_)) { y } else { x };
                return Err(Problem::ScalarNeeded {
                    place: sign.to_owned(),
                    found: vector.shape(),
                });
            }
        })
    }

    fn dot(&mut self, x: &[Id], y: &[Id]) -> Id {
        let products: Vec<_> = x.iter().zip(y).map(|(&x, &y)| self.graph.multiply(x, y)).collect();
        self.graph.sum(&products)
    }
}

impl Value {
    fn map(self, mut f: impl FnMut(Id) -> Id) -> Self {
        match self {
            Self::Scalar(x) => Self::Scalar(f(x)),
            Self::Vector(v) => Self::Vector(v.into_iter().map(f).collect()),
        }
    }

    /// Combines two values of the same shape.
    fn zip(self, other: Self, mut f: impl FnMut(Id, Id) -> Id) -> Self {
        match (self, other) {
            (Self::Scalar(x), Self::Scalar(y)) => Self::Scalar(f(x, y)),
            (Self::Vector(x), Self::Vector(y)) => {
                Self::Vector(x.into_iter().zip(y).map(|(x, y)| f(x, y)).collect())
            }
            (kept, _) => kept,
        }
    }
}
