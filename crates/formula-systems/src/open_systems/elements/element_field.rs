//! The element of an open system as a field and as a noise: [`ElementField`].

use crate::open_systems::open_system::OpenSystem;
use crate::open_systems::open_terms::{NoiseFields, NoiseTerms};
use collective_integrators::NoiseRule;
use lie_poisson::{LieAlgebra, LiePoisson, Momentum, Noise, OrbitField, Real, State, Vector};
use smallvec::SmallVec;

/// The largest dimension of an algebra whose multipliers are known: that of se(3).
const MOST: usize = 6;

/// The coordinates, the time and so many inputs need no allocation.
const MOST_NAMES: usize = 16;

/// The drift of an open system, and its noise, on the dual of so(3) or se(3) with the minus bracket.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct ElementField {
    system: OpenSystem,
    /// 1, or −1 for the plus bracket: the minus bracket makes the same motion along −ξ.
    sign: f64,
    /// Whether a term is a formula that may name the time or inputs.
    has_inputs: bool,
}

impl ElementField {
    pub(super) fn new(system: OpenSystem) -> Self {
        let sign = if system.base().has_plus_bracket() { -1.0 } else { 1.0 };
        let terms = system.terms();
        let noise = terms.noise.as_ref().map(|noise| &noise.fields);
        let has_inputs = terms.hamiltonian.is_some()
            || terms.drive.is_some()
            || matches!(noise, Some(NoiseFields::Formulas(_)));
        Self { system, sign, has_inputs }
    }

    /// Returns the fields of the noise.
    fn noise(&self) -> Option<&NoiseFields> {
        self.system.terms().noise.as_ref().map(|noise| &noise.fields)
    }

    /// Returns the element of a part of a step: how much of the drift, and the weights of the noise.
    fn sum<A: LieAlgebra, T: Real>(
        &self,
        mu: &Momentum<A, T>,
        time: T,
        part: (f64, &[T]),
    ) -> A::Element<T> {
        let dimension = A::Element::<f64>::DIM;
        let at = |i: usize| if i < dimension { mu.coordinate(i) } else { T::zero() };
        let numbers: [T; MOST] = core::array::from_fn(at);
        let numbers = numbers.get(..dimension).unwrap_or_default();
        let mut with_inputs: SmallVec<[T; MOST_NAMES]> = SmallVec::new();
        if self.has_inputs {
            with_inputs.extend_from_slice(numbers);
            self.system.terms().inputs.append(time, &mut with_inputs);
        }
        let x = if self.has_inputs { &with_inputs } else { numbers };
        let mut vectors = [[T::zero(); MOST]; 3];
        let vectors_of = vectors.each_mut().map(|v| v.get_mut(..dimension).unwrap_or_default());
        self.system.write_element(part, x, vectors_of);
        let [xi, ..] = vectors;
        Vector::from_coordinates(|i| xi[i] * self.sign)
    }
}

impl<A: LieAlgebra, T: Real> OrbitField<LiePoisson<A>, T> for ElementField {
    fn element(&self, mu: &Momentum<A, T>, time: T) -> A::Element<T> {
        self.sum::<A, T>(mu, time, (1.0, &[]))
    }

    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        self.system.next_break(time, forward)
    }
}

impl<A: LieAlgebra, T: Real> Noise<LiePoisson<A>, T> for ElementField {
    fn count(&self) -> usize {
        self.noise().map_or(0, |noise| noise.count(A::Element::<f64>::DIM))
    }

    fn element(&self, mu: &Momentum<A, T>, time: T, weights: &[T]) -> A::Element<T> {
        self.sum::<A, T>(mu, time, (0.0, weights))
    }

    fn is_constant(&self) -> bool {
        // The noise of Gilbert's damping depends on the lengths of spins: flows keep them, and the middle of a step does not.
        self.system.terms().noise.as_ref().is_some_and(|NoiseTerms { fields, rule, .. }| {
            let follows =
                *rule == NoiseRule::Together && matches!(fields, NoiseFields::OfSpins { .. });
            !follows && fields.are_constant(A::Element::<f64>::DIM)
        })
    }
}
