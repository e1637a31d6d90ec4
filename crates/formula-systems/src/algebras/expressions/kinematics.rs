//! Algebras of kinematics: Heisenberg's, Galilei's with and without a mass, and Poincaré's.

use super::matrices::pairs;
use super::part::Part;
use crate::algebras::family::Family;
use lie_poisson_formulas::{Coordinates, NameError, StructureEntry};

/// Brackets of basis vectors, collected one by one.
#[derive(Default)]
struct Brackets(Vec<StructureEntry>);

impl Brackets {
    /// Adds [e_i, e_j] = value e_k.
    fn add(&mut self, i: usize, j: usize, k: usize, value: f64) {
        self.0.push(StructureEntry { i, j, k, value });
    }

    /// Adds the brackets by which rotations with this first index turn the vector with another first index.
    fn turn(&mut self, rotations: usize, vector: usize) {
        for (i, j, k) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
            self.add(rotations + i, vector + j, vector + k, 1.0);
            if rotations != vector {
                self.add(rotations + j, vector + i, vector + k, -1.0);
            }
        }
    }

    fn part(self, coordinates: Coordinates) -> Part {
        let (acts, family, summands) = (None, Family::Other, Vec::new());
        Part { coordinates, constants: self.0, acts, family, summands }
    }
}

/// Returns the abelian algebra Rⁿ.
pub(super) fn abelian(n: usize) -> Result<Part, NameError> {
    Ok(Brackets::default().part(Coordinates::new().vector("p", n)?))
}

/// Returns Heisenberg's algebra of n degrees of freedom: [q_i, p_i] = z.
pub(super) fn heisenberg(n: usize) -> Result<Part, NameError> {
    let mut brackets = Brackets::default();
    (0..n).for_each(|i| brackets.add(i, n + i, 2 * n, 1.0));
    let coordinates = match n {
        1 => Coordinates::scalars(["q", "p", "z"])?,
        _ => Coordinates::new().vector("q", n)?.vector("p", n)?.scalar("z")?,
    };
    Ok(brackets.part(coordinates))
}

/// Returns Galilei's algebra of rotations J, boosts K, translations P and H, with [K_i, H] = P_i; with a mass M it is
/// Bargmann's, with [K_i, P_j] = δ_ij M.
pub(super) fn galilei(has_mass: bool) -> Result<Part, NameError> {
    let mut brackets = Brackets::default();
    [0, 3, 6].into_iter().for_each(|vector| brackets.turn(0, vector));
    for i in 0..3 {
        brackets.add(3 + i, 9, 6 + i, 1.0);
        if has_mass {
            brackets.add(3 + i, 6 + i, 10, 1.0);
        }
    }
    let vectors = Coordinates::new().vector("J", 3)?.vector("K", 3)?.vector("P", 3)?.scalar("H")?;
    Ok(brackets.part(if has_mass { vectors.scalar("M")? } else { vectors }))
}

/// Returns Poincaré's algebra of space dimension 1, 2 or 3, with the velocity of light 1: rotations J, boosts K,
/// translations P and H, with [K_i, H] = P_i, [K_i, P_j] = δ_ij H and [K₁, K₂] = −J₃.
pub(super) fn poincare(n: usize) -> Result<Part, NameError> {
    let rotations = n * (n - 1) / 2;
    let (k, p) = (rotations, rotations + n);
    let h = p + n;
    let mut brackets = Brackets::default();
    for i in 0..n {
        brackets.add(k + i, h, p + i, 1.0);
        brackets.add(k + i, p + i, h, 1.0);
    }
    let coordinates = match n {
        1 => return Ok(brackets.part(Coordinates::scalars(["K", "P", "H"])?)),
        2 => {
            for vector in [k, p] {
                brackets.add(0, vector, vector + 1, 1.0);
                brackets.add(0, vector + 1, vector, -1.0);
            }
            brackets.add(k, k + 1, 0, -1.0);
            Coordinates::new().scalar("J")?
        }
        _ => {
            [0, k, p].into_iter().for_each(|vector| brackets.turn(0, vector));
            for (i, j) in pairs(3) {
                let other = 3 - i - j;
                let sign = if j == i + 1 { -1.0 } else { 1.0 };
                brackets.add(k + i, k + j, other, sign);
            }
            Coordinates::new().vector("J", 3)?
        }
    };
    Ok(brackets.part(coordinates.vector("K", n)?.vector("P", n)?.scalar("H")?))
}
