//! Tables of open systems that are refused before anything is written.

use crate::program::Folder;

const SPIN: &str = "\
[system]
algebra = 'so(3)'
hamiltonian = '-Pi3'
initial.Pi = [1, 0, 0]
[integrator]
end = 10
step = 0.1
";

const BACK: &str = "\
[system]
algebra = 'so(3)'
hamiltonian = '-Pi3'
initial.Pi = [1, 0, 0]
[integrator]
end = -10
step = 0.1
";

const TOP: &str = "[integrator]\nend = 1\n";

#[test]
fn errors_name_the_value_the_bound_and_the_line() {
    let folder = Folder::new();
    for (base, tables, parts) in [
        (
            SPIN,
            "[damping]\nfriction = -0.1\n",
            &["-0.1", "0 or a positive number", "friction = -0.1"][..],
        ),
        (
            BACK,
            "[damping]\nfriction = 2\n[noise]\ntemperature = 0.5\n",
            &[
                "no way back in time",
                "friction = 2",
                "must be above 0",
                "is -0.1",
                "end = -10",
                "^ write",
            ],
        ),
        (
            BACK,
            "[damping]\nfriction = 2\n[noise]\nstrength = 0.5\n",
            &["no way back in time", "the step is -0.1"],
        ),
        (SPIN, "[damping]\nfriction = nan\n", &["NaN"]),
        (SPIN, "[damping]\n", &["friction"]),
        (SPIN, "[noise]\ntemperature = 1\n", &["a temperature needs a friction", "add [damping]"]),
        (
            SPIN,
            "[damping]\nfriction = 1\n[noise]\ntemperature = -1\n",
            &["temperature = -1", "0 or a positive"],
        ),
        (
            SPIN,
            "[damping]\nfriction = 0\n[noise]\ntemperature = 0.5\n",
            &[
                "friction must be a positive number",
                "^ write more than 0, or leave noise.temperature out",
            ],
        ),
        (
            SPIN,
            "[damping]\nfriction = 1\nform = 'gilbert'\ninner_product = 2\n",
            &["damping.inner_product", "with form, which is of spins", "leave it out"],
        ),
        (SPIN, "[damping]\nform = 'gilbert'\n", &["friction is missing in [damping]"]),
        (SPIN, "[damping]\nfriction = 1\nform = 'bloch'\n", &["landau-lifshitz", "gilbert"]),
        (
            TOP,
            "[damping]\nfriction = 1\nform = 'gilbert'\n",
            &[
                "a form of damping is of spins",
                "se(3) has friction with inner_product",
                "form = 'gil",
            ],
        ),
        (SPIN, "[noise]\n", &["[noise] has one of temperature"]),
        (SPIN, "[drive]\n", &["[drive] has no formulas"]),
        (SPIN, "[torque]\n", &["[torque] has no formulas"]),
        (SPIN, "[noise]\nstrength = 1\npath = 9007199254740992\n", &["below 9007199254740992"]),
        (SPIN, "[noise]\nstrength = 1\ninterval = 1e-30\n", &["1e-30", "must be at least 0.00001"]),
        (SPIN, "[damping]\ninner_product = 1\n", &["friction is missing in [damping]"]),
        (SPIN, "[noise]\nstrength = -2\n", &["it is -2"]),
        (SPIN, "[noise]\nstrength = 1\nbound = 0.5\n", &["0.5", "1 standard deviation or more"]),
        (SPIN, "[noise]\nstrength = 1\nseed = -1\n", &["seed"]),
        (SPIN, "[noise]\nstrength = 1\nrule = 'both'\n", &["rule", "together", "alternating"]),
        (SPIN, "[noise]\nfields = [{ Pi = [0, 1] }]\n", &["3 formulas", "2"]),
        (SPIN, "[drive]\nPi = ['1', 'Pj', '0']\n", &["drive Pi2", "Pj", "^^"]),
        (SPIN, "[drive]\nOmega = [1, 0, 0]\n", &["Omega", "Pi"]),
        (SPIN, "[torque]\nPi = 'Pi1'\n", &["3 formulas"]),
        (
            SPIN,
            "[torque]\nPi = [0, 0, nan]\n",
            &["expected a finite number or a formula, got NaN", "Pi = [0, 0, nan]"],
        ),
        (TOP, "[drive]\nPi = [0, -inf, 0]\n", &["expected a finite number or a formula, got -inf"]),
        (
            SPIN,
            "[inputs.u]\ntimes = [0, 1]\nvalues = [0, 1]\ninterpolation = 'linear'\n[drive]\nPi = [0, 0, 'u']\n",
            &["from 0 to 1", "from 0 to 10"],
        ),
        (
            SPIN,
            "[inputs.u]\ntimes = [0, 2, 1]\nvalues = [0, 1, 1]\ninterpolation = 'linear'\n",
            &["must increase", "time 3 is 1, after 2"],
        ),
        (
            SPIN,
            "[inputs.u]\ntimes = [0, nan]\nvalues = [0, 1]\ninterpolation = 'linear'\n",
            &["NaN"],
        ),
        (
            SPIN,
            "[drive]\nPi = ['u', 0, 0]\n[inputs.u]\ntimes = [0, 20]\nvalues = [0, 1]\ninterpolation = 'linear'\n\
             [inputs.thruster]\ntimes = [0, 20]\nvalues = [0, 1]\ninterpolation = 'linear'\n",
            &["no formula names the input thruster", "[inputs.thruster]", "name it in a formula"],
        ),
        (
            TOP,
            "[inputs.u]\ntimes = [0, 20]\nvalues = [0, 1]\ninterpolation = 'linear'\n",
            &["no formula names the input u", "remove the table"],
        ),
        (SPIN, "[inputs.u]\ntimes = [0, 20]\nvalues = [0, 1]\n", &["interpolation"]),
        (
            SPIN,
            "[inputs.t]\ntimes = [0, 20]\nvalues = [0, 1]\ninterpolation = 'cubic'\n",
            &["is that of the time"],
        ),
        (
            TOP,
            "[damping]\nfriction = 1\n",
            &["an inner product is needed", "6 rows", "add inner_product"],
        ),
        (
            TOP,
            "[torque]\nGamma = [1, 0, 0]\n",
            &["formulas for Pi alone: Gamma is a direction in space", "Gamma = [1", "leave it out"],
        ),
        (
            TOP,
            "[torque]\nPi = [1, 0, 0]\n[output]\ncolumns = ['Omega']\n",
            &["Omega", "nothing drives"],
        ),
        (
            "[body]\ninertia = [1, 1, 0]\ncenter_of_mass = [0, 0, 1]\n[initial]\nangular_momentum = [1, 0, 0]\n",
            "[torque]\nPi = [1, 0, 0]\n",
            &["a thin rod"],
        ),
    ] {
        folder.write("a.toml", &format!("{base}{tables}"));
        let done = folder.heavytop(&["simulate", "a.toml", "--out", "a.csv"]);
        let told = done.stderr();
        assert_eq!(done.code(), 2, "{tables}: {told}");
        assert!(parts.iter().all(|part| told.contains(part)), "{tables}: {told}");
        assert_eq!(folder.names(), ["a.toml"], "{tables}");
    }
}

