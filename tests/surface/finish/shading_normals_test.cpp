// tests/surface/finish/shading_normals_test.cpp: shading normals are the field's where faces can show them, otherwise
// follow the faces.

#include "core/surface/finish/shading_normals.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/support/surface/mesh_checks.h"
#include "tests/support/surface/sheets.h"

namespace sinew::test {
namespace {

constexpr int kNormalsCells = 40;
constexpr float kNormalsEdge = 2.0f / kNormalsCells;

/// A flat patch raised by a height, with a field's normals.
class Raised {
 public:
  Raised()
      : mesh_(flat()), refinement_(refine(mesh_, 1)), rings_(vertexRings(refinement_)), patchNormals_(mesh_.normals) {}

  /// @param height  at a place; 0: not moved.  @param normal  of the field; called where it moved
  std::vector<glm::vec3> shaded(const std::function<float(const glm::vec3&)>& height,
                                const std::function<glm::vec3(const glm::vec3&)>& normal) {
    positions = mesh_.positions;
    fieldNormals = patchNormals_;
    for (std::size_t v = 0; v < positions.size(); ++v) {
      const float rise = height(mesh_.positions[v]);
      if (rise == 0.0f) continue;
      positions[v].z += rise;
      fieldNormals[v] = glm::normalize(normal(mesh_.positions[v]));
    }
    moved_.find(refinement_, mesh_.positions, positions);
    pairs_.fill(moved_.corners, mesh_.positions, positions);
    std::vector<glm::vec3> out = fieldNormals;
    shading_.apply(refinement_, rings_, moved_, pairs_, patchNormals_, {}, softensRims, out);
    return out;
  }

  /// The field's normals of the last shading, softened only.
  [[nodiscard]] std::vector<glm::vec3> softened(InstructionSet set) const {
    std::vector<glm::vec3> out = fieldNormals;
    std::vector<NormalsVertex> vertices(out.size());
    std::vector<int> rims(moved_.corners.size());
    NormalsInputs inputs;
    inputs.rings = &rings_;
    inputs.moved = &moved_;
    inputs.patchNormals = patchNormals_;
    inputs.normals = out;
    inputs.vertices = vertices.data();
    inputs.teeth = rims;
    const NormalsKernel kernel = normalsKernel(set);
    kernel.takeDeltas(inputs, 0, moved_.corners.size());
    kernel.softenRims(inputs, 0, kernel.findRims(inputs, 0, moved_.near.size()));
    return out;
  }

  [[nodiscard]] const Refinement& refinement() const { return refinement_; }
  [[nodiscard]] const std::vector<glm::vec3>& patch() const { return mesh_.positions; }
  [[nodiscard]] const std::vector<glm::vec3>& patchNormals() const { return patchNormals_; }

  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> fieldNormals;
  bool softensRims = false;

 private:
  static ControlMesh flat() {
    const Sheet sheet = sheetOf(kNormalsCells, [](float, float) { return 0.0f; });
    return meshOf(sheet.positions, sheet.triangles);
  }

  ControlMesh mesh_;
  Refinement refinement_;
  VertexRings rings_;
  std::vector<glm::vec3> patchNormals_;
  MovedTriangles moved_;
  VertexPairs pairs_;
  ShadingNormals shading_;
};

/// A bump around the origin that ends smoothly at a radius, and its normals.
struct Bump {
  float height = 0.1f;
  float radius = 0.5f;

