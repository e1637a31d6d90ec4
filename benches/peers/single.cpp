// Measures one top from t = 0 to the problem's end with hand-written fixed-step methods: RK4, DOP853's method of
// order 8 and the implicit midpoint rule on the six equations (not a Poisson map).
//
//     single PROBLEM
#include "kernels.hpp"

static INLINE bool all_within(const State6<double> &a, const State6<double> &b, double tolerance) {
  double largest[3];
  for (int i = 0; i < 3; ++i) largest[i] = std::max(std::fabs(a.x[i] - b.x[i]), std::fabs(a.x[i + 3] - b.x[i + 3]));
  return std::max(std::max(largest[0], largest[1]), largest[2]) <= tolerance;
}

template <class Method> __attribute__((noinline)) bool advance(Method &method, State6<double> &state, long steps) {
  State6<double> y = state;
  bool converged = true;
  for (long n = 0; n < steps; ++n) converged &= method.step(y);
  state = y;
  return converged;
}

template <template <class> class Method>
void compete(const char *name, const Problem &problem, double h) {
  char setting[32];
  std::snprintf(setting, sizeof setting, "h = %g", h);
  contest(name, setting, problem, [&](std::vector<State> &states, double end) {
    const long steps = std::lround(end / h);
    const double *inertia = problem.top.inertia;
    State6<double> y;
    for (int i = 0; i < 6; ++i) y.x[i] = i < 3 ? states[0][i] * h / inertia[i] : states[0][i];
    Method<double> method(problem.top, h);
    if (!advance(method, y, steps)) std::exit(1);
    for (int i = 0; i < 6; ++i) states[0][i] = i < 3 ? y.x[i] * inertia[i] / h : y.x[i];
    return steps;
  });
}

int main(int, char **arguments) {
  const Problem problem = read_problem(arguments[1]);
  compete<RungeKutta4>("C++ RK4", problem, 0.01);
  for (double h : {0.025, 0.05}) compete<RungeKutta8>("C++ RK8", problem, h);
  compete<ImplicitMidpoint>("C++ implicit midpoint", problem, 0.01);
}
