//! A scalar as text, with its derivatives: [`Formula`].

use crate::graphs::elaboration::elaborate;
use crate::graphs::graph::{Graph, Node};
use crate::names::vocabulary::Vocabulary;
use crate::tapes::tape::Tape;
use crate::text::expressions::{Expression, Expressions};
use crate::text::formula_error::FormulaError;
use crate::text::parsing::parser::parse;
use crate::text::printer::print;
use crate::text::syntax::{Part, Syntax};
use core::fmt;
use core::ops::Range;
use lie_poisson::{Real, Vector};
use std::sync::Arc;

/// A scalar function h of named coordinates, written as text, with its exact derivatives dh and D²h·v.
///
/// The text becomes a graph in which equal parts are computed once. The derivatives are formed symbolically and
/// simplified, so that the gradient of a quadratic form costs a few products. Value, gradient and second derivative
/// are lists of instructions that run over every scalar. Their results in SIMD lanes (several trajectories in one
/// register) are bit-identical to those for `f64`. An evaluation allocates nothing.
///
/// Copies share everything that was computed from the text. Two formulas are equal if their expressions, names and
/// parameters are the same. Spaces, superfluous parentheses and alternative spellings of an operator make no
/// difference.
///
/// # Errors
/// [`new`](Self::new) returns a [`FormulaError`], which states the problem and its place in the text.
///
/// # Example
/// The energy of a heavy top, h = ½ Π·I⁻¹Π + mgl c·Γ:
/// ```
/// use lie_poisson::{Pair, Se3, Se3Dual};
/// use lie_poisson_formulas::{Formula, Parameters, Vocabulary};
/// use nalgebra::Vector3;
///
/// let parameters = Parameters::new().vector("I", &[2.0, 2.0, 1.0])?.number("mgl", 1.0)?.vector("c", &[1.0, 0.0, 0.0])?;
/// let names = Vocabulary::of(&Se3::default(), &parameters)?;
/// let h = Formula::new("½*(Π₁²/I₁ + Π₂²/I₂ + Π₃²/I₃) + mgl*c·Γ", &names)?;
/// let mu = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.5, 0.0, 0.75_f64.sqrt()));
/// assert_eq!(h.value(&mu), 11.75);
/// // dh = (I⁻¹Π, mgl c)
/// assert_eq!(h.differential(&mu), Pair(Vector3::new(1.0, 1.5, 4.0), Vector3::x()));
/// assert_eq!(h.to_string(), "0.5*(Pi1^2/I1 + Pi2^2/I2 + Pi3^2/I3) + mgl*c·Gamma");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct Formula(Arc<Compiled>);

#[derive(Clone)]
struct Compiled {
    syntax: Syntax,
    /// The text that is printed instead of the formula.
    short: Option<String>,
    names: Vocabulary,
    dimension: usize,
    /// Whether the value depends on each coordinate.
    depends: Vec<bool>,
    period: Option<f64>,
    /// Whether the derivatives are numbers, and no part is chosen by a condition.
    has_constant_gradient: bool,
    value: Tape,
    gradient: Tape,
    second_derivative: Tape,
}

impl Formula {
    /// Creates a formula from its text.
    ///
    /// # Errors
    /// Returns [`FormulaError`] if the text is not a formula in these names; if it is a vector; if a part has a
    /// constant value that is infinite or not a number, such as 1/0; or if the formula or its derivatives exceed the
    /// limits on length and nesting, which are larger than a person needs.
    ///
    /// # Example
    /// ```
    /// use lie_poisson::So3;
    /// use lie_poisson_formulas::{Formula, Parameters, Vocabulary};
    /// let names = Vocabulary::of(&So3, &Parameters::new())?;
    /// let error = Formula::new("2 Pi1", &names).unwrap_err();
    /// assert_eq!(error.quoted("2 Pi1"), "2 Pi1\n  ^^^ an operator is missing before `Pi1`; write `*` for a product");
    /// # Ok::<(), lie_poisson_formulas::NameError>(())
    /// ```
    pub fn new(text: &str, names: &Vocabulary) -> Result<Self, FormulaError> {
        Self::of_syntax(parse(text, names)?, names, 0..text.len())
    }

