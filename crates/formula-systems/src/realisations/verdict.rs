//! Whether quadratic momenta make a Poisson map, and a collective integrator: [`Verdict`].

use super::generic_point::generic;
use super::odd_powers::{ROUNDING, odd_powers, unit};
use super::quadratic_momenta::{QuadraticMomenta, wrong};
use crate::error::FormulaSystemError;
use lie_poisson::StructureTable;
use lie_poisson_formulas::Coordinates;
use nalgebra::DMatrix;

/// What [quadratic momenta](QuadraticMomenta) obey.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Verdict {
    /// Whether the bracket of 𝔤∗ for which they are a Poisson map is the plus bracket: {J_a, J_b} = Σ c_abk J_k. If not, it
    /// is the minus bracket.
    pub is_plus: bool,
    /// The largest deviation from these relations, relative to the sizes of the two momenta and of their bracket.
    pub defect: f64,
    /// The rank of z ↦ J(z) at a generic point. The momenta reach an open part of 𝔤∗ if it is the dimension of 𝔤.
    pub rank: usize,
    /// The largest distance of the cube of a generic matrix 𝕁S_ξ from these matrices, relative to its size. If it is rounding,
    /// steps of symplectic Runge–Kutta methods descend to 𝔤∗, where they are Poisson maps.
    pub odd_powers: f64,
}

impl Verdict {
    /// Returns whether steps descend to 𝔤∗, so that they conserve all Casimirs.
    #[must_use]
    pub fn descends(&self) -> bool {
        self.odd_powers < ROUNDING
    }
}

impl QuadraticMomenta {
    /// Returns what the momenta obey, for an algebra with names for the coordinates of its dual.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::Realisation`] if there are not as many momenta as coordinates of 𝔤∗, or if they are a
    /// Poisson map for neither bracket; the message names the pair for which it fails most, and says if another unit of the
    /// momenta would do.
    pub fn verdict(
        &self,
        algebra: &StructureTable,
        coordinates: &Coordinates,
    ) -> Result<Verdict, FormulaSystemError> {
        let (found, expected) = (self.count(), algebra.dimension());
        if found != expected {
            return Err(wrong(format!(
                "there are {found} matrices for an algebra of dimension {expected}"
            )));
        }
        let brackets = self.brackets();
        let [plus, minus] = [1.0, -1.0].map(|factor| self.fault(algebra, &brackets, factor));
        let (is_plus, fault) =
            if plus.defect <= minus.defect { (true, plus) } else { (false, minus) };
        if fault.defect > ROUNDING {
            let names: Vec<String> = coordinates.names().collect();
            return Err(wrong(self.lesson(algebra, &names, (&brackets, &fault))));
        }
        Ok(Verdict {
            is_plus,
            defect: fault.defect,
            rank: self.rank(),
            odd_powers: self.odd_powers(),
        })
    }

    /// Returns the momenta of the fewest copies of a representation that reach an open part of 𝔤∗, and what they obey, if
    /// steps along them descend. `None` if there are no such momenta.
    pub(crate) fn reaching(matrices: &[DMatrix<f64>]) -> Option<(Self, Verdict)> {
        let (one, size) = (Self::of_representation(matrices).ok()?, matrices.first()?.nrows());
        let odd_powers = one.odd_powers();
        if odd_powers >= ROUNDING {
            return None;
        }
        // All symmetric forms, as of sp(2n, R): a copy has one positive and one negative square, so that as many copies as rows
        // have every signature.
        let is_symmetric = matrices.len() == size * (size + 1) / 2;
        (if is_symmetric { size } else { 1 }..=size).find_map(|copies| {
            let momenta = Self::of_copies(matrices, copies).ok()?;
            let rank = momenta.rank();
            // The momenta p·ρ q of a representation are a Poisson map to the plus bracket.
            let verdict = Verdict { is_plus: true, defect: 0.0, rank, odd_powers };
            (rank == matrices.len()).then_some((momenta, verdict))
        })
    }

    /// Returns the matrices of {J_a, J_b} for a < b: S_a 𝕁 S_b − S_b 𝕁 S_a.
    fn brackets(&self) -> Vec<Bracket> {
        let forms = self.forms();
        let turned: Vec<DMatrix<f64>> = forms.iter().map(turned).collect();
        let pairs = (0..self.count()).flat_map(|b| (0..b).map(move |a| (a, b)));
        pairs.map(|(a, b)| (a, b, &forms[a] * &turned[b] - &forms[b] * &turned[a])).collect()
    }

