// app/viewport/tools/skin_stroke.cpp: from the pixels of a drag to a path on the skin.

#include "app/viewport/tools/skin_stroke.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"

namespace sinew::app {
namespace {

constexpr float kFold = 0.02f;          ///< Fraction of H: path length that may be hidden before the stroke ends.
constexpr float kShortestLine = 0.01f;  ///< Pixels: below it the line has no direction.

using EdgeEnds = std::pair<int, int>;  ///< Refined vertices, the smaller first.

/// The part of the cut inside one triangle.
struct CutPiece {
  EdgeEnds enter;
  EdgeEnds leave;
};

/// The skin cut by a plane. Neighbors wind their common edge in opposite ways: what leaves one triangle enters the
/// next.
class SkinCut {
 public:
  SkinCut(const SkinSnapshot& skin, const glm::vec3& origin, const glm::vec3& normal) : skin_(skin) {
    heights_.reserve(skin.positions.size());
    for (const glm::vec3& position : skin.positions) heights_.push_back(glm::dot(position - origin, normal));
    for (const std::array<int, 3>& triangle : skin.refinement->triangles) {
      const auto above = std::ranges::count_if(triangle, [this](int vertex) { return isAbove(vertex); });
      if (above == 1 || above == 2) pieces_.push_back(pieceOf(triangle));
    }
  }

  [[nodiscard]] std::size_t size() const { return pieces_.size(); }

  /// Nothing if the plane misses the skin.
  [[nodiscard]] std::optional<CutPiece> nearestTo(const glm::vec3& point) const {
    std::optional<CutPiece> nearest;
    float least = std::numeric_limits<float>::infinity();
    for (const CutPiece& piece : pieces_) {
      const glm::vec3 from = crossing(piece.enter).point;
      const glm::vec3 way = crossing(piece.leave).point - from;
      const float length2 = glm::dot(way, way);
      const float share = length2 > 0.0f ? std::clamp(glm::dot(point - from, way) / length2, 0.0f, 1.0f) : 0.0f;
      const float distance = glm::length(point - (from + share * way));
      if (distance >= least) continue;
      least = distance;
      nearest = piece;
    }
    return nearest;
  }

  /// Makes next() lead the other way.
  void reverse() {
    for (CutPiece& piece : pieces_) std::swap(piece.enter, piece.leave);
  }

  void link() {
    for (const CutPiece& piece : pieces_) byEnter_.emplace(piece.enter, piece);
  }

  /// After link(). Nothing where the skin ends.
  [[nodiscard]] std::optional<CutPiece> next(const CutPiece& piece) const {
    const auto found = byEnter_.find(piece.leave);
    return found == byEnter_.end() ? std::nullopt : std::optional(found->second);
  }

  /// Where the plane crosses an edge.
  [[nodiscard]] SkinPoint crossing(const EdgeEnds& edge) const {
    const auto a = static_cast<std::size_t>(edge.first), b = static_cast<std::size_t>(edge.second);
    const float share = heights_[a] / (heights_[a] - heights_[b]);
    return {glm::mix(skin_.positions[a], skin_.positions[b], share),
            normalizeOr(glm::mix(skin_.normals[a], skin_.normals[b], share), skin_.normals[a])};
  }

 private:
  [[nodiscard]] bool isAbove(int vertex) const { return at(heights_, vertex) >= 0.0f; }

  [[nodiscard]] CutPiece pieceOf(const std::array<int, 3>& triangle) const {
    CutPiece piece;
    for (std::size_t i = 0; i < 3; ++i) {
      const int from = triangle[i], to = triangle[(i + 1) % 3];
      if (isAbove(from) == isAbove(to)) continue;
      (isAbove(from) ? piece.leave : piece.enter) = std::minmax(from, to);
    }
    return piece;
  }

  const SkinSnapshot& skin_;
  std::vector<float> heights_;  ///< [V'] over the plane.
  std::vector<CutPiece> pieces_;
  std::map<EdgeEnds, CutPiece> byEnter_;
};

/// The straight line on the screen that the pointer has drawn.
struct ScreenLine {
  const View& view;
  glm::vec2 from{0.0f};
  glm::vec2 direction{0.0f};
  float length = 0.0f;  ///< Pixels.

  /// Pixels from the start, towards the pointer.
  [[nodiscard]] float progress(const glm::vec3& point) const {
    return glm::dot(glm::vec2(view.toPixel(point)) - from, direction);
  }
};

/// Normal of the plane through the eye and the line; 0 if there is none.
glm::vec3 planeNormal(const ScreenLine& line, const glm::vec3& start) {
  const Ray from = line.view.rayThrough(line.from);
  const Ray to = line.view.rayThrough(line.from + line.length * line.direction);
  const float distance = glm::dot(start - from.origin, from.direction);
  const glm::vec3 along = to.origin + distance * to.direction - start;
  return normalizeOr(glm::cross(from.direction, along), glm::vec3(0.0f));
}

SkinPoint between(const SkinPoint& a, const SkinPoint& b, float share) {
  return {glm::mix(a.point, b.point, share), normalizeOr(glm::mix(a.normal, b.normal, share), a.normal)};
}

/// Adds what of the cut comes into view one after the other, up to the line's end.
void follow(const SkinCut& cut, CutPiece piece, const ScreenLine& line, float fold, SkinStroke& stroke) {
  float reached = 0.0f;
  float hidden = 0.0f;
  glm::vec3 last = stroke.points.front().point;
  for (std::size_t step = 0; step < cut.size(); ++step) {
    const SkinPoint here = cut.crossing(piece.leave);
    if (line.view.toPixel(here.point).z > 1.0f) return;
    const float progress = line.progress(here.point);
    if (progress >= line.length) {
      stroke.points.push_back(between(stroke.points.back(), here, (line.length - reached) / (progress - reached)));
      return;
    }
    hidden += glm::length(here.point - last);
    last = here.point;
    if (progress > reached) {
      stroke.points.push_back(here);
      reached = progress;
      hidden = 0.0f;
    }
    const std::optional<CutPiece> next = cut.next(piece);
    if (!next || hidden > fold) return;
    piece = *next;
  }
}

}  // namespace

SkinSnapshot snapshotOf(const Surface& surface) { return {surface.refinement, surface.positions, surface.normals}; }

SkinStroke strokeOnSkin(const SkinSnapshot& skin, const SkinPoint& start, const View& view, const glm::vec2& pixel,
                        float characterHeight) {
  assert(skin.refinement);
  SkinStroke stroke{{start}};
  const glm::vec2 from(view.toPixel(start.point));
  const float length = glm::length(pixel - from);
  if (!(length > kShortestLine)) return stroke;
  const ScreenLine line{view, from, (pixel - from) / length, length};
  const glm::vec3 normal = planeNormal(line, start.point);
  if (normal == glm::vec3(0.0f)) return stroke;
  SkinCut cut(skin, start.point, normal);
  std::optional<CutPiece> piece = cut.nearestTo(start.point);
  if (!piece) return stroke;
  // From behind, as on a double-sided strip, triangles wind the other way.
  if (line.progress(cut.crossing(piece->leave).point) < line.progress(cut.crossing(piece->enter).point)) {
    cut.reverse();
    std::swap(piece->enter, piece->leave);
  }
  cut.link();
  follow(cut, *piece, line, kFold * characterHeight, stroke);
  return stroke;
}

}  // namespace sinew::app
