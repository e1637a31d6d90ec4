//! Numbers in tables of fonts, which are big-endian.

/// A part of a font. What lies outside of it is `None`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bytes(pub(crate) &'static [u8]);

impl Bytes {
    /// Returns the bytes from a place on.
    pub(crate) fn from(self, start: usize) -> Option<Self> {
        self.0.get(start..).map(Self)
    }

    /// Returns so many bytes from a place on.
    pub(crate) fn part(self, start: usize, length: usize) -> Option<Self> {
        self.0.get(start..start.checked_add(length)?).map(Self)
    }

    pub(crate) fn u8(self, at: usize) -> Option<u8> {
        self.0.get(at).copied()
    }

    pub(crate) fn u16(self, at: usize) -> Option<u16> {
        self.number(at).map(u16::from_be_bytes)
    }

    pub(crate) fn i16(self, at: usize) -> Option<i16> {
        self.number(at).map(i16::from_be_bytes)
    }

    pub(crate) fn u32(self, at: usize) -> Option<u32> {
        self.number(at).map(u32::from_be_bytes)
    }

    fn number<const N: usize>(self, at: usize) -> Option<[u8; N]> {
        self.0.get(at..)?.first_chunk().copied()
    }

    /// Returns the place of the record with this key, among records of `size` bytes that are sorted by their keys.
    pub(crate) fn search(
        self,
        size: usize,
        compare: impl Fn(Self) -> Option<std::cmp::Ordering>,
    ) -> Option<Self> {
        let (mut low, mut high) = (0, self.0.len() / size);
        while low < high {
            let middle = low.midpoint(high);
            let record = self.part(middle * size, size)?;
            match compare(record)? {
                std::cmp::Ordering::Less => low = middle + 1,
                std::cmp::Ordering::Greater => high = middle,
                std::cmp::Ordering::Equal => return Some(record),
            }
        }
        None
    }
}
