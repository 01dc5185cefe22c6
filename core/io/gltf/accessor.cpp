// core/io/gltf/accessor.cpp: accessors (glTF 2.0, section 3.6.2).

#include "core/io/gltf/accessor.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace sinew::gltf {
namespace {

/// Elements one accessor may claim; far above kMaxControlTriangles' three corners.
constexpr std::uint64_t kMostElements = 1ULL << 31;
/// Sparse entries of all accessors of a file together: opening them walks over each once.
constexpr std::size_t kMostSparseEntries = 1U << 26;

struct Shape {
  std::string_view name;
  int components;
};
// MAT2 and MAT3 have padded columns and nothing Sinew reads uses them.
constexpr std::array<Shape, 5> kShapes{{{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}}};

std::size_t componentSize(const Field& type) {
  switch (type.requiredCount()) {
    case 5120:
    case 5121:
      return 1;
    case 5122:
    case 5123:
      return 2;
    case 5125:
    case 5126:
      return 4;
    default:
      refuse(type.place(), "unknown component type " + std::to_string(type.count(0)));
  }
}

}  // namespace

template <class T>
T Accessor::load(std::size_t index, int component) const {
  const std::uint8_t* from = element(index);
  if (!from) return T{};
  T value;
  std::memcpy(&value, from + static_cast<std::size_t>(component) * sizeof(T), sizeof(T));
  return value;
}

double Accessor::number(std::size_t index, int component) const {
  const auto scaled = [this](double value, double largest) {
    return normalized_ ? std::max(value / largest, -1.0) : value;
  };
  switch (type_) {
    case kByte:
      return scaled(load<std::int8_t>(index, component), 127.0);
    case kUnsignedByte:
      return scaled(load<std::uint8_t>(index, component), 255.0);
    case kShort:
      return scaled(load<std::int16_t>(index, component), 32767.0);
    case kUnsignedShort:
      return scaled(load<std::uint16_t>(index, component), 65535.0);
    case kUnsignedInt:
      return load<std::uint32_t>(index, component);
    default:
      return static_cast<double>(load<float>(index, component));
  }
}

std::uint32_t Accessor::integer(std::size_t index, int component) const {
  switch (type_) {
    case kUnsignedByte:
      return load<std::uint8_t>(index, component);
    case kUnsignedShort:
      return load<std::uint16_t>(index, component);
    case kUnsignedInt:
      return load<std::uint32_t>(index, component);
    default:
      return 0;
  }
}

std::uint32_t Accessor::sparseIndex(std::size_t entry) const {
  const auto loadAs = [&]<class T>(T value) {
    std::memcpy(&value, sparseIndices_ + entry * sizeof(T), sizeof(T));
    return static_cast<std::uint32_t>(value);
  };
  if (sparseType_ == kUnsignedByte) return loadAs(std::uint8_t{});
  if (sparseType_ == kUnsignedShort) return loadAs(std::uint16_t{});
  return loadAs(std::uint32_t{});
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
    const std::size_t size = type_ == kFloat || type_ == kUnsignedInt   ? 4
                             : type_ == kByte || type_ == kUnsignedByte ? 1
                                                                        : 2;
    return sparseValues_ + low * size * static_cast<std::size_t>(components_);
  }
  return base_ ? base_ + index * stride_ : nullptr;
}

Accessors::Accessors(const File& file) : file_(file), opened_(file.root().member("accessors").size()) {}

const Accessor& Accessors::open(const Field& reference, std::initializer_list<std::string_view> shapes) {
  const auto index = static_cast<std::size_t>(reference.requiredIndex(opened_.size(), "accessor"));
  if (!opened_[index]) opened_[index] = std::make_unique<Accessor>(read(index));
  const Accessor& accessor = *opened_[index];
  if (std::ranges::find(shapes, std::string_view(accessor.shape_)) == shapes.end()) {
    std::string wanted;
    for (const std::string_view shape : shapes) wanted += (wanted.empty() ? "" : " or ") + std::string(shape);
    refuse(reference.place(), accessor.place_ + " is " + accessor.shape_ + "; " + wanted + " expected");
  }
  return accessor;
}

