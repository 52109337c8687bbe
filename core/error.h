#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace ringlet {

/// Thrown at set-up when something cannot be done; says what, where and what was expected.
/// Hot loops never throw: they return reports.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One thing wrong with a JSON input: the JSON pointer to it and what was expected there.
struct Problem {
  std::string pointer;
  std::string message;
};

/// Everything wrong with a scene or another JSON input, at once.
class InvalidInput : public Error {
 public:
  explicit InvalidInput(std::vector<Problem> problems);
  const std::vector<Problem>& problems() const { return problems_; }

 private:
  std::vector<Problem> problems_;
};

}  // namespace ringlet
