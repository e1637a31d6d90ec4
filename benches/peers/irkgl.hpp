// The Gauss method of order 16 with its eight stages in the lanes of a vector, by fixed-point iteration, as in
//     M. Antoñana, J. Makazaga & A. Murua, SIMD-vectorized implicit symplectic integrators can outperform explicit
//     ones, 2024 (IRKGaussLegendre.jl),
// written by hand over the six equations in w = h I⁻¹Π and Γ:
//     L_i = b_i f(Y_i),    Y_i = y + Σ_j μ_ij L_j,    y⁺ = y + Σ_i L_i,    μ_ij = a_ij/b_j, μ_ij + μ_ji = 1.
// The first guess is the polynomial through the stages of the last step. The iteration ends when no Y_i moves by more
// than a tolerance, or, to the floor, when the largest move has not become smaller.
#pragma once
#pragma GCC diagnostic ignored "-Wpsabi" // vectors wider than the registers are passed within this file only
#include "kernels.hpp"
#include <algorithm>
#include <array>

struct GaussCoefficients {
  static constexpr int S = 8;
  typedef long double Real;
  // Column j of a matrix is the vector over i.
  double b[S], mu[S][S], nu[S][S];

  GaussCoefficients() {
    Real c[S], weight[S];
    for (int i = 0; i < S; ++i) { // Newton's iteration for the zeros of the Legendre polynomial of degree S
      Real x = -std::cos(std::acos(Real(-1)) * (i + Real(0.75)) / (S + Real(0.5))), slope = 0;
      for (int pass = 0; pass < 50; ++pass) {
        Real p = 1, q = 0;
        for (int n = 1; n <= S; ++n) {
          const Real next = ((2 * n - 1) * x * p - (n - 1) * q) / n;
          q = p, p = next;
        }
        slope = S * (x * p - q) / (x * x - 1);
        x -= p / slope;
      }
      c[i] = (1 + x) / 2, weight[i] = 1 / ((1 - x * x) * slope * slope);
    }
    for (int j = 0; j < S; ++j) {
      b[j] = double(weight[j]);
      // ∫ of the j-th Lagrange polynomial, exact by the method's own quadrature
      const auto integral = [&](Real from, Real to) {
        Real sum = 0;
        for (int m = 0; m < S; ++m) {
          const Real x = from + (to - from) * c[m];
          Real value = weight[m] * (to - from);
          for (int l = 0; l < S; ++l)
            if (l != j) value *= (x - c[l]) / (c[j] - c[l]);
          sum += value;
        }
        return sum;
      };
      for (int i = 0; i < S; ++i) {
        mu[j][i] = double(integral(0, c[i]) / weight[j]);
        nu[j][i] = double(integral(1, 1 + c[i]) / weight[j]);
      }
    }
    // exact symplecticity: the sum of the rounded coefficients is 1
    for (int i = 0; i < S; ++i)
      for (int j = 0; j < i; ++j) mu[j][i] = 1 - mu[i][j];
    for (int i = 0; i < S; ++i) mu[i][i] = 0.5;
  }
};

struct Gauss16 {
  static constexpr int S = GaussCoefficients::S;
  // Eight lanes: one register of AVX-512, two of AVX2.
  typedef double Stages __attribute__((vector_size(8 * S)));
  struct Columns {
    Stages column[S];
    explicit Columns(const double (&matrix)[S][S]) {
      for (int j = 0; j < S; ++j)
        for (int i = 0; i < S; ++i) column[j][i] = matrix[j][i];
    }
  };

  Components<Stages>::Equations top;
  Columns mu, nu;
  Stages b;
  alignas(64) double L[6][S]; // the increments L_i of the last step, by component
  double tolerance;           // 0 iterates to the floor
  bool begun = false;

  Gauss16(const Top &top, double h, double tolerance) : Gauss16(GaussCoefficients(), top, h, tolerance) {}
  Gauss16(const GaussCoefficients &gauss, const Top &top, double h, double tolerance)
      : top(top, h), mu(gauss.mu), nu(gauss.nu), tolerance(tolerance) {
    for (int i = 0; i < S; ++i) b[i] = gauss.b[i];
  }

  // y + Σ_j M_ij L_j, as two sums of four products each, which wait for each other half as long.
  INLINE Stages combined(const Columns &matrix, const double *increments, double y) const {
    Stages even = matrix.column[0] * increments[0] + y, odd = matrix.column[1] * increments[1];
    unrolled<S / 2 - 1>([&](auto n) __attribute__((always_inline)) {
      constexpr int j = 2 * n + 2;
      even += matrix.column[j] * increments[j], odd += matrix.column[j + 1] * increments[j + 1];
    });
    return even + odd;
  }

  static INLINE Stages larger(Stages a, Stages b) { return a > b ? a : b; }

  // The largest lane, or NaN.
  static INLINE double largest(Stages a) {
    double most = 0, sum = 0;
    unrolled<S>([&](auto i) __attribute__((always_inline)) {
      constexpr int lane = i;
      most = a[lane] > most ? a[lane] : most, sum += a[lane];
    });
    return sum == sum ? most : sum;
  }

  INLINE bool step(Components<double> &y) {
    Components<Stages> Y;
    unrolled<6>([&](auto c) __attribute__((always_inline)) {
      Y.x[c] = begun ? combined(nu, L[c], y.x[c]) : Stages{} + y.x[c];
    });
    begun = true;
    double before = INFINITY;
    for (int sweep = 0; sweep < 100; ++sweep) {
      const Components<Stages> f = top.derivative(Y);
      unrolled<6>([&](auto c) __attribute__((always_inline)) { *reinterpret_cast<Stages *>(L[c]) = f.x[c] * b; });
      Stages moved{};
      unrolled<6>([&](auto c) __attribute__((always_inline)) {
        const Stages next = combined(mu, L[c], y.x[c]), move = next - Y.x[c];
        moved = larger(larger(move, -move), moved);
        Y.x[c] = next;
      });
      const double move = largest(moved);
      if (tolerance > 0 ? move <= tolerance : move == 0 || (move >= before && move < 1e-12)) {
        unrolled<6>([&](auto c) __attribute__((always_inline)) {
          double sum = 0;
          for (int i = 0; i < S / 2; ++i) sum += L[c][i] + L[c][S - 1 - i];
          y.x[c] += sum;
        });
        return true;
      }
      if (move != move) return false;
      before = move;
    }
    return false;
  }
};

struct Gauss16WithTolerance : Gauss16 {
  Gauss16WithTolerance(const Top &top, double h) : Gauss16(top, h, 5e-14) {}
};

struct Gauss16ToTheFloor : Gauss16 {
  Gauss16ToTheFloor(const Top &top, double h) : Gauss16(top, h, 0) {}
};
