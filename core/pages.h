#pragma once

#include <array>
#include <memory>
#include <vector>

namespace ringlet {

/// A list whose members never move: the first ones are part of it, further ones come in pages. Not
/// initialised.
template <class T, int page_size>
class Pages {
 public:
  int size() const { return size_; }
  [[gnu::always_inline]] T& add() {
    if (size_ == page_size * static_cast<int>(more_.size() + 1)) {
      more_.push_back(std::make_unique_for_overwrite<Page>());
    }
    return (*this)[size_++];
  }
  [[gnu::always_inline]] T& operator[](int i) {
    return i < page_size ? first_[i] : page(i)[i % page_size];
  }
  [[gnu::always_inline]] const T& operator[](int i) const {
    return i < page_size ? first_[i] : page(i)[i % page_size];
  }

 private:
  using Page = std::array<T, page_size>;
  Page& page(int i) const { return *more_[i / page_size - 1]; }

  Page first_;
  std::vector<std::unique_ptr<Page>> more_;
  int size_ = 0;
};

}  // namespace ringlet
