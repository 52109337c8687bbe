#pragma once

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>

namespace ringlet {

/// The time of all calls of something, s: those that several threads make at once are added up, and
/// what it calls itself is part of it.
class WorkTime {
 public:
  double seconds() const { return 1e-9 * static_cast<double>(nanoseconds_.load()); }

  /// Adds the time of its life, or, where that is a sample of a longer work, so many times as much.
  class Timer {
   public:
    explicit Timer(WorkTime& time, double weight = 1)
        : time_(time), weight_(weight), start_(Clock::now()) {}
    ~Timer() {
      const std::chrono::duration<double, std::nano> passed = Clock::now() - start_;
      time_.nanoseconds_.fetch_add(std::llround(weight_ * passed.count()),
                                   std::memory_order_relaxed);
    }
    Timer(const Timer&) = delete;
    Timer& operator=(const Timer&) = delete;

   private:
    using Clock = std::chrono::steady_clock;
    WorkTime& time_;
    double weight_;
    Clock::time_point start_;
  };

 private:
  std::atomic<std::int64_t> nanoseconds_{0};
};

}  // namespace ringlet
