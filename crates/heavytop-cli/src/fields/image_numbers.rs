//! The numbers of an array in image data of VTK, in all ways in which they may be written without compression: [`Numbers`].

use crate::errors::FieldFileError;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::read::ZlibDecoder;
use roxmltree::Node;
use std::io::Read;

/// How the numbers of an array are written.
pub(super) struct Numbers {
    is_double: bool,
    is_little: bool,
    is_compressed: bool,
    /// The bytes of a count before the numbers.
    header: usize,
}

/// The compression that is read here, the usual one.
const ZLIB: &str = "vtkZLibDataCompressor";

impl Numbers {
    pub(super) fn of(file: &Node<'_, '_>, array: &Node<'_, '_>) -> Result<Self, FieldFileError> {
        let is_double = match array.attribute("type") {
            Some("Float64") => true,
            Some("Float32") => false,
            other => {
                let found = other.unwrap_or("none");
                return Err(wrong(&format!("its numbers are {found}, not Float64 or Float32")));
            }
        };
        let compressor = file.attribute("compressor");
        if let Some(other) = compressor.filter(|other| *other != ZLIB) {
            return Err(wrong(&format!("it is compressed by {other}, not by {ZLIB}")));
        }
        let is_little = file.attribute("byte_order") != Some("BigEndian");
        let header = if file.attribute("header_type") == Some("UInt64") { 8 } else { 4 };
        Ok(Self { is_double, is_little, is_compressed: compressor.is_some(), header })
    }

    /// Returns the numbers of an array, which may be in the element of appended numbers.
    pub(super) fn read(
        &self,
        array: &Node<'_, '_>,
        appended: &[u8],
    ) -> Result<Vec<f64>, FieldFileError> {
        let text = array.text().unwrap_or_default();
        match array.attribute("format") {
            Some("appended") => {
                let offset = array.attribute("offset").and_then(|offset| offset.parse().ok());
                self.appended(appended, offset.unwrap_or(0))
            }
            Some("binary") => self.base64(text.trim().as_bytes()),
            _ => {
                let numbers = text.split_whitespace().map(|word| word.parse().ok());
                let numbers: Option<Vec<f64>> = numbers.collect();
                let finite = numbers.filter(|numbers| numbers.iter().all(|x| x.is_finite()));
                finite.ok_or_else(|| wrong("a number cannot be read or is not finite"))
            }
        }
    }

    fn appended(&self, element: &[u8], offset: usize) -> Result<Vec<f64>, FieldFileError> {
        let begin = element.iter().position(|byte| *byte == b'>').unwrap_or(element.len());
        let tag = String::from_utf8_lossy(&element[..begin]).into_owned();
        let rest = &element[begin..];
        let mark = rest.iter().position(|byte| *byte == b'_');
        let data = mark.and_then(|mark| rest.get((mark + 1).checked_add(offset)?..));
        let data = data.ok_or_else(|| wrong("its appended numbers are missing"))?;
        match tag.contains("base64") {
            true => {
                let is_letter = |byte: &u8| byte.is_ascii_alphanumeric() || b"+/=".contains(byte);
                let end = data.iter().position(|byte| !is_letter(byte)).unwrap_or(data.len());
                self.base64(&data[..end])
            }
            false => self.raw(data),
        }
    }

    /// Reads numbers in Base64. The counts before them are encoded by themselves, as VTK does it, or with them.
    fn base64(&self, text: &[u8]) -> Result<Vec<f64>, FieldFileError> {
        let letters = |bytes: usize| bytes.div_ceil(3).checked_mul(4);
        let read = || {
            let first = STANDARD.decode(text.get(..letters(self.header)?)?).ok()?;
            let counts = self.counts(self.count(&first, 0)?)?;
            let alone = letters(counts)?;
            let is_alone = text.get(..alone)?.ends_with(b"=") || counts.is_multiple_of(3);
            let head = STANDARD.decode(text.get(..alone)?).ok()?;
            let data = self.data(&head)?;
            let (start, length) =
                if is_alone { (alone, data) } else { (0, data.checked_add(counts)?) };
            let end = letters(length)?.checked_add(start)?;
            let own = STANDARD.decode(text.get(start..end)?).ok()?;
            Some(if is_alone { [head, own].concat() } else { own })
        };
        let bytes = read().ok_or_else(|| wrong("its numbers are no Base64"))?;
        self.raw(&bytes)
    }

