//! The coefficients of Lobatto collocation.

use crate::error::SchemeError;
use crate::tableaux::tableau::Tableau;

impl Tableau {
    /// Creates Lobatto IIIA with s = 2, 3 or 4 stages: collocation at Lobatto's nodes, order 2s − 2.
    ///
    /// It is symmetric, but not symplectic. With its [`symplectic_conjugate`](Self::symplectic_conjugate), Lobatto
    /// IIIB, it forms a symplectic partitioned method.
    ///
    /// Source: Hairer, Lubich & Wanner, *Geometric Numerical Integration*, 2nd ed. (2006), Table
    /// II.1.3; Hairer & Wanner, *Solving Ordinary Differential Equations II*, Table IV.5.7.
    ///
    /// # Errors
    /// Returns [`SchemeError::Family`] for another number of stages.
    #[rustfmt::skip]
    pub fn lobatto_iiia(stages: usize) -> Result<Self, SchemeError> {
        let r = 5.0_f64.sqrt();
        let over = |d: f64, x: [f64; 4]| x.map(|x| x / d);
        match stages {
            2 => Self::new(&[0.0, 0.0,
                             0.5, 0.5], &[0.5, 0.5]),
            3 => Self::new(&[0.0,        0.0,       0.0,
                             5.0 / 24.0, 1.0 / 3.0, -1.0 / 24.0,
                             1.0 / 6.0,  2.0 / 3.0, 1.0 / 6.0],
                           &[1.0 / 6.0,  2.0 / 3.0, 1.0 / 6.0]),
            4 => {
                let b = over(12.0, [1.0, 5.0, 5.0, 1.0]);
                let a = [
                    [0.0; 4],
                    over(120.0, [11.0 + r, 25.0 - r,        25.0 - 13.0 * r, -1.0 + r]),
                    over(120.0, [11.0 - r, 25.0 + 13.0 * r, 25.0 + r,        -1.0 - r]),
                    b,
                ];
                Self::new(a.as_flattened(), &b)
            }
            _ => Err(SchemeError::Family { family: "Lobatto IIIA", least: 2, most: 4, stages }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lobatto_methods_have_order_2s_minus_2() {
        for s in 2..=4 {
            let iiia = Tableau::lobatto_iiia(s);
            let iiib = iiia.clone().and_then(|t| t.symplectic_conjugate());
            for tableau in [&iiia, &iiib] {
                let properties = tableau
                    .as_ref()
                    .map(|t| (t.order(), t.is_symmetric(), t.is_symplectic(), t.is_explicit()));
                assert_eq!(properties, Ok((2 * s - 2, true, false, false)));
            }
            let again = iiib.and_then(|t| t.symplectic_conjugate());
            let pairs = iiia.and_then(|a| again.map(|b| (a, b)));
            assert!(pairs.is_ok_and(|(a, b)| {
                a.matrix().iter().zip(b.matrix()).all(|(a, b)| (a - b).abs() < 1e-15)
            }));
        }
        assert!(matches!(Tableau::lobatto_iiia(5), Err(SchemeError::Family { stages: 5, .. })));
        // zero weights have no conjugate
        let runge = Tableau::new(&[0.0, 0.0, 0.5, 0.0], &[0.0, 1.0]);
        assert_eq!(runge.and_then(|t| t.symplectic_conjugate()), Err(SchemeError::NotFinite));
    }
}
