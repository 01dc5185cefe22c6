// core/files/gltf/accessor.cpp: accessors (glTF 2.0, section 3.6.2).

#include "core/files/gltf/accessor.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

#include "core/geometry/at.h"

namespace sinew::gltf {
namespace {

/// Elements of one accessor; far above three corners of kMaxControlTriangles.
constexpr std::uint64_t kMaxElements = 1ULL << 31;
/// Sparse entries of all accessors of a file, each visited once on opening.
constexpr std::size_t kMaxSparseEntries = 1U << 26;

constexpr int kFewestBits = 8;  ///< Of rounded numbers.

const char* nameOf(int type) {
  if (type == TINYGLTF_TYPE_SCALAR) return "SCALAR";
  if (type == TINYGLTF_TYPE_VEC2) return "VEC2";
  if (type == TINYGLTF_TYPE_VEC3) return "VEC3";
  return type == TINYGLTF_TYPE_VEC4 ? "VEC4" : "MAT4";
}

std::size_t sizeOf(int componentType) {
  return toIndex(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(componentType)));
}

}  // namespace

template <class T>
T Accessor::load(std::size_t index, int component) const {
  const std::uint8_t* from = element(index);
  if (!from) return T{};
  T value;
  std::memcpy(&value, from + toIndex(component) * sizeof(T), sizeof(T));
  return value;
}

bool Accessor::holdsColors() const {
  const bool unsignedSmall = componentType_ == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                             componentType_ == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
  return isFloat() || (normalized_ && unsignedSmall);
}

int Accessor::normalizedBits() const {
  if (!normalized_ || isFloat()) return 0;
  const bool isSigned =
      componentType_ == TINYGLTF_COMPONENT_TYPE_BYTE || componentType_ == TINYGLTF_COMPONENT_TYPE_SHORT;
  const int bits = 8 * static_cast<int>(sizeOf(componentType_));
  return bits > 16 ? 0 : bits - (isSigned ? 1 : 0);  // Larger ones are not scaled.
}

bool Accessor::hasBits(int bits, int stored) const {
  const int lower = stored - bits;
  const double largest = std::exp2(stored) - 1.0;
  for (std::size_t i = 0; i < count_; ++i) {
    for (int c = 0; c < components_; ++c) {
      const auto value = static_cast<std::uint32_t>(std::lround(std::abs(number(i, c)) * largest));
      const std::uint32_t high = value >> lower;
      if (value != (high << lower | high >> (bits - lower))) return false;
    }
  }
  return true;
}

double Accessor::step() const {
  if (isFloat() || roundedTo_ > 0.0) return roundedTo_;
  const int stored = normalizedBits();
  if (stored == 0) return 1.0;
  int bits = std::min(kFewestBits, stored);
  while (bits < stored && !hasBits(bits, stored)) ++bits;
  return std::exp2(stored - bits) / (std::exp2(stored) - 1.0);
}

double Accessor::number(std::size_t index, int component) const {
  return withComponent(componentType_, [&]<class T>(T) {
    const auto value = static_cast<double>(load<T>(index, component));
    const bool isScaled = normalized_ && sizeof(T) <= 2;  // Larger integers are not scaled.
    return isScaled ? std::max(value / static_cast<double>(std::numeric_limits<T>::max()), -1.0) : value;
  });
}

std::uint32_t Accessor::integer(std::size_t index, int component) const {
  return withComponent(componentType_, [&]<class T>(T) -> std::uint32_t {
    if constexpr (std::is_unsigned_v<T>) return load<T>(index, component);
    else return 0;
  });
}

std::uint32_t Accessor::sparseIndex(std::size_t entry) const {
  return withComponent(sparseType_, [&](auto value) {
    std::memcpy(&value, sparseIndices_ + entry * sizeof(value), sizeof(value));
    return static_cast<std::uint32_t>(value);
  });
}

const std::uint8_t* Accessor::element(std::size_t index) const {
  std::size_t low = 0;
  std::size_t high = sparseCount_;
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (sparseIndex(middle) < index) low = middle + 1;
    else high = middle;
  }
  if (low < sparseCount_ && sparseIndex(low) == index) {
    return sparseValues_ + low * sizeOf(componentType_) * toIndex(components_);
  }
  return base_ ? base_ + index * stride_ : nullptr;
}

Accessors::Accessors(const File& file) : file_(file), opened_(file.model().accessors.size()) {}

