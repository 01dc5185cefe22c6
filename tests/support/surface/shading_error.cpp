// tests/support/surface/shading_error.cpp: finds the flat triangle around a place in barycentric coordinates.
#include "tests/support/surface/shading_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "core/geometry/parallel.h"

namespace sinew::test {
namespace {

constexpr float kCosine = 0.9961947f;  // Of 5 degrees.

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// The triangles of one control triangle, flat.
class FlatPieces {
 public:
  FlatPieces(const ControlMesh& mesh, const Surface& flat, int triangle) : flat_(flat) {
    const Refinement& refinement = *flat.refinement;
    for (int i = at(refinement.triangleBegin, triangle); i < at(refinement.triangleBegin, triangle + 1); ++i) {
      Piece piece{at(refinement.triangles, i), {}};
      for (std::size_t c = 0; c < 3; ++c) {
        const glm::dvec3 place = controlCoordinates(mesh, refinement, triangle, piece.vertices[c]);
        piece.places[c] = {place.y, place.z};
      }
      pieces_.push_back(piece);
    }
  }

  [[nodiscard]] glm::vec3 normalAt(const glm::dvec2& place) const {
    double best = -std::numeric_limits<double>::max();
    glm::vec3 normal(0.0f);
    for (const Piece& piece : pieces_) {
      const auto& [a, b, c] = piece.places;
      const double area = cross(b - a, c - a);
      if (!(area > 0.0)) continue;
      const glm::dvec3 shares{cross(b - place, c - place) / area, cross(c - place, a - place) / area,
                              cross(a - place, b - place) / area};
      const double least = std::min({shares.x, shares.y, shares.z});
      if (least <= best) continue;
      best = least;
      normal = glm::vec3(0.0f);
      for (int i = 0; i < 3; ++i) {
        normal += static_cast<float>(shares[i]) * at(flat_.normals, piece.vertices[toIndex(i)]);
      }
      if (least >= 0.0) break;
    }
    return normal;
  }

 private:
  struct Piece {
    std::array<int, 3> vertices{};
    std::array<glm::dvec2, 3> places{};  ///< Barycentric (1-x-y, x, y) in the control triangle.
  };
  const Surface& flat_;
  std::vector<Piece> pieces_;
};

bool isOff(const glm::vec3& a, const glm::vec3& b) {
  const float lengths = glm::length(a) * glm::length(b);
  return lengths > 0.0f && glm::dot(a, b) < kCosine * lengths;
}

}  // namespace

void ShadingError::add(const ShadingError& other) {
  area += other.area;
  off += other.off;
  movedArea += other.movedArea;
  movedOff += other.movedOff;
}

ShadingError shadingError(const ControlMesh& mesh, const Surface& fine, const Surface& flat) {
  const Refinement& refinement = *fine.refinement;
  std::vector<ShadingError> of(mesh.triangles.size());
  forEachIndex(of.size(), 16, [&](std::size_t t) {
    const int triangle = static_cast<int>(t);
    const FlatPieces pieces(mesh, flat, triangle);
    for (int i = refinement.triangleBegin[t]; i < refinement.triangleBegin[t + 1]; ++i) {
      std::array<glm::vec3, 3> corners{};
      glm::dvec3 place(0.0);
      glm::vec3 normal(0.0f);
      bool moved = false;
      for (std::size_t c = 0; c < 3; ++c) {
        const int vertex = at(refinement.triangles, i)[c];
        corners[c] = at(fine.positions, vertex);
        place += controlCoordinates(mesh, refinement, triangle, vertex) / 3.0;
        normal += at(fine.normals, vertex);
        moved = moved || at(fine.displacement, vertex) != 0.0f;
      }
      const auto area =
          0.5 * static_cast<double>(glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0])));
      const double off = isOff(normal, pieces.normalAt({place.y, place.z})) ? area : 0.0;
      of[t].add({area, off, moved ? area : 0.0, moved ? off : 0.0});
    }
  });
  ShadingError sum;
  for (const ShadingError& own : of) sum.add(own);
  return sum;
}

}  // namespace sinew::test
