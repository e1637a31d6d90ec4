// Measures the splitting of order 4 of S. Blanes & P. C. Moan (J. Comput. Appl. Math. 142 (2002), Table 3, SRKN6b) on one
// symmetric top, I1 = I2, written by hand: kicks by the weight, and the exact flow of the free symmetric top.
//
//     splitting PROBLEM [STEPS]     with STEPS it only makes these steps of 1/5, so that their instructions can be counted
#include "kernels.hpp"

namespace blanes_moan {
constexpr double A1 = 0.245298957184271, A2 = 0.60487266571108, A3 = 0.5 - A1 - A2;
constexpr double B1 = 0.0829844064174052, B2 = 0.396309801498368, B3 = -0.0390563049223486;
constexpr double B4 = 1 - 2 * (B1 + B2 + B3);
constexpr double A[6] = {A1, A2, A3, A3, A2, A1}, B[7] = {B1, B2, B3, B4, B3, B2, B1};
} // namespace blanes_moan

struct SymmetricTopSplitting {
  double half_turn[6]; // of −ah/(2 I1), which times |Π| is half an angle
  double axial[6];     // of −ah (1/I3 − 1/I1), which times Π3 is an angle
  double force[7][3];  // bhγ

  SymmetricTopSplitting(const Top &top, double h) {
    for (int i = 0; i < 6; ++i) {
      half_turn[i] = -blanes_moan::A[i] * h / (2 * top.inertia[0]);
      axial[i] = -blanes_moan::A[i] * h * (1 / top.inertia[2] - 1 / top.inertia[0]);
    }
    for (int i = 0; i < 7; ++i)
      for (int j = 0; j < 3; ++j) force[i][j] = blanes_moan::B[i] * h * top.gravity[j];
  }

  // Π ← Π + Γ × bhγ
  INLINE void kick(double *pi, const double *gamma, int i) const {
    const double *f = force[i];
    pi[0] += gamma[1] * f[2] - gamma[2] * f[1];
    pi[1] += gamma[2] * f[0] - gamma[0] * f[2];
    pi[2] += gamma[0] * f[1] - gamma[1] * f[0];
  }

  static INLINE void turn(double *v, double cos, double sin) {
    const double x = cos * v[0] - sin * v[1];
    v[1] = sin * v[0] + cos * v[1];
    v[0] = x;
  }

  // Γ turns about Π, then Π and Γ turn about e3.
  INLINE void drift(double *pi, double *gamma, int i) const {
    const double square = pi[0] * pi[0] + pi[1] * pi[1] + pi[2] * pi[2];
    const double length = std::sqrt(square), angle = half_turn[i] * length;
    // the quaternion (c, s Π) of the rotation
    const double c = std::cos(angle), s = length > 0 ? std::sin(angle) / length : half_turn[i];
    const double q[3] = {s * pi[0], s * pi[1], s * pi[2]};
    double t[3]; // 2 q × Γ
    for (int j = 0; j < 3; ++j) {
      const int k = (j + 1) % 3, l = (j + 2) % 3;
      t[j] = 2 * (q[k] * gamma[l] - q[l] * gamma[k]);
    }
    for (int j = 0; j < 3; ++j) {
      const int k = (j + 1) % 3, l = (j + 2) % 3;
      gamma[j] += c * t[j] + (q[k] * t[l] - q[l] * t[k]);
    }
    const double about_axis = axial[i] * pi[2], cos = std::cos(about_axis), sin = std::sin(about_axis);
    turn(pi, cos, sin);
    turn(gamma, cos, sin);
  }

  INLINE void step(double *pi, double *gamma) const {
    unrolled<6>([&](auto i) __attribute__((always_inline)) {
      kick(pi, gamma, i);
      drift(pi, gamma, i);
    });
    kick(pi, gamma, 6);
  }
};

static __attribute__((noinline)) void advance(const SymmetricTopSplitting &splitting, State &state, long steps) {
  double pi[3] = {state[0], state[1], state[2]}, gamma[3] = {state[3], state[4], state[5]};
  for (long n = 0; n < steps; ++n) splitting.step(pi, gamma);
  state = {pi[0], pi[1], pi[2], gamma[0], gamma[1], gamma[2]};
}

int main(int count, char **arguments) {
  Problem problem = read_problem(arguments[1]);
  if (problem.top.inertia[0] != problem.top.inertia[1]) return 0;
  if (count > 2) {
    advance(SymmetricTopSplitting(problem.top, 0.2), problem.start[0], std::atol(arguments[2]));
    return std::isnan(problem.start[0][0]);
  }
  for (double h : {0.2, 0.05}) {
    char setting[32];
    std::snprintf(setting, sizeof setting, "h = %g", h);
    contest("C++ splitting of order 4", setting, problem, [&](std::vector<State> &states, double end) {
      const long steps = std::lround(end / h);
      advance(SymmetricTopSplitting(problem.top, h), states[0], steps);
      return steps;
    });
  }
}
