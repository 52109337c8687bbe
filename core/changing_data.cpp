#include "core/changing_data.h"

#include <algorithm>
#include <string>

#include "core/error.h"

namespace ringlet {
namespace {

template <class Visit>
void for_each_part(Model& model, const Visit& visit) {
  for (const auto& energy : model.energies) visit(energy->changing_data());
  for (const auto& coupling : model.couplings) visit(coupling->changing_data());
  for (const auto& force : model.forces) visit(force->changing_data());
}

}  // namespace

void ChangingData::save(Model& model) {
  bytes_.clear();
  for_each_part(model, [&](std::span<const std::byte> part) {
    bytes_.insert(bytes_.end(), part.begin(), part.end());
  });
}

void ChangingData::set_data(std::vector<std::byte> data) {
  if (data.size() != bytes_.size()) {
    throw Error("what its terms change are " + std::to_string(data.size()) + " bytes; expected " +
                std::to_string(bytes_.size()));
  }
  bytes_ = std::move(data);
}

void ChangingData::restore(Model& model) const {
  auto from = bytes_.begin();
  for_each_part(model, [&](std::span<std::byte> part) {
    std::copy_n(from, part.size(), part.begin());
    from += static_cast<std::ptrdiff_t>(part.size());
  });
}

}  // namespace ringlet
