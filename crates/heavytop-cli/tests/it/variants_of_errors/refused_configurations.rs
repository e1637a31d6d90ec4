//! Configurations that are refused: as text, of runs, of sections and of sweeps.

use super::refused;
use crate::program::Folder;
use heavytop_cli::commands::events::events;
use heavytop_cli::commands::section::section;
use heavytop_cli::commands::sweep::sweep;
use heavytop_cli::configuration::Config;
use heavytop_cli::reading::Sources;
use heavytop_cli::supervision::{TileOptions, Watch};
use std::collections::BTreeSet;

/// Assignments that are refused before there is a configuration.
const ASSIGNMENTS: [(&str, &str); 4] = [
    ("Error::Misread", "body.mas=1"),
    ("Error::Quoted", "body.mass='heavy'"),
    ("Error::Assignment", "body.mass"),
    ("Error::ReadTable", "system={structure_constants='missing.csv'}"),
];

/// Configurations of runs of tops.
const RUNS: [(&str, &str); 20] = [
    ("Error::Body", "body.mass = -1"),
    ("Error::Vertical", "initial.vertical = [0, 0, 2]"),
    ("Error::Spin", "body = { inertia = [2, 2, 0], center_of_mass = [0, 0, 1] }"),
    ("Error::CentralMoments", "body.inertia_about = 'center-of-mass'"),
    ("Error::AzimuthAlone", "initial.azimuth = 1"),
    ("Error::UnknownLength", "output.columns = ['height']"),
    (
        "Error::ColumnOfAttitude",
        "integrator.formulation = 'direct'\noutput.columns = ['euler-angles']",
    ),
    ("Error::Method", "integrator.formulation = 'splitting'"),
    ("Error::Run", "integrator.formulation = 'direct'\noutput.attitude = true"),
    ("Error::OutOfRange", "output.every = 0"),
    ("Error::Run", "integrator = { step = -0.02, end = 100 }"),
    ("Error::Run", "integrator = { step = 1e10, end = 1e10 }"),
    ("Error::Run", "integrator.step = 1e-300"),
    ("Error::Run", "integrator.step = 0.03"),
    ("SystemTableError::OneNoise", "[noise]"),
    ("SystemTableError::NoForces", "[torque]"),
    ("SystemTableError::MissingKey", "[damping]"),
    (
        "SystemTableError::OtherKey",
        "damping.inner_product = 1\n[system]\nkind = 'spin-lattice'\n\
         parameters = { shape = [2], exchange = 1 }\ninitial.tilt = 1",
    ),
    ("SystemTableError::ColumnOfClosed", "output.columns = ['Omega']\n[torque]\nPi = [1, 0, 0]"),
    (
        "SystemTableError::OpenRod",
        "body = { inertia = [2, 2, 0], center_of_mass = [0, 0, 1] }\n\
         initial.angular_momentum = [1, 0, 0]\n[torque]",
    ),
];

/// Configurations of runs of systems, below `[system]`.
const SYSTEMS: [(&str, &str); 12] = [
    ("SystemTableError::Missing", "algebra = 'so(3)'"),
    (
        "SystemTableError::TwoAlgebras",
        "algebra = 'so(3)'\nbrackets = { 'x, y' = 'x' }\nhamiltonian = 'x'",
    ),
    (
        "SystemTableError::TwoRealisations",
        "algebra = 'R3'\nhamiltonian = 'p1'\nrepresentation = [[[0]]]\nmomenta = [[[0]]]",
    ),
    ("SystemTableError::TwoSystems", "kind = 'body-with-rotors'\nhamiltonian = 'Pi1'"),
    (
        "SystemTableError::StructureConstants",
        "structure_constants = '''\n1\n2'''\nhamiltonian = '1'",
    ),
    ("SystemTableError::Parameter", "algebra = 'so(3)'\nhamiltonian = 'Pi1'\nparameters.'1' = 1"),
    ("SystemTableError::Formula", "algebra = 'so(3)'\nhamiltonian = 'x'"),
    ("SystemTableError::OnlySimulated", "kind = 'sphere-fluid'"),
    (
        "SystemTableError::NoStartFile",
        "algebra = 'so(3)'\nhamiltonian = 'Pi1'\ninitial_file = 'a.npz'",
    ),
    ("SystemTableError::NoAttitude", "hamiltonian = '1'\n[output]\nattitude = true"),
    ("SystemTableError::ColumnOfTops", "hamiltonian = '1'\n[output]\ncolumns = ['height']"),
    ("SystemTableError::Top", "hamiltonian = '1'\n[body]\nmass = 2"),
];

