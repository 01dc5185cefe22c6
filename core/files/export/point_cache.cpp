// core/files/export/point_cache.cpp: PC2 is little endian, MDD big.
#include "core/files/export/point_cache.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string_view>

namespace sinew::exporting {
namespace {

constexpr std::string_view kMagic("POINTCACHE2\0", 12);
constexpr std::int32_t kCacheVersion = 1;
constexpr double kPc2Header = 32;
constexpr double kMddHeader = 8;

}  // namespace

PointCache::PointCache(Format format, std::span<const float> times, std::size_t points) : format_(format) {
  const auto frames = static_cast<double>(times.size());
  bytes_.reserve(static_cast<std::size_t>(sizeOf(format, frames, static_cast<double>(points))));
  const auto count = static_cast<std::int32_t>(points);
  const auto samples = static_cast<std::int32_t>(times.size());
  if (format == Format::kPc2) {
    bytes_ = kMagic;
    append(kCacheVersion);
    append(count);
    append(0.0f);  // The first sample is at frame 0 ...
    append(1.0f);  // ... and there is one a frame.
    append(samples);
  } else {
    append(samples);
    append(count);
    for (const float time : times) append(time);
  }
}

double PointCache::sizeOf(Format format, double frames, double points) {
  const double header = format == Format::kPc2 ? kPc2Header : kMddHeader + 4 * frames;
  return header + frames * points * static_cast<double>(sizeof(glm::vec3));
}

void PointCache::add(std::span<const glm::vec3> points) {
  for (const glm::vec3& point : points) {
    for (int axis = 0; axis < 3; ++axis) append(point[axis]);
  }
}

template <class Number>
void PointCache::append(Number number) {
  static_assert(std::endian::native == std::endian::little);
  auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if (format_ == Format::kMdd) std::ranges::reverse(bytes);
  bytes_.append(bytes.data(), bytes.size());
}

}  // namespace sinew::exporting
