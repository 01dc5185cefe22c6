// core/geometry/scratch_array.h: memory that takes none until it is written.
#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>

namespace sinew {

/// Items without values: reading one that was not written is an error. A copy starts without any.
template <class Item>
requires std::is_trivially_default_constructible_v<Item>
class ScratchArray {
 public:
  ScratchArray() = default;
  ScratchArray(const ScratchArray&) {}
  ScratchArray(ScratchArray&&) noexcept = default;
  ScratchArray& operator=(const ScratchArray& other) {
    if (this != &other) *this = ScratchArray();
    return *this;
  }
  ScratchArray& operator=(ScratchArray&&) noexcept = default;
  ~ScratchArray() = default;

  /// Loses what was written where the size changes.
  void resize(std::size_t size) {
    if (size == size_) return;
    items_ = std::make_unique_for_overwrite<Item[]>(size);
    size_ = size;
  }
  [[nodiscard]] Item* data() { return items_.get(); }

 private:
  std::unique_ptr<Item[]> items_;
  std::size_t size_ = 0;
};

}  // namespace sinew
