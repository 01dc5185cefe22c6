// tests/support/characters/morphing_post.cpp: random deltas on the twelve vertices of a post.
#include "tests/support/characters/morphing_post.h"

#include <cmath>

#include "tests/support/rigs/random_rigs.h"

namespace sinew::test {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t kVertices = 12;
constexpr float kMost = 0.25f;

int floats(GltfBuilder& file, const std::vector<float>& deltas) { return file.accessor(deltas, "VEC3"); }

int sparse(GltfBuilder& file, const std::vector<float>& deltas) {
  std::vector<std::uint16_t> indices;
  std::vector<float> values;
  for (std::size_t v = 0; v < kVertices; ++v) {
    if (deltas[3 * v] == 0.0f && deltas[3 * v + 1] == 0.0f && deltas[3 * v + 2] == 0.0f) continue;
    indices.push_back(static_cast<std::uint16_t>(v));
    values.insert(values.end(), deltas.begin() + static_cast<std::ptrdiff_t>(3 * v),
                  deltas.begin() + static_cast<std::ptrdiff_t>(3 * v + 3));
  }
  ordered_json accessor{{"componentType", 5126}, {"type", "VEC3"}, {"count", kVertices}};
  accessor["sparse"] = {{"count", indices.size()},
                        {"indices", {{"bufferView", file.viewOf(indices)}, {"componentType", 5123}}},
                        {"values", {{"bufferView", file.viewOf(values)}}}};
  file.json["accessors"].push_back(accessor);
  return static_cast<int>(file.json["accessors"].size()) - 1;
}

/// Four components per vertex, the last one padding.
int shorts(GltfBuilder& file, const std::vector<float>& deltas) {
  std::vector<std::int16_t> packed;
  for (const float delta : deltas) packed.push_back(static_cast<std::int16_t>(std::lround(delta * 32767.0f)));
  return file.accessor(packed, "VEC3", true);
}

}  // namespace

std::string morphName(int target) { return (target % 2 == 0 ? "bulge." : "dent.") + std::to_string(target); }

void setWeightKeys(Post& post, const std::vector<float>& times, const std::vector<float>& values,
                   const std::string& interpolation) {
  ordered_json& clip = post.file.json["animations"][0];
  auto& channels = clip["channels"];
  for (std::size_t i = channels.size(); i-- > 0;) {
    if (channels[i]["target"]["path"] == "weights") channels.erase(i);
  }
  channels.push_back({{"sampler", clip["samplers"].size()}, {"target", {{"node", 0}, {"path", "weights"}}}});
  clip["samplers"].push_back({{"input", post.file.accessor(times, "SCALAR")},
                              {"output", post.file.accessor(values, "SCALAR")},
                              {"interpolation", interpolation}});
}

Post makeMorphingPost(int targets, std::uint64_t seed, DeltaForm form) {
  Post post = makePost();
  Random random(seed);
  ordered_json names = ordered_json::array();
  ordered_json weights = ordered_json::array();
  for (int k = 0; k < targets; ++k) {
    std::vector<float> deltas(3 * kVertices, 0.0f);
    for (std::size_t v = 0; v < kVertices; ++v) {
      if (!random.chance(0.6f)) continue;
      for (std::size_t axis = 0; axis < 3; ++axis) deltas[3 * v + axis] = random.uniform(-kMost, kMost);
    }
    const int accessor = form == DeltaForm::kFloats   ? floats(post.file, deltas)
                         : form == DeltaForm::kSparse ? sparse(post.file, deltas)
                                                      : shorts(post.file, deltas);
    post.primitive()["targets"].push_back({{"POSITION", accessor}});
    names.push_back(morphName(k));
    weights.push_back(0);
  }
  post.file.json["meshes"][0]["weights"] = weights;
  post.file.json["meshes"][0]["extras"]["targetNames"] = names;
  std::vector<float> keys;
  for (int key = 0; key < 3 * targets; ++key) keys.push_back(random.uniform(-0.5f, 1.5f));
  if (targets > 0) setWeightKeys(post, {0.0f, 0.3f, 1.0f}, keys, "LINEAR");
  return post;
}

}  // namespace sinew::test
