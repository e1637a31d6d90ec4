//! The formulas of the invariants of a vector and a 2-form: [`WedgeFormulas`].

use super::motion_algebra::MotionAlgebra;
use super::wedge_product::WedgeProduct;
use crate::casimirs::matrices::expression_matrix::{scaled, sum};
use crate::casimirs::matrices::pfaffian::Pfaffians;
use lie_poisson_formulas::{Expression, Expressions, Formula, Vocabulary};

/// The largest number of products of a formula that is tried. Of those of so(n) ⋉ Rⁿ the largest that fits has 5500,
/// |Γ ∧ L²|² of n = 12, and the smallest that does not 8421, |Γ ∧ L⁴|² of n = 12.
const MOST_PRODUCTS: usize = 7000;

/// The forms Γ and L as expressions, with the minors that were needed.
///
/// The component of Γ ∧ L^∧k at indices I is k! times the Pfaffian of the rows and columns 0 and I of the matrix
/// [0 Γᵀ; −Γ L], whose rows count from 0.
pub(crate) struct WedgeFormulas<'a> {
    algebra: &'a MotionAlgebra,
    names: &'a Vocabulary,
    parts: Expressions,
    bordered: Pfaffians,
}

impl<'a> WedgeFormulas<'a> {
    pub(crate) fn new(algebra: &'a MotionAlgebra, names: &'a Vocabulary) -> Self {
        let mut parts = Expressions::new();
        let own = names.coordinates().names().skip(algebra.places().start);
        let own: Vec<Expression> =
            own.take(algebra.places().len()).map(|name| parts.name(&name)).collect();
        let n = algebra.size();
        let (rotations, vector) = own.split_at(algebra.rotations().len().min(own.len()));
        let bordered = Pfaffians::new(n + 1, |row, column| {
            let entry = match row.checked_sub(1) {
                None => vector.get(column - 1),
                // The pairs i < j come in their order: i (2n − i − 1)/2 of them have a smaller first index.
                Some(i) => rotations.get(i * (2 * n - i - 1) / 2 + column - row - 1),
            };
            entry.map(|entry| (1.0, *entry))
        });
        Self { algebra, names, parts, bordered }
    }

    /// Returns the formula of an invariant, or `None` if it is larger than a formula may be.
    pub(crate) fn formula(&mut self, product: WedgeProduct) -> Option<Formula> {
        let (n, k) = (self.algebra.size(), product.exponent());
        if products(n, k) > MOST_PRODUCTS {
            return None;
        }
        let factorial: f64 = (1..=k).map(|i| i as f64).product();
        let indices = (0..1_u32 << n).filter(|set| set.count_ones() as usize == 2 * k + 1);
        let mut terms = Vec::new();
        for set in indices {
            let Some(minor) = self.bordered.of(set << 1 | 1, &mut self.parts) else { continue };
            terms.push(match product {
                WedgeProduct::Top(_) => minor,
                WedgeProduct::Square(_) => {
                    let (sign, square) = (self.sign(set), self.parts.multiply(minor, minor));
                    scaled(&mut self.parts, sign, square)
                }
            });
        }
        let value = sum(&mut self.parts, terms)?;
        let factor = match product {
            WedgeProduct::Top(_) => factorial,
            WedgeProduct::Square(_) => factorial * factorial,
        };
        let value = scaled(&mut self.parts, factor, value);
        let formula = Formula::of_expressions(&self.parts, value, self.names).ok()?;
        Some(formula.printed_as(&self.text(product)))
    }

    /// Returns the text that says what an invariant is.
    pub(crate) fn text(&self, product: WedgeProduct) -> String {
        product.text(&self.vector_text(), &self.rotations_text())
    }

    /// Returns the product of the signs of the form at indices.
    fn sign(&self, set: u32) -> f64 {
        let own = self.algebra.form().iter().enumerate();
        own.filter(|(place, _)| set >> place & 1 == 1).map(|(_, sign)| sign).product()
    }

    /// Returns the name of the vector, which tells the summand.
    fn vector_text(&self) -> String {
        let start = self.algebra.vectors().start;
        let mut groups = self.names.coordinates().groups();
        let own = groups.find(|(_, group)| group.start == start);
        own.map_or_else(|| "Gamma".into(), |(name, _)| name.to_owned())
    }

    /// Returns the letters that the names of all L_ij begin with, or L if there are none.
    fn rotations_text(&self) -> String {
        let places = self.algebra.rotations();
        let names = self.names.coordinates().names().skip(places.start).take(places.len());
        let is_number = |c: char| c == '_' || c.is_ascii_digit();
        let mut letters: Vec<String> =
            names.map(|name| name.trim_end_matches(is_number).to_owned()).collect();
        letters.dedup();
        match <[String; 1]>::try_from(letters) {
            Ok([letters]) => letters,
            Err(_) => "L".into(),
        }
    }
}

/// Returns the number of products in the components of Γ ∧ L^∧k: of each of them one for each index, and of the minors of L one
/// for each index but the first. Those of 2j indices have none of the k − j first ones, along which others were expanded.
fn products(n: usize, k: usize) -> usize {
    let minors = (1..=k).map(|j| subsets((n + j).saturating_sub(k), 2 * j) * (2 * j - 1));
    minors.sum::<usize>() + subsets(n, 2 * k + 1) * (2 * k + 1)
}

/// Returns the number of subsets of so many of n elements.
fn subsets(n: usize, count: usize) -> usize {
    (0..count).fold(1, |all, i| all * n.saturating_sub(i) / (i + 1))
}

#[cfg(test)]
mod tests {
    use super::products;

    /// By hand for the components of Γ ∧ L and Γ ∧ L² in five dimensions, and for the bound.
    #[test]
    fn products_are_those_of_the_minors() {
        assert_eq!((products(5, 1), products(5, 2)), (10 + 30, 6 + 15 + 5));
        assert_eq!((products(12, 2), products(12, 4)), (5500, 8421));
    }
}
