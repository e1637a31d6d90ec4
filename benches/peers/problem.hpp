// What every contestant in C++ shares: the problem read from a file (so that nothing about the top is
// known at compile time), the clock, and the line of JSON on standard output.
//
// A problem file (written by reference.cpp) holds, on its first line,
//     I1 I2 I3 mgl c1 c2 c3 end
// and on each further line one top: its state (Π, Γ) at times 0, 10 and end.
#pragma once
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

using State = std::array<double, 6>; // Π, Γ

struct Top {
  double inertia[3];
  double gravity[3]; // γ = mgl c
};

struct Problem {
  Top top;
  double end;
  std::vector<State> start, at_10, at_end;
};

inline Problem read_problem(const char *path) {
  std::ifstream file(path);
  Problem problem;
  double mgl, c[3];
  for (double &x : problem.top.inertia) file >> x;
  file >> mgl >> c[0] >> c[1] >> c[2] >> problem.end;
  for (int i = 0; i < 3; ++i) problem.top.gravity[i] = mgl * c[i];
  const auto read = [&](State &state) {
    for (double &x : state) file >> x;
  };
  for (State a, b, c;;) {
    read(a), read(b), read(c);
    if (!file) break;
    problem.start.push_back(a), problem.at_10.push_back(b), problem.at_end.push_back(c);
  }
  if (problem.start.empty()) {
    std::fprintf(stderr, "no top in %s\n", path);
    std::exit(1);
  }
  return problem;
}

// Π' = Π×Ω + Γ×γ, Γ' = Γ×Ω with Ω = I⁻¹Π, as a user of a library would write it.
inline void heavy_top(const Top &top, const double *y, double *dy) {
  const double *g = top.gravity;
  const double w[3] = {y[0] / top.inertia[0], y[1] / top.inertia[1], y[2] / top.inertia[2]};
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    dy[i] = y[j] * w[k] - y[k] * w[j] + y[3 + j] * g[k] - y[3 + k] * g[j];
    dy[3 + i] = y[3 + j] * w[k] - y[3 + k] * w[j];
  }
}

// The arithmetic mean over the tops of the 2-norm of the state's error. NaN stays NaN.
inline double mean_error(const std::vector<State> &states, const std::vector<State> &reference) {
  double sum = 0;
  for (size_t n = 0; n < states.size(); ++n) {
    double square = 0;
    for (int i = 0; i < 6; ++i) square += (states[n][i] - reference[n][i]) * (states[n][i] - reference[n][i]);
    sum += std::sqrt(square);
  }
  return sum / states.size();
}

// Wall-clock time of the least disturbed run of at least five that together take half a second, after one to warm up.
template <class Run> double best_seconds(Run run) {
  using clock = std::chrono::steady_clock;
  run();
  double best = INFINITY, total = 0;
  for (int repeat = 0; repeat < 5 || total < 0.5; ++repeat) {
    const auto begin = clock::now();
    run();
    const double seconds = std::chrono::duration<double>(clock::now() - begin).count();
    best = std::min(best, seconds);
    total += seconds;
  }
  return best;
}

// Runs `integrate(states, end)`, which moves every state from 0 to `end` and returns the number of steps
// of one top, and prints the result.
template <class Integrate>
void contest(const std::string &name, const std::string &setting, const Problem &problem, Integrate integrate) {
  std::vector<State> states = problem.start;
  integrate(states, 10.0);
  const double error_10 = mean_error(states, problem.at_10);
  long steps = 0;
  const double seconds = best_seconds([&] {
    states = problem.start;
    steps = integrate(states, problem.end);
  });
  std::printf("{\"name\": \"%s\", \"setting\": \"%s\", \"seconds\": %.9e, \"steps\": %ld, \"error_10\": %.3e, "
              "\"error_%g\": %.3e}\n",
              name.c_str(), setting.c_str(), seconds, steps, error_10, problem.end, mean_error(states, problem.at_end));
  std::fflush(stdout);
}
