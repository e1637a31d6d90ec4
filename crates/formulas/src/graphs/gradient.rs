//! The gradient of an expression, by the chain rule from the whole to its parts.

use super::graph::{Graph, Id, Node, Unary};
use super::guards::Term;

impl Graph {
    /// Returns the derivative of an expression with respect to each of the first `inputs` coordinates.
    ///
    /// The method is reverse differentiation: each part receives the derivative of the whole with respect to it, and
    /// passes it on to its own parts. The number of new nodes is a small multiple of the number of nodes of the
    /// expression, whatever the number of coordinates.
    ///
    /// What a part receives through a formula that is not chosen does not count, even where the part has no slope.
    pub(crate) fn gradient(&mut self, root: Id, inputs: usize) -> Vec<Id> {
        let reachable = self.reachable(&[root]);
        let mut terms: Vec<Vec<Term>> = vec![Vec::new(); root + 1];
        let mut gradient = vec![self.number(0.0); inputs];
        let one = self.number(1.0);
        if let Some(whole) = terms.get_mut(root) {
            whole.push(Term { guard: None, slope: one });
        }
        for id in (0..=root).rev() {
            if reachable.get(id) != Some(&true) || self.as_number(id).is_some() {
                continue;
            }
            let own = terms.get_mut(id).map(core::mem::take).unwrap_or_default();
            if own.is_empty() {
                // A part of a condition alone.
                continue;
            }
            let own = self.merged(&own);
            if let Node::Input(i) = self.node(id) {
                if let Some(entry) = gradient.get_mut(i) {
                    *entry = self.total(&own);
                }
                continue;
            }
            let whole = self.joined(&own);
            for (part, term) in self.passed_on(id, whole) {
                // A number passes no derivative on.
                if self.as_number(part).is_none()
                    && let Some(terms) = terms.get_mut(part)
                {
                    terms.push(term);
                }
            }
        }
        gradient
    }

    /// Returns the parts of a node, each with its contribution: the slope of the node times the partial derivative.
    fn passed_on(&mut self, id: Id, whole: Term) -> Vec<(Id, Term)> {
        let slope = whole.slope;
        let passed = match self.node(id) {
            Node::Number(_) | Node::Input(_) => Vec::new(),
            Node::Add(a, b) => vec![(a, slope), (b, slope)],
            Node::Multiply(a, b) => {
                vec![(a, self.multiply(slope, b)), (b, self.multiply(slope, a))]
            }
            Node::Divide(a, b) => {
                let first = self.divide(slope, b);
                let second = self.multiply(first, id);
                vec![(a, first), (b, self.negate(second))]
            }
            Node::Power(a, bits) => {
                let exponent = f64::from_bits(bits);
                let scaled = self.scale(exponent, slope);
                let power = self.inner_power(a, exponent - 1.0);
                vec![(a, self.multiply(scaled, power))]
            }
            // d√x = ½/√x keeps the quotient of the slope
            Node::Function(Unary::Sqrt, a) => {
                let half = self.scale(0.5, slope);
                vec![(a, self.divide(half, id))]
            }
            Node::Function(Unary::Ln, a) => vec![(a, self.divide(slope, a))],
            Node::Function(function, a) => {
                let derivative = self.function_derivative(function, a, id);
                vec![(a, self.multiply(slope, derivative))]
            }
            Node::Choose([condition, a, b]) => {
                let [holds, fails] = self.guards(whole.guard, condition);
                return vec![(a, Term { guard: holds, slope }), (b, Term { guard: fails, slope })];
            }
            // dh = (x dx + y dy)/h, with a quotient that is in range where h is
            Node::Hypotenuse(a, b) => {
                let first = self.divide(slope, id);
                vec![(a, self.multiply(first, a)), (b, self.multiply(first, b))]
            }
            Node::Angle(y, x) => {
                let (dy, dx) = self.angle_derivatives(y, x);
                vec![(y, self.multiply(slope, dy)), (x, self.multiply(slope, dx))]
            }
        };
        passed.into_iter().map(|(part, slope)| (part, Term { slope, ..whole })).collect()
    }

    /// Returns f′(x), where `value` is f(x).
    pub(crate) fn function_derivative(&mut self, function: Unary, x: Id, value: Id) -> Id {
        match function {
            Unary::Sqrt => {
                let half = self.number(0.5);
                self.divide(half, value)
            }
            Unary::Exp => value,
            Unary::Ln => self.power(x, -1.0),
            Unary::Sin => self.function(Unary::Cos, x),
            Unary::Cos => {
                let sin = self.function(Unary::Sin, x);
                self.negate(sin)
            }
            Unary::Sinh => self.function(Unary::Cosh, x),
            Unary::Cosh => self.function(Unary::Sinh, x),
            // 1 − tanh² x = 4e/(1 + e)² with e = exp(−2|x|), accurate where tanh x rounds to ±1
            Unary::Tanh => {
                let size = self.function(Unary::Absolute, x);
                let exponent = self.scale(-2.0, size);
                let e = self.function(Unary::Exp, exponent);
                let one = self.number(1.0);
                let sum = self.add(one, e);
                let (above, below) = (self.scale(4.0, e), self.multiply(sum, sum));
                self.divide(above, below)
            }
            Unary::Absolute => self.function(Unary::Sign, x),
            Unary::Sign => self.number(0.0),
        }
    }

    /// Returns the partial derivatives x/(x² + y²) and −y/(x² + y²) of the angle of (x, y).
    pub(crate) fn angle_derivatives(&mut self, y: Id, x: Id) -> (Id, Id) {
        let (xx, yy) = (self.multiply(x, x), self.multiply(y, y));
        let square = self.add(xx, yy);
        let (dy, dx) = (self.divide(x, square), self.divide(y, square));
        (dy, self.negate(dx))
    }
}
