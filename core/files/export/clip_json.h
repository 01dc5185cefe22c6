// core/files/export/clip_json.h: clips of the file as JSON: what they are called, and channels that are added to them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/files/export/gltf_rewrite.h"
#include "sinew/character/animation_clip.h"
#include "sinew/geometry/morph_target.h"

namespace sinew::exporting {

/// As the import names it.
[[nodiscard]] std::string clipName(const Json& clip, int index);

/// A clip of its own at the end of the file's.
/// @param fileNode  [skeleton nodes]  @param targets  of the character
void addClip(const AnimationClip& clip, std::span<const int> fileNode, std::span<const MorphTarget> targets,
             GltfRewrite& rewrite);

/// An accessor of key times. @param times  seconds, rising, not empty
[[nodiscard]] int addTimes(const std::vector<float>& times, GltfRewrite& rewrite);

/// Linear between keys. Returns the sampler's number in the clip. @param input, output  accessors
int addSampler(int clip, int input, int output, GltfRewrite& rewrite);
/// Of weights of morph targets. @param weights  [times * targets]
int addWeightSampler(int clip, const std::vector<float>& times, const std::vector<float>& weights,
                     GltfRewrite& rewrite);
/// @param sampler  of the clip  @param path  "translation", "weights" ...
void addChannel(int clip, int sampler, int node, const char* path, GltfRewrite& rewrite);

}  // namespace sinew::exporting
