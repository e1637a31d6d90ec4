// Measures what one core can do at most: independent fused multiply-adds on registers of 256 and 512 bits,
// twelve accumulators each, in 10⁹ floating-point operations a second (one FMA on a double is two).
//
//     peak
#include <algorithm>
#include <chrono>
#include <cstdio>

template <int BYTES> __attribute__((noinline)) double seconds(long rounds) {
  typedef double Register __attribute__((vector_size(BYTES)));
  Register factor = Register{} + 0.999, term = Register{} + 0.001;
  asm("" : "+v"(factor), "+v"(term)); // not known at compile time
  // twelve different starts: equal ones would be merged
  Register a = term, b = 2 * a, c = 3 * a, d = 4 * a, e = 5 * a, f = 6 * a;
  Register g = 7 * a, h = 8 * a, i = 9 * a, j = 10 * a, k = 11 * a, l = 12 * a;
  const auto begin = std::chrono::steady_clock::now();
  for (long n = 0; n < rounds; ++n) {
    a = a * factor + term, b = b * factor + term, c = c * factor + term, d = d * factor + term;
    e = e * factor + term, f = f * factor + term, g = g * factor + term, h = h * factor + term;
    i = i * factor + term, j = j * factor + term, k = k * factor + term, l = l * factor + term;
  }
  asm volatile("" ::"v"(a + b + c + d + e + f), "v"(g + h + i + j + k + l)); // not optimised away
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

template <int BYTES> void measure(const char *setting) {
  constexpr long ROUNDS = 1000000;
  double best = 1e300;
  for (int repeat = 0; repeat < 200; ++repeat) best = std::min(best, seconds<BYTES>(ROUNDS));
  std::printf("{\"name\": \"FMA peak\", \"setting\": \"%s\", \"seconds\": %.9e, \"gflops\": %.1f}\n", setting, best,
              ROUNDS * 12.0 * 2 * (BYTES / 8) / best * 1e-9);
}

int main() {
#ifdef __AVX512F__
  measure<64>("512 bits");
#endif
#ifdef __AVX2__
  measure<32>("256 bits");
#endif
  measure<16>("128 bits");
}
