//! The equations of a system of any dimension: [`TableField`].

use collective_integrators::{AnyState, VectorField};
use lie_poisson::{DualNumber, Real, State, StructureTable};
use lie_poisson_formulas::Formula;

/// The field dμ/dt = ad∗_ξ μ, ξ = dh(μ), on an algebra whose dimension is known only when the program runs.
pub(super) struct TableField {
    pub(super) table: StructureTable,
    pub(super) hamiltonian: Formula,
}

impl<T: Real> VectorField<T> for TableField {
    type Point = AnyState<T>;

    fn at(&self, mu: &AnyState<T>) -> AnyState<T> {
        let mut rate = mu.zeros_like();
        self.at_into(mu, &mut rate);
        rate
    }

    /// Writes the rate, or NaN for a point of another dimension.
    #[cfg_attr(optimised, inline(always))]
    fn at_into(&self, mu: &AnyState<T>, rate: &mut AnyState<T>) {
        let (mu, rate) = (mu.as_slice(), rate.as_mut_slice());
        self.hamiltonian.with_differential(
            mu.len(),
            |i| mu[i],
            #[cfg_attr(optimised, inline(always))]
            |xi| match xi.len() == rate.len() {
                true => self.table.coadjoint(xi, mu, rate),
                false => rate.fill(T::from_f64(f64::NAN)),
            },
        );
    }

    /// Returns `ad∗_η μ` + `ad∗_ξ v` with η = D²h(μ)·v, as the derivative of a product of dual numbers.
    fn derivative(&self, mu: &AnyState<T>, v: &AnyState<T>) -> Option<AnyState<T>> {
        let (at, along) = (mu.as_slice(), v.as_slice());
        let xi = self.hamiltonian.with_differential(at.len(), |i| at[i], <[T]>::to_vec);
        let eta = self.hamiltonian.with_second_derivative(at, along, <[T]>::to_vec);
        let moved = dual(at, along);
        let mut rate = moved.clone();
        self.table.coadjoint(&dual(&xi, &eta), &moved, &mut rate);
        let mut derivative = mu.zeros_like();
        derivative.set_coordinates(|i| rate[i].derivative());
        Some(derivative)
    }
}

/// Returns the dual numbers x + ε y.
fn dual<T: Real>(x: &[T], y: &[T]) -> Vec<DualNumber<T>> {
    x.iter().zip(y).map(|(x, y)| DualNumber::new(*x, *y)).collect()
}
