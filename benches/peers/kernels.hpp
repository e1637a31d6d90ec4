// RK4, DOP853's method of order 8 with fixed steps, and the implicit midpoint rule on the six equations of the heavy
// top, written by hand over the type S of the state (w, Γ): `Components` below, or one of the program's own.
//
// Time is measured in steps and the state is (w, Γ) with w = h I⁻¹Π, which saves the multiplications by h and by I⁻¹.
// The methods commute with linear maps, so their steps are the same:
//     w1' = ((I2 − I3)/I1) w2 w3 + (h²/I1)(Γ2 γ3 − Γ3 γ2),   Γ1' = Γ2 w3 − Γ3 w2,   and cyclically.
#pragma once
#include "dop853.hpp"
#include "problem.hpp"
#include <utility>

#define INLINE inline __attribute__((always_inline))

// f(0), …, f(N − 1) without a loop: the compiler keeps arrays in registers only if it unrolls them early.
template <int N, class F> INLINE void unrolled(F f) {
  [&]<int... I>(std::integer_sequence<int, I...>) __attribute__((always_inline)) {
    (f(std::integral_constant<int, I>()), ...);
  }(std::make_integer_sequence<int, N>());
}

// The coefficients, known at run time only: those of w2 w3, of Γ2 and of −Γ3 in w1', and so on.
struct Coefficients {
  double euler[3], gravity[3][2];

  Coefficients(const Top &top, double h) {
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      euler[i] = (top.inertia[j] - top.inertia[k]) / top.inertia[i];
      gravity[i][0] = h * h / top.inertia[i] * top.gravity[k];
      gravity[i][1] = h * h / top.inertia[i] * top.gravity[j];
    }
  }
};

// The six components of (w, Γ), each a number or registers of tops.
template <class V> struct Components {
  V x[6];

  struct Equations : Coefficients {
    using Coefficients::Coefficients;

    INLINE Components derivative(const Components &y) const {
      Components d;
      unrolled<3>([&](auto i) __attribute__((always_inline)) {
        constexpr int j = (i + 1) % 3, k = (i + 2) % 3;
        d.x[i] = euler[i] * y.x[j] * y.x[k] + (gravity[i][0] * y.x[3 + j] - gravity[i][1] * y.x[3 + k]);
        d.x[3 + i] = y.x[3 + j] * y.x[k] - y.x[3 + k] * y.x[j];
      });
      return d;
    }
  };
};

template <class V> INLINE Components<V> axpy(double a, const Components<V> &x, const Components<V> &y) {
  Components<V> z;
  unrolled<6>([&](auto i) __attribute__((always_inline)) { z.x[i] = a * x.x[i] + y.x[i]; });
  return z;
}

template <class V> INLINE V square_distance(const Components<V> &a, const Components<V> &b) {
  V sum{};
  unrolled<6>([&](auto i) __attribute__((always_inline)) { sum = (a.x[i] - b.x[i]) * (a.x[i] - b.x[i]) + sum; });
  return sum;
}

template <class S> struct RungeKutta4 {
  typename S::Equations top;
  RungeKutta4(const Top &top, double h) : top(top, h) {}

  INLINE bool step(S &y) {
    const S k1 = top.derivative(y), k2 = top.derivative(axpy(0.5, k1, y));
    const S k3 = top.derivative(axpy(0.5, k2, y)), k4 = top.derivative(axpy(1.0, k3, y));
    // y + (k1 + 2k2 + 2k3 + k4)/6; what comes last is added last, to keep it off the critical path
    y = axpy(1.0 / 6, k4, axpy(1.0 / 3, k3, axpy(1.0 / 3, k2, axpy(1.0 / 6, k1, y))));
    return true;
  }
};

template <class S> struct RungeKutta8 {
  typename S::Equations top;
  RungeKutta8(const Top &top, double h) : top(top, h) {}

  // y + Σ_j a_{Ij} k_j without the zeros, the newest k last
  template <int I, int J> static INLINE void add(const S *k, S &sum) {
    if constexpr (dop853::A[I][J] != 0) sum = axpy(dop853::A[I][J], k[J], sum);
  }
  template <int I, int... J>
  static INLINE S stage([[maybe_unused]] const S *k, const S &y, std::integer_sequence<int, J...>) {
    S sum = y;
    (add<I, J>(k, sum), ...);
    return sum;
  }
  template <int... I> INLINE void stages(S *k, const S &y, std::integer_sequence<int, I...>) {
    ((k[I] = top.derivative(stage<I>(k, y, std::make_integer_sequence<int, I>()))), ...);
  }

  INLINE bool step(S &y) {
    S k[12];
    stages(k, y, std::make_integer_sequence<int, 12>());
    y = stage<12>(k, y, std::make_integer_sequence<int, 12>());
    return true;
  }
};

// The implicit midpoint rule, m = y + f(m)/2, y ← 2m − y. The first guess extrapolates f from the last
// eleven steps with a polynomial of degree 10; fixed point iterations go on until m moves by less than three units in
// the last place of 1/2 (|Γ| = 1), a tolerance at which no change of an invariant beyond round-off is seen.
template <class S> struct ImplicitMidpoint {
  static constexpr int DEPTH = 11;
  static constexpr double TOLERANCE = 3e-16;
  // Of the value j steps after the oldest of them, in the prediction one step after the newest.
  static constexpr double weight(int j) {
    double binomial = 1;
    for (int i = 0; i < j; ++i) binomial = binomial * (DEPTH - i) / (i + 1);
    return (DEPTH - j) % 2 ? binomial : -binomial;
  }
  typename S::Equations top;
  S history[2 * DEPTH]; // f at n and n + DEPTH: a window without wrapping
  int oldest = -1;

  ImplicitMidpoint(const Top &top, double h) : top(top, h) {}

  INLINE bool step(S &y) {
    if (oldest < 0) {
      for (S &f : history) f = top.derivative(y);
      oldest = 0;
    }
    const S *window = history + oldest;
    S m = y, f;
    unrolled<DEPTH>([&](auto j) __attribute__((always_inline)) { m = axpy(weight(j) / 2, window[j], m); });
    bool converged = false;
    for (int iteration = 0; iteration < 50 && !converged; ++iteration) {
      f = top.derivative(m);
      const S next = axpy(0.5, f, y);
      converged = all_within(next, m, TOLERANCE);
      m = next;
    }
    history[oldest] = history[oldest + DEPTH] = f;
    oldest = (oldest + 1) % DEPTH;
    y = axpy(1.0, f, y);
    return converged;
  }
};
