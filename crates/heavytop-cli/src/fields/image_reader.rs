//! The reader of image data of VTK, which ParaView and PyVista write.
//!
//! Source: *VTK File Formats*, the sections on XML formats. The first index along x is the fastest in the file.

use super::image_numbers::Numbers;
use super::ovf::{cells, in_order};
use crate::errors::FieldFileError;
use roxmltree::{Document, Node};
use std::path::Path;

/// Returns the numbers of an array on the cells or on the points of an image.
///
/// # Errors
/// If the file cannot be read, or has no such array of this shape.
pub(super) fn read(path: &Path, name: &str, shape: &[usize]) -> Result<Vec<f64>, FieldFileError> {
    let bytes = std::fs::read(path)?;
    let (text, appended) = parts(&bytes);
    let text = std::str::from_utf8(text).map_err(|error| wrong(&error.to_string()))?;
    // What is appended may be no text, and its element is left open.
    let whole = match appended.is_empty() {
        true => text.to_owned(),
        false => text.to_owned() + "</VTKFile>",
    };
    let document = Document::parse(&whole).map_err(|error| wrong(&error.to_string()))?;
    let file = document.root_element();
    if file.attribute("type") != Some("ImageData") {
        return Err(wrong("it is no image data of VTK"));
    }
    let array = array(&file, name)?;
    let (counts, components) = cells(shape).ok_or_else(|| wrong("it has vectors only"))?;
    let numbers = Numbers::of(&file, &array)?.read(&array, appended)?;
    let expected = shape.iter().product::<usize>();
    let found = [&extent(&array)?[..], &[components_of(&array)]].concat();
    if found != [&counts[..], &[components]].concat() || numbers.len() != expected {
        let (name, expected) = (name.into(), shape.to_vec());
        return Err(FieldFileError::Shape { name, expected, found });
    }
    let mut ordered = vec![0.0; expected];
    for (place, vector) in in_order(counts).zip(numbers.chunks_exact(components)) {
        if let Some(to) = ordered.get_mut(place * components..(place + 1) * components) {
            to.copy_from_slice(vector);
        }
    }
    Ok(ordered)
}

fn wrong(text: &str) -> FieldFileError {
    FieldFileError::Format(text.into())
}

/// Returns what stands before the element of appended numbers, and the element, if there is one.
fn parts(bytes: &[u8]) -> (&[u8], &[u8]) {
    const BEGIN: &[u8] = b"<AppendedData";
    let place = bytes.windows(BEGIN.len()).position(|window| window == BEGIN);
    bytes.split_at(place.unwrap_or(bytes.len()))
}

/// Returns the array of this name on cells or points.
fn array<'a>(file: &Node<'a, 'a>, name: &str) -> Result<Node<'a, 'a>, FieldFileError> {
    let on_mesh = |node: &Node<'_, '_>| {
        let parent = node.parent().map(|parent| parent.tag_name().name().to_owned());
        node.has_tag_name("DataArray")
            && matches!(parent.as_deref(), Some("CellData" | "PointData"))
    };
    let mut arrays = file.descendants().filter(on_mesh);
    arrays.clone().find(|array| array.attribute("Name") == Some(name)).ok_or_else(|| {
        let has = arrays.by_ref().filter_map(|array| array.attribute("Name").map(String::from));
        FieldFileError::NoArray { kind: "array", name: name.into(), has: has.collect() }
    })
}

fn components_of(array: &Node<'_, '_>) -> usize {
    array.attribute("NumberOfComponents").and_then(|count| count.parse().ok()).unwrap_or(1)
}

/// Returns the numbers of cells, or of points, along x, y and z.
fn extent(array: &Node<'_, '_>) -> Result<[usize; 3], FieldFileError> {
    let data = array.parent();
    let extra = i64::from(data.is_some_and(|data| data.has_tag_name("PointData")));
    let piece = data.and_then(|data| data.parent()).and_then(|piece| piece.attribute("Extent"));
    let ends = piece.unwrap_or_default().split_whitespace().map(|end| end.parse::<i64>().ok());
    let ends: Option<Vec<i64>> = ends.collect();
    match ends.as_deref() {
        Some(&[a, b, c, d, e, f]) => {
            let count = |first: i64, last: i64| {
                let count = last.checked_sub(first).and_then(|count| count.checked_add(extra));
                // A flat image has an axis without cells.
                count.and_then(|count| usize::try_from(count.max(1)).ok())
            };
            match (count(a, b), count(c, d), count(e, f)) {
                (Some(x), Some(y), Some(z)) => Ok([x, y, z]),
                _ => Err(wrong("its extent is no range")),
            }
        }
        _ => Err(wrong("it has no piece with an extent of six whole numbers")),
    }
}
