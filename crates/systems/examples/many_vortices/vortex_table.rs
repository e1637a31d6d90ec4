//! A table of point vortices on the sphere as comma-separated values.

use nalgebra::Vector3;
use std::error::Error;
use std::fs;
use std::path::Path;

/// Strengths (m²/s) and positions on the unit sphere.
#[derive(Debug, PartialEq)]
pub struct VortexTable {
    pub strengths: Vec<f64>,
    pub positions: Vec<Vector3<f64>>,
}

/// How the positions are given.
#[derive(Clone, Copy)]
enum Coordinates {
    /// x, y, z, at most [`OFF_THE_SPHERE`] away from the unit sphere.
    Cartesian,
    /// Latitude and longitude in degrees.
    Geographic,
}

/// How far a distance from the centre may be from 1 m, so that positions may be given by four digits.
const OFF_THE_SPHERE: f64 = 1e-3;

impl VortexTable {
    /// Reads the table in a file.
    ///
    /// # Errors
    /// Returns a message that names the file, and the line and the value that is wrong.
    pub fn read(path: &Path) -> Result<Self, Box<dyn Error>> {
        let named = |reason: String| format!("{}: {reason}", path.display());
        let text = fs::read_to_string(path).map_err(|reason| named(reason.to_string()))?;
        Ok(Self::from_text(&text).map_err(named)?)
    }

    /// Reads a table: one vortex a line, after a header `strength,x,y,z` or `strength,latitude,longitude`.
    ///
    /// Spaces around values and empty lines are allowed. Positions are moved to the sphere along their rays.
    ///
    /// # Errors
    /// Returns a message that names the line, counted from 1, and the value that is wrong.
    pub fn from_text(text: &str) -> Result<Self, String> {
        let lines = text.lines().enumerate().map(|(index, line)| (index + 1, line.trim()));
        let mut lines = lines.filter(|(_, line)| !line.is_empty());
        let (number, header) = lines.next().ok_or("the table is empty")?;
        let columns: Vec<_> = header.split(',').map(|name| name.trim().to_lowercase()).collect();
        let names: Vec<_> = columns.iter().map(String::as_str).collect();
        let coordinates = match names[..] {
            ["strength", "x", "y", "z"] => Coordinates::Cartesian,
            ["strength", "latitude", "longitude"] => Coordinates::Geographic,
            _ => {
                return Err(format!(
                    "line {number}: the header is '{header}', and must be 'strength,x,y,z' or \
                     'strength,latitude,longitude'"
                ));
            }
        };
        let mut table = Self { strengths: Vec::new(), positions: Vec::new() };
        let mut numbers = Vec::new();
        for (number, line) in lines {
            let (strength, position) = vortex(&names, coordinates, line)
                .map_err(|reason| format!("line {number}: {reason}"))?;
            if let Some(i) = table.positions.iter().position(|x| (x - position).norm() < 1e-9) {
                return Err(format!("line {number}: the same place as in line {}", numbers[i]));
            }
            table.strengths.push(strength);
            table.positions.push(position);
            numbers.push(number);
        }
        if numbers.len() < 2 {
            return Err(format!(
                "a vortex moves another one: two are needed, and {} given",
                numbers.len()
            ));
        }
        Ok(table)
    }
}

/// Returns strength and position in a line.
fn vortex(
    names: &[&str],
    coordinates: Coordinates,
    line: &str,
) -> Result<(f64, Vector3<f64>), String> {
    let values: Vec<_> = line.split(',').map(str::trim).collect();
    if values.len() != names.len() {
        return Err(format!("{} values where the header has {}", values.len(), names.len()));
    }
    let number = |(name, value): (&&str, &&str)| match value.parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        _ => Err(format!("{name}: '{value}' is not a finite number")),
    };
    let numbers = names.iter().zip(&values).map(number).collect::<Result<Vec<_>, _>>()?;
    let strength = numbers[0];
    if !strength.recip().is_finite() {
        return Err(format!("strength: '{}' is zero or too near to it", values[0]));
    }
    Ok((strength, position(coordinates, &numbers[1..])?))
}

fn position(coordinates: Coordinates, numbers: &[f64]) -> Result<Vector3<f64>, String> {
    match (coordinates, numbers) {
        (Coordinates::Geographic, &[latitude, longitude]) => {
            if latitude.abs() > 90.0 {
                return Err(format!("latitude: '{latitude}' is not between -90 and 90 degrees"));
            }
            let (sin, cos) = latitude.to_radians().sin_cos();
            let longitude = longitude.to_radians();
            Ok(Vector3::new(cos * longitude.cos(), cos * longitude.sin(), sin))
        }
        (_, numbers) => {
            let x = Vector3::from_row_slice(numbers);
            if (x.norm() - 1.0).abs() > OFF_THE_SPHERE {
                return Err(format!(
                    "x, y, z: the distance from the centre is {}, and must be 1",
                    x.norm()
                ));
            }
            Ok(x.normalize())
        }
    }
}