/// A formula that is 0 names its input, since a sweep may vary the factor; so do functions of other commands in the file.
#[test]
fn any_formula_names_an_input() {
    let folder = Folder::new();
    let input = "[inputs.'ω']\ntimes = [0, 20]\nvalues = [0, 1]\ninterpolation = 'linear'\n";
    for naming in [
        "[torque]\nPi = ['0*omega', 0, 0]\n",
        "[noise]\nfields = [{ Pi = [0, 0, 'ω'] }]\n",
        "[events]\nfunctions = ['Pi1 - 2ω²']\n",
        "[section]\nsurface = 'sin(ω)'\n",
    ] {
        folder.write("a.toml", &format!("{SPIN}{input}{naming}"));
        let done = folder.heavytop(&["simulate", "a.toml", "--out", "a.csv", "--force"]);
        assert_eq!(done.code(), 0, "{naming}: {}", done.stderr());
    }
}

#[test]
fn commands_of_closed_systems_say_which_table_they_do_not_take() {
    let folder = Folder::new();
    folder.write("top.toml", "[torque]\nPi = [0, 0, 1]\n");
    folder.write(
        "spin.toml",
        &format!("{SPIN}[damping]\nfriction = 1\n[events]\nfunctions = ['Pi1']\n"),
    );
    for arguments in [
        ["compare", "top.toml", "--out", "a"],
        ["animate", "top.toml", "--out", "a.html"],
        ["animate", "spin.toml", "--out", "a.html"],
    ] {
        let done = folder.heavytop(&arguments);
        let table = if arguments[1] == "top.toml" { "[torque]" } else { "[damping]" };
        assert!(
            done.code() == 2
                && done.stderr().contains(&format!("{table} is for tops and systems by formula")),
            "{arguments:?}: {}",
            done.stderr()
        );
        assert_eq!(folder.names(), ["spin.toml", "top.toml"]);
    }
}

