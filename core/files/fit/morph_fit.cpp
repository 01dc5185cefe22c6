// core/files/fit/morph_fit.cpp: what skinning leaves over, as displacements in the bind pose.
#include "core/files/fit/morph_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/files/fit/error_meter.h"
#include "core/geometry/at.h"
#include "core/geometry/parallel.h"

namespace sinew::exporting {
namespace {

/// Determinant of a blend, beside that of a rotation as large, below which its inverse is damped ...
constexpr double kSingular = 0.01;
/// ... by this, of the mean square of its singular values.
constexpr double kDamping = 1e-4;
/// Share of the height that other readers' arithmetic may differ by ...
constexpr double kReaders = 1e-6;
/// ... and of the distance from the origin: products of matrices, and a sum for each vertex.
constexpr double kReadersFar = 4.0 * static_cast<double>(std::numeric_limits<float>::epsilon());
constexpr std::size_t kLeastMorphRange = 1024;  ///< Vertices that are worth a thread.

/// What displacement a blend B makes `way` of: B^-1 way, damped where B is nearly singular.
glm::dvec3 beforeSkinning(const glm::dmat3& blend, const glm::dvec3& way) {
  const double square =
      (glm::dot(blend[0], blend[0]) + glm::dot(blend[1], blend[1]) + glm::dot(blend[2], blend[2])) / 3;
  if (square <= 0.0) return glm::dvec3(0.0);
  if (std::abs(glm::determinant(blend)) > kSingular * square * std::sqrt(square)) return glm::inverse(blend) * way;
  const glm::dmat3 transposed = glm::transpose(blend);
  return glm::inverse(transposed * blend + glm::dmat3(kDamping * square)) * (transposed * way);
}

}  // namespace

glm::dmat3 blendedMatrix(std::span<const glm::dmat4> matrices, const FourWeights& weights) {
  glm::dmat3 blend(0.0);
  for (std::size_t i = 0; i < kMostWeights && weights.binding[i] >= 0; ++i) {
    blend += static_cast<double>(weights.weight[i]) * glm::dmat3(at(matrices, weights.binding[i]));
  }
  return blend;
}

MorphFit::MorphFit(std::vector<MorphVertex> vertices, std::vector<glm::dmat3> meshToBind, double height)
    : vertices_(std::move(vertices)), meshToBind_(std::move(meshToBind)), height_(height) {
  for (const glm::dmat3& matrix : meshToBind_) bindToMesh_.push_back(glm::inverse(matrix));
  for (const MorphVertex& vertex : vertices_) {
    reach_ = std::max({reach_, vertex.reach, glm::length(vertex.rest)});
  }
}

void MorphFit::add(std::vector<glm::dmat4> matrices, std::span<const glm::vec3> live) {
  Frame frame{std::move(matrices), {}, {}};
  frame.live.resize(vertices_.size());
  frame.wanted.resize(3 * vertices_.size());
  forEachIndex(vertices_.size(), kLeastMorphRange, [&](std::size_t v) {
    const MorphVertex& vertex = vertices_[v];
    const glm::vec3& place = live[toIndex(vertex.refined)];
    const glm::dvec3 way = glm::dvec3(place) - skinPoint(frame.matrices, vertex.weights, vertex.rest);
    const glm::dvec3 wanted = beforeSkinning(blendedMatrix(frame.matrices, vertex.weights), way);
    frame.live[v] = place;
    for (int axis = 0; axis < 3; ++axis) frame.wanted[3 * v + toIndex(axis)] = static_cast<float>(wanted[axis]);
  });
  for (const glm::vec3& place : frame.live) reach_ = std::max(reach_, glm::length(glm::dvec3(place)));
  frames_.push_back(std::move(frame));
}

double MorphFit::coarseness() const { return std::max(kReaders * height_, kReadersFar * reach_); }

ErrorFigures MorphFit::skinnedFigures() const {
  ErrorMeter meter(height_);
  for (std::size_t f = 0; f < frames_.size(); ++f) {
    const Frame& frame = frames_[f];
    meter.addPose(0, static_cast<float>(f));
    for (std::size_t v = 0; v < vertices_.size(); ++v) {
      const MorphVertex& vertex = vertices_[v];
      meter.add(glm::distance(skinPoint(frame.matrices, vertex.weights, vertex.rest), glm::dvec3(frame.live[v])),
                vertex.refined);
    }
  }
  return meter.figures();
}

}  // namespace sinew::exporting
