//! The parser: from a text to its syntax tree, by the binding powers of operators (V. Pratt, *Top down operator
//! precedence*, POPL 1973).

use super::lexer::tokens;
use crate::names::vocabulary::Vocabulary;
use crate::text::formula_error::{FormulaError, MOST_LEVELS, Problem};
use crate::text::suggestion::closest_name;
use crate::text::syntax::{Function, Operator, Part, Syntax};
use crate::text::token::{Placed, Token};
use core::ops::Range;

/// The name of the form with a condition: `if(x >= 0, y, z)`.
pub(crate) const CHOICE: &str = "if";

/// The name of the form with an index: `sum(S[i]·S[i+1])`.
pub(crate) const SUM: &str = "sum";

pub(super) type Parsed<T> = Result<T, FormulaError>;

/// How tightly a sign binds its operand: more than a product, less than a power.
pub(crate) const SIGN: u8 = 7;

/// Returns how tightly an operator binds its left and its right side.
pub(crate) const fn powers(operator: Operator) -> (u8, u8) {
    match operator {
        Operator::Add | Operator::Subtract => (1, 2),
        Operator::Multiply | Operator::Divide | Operator::Dot => (3, 4),
        Operator::Cross => (5, 6),
        // to the right: 2^3^2 = 2^9
        Operator::Power => (10, 9),
    }
}

/// Returns the syntax tree of a text. The names tell how far indices of sums go.
pub(crate) fn parse(text: &str, names: &Vocabulary) -> Parsed<Syntax> {
    let (tokens, syntax) = (tokens(text)?, Syntax::default());
    let mut parser = Parser { tokens, names, place: 0, level: 0, bound: Vec::new(), syntax };
    if parser.peek().token == Token::End {
        return Err(FormulaError::new(0..0, Problem::Empty));
    }
    parser.expression(0)?;
    parser.end()?;
    let has_sums = parser.tokens.iter().any(|placed| placed.token == Token::Name(SUM.into()));
    Ok(if has_sums { parser.syntax.written(text.trim()) } else { parser.syntax })
}

/// The value of an index in the term of a sum that is read.
pub(super) struct Bound {
    pub(super) name: String,
    pub(super) value: usize,
}

pub(super) struct Parser<'a> {
    pub(super) tokens: Vec<Placed>,
    pub(super) names: &'a Vocabulary,
    pub(super) place: usize,
    pub(super) level: usize,
    /// The indices of the sums around the next token.
    pub(super) bound: Vec<Bound>,
    pub(super) syntax: Syntax,
}

