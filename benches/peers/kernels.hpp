// RK4, DOP853's method of order 8 with fixed steps, and the implicit midpoint rule on the six equations of the heavy
// top, written by hand over a number type V: double, or registers of tops.
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

template <class V> struct State6 {
  V x[6];
};

// The equations' coefficients, known at run time only.
struct ScaledTop {
  double euler[3], gravity[3][2];

  ScaledTop(const Top &top, double h) {
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      euler[i] = (top.inertia[j] - top.inertia[k]) / top.inertia[i];
      gravity[i][0] = h * h / top.inertia[i] * top.gravity[k];
      gravity[i][1] = h * h / top.inertia[i] * top.gravity[j];
    }
  }

  template <class V> INLINE State6<V> derivative(const State6<V> &y) const {
    State6<V> d;
    unrolled<3>([&](auto i) __attribute__((always_inline)) {
      constexpr int j = (i + 1) % 3, k = (i + 2) % 3;
      d.x[i] = euler[i] * y.x[j] * y.x[k] + (gravity[i][0] * y.x[3 + j] - gravity[i][1] * y.x[3 + k]);
      d.x[3 + i] = y.x[3 + j] * y.x[k] - y.x[3 + k] * y.x[j];
    });
    return d;
  }
};

template <class V> INLINE State6<V> axpy(double a, const State6<V> &x, const State6<V> &y) {
  State6<V> z;
  unrolled<6>([&](auto i) __attribute__((always_inline)) { z.x[i] = a * x.x[i] + y.x[i]; });
  return z;
}

template <class V> struct RungeKutta4 {
  ScaledTop top;
  RungeKutta4(const Top &top, double h) : top(top, h) {}

  INLINE bool step(State6<V> &y) {
    const State6<V> k1 = top.derivative(y), k2 = top.derivative(axpy(0.5, k1, y));
    const State6<V> k3 = top.derivative(axpy(0.5, k2, y)), k4 = top.derivative(axpy(1.0, k3, y));
    // y + (k1 + 2k2 + 2k3 + k4)/6; what comes last is added last, to keep it off the critical path
    y = axpy(1.0 / 6, k4, axpy(1.0 / 3, k3, axpy(1.0 / 3, k2, axpy(1.0 / 6, k1, y))));
    return true;
  }
};

template <class V> struct RungeKutta8 {
  ScaledTop top;
  RungeKutta8(const Top &top, double h) : top(top, h) {}

  // y + Σ_j a_{Ij} k_j without the zeros, the newest k last
  template <int I, int J> static INLINE void add(const State6<V> *k, State6<V> &sum) {
    if constexpr (dop853::A[I][J] != 0) sum = axpy(dop853::A[I][J], k[J], sum);
  }
  template <int I, int... J>
  static INLINE State6<V> stage([[maybe_unused]] const State6<V> *k, const State6<V> &y, std::integer_sequence<int, J...>) {
    State6<V> sum = y;
    (add<I, J>(k, sum), ...);
    return sum;
  }
  template <int... I> INLINE void stages(State6<V> *k, const State6<V> &y, std::integer_sequence<int, I...>) {
    ((k[I] = top.derivative(stage<I>(k, y, std::make_integer_sequence<int, I>()))), ...);
  }

  INLINE bool step(State6<V> &y) {
    State6<V> k[12];
    stages(k, y, std::make_integer_sequence<int, 12>());
    y = stage<12>(k, y, std::make_integer_sequence<int, 12>());
    return true;
  }
};

// The implicit midpoint rule, m = y + f(m)/2, y ← 2m − y. The first guess extrapolates f from the last
// eleven steps with a polynomial of degree 10; fixed point iterations go on until m moves by less than three units in
// the last place of 1/2 (|Γ| = 1), a tolerance at which no change of an invariant beyond round-off is seen.
template <class V> struct ImplicitMidpoint {
  static constexpr int DEPTH = 11;
  static constexpr double TOLERANCE = 3e-16;
  // Of the value j steps after the oldest of them, in the prediction one step after the newest.
  static constexpr double weight(int j) {
    double binomial = 1;
    for (int i = 0; i < j; ++i) binomial = binomial * (DEPTH - i) / (i + 1);
    return (DEPTH - j) % 2 ? binomial : -binomial;
  }
  ScaledTop top;
  State6<V> history[2 * DEPTH]; // f at n and n + DEPTH: a window without wrapping
  int oldest = -1;

  ImplicitMidpoint(const Top &top, double h) : top(top, h) {}

  INLINE bool step(State6<V> &y) {
    if (oldest < 0) {
      for (State6<V> &f : history) f = top.derivative(y);
      oldest = 0;
    }
    const State6<V> *window = history + oldest;
    State6<V> m = y, f;
    unrolled<DEPTH>([&](auto j) __attribute__((always_inline)) { m = axpy(weight(j) / 2, window[j], m); });
    bool converged = false;
    for (int iteration = 0; iteration < 50 && !converged; ++iteration) {
      f = top.derivative(m);
      const State6<V> next = axpy(0.5, f, y);
      converged = all_within(next, m, TOLERANCE);
      m = next;
    }
    history[oldest] = history[oldest + DEPTH] = f;
    oldest = (oldest + 1) % DEPTH;
    y = axpy(1.0, f, y);
    return converged;
  }
};