    /// Returns the worst deviation of the brackets from the structure constants times a factor.
    fn fault(&self, algebra: &StructureTable, brackets: &[Bracket], factor: f64) -> Fault {
        let forms = self.forms();
        let expected = |a: usize, b: usize| {
            let zero = DMatrix::zeros(self.size(), self.size());
            (0..self.count()).fold(zero, |sum, k| match algebra.constant(a, b, k) {
                0.0 => sum,
                c => sum + &forms[k] * (c * factor),
            })
        };
        // Each pair has a size of its own, so that the units of the momenta do not matter.
        let faults = brackets.iter().map(|(a, b, found)| {
            let expected = expected(*a, *b);
            let size = forms[*a].amax() * forms[*b].amax();
            let size = size.max(found.amax()).max(expected.amax());
            let defect = match size {
                0.0 => 0.0,
                size => (found - expected).amax() / size,
            };
            // What overflows is no relation that holds.
            Fault { pair: (*a, *b), defect: if defect.is_nan() { f64::INFINITY } else { defect } }
        });
        let none = Fault { pair: (0, 0), defect: 0.0 };
        faults.fold(none, |worst, fault| if fault.defect > worst.defect { fault } else { worst })
    }

    /// Says for which pair the relations fail, and whether they hold in another unit of the momenta.
    fn lesson(
        &self,
        algebra: &StructureTable,
        names: &[String],
        (brackets, fault): (&[Bracket], &Fault),
    ) -> String {
        let ((a, b), name) = (fault.pair, |i: usize| names.get(i).cloned().unwrap_or_default());
        let constants = (0..self.count()).map(|k| (k, algebra.constant(a, b, k)));
        let terms: Vec<String> =
            constants.filter(|(_, c)| *c != 0.0).map(|(k, c)| format!("{c} {}", name(k))).collect();
        let sum = if terms.is_empty() { "0".into() } else { terms.join(" + ") };
        let (first, second) = (name(a), name(b));
        let problem = format!(
            "the momenta are no Poisson map: {{{first}, {second}}} is neither {sum} nor the negative of it, but differs by \
             {:.1e} of the size of the brackets",
            fault.defect
        );
        // {J_a, J_b} = λ Σ c J for one number λ, found by least squares.
        let forms = self.forms();
        let expected = |a: usize, b: usize| {
            let terms = (0..self.count()).map(|k| &forms[k] * algebra.constant(a, b, k));
            terms.fold(DMatrix::zeros(self.size(), self.size()), |sum, term| sum + term)
        };
        let pairs = brackets.iter().map(|(a, b, found)| (expected(*a, *b), found));
        let [over, under] = pairs.fold([0.0, 0.0], |[x, y], (expected, found)| {
            [x + expected.dot(found), y + expected.dot(&expected)]
        });
        let factor = over / under;
        match factor.is_finite()
            && factor != 0.0
            && self.fault(algebra, brackets, factor).defect < ROUNDING
        {
            true => format!(
                "{problem}. All brackets are {factor:.6} times what they should be: divide the matrices by {factor:.6}"
            ),
            false => problem,
        }
    }

    /// Returns the rank of dJ at a generic point.
    pub(crate) fn rank(&self) -> usize {
        let z = generic(self.size(), 1);
        // Rows of the length 1, so that the units of the momenta do not matter.
        let rows = self.rows(&z);
        let mut columns = rows.transpose();
        columns
            .column_iter_mut()
            .for_each(|mut column| column.copy_from(&unit(column.clone_owned())));
        // The diagonal entries of R with the largest columns first decrease as the singular values do, and cost less.
        let r = columns.col_piv_qr().unpack_r();
        let diagonal: Vec<f64> = (0..r.nrows().min(r.ncols())).map(|i| r[(i, i)].abs()).collect();
        let largest = diagonal.first().copied().unwrap_or(0.0);
        diagonal.iter().filter(|entry| **entry > 1e-9 * largest).count()
    }

    /// Returns the largest distance of the cube of a generic matrix 𝕁S_ξ from these matrices, relative to its size.
    pub(crate) fn odd_powers(&self) -> f64 {
        odd_powers(&self.forms().iter().map(turned).collect::<Vec<_>>())
    }
}

/// The indices of two momenta, and the matrix of their bracket.
type Bracket = (usize, usize, DMatrix<f64>);

/// A pair of momenta, and how far their bracket is from what it must be.
struct Fault {
    pair: (usize, usize),
    defect: f64,
}

/// Returns 𝕁S: the rows of p, then the negative of the rows of q.
fn turned(form: &DMatrix<f64>) -> DMatrix<f64> {
    let m = form.nrows() / 2;
    DMatrix::from_fn(2 * m, 2 * m, |i, j| if i < m { form[(m + i, j)] } else { -form[(i - m, j)] })
}