/// Configurations of sections, and below them those of a system.
const SECTIONS: [(&str, &str); 7] = [
    ("Error::Section", "section.energy = -100"),
    ("Error::TooManyPoints", "section = { starts = 100000, crossings = 100000 }"),
    ("Error::UnknownSurface", "section.surface = 'Pi9'"),
    ("Error::SectionKey", "section.axes = ['Pi1', 'Pi2']"),
    ("Error::PlaneLimits", "section.limits.y = [1, -1]"),
    ("Error::Crossing", FAILING),
    ("Error::Kept", FAILING),
];
const SYSTEM_SECTIONS: [(&str, &str); 5] = [
    ("Error::NoisyFunction", "surface = 'Pi1'\n[noise]\nstrength = 0.1"),
    ("Error::NoSurface", "starts = 1"),
    ("Error::SystemSection", "surface = 'x'"),
    ("Error::NeverCrosses", "surface = 'Pi1'\nlongest = 1\nstates = [{ Pi = [1, 0, 0] }]"),
    (
        "Error::NoValue",
        "surface = 'Pi1'\ndirection = 'both'\naxes = ['ln(Pi2)', 'Pi3']\nstates = [{ Pi = [1, 0, 1] }]",
    ),
];

/// An integrator whose first step fails.
const FAILING: &str =
    "integrator = { step = 0.5, formulation = 'collective', scheme = 'lobatto-iiia-iiib-4' }";

/// Configurations of events, and the names of their tables.
const EVENTS: [(&str, &str, &str); 3] = [
    ("Error::NoEvents", "", "e.csv"),
    ("Error::EventFunction", "events.functions = ['x']", "e.csv"),
    ("Error::NoTable", "events.functions = ['Pi1']", "e.npz"),
];

/// A system in which every coordinate but Pi3 changes.
const BODY: &str = "[system]\nalgebra = 'so(3)'\nhamiltonian = 'Pi3^2'\ninitial.Pi = [1, 0, 1]\n";

