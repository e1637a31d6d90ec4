//! Archives of NumPy's, whose arrays are read: [`Archive`].
//!
//! Source: NumPy Enhancement Proposal 1, *A simple file format for NumPy arrays*.

use crate::errors::FieldFileError;
use std::fs::File;
use std::io::{self, BufReader, Read};
use std::path::Path;
use zip::ZipArchive;

/// An archive of arrays.
pub(crate) struct Archive {
    zip: ZipArchive<BufReader<File>>,
    /// The length of the file.
    length: u64,
}

/// The header of an array.
#[derive(Debug, PartialEq)]
pub(crate) struct Header {
    /// The bytes of a number, 8 or 4.
    width: usize,
    /// The shape, whose last index is the fastest.
    pub(crate) shape: Vec<usize>,
    /// The length of the header itself, in bytes.
    length: usize,
}

/// The largest size of a header, in bytes.
const MOST_HEADER: usize = 1 << 16;

/// The largest factor by which arrays can be compressed, that of zeros.
const MOST_COMPRESSION: u64 = 1100;

impl Archive {
    /// Opens an archive.
    ///
    /// # Errors
    /// If the file cannot be read, or is no archive.
    pub(crate) fn open(path: &Path) -> Result<Self, FieldFileError> {
        Self::open_ahead(path, 1 << 20)
    }

    /// Opens an archive of which so many bytes are read ahead.
    ///
    /// # Errors
    /// If the file cannot be read, or is no archive.
    pub(crate) fn open_ahead(path: &Path, bytes: usize) -> Result<Self, FieldFileError> {
        let file = File::open(path)?;
        let length = file.metadata()?.len();
        let archive = ZipArchive::new(BufReader::with_capacity(bytes, file));
        archive
            .map(|zip| Self { zip, length })
            // What the reader of the format says helps nobody.
            .map_err(|_| FieldFileError::Format("it is no archive of arrays, a file .npz".into()))
    }

    /// Returns the names of the arrays.
    pub(crate) fn names(&self) -> Vec<String> {
        let names = self.zip.file_names().filter_map(Result::ok);
        let mut names: Vec<String> =
            names.filter_map(|name| name.strip_suffix(".npy").map(String::from)).collect();
        names.sort();
        names
    }

    /// Returns the header of an array, and what reads its numbers.
    ///
    /// # Errors
    /// If there is none, or its numbers cannot be read here.
    pub(crate) fn array(&mut self, name: &str) -> Result<(Header, impl Read + '_), FieldFileError> {
        let has = self.names();
        if !has.iter().any(|other| other == name) {
            return Err(FieldFileError::NoArray { kind: "array", name: name.into(), has });
        }
        let length = self.length;
        let mut file = self.zip.by_name(&format!("{name}.npy")).map_err(|error| {
            let text = format!("{name} cannot be read: {error}");
            FieldFileError::Format(text)
        })?;
        let header = Header::read(name, &mut file)?;
        // A size that a header invents takes no memory.
        if file.size() / MOST_COMPRESSION > length || header.bytes() != Some(file.size()) {
            let text = format!("{name} has not as many numbers as its header says");
            return Err(FieldFileError::Format(text));
        }
        Ok((header, file))
    }

    /// Returns all numbers of an array.
    ///
    /// # Errors
    /// If there is no such array.
    pub(crate) fn numbers(&mut self, name: &str) -> Result<Vec<f64>, FieldFileError> {
        let (header, mut file) = self.array(name)?;
        let mut numbers = vec![0.0; header.shape.iter().product()];
        header.fill(&mut file, &mut numbers)?;
        ended(&mut file)?;
        Ok(numbers)
    }

    /// Returns the text of an array that is one, if there is one of this name.
    pub(crate) fn text(&mut self, name: &str) -> Option<String> {
        let mut file = self.zip.by_name(&format!("{name}.npy")).ok()?;
        let mut bytes = Vec::new();
        (&mut file).take(1 << 24).read_to_end(&mut bytes).ok()?;
        let length = usize::from(u16::from_le_bytes([*bytes.get(8)?, *bytes.get(9)?]));
        let characters = bytes.get(10 + length..)?.as_chunks::<4>().0.iter();
        characters.map(|four| char::from_u32(u32::from_le_bytes(*four))).collect()
    }

    /// Returns the numbers of an array, or of its last sample.
    ///
    /// # Errors
    /// If there is no such array.
    pub(crate) fn last(&mut self, name: &str, shape: &[usize]) -> Result<Vec<f64>, FieldFileError> {
        let (header, mut file) = self.array(name)?;
        header.last(&mut file, name, shape)
    }
}

/// Returns the numbers of an array that `numpy.save` has written to a file of its own, or of its last sample.
///
/// # Errors
/// If it cannot be read, or has another shape.
pub(super) fn last_of_array(
    path: &Path,
    name: &str,
    shape: &[usize],
) -> Result<Vec<f64>, FieldFileError> {
    let file = File::open(path)?;
    let length = file.metadata()?.len();
    let mut file = BufReader::with_capacity(1 << 20, file);
    let header = Header::read(name, &mut file)?;
    if header.bytes() != Some(length) {
        return Err(FieldFileError::Format("it has not as many numbers as its header says".into()));
    }
    header.last(&mut file, name, shape)
}

/// Reads on to the end, where an archive checks its sums.
fn ended(file: &mut impl Read) -> io::Result<()> {
    file.read(&mut [0; 1]).map(drop)
}

