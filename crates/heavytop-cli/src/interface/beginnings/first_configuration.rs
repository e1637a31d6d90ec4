//! The command `init`: a configuration with comments, to begin with.

use super::map_tables::MapTable;
use crate::configuration::{BodyConfig, Config, Integration, Preset};
use crate::errors::Error;
use crate::files::{Kind, Output, Place, Safeguard};
use crate::interface::standard_output::to_stdout;
use clap::ValueEnum;
use std::io::{self, Write};
use std::path::Path;

/// How a configuration is recognised that nobody has edited since.
const KIND: Kind<'_> = Kind {
    name: "configuration as init writes it",
    first: b"# A heavy top for the program heavytop.",
    is_whole: |head, _| Ok(texts().any(|text| text.as_bytes() == head)),
};

/// Returns the configurations that there are to write.
fn texts() -> impl Iterator<Item = String> {
    let presets = Preset::value_variants().iter().map(|preset| preset.config());
    let maps = [None, Some(MapTable::Section), Some(MapTable::Sweep)];
    presets.flat_map(move |config| maps.map(|map| commented(&config, map)))
}

/// Writes a commented configuration into a file, or to stdout, of one motion or of many.
///
/// # Errors
/// If the file exists and has been edited, unless it is replaced by force; or it cannot be written.
pub(in crate::interface) fn init(
    preset: Option<Preset>,
    map: Option<MapTable>,
    file: Option<&Path>,
    force: bool,
) -> Result<(), Error> {
    let config = preset.map_or_else(Config::default, Preset::config);
    write_new(&commented(&config, map), &KIND, file, force)
}

/// Writes a configuration of a kind into a file, or to stdout.
///
/// # Errors
/// If the file exists and is no such configuration, unless it is replaced by force; or it cannot be written.
pub(super) fn write_new(
    text: &str,
    kind: &Kind<'_>,
    file: Option<&Path>,
    force: bool,
) -> Result<(), Error> {
    let place = file.map(Place::of).transpose()?.filter(|place| !place.is_standard_output());
    let (Some(path), Some(place)) = (file, place) else {
        return to_stdout(io::stdout().lock().write_all(text.as_bytes()));
    };
    Safeguard::new(Vec::new(), force).require(path, kind)?;
    let is_there = place.path.exists();
    let mut output = Output::create(path)?;
    output.write(|to| to.write_all(text.as_bytes()))?;
    // Another one that appears at this moment is not replaced.
    if is_there { output.complete() } else { output.complete_new(kind) }
}

/// Returns the configuration as TOML with comments.
fn commented(config: &Config, map: Option<MapTable>) -> String {
    let Config { body, initial, output, .. } = config;
    let integrator = config.integrator.or(Integration::default());
    let (formulation, scheme) = (integrator.formulation.name(), integrator.scheme.name());
    let run = match map {
        None => "simulate FILE --out top.csv".to_owned(),
        Some(map) => format!("{} FILE --out DIR", map.command()),
    };
    let mut text = format!(
        "# A heavy top for the program heavytop. Every key may be left out.\n# Run it: heavytop {run}\n"
    );
    let mut table = |name: &str, lines: &[(String, &str)]| {
        text += &format!("\n[{name}]\n");
        for (line, comment) in lines {
            text += &format!("{line:<46} # {comment}\n");
        }
    };
    table("body", &lines_of_body(body));
    table(
        "initial",
        &[
            (
                format!("angular_momentum = {:?}", initial.angular_momentum),
                "Π(0), kg m²/s, body frame",
            ),
            ("# angular_velocity = [1.0, 0.0, 0.0]".into(), "Ω(0), rad/s, instead of it"),
            (format!("vertical = {:?}", initial.vertical), "Γ(0), body frame, a unit vector"),
            ("# inclination = \"20 deg\"".into(), "from e3 to Γ(0), instead of vertical"),
            ("# azimuth = \"0 deg\"".into(), "from e1 towards e2, beside inclination"),
        ],
    );
    if let Some(map) = map {
        return text + map.text() + CHOSEN;
    }
    table(
        "integrator",
        &[
            (format!("formulation = \"{formulation}\""), "collective, reduced, direct, splitting"),
            (format!("scheme = \"{scheme}\""), "see heavytop help simulate"),
            (format!("step = {:?}", integrator.step), "s"),
            (
                format!("end = {:?}", integrator.end),
                "s; a whole number of steps, backward if negative",
            ),
            (
                format!("tolerance = {:?}", integrator.tolerance),
                "of the stage equations; 0 iterates to the round-off floor",
            ),
            ("# instructions = \"portable\"".into(), "the same bytes on every processor, slower"),
        ],
    );
    table(
        "output",
        &[
            (format!("every = {}", output.every), "keep every n-th step, and the last"),
            (format!("attitude = {}", output.attitude), "whether to write the attitude"),
            ("# columns = [\"Omega\", \"euler-angles\"]".into(), "or height, kinetic, ..."),
        ],
    );
    text + "\n# heavytop help section and heavytop help sweep show [section] and [sweep]. They choose formulation,\n\
            # scheme and step if these are left out.\n"
}

/// What stands at the end of a configuration of a section or of a sweep.
const CHOSEN: &str = "
# [integrator]                                 # formulation, scheme, step: chosen if they are left out
";

/// Returns the lines of the table `[body]`, each with its comment.
fn lines_of_body(body: &BodyConfig) -> Vec<(String, &'static str)> {
    let mut lines = vec![
        (
            format!("inertia = {}", body.inertia),
            "principal moments about the support, kg m²; or a matrix",
        ),
        ("# inertia_about = \"center-of-mass\"".into(), "if they are about the centre of mass"),
    ];
    let factors = [
        (format!("mass = {:?}", body.mass), "kg"),
        (format!("gravity = {:?}", body.gravity), "m/s²; 9.81 on Earth, 0 for the free rigid body"),
        (format!("length = {:?}", body.length), "m, support to centre of mass"),
    ];
    match body.weight_moment {
        // Of such a top neither mass nor length is known.
        Some(weight) => lines.extend([
            (
                format!("weight_moment = {weight:?}"),
                "m g l, N m: the motion depends on no more, or",
            ),
            (
                "# mass = 1.0, gravity = 9.81, length = 0.1".into(),
                "kg, m/s², m: three keys instead of it",
            ),
        ]),
        None => lines.extend(factors),
    }
    lines.extend([
        (
            format!("center_of_mass = {:?}", body.center_of_mass),
            "direction from the support in the body frame, a unit vector",
        ),
        ("# normalise = true".into(), "scale it to length 1 instead"),
    ]);
    lines
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn the_text_reads_back_as_the_preset() {
        for preset in Preset::value_variants() {
            let mut config = preset.config();
            config.integrator = config.integrator.or(Integration::default()).into();
            let read: Config = toml::from_str(&commented(&config, None)).unwrap();
            // Beside m g l its factors are neither written nor used.
            if config.body.weight_moment.is_some() {
                config.body.gravity = read.body.gravity;
            }
            assert_eq!(read, config);
        }
    }
}