    /// Creates a formula from one of the expressions that a program has built.
    ///
    /// A part that several others use is computed once. The printed formula names such parts: `s1 = …; s1*exp(s1)`.
    ///
    /// # Errors
    /// Returns [`FormulaError`] as [`new`](Self::new) does, or if the part is not one of these expressions. Its span is
    /// empty, since there is no text.
    pub fn of_expressions(
        expressions: &Expressions,
        value: Expression,
        names: &Vocabulary,
    ) -> Result<Self, FormulaError> {
        Self::of_syntax(expressions.syntax_of(value)?, names, 0..0)
    }

    fn of_syntax(
        syntax: Syntax,
        names: &Vocabulary,
        whole: Range<usize>,
    ) -> Result<Self, FormulaError> {
        let mut graph = Graph::default();
        let value = elaborate(&syntax, names, &mut graph)?;
        let inputs = names.coordinates().dimension();
        let reachable = graph.reachable(&[value]);
        let is_reachable = |id| reachable.get(id) == Some(&true);
        let depends =
            (0..inputs).map(|i| graph.find(Node::Input(i)).is_some_and(is_reachable)).collect();
        let period = graph.period(value);
        let gradient = graph.gradient(value, inputs);
        let is_constant = gradient.iter().all(|&slope| graph.as_number(slope).is_some());
        let has_constant_gradient = is_constant && !graph.is_piecewise(value);
        let tangents = graph.tangents(&gradient, inputs);
        let tape = |roots: &[usize], inputs, first| {
            Tape::new(&graph, roots, inputs, first)
                .map_err(|problem| FormulaError::new(whole.clone(), problem))
        };
        Ok(Self(Arc::new(Compiled {
            value: tape(&[value], inputs, 0)?,
            gradient: tape(&gradient, inputs, 0)?,
            second_derivative: tape(&tangents, 2 * inputs, inputs)?,
            names: names.clone(),
            dimension: inputs,
            depends,
            period,
            has_constant_gradient,
            syntax,
            short: None,
        })))
    }

    /// Creates the formula of another syntax tree in the same names.
    pub(super) fn with_syntax(&self, syntax: Syntax) -> Result<Self, FormulaError> {
        Self::of_syntax(syntax, self.names(), 0..0)
    }

    /// Returns the formula of −h.
    ///
    /// ```
    /// use lie_poisson::So3;
    /// use lie_poisson_formulas::{Formula, Parameters, Vocabulary};
    /// let h = Formula::new("Pi1 + Pi2", &Vocabulary::of(&So3, &Parameters::new())?)?;
    /// assert_eq!(h.negated()?.to_string(), "-(Pi1 + Pi2)");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// Returns [`FormulaError`] if the formula is as large as a formula may be.
    pub fn negated(&self) -> Result<Self, FormulaError> {
        let mut syntax = self.syntax().clone();
        if let Some(last) = syntax.parts().count().checked_sub(1) {
            syntax.add(Part::Negate(last), 0..0);
        }
        self.with_syntax(syntax)
    }

