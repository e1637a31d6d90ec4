//! Casimirs from structure constants alone.

use lie_poisson::*;
use lie_poisson_formulas::{
    CasimirError, Coordinates, NamedAlgebra, StructureEntry, find_casimirs, find_casimirs_of_table,
    structure_constants, table_of_entries,
};

/// Returns the Casimirs as text, and how many are missing.
fn found<A: LieAlgebra>(algebra: &A, coordinates: &Coordinates) -> (Vec<String>, usize) {
    let found = find_casimirs(algebra, coordinates).unwrap();
    assert!(found.formulas().len() <= found.independent(), "{found:?}");
    (found.formulas().iter().map(ToString::to_string).collect(), found.missing())
}

/// Returns the Casimirs of a table of brackets [e_i, e_j] = value e_k + … with named coordinates.
fn of_table<const N: usize>(
    names: [&str; N],
    entries: &[(usize, usize, usize, f64)],
) -> (Vec<String>, usize) {
    let entries: Vec<_> =
        entries.iter().map(|&(i, j, k, value)| StructureEntry { i, j, k, value }).collect();
    let table = structure_constants::<N>(&entries).unwrap();
    found(&table, &Coordinates::scalars(names).unwrap())
}

fn named<A: NamedAlgebra>(algebra: &A) -> (Vec<String>, usize) {
    found(algebra, &algebra.coordinates().unwrap())
}

fn texts(texts: &[&str]) -> (Vec<String>, usize) {
    (texts.iter().map(|text| (*text).to_owned()).collect(), 0)
}

#[test]
fn algebras_of_the_library() {
    assert_eq!(named(&So3), texts(&["|Pi|^2"]));
    assert_eq!(named(&Su2), texts(&["|mu|^2"]));
    assert_eq!(named(&Se3::default()), texts(&["Pi·Gamma", "|Gamma|^2"]));
    assert_eq!(named(&Se2::default()), texts(&["|Gamma|^2"]));
    assert_eq!(named(&Sl2), texts(&["alpha^2/4 + beta*gamma"]));
    assert_eq!(named(&RealSpace::<3>), texts(&["p1", "p2", "p3"]));
    assert_eq!(named(&ProductAlgebra(So3, Se2::default())), texts(&["|Pi_1|^2", "|Gamma_2|^2"]));
    assert_eq!(named(&SemidirectAlgebra(SU2OnC2)), texts(&["|alpha|^2"]));
    let base = SemidirectAlgebra(Inherited { quotient: SO3OnR3, representation: SO3OnR3 });
    assert_eq!(named(&base), texts(&["|P|^2", "P·Gamma", "|Gamma|^2"]));
}

/// The Casimirs of u(3) have the degrees 1, 2 and 3.
#[test]
fn the_unitary_algebra() {
    let (casimirs, missing) = named(&UnitaryAlgebra::<3>);
    assert_eq!((casimirs.len(), missing), (3, 0));
    assert_eq!(casimirs[0], "mu1 + mu5 + mu9");
}

/// The conditions on Casimirs are linear in the constants, whose unit is therefore free.
#[test]
fn the_unit_of_the_constants_does_not_matter() {
    // [K, H] = P and [K, P] = H; so(3) in an orthonormal basis of another invariant product; a fraction and a square root
    let poincare = [(0, 1, 2, 1.0), (0, 2, 1, 1.0)];
    let stretched = [(0, 1, 2, 2.0 / 3.0), (1, 2, 0, 1.5), (2, 0, 1, 0.6)];
    let roots = [(0, 1, 2, 2.0_f64.sqrt()), (1, 2, 0, 2.0_f64.sqrt() / 3.0), (2, 0, 1, 0.5)];
    for table in [&poincare[..], &stretched, &roots] {
        let plain = of_table(["x", "y", "z"], table);
        assert_eq!((plain.0.len(), plain.1), (1, 0), "{plain:?}");
        for scale in [1e-30, 1e30, 1e-3, 7e11] {
            let scaled: Vec<_> = table.iter().map(|&(i, j, k, c)| (i, j, k, scale * c)).collect();
            assert_eq!(of_table(["x", "y", "z"], &scaled), plain, "{scale:e}");
        }
    }
    // Control: other ratios have another Casimir.
    assert_ne!(of_table(["x", "y", "z"], &stretched), of_table(["x", "y", "z"], &roots));
}

