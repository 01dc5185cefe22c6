// core/files/gltf/accessor.h: typed, bounds-checked reading of accessors.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/files/gltf/file.h"

namespace sinew::gltf {

/// One accessor, checked when it was opened: every element lies within its buffer. Reads need no alignment. Elements
/// are decoded when asked for, so a file cannot make it allocate. Without a bufferView the elements are zero, as glTF
/// says.
class Accessor {
 public:
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] int components() const { return components_; }
  [[nodiscard]] bool isFloat() const { return componentType_ == TINYGLTF_COMPONENT_TYPE_FLOAT; }
  /// Floats, or normalized unsigned bytes or shorts: what glTF allows for colors.
  [[nodiscard]] bool holdsColors() const;
  [[nodiscard]] const std::string& place() const { return place_; }
  /// What compression has rounded the values to; 0: they are as they were.
  [[nodiscard]] double roundedTo() const { return roundedTo_; }
  /// The step between values that could have been written, as number() gives them: roundedTo(), or the grid of
  /// integers; of normalized ones a coarser grid where all have only their highest bits, repeated in the lower ones, as
  /// programs write numbers of fewer bits that are to reach 1. 0: floats as they were. Walks over all elements.
  [[nodiscard]] double step() const;

  /// As the accessor says: floats as they are, integers scaled to -1..1 or 0..1 where `normalized`. Element < count().
  [[nodiscard]] double number(std::size_t element, int component) const;
  /// The integer itself; 0 for floats and negative numbers.
  [[nodiscard]] std::uint32_t integer(std::size_t element, int component) const;

 private:
  friend class Accessors;

  /// Bits beside the sign of integers that stand for numbers up to 1; 0 for others.
  [[nodiscard]] int normalizedBits() const;
  /// Whether every value is a number of so many bits, moved to the top, its highest bits repeated below.
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

/// All elements of an accessor with as many components as the vectors have.
template <class Vector>
[[nodiscard]] std::vector<Vector> vectorsOf(const Accessor& from) {
  std::vector<Vector> values(from.count());
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (int c = 0; c < Vector::length(); ++c) values[i][c] = static_cast<float>(from.number(i, c));
  }
  return values;
}

/// The accessors of a file, each opened once, when first used.
class Accessors {
 public:
  explicit Accessors(const File& file);

  /// The accessor an index refers to (-1: refused as missing); it must be of the given tinygltf type, or of the other
  /// one if that is named. Refuses at the accessor's JSON path, or that of the reference.
  [[nodiscard]] const Accessor& open(int index, const std::string& reference, int type, int orType = -1);
  /// The same, of an index in the file's JSON that nothing has checked.
  [[nodiscard]] const Accessor& open(const Json& index, const std::string& reference, int type, int orType = -1);

 private:
  [[nodiscard]] Accessor read(std::size_t index);
  void readSparse(const tinygltf::Accessor& from, std::size_t elementSize, Accessor& accessor);
  /// First byte of `count` elements inside a view.
  [[nodiscard]] const std::uint8_t* locate(const std::string& place, int view, std::uint64_t offset,
                                           std::uint64_t count, std::size_t elementSize, std::size_t stride) const;

  const File& file_;
  std::vector<std::unique_ptr<Accessor>> opened_;
  std::size_t sparseTotal_ = 0;
};

}  // namespace sinew::gltf
