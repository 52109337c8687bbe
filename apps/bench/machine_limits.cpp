#include "apps/bench/machine_limits.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <thread>
#include <vector>

#include "core/lanes.h"

namespace ringlet {
namespace {

/// Enough independent chains that none waits, and registers for all of them.
constexpr int chains = 12;

[[gnu::noinline]] double multiply_add(std::int64_t rounds) {
  Pack x[chains];
  for (int c = 0; c < chains; ++c) x[c] = Pack(1.0 + c);
  const Pack factor = 1 - 1e-9, term = 1e-9;
  for (std::int64_t round = 0; round < rounds; ++round) {
    for (Pack& value : x) value = value * factor + term;
  }
  Pack sum = 0;
  for (const Pack& value : x) sum += value;
  return sum_lanes(sum);
}

[[gnu::noinline]] void add_multiple(std::span<double> y, std::span<const double> x, double s) {
  for (std::size_t i = 0; i < y.size(); ++i) y[i] += s * x[i];
}

/// Calls work(thread) on so many threads at once.
template <class Work>
Timing measure_on(int threads, double seconds, const Work& work) {
  return measure(
      [&] {
        std::vector<std::jthread> others;
        for (int thread = 1; thread < threads; ++thread) others.emplace_back(work, thread);
        work(0);
      },
      seconds);
}

/// y += s x again and again in arrays of so many bytes together, a thread.
Rate stream_rate(int threads, double seconds, std::size_t bytes, int rounds) {
  const std::size_t size = bytes / (2 * sizeof(double));
  std::vector<std::vector<double>> x(threads, std::vector<double>(size, 1.0)), y = x;
  const Timing time = measure_on(threads, seconds, [&](int thread) {
    for (int round = 0; round < rounds; ++round) add_multiple(y[thread], x[thread], 1e-9);
  });
  constexpr int accesses = 3;
  return {accesses * sizeof(double) * double(size) * rounds * threads / time.median, time};
}

}  // namespace

Rate multiply_add_rate(int threads, double seconds) {
  const std::int64_t rounds = seconds > 0 ? 5'000'000 : 1000;
  std::vector<double> results(threads);  // so that nothing is left out as unused
  const Timing time =
      measure_on(threads, seconds, [&](int thread) { results[thread] = multiply_add(rounds); });
  return {2.0 * chains * lane_count * double(rounds) * threads / time.median, time};
}

Rate memory_rate(int threads, double seconds) {
  const std::size_t bytes = seconds > 0 ? 256u << 20 : 1u << 20;
  return stream_rate(threads, seconds, bytes, 1);
}

Rate cache_rate(int threads, double seconds) {
  return stream_rate(threads, seconds, 256u << 10, seconds > 0 ? 500 : 1);
}

}  // namespace ringlet