    /// Returns the formula with a short text that is printed instead of it, such as `tr X^5` for a polynomial of thousands
    /// of terms that a program has built. Errors that name a failing part name the whole formula by this text.
    ///
    /// The text says to a reader what the formula is. It need not be a formula, and is not read back.
    ///
    /// ```
    /// use lie_poisson::So3;
    /// use lie_poisson_formulas::{Formula, Parameters, Vocabulary};
    /// let names = Vocabulary::of(&So3, &Parameters::new())?;
    /// let square = Formula::new("-2*(Pi1^2 + Pi2^2 + Pi3^2)", &names)?.printed_as("tr X^2");
    /// assert_eq!(square.to_string(), "tr X^2");
    /// assert_eq!(square.value_at(&[1.0, 2.0, 2.0]), -18.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn printed_as(self, text: &str) -> Self {
        let compiled = Arc::unwrap_or_clone(self.0);
        Self(Arc::new(Compiled { short: Some(text.into()), ..compiled }))
    }

    /// Returns the short text that is printed instead of the formula, if it has one.
    pub(super) fn short(&self) -> Option<&str> {
        self.0.short.as_deref()
    }

    /// Returns the printed text.
    fn printed(&self) -> String {
        self.short().map_or_else(|| print(&self.0.syntax), str::to_owned)
    }

    /// Returns the formula of the same text in other names.
    pub(crate) fn renamed(&self, names: &Vocabulary) -> Result<Self, FormulaError> {
        Self::of_syntax(self.syntax().clone(), names, 0..0)
    }

    /// Returns the syntax tree.
    pub(super) fn syntax(&self) -> &Syntax {
        &self.0.syntax
    }

    /// Returns the names of coordinates and parameters in which the formula is written.
    #[must_use]
    pub fn names(&self) -> &Vocabulary {
        &self.0.names
    }

    /// Returns the number of coordinates.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.0.dimension
    }

    /// Returns whether the formula depends on a coordinate, after simplification.
    ///
    /// ```
    /// use lie_poisson::So3;
    /// use lie_poisson_formulas::{Formula, Parameters, Vocabulary};
    /// let names = Vocabulary::of(&So3, &Parameters::new())?;
    /// let h = Formula::new("if(Pi1 > 0, 1, 2) + 0*Pi2", &names)?;
    /// assert_eq!([0, 1, 2].map(|i| h.depends_on(i)), [true, false, false]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn depends_on(&self, coordinate: usize) -> bool {
        self.0.depends.get(coordinate) == Some(&true)
    }

    /// Returns the period of the values if the formula is an angle, and `None` otherwise.
    ///
    /// `atan2(y, x)` has the period 2π: along a motion it jumps from π to −π, although the direction of (x, y) turns
    /// steadily. So do sums of such angles and functions without one. A constant factor multiplies the period: in degrees
    /// it is 360. The period tells a jump of an angle from a change of it, in a surface or an event where the angle has a
    /// value.
    ///
    /// `arcsin`, `arccos`, `arctan`, and `atan2` with an argument that is never negative, cover half a turn alone. They do
    /// not jump by 2π, each of their values is one of its own, and they have no period.
    ///
    /// ```
    /// use core::f64::consts::{PI, TAU};
    /// use lie_poisson::So3;
    /// use lie_poisson_formulas::{Formula, Parameters, Vocabulary};
    /// let names = Vocabulary::of(&So3, &Parameters::new())?;
    /// let period = |text| Formula::new(text, &names).ok().and_then(|formula| formula.period());
    /// assert_eq!(period("atan2(Pi2, Pi1)"), Some(TAU));
    /// assert_eq!(period("1 - atan2(Pi2, Pi1) + atan2(Pi3, |Pi|)"), Some(TAU));
    /// assert_eq!(period("atan2(Pi2, Pi1)/2"), Some(PI));
    /// assert_eq!(period("sin(atan2(Pi2, Pi1))"), None);
    /// assert_eq!(period("arctan(Pi1)"), None);
    /// # Ok::<(), lie_poisson_formulas::NameError>(())
    /// ```
    #[must_use]
    pub fn period(&self) -> Option<f64> {
        self.0.period
    }

    /// Returns the value h(z), or NaN if z has fewer or more coordinates than the formula.
    #[inline]
    pub fn value<V: Vector>(&self, z: &V) -> V::Scalar {
        self.0.value.scalar(V::DIM, |i| z.coordinate(i))
    }

    /// Returns the value h(z) at coordinates in a slice, or NaN if the slice has fewer or more coordinates than the
    /// formula.
    ///
    /// ```
    /// use lie_poisson::So3;
    /// use lie_poisson_formulas::{Formula, Parameters, Vocabulary};
    /// let h = Formula::new("Pi1*Pi2 + Pi3", &Vocabulary::of(&So3, &Parameters::new())?)?;
    /// assert_eq!(h.value_at(&[2.0, 3.0, 4.0]), 10.0);
    /// assert!(h.value_at(&[2.0, 3.0]).is_nan());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn value_at(&self, z: &[f64]) -> f64 {
        self.0.value.scalar(z.len(), |i| z.get(i).copied().unwrap_or(f64::NAN))
    }

    /// Returns the value at the point with the coordinates z(i), i < `count`, over every scalar, or NaN if the formula has
    /// another number of coordinates.
    ///
    /// ```
    /// use lie_poisson::So3;
    /// use lie_poisson_formulas::{Formula, Parameters, Vocabulary};
    /// let h = Formula::new("Pi1*Pi2 + Pi3", &Vocabulary::of(&So3, &Parameters::new())?)?;
    /// assert_eq!(h.value_of(3, |i| 2.0 + i as f64), 10.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn value_of<T: Real>(&self, count: usize, z: impl Fn(usize) -> T) -> T {
        self.0.value.scalar(count, z)
    }

    /// Returns whether the differential takes less time in wider registers. It need not if it has hundreds of terms, which need
    /// more than 1,024 numbers at once.
    ///
    /// ```
    /// use lie_poisson::So3;
    /// use lie_poisson_formulas::{Formula, Parameters, Vocabulary};
    /// let names = Vocabulary::of(&So3, &Parameters::new())?;
    /// let terms = |count| (0..count).map(|k| format!("sin({k}*Pi1)*cos(Pi2^{k})")).collect::<Vec<_>>().join(" + ");
    /// assert!(Formula::new(&terms(3), &names)?.pays_in_wide_registers());
    /// assert!(!Formula::new(&terms(300), &names)?.pays_in_wide_registers());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn pays_in_wide_registers(&self) -> bool {
        self.0.gradient.pays_in_wide_registers()
    }

    /// Returns the differential dh(z), with the coordinates ∂h/∂zᵢ, or NaN if z has fewer or more coordinates
    /// than the formula.
    #[cfg_attr(optimised, inline(always))]
    pub fn differential<V: Vector>(&self, z: &V) -> V::Dual {
        self.0.gradient.vector(V::DIM, |i| z.coordinate(i), |i| z.coordinate(i))
    }

    /// Returns the coordinates ∂h/∂zᵢ of the differential at coordinates in a slice, or NaN if the slice has fewer or
    /// more coordinates than the formula.
    ///
    /// ```
    /// use lie_poisson::So3;
    /// use lie_poisson_formulas::{Formula, Parameters, Vocabulary};
    /// let h = Formula::new("Pi1*Pi2 + Pi3", &Vocabulary::of(&So3, &Parameters::new())?)?;
    /// assert_eq!(h.differential_at(&[2.0, 3.0, 4.0]), [3.0, 2.0, 1.0]);
    /// assert!(h.differential_at(&[2.0, 3.0]).iter().all(|slope| slope.is_nan()));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn differential_at(&self, z: &[f64]) -> Vec<f64> {
        let mut slopes = vec![f64::NAN; z.len()];
        self.write_differential(z, &mut slopes);
        slopes
    }

    /// Writes the coordinates ∂h/∂zᵢ of the differential at coordinates in a slice, without an allocation. They are NaN if
    /// the slice has fewer or more coordinates than the formula. Those for which there is no room are left out.
    ///
    /// ```
    /// use lie_poisson::So3;
    /// use lie_poisson_formulas::{Formula, Parameters, Vocabulary};
    /// let h = Formula::new("Pi1*Pi2 + Pi3", &Vocabulary::of(&So3, &Parameters::new())?)?;
    /// let mut slopes = [0.0; 3];
    /// h.write_differential(&[2.0, 3.0, 4.0], &mut slopes);
    /// assert_eq!(slopes, [3.0, 2.0, 1.0]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn write_differential(&self, z: &[f64], slopes: &mut [f64]) {
        self.0.gradient.write(z, slopes);
    }

    /// Passes the coordinates ∂h/∂zᵢ of the differential on, over every scalar and without an allocation. The point has the
    /// coordinates z(i), i < `count`. There are none if the formula has another number of coordinates.
    ///
    /// ```
    /// use lie_poisson::So3;
    /// use lie_poisson_formulas::{Formula, Parameters, Vocabulary};
    /// let h = Formula::new("Pi1*Pi2 + Pi3", &Vocabulary::of(&So3, &Parameters::new())?)?;
    /// assert_eq!(h.with_differential(3, |i| 2.0 + i as f64, <[f64]>::to_vec), [3.0, 2.0, 1.0]);
    /// assert!(h.with_differential(2, |i| i as f64, <[f64]>::is_empty));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[cfg_attr(optimised, inline(always))]
    pub fn with_differential<T: Real, R>(
        &self,
        count: usize,
        z: impl Fn(usize) -> T,
        mut use_it: impl FnMut(&[T]) -> R,
    ) -> R {
        match count == self.dimension() {
            true => self.0.gradient.pass((count, count), &z, &z, use_it),
            false => use_it(&[]),
        }
    }

    /// Passes the coordinates Σⱼ ∂²h/∂zᵢ∂zⱼ vⱼ of D²h(z)·v on, as [`with_differential`](Self::with_differential) does.
    ///
    /// ```
    /// use lie_poisson::So3;
    /// use lie_poisson_formulas::{Formula, Parameters, Vocabulary};
    /// let h = Formula::new("Pi1^2*Pi2", &Vocabulary::of(&So3, &Parameters::new())?)?;
    /// let moved = h.with_second_derivative(&[3.0, 5.0, 0.0], &[1.0, 10.0, 0.0], <[f64]>::to_vec);
    /// assert_eq!(moved, [10.0 + 60.0, 6.0, 0.0]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn with_second_derivative<T: Real, R>(
        &self,
        z: &[T],
        v: &[T],
        mut use_it: impl FnMut(&[T]) -> R,
    ) -> R {
        let count = self.dimension();
        let both = |i: usize| if i < count { z[i] } else { v[i - count] };
        match [z.len(), v.len()] == [count; 2] {
            true => self.0.second_derivative.pass((2 * count, count), both, |i| v[i], use_it),
            false => use_it(&[]),
        }
    }

    /// Returns the coefficients a_i if the formula is a linear form Σ a_i zᵢ, and `None` otherwise.
    ///
    /// ```
    /// use lie_poisson::So3;
    /// use lie_poisson_formulas::{Formula, Parameters, Vocabulary};
    /// let names = Vocabulary::of(&So3, &Parameters::new())?;
    /// let form = |text| Ok::<_, Box<dyn std::error::Error>>(Formula::new(text, &names)?.linear_form());
    /// assert_eq!(form("2*Pi1 - (Pi3 + Pi1)")?, Some(vec![1.0, 0.0, -1.0]));
    /// assert_eq!(form("|Pi1|")?, None);
    /// assert_eq!(form("Pi1 + 1")?, None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn linear_form(&self) -> Option<Vec<f64>> {
        let zero = vec![0.0; self.dimension()];
        let is_linear = self.0.has_constant_gradient && self.value_at(&zero) == 0.0;
        is_linear.then(|| self.differential_at(&zero))
    }

    /// Returns the derivative D²h(z)·v of the differential along v, with the coordinates Σⱼ ∂²h/∂zᵢ∂zⱼ vⱼ.
    ///
    /// ```
    /// use lie_poisson::So3;
    /// use lie_poisson_formulas::{Formula, Parameters, Vocabulary};
    /// use nalgebra::Vector3;
    /// let h = Formula::new("Pi1^2*Pi2", &Vocabulary::of(&So3, &Parameters::new())?)?;
    /// // D²h = [2 Π₂, 2 Π₁; 2 Π₁, 0]
    /// let moved = h.second_derivative(&Vector3::new(3.0, 5.0, 0.0), &Vector3::new(1.0, 10.0, 0.0));
    /// assert_eq!(moved.0, Vector3::new(10.0 + 60.0, 6.0, 0.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[inline]
    pub fn second_derivative<V: Vector>(&self, z: &V, v: &V) -> V::Dual {
        let both = |i| if i < V::DIM { z.coordinate(i) } else { v.coordinate(i - V::DIM) };
        self.0.second_derivative.vector(2 * V::DIM, both, |i| v.coordinate(i))
    }
}

impl PartialEq for Formula {
    fn eq(&self, other: &Self) -> bool {
        self.0.syntax == other.0.syntax && self.0.names == other.0.names
    }
}

/// Prints the formula with plain names and no superfluous parentheses. If the formula was created from a text, the
/// printed text parses to an equal formula.
///
/// A part of [`Expressions`] that is used several times is printed once, before the formula: `s1 = …; s1*exp(s1)`. A
/// formula that has [a short text](Self::printed_as) prints this.
impl fmt::Display for Formula {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.printed())
    }
}

impl fmt::Debug for Formula {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Formula").field(&self.printed()).finish()
    }
}
