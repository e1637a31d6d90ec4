//! The instructions of a graph: the choice of the nodes that become an instruction of their own.

use super::instruction::{Binary, Instruction, Operation};
use crate::graphs::graph::{Graph, Id, Node};
use crate::graphs::simplification::whole;

/// Returns the instructions that compute the roots, in order; numbers and coordinates need none.
pub(crate) fn select(graph: &Graph, roots: &[Id]) -> Vec<Instruction<Id>> {
    let uses = uses(graph, roots);
    let mut needed = vec![false; graph.len()];
    for &root in roots {
        mark(&mut needed, root);
    }
    let mut instructions = Vec::new();
    for id in (0..graph.len()).rev() {
        if needed.get(id) == Some(&true)
            && let Some((operation, operands)) = choose(graph, id, &uses)
        {
            operands.iter().for_each(|&operand| mark(&mut needed, operand));
            instructions.push(Instruction { operation, target: id, operands });
        }
    }
    instructions.reverse();
    instructions
}

fn mark(needed: &mut [bool], id: Id) {
    if let Some(mark) = needed.get_mut(id) {
        *mark = true;
    }
}

/// Returns for each node how often it is a part of another node or a root.
fn uses(graph: &Graph, roots: &[Id]) -> Vec<usize> {
    let reachable = graph.reachable(roots);
    let mut uses = vec![0; graph.len()];
    let parts = (0..graph.len()).filter(|&id| reachable.get(id) == Some(&true));
    for part in parts.flat_map(|id| graph.node(id).parts()).chain(roots.iter().copied()) {
        if let Some(count) = uses.get_mut(part) {
            *count += 1;
        }
    }
    uses
}

/// Returns the operation of a node with its operands, or `None` for a number or a coordinate.
fn choose(graph: &Graph, id: Id, uses: &[usize]) -> Option<(Operation, [Id; 3])> {
    let node = graph.node(id);
    let (operation, operands) = match node {
        Node::Number(_) | Node::Input(_) => return None,
        Node::Add(a, b) => return Some(sum(graph, a, b, uses)),
        Node::Multiply(a, b) => match graph.as_number(a) {
            Some(number) => multiple(graph, number, b, uses),
            None => (Operation::Multiply, [a, b, a]),
        },
        Node::Divide(a, b) => (Operation::Divide, [a, b, a]),
        Node::Power(a, bits) => {
            (Operation::Power(whole(f64::from_bits(bits)).unwrap_or(1)), [a; 3])
        }
        Node::Function(function, a) => (Operation::Function(function), [a; 3]),
        Node::Angle(y, x) => (Operation::OfTwo(Binary::Angle), [y, x, y]),
        Node::Hypotenuse(x, y) => (Operation::OfTwo(Binary::Hypotenuse), [x, y, x]),
        Node::Choose(parts) => (Operation::Choose, parts),
    };
    Some((operation, operands))
}

/// Returns a multiple of a node as an operation that includes a product that nothing else uses.
fn multiple(graph: &Graph, number: f64, x: Id, uses: &[usize]) -> (Operation, [Id; 3]) {
    match graph.node(x) {
        Node::Multiply(a, b) if uses.get(x) == Some(&1) && graph.as_number(a).is_none() => {
            (Operation::ScaleProduct(number), [a, b, a])
        }
        _ if number == -1.0 => (Operation::Negate, [x; 3]),
        _ => (Operation::Scale(number), [x; 3]),
    }
}

/// Returns a sum as an operation that includes a side that is a number, a multiple, or a product that nothing else
/// uses.
fn sum(graph: &Graph, a: Id, b: Id, uses: &[usize]) -> (Operation, [Id; 3]) {
    for (a, b) in [(a, b), (b, a)] {
        if let Some(number) = graph.as_number(b) {
            return (Operation::Offset(number), [a; 3]);
        }
        if let Node::Multiply(c, x) = graph.node(b)
            && let Some(number) = graph.as_number(c)
        {
            return match number {
                -1.0 => (Operation::Subtract, [a, x, a]),
                _ => (Operation::ScaleAdd(number), [x, a, x]),
            };
        }
    }
    for (a, b) in [(a, b), (b, a)] {
        if let Node::Multiply(x, y) = graph.node(b)
            && uses.get(b) == Some(&1)
        {
            return (Operation::MultiplyAdd, [x, y, a]);
        }
    }
    (Operation::Add, [a, b, a])
}