/// [x, y] = c z and cyclic permutations have the Casimir a x² + b y² + c z², of which a multiple has the coefficient 1.
#[test]
fn the_largest_coefficient_is_one() {
    let casimir = |a: f64, b: f64, c: f64| {
        of_table(["x", "y", "z"], &[(0, 1, 2, c), (1, 2, 0, a), (2, 0, 1, b)])
    };
    assert_eq!(casimir(12.0, 3.0, 2.0), texts(&["x^2 + y^2/4 + z^2/6"]));
    assert_eq!(casimir(12.0, 6.0, 4.0), texts(&["x^2 + y^2/2 + z^2/3"]));
    assert_eq!(casimir(-2.0, 3.0, 1.0), texts(&["2*x^2/3 - y^2 - z^2/3"]));
    // A unit in which the constants are small fractions is not replaced by one in which they are not.
    assert_eq!(casimir(1.0 / 37.0, 1.0, 31.0), texts(&["x^2/1147 + y^2/31 + z^2"]));
}

#[test]
fn algebras_from_tables() {
    // Heisenberg
    assert_eq!(of_table(["p", "q", "z"], &[(0, 1, 2, 1.0)]), texts(&["z"]));
    // Poincaré in one space dimension
    let poincare = [(0, 1, 2, 1.0), (0, 2, 1, 1.0)];
    assert_eq!(of_table(["K", "H", "P"], &poincare), texts(&["H^2 - P^2"]));
    // affine maps of the line have an open orbit
    assert_eq!(of_table(["a", "b"], &[(0, 1, 1, 1.0)]), texts(&[]));
    // [a, x] = x, [a, y] = 2y has the Casimir x²/y, and [a, x] = x, [a, y] = √2 y has x^√2/y: neither is polynomial
    for weight in [2.0, 2.0_f64.sqrt()] {
        let dilations = [(0, 1, 1, 1.0), (0, 2, 2, weight)];
        assert_eq!(of_table(["a", "x", "y"], &dilations), (Vec::new(), 1));
    }
    // [a, x] = x, [a, y] = −2y has the Casimir x²y
    let squeeze = [(0, 1, 1, 1.0), (0, 2, 2, -2.0)];
    assert_eq!(of_table(["a", "x", "y"], &squeeze), texts(&["x^2*y"]));
}

/// With rounded constants there are more candidates for linear Casimirs here than equations.
#[test]
fn more_central_coordinates_than_equations() {
    let names = ["h", "x", "y", "z1", "z2", "z3", "z4"];
    for small in [1.234567891234e-8, 1.234567891234e-3] {
        let (casimirs, missing) = of_table(names, &[(0, 1, 1, 1.0), (0, 2, 2, small)]);
        // The fifth, y/x^small, is not polynomial.
        assert_eq!((casimirs, missing), (texts(&["z1", "z2", "z3", "z4"]).0, 1), "{small:e}");
    }
}

/// Returns the brackets of so(n) in the basis L_ab, a < b: [L_ab, L_bc] = L_ac with signs.
fn orthogonal(n: usize) -> Vec<StructureEntry> {
    let basis: Vec<(usize, usize)> = (0..n).flat_map(|a| (a + 1..n).map(move |b| (a, b))).collect();
    let place = |a: usize, b: usize| {
        let sign = if a < b { 1.0 } else { -1.0 };
        basis.iter().position(|&pair| pair == (a.min(b), a.max(b))).map(|k| (k, sign))
    };
    let mut entries = Vec::new();
    for (i, &(a, b)) in basis.iter().enumerate() {
        for (j, &(c, d)) in basis.iter().enumerate() {
            // [L_ab, L_cd] = δ_bc L_ad − δ_ac L_bd − δ_bd L_ac + δ_ad L_bc
            let terms = [
                (b == c, 1.0, a, d),
                (a == c, -1.0, b, d),
                (b == d, -1.0, a, c),
                (a == d, 1.0, b, c),
            ];
            for (_, factor, first, second) in
                terms.into_iter().filter(|term| term.0 && term.2 != term.3)
            {
                if let Some((k, sign)) = place(first, second) {
                    entries.push(StructureEntry { i, j, k, value: factor * sign });
                }
            }
        }
    }
    entries
}

#[test]
fn orthogonal_algebras() {
    let so4 = structure_constants::<6>(&orthogonal(4)).unwrap();
    let names = Coordinates::scalars(["L12", "L13", "L14", "L23", "L24", "L34"]).unwrap();
    let squares = "L12^2 + L13^2 + L14^2 + L23^2 + L24^2 + L34^2";
    let pfaffian = "L12*L34 - L13*L24 + L14*L23";
    assert_eq!(found(&so4, &names), texts(&[pfaffian, squares]));
    // so(5) has Casimirs of degrees 2 and 4, and so(6) of degrees 2, 3 and 4
    let so5 = find_casimirs(&structure_constants::<10>(&orthogonal(5)).unwrap(), &mu(10)).unwrap();
    assert_eq!((so5.formulas().len(), so5.missing(), so5.degree()), (2, 0, 4));
    let so6 = find_casimirs(&structure_constants::<15>(&orthogonal(6)).unwrap(), &mu(15)).unwrap();
    assert_eq!((so6.formulas().len(), so6.missing(), so6.degree()), (3, 0, 4));
}

