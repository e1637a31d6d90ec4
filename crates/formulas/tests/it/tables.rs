//! Structure constants from the entries of a table.

use lie_poisson::{LieAlgebra, So3};
use lie_poisson_formulas::{EntryError, StructureEntry, structure_constants};
use nalgebra::Vector3;

fn entry(i: usize, j: usize, k: usize, value: f64) -> StructureEntry {
    StructureEntry { i, j, k, value }
}

#[test]
fn three_entries_are_so3() {
    let so3 = structure_constants::<3>(&[
        entry(0, 1, 2, 1.0),
        entry(1, 2, 0, 1.0),
        entry(2, 0, 1, 1.0),
        entry(0, 2, 1, -1.0), // says the same as the one before
    ]);
    let (xi, eta) = (Vector3::new(1.0, 2.0, 3.0), Vector3::new(-1.0, 0.5, 2.0));
    assert_eq!(so3.unwrap().bracket(&xi, &eta), So3.bracket(&xi, &eta));
}

#[test]
fn wrong_entries_are_named() {
    let error = |entries: &[StructureEntry]| structure_constants::<3>(entries).unwrap_err();
    let first = entry(0, 1, 2, 1.0);
    assert_eq!(
        error(&[first, entry(0, 3, 1, 1.0)]),
        EntryError::IndexTooLarge { entry: 1, index: 3, dimension: 3 }
    );
    assert_eq!(error(&[entry(1, 1, 0, 1.0)]), EntryError::WithItself { entry: 0, index: 1 });
    for second in [entry(0, 1, 2, 2.0), entry(1, 0, 2, 1.0)] {
        assert_eq!(error(&[first, second]), EntryError::Contradiction { entry: 1, earlier: 0 });
    }
    // [e₀, e₁] = e₂, [e₁, e₂] = e₂, [e₀, e₂] = e₁ violates the Jacobi identity
    let broken = [first, entry(1, 2, 2, 1.0), entry(0, 2, 1, 1.0)];
    assert!(matches!(error(&broken), EntryError::Structure(_)));
    assert!(matches!(error(&[entry(0, 1, 2, f64::NAN)]), EntryError::Structure(_)));
}
