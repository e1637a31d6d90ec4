// The Gauss method of order 16 with its eight stages in the lanes of a vector, by fixed-point iteration, as in
//     M. Antoñana, J. Makazaga & A. Murua, SIMD-vectorized implicit symplectic integrators can outperform explicit
//     ones, 2024 (IRKGaussLegendre.jl),
// written by hand over the six equations in w = h I⁻¹Π and Γ:
//     L_i = b_i f(Y_i),    Y_i = y + Σ_j μ_ij L_j,    y⁺ = y + Σ_i L_i,    μ_ij = a_ij/b_j, μ_ij + μ_ji = 1.
// The first guess is the polynomial through the stages of the last step. The iteration ends when no Y_i moves by more
// than a tolerance, or, to the floor, when the largest move, below 1e-12, has not become smaller.
#pragma once
#include "kernels.hpp"

struct GaussCoefficients {
  static constexpr int S = 8;
  typedef long double Real;
  // Column j of a matrix is the vector over i.
  alignas(64) double b[S], mu[S][S], nu[S][S];

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
    // Exact symplecticity: the small coefficient is the exact difference of 1 and the large one.
    for (int i = 0; i < S; ++i)
      for (int j = 0; j < i; ++j) mu[i][j] = 1 - mu[j][i];
    for (int i = 0; i < S; ++i) mu[i][i] = 0.5;
  }
};

// Eight numbers, one for each stage: a register of AVX-512, or two of AVX2.
struct Stages {
#ifdef __AVX512F__
  static constexpr int REGISTERS = 1;
#else
  static constexpr int REGISTERS = 2;
#endif
  static constexpr int LANES = GaussCoefficients::S / REGISTERS;
  typedef double Register __attribute__((vector_size(8 * LANES)));
  Register part[REGISTERS];

  static INLINE Stages load(const double *from) {
    Stages result;
    for (int n = 0; n < REGISTERS; ++n) result.part[n] = *reinterpret_cast<const Register *>(from + LANES * n);
    return result;
  }
  INLINE void store(double *to) const {
    for (int n = 0; n < REGISTERS; ++n) *reinterpret_cast<Register *>(to + LANES * n) = part[n];
  }
  static INLINE Stages all(double x) {
    Stages result;
    for (int n = 0; n < REGISTERS; ++n) result.part[n] = Register{} + x;
    return result;
  }
};

template <class F> INLINE Stages in_parts(F f) {
  Stages result;
  result.part[0] = f(0);
  if constexpr (Stages::REGISTERS > 1) result.part[1] = f(1);
  return result;
}
static INLINE Stages operator+(const Stages &a, const Stages &b) {
  return in_parts([&](int n) __attribute__((always_inline)) { return a.part[n] + b.part[n]; });
}
static INLINE Stages operator-(const Stages &a, const Stages &b) {
  return in_parts([&](int n) __attribute__((always_inline)) { return a.part[n] - b.part[n]; });
}
static INLINE Stages operator*(const Stages &a, const Stages &b) {
  return in_parts([&](int n) __attribute__((always_inline)) { return a.part[n] * b.part[n]; });
}
static INLINE Stages operator*(double a, const Stages &b) {
  return in_parts([&](int n) __attribute__((always_inline)) { return a * b.part[n]; });
}
static INLINE Stages magnitude(const Stages &a) {
  return in_parts([&](int n) __attribute__((always_inline)) { return a.part[n] > -a.part[n] ? a.part[n] : -a.part[n]; });
}
static INLINE Stages larger(const Stages &a, const Stages &b) {
  return in_parts([&](int n) __attribute__((always_inline)) {
    return (a.part[n] > b.part[n]) | (a.part[n] != a.part[n]) ? a.part[n] : b.part[n]; // keeps NaN
  });
}

struct Gauss16 {
  static constexpr int S = GaussCoefficients::S;

  Components<Stages>::Equations top;
  GaussCoefficients gauss;
  alignas(64) double L[6][S]; // the increments L_i of the last step, by component
  double tolerance;           // 0 iterates to the floor
  bool begun = false;

  Gauss16(const Top &top, double h, double tolerance) : top(top, h), tolerance(tolerance) {}

  // y + Σ_j M_ij L_j, as two sums of four products each, which wait for each other half as long.
  static INLINE Stages combined(const double (&columns)[S][S], const double *increments, double y) {
    Stages even = increments[0] * Stages::load(columns[0]) + Stages::all(y);
    Stages odd = increments[1] * Stages::load(columns[1]);
    unrolled<S / 2 - 1>([&](auto n) __attribute__((always_inline)) {
      constexpr int j = 2 * n + 2;
      even = increments[j] * Stages::load(columns[j]) + even;
      odd = increments[j + 1] * Stages::load(columns[j + 1]) + odd;
    });
    return even + odd;
  }

  // The largest number, or NaN.
  static INLINE double largest(const Stages &a) {
    alignas(64) double x[S];
    a.store(x);
    const auto two = [](double a, double b) __attribute__((always_inline)) { return a > b || a != a ? a : b; };
    return two(two(two(x[0], x[1]), two(x[2], x[3])), two(two(x[4], x[5]), two(x[6], x[7])));
  }

  INLINE bool step(Components<double> &y) {
    Components<Stages> Y;
    unrolled<6>([&](auto c) __attribute__((always_inline)) {
      Y.x[c] = begun ? combined(gauss.nu, L[c], y.x[c]) : Stages::all(y.x[c]);
    });
    begun = true;
    const Stages b = Stages::load(gauss.b);
    double before = INFINITY;
    for (int sweep = 0; sweep < 100; ++sweep) {
      const Components<Stages> f = top.derivative(Y);
      unrolled<6>([&](auto c) __attribute__((always_inline)) { (f.x[c] * b).store(L[c]); });
      Stages moved = Stages::all(0);
      unrolled<6>([&](auto c) __attribute__((always_inline)) {
        const Stages next = combined(gauss.mu, L[c], y.x[c]);
        moved = larger(magnitude(next - Y.x[c]), moved);
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
