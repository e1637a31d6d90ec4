// Measures GSL's implicit midpoint rule, rk2imp, with a fixed step and the exact Jacobian, on one top. It makes two half
// steps besides each step, for its error estimate, and keeps their result: its error is that of h/2.
//
//     gsl PROBLEM
#include "problem.hpp"
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

static int derivative(double, const double *y, double *dy, void *top) {
  heavy_top(*static_cast<const Top *>(top), y, dy);
  return GSL_SUCCESS;
}

// Column m is f(y + e_m) − f(y), exactly: no term holds the square of a component.
static int jacobian(double, const double *y, double *columns, double *dt, void *top) {
  double f[6], moved[6], z[6];
  derivative(0, y, f, top);
  for (int m = 0; m < 6; ++m) {
    std::copy(y, y + 6, z);
    z[m] += 1;
    derivative(0, z, moved, top);
    for (int i = 0; i < 6; ++i) columns[6 * i + m] = moved[i] - f[i];
    dt[m] = 0;
  }
  return GSL_SUCCESS;
}

int main(int, char **arguments) {
  Problem problem = read_problem(arguments[1]);
  const double h = 0.01;
  gsl_odeiv2_system system = {derivative, jacobian, 6, &problem.top};
  contest("GSL rk2imp", "h = 0.01", problem, [&](std::vector<State> &states, double end) {
    // the driver's tolerance is what Newton's iterations stop at
    gsl_odeiv2_driver *driver = gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk2imp, h, 1e-13, 0);
    const long steps = std::lround(end / h);
    double error[6];
    for (long n = 0; n < steps; ++n)
      if (gsl_odeiv2_step_apply(driver->s, n * h, h, states[0].data(), error, nullptr, nullptr, &system) != GSL_SUCCESS)
        std::exit(1);
    gsl_odeiv2_driver_free(driver);
    return steps;
  });
}
