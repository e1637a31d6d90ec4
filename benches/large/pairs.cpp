// The interactions of each two of many vortices alone, by hand: Σ_j m_j/(1 − x_i·x_j) over all j, in seconds.
//
//     pairs COUNT REPEATS
//
// Prints a row of a name and the least time. COUNT is a multiple of 16. Threads: OMP_NUM_THREADS.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#ifdef __AVX512F__
constexpr long LANES = 8, REGISTERS = 2;
#else
constexpr long LANES = 4, REGISTERS = 2;
#endif
typedef double Lanes __attribute__((vector_size(8 * LANES), aligned(8), may_alias));

static Lanes load(const double *p) { return *reinterpret_cast<const Lanes *>(p); }

int main(int, char **words) {
  const long count = std::atol(words[1]);
  const int repeats = std::atoi(words[2]);
  std::vector<double> x(count), y(count), z(count), rows(6 * count), sums(3 * count);
  for (long i = 0; i < count; ++i) {
    const double h = 1 - (2 * i + 1.0) / count, angle = 2.399963 * i, r = std::sqrt(1 - h * h);
    // A little inside the sphere, so that the term of a vortex with itself is a number.
    x[i] = 0.999 * r * std::cos(angle), y[i] = 0.999 * r * std::sin(angle), z[i] = 0.999 * h;
    const double k = i % 3 ? 1 : -0.5, row[6] = {x[i], y[i], z[i], k * x[i], k * y[i], k * z[i]};
    std::copy(row, row + 6, &rows[6 * i]);
  }
  double best = 1e300;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const auto begin = std::chrono::steady_clock::now();
#pragma omp parallel for schedule(dynamic, 8)
    for (long first = 0; first < count; first += LANES * REGISTERS) {
      Lanes at[REGISTERS][3], sum[REGISTERS][3] = {};
      for (long r = 0; r < REGISTERS; ++r) {
        const long i = first + LANES * r;
        at[r][0] = load(&x[i]), at[r][1] = load(&y[i]), at[r][2] = load(&z[i]);
      }
      for (long j = 0; j < count; ++j) {
        const double *p = &rows[6 * j];
        for (long r = 0; r < REGISTERS; ++r) {
          const Lanes inverse = 1 / (1 - at[r][0] * p[0] - at[r][1] * p[1] - at[r][2] * p[2]);
          for (int c = 0; c < 3; ++c) sum[r][c] += inverse * p[3 + c];
        }
      }
      for (long r = 0; r < REGISTERS; ++r)
        for (int c = 0; c < 3; ++c)
          for (long lane = 0; lane < LANES; ++lane) sums[3 * (first + LANES * r + lane) + c] = sum[r][c][lane];
    }
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  std::printf("C++ pairs\t%.9e\n", best);
  double total = 0;
  for (double s : sums) total += s;
  std::fprintf(stderr, "total %g\n", total);
}