impl Parser<'_> {
    pub(super) fn peek(&self) -> Placed {
        let end = || Placed { token: Token::End, span: 0..0 };
        self.tokens.get(self.place).or_else(|| self.tokens.last()).cloned().unwrap_or_else(end)
    }

    pub(super) fn take(&mut self) -> Placed {
        let taken = self.peek();
        self.place += 1;
        taken
    }

    pub(super) fn take_if(&mut self, token: &Token) -> bool {
        let found = self.tokens.get(self.place).is_some_and(|placed| placed.token == *token);
        self.place += usize::from(found);
        found
    }

    /// Checks that no token is left.
    fn end(&self) -> Parsed<()> {
        let Placed { token, span } = self.peek();
        let found = token.to_string();
        match token {
            Token::End => Ok(()),
            Token::Close | Token::CloseIndex | Token::Comma => {
                Err(FormulaError::new(span, Problem::NotOpened { found }))
            }
            _ => Err(FormulaError::new(span, Problem::MissingOperator { found })),
        }
    }

    pub(super) fn check_level(&self) -> Parsed<()> {
        let problem = Problem::TooDeep { limit: MOST_LEVELS };
        if self.level > MOST_LEVELS {
            Err(FormulaError::new(self.peek().span, problem))
        } else {
            Ok(())
        }
    }

    /// Parses operators that bind at least as tightly as `least`, with their operands.
    pub(super) fn expression(&mut self, least: u8) -> Parsed<usize> {
        self.level += 1;
        self.check_level()?;
        let mut left = self.operand()?;
        loop {
            let Placed { token, span } = self.peek();
            let operator = match token {
                Token::Plus => Operator::Add,
                Token::Minus => Operator::Subtract,
                Token::Times => Operator::Multiply,
                Token::Over => Operator::Divide,
                Token::Dot => Operator::Dot,
                Token::Cross => Operator::Cross,
                Token::Power => Operator::Power,
                _ => break,
            };
            let (left_power, right_power) = powers(operator);
            if left_power < least {
                break;
            }
            self.place += 1;
            let right = self.expression(right_power)?;
            left = self.syntax.add(Part::Binary(operator, left, right), span);
        }
        self.level -= 1;
        Ok(left)
    }

    /// Parses a sign with its operand, or a number, name, function or bracket with its powers and components.
    fn operand(&mut self) -> Parsed<usize> {
        let Placed { token, span } = self.take();
        let mut part = match token {
            Token::Plus => return self.expression(SIGN),
            Token::Minus => {
                let operand = self.expression(SIGN)?;
                return Ok(self.syntax.add(Part::Negate(operand), span));
            }
            _ => {
                self.place -= 1;
                self.primary()?
            }
        };
        while let Placed { token: Token::Superscript(exponent), span } = self.peek() {
            self.place += 1;
            let mut exponent_part = self.syntax.add(Part::Number(exponent.abs()), span.clone());
            if exponent < 0.0 {
                exponent_part = self.syntax.add(Part::Negate(exponent_part), span.clone());
            }
            part = self.syntax.add(Part::Binary(Operator::Power, part, exponent_part), span);
        }
        Ok(part)
    }

    /// Parses a number, a name, a function or a bracket, with its components.
    fn primary(&mut self) -> Parsed<usize> {
        let Placed { token, span } = self.take();
        let mut part = match token {
            Token::Number(value) => self.syntax.add(Part::Number(value), span),
            Token::Name(name) => self.name(name, span)?,
            Token::Root => {
                // The level counts nested roots, which no other check bounds.
                self.level += 1;
                self.check_level()?;
                let argument = self.primary()?;
                self.level -= 1;
                self.syntax.add(Part::Call(Function::Sqrt, [argument; 2]), span)
            }
            Token::Open => {
                let inner = self.expression(0)?;
                self.close(&Token::Close, span, "(", ")")?;
                inner
            }
            Token::Bar => {
                let inner = self.expression(0)?;
                self.close(&Token::Bar, span.clone(), "|", "|")?;
                self.syntax.add(Part::Norm(inner), span)
            }
            other => {
                let problem = Problem::MissingOperand { found: other.to_string() };
                return Err(FormulaError::new(span, problem));
            }
        };
        while let Placed { token: Token::OpenIndex, span } = self.peek() {
            self.place += 1;
            let at = self.peek().span;
            let index = self.index()?;
            self.close(&Token::CloseIndex, span, "[", "]")?;
            part = self.component(part, index, at);
        }
        Ok(part)
    }

    /// Adds a component of a vector, or the vector `S_3` if that is what `S[3]` must mean.
    fn component(&mut self, part: usize, index: usize, span: Range<usize>) -> usize {
        let numbered = self.syntax.name_of(part).filter(|name| self.names.meaning(name).is_none());
        let numbered = numbered.map(|name| format!("{name}_{index}"));
        match numbered.filter(|name| self.names.meaning(name).is_some()) {
            Some(name) => self.syntax.rename(part, name),
            None => self.syntax.add(Part::Component(part, index), span),
        }
    }

    /// Takes the closing bracket of one that was opened at `span`.
    pub(super) fn close(
        &mut self,
        token: &Token,
        span: Range<usize>,
        opening: &'static str,
        closing: &'static str,
    ) -> Parsed<()> {
        if self.take_if(token) {
            return Ok(());
        }
        let next = self.peek();
        let found = next.token.to_string();
        Err(match next.token {
            Token::End | Token::Close | Token::CloseIndex | Token::Comma => {
                FormulaError::new(span, Problem::NotClosed { opening, closing })
            }
            _ => FormulaError::new(next.span, Problem::MissingOperator { found }),
        })
    }

    /// Parses what follows a name: a function with its arguments, or the name alone.
    fn name(&mut self, name: String, span: Range<usize>) -> Parsed<usize> {
        let function = Function::NAMES.iter().find(|(known, _)| *known == name);
        let other = match name.as_str() {
            "norm" | "abs" => Some(1),
            "dot" | "cross" => Some(2),
            CHOICE => Some(3),
            SUM => Some(1),
            _ => function.map(|(_, function)| function.arguments()),
        };
        let opened = self.peek();
        if opened.token != Token::Open {
            return match other {
                Some(_) => Err(FormulaError::new(span, Problem::MissingArgument { name })),
                None => Ok(self.syntax.add_name(name, span)),
            };
        }
        let Some(expected) = other else {
            // The names of coordinates are not known here: a name counts as an unknown function if it resembles that
            // of a function.
            let names = Function::NAMES.iter().map(|(name, _)| *name);
            let suggestion =
                closest_name(&name, names.chain(["norm", "abs", "dot", "cross", CHOICE, SUM]));
            let problem = match suggestion {
                Some(_) => Problem::UnknownFunction { name, suggestion },
                None => Problem::NotAFunction { name },
            };
            return Err(FormulaError::new(span, problem));
        };
        self.place += 1;
        if name == SUM {
            return self.sum(span, opened.span);
        }
        if name == CHOICE {
            return self.choice(name, span, opened.span);
        }
        let mut arguments = Vec::new();
        if self.peek().token != Token::Close {
            arguments.push(self.expression(0)?);
            while self.take_if(&Token::Comma) {
                arguments.push(self.expression(0)?);
            }
        }
        self.close(&Token::Close, opened.span, "(", ")")?;
        let part = match (name.as_str(), function, arguments.as_slice()) {
            ("norm" | "abs", _, &[x]) => Part::Norm(x),
            ("dot", _, &[x, y]) => Part::Binary(Operator::Dot, x, y),
            ("cross", _, &[x, y]) => Part::Binary(Operator::Cross, x, y),
            (_, Some((_, function)), &[x]) if expected == 1 => Part::Call(*function, [x; 2]),
            (_, Some((_, function)), &[x, y]) if expected == 2 => Part::Call(*function, [x, y]),
            _ => {
                let found = arguments.len();
                let problem = Problem::WrongArgumentCount { name, expected, found };
                return Err(FormulaError::new(span, problem));
            }
        };
        Ok(self.syntax.add(part, span))
    }

    /// Parses the arguments of `if(a >= b, y, z)`, which is y where a ≥ b and z elsewhere.
    fn choice(&mut self, name: String, span: Range<usize>, opened: Range<usize>) -> Parsed<usize> {
        let left = self.expression(0)?;
        let Placed { token: Token::Comparison(comparison), .. } = self.take() else {
            return Err(FormulaError::new(span, Problem::NoCondition));
        };
        let right = self.expression(0)?;
        let mut values = Vec::new();
        while self.take_if(&Token::Comma) {
            values.push(self.expression(0)?);
        }
        self.close(&Token::Close, opened, "(", ")")?;
        let [holds, fails] = *values.as_slice() else {
            let found = 1 + values.len();
            let problem = Problem::WrongArgumentCount { name, expected: 3, found };
            return Err(FormulaError::new(span, problem));
        };
        let parts = [left, right, holds, fails];
        Ok(self.syntax.add(Part::Choose(comparison, parts), span))
    }
}
