//! Hamiltonians on the dual of any Lie algebra, written as text and differentiated symbolically, and Casimirs
//! computed from structure constants alone.
//!
//! ```toml
//! [dependencies]
//! lie-poisson = "0.1"
//! lie-poisson-formulas = "0.1"
//! ```
//!
//! The heavy top on se(3)∗: its energy as text, its equations of motion, and its Casimirs.
//!
//! ```
//! use lie_poisson::{Hamiltonian, LiePoisson, PoissonSpace, Se3, Se3Dual};
//! use lie_poisson_formulas::{FormulaHamiltonian, NamedAlgebra, Parameters, Vocabulary, find_casimirs};
//! use nalgebra::Vector3;
//!
//! let se3 = Se3::default();
//! let parameters = Parameters::new().vector("I", &[2.0, 2.0, 1.0])?.number("mgl", 1.0)?;
//! let names = Vocabulary::of(&se3, &parameters)?;
//! let h = FormulaHamiltonian::<Se3>::new("0.5*(Pi1^2/I1 + Pi2^2/I2 + Pi3^2/I3) + mgl*Gamma1", &names)?;
//!
//! let (pi, gamma) = (Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.0, 0.6, 0.8));
//! let mu = Se3Dual::new(pi, gamma);
//! let omega = Vector3::new(1.0, 1.5, 4.0); // I⁻¹Π
//! let rate = LiePoisson::minus(se3).hamiltonian_vector(&mu, &h.differential(&mu));
//! assert_eq!(rate, Se3Dual::new(pi.cross(&omega) + gamma.cross(&Vector3::x()), gamma.cross(&omega)));
//!
//! let casimirs = find_casimirs(&se3, &se3.coordinates()?)?;
//! let texts: Vec<String> = casimirs.formulas().iter().map(ToString::to_string).collect();
//! assert_eq!(texts, ["Pi·Gamma", "|Gamma|^2"]);
//! assert_eq!(casimirs.missing(), 0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # The language
//!
//! | to express | write |
//! |---|---|
//! | numbers | `2`, `0.5`, `6.02e23`, `½`, `pi` |
//! | a coordinate, a component of a vector | `Pi1`, `Pi[1]`, `Π₁`, `(Pi×Gamma)[3]` |
//! | the third of the vectors `S_1`, `S_2`, … | `S_3`, `S3`, `S[3]`; its second component is `S[3][2]` or `S_3_2` |
//! | sums and products | `+`, `-`, `*`, `/`; a product always needs a sign |
//! | powers, which bind most tightly and from right to left | `x^3`, `x**3`, `x²`, `2^3^2` = 2⁹, `-x^2` = −(x²) |
//! | products of vectors | `a·b` or `dot(a, b)`; `a×b` or `cross(a, b)`, which binds more tightly: `a·b×c` |
//! | a sum over an index, for all its values for which everything in brackets exists | `sum(S[i]·S[i+1])`; with several indices `sum(S[i]·S[j], i < j)`, `sum(S[i]·T[j], i, j)` |
//! | the length of a vector, the size of a number | <code>&#124;v&#124;</code>, `norm(v)`, `abs(x)` |
//! | functions | `sqrt` or `√`, `cbrt`, `exp`, `ln` or `log`, `log10`, `sin`, `cos`, `tan`, `arcsin`, `arccos`, `arctan` (or `asin`, `acos`, `atan`), `sinh`, `cosh`, `tanh`, `atan2(y, x)`, `hypot(x, y)` |
//! | different formulas in different places | `if(x >= 1, y, z)`, with `>=`, `>`, `<=` or `<`: y where x ≥ 1, and z elsewhere |
//!
//! A whole power is a product, x^(n+½) is xⁿ√x, and every other power is exp(c ln x). The slope of |x| at 0 is 1, and that
//! of |v|^p at v = 0 is 0 for p > 1; |v| itself has no slope there. Both values of `if` are computed, and one is chosen:
//! the value and all derivatives are those of the chosen formula, even where the other has none, and also on the seam,
//! where the condition holds or not as it says. Where a side of the condition is not a number, neither is the value. A
//! Hamiltonian should be continuous across a seam, and a method has its full order only if as many derivatives are, since
//! no step ends at a seam.
//! Names consist of letters, digits and underscores. A Greek letter stands for its name: `Γ₁` is `Gamma1`. Wherever
//! the formula is a real number, a simplification changes its value by rounding at most: 0·x becomes 0 only if x is a
//! real number for all real coordinates, as a polynomial is.
//!
//! # Which item when
//!
//! | when you need | use |
//! |---|---|
//! | a Hamiltonian from text, over every scalar | [`FormulaHamiltonian`] |
//! | a function from text with its derivatives | [`Formula`] |
//! | a formula that a program builds, without text | [`Expressions`] |
//! | the names of coordinates and parameters | [`Coordinates`] and [`Parameters`], combined in a [`Vocabulary`] |
//! | the usual names for an algebra | [`NamedAlgebra`] |
//! | the error in a text, and its place | [`FormulaError`], [`Problem`], [`Shape`]; for names [`NameError`] |
//! | the part of a formula that has no value at a state | [`Formula::checked_value`], [`ValueError`] |
//! | the Casimirs of an algebra of your own | [`find_casimirs`], [`PolynomialCasimirs`] |
//! | structure constants from the entries of a table | [`structure_constants`], [`StructureEntry`] |
//! | an algebra whose dimension is known only when the program runs | [`table_of_entries`], [`find_casimirs_of_table`] |
//!
//! # Cost
//!
//! An evaluation allocates nothing. The section "Against code by hand" of `docs/performance.md` in the source
//! repository compares the instructions of a step of RK4 with those for the same Hamiltonian in Rust.
//!
//! # Conventions
//!
//! * A formula is a function on 𝔤∗, in the coordinates of the basis dual to that of the algebra. Its differential is an
//!   element of 𝔤.
//! * In formulas, components of vectors count from 1. In tables of structure constants, indices count from 0.
//! * The structure constant of the indices i, j, k is the coordinate of [e_i, e_j] at e_k.
//! * Angles are in radians. Formulas have no units: the units of the parameters determine the unit of the result.
//! * The signs on 𝔤∗ are those of [`lie_poisson`].
//!
//! The notation of all the crates is collected in `docs/notation.md` of the source repository.
//!
//! # Features and versions
//!
//! The crate has no features. The oldest supported compiler is Rust 1.89.
//!
//! # Related crates
//!
//! [`lie_poisson`] holds the algebras, brackets and scalars, and `collective-integrators` holds the time steps.
//! `lie-poisson-formula-systems` builds systems from formulas and algebras that are known only when the program runs.
//! The program `heavytop` simulates them from a configuration file.

#![cfg_attr(docsrs, feature(doc_cfg))]

mod names;
mod text;
mod graphs;
mod tapes;
mod hamiltonians;
mod casimirs;

pub use names::coordinates::Coordinates;
pub use names::invisible::{invisible_name, shown};
pub use names::name_error::NameError;
pub use names::named_algebra::NamedAlgebra;
pub use names::parameters::Parameters;
pub use names::vocabulary::Vocabulary;
pub use text::formula_error::{FormulaError, Problem, Shape};
pub use text::names_in_text::names_in;
pub use text::suggestion::closest_name;

pub use text::expressions::{Expression, Expressions};

pub use hamiltonians::formula::Formula;
pub use hamiltonians::formula_hamiltonian::FormulaHamiltonian;
pub use hamiltonians::value_error::ValueError;

pub use casimirs::casimir_error::CasimirError;
pub use casimirs::polynomial::generic_point;
pub use casimirs::polynomial_casimirs::{
    PolynomialCasimirs, find_casimirs, find_casimirs_of_table,
};
pub use casimirs::structure_entries::{EntryError, structure_constants, table_of_entries};
pub use lie_poisson::StructureEntry;

/// Compiles and runs the examples of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
