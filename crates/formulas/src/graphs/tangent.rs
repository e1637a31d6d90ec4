//! The derivative of expressions along a vector, by the chain rule from the parts to the whole.

use super::graph::{Graph, Id, Node};

impl Graph {
    /// Returns the derivative of each expression along the vector whose i-th coordinate is the input `inputs + i`.
    pub(crate) fn tangents(&mut self, roots: &[Id], inputs: usize) -> Vec<Id> {
        let reachable = self.reachable(roots);
        let zero = self.number(0.0);
        let mut tangents = vec![zero; reachable.len()];
        for id in 0..reachable.len() {
            if reachable.get(id) != Some(&true) {
                continue;
            }
            let at = |part: Id| tangents.get(part).copied().unwrap_or(zero);
            let new = match self.node(id) {
                Node::Input(i) => self.input(inputs + i),
                node if node.parts().all(|part| at(part) == zero) => zero,
                Node::Number(_) => zero,
                Node::Add(a, b) => self.add(at(a), at(b)),
                Node::Multiply(a, b) => self.two_terms([(at(a), b), (at(b), a)], zero),
                Node::Divide(a, b) => {
                    let moved = self.two_terms([(at(b), id), (zero, id)], zero);
                    let moved = self.negate(moved);
                    let above = self.add(at(a), moved);
                    self.divide(above, b)
                }
                Node::Power(a, bits) => {
                    let exponent = f64::from_bits(bits);
                    let power = self.inner_power(a, exponent - 1.0);
                    let scaled = self.scale(exponent, at(a));
                    self.multiply(scaled, power)
                }
                Node::Function(function, a) => {
                    let derivative = self.function_derivative(function, a, id);
                    self.multiply(derivative, at(a))
                }
                Node::Choose([condition, a, b]) => self.choose_slope(condition, at(a), at(b)),
                Node::Hypotenuse(a, b) => {
                    let inverse = self.power(id, -1.0);
                    let [da, db] = [a, b].map(|part| self.multiply(inverse, part));
                    self.two_terms([(at(a), da), (at(b), db)], zero)
                }
                Node::Angle(y, x) => {
                    let (dy, dx) = self.angle_derivatives(y, x);
                    self.two_terms([(at(y), dy), (at(x), dx)], zero)
                }
            };
            if let Some(tangent) = tangents.get_mut(id) {
                *tangent = new;
            }
        }
        roots.iter().map(|&root| tangents.get(root).copied().unwrap_or(zero)).collect()
    }

    /// Returns the sum of tangents times factors; a tangent that is zero everywhere has no term.
    fn two_terms(&mut self, terms: [(Id, Id); 2], zero: Id) -> Id {
        let products: Vec<_> = terms
            .into_iter()
            .filter(|(tangent, _)| *tangent != zero)
            .map(|(tangent, factor)| self.multiply(tangent, factor))
            .collect();
        self.sum(&products)
    }
}