/// Sweeps of tops.
const SWEEPS: [(&str, &str); 15] = [
    ("SweepError::NoAxes", "axes = []"),
    ("SweepError::NoObservables", "observables = []"),
    (
        "SweepError::OfClosed",
        "observables = ['relative-drift']\naxes = [{ parameter = 'body.mass', from = 1, to = 2, count = 2 }]\n\
         [torque]\nPi = [1, 0, 0]",
    ),
    ("SweepError::Twice", "observables = ['megno', 'megno']"),
    ("SweepError::Axis", "axes = [{ parameter = 'body.mass', from = 1 }]"),
    (
        "SweepError::OfAnother",
        "axes = [{ parameter = 'system.initial.x', from = 0, to = 1, count = 2 }]",
    ),
    (
        "SweepError::Clash",
        "count = 1\naxes = [{ parameter = 'body.mass', uniform = [1, 2] }, \
         { parameter = 'body.mass', uniform = [1, 3] }]",
    ),
    (
        "SweepError::Mixed",
        "axes = [{ parameter = 'body.mass', uniform = [1, 2] }, \
         { parameter = 'body.length', from = 1, to = 3, count = 2 }]",
    ),
    ("SweepError::Count", "axes = [{ parameter = 'body.mass', uniform = [1, 2] }]"),
    (
        "SweepError::TooMany",
        "axes = [{ parameter = 'body.mass', from = 1, to = 2, count = 4000000000 }]",
    ),
    (
        "SweepError::Velocity",
        "axes = [{ parameter = 'initial.angular_momentum[0]', from = 1, to = 2, count = 2 }]\n\
         [initial]\nangular_velocity = [1, 0, 0]",
    ),
    (
        "SweepError::Momentum",
        "axes = [{ parameter = 'initial.angular_velocity[0]', from = 1, to = 2, count = 2 }]",
    ),
    (
        "SweepError::Matrix",
        "axes = [{ parameter = 'body.inertia[0]', from = 1, to = 2, count = 2 }]\n\
         [body]\ninertia = [[2, 0, 0], [0, 2, 0], [0, 0, 1]]",
    ),
    (
        "SweepError::Weight",
        "axes = [{ parameter = 'body.mass', from = 1, to = 2, count = 2 }]\n\
         [body]\nweight_moment = 3",
    ),
    (
        "Error::AllFailed",
        "axes = [{ parameter = 'body.mass', from = 1, to = 2, count = 2 }]\n\
         [integrator]\nstep = 500\nend = 1000",
    ),
];

/// Parameters of axes of a system, with observables.
const SYSTEM_SWEEPS: [(&str, &str, &str); 5] = [
    ("SweepError::NoParameter", "system.parameters.k", "megno"),
    ("SweepError::Index", "system.parameters.b[9]", "megno"),
    ("SweepError::NoVector", "system.parameters.a[0]", "megno"),
    ("SweepError::OfTops", "system.initial.failure", "rotation-number"),
    ("SweepError::SameColumn", "system.initial.failure", "final-state"),
];

/// A system with three coordinates, one of which has the name of another column.
const NAMED: &str = "[system]\ncoordinates = ['failure', 'y', 'z']\nbrackets = { 'failure, y' = 'a*z' }\n\
                     hamiltonian = 'failure'\nparameters = { a = 1, b = [1, 2] }\ninitial = { failure = 1, y = 1, z = 1 }\n";

/// A system whose coordinates x and y have the names of columns of a section.
const SOLVABLE: &str = "[system]\ncoordinates = ['x', 'y', 'z']\nbrackets = { 'x, y' = 'y', 'x, z' = 'z' }\n\
                       hamiltonian = 'a*x'\nparameters.a = 1\ninitial = { x = 1, y = 0, z = 0 }\n\
                       [integrator]\nformulation = 'direct'\nscheme = 'explicit-midpoint'\nstep = 1\nend = 3\n";

/// A collective method from the origin, where all tangent vectors of z have the image 0.
const AT_REST: &str = "[system]\ncoordinates = ['x', 'y', 'z']\nbrackets = { 'x, y' = 'z', 'x, z' = 'y' }\n\
                       hamiltonian = 'a*x + y^2'\nparameters.a = 1\ninitial = { x = 0, y = 0, z = 0 }\n\
                       [integrator]\nformulation = 'collective'\nstep = 1\nend = 3\n";

/// A collective method whose steps do not descend, since the cube of ad z is no multiple of ad z.
const LIFTED: &str = "[system]\ncoordinates = ['x', 'y', 'z']\nbrackets = { 'x, z' = 'x', 'y, z' = '2*y' }\n\
                      hamiltonian = 'x^2 + y^2 + z^2'\ninitial = { x = 0.1, y = 0.3, z = -0.2 }\n\
                      [integrator]\nformulation = 'collective'\nstep = 0.1\nend = 1\n";

/// A lattice of 100 spins, which are more than columns of a table.
const LATTICE: &str = "[system]\nkind = 'spin-lattice'\nparameters = { shape = [100], exchange = 1, field = [0, 0, 0] }\n\
                       initial = { tilt = 0.3 }\n[integrator]\nstep = 0.1\nend = 0.2\n";