Accessor Accessors::read(std::size_t index) {
  const Field field = file_.root().member("accessors").item(index);
  Accessor accessor;
  accessor.place_ = field.place();
  accessor.shape_ = std::string(field.member("type").text(""));
  const auto shape = std::ranges::find(kShapes, std::string_view(accessor.shape_), &Shape::name);
  if (shape == kShapes.end()) refuse(field.place() + ".type", "unknown or unusable type \"" + accessor.shape_ + "\"");
  accessor.components_ = shape->components;
  const std::size_t elementSize =
      componentSize(field.member("componentType")) * static_cast<std::size_t>(shape->components);
  accessor.type_ = static_cast<int>(field.member("componentType").count(0));
  accessor.normalized_ = field.member("normalized").boolean(false);
  const std::uint64_t count = field.member("count").requiredCount();
  if (count > kMostElements) refuse(field.place() + ".count", std::to_string(count) + " elements; too many");
  accessor.count_ = static_cast<std::size_t>(count);

  if (const auto view = field.member("bufferView").index(file_.bufferViewCount(), "bufferView")) {
    const std::size_t stride = file_.bufferViewStride(static_cast<std::size_t>(*view));
    accessor.stride_ = stride == 0 ? elementSize : stride;
    accessor.base_ = locate(field, static_cast<std::size_t>(*view), field.member("byteOffset").count(0), count,
                            elementSize, accessor.stride_);
  }
  if (field.member("sparse").exists()) readSparse(field.member("sparse"), elementSize, accessor);
  return accessor;
}

void Accessors::readSparse(const Field& sparse, std::size_t elementSize, Accessor& accessor) {
  const std::uint64_t count = sparse.member("count").requiredCount();
  if (count > accessor.count_) refuse(sparse.place() + ".count", "more entries than the accessor has elements");
  const Field indices = sparse.member("indices");
  const Field values = sparse.member("values");
  const std::size_t indexSize = componentSize(indices.member("componentType"));
  accessor.sparseType_ = static_cast<int>(indices.member("componentType").count(0));
  if (accessor.sparseType_ != Accessor::kUnsignedByte && accessor.sparseType_ != Accessor::kUnsignedShort &&
      accessor.sparseType_ != Accessor::kUnsignedInt) {
    refuse(indices.place() + ".componentType", "expected an unsigned integer type");
  }
  const auto place = [&](const Field& part, std::size_t size) {
    const int view = part.member("bufferView").requiredIndex(file_.bufferViewCount(), "bufferView");
    return locate(part, static_cast<std::size_t>(view), part.member("byteOffset").count(0), count, size, size);
  };
  accessor.sparseIndices_ = place(indices, indexSize);
  accessor.sparseValues_ = place(values, elementSize);
  accessor.sparseCount_ = static_cast<std::size_t>(count);
  sparseTotal_ += accessor.sparseCount_;
  if (sparseTotal_ > kMostSparseEntries) refuse(sparse.place(), "more than 67 million sparse entries in one file");
  for (std::size_t i = 0; i < accessor.sparseCount_; ++i) {
    const std::uint32_t now = accessor.sparseIndex(i);
    if (now >= accessor.count_ || (i > 0 && now <= accessor.sparseIndex(i - 1))) {
      refuse(indices.place(), "entry " + std::to_string(i) + " (" + std::to_string(now) +
                                  ") is out of range or not in increasing order");
    }
  }
}

const std::uint8_t* Accessors::locate(const Field& where, std::size_t view, std::uint64_t offset, std::uint64_t count,
                                      std::size_t elementSize, std::size_t stride) const {
  if (stride < elementSize) {
    refuse(where.place(),
           "stride " + std::to_string(stride) + " is less than an element's " + std::to_string(elementSize) + " bytes");
  }
  const Bytes bytes = file_.bufferView(view);
  // count <= 2^31, stride <= 2^16, offset <= 2^53: none of these sums leaves 64 bits.
  const std::uint64_t needed = count == 0 ? 0 : offset + (count - 1) * stride + elementSize;
  if (needed > bytes.size()) {
    refuse(where.place(), "needs " + std::to_string(needed) + " bytes; bufferViews[" + std::to_string(view) + "] has " +
                              std::to_string(bytes.size()));
  }
  return count == 0 ? nullptr : bytes.data() + offset;
}

}  // namespace sinew::gltf
