//! The direct sum that the brackets of basis vectors show: [`summands`].

use crate::names::coordinates::Coordinates;
use lie_poisson::StructureEntry;

/// An ideal that is spanned by basis vectors and commutes with all others.
pub(crate) struct Summand {
    /// The names of the coordinates of the ideal.
    pub(crate) coordinates: Coordinates,
    /// The structure constants, whose indices are places in these coordinates.
    pub(crate) constants: Vec<StructureEntry>,
}

/// Returns the smallest ideals of basis vectors whose direct sum is the algebra, in the order of their first coordinates.
///
/// The Casimirs of a sum are functions of those of its summands, of which each is found apart: the monomials of two hundred
/// coordinates are too many.
pub(crate) fn summands(constants: &[StructureEntry], coordinates: &Coordinates) -> Vec<Summand> {
    let dimension = coordinates.dimension();
    // The least coordinate of the summand of each coordinate, as far as it is known.
    let mut least: Vec<usize> = (0..dimension).collect();
    loop {
        let before = least.clone();
        for entry in constants {
            let places = [entry.i, entry.j, entry.k];
            let first = places.iter().filter_map(|&place| least.get(place)).min().copied();
            for place in places {
                if let (Some(known), Some(first)) = (least.get_mut(place), first) {
                    *known = first;
                }
            }
        }
        if least == before {
            break;
        }
    }
    let firsts = (0..dimension).filter(|&i| least.get(i) == Some(&i));
    firsts.map(|first| summand(constants, coordinates, |i| least.get(i) == Some(&first))).collect()
}

fn summand(
    constants: &[StructureEntry],
    coordinates: &Coordinates,
    belongs: impl Fn(usize) -> bool,
) -> Summand {
    let places: Vec<usize> = (0..coordinates.dimension()).filter(|&i| belongs(i)).collect();
    let place = |i: usize| places.binary_search(&i).unwrap_or(0);
    let own = constants.iter().filter(|entry| belongs(entry.i));
    let own = own.map(|&StructureEntry { i, j, k, value }| {
        let [i, j, k] = [i, j, k].map(place);
        StructureEntry { i, j, k, value }
    });
    Summand { coordinates: coordinates.only(&belongs), constants: own.collect() }
}
