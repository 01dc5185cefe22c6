// core/files/gltf/accessor.h: typed, bounds-checked reading of accessors.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/files/gltf/file.h"

namespace sinew::gltf {

/// An accessor, checked when opened: every element lies within its buffer. Elements are decoded on access, so that a
/// file cannot make it allocate. Without a bufferView they are zero, as in glTF.
class Accessor {
 public:
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] int components() const { return components_; }
  [[nodiscard]] bool isFloat() const { return componentType_ == TINYGLTF_COMPONENT_TYPE_FLOAT; }
  /// Whether it is of a type that glTF allows for colors: floats, or normalized unsigned bytes or shorts.
  [[nodiscard]] bool holdsColors() const;
  [[nodiscard]] const std::string& place() const { return place_; }
  /// Step that compression rounded the values to; 0: not rounded.
  [[nodiscard]] double roundedTo() const { return roundedTo_; }
  /// Step between representable values of number(): roundedTo() or the grid of integers; 0 for floats. For normalized
  /// integers a coarser grid if all have only high bits, repeated in the lower ones, as programs write numbers of fewer
  /// bits. Visits all elements.
  [[nodiscard]] double step() const;

  /// A float, or an integer, scaled to -1..1 or 0..1 if `normalized`. Element < count().
  [[nodiscard]] double number(std::size_t element, int component) const;
  /// The integer; 0 for floats and negative numbers.
  [[nodiscard]] std::uint32_t integer(std::size_t element, int component) const;

 private:
  friend class Accessors;

  [[nodiscard]] int normalizedBits() const;  ///< Bits without the sign of normalized integers; 0 for others.
  /// Whether every value is a number of `bits` bits, shifted to the top, with its highest bits repeated below.
  [[nodiscard]] bool hasBits(int bits, int stored) const;
  [[nodiscard]] const std::uint8_t* element(std::size_t index) const;
  [[nodiscard]] std::uint32_t sparseIndex(std::size_t entry) const;
  template <class T>
  [[nodiscard]] T load(std::size_t index, int component) const;

  std::string place_;
  int type_ = TINYGLTF_TYPE_SCALAR;
  int componentType_ = TINYGLTF_COMPONENT_TYPE_FLOAT;
  int components_ = 1;
  bool normalized_ = false;
  std::size_t count_ = 0;
  std::size_t stride_ = 0;
  const std::uint8_t* base_ = nullptr;  // nullptr: zeros
  std::size_t sparseCount_ = 0;
  int sparseType_ = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  const std::uint8_t* sparseIndices_ = nullptr;
  const std::uint8_t* sparseValues_ = nullptr;
  double roundedTo_ = 0.0;
};

/// All elements. The accessor has the vectors' components.
template <class Vector>
[[nodiscard]] std::vector<Vector> vectorsOf(const Accessor& from) {
  std::vector<Vector> values(from.count());
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (int c = 0; c < Vector::length(); ++c) values[i][c] = static_cast<float>(from.number(i, c));
  }
  return values;
}

/// The accessors of a file, each opened at its first use.
class Accessors {
 public:
  explicit Accessors(const File& file);

  /// The accessor with an index (-1: refused as missing), which must be of one of the tinygltf types. Refuses at the
  /// JSON path of the accessor or of the reference.
  [[nodiscard]] const Accessor& open(int index, const std::string& reference, int type, int orType = -1);
  /// The same for an unchecked index in the file's JSON.
  [[nodiscard]] const Accessor& open(const Json& index, const std::string& reference, int type, int orType = -1);

 private:
  [[nodiscard]] Accessor read(std::size_t index);
  void readSparse(const tinygltf::Accessor& from, std::size_t elementSize, Accessor& accessor);
  /// Checks that `count` elements lie inside a view. Returns their first byte.
  [[nodiscard]] const std::uint8_t* locate(const std::string& place, int view, std::uint64_t offset,
                                           std::uint64_t count, std::size_t elementSize, std::size_t stride) const;

  const File& file_;
  std::vector<std::unique_ptr<Accessor>> opened_;
  std::size_t sparseTotal_ = 0;
};

}  // namespace sinew::gltf
