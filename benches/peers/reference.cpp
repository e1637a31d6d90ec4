// Measures nothing: writes a problem file with reference solutions, by Taylor's method of order 40 in
// quadruple precision for one top (24 in extended precision for an ensemble, where 10⁴ tops must be solved).
// Each is solved with two step sizes; if they differ by more than `TOLERANCE`, in the mean over the tops, the program
// fails. (Of 10⁴ tops a few are close to a separatrix, where round-off grows a thousandfold.)
//
//     reference I1 I2 I3 mgl c1 c2 c3 end tops
//
// One top starts at Π = (2, 3, 4), Γ = (1/2, 0, √3/2). In an ensemble each component of Π is moved by up to 1/2 and
// Γ is uniform on the sphere.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

constexpr double TOLERANCE = 1e-15;

template <class R> struct Top {
  R inertia[3], gravity[3];
};

// One step: the coefficients of the solution's Taylor series from the recurrence of the (quadratic) equations.
template <class R, int ORDER> void taylor_step(const Top<R> &top, R y[6], R h) {
  R c[6][ORDER + 1], w[3][ORDER + 1];
  for (int i = 0; i < 6; ++i) c[i][0] = y[i];
  for (int n = 0; n < ORDER; ++n) {
    for (int i = 0; i < 3; ++i) w[i][n] = c[i][n] / top.inertia[i];
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      R momentum = c[3 + j][n] * top.gravity[k] - c[3 + k][n] * top.gravity[j], vertical = 0;
      for (int m = 0; m <= n; ++m) {
        momentum += c[j][m] * w[k][n - m] - c[k][m] * w[j][n - m];
        vertical += c[3 + j][m] * w[k][n - m] - c[3 + k][m] * w[j][n - m];
      }
      c[i][n + 1] = momentum / (n + 1);
      c[3 + i][n + 1] = vertical / (n + 1);
    }
  }
  for (int i = 0; i < 6; ++i) {
    R sum = c[i][ORDER];
    for (int n = ORDER; n-- > 0;) sum = sum * h + c[i][n];
    y[i] = sum;
  }
}

template <class R, int ORDER> void solve(const Top<R> &top, const R start[6], R end, long steps, R y[6]) {
  for (int i = 0; i < 6; ++i) y[i] = start[i];
  for (long n = 0; n < steps; ++n) taylor_step<R, ORDER>(top, y, end / steps);
}

double uniform() { // in [-1, 1), splitmix64
  static uint64_t state = 1;
  uint64_t z = (state += 0x9e3779b97f4a7c15);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return double((z ^ (z >> 31)) >> 11) * 0x1p-52 - 1;
}

void choose_start(bool single, double start[6]) {
  double vertical[3] = {0.5, 0, std::sqrt(0.75)}, square = 1;
  if (!single)
    do {
      square = 0;
      for (double &x : vertical) x = uniform(), square += x * x;
    } while (square > 1 || square < 0.01);
  for (int i = 0; i < 3; ++i) {
    start[i] = 2 + i + (single ? 0 : 0.5 * uniform());
    start[3 + i] = vertical[i] / std::sqrt(square);
  }
}

template <class R, int ORDER> void write_problem(char **arguments) {
  Top<R> top;
  for (int i = 0; i < 3; ++i) top.inertia[i] = std::atof(arguments[1 + i]);
  for (int i = 0; i < 3; ++i) top.gravity[i] = R(std::atof(arguments[4])) * std::atof(arguments[5 + i]);
  for (int i = 1; i <= 8; ++i) std::printf("%s%c", arguments[i], i < 8 ? ' ' : '\n');

  const double times[2] = {10, std::atof(arguments[8])};
  const long tops = std::atol(arguments[9]);
  R sum = 0;
  for (long n = 0; n < tops; ++n) {
    double start[6];
    choose_start(tops == 1, start);
    R from[6], coarse[6], fine[6];
    for (int i = 0; i < 6; ++i) std::printf("%.17g ", start[i]), from[i] = start[i];
    R largest = 0;
    for (double time : times) {
      solve<R, ORDER>(top, from, R(time), long(time * 16), coarse);
      solve<R, ORDER>(top, from, R(time), long(time * 20), fine);
      for (int i = 0; i < 6; ++i) {
        const R difference = coarse[i] > fine[i] ? coarse[i] - fine[i] : fine[i] - coarse[i];
        if (!(difference <= largest)) largest = difference; // NaN too
        std::printf("%.17g ", double(fine[i]));
      }
    }
    sum += largest;
    std::printf("\n");
  }
  const double mean = double(sum / tops);
  std::fprintf(stderr, "%ld tops to t = %g: two step sizes differ by %.1e\n", tops, times[1], mean);
  if (!(mean <= TOLERANCE)) std::exit(1);
}

int main(int count, char **arguments) {
  if (count != 10) {
    std::fprintf(stderr, "reference I1 I2 I3 mgl c1 c2 c3 end tops\n");
    return 2;
  }
  if (std::atol(arguments[9]) == 1) write_problem<__float128, 40>(arguments);
  else write_problem<long double, 24>(arguments);
}
