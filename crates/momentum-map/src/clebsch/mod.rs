//! Clebsch maps: realisations of 𝔤∗ on T∗V for any representation V of any Lie algebra, with lifts.

pub(crate) mod cotangent_representation;
pub(crate) mod clebsch_map;
mod equations;
mod search;
pub(crate) mod clebsch_section;