/// A rounding error at one place, of a constant or of a zero, leaves the Casimirs of so(4) as they are.
#[test]
fn a_rounding_error_at_one_place_changes_no_casimir() {
    let names = Coordinates::scalars(["L12", "L13", "L14", "L23", "L24", "L34"]).unwrap();
    let plain = found(&structure_constants::<6>(&orthogonal(4)).unwrap(), &names);
    assert_eq!((plain.0.len(), plain.1), (2, 0));
    // [e₀, e₁] is ±e₃, and has no coordinate at e₀.
    for (place, error) in [((0, 1, 3), f64::EPSILON), ((0, 1, 0), 1e-16), ((2, 4, 5), -1e-16)] {
        let of = |i: usize, j: usize, k: usize| {
            let entries = orthogonal(4);
            let same = entries.iter().filter(|e| (e.i, e.j, e.k) == (i, j, k));
            let exact: f64 = same.map(|entry| entry.value).sum();
            exact + if (i, j, k) == place { error } else { 0.0 }
        };
        let table = StructureConstants::<6>::new(|i, j, k| match i < j {
            true => of(i, j, k),
            false if i == j => 0.0,
            false => -of(j, i, k),
        });
        assert_eq!(found(&table.unwrap(), &names), plain, "{place:?} {error:e}");
    }
}

/// sl(3), with the constants by least squares from matrices: degrees 2 and 3, in the basis of matrix units and in a
/// generic one.
#[test]
fn constants_by_least_squares() {
    use nalgebra::{DMatrix, Matrix3};
    let unit =
        |i: usize, j: usize| Matrix3::from_fn(|a, b| if (a, b) == (i, j) { 1.0 } else { 0.0 });
    let off = [(0, 1), (0, 2), (1, 0), (1, 2), (2, 0), (2, 1)].map(|(i, j)| unit(i, j));
    let diagonal = [unit(0, 0) - unit(1, 1), unit(1, 1) - unit(2, 2)];
    let plain: Vec<Matrix3<f64>> = off.into_iter().chain(diagonal).collect();
    let weight = |a: usize, b: usize| ((3 * a + 7 * b + a * b) as f64).sin();
    let generic: Vec<Matrix3<f64>> = (0..8)
        .map(|a| {
            plain.iter().enumerate().map(|(b, m)| m * weight(a, b)).sum::<Matrix3<f64>>()
                + plain[a] * 2.0
        })
        .collect();
    for basis in [plain.clone(), generic] {
        let columns = DMatrix::from_fn(9, 8, |row, column| basis[column].as_slice()[row]);
        let solver = columns.svd(true, true);
        let bracket = |i: usize, j: usize| {
            let commutator = basis[i] * basis[j] - basis[j] * basis[i];
            let right = DMatrix::from_column_slice(9, 1, commutator.as_slice());
            solver.solve(&right, 1e-12).unwrap()
        };
        let table: Vec<_> = (0..8).map(|i| (0..8).map(move |j| (i.min(j), i.max(j)))).collect();
        let constants: Vec<Vec<_>> =
            table.into_iter().map(|row| row.map(|(i, j)| bracket(i, j)).collect()).collect();
        let algebra = StructureConstants::<8>::new(|i, j, k| match i.cmp(&j) {
            core::cmp::Ordering::Equal => 0.0,
            core::cmp::Ordering::Less => constants[i][j][(k, 0)],
            core::cmp::Ordering::Greater => -constants[i][j][(k, 0)],
        });
        let found = find_casimirs(&algebra.unwrap(), &mu(8)).unwrap();
        assert_eq!((found.degrees(), found.missing()), (&[2, 3][..], 0));
    }
}

/// Constants that are decimals, or squares that are no small whole numbers, have decimal coefficients.
#[test]
fn coefficients_are_decimals_if_need_be() {
    let casimir = |a: f64, b: f64, c: f64| {
        of_table(["x", "y", "z"], &[(0, 1, 2, c), (1, 2, 0, a), (2, 0, 1, b)])
    };
    assert_eq!(casimir(1.2345, 1.0, 1.0), texts(&["x^2 + 2000*y^2/2469 + 2000*z^2/2469"]));
    let speed = texts(&["x^2/299792458 + y^2/299792458 + z^2"]);
    assert_eq!(casimir(1.0, 1.0, 299_792_458.0), speed);
    assert_eq!(casimir(1.0, 0.123_456_789_123, 1.0), texts(&["x^2 + 0.123456789123*y^2 + z^2"]));
}

