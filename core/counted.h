#pragma once

#include <cmath>
#include <cstdint>

namespace ringlet {

/// A double that counts the floating-point operations it takes part in: a scalar of kernels, to
/// learn what they cost. Additions, multiplications and divisions count one each; comparisons,
/// choices and signs nothing; roots and angles as much as core/lanes.h and core/angles.h take in
/// packs; other functions one. What is computed of constants alone is left to the compiler.
class Counted {
 public:
  Counted() = default;
  Counted(double constant) : value_(constant) {}  // NOLINT(*-explicit-*)
  /// The count must outlive the number and all that is computed from it.
  Counted(double value, std::int64_t& count) : value_(value), count_(&count) {}

  double value() const { return value_; }

  friend Counted operator+(const Counted& a, const Counted& b) {
    return combine(1, a.value_ + b.value_, a, b);
  }
  friend Counted operator-(const Counted& a, const Counted& b) {
    return combine(1, a.value_ - b.value_, a, b);
  }
  friend Counted operator*(const Counted& a, const Counted& b) {
    return combine(1, a.value_ * b.value_, a, b);
  }
  friend Counted operator/(const Counted& a, const Counted& b) {
    return combine(1, a.value_ / b.value_, a, b);
  }
  friend Counted operator-(const Counted& a) { return combine(0, -a.value_, a, a); }
  Counted& operator+=(const Counted& b) { return *this = *this + b; }
  Counted& operator-=(const Counted& b) { return *this = *this - b; }
  Counted& operator*=(const Counted& b) { return *this = *this * b; }
  Counted& operator/=(const Counted& b) { return *this = *this / b; }

  friend bool operator<(const Counted& a, const Counted& b) { return a.value_ < b.value_; }
  friend bool operator<=(const Counted& a, const Counted& b) { return a.value_ <= b.value_; }
  friend bool operator>(const Counted& a, const Counted& b) { return a.value_ > b.value_; }
  friend bool operator>=(const Counted& a, const Counted& b) { return a.value_ >= b.value_; }
  friend bool operator==(const Counted& a, const Counted& b) { return a.value_ == b.value_; }
  friend bool operator!=(const Counted& a, const Counted& b) { return a.value_ != b.value_; }

  friend Counted select(bool condition, const Counted& a, const Counted& b) {
    return combine(0, condition ? a.value_ : b.value_, a, b);
  }
  friend Counted min(const Counted& a, const Counted& b) { return select(b < a, b, a); }
  friend Counted max(const Counted& a, const Counted& b) { return select(a < b, b, a); }
  friend Counted abs(const Counted& a) { return combine(0, std::abs(a.value_), a, a); }
  friend Counted copysign(const Counted& a, const Counted& b) {
    return combine(0, std::copysign(a.value_, b.value_), a, b);
  }

  friend Counted sqrt(const Counted& a) { return combine(1, std::sqrt(a.value_), a, a); }
  /// An estimate and two steps of Newton's method.
  friend Counted inverse_sqrt(const Counted& a) {
    return combine(12, 1 / std::sqrt(a.value_), a, a);
  }
  friend Counted atan2(const Counted& a, const Counted& b) {
    return combine(30, std::atan2(a.value_, b.value_), a, b);
  }
  friend Counted exp(const Counted& a) { return combine(1, std::exp(a.value_), a, a); }
  friend Counted log(const Counted& a) { return combine(1, std::log(a.value_), a, a); }
  friend Counted sin(const Counted& a) { return combine(1, std::sin(a.value_), a, a); }
  friend Counted cos(const Counted& a) { return combine(1, std::cos(a.value_), a, a); }
  friend Counted tan(const Counted& a) { return combine(1, std::tan(a.value_), a, a); }
  friend Counted pow(const Counted& a, double exponent) {
    return combine(1, std::pow(a.value_, exponent), a, a);
  }

 private:
  static Counted combine(int operations, double value, const Counted& a, const Counted& b) {
    Counted result(value);
    result.count_ = a.count_ != nullptr ? a.count_ : b.count_;
    if (result.count_ != nullptr) *result.count_ += operations;
    return result;
  }

  double value_ = 0;
  std::int64_t* count_ = nullptr;
};

}  // namespace ringlet
