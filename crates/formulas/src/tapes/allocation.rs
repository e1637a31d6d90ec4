//! Registers for the nodes of a graph: a register is reused once its value is no longer needed.

use super::instruction::{Instruction, Operation};
use crate::graphs::graph::{Graph, Id, Node};
use crate::text::formula_error::Problem;
use std::collections::HashMap;

/// The largest number of registers, and the sizes of the arrays that hold them.
pub(crate) const SIZES: [usize; 6] = [16, 32, 64, 256, 1024, 8192];

/// The instructions on registers, and the contents of the registers before the first instruction.
pub(crate) struct Allocation {
    pub(crate) instructions: Vec<Instruction<u16>>,
    /// The numbers that are in registers from the start.
    pub(crate) numbers: Vec<(u16, f64)>,
    /// The number of registers, one of [`SIZES`].
    pub(crate) size: usize,
}

/// Assigns registers to the coordinates first, then to the roots, then to numbers, then to intermediate results.
///
/// A root that is `None` gets a register that no instruction changes.
pub(crate) fn allocate(
    graph: &Graph,
    selected: &[Instruction<Id>],
    roots: &[Option<Id>],
    inputs: usize,
) -> Result<Allocation, Problem> {
    let mut registers = HashMap::new();
    let (mut numbers, mut copies) = (Vec::new(), Vec::new());
    for (place, root) in (inputs..).zip(roots) {
        match root.map(|root| (root, graph.node(root), registers.get(&root))) {
            None => {}
            Some((_, Node::Input(from), _)) | Some((_, _, Some(&from))) => {
                copies.push((Operation::Copy, place, [from; 3]));
            }
            Some((root, ..)) => drop(registers.insert(root, place)),
        }
    }
    let mut count = inputs + roots.len();
    for id in selected.iter().flat_map(|instruction| instruction.operands) {
        match graph.node(id) {
            Node::Input(i) => drop(registers.insert(id, i)),
            Node::Number(bits) if !registers.contains_key(&id) => {
                registers.insert(id, count);
                numbers.push((count, f64::from_bits(bits)));
                count += 1;
            }
            _ => {}
        }
    }
    let last = last_uses(selected, roots.iter().flatten());
    let first = count;
    let (mut free, mut placed) = (Vec::new(), Vec::new());
    for (n, instruction) in selected.iter().enumerate() {
        let operands = instruction.operands.map(|id| registers.get(&id).copied().unwrap_or(0));
        for (id, register) in instruction.operands.into_iter().zip(operands) {
            if last.get(&id) == Some(&n) && register >= first && !free.contains(&register) {
                free.push(register);
            }
        }
        let target = *registers.entry(instruction.target).or_insert_with(|| {
            free.pop().unwrap_or_else(|| {
                count += 1;
                count - 1
            })
        });
        placed.push((instruction.operation, target, operands));
    }
    placed.extend(copies);
    let limit = SIZES[SIZES.len() - 1];
    let Some(size) = SIZES.into_iter().find(|&size| count <= size) else {
        return Err(Problem::TooLarge { needed: count, limit });
    };
    let short = |register: usize| u16::try_from(register).unwrap_or(u16::MAX);
    let instructions = placed.into_iter().map(|(operation, target, operands)| Instruction {
        operation,
        target: short(target),
        operands: operands.map(short),
    });
    let numbers = numbers.into_iter().map(|(register, number)| (short(register), number));
    Ok(Allocation { instructions: instructions.collect(), numbers: numbers.collect(), size })
}

/// Returns the last instruction that uses each node, except for the roots, which are needed to the end.
fn last_uses<'a>(
    selected: &[Instruction<Id>],
    roots: impl Iterator<Item = &'a Id>,
) -> HashMap<Id, usize> {
    let mut last = HashMap::new();
    for (n, instruction) in selected.iter().enumerate() {
        last.extend(instruction.operands.map(|id| (id, n)));
    }
    for root in roots {
        last.remove(root);
    }
    last
}
