// Measures an ensemble of tops on one thread, hand-written: two registers of tops, interleaved operation by operation,
// under DOP853's method of order 8 and the implicit midpoint rule on the six equations (not a Poisson map).
//
//     ensemble PROBLEM
#include "kernels.hpp"

#ifdef __AVX512F__
constexpr int BYTES = 64;
#else
constexpr int BYTES = 32;
#endif
typedef double Register __attribute__((vector_size(BYTES)));
constexpr int REGISTERS = 2, WIDTH = REGISTERS * BYTES / 8;

struct Lanes {
  Register r[REGISTERS];

  INLINE Lanes() : r{} {}
  INLINE double &operator[](int lane) { return reinterpret_cast<double *>(r)[lane]; }
};
#define LANES_OPERATOR(OP)                                                                                             \
  INLINE Lanes operator OP(const Lanes &a, const Lanes &b) {                                                           \
    Lanes c;                                                                                                           \
    unrolled<REGISTERS>([&](auto i) __attribute__((always_inline)) { c.r[i] = a.r[i] OP b.r[i]; });                    \
    return c;                                                                                                          \
  }                                                                                                                    \
  INLINE Lanes operator OP(double a, const Lanes &b) {                                                                 \
    Lanes c;                                                                                                           \
    unrolled<REGISTERS>([&](auto i) __attribute__((always_inline)) { c.r[i] = a OP b.r[i]; });                         \
    return c;                                                                                                          \
  }
LANES_OPERATOR(+)
LANES_OPERATOR(-)
LANES_OPERATOR(*)
INLINE Lanes operator+(const Lanes &a, double b) { return b + a; }

static INLINE bool all_within(const State6<Lanes> &a, const State6<Lanes> &b, double tolerance) {
  typedef long Mask __attribute__((vector_size(BYTES)));
  Mask within = Mask{} - 1;
  unrolled<6>([&](auto i) __attribute__((always_inline)) {
    unrolled<REGISTERS>([&](auto j) __attribute__((always_inline)) {
      const Register difference = a.x[i].r[j] - b.x[i].r[j];
      within &= (difference <= tolerance) & (difference >= -tolerance); // false for NaN
    });
  });
  long all = -1;
  for (int lane = 0; lane < BYTES / 8; ++lane) all &= within[lane];
  return all;
}

template <class Method> __attribute__((noinline)) bool advance(Method &method, State6<Lanes> &state, long steps) {
  State6<Lanes> y = state;
  bool converged = true;
  for (long n = 0; n < steps; ++n) converged &= method.step(y);
  state = y;
  return converged;
}

template <template <class> class Method> void compete(const char *name, const Problem &problem, double h) {
  char setting[32];
  std::snprintf(setting, sizeof setting, "h = %g", h);
  contest(name, setting, problem, [&](std::vector<State> &states, double end) {
    const long steps = std::lround(end / h);
    for (size_t first = 0; first < states.size(); first += WIDTH) {
      const auto top = [&](int lane) -> State & { return states[std::min(first + lane, states.size() - 1)]; };
      State6<Lanes> y;
      for (int i = 0; i < 6; ++i)
        for (int lane = 0; lane < WIDTH; ++lane)
          y.x[i][lane] = top(lane)[i] * (i < 3 ? h / problem.top.inertia[i] : 1);
      Method<Lanes> method(problem.top, h);
      if (!advance(method, y, steps)) std::exit(1);
      for (int i = 0; i < 6; ++i)
        for (int lane = 0; lane < WIDTH; ++lane)
          top(lane)[i] = y.x[i][lane] * (i < 3 ? problem.top.inertia[i] / h : 1);
    }
    return steps;
  });
}

int main(int, char **arguments) {
  const Problem problem = read_problem(arguments[1]);
  for (double h : {0.02, 0.025, 0.04, 0.05, 0.0625, 0.1}) compete<RungeKutta8>("C++ SIMD RK8", problem, h);
  compete<ImplicitMidpoint>("C++ SIMD implicit midpoint", problem, 0.01);
}