    /// Returns the number of bytes of all counts, of which the first is this.
    fn counts(&self, first: usize) -> Option<usize> {
        match self.is_compressed {
            // The number of blocks, the bytes of a block and of the last one, and what each is compressed to.
            true => first.checked_add(3)?.checked_mul(self.header),
            false => Some(self.header),
        }
    }

    /// Returns the number of bytes after the counts.
    fn data(&self, bytes: &[u8]) -> Option<usize> {
        let first = self.count(bytes, 0)?;
        match self.is_compressed {
            true => {
                (0..first).try_fold(0_usize, |sum, i| sum.checked_add(self.count(bytes, 3 + i)?))
            }
            false => Some(first),
        }
    }

    /// Returns the count with this number.
    fn count(&self, bytes: &[u8], number: usize) -> Option<usize> {
        let start = number.checked_mul(self.header)?;
        let own = bytes.get(start..start.checked_add(self.header)?)?;
        let mut count = [0; 8];
        match self.is_little {
            true => count[..self.header].copy_from_slice(own),
            false => own.iter().rev().zip(&mut count).for_each(|(byte, to)| *to = *byte),
        }
        usize::try_from(u64::from_le_bytes(count)).ok()
    }

    /// Reads numbers after the counts of their bytes.
    fn raw(&self, bytes: &[u8]) -> Result<Vec<f64>, FieldFileError> {
        let counts = self.count(bytes, 0).and_then(|first| self.counts(first));
        let data = counts.and_then(|counts| {
            let end = counts.checked_add(self.data(bytes)?)?;
            bytes.get(counts..end)
        });
        let data = data.ok_or_else(|| wrong("it has fewer numbers than it says"))?;
        match self.is_compressed {
            true => self.numbers(&self.inflated(bytes, data)?),
            false => self.numbers(data),
        }
    }

    /// Returns the bytes of compressed blocks.
    fn inflated(&self, bytes: &[u8], mut data: &[u8]) -> Result<Vec<u8>, FieldFileError> {
        let broken = || wrong("its numbers cannot be decompressed");
        let [blocks, size, last] = [0, 1, 2].map(|i| self.count(bytes, i).unwrap_or(0));
        let mut all = Vec::new();
        for block in 0..blocks {
            let length = self.count(bytes, 3 + block).ok_or_else(broken)?;
            let (own, rest) = data.split_at_checked(length).ok_or_else(broken)?;
            let expected = if block + 1 == blocks && last > 0 { last } else { size };
            let before = all.len();
            // A block that unfolds to more than it says is cut.
            let most = (expected as u64).saturating_add(1);
            ZlibDecoder::new(own).take(most).read_to_end(&mut all).map_err(|_| broken())?;
            if all.len() - before != expected {
                return Err(broken());
            }
            data = rest;
        }
        Ok(all)
    }

    fn numbers(&self, numbers: &[u8]) -> Result<Vec<f64>, FieldFileError> {
        let read: Vec<f64> = match (self.is_double, self.is_little) {
            (true, true) => numbers.as_chunks().0.iter().map(|x| f64::from_le_bytes(*x)).collect(),
            (true, false) => numbers.as_chunks().0.iter().map(|x| f64::from_be_bytes(*x)).collect(),
            (false, true) => {
                numbers.as_chunks().0.iter().map(|x| f32::from_le_bytes(*x).into()).collect()
            }
            (false, false) => {
                numbers.as_chunks().0.iter().map(|x| f32::from_be_bytes(*x).into()).collect()
            }
        };
        match read.iter().all(|x| x.is_finite()) {
            true => Ok(read),
            false => Err(wrong("a number is not finite")),
        }
    }
}

fn wrong(text: &str) -> FieldFileError {
    FieldFileError::Format(text.into())
}