impl Header {
    fn read(name: &str, file: &mut impl Read) -> Result<Self, FieldFileError> {
        let unreadable = || {
            FieldFileError::Format(format!(
                "{name} is no array of 64-bit or 32-bit numbers in the order of C, which \
                 numpy.ascontiguousarray(x, float) gives"
            ))
        };
        let mut prefix = [0; 8];
        file.read_exact(&mut prefix)?;
        let (before, length) = match prefix {
            [0x93, b'N', b'U', b'M', b'P', b'Y', 1, _] => {
                let mut length = [0; 2];
                file.read_exact(&mut length)?;
                (10, usize::from(u16::from_le_bytes(length)))
            }
            [0x93, b'N', b'U', b'M', b'P', b'Y', 2 | 3, _] => {
                let mut length = [0; 4];
                file.read_exact(&mut length)?;
                (12, u32::from_le_bytes(length) as usize)
            }
            _ => return Err(unreadable()),
        };
        if length > MOST_HEADER {
            return Err(unreadable());
        }
        let mut text = vec![0; length];
        file.read_exact(&mut text)?;
        let header = Self::parse(&String::from_utf8_lossy(&text)).ok_or_else(unreadable)?;
        Ok(Self { length: before + length, ..header })
    }

    /// Returns the number of bytes of the array and of its header; `None` if no file has so many.
    fn bytes(&self) -> Option<u64> {
        let mut counts = self.shape.iter().map(|count| *count as u64);
        let count = counts.try_fold(1_u64, u64::checked_mul)?;
        count.checked_mul(self.width as u64)?.checked_add(self.length as u64)
    }

    /// Reads a header such as `{'descr': '<f8', 'fortran_order': False, 'shape': (3, 4), }`.
    fn parse(text: &str) -> Option<Self> {
        let after = |key: &str| Some(text.split_once(&format!("'{key}':"))?.1.trim_start());
        let width = match after("descr")?.get(..5)? {
            "'<f8'" => 8,
            "'<f4'" => 4,
            _ => return None,
        };
        let shape = after("shape")?.strip_prefix('(')?.split_once(')')?.0;
        let shape = shape.split(',').map(str::trim).filter(|count| !count.is_empty());
        let shape: Option<Vec<usize>> = shape.map(|count| count.parse().ok()).collect();
        let shape = shape?;
        // A single index has one order.
        let is_c = after("fortran_order")?.starts_with("False") || shape.len() < 2;
        is_c.then_some(Self { width, shape, length: 0 })
    }

    /// Reads the numbers of the array, or of its last sample.
    fn last(
        &self,
        file: &mut impl Read,
        name: &str,
        shape: &[usize],
    ) -> Result<Vec<f64>, FieldFileError> {
        let samples = match self.shape.split_first() {
            _ if self.shape == shape => 1,
            Some((samples, rest)) if rest == shape && *samples > 0 => *samples,
            _ => {
                let (name, expected, found) = (name.into(), shape.to_vec(), self.shape.clone());
                return Err(FieldFileError::Shape { name, expected, found });
            }
        };
        let count: usize = shape.iter().product();
        let before = ((samples - 1) * count * self.width) as u64;
        io::copy(&mut file.take(before), &mut io::sink())?;
        let mut numbers = vec![0.0; count];
        self.fill(file, &mut numbers)?;
        ended(file)?;
        Ok(numbers)
    }

    /// Reads the next numbers.
    pub(crate) fn fill(&self, file: &mut impl Read, numbers: &mut [f64]) -> io::Result<()> {
        let mut bytes = vec![0; numbers.len() * self.width];
        file.read_exact(&mut bytes)?;
        match self.width {
            8 => {
                let read = bytes.as_chunks().0.iter().map(|eight| f64::from_le_bytes(*eight));
                numbers.iter_mut().zip(read).for_each(|(number, read)| *number = read);
            }
            _ => {
                let read = bytes.as_chunks().0.iter().map(|four| f32::from_le_bytes(*four).into());
                numbers.iter_mut().zip(read).for_each(|(number, read)| *number = read);
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headers_of_numbers_in_the_order_of_c_are_read() {
        let of = |descr: &str, fortran: &str, shape: &str| {
            Header::parse(&format!(
                "{{'descr': '{descr}', 'fortran_order': {fortran}, 'shape': {shape}, }}  \n"
            ))
        };
        let header =
            |width, shape: &[usize]| Some(Header { width, shape: shape.to_vec(), length: 0 });
        assert_eq!(of("<f8", "False", "(3, 4)"), header(8, &[3, 4]));
        assert_eq!(of("<f4", "False", "(5,)"), header(4, &[5]));
        assert_eq!(of("<f8", "False", "()"), header(8, &[]));
        assert_eq!(of("<f8", "True", "(5,)"), header(8, &[5]));
        for (descr, fortran, shape) in [
            ("<f8", "True", "(3, 4)"),
            (">f8", "False", "(3,)"),
            ("<i8", "False", "(3,)"),
            ("<f8", "False", "(3, x)"),
        ] {
            assert_eq!(of(descr, fortran, shape), None, "{descr} {fortran} {shape}");
        }
        let huge = of("<f8", "False", "(4294967296, 4294967296, 2)");
        assert_eq!(huge.map(|huge| huge.bytes()), Some(None));
    }
}
