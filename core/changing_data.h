#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/model.h"

namespace ringlet {

/// A copy of what the terms of a model change when a step begins, so that the step can be tried
/// again. Empty, and without cost, where no term changes anything.
class ChangingData {
 public:
  void save(Model& model);
  /// As it was when last saved.
  void restore(Model& model) const;
  std::size_t bytes() const { return bytes_of(bytes_); }
  std::span<const std::byte> data() const { return bytes_; }
  /// Data of another model of the same scene, for restore(). Throws Error if it is not as long as
  /// what was saved last.
  void set_data(std::vector<std::byte> data);

 private:
  std::vector<std::byte> bytes_;
};

}  // namespace ringlet
