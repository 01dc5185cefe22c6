// tests/support/surface/pops.h: how often skin steps far within a frame, and how often it does so at once.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/rig/rig.h"

namespace sinew::test {

// Fractions of H, against the patch at the vertex: in its own frame, or in the world's where that is less.
constexpr float kStep = 0.005f;   ///< Move within 1/60 s that counts as a step.
constexpr float kKept = 0.0015f;  ///< What a pop keeps of its step within its fastest 26 microseconds.

/// A vertex that pops.
struct PopPlace {
  std::string clip;
  double time = 0.0;        ///< Seconds, at which its fastest 26 microseconds begin.
  int vertex = 0;           ///< Refined.
  int controlTriangle = 0;  ///< One that it lies in.
  float step = 0.0f;        ///< Within 1/60 s, fraction of H.
  float kept = 0.0f;        ///< Within those 26 microseconds.
  float ofRoot = 0.0f;      ///< The same of projection alone, before the mesh bounds, filters and unfolds heights.
};

/// Moves of refined vertices over time.
struct Pops {
  int frames = 0;
  long long steps = 0;                ///< Vertices that move by more than kStep from one frame to the next.
  long long pops = 0;                 ///< Those of them that keep more than kKept.
  float largestStep = 0.0f;           ///< Fraction of H.
  float largestPop = 0.0f;            ///< Move within 1/60 s of the farthest vertex that pops, fraction of H.
  double turned = 0.0;                ///< Degrees between shading normal and patch normal, summed over moved vertices.
  long long moved = 0;                ///< Those vertices.
  long long backs = 0;                ///< Pixels (visible_backs.h), every fifteenth frame.
  long long bareBacks = 0;            ///< Of the bare skin in the same pictures.
  long long moreBacks = 0;            ///< Of the frames that show more than the bare skin, by how much they do.
  std::vector<PopPlace> places = {};  ///< [pops]

  /// Definition: mean degrees that muscles turn the normals of skin that they move.
  [[nodiscard]] double definition() const { return moved > 0 ? turned / static_cast<double>(moved) : 0.0; }

  void add(const Pops& other);
};

/// Over all clips at 60 frames a second. What steps is followed into the fastest tenth of its frame, then into the
/// faster half six times over.
/// @param mostFrames  of each clip.
[[nodiscard]] Pops countPops(const std::shared_ptr<const Character>& character, const Rig& rig,
                             int mostFrames = 100'000);

}  // namespace sinew::test
