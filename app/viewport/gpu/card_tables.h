// app/viewport/gpu/card_tables.h: a preparation as the shaders read it. Uploaded once.
#pragma once

#include <cstdint>
#include <vector>

#include "app/viewport/gpu/card_layout.h"
#include "core/surface/preparation.h"

namespace sinew::app {

struct CardTables {
  std::vector<std::int32_t> influenceBegin;  ///< [V + 1]
  std::vector<card::Influence> influences;
  std::vector<card::Control> controls;  ///< [V] bind pose.
  std::vector<std::int32_t> fans;       ///< Where the triangles at each control vertex begin [V + 1], then those.
  std::vector<card::Triangle> controlTriangles;  ///< [T]
  std::vector<card::Refined> refined;            ///< [V']
  /// By carrier [C]: where its candidates begin [C + 1], its set of cliques [C]; where the sets' cliques begin
  /// [sets + 1]; cliques, a bit a slot, two words each.
  std::vector<std::int32_t> seen;
  std::vector<card::Candidate> candidates;
  std::vector<card::Ring> rings;        ///< [V']
  std::vector<std::int32_t> neighbors;  ///< Then the vertices across.
  std::vector<std::int32_t> corners;
  std::vector<card::Triangle> triangles;   ///< [T']
  std::vector<std::int32_t> drawVertices;  ///< [D]
  std::vector<card::Anchor> anchors;       ///< [V'] in `replace`, else empty.
  std::vector<float> omegas;               ///< [V'] likewise: how far each goes to the muscles' surface.
  card::Making making;
};

/// @param preparation  one that is not leftToProcessor (coverage.h)
[[nodiscard]] CardTables cardTables(const Preparation& preparation);

}  // namespace sinew::app