/// Values of the parameter at which members fail, of which only their text is returned. Without brackets there are more
/// Casimirs.
const MEMBERS: [(&str, &str, &str, &str); 2] = [
    ("SweepError::Casimirs", NAMED, "0", "it has 3 Casimirs, and the system with "),
    ("Error::Tangent", AT_REST, "1", "tangent vector 0 has the length 0e0 "),
];

pub fn errors() -> BTreeSet<String> {
    let folder = Folder::new();
    let out = folder.path("made");
    let config = |text: &str| -> Config { toml::from_str(text).unwrap() };
    let cut = |text: &str| section(&config(text), &out, &TileOptions::default());
    let sweep_of = |text: &str| sweep(&config(text), &out, &TileOptions::default());
    let axis = |parameter: &str, observable: &str, values: &str| {
        format!(
            "[sweep]\nobservables = ['{observable}']\n\
             axes = [{{ parameter = '{parameter}', {values}, count = 2 }}]"
        )
    };
    let mut found = Vec::new();
    for (expected, text) in ASSIGNMENTS {
        found.push(refused(expected, Sources::read(None, None, &[text.into()])));
    }
    for (expected, text) in RUNS {
        found.push(refused(expected, config(text).run().map(drop)));
    }
    for (expected, text) in SYSTEMS {
        found.push(refused(expected, config(&format!("[system]\n{text}")).system_experiment()));
    }
    found.push(refused("SystemTableError::CommandOfTops", config(BODY).experiment()));
    found.push(refused("SystemTableError::OpenTable", config("[torque]").experiment()));
    for (expected, text) in SECTIONS {
        found.push(refused(expected, cut(text)));
    }
    for (expected, text) in SYSTEM_SECTIONS {
        found.push(refused(expected, cut(&format!("{BODY}[section]\n{text}"))));
    }
    for (expected, text, name) in EVENTS {
        let result = events(&config(text), &folder.path(name), &Watch::default());
        found.push(refused(expected, result));
    }
    // The points of a section have the columns x and y.
    let plane = cut(&format!("{SOLVABLE}[section]\nsurface = 'z'"));
    found.push(refused("SystemTableError::SameColumn", plane));
    for (expected, text) in SWEEPS {
        found.push(refused(expected, sweep_of(&format!("[sweep]\n{text}"))));
    }
    for (expected, parameter, observable) in SYSTEM_SWEEPS {
        let text = NAMED.to_owned() + &axis(parameter, observable, "from = 0, to = 1");
        found.push(refused(expected, sweep_of(&text)));
    }
    let of_start = |observable| axis("system.initial.x", observable, "from = 0.1, to = 0.2");
    let lifted = |observable| sweep_of(&(LIFTED.to_owned() + &of_start(observable)));
    found.push(refused("SweepError::Lifted", lifted("megno")));
    assert!(lifted("final-state").is_ok());
    // A shorter chain has fewer coordinates.
    for (variant, observable) in
        [("SweepError::WideState", "final-state"), ("SweepError::OtherColumns", "invariant-drift")]
    {
        let swept = axis("system.parameters.shape[0]", observable, "from = 50, to = 50");
        let message = sweep_of(&(LATTICE.to_owned() + &swept)).unwrap_err().message();
        let said = ["has at most 256", "it has 150 coordinates, and the system with"];
        assert!(said.iter().any(|said| message.contains(said)), "{message}");
        found.push(BTreeSet::from([variant.into()]));
    }
    for (variant, system, value, said) in MEMBERS {
        let values = format!("from = {value}, to = {value}");
        let text = system.to_owned() + &axis("system.parameters.a", "lyapunov", &values);
        let message = sweep_of(&text).unwrap_err().message();
        assert!(message.contains("; the first: ") && message.contains(said), "{message}");
        found.push(BTreeSet::from([variant.into()]));
    }
    found.into_iter().flatten().collect()
}