const Accessor& Accessors::open(int index, const std::string& reference, int type, int orType) {
  file_.expectSound(reference);
  if (index < 0) refuse(reference, "missing");
  std::unique_ptr<Accessor>& opened = at(opened_, index);
  if (!opened) opened = std::make_unique<Accessor>(read(toIndex(index)));
  if (opened->type_ != type && opened->type_ != orType) {
    const std::string expected = nameOf(type) + (orType < 0 ? std::string() : std::string(" or ") + nameOf(orType));
    refuse(reference, opened->place_ + " is " + nameOf(opened->type_) + "; " + expected + " expected");
  }
  return *opened;
}

const Accessor& Accessors::open(const Json& index, const std::string& reference, int type, int orType) {
  const double number = index.number(-1.0);
  if (!(number >= 0.0 && number < static_cast<double>(opened_.size()))) refuse(reference, "there is no such accessor");
  return open(static_cast<int>(number), reference, type, orType);
}

Accessor Accessors::read(std::size_t index) {
  const tinygltf::Accessor& from = file_.model().accessors[index];
  Accessor accessor;
  accessor.place_ = placeOf("accessors", index);
  file_.expectSound(accessor.place_);
  accessor.type_ = from.type;
  accessor.componentType_ = from.componentType;
  accessor.components_ = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(from.type));
  accessor.normalized_ = from.normalized;
  const std::map<std::size_t, float>& unpacked = file_.unpacked().accessors;
  if (const auto found = unpacked.find(index); found != unpacked.end()) accessor.roundedTo_ = found->second;
  if (from.count > kMaxElements) refuse(accessor.place_ + ".count", std::to_string(from.count) + " elements; too many");
  accessor.count_ = from.count;

  const std::size_t elementSize = sizeOf(from.componentType) * toIndex(accessor.components_);
  if (from.bufferView >= 0) {
    const std::size_t stride = file_.model().bufferViews[toIndex(from.bufferView)].byteStride;
    accessor.stride_ = stride == 0 ? elementSize : stride;
    accessor.base_ =
        locate(accessor.place_, from.bufferView, from.byteOffset, from.count, elementSize, accessor.stride_);
  }
  if (from.sparse.isSparse) readSparse(from, elementSize, accessor);
  return accessor;
}

void Accessors::readSparse(const tinygltf::Accessor& from, std::size_t elementSize, Accessor& accessor) {
  const auto& [count, isSparse, indices, values] = from.sparse;
  const std::string place = accessor.place_ + ".sparse";
  const auto entries = toIndex(count);
  if (entries > accessor.count_) refuse(place + ".count", "more entries than the accessor has elements");
  if (indices.componentType != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE &&
      indices.componentType != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
      indices.componentType != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) {
    refuse(place + ".indices.componentType", "expected an unsigned integer type");
  }
  accessor.sparseType_ = indices.componentType;
  const std::size_t indexSize = sizeOf(indices.componentType);
  accessor.sparseIndices_ = locate(place + ".indices", indices.bufferView,
                                   static_cast<std::uint64_t>(indices.byteOffset), entries, indexSize, indexSize);
  accessor.sparseValues_ = locate(place + ".values", values.bufferView, static_cast<std::uint64_t>(values.byteOffset),
                                  entries, elementSize, elementSize);
  accessor.sparseCount_ = entries;
  sparseTotal_ += accessor.sparseCount_;
  if (sparseTotal_ > kMaxSparseEntries) refuse(place, "more than 67 million sparse entries in one file");
  for (std::size_t i = 0; i < accessor.sparseCount_; ++i) {
    const std::uint32_t now = accessor.sparseIndex(i);
    if (now >= accessor.count_ || (i > 0 && now <= accessor.sparseIndex(i - 1))) {
      refuse(place + ".indices", "entry " + std::to_string(i) + " (" + std::to_string(now) +
                                     ") is out of range or not in increasing order");
    }
  }
}

const std::uint8_t* Accessors::locate(const std::string& place, int view, std::uint64_t offset, std::uint64_t count,
                                      std::size_t elementSize, std::size_t stride) const {
  if (stride < elementSize) {
    refuse(place,
           "stride " + std::to_string(stride) + " is less than an element's " + std::to_string(elementSize) + " bytes");
  }
  const Bytes bytes = file_.bufferView(toIndex(view));
  // count <= 2^31, stride <= 2^16, offset <= 2^53: none of these sums leaves 64 bits.
  const std::uint64_t needed = count == 0 ? 0 : offset + (count - 1) * stride + elementSize;
  if (needed > bytes.size()) {
    refuse(place, "needs " + std::to_string(needed) + " bytes; bufferViews[" + std::to_string(view) + "] has " +
                      std::to_string(bytes.size()));
  }
  return count == 0 ? nullptr : bytes.data() + offset;
}

}  // namespace sinew::gltf