/// The directions in the frame of a body have lengths and angles that mean something; momenta are changed as one likes.
#[test]
fn no_torque_acts_on_a_direction() {
    let folder = Folder::new();
    let satellite = "kind = 'satellite'\nparameters = { I = [100, 120, 40], n = 0.001 }\n\
                     initial.pitch = 0.1\n";
    let ellipse = satellite.replace("n =", "eccentricity = 0.1, n =");
    let gyrostat = "kind = 'gyrostat'\nparameters = { inertia = [2, 2, 1], weight = 1, center_of_mass = [0, 0, 1], \
                    rotor = [0, 0, 5] }\ninitial = { Pi = [0, 0, 5], Gamma = [1, 0, 0] }\n";
    let base = "kind = 'top-on-base'\nparameters = { inertia = [1, 1.2, 0.5], mass = 1, base_mass = 2, gravity = 9.81, \
                center_of_mass = [0, 0, 0.3] }\n\
                initial = { Pi = [0, 0, 1], P = [0, 0, 0], Gamma = [1, 0, 0] }\n";
    for (system, name, momenta) in [
        (satellite, "Gamma_1", "Pi"),
        (&ellipse, "Gamma_2", "Pi"),
        (gyrostat, "Gamma", "Pi"),
        (base, "Gamma", "Pi and P"),
    ] {
        let simulated = |torque: &str| {
            let run = "[integrator]\nstep = 0.01\nend = 0.1\n[torque]\n";
            folder.write("a.toml", &format!("[system]\n{system}{run}{torque}"));
            folder.heavytop(&["simulate", "a.toml", "--out", "a.csv", "--force"])
        };
        let refused = simulated(&format!("Pi = [0, 0, 1]\n{name} = [0, 't', 0]\n"));
        let told = refused.stderr();
        let words =
            format!("a torque has formulas for {momenta} alone: {name} is a direction in space");
        assert!(refused.code() == 2 && told.contains(&words), "{told}");
        assert!(told.contains(&format!("{name} = [0")) && told.contains("leave it out"), "{told}");
        let done = simulated(&format!("Pi = [0, 0, 1]\n{name} = [0, 0, 0]\n"));
        assert_eq!(done.code(), 0, "{}", done.stderr());
    }
}

/// What fails within a run is kept until then, as for other runs.
#[test]
fn a_formula_without_a_value_ends_the_run_there() {
    let folder = Folder::new();
    folder.write("a.toml", &format!("{SPIN}[drive]\nPi = ['log(5.05 - t)', 0, 0]\n"));
    let done = folder.heavytop(&["simulate", "a.toml", "--out", "a.csv"]);
    assert!(done.code() == 1 && done.stderr().contains("step 51"), "{}", done.stderr());
    assert_eq!(folder.names(), ["a.csv.partial", "a.toml"]);
}
