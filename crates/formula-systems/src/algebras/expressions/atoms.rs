//! The algebras that have names of their own: [`atom`].

use super::kinematics::{abelian, galilei, heisenberg, poincare};
use super::matrices::{
    general_linear, orthogonal, plane_rotations, rotations, special_linear, special_linear_two,
    special_unitary, symplectic,
};
use super::part::Part;
use crate::algebras::family::{Family, MOST_DIMENSIONS};
use crate::error::FormulaSystemError;
use lie_poisson_formulas::NameError;

/// A number or the letter R in the parentheses after a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Argument {
    Number(usize),
    Reals,
}

use Argument::{Number, Reals};

/// Returns the algebra of a name and its arguments, or `None` if there is none.
pub(super) fn atom(name: &str, arguments: &[Argument]) -> Option<Result<Part, FormulaSystemError>> {
    // An algebra with too many dimensions is refused before it is computed.
    let small = |dimension: usize, make: &dyn Fn() -> Result<Part, NameError>| {
        let most = MOST_DIMENSIONS;
        match (1..=most).contains(&dimension) {
            true => make().map_err(FormulaSystemError::Coordinates),
            false => Err(FormulaSystemError::Dimension { count: dimension, most }),
        }
    };
    let square = |n: usize| n.saturating_mul(n);
    let rotation = |n: usize| n.saturating_mul(n.saturating_sub(1)) / 2;
    Some(match (name, arguments) {
        ("so", &[Number(2)]) => small(1, &plane_rotations),
        ("so", &[Number(3)]) => small(3, &rotations),
        ("so", &[Number(n)]) => small(rotation(n), &|| orthogonal(n, 0)),
        ("so", &[Number(p), Number(q)]) => {
            small(rotation(p.saturating_add(q)), &|| orthogonal(p, q))
        }
        ("se", &[Number(n)]) => {
            return match atom("so", arguments)? {
                Ok(rotations) => euclidean(rotations, n),
                Err(error) => Some(Err(error)),
            };
        }
        ("su", &[Number(2)]) => {
            small(3, &|| special_unitary(2).map(|part| Part { family: Family::Rotations, ..part }))
        }
        ("su", &[Number(n)]) => small(square(n).saturating_sub(1), &|| special_unitary(n)),
        ("sl", &[Number(2)] | &[Number(2), Reals]) => small(3, &special_linear_two),
        ("sl", &[Number(n)] | &[Number(n), Reals]) => {
            small(square(n).saturating_sub(1), &|| special_linear(n))
        }
        ("gl", &[Number(n)] | &[Number(n), Reals]) => small(square(n), &|| general_linear(n)),
        ("sp", &[Number(n)] | &[Number(n), Reals]) if n.is_multiple_of(2) => {
            small((n / 2).saturating_mul(n.saturating_add(1)), &|| symplectic(n / 2))
        }
        ("heisenberg", &[Number(n)]) if n > 0 => {
            small(n.saturating_mul(2).saturating_add(1), &|| heisenberg(n))
        }
        ("galilei", &[]) => small(10, &|| galilei(false)),
        ("bargmann", &[]) => small(11, &|| galilei(true)),
        ("poincare", &[Number(1), Number(n @ 1..=3)]) => small(10, &|| poincare(n)),
        ("R", &[Number(n)]) => small(n, &|| abelian(n)),
        _ => return None,
    })
}

/// Returns the rotations with the translations of their space; those of three dimensions have a family of their own.
fn euclidean(rotations: Part, n: usize) -> Option<Result<Part, FormulaSystemError>> {
    let family = if n == 3 { Family::Motions } else { Family::Other };
    Some(rotations.acting(1)?.map(|part| Part { family, ..part }))
}

/// The forms of all names, for messages.
pub(super) const FORMS: [&str; 13] = [
    "so(n)",
    "so(p,q)",
    "se(n)",
    "su(n)",
    "sl(n,R)",
    "gl(n)",
    "sp(2n,R)",
    "heisenberg(n)",
    "galilei",
    "bargmann",
    "poincare(1,n)",
    "Rn",
    "and sums, powers and semidirect products of these",
];