  float at(const glm::vec3& p) const {
    const float inside = std::max(0.0f, 1.0f - (p.x * p.x + p.y * p.y) / (radius * radius));
    return height * inside * inside;
  }
  glm::vec3 normal(const glm::vec3& p) const {
    const float inside = std::max(0.0f, 1.0f - (p.x * p.x + p.y * p.y) / (radius * radius));
    const float slope = 4.0f * height * inside / (radius * radius);
    return {slope * p.x, slope * p.y, 1.0f};
  }
};

float turnInDegrees(const glm::vec3& a, const glm::vec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180.0f / std::numbers::pi_v<float>;
}

/// Unit normals of the faces around each vertex, weighted by their angles there.
std::vector<glm::vec3> faceNormals(const Refinement& refinement, const std::vector<glm::vec3>& positions) {
  std::vector<glm::vec3> sums(positions.size(), glm::vec3(0.0f));
  for (const auto& t : refinement.triangles) {
    const auto at = [&](std::size_t i) { return positions[static_cast<std::size_t>(t[i % 3])]; };
    const glm::vec3 face = glm::normalize(glm::cross(at(1) - at(0), at(2) - at(0)));
    for (std::size_t i = 0; i < 3; ++i) {
      sums[static_cast<std::size_t>(t[i])] += turnInDegrees(at(i + 1) - at(i), at(i + 2) - at(i)) * face;
    }
  }
  for (glm::vec3& sum : sums) sum = glm::normalize(sum);
  return sums;
}

TEST(ShadingNormals, AreUnchangedWhereNothingMoved) {
  Raised sheet;
  const auto nowhere = [](const glm::vec3&) { return 0.0f; };
  EXPECT_TRUE(sameBytes(sheet.shaded(nowhere, [](const glm::vec3& p) { return p; }), sheet.patchNormals()));

  // A steep bump: one edge around it may change, and no vertex beyond.
  const Bump bump{0.3f, 0.2f};
  const auto shaded =
      sheet.shaded([&](const glm::vec3& p) { return bump.at(p); }, [&](const glm::vec3& p) { return bump.normal(p); });
  const std::vector<bool> moved = movedBetween(sheet.patch(), sheet.positions);
  const std::vector<bool> near = grown(sheet.refinement().triangles, moved, 1);
  int beyond = 0;
  int changed = 0;
  for (std::size_t v = 0; v < shaded.size(); ++v) {
    const bool same = sameBits(shaded[v], sheet.patchNormals()[v]);
    changed += !same && !moved[v] ? 1 : 0;
    if (near[v]) continue;
    ++beyond;
    EXPECT_TRUE(same) << v;
  }
  EXPECT_GT(beyond, 100);
  EXPECT_GT(changed, 0) << "the faces beside the bump were not looked at";
}

TEST(ShadingNormals, EqualTheFieldNormalsOnAWideBump) {
  Raised sheet;
  const Bump bump{0.1f, 0.8f};
  const auto shaded =
      sheet.shaded([&](const glm::vec3& p) { return bump.at(p); }, [&](const glm::vec3& p) { return bump.normal(p); });
  const std::vector<bool> moved = movedBetween(sheet.patch(), sheet.positions);
  ASSERT_GT(std::ranges::count(moved, true), 500);
  float most = 0.0f;
  for (std::size_t v = 0; v < shaded.size(); ++v) {
    if (!moved[v]) continue;
    EXPECT_TRUE(sameBits(shaded[v], sheet.fieldNormals[v])) << v;
    most = std::max(most, turnInDegrees(shaded[v], sheet.patchNormals()[v]));
  }
  EXPECT_GT(most, 8.0f) << "too flat to tell";
}

bool inSquare(const glm::vec3& p) { return std::abs(p.x) < 0.5f && std::abs(p.y) < 0.5f; }

/// 60 degrees to both sides.
glm::vec3 steepNormal(const glm::vec3& p) { return {p.x > 0.0f ? 1.7f : -1.7f, 0.0f, 1.0f}; }

// The field's normal leans 60 degrees where the faces hardly lean.
TEST(ShadingNormals, StayNearTheFacesOnANarrowBump) {
  Raised sheet;
  const auto uneven = [](const glm::vec3& p) {
    return inSquare(p) ? 0.001f * (1.0f + 0.3f * std::sin(13.0f * p.x + 7.0f * p.y)) : 0.0f;
  };
  const std::vector<glm::vec3> shaded = sheet.shaded(uneven, steepNormal);
  const std::vector<glm::vec3> faces = faceNormals(sheet.refinement(), sheet.positions);
  int steepBefore = 0;
  float most = 0.0f;
  for (std::size_t v = 0; v < shaded.size(); ++v) {
    steepBefore += turnInDegrees(sheet.fieldNormals[v], faces[v]) > 50.0f ? 1 : 0;
    most = std::max(most, turnInDegrees(shaded[v], faces[v]));
  }
  EXPECT_GT(steepBefore, 100);
  EXPECT_LT(most, 9.0f);  // A difference of 0.145.
}

// Lifted by the same height everywhere, the faces match the patch's exactly.
TEST(ShadingNormals, StayNearFacesThatWereOnlyShifted) {
  Raised sheet;
  const auto even = [](const glm::vec3& p) { return inSquare(p) ? 0.001f : 0.0f; };
  const std::vector<glm::vec3> shaded = sheet.shaded(even, steepNormal);
  const std::vector<glm::vec3> faces = faceNormals(sheet.refinement(), sheet.positions);
  float most = 0.0f;
  for (std::size_t v = 0; v < shaded.size(); ++v) most = std::max(most, turnInDegrees(shaded[v], faces[v]));
  EXPECT_LT(most, 9.0f);
}

// A step that runs diagonally over the mesh, narrower than an edge: its faces alternate.
TEST(ShadingNormals, AreSmoothAlongADiagonalRim) {
  Raised sheet;
  const auto step = [](const glm::vec3& p) {
    return 0.6f * kNormalsEdge * std::clamp((p.x + 0.4f * p.y + 0.2f) / (0.5f * kNormalsEdge), 0.0f, 1.0f);
  };
  sheet.shaded(step, [](const glm::vec3&) { return glm::vec3(0.0f, 0.0f, 1.0f); });
  const std::vector<glm::vec3> faces = faceNormals(sheet.refinement(), sheet.positions);
  std::size_t next = 0;
  const auto asTheFaces = [&](const glm::vec3&) {
    while (sheet.positions[next].z == 0.0f) ++next;  // Called in order, for moved vertices only.
    return faces[next++];
  };
  const std::vector<glm::vec3> shaded = sheet.shaded(step, asTheFaces);
  const auto roughness = [&](const std::vector<glm::vec3>& normals) {
    double sum = 0.0;
    for (const auto& t : sheet.refinement().triangles) {
      const glm::vec3 apart = normals[static_cast<std::size_t>(t[0])] - normals[static_cast<std::size_t>(t[1])];
      sum += static_cast<double>(glm::dot(apart, apart));
    }
    return sum;
  };
  std::printf("  squared differences along edges: %.1f before, %.1f after\n", roughness(faces), roughness(shaded));
  EXPECT_LT(roughness(shaded), 0.85 * roughness(faces));
}

struct Around {
  std::vector<glm::dvec3> difference;  ///< The ring's mean less the vertex's own.
  std::vector<double> most;            ///< The largest distance from a neighbor.
};

/// Each neighbor counts once for every shared triangle.
Around around(const Refinement& refinement, const std::vector<glm::dvec3>& of) {
  Around out{std::vector<glm::dvec3>(of.size(), glm::dvec3(0.0)), std::vector<double>(of.size(), 0.0)};
  std::vector<double> counts(of.size(), 0.0);
  for (const auto& t : refinement.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto own = static_cast<std::size_t>(t[i]);
      for (const std::size_t other : {(i + 1) % 3, (i + 2) % 3}) {
        const glm::dvec3 apart = of[static_cast<std::size_t>(t[other])] - of[own];
        out.difference[own] += apart;
        counts[own] += 1.0;
        out.most[own] = std::max(out.most[own], glm::length(apart));
      }
    }
  }
  for (std::size_t v = 0; v < of.size(); ++v) out.difference[v] /= counts[v];
  return out;
}

double step(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// Definition of docs/design.md in double precision.
std::vector<glm::dvec3> softenedByDefinition(const Refinement& refinement, const std::vector<glm::vec3>& patch,
                                             const std::vector<glm::vec3>& field) {
  std::vector<glm::dvec3> deltas;
  for (std::size_t v = 0; v < field.size(); ++v) deltas.push_back(glm::dvec3(field[v]) - glm::dvec3(patch[v]));
  const Around of = around(refinement, deltas);
  std::vector<glm::dvec3> out;
  for (std::size_t v = 0; v < field.size(); ++v) {
    out.push_back(glm::normalize(glm::dvec3(field[v]) + 0.6 * step(0.2, 0.45, of.most[v]) * of.difference[v]));
  }
  return out;
}

TEST(ShadingNormals, AreSoftenedOnlyAtRimsAndAsDefined) {
  Raised sheet;
  const Bump bump{0.1f, 0.6f};
  const auto turned = [&](const glm::vec3& p) {  // Smooth on one side, rough on the other.
    if (p.x < 0.0f) return bump.normal(p);
    return bump.normal(p) + glm::vec3(0.6f * std::sin(70.0f * p.x), 0.5f * std::sin(50.0f * p.y), 0.0f);
  };
  sheet.shaded([&](const glm::vec3& p) { return bump.at(p); }, turned);
  const std::vector<bool> near = grown(sheet.refinement().triangles, movedBetween(sheet.patch(), sheet.positions), 1);
  const std::vector<glm::dvec3> wanted =
      softenedByDefinition(sheet.refinement(), sheet.patchNormals(), sheet.fieldNormals);
  for (const InstructionSet set : availableInstructionSets()) {
    if (set == InstructionSet::kScalar) continue;
    const std::vector<glm::vec3> softened = sheet.softened(set);
    EXPECT_TRUE(sameBytes(softened, sheet.softened(chosenVectorSet()))) << nameOf(set);
    int changed = 0;
    int kept = 0;
    for (std::size_t v = 0; v < near.size(); ++v) {
      const bool same = sameBits(softened[v], sheet.fieldNormals[v]);
      changed += same ? 0 : 1;
      kept += same && near[v] ? 1 : 0;
      if (!near[v]) EXPECT_TRUE(same) << v;
      else EXPECT_LT(glm::distance(glm::dvec3(softened[v]), wanted[v]), 2e-6) << v;
    }
    EXPECT_GT(changed, 50);
    EXPECT_GT(kept, 20);
  }
}

class ShadingNormalsContinuity : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Softened, ShadingNormalsContinuity, testing::Bool());

TEST_P(ShadingNormalsContinuity, AreContinuousInTheHeight) {
  Raised sheet;
  sheet.softensRims = GetParam();
  constexpr float kSteepest = 0.4f;
  std::vector<float> slopes;
  for (const int steps : {200, 800}) {
    std::vector<glm::vec3> before = sheet.patchNormals();
    float worst = 0.0f;
    for (int i = 1; i <= steps; ++i) {
      const Bump bump{kSteepest * static_cast<float>(i) / static_cast<float>(steps), 4.3f * kNormalsEdge};
      const auto now = sheet.shaded([&](const glm::vec3& p) { return bump.at(p); },
                                    [&](const glm::vec3& p) { return bump.normal(p); });
      for (std::size_t v = 0; v < now.size(); ++v) worst = std::max(worst, glm::distance(now[v], before[v]));
      before = now;
    }
    slopes.push_back(worst * static_cast<float>(steps) / kSteepest);
    std::printf("  %d steps: the largest is %.1f a unit of height\n", steps, double{slopes.back()});
  }
  EXPECT_LT(slopes[1], 1.5f * slopes[0]) << "a jump stays as steps shrink";
}

// A second bump begins to rise next to a steep one: nothing may jump as it starts.
TEST_P(ShadingNormalsContinuity, AreContinuousAsAVertexStartsToMove) {
  Raised sheet;
  sheet.softensRims = GetParam();
  const Bump steep{0.3f, 0.2f};
  float worst = 0.0f;
  for (int column = -10; column <= 10; ++column) {
    const auto heightWith = [&](float more) {
      return [&, more](const glm::vec3& p) {
        const bool here = std::abs(p.x - kNormalsEdge * static_cast<float>(column)) < 0.1f * kNormalsEdge &&
                          std::abs(p.y) < 0.1f * kNormalsEdge;
        return steep.at(p) + (here ? more : 0.0f);
      };
    };
    const auto normal = [&](const glm::vec3& p) { return steep.normal(p); };
    const auto still = sheet.shaded(heightWith(0.0f), normal);
    const auto stirred = sheet.shaded(heightWith(1e-6f), normal);
    for (std::size_t v = 0; v < still.size(); ++v) worst = std::max(worst, turnInDegrees(still[v], stirred[v]));
  }
  std::printf("  a vertex that begins to move turns normals by up to %.4f degrees\n", double{worst});
  EXPECT_LT(worst, 0.05f);
}

}  // namespace
}  // namespace sinew::test
