// Measures one top from t = 0 to the problem's end with hand-written fixed-step methods: RK4, DOP853's method of
// order 8, the Gauss method of order 16 and the implicit midpoint rule on the six equations (not Poisson maps). The second
// and the last also with w and Γ in a register each ("vectors"); RK4, bound by latency, gains nothing from that.
//
//     single PROBLEM
#include "irkgl.hpp"
#include "kernels.hpp"
#include <immintrin.h>

using Scalars = Components<double>;

static INLINE bool all_within(const Scalars &a, const Scalars &b, double tolerance) {
  return square_distance(a, b) <= tolerance * tolerance;
}

// w and Γ in a register each, the fourth lane zero.
struct Vectors {
  typedef double Register __attribute__((vector_size(32)));
  Register w, g;

  struct Equations {
    Register euler{}, gravity[2]{};

    Equations(const Top &top, double h) {
      const Coefficients coefficients(top, h);
      for (int i = 0; i < 3; ++i) {
        euler[i] = coefficients.euler[i];
        for (int j : {0, 1}) gravity[j][i] = coefficients.gravity[i][j];
      }
    }

    static INLINE Register next(Register x) { return _mm256_permute4x64_pd(x, 0b11001001); }     // x2 x3 x1
    static INLINE Register previous(Register x) { return _mm256_permute4x64_pd(x, 0b11010010); } // x3 x1 x2

    INLINE Vectors derivative(const Vectors &y) const {
      const Register w2 = next(y.w), w3 = previous(y.w), g2 = next(y.g), g3 = previous(y.g);
      return {(euler * w2) * w3 + (gravity[0] * g2 - gravity[1] * g3), g2 * w3 - g3 * w2};
    }
  };
};

static INLINE Vectors axpy(double a, const Vectors &x, const Vectors &y) { return {a * x.w + y.w, a * x.g + y.g}; }

static INLINE bool all_within(const Vectors &a, const Vectors &b, double tolerance) {
  const Vectors::Register w = a.w - b.w, g = a.g - b.g, squares = w * w + g * g;
  const auto below = squares <= tolerance * tolerance; // false for NaN
  return _mm256_movemask_pd(reinterpret_cast<__m256d>(below)) == 0b1111;
}

static INLINE void set(Scalars &y, int i, double value) { y.x[i] = value; }
static INLINE void set(Vectors &y, int i, double value) { (i < 3 ? y.w : y.g)[i % 3] = value; }
static INLINE double get(const Scalars &y, int i) { return y.x[i]; }
static INLINE double get(const Vectors &y, int i) { return (i < 3 ? y.w : y.g)[i % 3]; }

template <class Method, class S> __attribute__((noinline)) bool advance(Method &method, S &state, long steps) {
  S y = state;
  bool converged = true;
  for (long n = 0; n < steps; ++n) converged &= method.step(y);
  state = y;
  return converged;
}

template <class Method, class S> void compete_with(const char *name, const Problem &problem, double h) {
  char setting[32];
  std::snprintf(setting, sizeof setting, "h = %g", h);
  contest(name, setting, problem, [&](std::vector<State> &states, double end) {
    const long steps = std::lround(end / h);
    const double *inertia = problem.top.inertia;
    S y{};
    for (int i = 0; i < 6; ++i) set(y, i, states[0][i] * (i < 3 ? h / inertia[i] : 1));
    Method method(problem.top, h);
    if (!advance(method, y, steps)) std::exit(1);
    for (int i = 0; i < 6; ++i) states[0][i] = get(y, i) * (i < 3 ? inertia[i] / h : 1);
    return steps;
  });
}

template <template <class> class Method, class S> void compete(const char *name, const Problem &problem, double h) {
  compete_with<Method<S>, S>(name, problem, h);
}

int main(int, char **arguments) {
  const Problem problem = read_problem(arguments[1]);
  for (double h : {0.0025, 0.01, 0.04}) compete<RungeKutta4, Scalars>("C++ RK4", problem, h);
  for (double h : {0.025, 0.05, 0.1}) compete<RungeKutta8, Scalars>("C++ RK8", problem, h);
  for (double h : {0.025, 0.05, 0.1}) compete<RungeKutta8, Vectors>("C++ RK8, vectors", problem, h);
  for (double h : {0.4, 1 / 3.0, 2 / 7.0, 0.25}) {
    compete_with<Gauss16WithTolerance, Scalars>("C++ IRKGL16", problem, h);
    compete_with<Gauss16ToTheFloor, Scalars>("C++ IRKGL16, to the floor", problem, h);
  }
  compete<ImplicitMidpoint, Scalars>("C++ implicit midpoint", problem, 0.01);
  compete<ImplicitMidpoint, Vectors>("C++ implicit midpoint, vectors", problem, 0.01);
}
