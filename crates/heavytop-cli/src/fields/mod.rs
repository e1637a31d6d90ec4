//! Files of fields, such as the spins of a lattice: archives of NumPy's, OVF, and image data of VTK.

pub(crate) mod field_file;
pub(crate) mod archive;
pub(crate) mod ovf;
pub(crate) mod image_data;
mod image_numbers;
mod image_reader;
