//! The numbers of a state in a checkpoint: a list, or many of them as a text of their bytes.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// The largest number of numbers that are a list.
const MOST_IN_LIST: usize = 1 << 12;

/// What a checkpoint may have.
#[derive(Deserialize)]
#[serde(untagged)]
enum Written {
    List(Vec<f64>),
    Text(String),
}

/// Writes a list, or the bytes of the numbers, the lowest first, in Base64.
pub(super) fn serialize<S: Serializer>(state: &[f64], to: S) -> Result<S::Ok, S::Error> {
    match state.len() > MOST_IN_LIST {
        false => state.serialize(to),
        true => {
            let bytes: Vec<u8> = state.iter().flat_map(|number| number.to_le_bytes()).collect();
            to.serialize_str(&STANDARD.encode(bytes))
        }
    }
}

/// Reads what [`serialize`] writes.
pub(super) fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<Vec<f64>, D::Error> {
    match Written::deserialize(from)? {
        Written::List(numbers) => Ok(numbers),
        Written::Text(text) => {
            let bytes = STANDARD.decode(text).map_err(D::Error::custom)?;
            let (numbers, rest) = bytes.as_chunks();
            match rest.is_empty() {
                true => Ok(numbers.iter().map(|eight| f64::from_le_bytes(*eight)).collect()),
                false => Err(D::Error::custom("the state ends within a number")),
            }
        }
    }
}
