//! The element of the algebra with which the momentum of an open system moves.

use crate::open_systems::open_system::OpenSystem;
use crate::open_systems::open_terms::{Damping, NoiseFields};
use crate::open_systems::spin_terms::{damp_spins, shake_spins};
use lie_poisson::Real;
use lie_poisson_formulas::Formula;

impl OpenSystem {
    /// Writes the element ξ of the algebra with which the momentum moves, a (dh + u + θ (Λ dh)♯) + Σ_k w_k σ_k with a = 0 or 1, without
    /// the torque. The point is the momentum, and behind it the time and the inputs if a term names them. The other two vectors are
    /// overwritten; all three are as long as the momentum.
    pub(in crate::open_systems) fn write_element<T: Real>(
        &self,
        (drift, weights): (f64, &[T]),
        x: &[T],
        [xi, rate, element]: [&mut [T]; 3],
    ) {
        let (base, terms, dimension) = (self.base(), self.terms(), xi.len());
        xi.fill(T::zero());
        if drift != 0.0 {
            let mut write = |slopes: &[T]| xi.iter_mut().zip(slopes).for_each(|(xi, s)| *xi = *s);
            match &terms.hamiltonian {
                Some(hamiltonian) => hamiltonian.with_differential(x.len(), |i| x[i], &mut write),
                None => base.hamiltonian().with_differential(dimension, |i| x[i], &mut write),
            }
            if let Some(drive) = &terms.drive {
                add(drive, x, T::one(), xi);
            }
            if let Some(damping) = &terms.damping {
                self.write_coadjoint(xi, x, rate);
                match damping {
                    Damping::Gilbert(damping) => damp_spins(*damping, x, rate, xi),
                    Damping::DoubleBracket { friction, inner_product } => {
                        inner_product.write_sharp(rate, element);
                        let pairs = xi.iter_mut().zip(element.iter());
                        pairs.for_each(|(xi, sharp)| *xi += *sharp * *friction);
                    }
                }
            }
        }
        match terms.noise.as_ref().map(|noise| &noise.fields) {
            Some(_) if weights.is_empty() => {}
            Some(NoiseFields::Isotropic(noise)) => {
                noise.inner_product.write_orthonormal(weights, element);
                let pairs = xi.iter_mut().zip(element.iter());
                pairs.for_each(|(xi, sigma)| *xi += *sigma * noise.strength);
            }
            Some(NoiseFields::OfSpins { damping, temperature }) => {
                shake_spins(*damping, *temperature, (x, weights), xi);
            }
            Some(NoiseFields::Formulas(fields)) => {
                let fields = fields.iter().zip(weights);
                fields.for_each(|(field, weight)| add(field, x, *weight, xi));
            }
            None => {}
        }
    }

    /// Writes Λ(μ) ξ.
    pub(in crate::open_systems) fn write_coadjoint<T: Real>(
        &self,
        xi: &[T],
        mu: &[T],
        rate: &mut [T],
    ) {
        self.base().algebra().table().coadjoint(xi, mu, rate);
        if self.base().has_plus_bracket() {
            rate.iter_mut().for_each(|rate| *rate = -*rate);
        }
    }
}

/// Adds the values of formulas, times a weight, to an element.
pub(in crate::open_systems) fn add<T: Real>(
    formulas: &[Formula],
    x: &[T],
    weight: T,
    element: &mut [T],
) {
    for (formula, element) in formulas.iter().zip(element) {
        *element += formula.value_of(x.len(), |i| x[i]) * weight;
    }
}
