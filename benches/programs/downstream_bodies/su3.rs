//! A generalised rigid body on su(3)∗.

use super::{Body, Start, rk4};
use collective_integrators::{Collective, RungeKutta};
use lie_poisson::num_complex::Complex;
use lie_poisson::{ComplexSpace, Covector, Hamiltonian, LieAlgebra, LiePoisson, Real};
use momentum_map::{Cotangent, CotangentBundle, PoissonMap};
use nalgebra::{SVector, Vector3};
use std::error::Error;

/// The coordinates of ξ = −(i/2) Σ ξ_a λ_a with Gell-Mann's matrices λ_a.
type Element<T> = SVector<T, 8>;

/// A point of C³.
type Triple<T> = Vector3<Complex<T>>;

/// The algebra su(3) in the basis −(i/2) λ_a, [e_a, e_b] = Σ_c f_abc e_c.
#[derive(Clone, Copy)]
pub struct Su3;

/// Half of √3.
const HALF_ROOT_3: f64 = 0.866_025_403_784_438_6;

/// The numbers f_abc that are not 0, up to permutations.
const STRUCTURE: [([usize; 3], f64); 9] = [
    ([0, 1, 2], 1.0),
    ([0, 3, 6], 0.5),
    ([0, 4, 5], -0.5),
    ([1, 3, 5], 0.5),
    ([1, 4, 6], 0.5),
    ([2, 3, 4], 0.5),
    ([2, 5, 6], -0.5),
    ([3, 4, 7], HALF_ROOT_3),
    ([5, 6, 7], HALF_ROOT_3),
];

impl LieAlgebra for Su3 {
    type Element<T: Real> = Element<T>;

    fn bracket<T: Real>(&self, xi: &Element<T>, eta: &Element<T>) -> Element<T> {
        let mut bracket = Element::zeros();
        for ([a, b, c], f) in STRUCTURE {
            for [i, j, k] in [[a, b, c], [b, c, a], [c, a, b]] {
                bracket[k] += (xi[i] * eta[j] - xi[j] * eta[i]) * f;
            }
        }
        bracket
    }
}

/// The momentum μ_a = ½ Im(p†λ_a q) of SU(3) on T∗C³, with the plus bracket.
#[derive(Clone, Copy)]
pub struct OnTriples;

impl PoissonMap for OnTriples {
    type Source = CotangentBundle<ComplexSpace<3>>;
    type Target = LiePoisson<Su3>;

    fn source(&self) -> Self::Source {
        CotangentBundle(ComplexSpace)
    }

    fn target(&self) -> Self::Target {
        LiePoisson::plus(Su3)
    }

    #[inline]
    fn apply<T: Real>(&self, z: &Cotangent<Triple<T>>) -> Covector<Element<T>> {
        let (q, Covector(p)) = (&z.q, &z.p);
        // The products p̄_j q_k.
        let re = |j: usize, k: usize| p[j].re * q[k].re + p[j].im * q[k].im;
        let im = |j: usize, k: usize| p[j].re * q[k].im - p[j].im * q[k].re;
        let symmetric = |j, k| (im(j, k) + im(k, j)) * 0.5;
        let antisymmetric = |j, k| (re(k, j) - re(j, k)) * 0.5;
        let [first, second, third] = [im(0, 0), im(1, 1), im(2, 2)];
        Covector(Element::from([
            symmetric(0, 1),
            antisymmetric(0, 1),
            (first - second) * 0.5,
            symmetric(0, 2),
            antisymmetric(0, 2),
            symmetric(1, 2),
            antisymmetric(1, 2),
            (first + second - third * 2.0) * (HALF_ROOT_3 / 3.0),
        ]))
    }

