//! Casimirs of degrees above 4, which are searched where there are few monomials.

use lie_poisson_formulas::{
    Coordinates, PolynomialCasimirs, StructureEntry, find_casimirs_of_table, table_of_entries,
};

/// Returns the entries [e_i, e_j] = value e_k + … without zeros.
fn entries(all: &[(usize, usize, usize, f64)]) -> Vec<StructureEntry> {
    let nonzero = all.iter().filter(|entry| entry.3 != 0.0);
    nonzero.map(|&(i, j, k, value)| StructureEntry { i, j, k, value }).collect()
}

fn found(names: &[String], entries: &[StructureEntry]) -> PolynomialCasimirs {
    let table = table_of_entries(names.len(), entries).unwrap();
    let coordinates = Coordinates::scalars(names.iter().map(String::as_str)).unwrap();
    find_casimirs_of_table(&table, &coordinates).unwrap()
}

/// [a, x] = p x and [a, y] = −q y have the Casimir x^q y^p, since {a, x^q y^p} = (pq − qp) x^q y^p.
#[test]
fn powers_balance_rates() {
    let names = ["a", "x", "y"].map(String::from);
    for (p, q, expected) in [
        (2.0, 3.0, Some("x^3*y^2")),
        (1.0, 5.0, Some("x^5*y")),
        (3.0, 4.0, Some("x^4*y^3")),
        (3.0, 5.0, Some("x^5*y^3")),
        // degree 9
        (4.0, 5.0, None),
    ] {
        let found = found(&names, &entries(&[(0, 1, 1, p), (0, 2, 2, -q)]));
        let texts: Vec<String> = found.formulas().iter().map(ToString::to_string).collect();
        assert_eq!(texts, Vec::from_iter(expected.map(String::from)), "{p} {q}");
        let (degree, missing) = expected.map_or((8, 1), |_| ((p + q) as u8, 0));
        assert_eq!((found.degree(), found.missing()), (degree, missing), "{p} {q}");
    }
}

/// sl(2, R) ⋉ V with the binary forms V of a degree n, in the basis h, e, f, v_0, …, v_n.
fn forms(n: usize) -> (Vec<String>, Vec<StructureEntry>) {
    let mut all = vec![(0, 1, 1, 2.0), (0, 2, 2, -2.0), (1, 2, 0, 1.0)];
    for i in 0..=n {
        let (v, i_) = (3 + i, i as f64);
        all.push((0, v, v, n as f64 - 2.0 * i_));
        all.push((1, v, v.saturating_sub(1), n as f64 + 1.0 - i_));
        all.push((2, v, v + 1, i_ + 1.0));
    }
    // e v_0 = 0 and f v_n = 0
    all.retain(|&(i, j, _, _)| (i, j) != (1, 3) && (i, j) != (2, 3 + n));
    let names = ["h", "e", "f"].map(String::from).into_iter();
    (names.chain((0..=n).map(|i| format!("v_{i}"))).collect(), entries(&all))
}

/// Returns the number of partitions of `w` into at most `parts` parts of at most `size`.
fn partitions(w: i64, parts: i64, size: i64) -> i64 {
    match (w, parts, size) {
        (0, _, _) => 1,
        (w, parts, size) if w < 0 || parts == 0 || size == 0 => 0,
        _ => partitions(w - size, parts - 1, size) + partitions(w, parts, size - 1),
    }
}

/// The dimension of the invariants of degree d of binary forms of degree n, by the formula of Cayley and Sylvester.
/// Source: D. Hilbert, *Theory of Algebraic Invariants* (1897), lecture XV.
fn invariants(n: i64, d: i64) -> i64 {
    if n * d % 2 == 1 {
        return 0;
    }
    partitions(n * d / 2, d, n) - partitions(n * d / 2 - 1, d, n)
}

/// Returns the number of products of degree d of elements with the given degrees.
fn products(degrees: &[u8], d: i64) -> i64 {
    match degrees.split_last() {
        _ if d == 0 => 1,
        None => 0,
        Some((last, rest)) => {
            (0..=d / i64::from(*last)).map(|n| products(rest, d - n * i64::from(*last))).sum()
        }
    }
}

/// From degree 5 on generic binary forms have no stabiliser of positive dimension, so that the Casimirs of sl(2, R) ⋉ V are
/// n − 2 in number, and functions on V∗: the invariants of binary forms. Those of sextics begin with degrees 2, 4 and 6, the
/// next has degree 10; those of quintics have degrees 4, 8 and 12.
#[test]
fn invariants_of_binary_forms() {
    for (n, degrees, searched) in
        [(3, &[4][..], 4), (4, &[2, 3], 3), (5, &[4], 7), (6, &[2, 4, 6], 6)]
    {
        let (names, entries) = forms(n);
        let found = found(&names, &entries);
        assert_eq!((found.degrees(), found.degree()), (degrees, searched), "{n}");
        assert_eq!((found.independent(), found.gap()), ((n - 2).max(1), None), "{n}");
        for d in 1..=i64::from(searched) {
            assert_eq!(invariants(n as i64, d), products(degrees, d), "{n} {d}");
        }
        let point: Vec<f64> =
            (0..names.len()).map(|i| (1.7 * (i * i) as f64 + 0.3).sin()).collect();
        for casimir in found.formulas() {
            let mut xi = casimir.differential_at(&point);
            let rate = |xi: &[f64]| {
                let (mut rate, mut size) = (vec![0.0; point.len()], 0.0_f64);
                for &StructureEntry { i, j, k, value } in &entries {
                    for (i, j, value) in [(i, j, value), (j, i, -value)] {
                        rate[j] += value * xi[i] * point[k];
                        size = size.max((value * xi[i] * point[k]).abs());
                    }
                }
                rate.into_iter().fold(0.0_f64, |largest, x| largest.max(x.abs())) / size
            };
            assert!(rate(&xi) < 1e-13, "{n}: {:e}", rate(&xi));
            // Negative control
            xi[3] *= 1.0 + 1e-6;
            assert!(rate(&xi) > 1e-9, "{n}: {:e}", rate(&xi));
        }
    }
}

/// Beyond these numbers of monomials nothing is searched: 6188 of degree 5 in 13 dimensions are searched, 8568 in 14 are not.
#[test]
fn the_number_of_monomials_of_high_degree_has_a_bound() {
    let searched = |dimension: usize| {
        let names: Vec<String> = (0..dimension).map(|i| format!("x{i}")).collect();
        let all: Vec<_> = (1..dimension).map(|j| (0, j, j, j as f64)).collect();
        let found = found(&names, &entries(&all));
        (found.formulas().len(), found.degree())
    };
    assert_eq!((searched(13), searched(14)), ((0, 5), (0, 4)));
}
