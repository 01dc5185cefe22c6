// tests/support/characters/morphing_post.h: a post with morph targets in every form that glTF allows.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/support/characters/gltf_builder.h"

namespace sinew::test {

/// Storage of a target's deltas in the file.
enum class DeltaForm { kFloats, kSparse, kShorts };

/// makePost() with `targets` targets of random deltas, names in extras, weights 0.
///   clip 0 "bend" also has linear keys of all weights at 0, 0.3 and 1 s.
/// @param form  kShorts: normalized, as KHR_mesh_quantization allows
[[nodiscard]] Post makeMorphingPost(int targets, std::uint64_t seed, DeltaForm form = DeltaForm::kFloats);

[[nodiscard]] std::string morphName(int target);  ///< "bulge.0", "dent.1", "bulge.2" ...

/// Replaces the keys of weights. @param values  [keys * targets], or [keys * 3 * targets] for "CUBICSPLINE"
void setWeightKeys(Post& post, const std::vector<float>& times, const std::vector<float>& values,
                   const std::string& interpolation);

}  // namespace sinew::test
