//! Registers for the nodes of a graph: a register is used again when its value is no longer needed.

use super::instruction::Instruction;
use crate::graphs::graph::{Graph, Id, Node};
use crate::text::formula_error::Problem;
use std::collections::HashMap;

/// The largest number of registers, and the sizes of the arrays that hold them.
pub(crate) const SIZES: [usize; 4] = [16, 64, 256, 1024];

/// The instructions on registers, with what is in the registers before the first of them.
pub(crate) struct Allocation {
    pub(crate) instructions: Vec<Instruction<u16>>,
    /// The numbers in all registers, of which there are as many as one of [`SIZES`]; zero for those that hold none.
    pub(crate) numbers: Vec<f64>,
    /// The register of each root.
    pub(crate) outputs: Vec<u16>,
}

/// Assigns registers: those of the coordinates first, then numbers, then results.
pub(crate) fn allocate(
    graph: &Graph,
    selected: &[Instruction<Id>],
    roots: &[Id],
    inputs: usize,
) -> Result<Allocation, Problem> {
    let mut registers = HashMap::new();
    let mut numbers = vec![0.0; inputs];
    let operands = selected.iter().flat_map(|instruction| instruction.operands);
    for id in operands.chain(roots.iter().copied()) {
        match graph.node(id) {
            Node::Input(i) => {
                registers.insert(id, i);
            }
            Node::Number(bits) if !registers.contains_key(&id) => {
                registers.insert(id, numbers.len());
                numbers.push(f64::from_bits(bits));
            }
            _ => {}
        }
    }
    let last = last_uses(selected, roots);
    let (first, mut count) = (numbers.len(), numbers.len());
    let (mut free, mut placed) = (Vec::new(), Vec::new());
    for (n, instruction) in selected.iter().enumerate() {
        let operands = instruction.operands.map(|id| registers.get(&id).copied().unwrap_or(0));
        for (id, register) in instruction.operands.into_iter().zip(operands) {
            if last.get(&id) == Some(&n) && register >= first && !free.contains(&register) {
                free.push(register);
            }
        }
        let target = free.pop().unwrap_or_else(|| {
            count += 1;
            count - 1
        });
        registers.insert(instruction.target, target);
        placed.push((instruction.operation, target, operands));
    }
    let limit = SIZES[SIZES.len() - 1];
    let Some(size) = SIZES.into_iter().find(|&size| count <= size) else {
        return Err(Problem::TooLarge { needed: count, limit });
    };
    numbers.resize(size, 0.0);
    let short = |register: usize| u16::try_from(register).unwrap_or(u16::MAX);
    let instructions = placed.into_iter().map(|(operation, target, operands)| Instruction {
        operation,
        target: short(target),
        operands: operands.map(short),
    });
    let outputs = roots.iter().map(|id| short(registers.get(id).copied().unwrap_or(0)));
    Ok(Allocation { instructions: instructions.collect(), numbers, outputs: outputs.collect() })
}

/// Returns the last instruction that uses each node, except for the roots, which are needed to the end.
fn last_uses(selected: &[Instruction<Id>], roots: &[Id]) -> HashMap<Id, usize> {
    let mut last = HashMap::new();
    for (n, instruction) in selected.iter().enumerate() {
        last.extend(instruction.operands.map(|id| (id, n)));
    }
    for root in roots {
        last.remove(root);
    }
    last
}