    #[inline]
    fn generator<T: Real>(
        &self,
        xi: &Element<T>,
        z: &Cotangent<Triple<T>>,
    ) -> Cotangent<Triple<T>> {
        let xi = xi * T::from_f64(0.5);
        let root = xi[7] * (2.0 * HALF_ROOT_3 / 3.0);
        let diagonal = [root + xi[2], root - xi[2], root * (-2.0)];
        // −i times the matrix ½ Σ ξ_a λ_a = (d, x − iy, …) times v
        let turned = |v: &Triple<T>| {
            let product =
                |d: T, j: usize, (x, y, k): (T, T, usize), (u, w, l): (T, T, usize)| Complex {
                    re: d * v[j].im + x * v[k].im - y * v[k].re + u * v[l].im - w * v[l].re,
                    im: -(d * v[j].re + x * v[k].re + y * v[k].im + u * v[l].re + w * v[l].im),
                };
            Vector3::new(
                product(diagonal[0], 0, (xi[0], xi[1], 1), (xi[3], xi[4], 2)),
                product(diagonal[1], 1, (xi[0], -xi[1], 0), (xi[5], xi[6], 2)),
                product(diagonal[2], 2, (xi[3], -xi[4], 0), (xi[5], -xi[6], 1)),
            )
        };
        Cotangent::new(turned(&z.q), Covector(turned(&z.p.0)))
    }
}

/// The body with h = ½ Σ μ_a²/I_a.
#[derive(Clone, Copy)]
pub struct BodyOnSu3 {
    inverse: Element<f64>,
}

impl BodyOnSu3 {
    /// Creates the body with I = (1, 1.2, …, 2.4).
    pub fn new() -> Self {
        Self { inverse: Element::from_fn(|a, _| 1.0 / (1.0 + 0.2 * a as f64)) }
    }
}

impl<T: Real> Hamiltonian<LiePoisson<Su3>, T> for BodyOnSu3 {
    fn value(&self, Covector(mu): &Covector<Element<T>>) -> T {
        mu.zip_map(&self.inverse, |x, inverse| x * x * inverse).sum() * 0.5
    }

    #[inline]
    fn differential(&self, Covector(mu): &Covector<Element<T>>) -> Element<T> {
        mu.zip_map(&self.inverse, |x, inverse| x * inverse)
    }
}

impl Body for BodyOnSu3 {
    type Map = OnTriples;
    type Energy = Self;

    fn gauss4(&self) -> Result<Start<Self>, Box<dyn Error>> {
        let c = Complex::new;
        let q = Vector3::new(c(1.0, 0.2), c(0.1, -0.5), c(0.5, 0.0));
        let p = Vector3::new(c(0.3, -0.7), c(0.9, 0.4), c(-0.2, 0.6));
        let gauss = Collective::new(RungeKutta::gauss(2)?, OnTriples, *self);
        Ok((gauss, Cotangent::new(q, Covector(p))))
    }

    /// The equations are dμ_a/dt = Σ f_abc ξ_b μ_c with ξ = ∂h/∂μ, that is, Σ_(b<c) f_abc (1/I_b − 1/I_c) μ_b μ_c. The
    /// coefficients of the products are computed beforehand.
    fn rk4(&self, mu: &mut [f64], steps: u64) -> Option<()> {
        let c = STRUCTURE.map(|([a, b, c], f)| {
            let [x, y, z] = [a, b, c].map(|i| self.inverse[i]);
            [f * (y - z), f * (z - x), f * (x - y)]
        });
        rk4(mu, steps, |m: &[f64; 8]| {
            [
                c[0][0] * (m[1] * m[2]) + c[1][0] * (m[3] * m[6]) + c[2][0] * (m[4] * m[5]),
                c[0][1] * (m[2] * m[0]) + c[3][0] * (m[3] * m[5]) + c[4][0] * (m[4] * m[6]),
                c[0][2] * (m[0] * m[1]) + c[5][0] * (m[3] * m[4]) + c[6][0] * (m[5] * m[6]),
                c[1][1] * (m[6] * m[0])
                    + c[3][1] * (m[5] * m[1])
                    + (c[5][1] * (m[4] * m[2]) + c[7][0] * (m[4] * m[7])),
                c[2][1] * (m[5] * m[0])
                    + c[4][1] * (m[6] * m[1])
                    + (c[5][2] * (m[2] * m[3]) + c[7][1] * (m[7] * m[3])),
                c[2][2] * (m[0] * m[4])
                    + c[3][2] * (m[1] * m[3])
                    + (c[6][1] * (m[6] * m[2]) + c[8][0] * (m[6] * m[7])),
                c[1][2] * (m[0] * m[3])
                    + c[4][2] * (m[1] * m[4])
                    + (c[6][2] * (m[2] * m[5]) + c[8][1] * (m[7] * m[5])),
                c[7][2] * (m[3] * m[4]) + c[8][2] * (m[5] * m[6]),
            ]
        })
    }
}
