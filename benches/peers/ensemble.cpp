// Measures an ensemble of tops on one thread, hand-written: a register of tops at a time, under DOP853's method of
// order 8 and the implicit midpoint rule on the six equations (not a Poisson map). Two registers, interleaved operation
// by operation, are slower: their stages do not fit the register file.
//
//     ensemble PROBLEM
#include "kernels.hpp"
#include <immintrin.h>

#ifdef __AVX512F__
typedef double Register __attribute__((vector_size(64)));
static INLINE bool all_below(Register a, double bound) { // false for NaN
  return _mm512_cmp_pd_mask(a, _mm512_set1_pd(bound), _CMP_LE_OQ) == 0xff;
}
#else
typedef double Register __attribute__((vector_size(32)));
static INLINE bool all_below(Register a, double bound) {
  return _mm256_movemask_pd(_mm256_cmp_pd(a, _mm256_set1_pd(bound), _CMP_LE_OQ)) == 0xf;
}
#endif
constexpr int WIDTH = sizeof(Register) / sizeof(double);
using Lanes = Components<Register>;

static INLINE bool all_within(const Lanes &a, const Lanes &b, double tolerance) {
  return all_below(square_distance(a, b), tolerance * tolerance);
}

template <class Method> __attribute__((noinline)) bool advance(Method &method, Lanes &state, long steps) {
  Lanes y = state;
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
      Lanes y;
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
  for (double h : {0.02, 0.025, 1.0 / 36, 1.0 / 32, 0.04, 0.05, 0.0625, 0.1, 10.0 / 96}) compete<RungeKutta8>("C++ SIMD RK8", problem, h);
  compete<ImplicitMidpoint>("C++ SIMD implicit midpoint", problem, 0.01);
}
