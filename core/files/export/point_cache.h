// core/files/export/point_cache.h: where all vertices are at each frame, as other programs cache it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace sinew::exporting {

/// Bytes of a cache, made frame by frame. Every frame has as many points.
class PointCache {
 public:
  enum class Format { kPc2, kMdd };

  /// @param times  [frames] seconds  @param points  in each frame
  PointCache(Format format, std::span<const float> times, std::size_t points);

  /// Bytes of a whole file. @param frames, points  any: nothing is made
  [[nodiscard]] static double sizeOf(Format format, double frames, double points);

  void add(std::span<const glm::vec3> points);
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  template <class Number>
  void append(Number number);

  Format format_;
  std::string bytes_;
};

}  // namespace sinew::exporting
