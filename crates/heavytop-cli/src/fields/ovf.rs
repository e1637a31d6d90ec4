//! The vector field format of OOMMF, which micromagnetic tools share.
//!
//! Source: M. J. Donahue & D. G. Porter, *OOMMF User's Guide*, NISTIR 6376, appendix "File formats: vector field (OVF)",
//! version 2.0. The first index along x is the fastest in the file; it is the slowest in an array of shape (n_x, n_y, n_z, 3).

use crate::errors::FieldFileError;
use std::fs::File;
use std::io::{self, BufRead, BufReader, Read, Write};
use std::path::Path;

/// The number by which a reader knows the order of the bytes.
const CHECK: f64 = 123_456_789_012_345.0;
const SHORT_CHECK: f32 = 1_234_567.0;

/// The most bytes of a header line.
const LINE: u64 = 1 << 12;

/// The beginning of the title of every file that the program writes.
pub(crate) const TITLE: &str = "# Title: heavytop, ";

/// Returns the numbers of cells along x, y and z of an array of vectors with this shape, and the components of each.
pub(super) fn cells(shape: &[usize]) -> Option<([usize; 3], usize)> {
    let (components, cells) = shape.split_last()?;
    let mut all = [1; 3];
    all.get_mut(..cells.len())?.copy_from_slice(cells);
    Some((all, *components))
}

/// Returns the place in an array of the cells in the order of the file.
pub(super) fn in_order([nx, ny, nz]: [usize; 3]) -> impl Iterator<Item = usize> {
    let along_x = move |(z, y)| (0..nx).map(move |x| (x * ny + y) * nz + z);
    (0..nz).flat_map(move |z| (0..ny).map(move |y| (z, y))).flat_map(along_x)
}

/// Returns the bytes of the vectors of an array in the order of the file, the lowest byte of each number first.
pub(super) fn bytes_in_order(cells: [usize; 3], components: usize, numbers: &[f64]) -> Vec<u8> {
    let vector = |cell: usize| numbers.get(cell * components..(cell + 1) * components);
    let vectors = in_order(cells).filter_map(vector);
    vectors.flatten().flat_map(|x| x.to_le_bytes()).collect()
}

/// Writes a field of vectors at a time.
pub(crate) fn write(
    to: &mut impl Write,
    (name, time): (&str, f64),
    shape: &[usize],
    numbers: &[f64],
) -> io::Result<()> {
    let Some(([nx, ny, nz], components)) = cells(shape) else { return Ok(()) };
    let labels: Vec<String> = (1..=components).map(|i| format!("{name}_{i}")).collect();
    write!(
        to,
        "# OOMMF OVF 2.0\n# Segment count: 1\n# Begin: Segment\n# Begin: Header\n{TITLE}{name}\n\
         # Desc: Total simulation time: {time} s\n# meshtype: rectangular\n# meshunit: 1\n\
         # xmin: 0\n# ymin: 0\n# zmin: 0\n# xmax: {nx}\n# ymax: {ny}\n# zmax: {nz}\n\
         # valuedim: {components}\n# valuelabels: {}\n# valueunits:{}\n\
         # xbase: 0.5\n# ybase: 0.5\n# zbase: 0.5\n# xnodes: {nx}\n# ynodes: {ny}\n# znodes: {nz}\n\
         # xstepsize: 1\n# ystepsize: 1\n# zstepsize: 1\n# End: Header\n# Begin: Data Binary 8\n",
        labels.join(" "),
        " 1".repeat(components),
    )?;
    to.write_all(&CHECK.to_le_bytes())?;
    to.write_all(&bytes_in_order([nx, ny, nz], components, numbers))?;
    to.write_all(b"\n# End: Data Binary 8\n# End: Segment\n")
}

/// Reads the field of vectors in a file as an array of this name and shape.
pub(super) fn read(path: &Path, name: &str, shape: &[usize]) -> Result<Vec<f64>, FieldFileError> {
    let wrong =
        |what: &str| FieldFileError::Format(format!("it is no OVF file of version 2: {what}"));
    let mut file = BufReader::with_capacity(1 << 20, File::open(path)?);
    let (mut nodes, mut components) = ([0_usize; 3], 0_usize);
    let mut first = true;
    let encoding = loop {
        let mut line = Vec::new();
        if file.by_ref().take(LINE).read_until(b'\n', &mut line)? == 0 {
            return Err(wrong("it has no data"));
        }
        let line = String::from_utf8_lossy(&line).to_ascii_lowercase();
        let text = line.trim_start_matches('#').trim();
        if std::mem::take(&mut first)
            && text.split_whitespace().collect::<Vec<_>>() != ["oommf", "ovf", "2.0"]
        {
            return Err(wrong("its first line is not `# OOMMF OVF 2.0`"));
        }
        let (key, value) =
            text.split_once(':').map_or((text, ""), |(key, value)| (key, value.trim()));
        let number = || value.parse().map_err(|_| wrong(&format!("{key} is {value}")));
        match key {
            "xnodes" => nodes[0] = number()?,
            "ynodes" => nodes[1] = number()?,
            "znodes" => nodes[2] = number()?,
            "valuedim" => components = number()?,
            "begin" if value.starts_with("data") => {
                break value.trim_start_matches("data").trim().to_owned();
            }
            _ => {}
        }
    };
    let found = [&nodes[..], &[components]].concat();
    if cells(shape) != Some((nodes, components)) {
        return Err(FieldFileError::Shape { name: name.into(), expected: shape.to_vec(), found });
    }
    let count: usize = shape.iter().product();
    let values = match encoding.as_str() {
        "binary 8" => {
            let mut bytes = vec![0; 8 * (count + 1)];
            file.read_exact(&mut bytes)?;
            let mut numbers = bytes.as_chunks().0.iter().map(|eight| f64::from_le_bytes(*eight));
            if numbers.next() != Some(CHECK) {
                return Err(wrong("its bytes have another order"));
            }
            numbers.collect()
        }
        "binary 4" => {
            let mut bytes = vec![0; 4 * (count + 1)];
            file.read_exact(&mut bytes)?;
            let mut numbers = bytes.as_chunks().0.iter().map(|four| f32::from_le_bytes(*four));
            if numbers.next() != Some(SHORT_CHECK) {
                return Err(wrong("its bytes have another order"));
            }
            numbers.map(f64::from).collect()
        }
        "text" => text_numbers(file, count).map_err(|what| wrong(&what))?,
        other => return Err(wrong(&format!("its data are {other}"))),
    };
    let values: Vec<f64> = values;
    let mut array = vec![0.0; count];
    for (cell, vector) in in_order(nodes).zip(values.chunks(components.max(1))) {
        array[cell * components..(cell + 1) * components].copy_from_slice(vector);
    }
    Ok(array)
}

/// Reads so many numbers of a text.
fn text_numbers(file: impl BufRead, count: usize) -> Result<Vec<f64>, String> {
    let mut numbers = Vec::new();
    for line in file.lines() {
        let line = line.map_err(|error| error.to_string())?;
        for word in line.split_whitespace().take_while(|word| !word.starts_with('#')) {
            numbers.push(word.parse().map_err(|_| format!("`{word}` is no number"))?);
        }
        if numbers.len() >= count || line.starts_with("# End") {
            break;
        }
    }
    match numbers.len() == count {
        true => Ok(numbers),
        false => Err(format!("it has {} numbers, not {count}", numbers.len())),
    }
}
