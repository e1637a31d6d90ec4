// The spherical midpoint method for the Heisenberg lattice by hand, and the memory bandwidth, in seconds.
//
//     lattice SIZE SWEEPS REPEATS
//
// Prints rows of a name and the least time: that of a triad a = b + s c over three arrays with as many numbers as the
// lattice has components of spins, and that of one sweep of a step of SWEEPS sweeps after the first guess, from spins
// as an array of vectors. The components are stored apart, and rows of midpoints are continued periodically. A sweep
// makes two passes: all midpoints, then all rates with their changes. Threads: OMP_NUM_THREADS.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>

#ifdef __AVX512F__
constexpr long LANES = 8;
#else
constexpr long LANES = 4;
#endif
typedef double Lanes __attribute__((vector_size(8 * LANES), aligned(8), may_alias));
constexpr long GHOST = 8;
constexpr double STEP = 0.05, FIELD[3] = {0.1, -0.2, 0.5};

static Lanes &at(double *p) { return *reinterpret_cast<Lanes *>(p); }
static Lanes all(double x) { return Lanes{} + x; }
static Lanes larger(Lanes a, Lanes b) { return a > b ? a : b; }
static Lanes magnitude(Lanes a) { return larger(a, -a); }
static Lanes root(Lanes a) {
  for (long lane = 0; lane < LANES; ++lane) a[lane] = std::sqrt(a[lane]);
  return a;
}

struct Numbers {
  std::unique_ptr<double, decltype(&std::free)> data;
  // Each thread writes first what it works on later.
  explicit Numbers(long count) : data(static_cast<double *>(std::aligned_alloc(64, (count * 8 + 63) / 64 * 64)), std::free) {
#pragma omp parallel for schedule(static)
    for (long i = 0; i < count; ++i) data.get()[i] = 0;
  }
  operator double *() const { return data.get(); }
};

template <class F> double least(int repeats, F f) {
  double best = 1e300;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const auto begin = std::chrono::steady_clock::now();
    f();
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  return best;
}

struct Lattice {
  long size, rows, count, width;
  Numbers spins, w[3], k[3], m[3];
  explicit Lattice(long size)
      : size(size), rows(size * size), count(size * rows), width(size + 2 * GHOST), spins(3 * count),
        w{Numbers(count), Numbers(count), Numbers(count)}, k{Numbers(count), Numbers(count), Numbers(count)},
        m{Numbers(rows * width), Numbers(rows * width), Numbers(rows * width)} {
    for (long i = 0; i < count; ++i) {
      const double t = i, x = std::sin(2.3 * t), y = std::cos(1.7 * t), z = std::sin(0.9 * t + 0.2);
      const double r = std::sqrt(x * x + y * y + z * z);
      spins[3 * i] = x / r, spins[3 * i + 1] = y / r, spins[3 * i + 2] = z / r;
    }
  }

  void begin() {
#pragma omp parallel for schedule(static)
    for (long i = 0; i < count; ++i)
      for (int c = 0; c < 3; ++c) w[c][i] = spins[3 * i + c], k[c][i] = 0;
  }

  void middles(double half) {
#pragma omp parallel for schedule(static)
    for (long row = 0; row < rows; ++row) {
      for (long x = 0; x < size; x += LANES) {
        const long i = size * row + x;
        Lanes u[3], ww = {}, uu = {};
        for (int c = 0; c < 3; ++c) {
          const Lanes start = at(w[c] + i);
          u[c] = start + all(half) * at(k[c] + i);
          ww += start * start, uu += u[c] * u[c];
        }
        const Lanes factor = root(ww / uu);
        for (int c = 0; c < 3; ++c) at(m[c] + row * width + GHOST + x) = u[c] * factor;
      }
      for (int c = 0; c < 3; ++c) {
        double *line = m[c] + row * width;
        line[GHOST - 1] = line[GHOST + size - 1], line[GHOST + size] = line[GHOST];
      }
    }
  }

  void rates(double &change, double &size_of_rates) {
    double most = 0, large = 0;
#pragma omp parallel for schedule(static) reduction(max : most, large)
    for (long row = 0; row < rows; ++row) {
      const long y = row % size, z = row / size, here = row * width + GHOST;
      const auto place = [&](long y, long z) { return ((y + size) % size + size * ((z + size) % size)) * width + GHOST; };
      const long near[4] = {place(y - 1, z), place(y + 1, z), place(y, z - 1), place(y, z + 1)};
      Lanes changes = {}, sizes = {};
      for (long x = 0; x < size; x += LANES) {
        Lanes h[3], s[3];
        for (int c = 0; c < 3; ++c) {
          double *line = m[c] + x;
          s[c] = at(line + here);
          h[c] = all(FIELD[c]) + (at(line + here - 1) + at(line + here + 1)) + (at(line + near[0]) + at(line + near[1])) +
                 (at(line + near[2]) + at(line + near[3]));
        }
        for (int c = 0; c < 3; ++c) {
          const int a = (c + 1) % 3, b = (c + 2) % 3;
          const Lanes rate = s[a] * h[b] - s[b] * h[a];
          Lanes &before = at(k[c] + size * row + x);
          changes = larger(magnitude(rate - before), changes), sizes = larger(magnitude(rate), sizes);
          before = rate;
        }
      }
      for (long lane = 0; lane < LANES; ++lane) most = std::max(most, changes[lane]), large = std::max(large, sizes[lane]);
    }
    change = most, size_of_rates = large;
  }
};

int main(int, char **words) {
  const long size = std::atol(words[1]);
  const int sweeps = std::atoi(words[2]), repeats = std::atoi(words[3]);
  Lattice lattice(size);
  const Numbers a(3 * lattice.count), b(3 * lattice.count), c(3 * lattice.count);
  const double triad = least(4 * repeats, [&] {
#pragma omp parallel for schedule(static)
    for (long i = 0; i < 3 * lattice.count; ++i) a[i] = b[i] + 1.5 * c[i];
  });
  std::printf("triad\t%.9e\n", triad);
  double change = 0, largest = 0;
  const double step = least(repeats, [&] {
    lattice.begin();
    for (int sweep = 0; sweep <= sweeps; ++sweep) {
      lattice.middles(sweep ? STEP / 2 : 0);
      lattice.rates(change, largest);
    }
  });
  std::printf("C++\t%.9e\n", step / (sweeps + 1));
  std::fprintf(stderr, "change %g of %g\n", change, largest);
}
