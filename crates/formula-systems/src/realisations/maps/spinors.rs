//! The momenta of spinors, for rotations and rigid motions.

use crate::realisations::quadratic_momenta::{QuadraticMomenta, Term};

/// The terms of ζ†σ_a ζ/4, by the real and imaginary parts (x₁, x₂, y₁, y₂) of a spinor ζ.
const SPINOR: [Term; 8] = [
    (0, 0, 1, 0.5),
    (0, 2, 3, 0.5),
    (1, 0, 3, 0.5),
    (1, 1, 2, -0.5),
    (2, 0, 0, 0.25),
    (2, 2, 2, 0.25),
    (2, 1, 1, -0.25),
    (2, 3, 3, -0.25),
];

/// The entries (a, row, column, value) of ζ ↦ −(i/2)σ_a ζ as real matrices of (x₁, x₂, y₁, y₂).
const TURN: [Term; 12] = [
    (0, 0, 3, 0.5),
    (0, 1, 2, 0.5),
    (0, 2, 1, -0.5),
    (0, 3, 0, -0.5),
    (1, 0, 1, -0.5),
    (1, 1, 0, 0.5),
    (1, 2, 3, -0.5),
    (1, 3, 2, 0.5),
    (2, 0, 2, 0.5),
    (2, 1, 3, -0.5),
    (2, 2, 0, -0.5),
    (2, 3, 1, 0.5),
];

impl QuadraticMomenta {
    /// Returns the momenta J_a = ζ†σ_a ζ/4 of so many spinors ζ = q + ip, on so many copies of so(3)∗: the Hopf map, up to the units
    /// of ζ.
    pub(crate) fn of_rotations(count: usize) -> Self {
        let freedoms = 2 * count;
        let place = |spin: usize, i: usize| 2 * spin + i % 2 + if i < 2 { 0 } else { freedoms };
        let terms = (0..count).flat_map(|spin| {
            let moved =
                move |(a, i, j, value)| (3 * spin + a, place(spin, i), place(spin, j), value);
            SPINOR.into_iter().map(moved)
        });
        Self::of_terms(3 * count, freedoms, terms.collect())
    }

    /// Returns the momenta of se(3)∗ on T∗C²: Π_a = p·(−(i/2)σ_a q) and Γ_a = q†σ_a q/4.
    ///
    /// Source: Ohsawa 2019, §3.2, up to the units of q.
    pub(crate) fn of_motions() -> Self {
        let turns = TURN.into_iter().map(|(a, i, j, value)| (a, j, i + 4, value));
        let verticals = SPINOR.into_iter().map(|(a, i, j, value)| (a + 3, i, j, value));
        Self::of_terms(6, 4, turns.chain(verticals).collect())
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use crate::algebras::system_algebra::SystemAlgebra;
    use crate::realisations::verdict::Verdict;

    #[test]
    fn they_are_poisson_maps_that_reach_all_orbits_and_whose_steps_descend() {
        for name in ["so(3)", "su(2)", "se(3)", "so(3)^3", "so(3) + su(2)"] {
            let algebra = SystemAlgebra::named(name).unwrap();
            let momenta = algebra.spinors().unwrap();
            let verdict = momenta.verdict(algebra.table(), algebra.coordinates()).unwrap();
            let Verdict { is_plus, defect, rank, odd_powers } = verdict;
            assert!(is_plus && defect == 0.0 && rank == algebra.dimension(), "{name}: {verdict:?}");
            assert!(odd_powers < 1e-14, "{name}: {verdict:?}");
        }
        assert_eq!(SystemAlgebra::named("so(4)").unwrap().spinors(), None);
    }

    #[test]
    fn every_momentum_has_a_lift() {
        let states: [(&str, &[&[f64]]); 2] = [
            ("so(3)", &[&[0.0, 0.0, 1.0], &[0.0, 0.0, -1.0], &[1.0, 0.0, 0.0], &[1e-9, 0.0, -1.0]]),
            (
                "se(3)",
                &[
                    &[0.0, 0.0, 5.0, 0.0, 0.0, 1.0],
                    &[0.0, 0.0, 5.0, 0.0, 0.0, -1.0],
                    &[1.0, 2.0, 3.0, 1.0, 0.0, 0.0],
                    &[0.0, 0.0, 0.0, 0.6, 0.0, 0.8],
                    &[300.0, -20.0, 1e-3, 0.6, 0.0, -0.8],
                ],
            ),
        ];
        for (name, states) in states {
            let algebra = SystemAlgebra::named(name).unwrap();
            let momenta = algebra.spinors().unwrap();
            for state in states {
                for scale in [1e-30, 1.0, 1e30] {
                    let mu: Vec<f64> = state.iter().map(|x| x * scale).collect();
                    let z = momenta.lift(&mu).unwrap();
                    let mut values = vec![0.0; mu.len()];
                    momenta.values(&z, &mut values);
                    let size = mu.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
                    let error =
                        values.iter().zip(&mu).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
                    assert!(error < 1e-14 * size, "{name} {mu:?}: {values:?}");
                }
            }
        }
    }
}
