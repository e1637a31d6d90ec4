//! Isospectral equations as a vector field: [`CommutatorField`].

use crate::fields::isospectral_field::IsospectralField;
use crate::matrices::products::Products;
use crate::matrices::skew_hermitian::LargeSkewHermitian;
use collective_integrators::{StoragePool, VectorField};
use lie_poisson::State;

/// The vector field [B(W), W] of an isospectral equation, for schemes that are applied to it directly.
///
/// Explicit Runge–Kutta methods applied to it conserve the spectrum to their accuracy only. They are a comparison, and
/// cheap where a short run is asked for. The field is NaN at a matrix of another size, so that a step from it fails
/// with [`NotFinite`](collective_integrators::StepError::NotFinite).
///
/// # Example
/// See [`GaussMagnus`](crate::GaussMagnus).
#[derive(Clone, Debug, PartialEq)]
pub struct CommutatorField<F> {
    field: F,
    /// The generator and the storage of products.
    storage: StoragePool<(Option<LargeSkewHermitian>, Products)>,
}

impl<F: IsospectralField> CommutatorField<F> {
    /// Creates the vector field of an equation.
    pub fn new(field: F) -> Self {
        Self { field, storage: StoragePool::default() }
    }
}

impl<F: IsospectralField> VectorField for CommutatorField<F> {
    type Point = LargeSkewHermitian;

    fn at(&self, w: &LargeSkewHermitian) -> LargeSkewHermitian {
        let mut rate = w.zeros_like();
        self.at_into(w, &mut rate);
        rate
    }

    fn at_into(&self, w: &LargeSkewHermitian, rate: &mut LargeSkewHermitian) {
        if w.size() != self.field.size() {
            return rate.scale_in_place(f64::NAN);
        }
        self.storage.with(|(generator, products)| {
            let generator = generator.get_or_insert_with(|| w.zeros_like());
            self.field.generator_into(w, generator);
            products.commutator(generator, w, rate);
        });
    }
}