fn mu(dimension: usize) -> Coordinates {
    Coordinates::new().vector("mu", dimension).unwrap()
}

/// su(3) in Gell-Mann's basis, with structure constants ½ and √3/2: Casimirs of degrees 2 and 3.
#[test]
fn square_roots_in_the_table() {
    let (half, root) = (0.5, 3.0_f64.sqrt() / 2.0);
    let entries = [
        (0, 1, 2, 1.0),
        (0, 3, 6, half),
        (0, 4, 5, -half),
        (1, 3, 5, half),
        (1, 4, 6, half),
        (2, 3, 4, half),
        (2, 5, 6, -half),
        (3, 4, 7, root),
        (5, 6, 7, root),
    ];
    // totally antisymmetric
    let cyclic = entries.iter().flat_map(|&(i, j, k, value)| {
        [(i, j, k), (j, k, i), (k, i, j)].map(|(i, j, k)| StructureEntry { i, j, k, value })
    });
    let su3 = structure_constants::<8>(&cyclic.collect::<Vec<_>>()).unwrap();
    let found = find_casimirs(&su3, &mu(8)).unwrap();
    assert_eq!((found.formulas().len(), found.missing()), (2, 0));
    assert_eq!(found.formulas()[0].to_string(), "|mu|^2");
    assert!(found.formulas()[1].to_string().contains("sqrt(3)"), "{}", found.formulas()[1]);
}

/// The Casimirs that are found are those of the trait, whose differentials span the kernel.
#[test]
fn they_are_casimirs() {
    let se3 = Se3::default();
    let casimirs = find_casimirs(&se3, &se3.coordinates().unwrap()).unwrap();
    let mu = crate::support::point([0.3, -1.2, 0.7, 1.1, 0.4, -0.9]);
    for casimir in casimirs.formulas() {
        let rate = se3.coadjoint(&casimir.differential(&mu), &mu);
        // three products of numbers near 1 in each coordinate
        assert!(rate.max_abs() < 1e-15);
    }
    // Negative control: the energy of a body is no Casimir.
    let rate = se3.coadjoint(&crate::support::formula("Pi1^2").differential(&mu), &mu);
    assert!(rate.max_abs() > 0.1);
}

#[test]
fn as_many_names_as_dimensions() {
    let error = find_casimirs(&So3, &mu(4)).unwrap_err();
    assert_eq!(error, CasimirError::WrongDimension { names: 4, dimension: 3 });
}

/// In 17 dimensions there are 4845 monomials of degree 4, more than are searched, and 969 of degree 3.
///
/// With [a, x_j] = j x_j the Casimirs are no polynomials, such as x₂/x₁², so that the search would go on.
#[test]
fn the_number_of_monomials_has_a_bound() {
    fn searched<const N: usize>() -> (usize, usize, u8) {
        let entry = |j: usize| StructureEntry { i: 0, j, k: j, value: j as f64 };
        let names: Vec<String> = (0..N).map(|i| format!("x{i}")).collect();
        let table = structure_constants::<N>(&(1..N).map(entry).collect::<Vec<_>>()).unwrap();
        let coordinates = Coordinates::scalars(names.iter().map(String::as_str)).unwrap();
        let casimirs = find_casimirs(&table, &coordinates).unwrap();
        (casimirs.formulas().len(), casimirs.missing(), casimirs.degree())
    }
    assert_eq!(searched::<17>(), (0, 15, 3));
    // Control: with 16 dimensions and 3876 monomials degree 4 is searched.
    assert_eq!(searched::<16>(), (0, 14, 4));
}

/// Sixty-four spins and a centre: as many Casimirs as summands, each in the names of its own coordinates.
#[test]
fn a_sum_of_many_algebras() {
    let cyclic = |n: usize| [(0, 1, 2), (1, 2, 0), (2, 0, 1)].map(|of| (3 * n, of));
    let entries = (0..64).flat_map(cyclic).map(|(first, (i, j, k))| {
        let [i, j, k] = [i, j, k].map(|index| first + index);
        StructureEntry { i, j, k, value: 1.0 }
    });
    let table = table_of_entries(193, &entries.collect::<Vec<_>>()).unwrap();
    let spins = Coordinates::new().vector("S", 3).unwrap().repeated(64).unwrap();
    let found = find_casimirs_of_table(&table, &spins.scalar("z").unwrap()).unwrap();
    assert_eq!((found.formulas().len(), found.missing()), (65, 0));
    assert_eq!(found.formulas()[0].to_string(), "z");
    assert_eq!(found.formulas()[64].to_string(), "|S_64|^2");
    assert_eq!(found.degrees()[..2], [1, 2]);
}
