// Measures Boost.odeint on one top: RK4 with a fixed step, Dormand–Prince 5(4) and Fehlberg 7(8) with step control.
//
//     odeint PROBLEM
#include "problem.hpp"
#include <boost/numeric/odeint.hpp>

namespace odeint = boost::numeric::odeint;

int main(int, char **arguments) {
  const Problem problem = read_problem(arguments[1]);
  const Top top = problem.top;
  const auto system = [top](const State &y, State &dy, double) { heavy_top(top, y.data(), dy.data()); };

  contest("Boost.odeint RK4", "h = 0.01", problem, [&](std::vector<State> &states, double end) {
    const long steps = std::lround(end / 0.01);
    odeint::integrate_n_steps(odeint::runge_kutta4<State>(), system, states[0], 0.0, 0.01, steps);
    return steps;
  });
  const auto controlled = [&](const char *name, auto stepper) {
    for (double tolerance : {1e-9, 1e-13}) {
      char setting[32];
      std::snprintf(setting, sizeof setting, "tolerance %g", tolerance);
      contest(name, setting, problem, [&](std::vector<State> &states, double end) {
        return long(odeint::integrate_adaptive(odeint::make_controlled(tolerance, tolerance, stepper), system,
                                               states[0], 0.0, end, 0.01));
      });
    }
  };
  controlled("Boost.odeint Dormand–Prince 5", odeint::runge_kutta_dopri5<State>());
  controlled("Boost.odeint Fehlberg 7(8)", odeint::runge_kutta_fehlberg78<State>());
}
