//! Image data of VTK, for ParaView: one file for each time, and a collection of them.
//!
//! Source: *VTK File Formats*, the sections on XML formats. The first index along x is the fastest in the file.

use super::ovf::{bytes_in_order, cells};
use std::io::{self, Write};

/// The comment after the first line of every file.
pub(crate) const COMMENT: &str = "<!-- heavytop -->";

/// Writes a field of numbers or vectors on the cells of a lattice.
pub(crate) fn write(
    to: &mut impl Write,
    (name, time): (&str, f64),
    shape: &[usize],
    numbers: &[f64],
) -> io::Result<()> {
    let Some(([nx, ny, nz], components)) = cells(shape) else { return Ok(()) };
    let bytes = 8 * nx * ny * nz * components;
    write!(
        to,
        "<?xml version=\"1.0\"?>\n{COMMENT}\n\
         <VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n\
         <ImageData WholeExtent=\"0 {nx} 0 {ny} 0 {nz}\" Origin=\"0 0 0\" Spacing=\"1 1 1\">\n\
         <FieldData><DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{time:?}</DataArray></FieldData>\n\
         <Piece Extent=\"0 {nx} 0 {ny} 0 {nz}\">\n\
         <CellData Vectors=\"{name}\"><DataArray type=\"Float64\" Name=\"{name}\" NumberOfComponents=\"{components}\" \
         format=\"appended\" offset=\"0\"/></CellData>\n\
         </Piece>\n</ImageData>\n<AppendedData encoding=\"raw\">\n_"
    )?;
    to.write_all(&(bytes as u64).to_le_bytes())?;
    to.write_all(&bytes_in_order([nx, ny, nz], components, numbers))?;
    to.write_all(b"\n</AppendedData>\n</VTKFile>\n")
}

/// Returns the collection of files, each with its time.
pub(crate) fn collection(files: &[(f64, String)]) -> String {
    let entry = |(time, file): &(f64, String)| {
        format!("<DataSet timestep=\"{time:?}\" part=\"0\" file=\"{file}\"/>\n")
    };
    format!(
        "<?xml version=\"1.0\"?>\n{COMMENT}\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n\
         <Collection>\n{}</Collection>\n</VTKFile>\n",
        files.iter().map(entry).collect::<String>()
    )
}
