// tests/support/surface/coherence.h: steps of the skin between frames over all clips, and the causes of large ones.
#pragma once

#include <map>
#include <string>

#include "tests/support/rigs/trial_scenes.h"

namespace sinew::test {

constexpr float kFarStep = 0.01f;  ///< Fraction of H in a frame of 1/60 s that counts as far.

/// The first that applies.
enum class StepCause {
  kFolds,        ///< Fold removal moved the vertex further than its projection did.
  kCrossing,     ///< `replace`: the skin passed the surface F = T.
  kAnchor,       ///< `replace`: the anchor came to be inside, or no longer is.
  kRoots,        ///< `replace`: a stretch of F > T appeared or vanished.
  kShares,       ///< `replace`: more than half of it is due to changed weights of intervals.
  kOverhang,     ///< phi is not monotone between the two places on the ray: air lies between them.
  kMuscle,       ///< No further than a muscle there moved against the skin, which moved further than the ray.
  kSwingingRay,  ///< No further than the ray moved at the root.
  kSteepFlank,   ///< Further than anything that moved it.
};

/// As the enumerator is written.
[[nodiscard]] const char* nameOf(StepCause cause);

/// One vertex between two frames.
struct Step {
  float size = 0.0f;  ///< Fraction of H, in the frame that rides on the patch.
  int vertex = 0;
  std::string clip;
  float time = 0.0f;    ///< Time of the later frame.
  std::string details;  ///< Numbers of far steps, to look into them.
};

struct FarSteps {
  long long count = 0;
  Step largest;
};

struct Coherence {
  int frames = 0;
  long long vertexSteps = 0;  ///< Vertices in frames.
  Step largest;
  std::map<StepCause, FarSteps> far;

  [[nodiscard]] long long farSteps() const;
};

/// Smooths every clip at 60 frames a second with and without the rig's muscles. Brute force (oracle.h) finds the causes
/// of large steps.
[[nodiscard]] Coherence walkClips(const TrialScene& scene, const Rig& rig);

}  // namespace sinew::test
