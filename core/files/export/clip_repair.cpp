// core/files/export/clip_repair.cpp: reads samplers, sorts them, starts them at 0 and writes them again.
#include "core/files/export/clip_repair.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include <glm/gtc/quaternion.hpp>

#include "core/files/gltf/accessor.h"
#include "core/geometry/at.h"

namespace sinew::exporting {
namespace {

constexpr float kToldWithin = 1e-4f;  ///< Validators accept rotations whose length differs less from 1.

enum class ClipRepairKeys { kStep, kLinear, kCubic };

struct KeyTrack {
  ClipRepairKeys kind = ClipRepairKeys::kLinear;
  bool turns = false;      ///< Rotations.
  std::size_t width = 0;   ///< Numbers of a value.
  std::size_t perKey = 0;  ///< Numbers of a key: cubic keys have a value between two tangents.
  std::vector<float> times;
  std::vector<float> values;

  [[nodiscard]] float* key(std::size_t k) { return &values[k * perKey]; }
  [[nodiscard]] float* value(std::size_t k) { return key(k) + (kind == ClipRepairKeys::kCubic ? width : 0); }
};

/// Sorts keys; the last of equal times remains.
bool sortKeys(KeyTrack& track) {
  if (std::ranges::adjacent_find(track.times, std::ranges::greater_equal()) == track.times.end()) return false;
  std::vector<std::size_t> order(track.times.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return track.times[k]; });
  KeyTrack sorted = track;
  sorted.times.clear();
  sorted.values.clear();
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i + 1 < order.size() && track.times[order[i]] == track.times[order[i + 1]]) continue;
    sorted.times.push_back(track.times[order[i]]);
    sorted.values.insert(sorted.values.end(), track.key(order[i]), track.key(order[i]) + track.perKey);
  }
  track = std::move(sorted);
  return true;
}

glm::quat quatAt(const float* value) { return glm::quat(value[3], value[0], value[1], value[2]); }

/// The key at the fraction `share` between key k and the next, `span` seconds later.
std::vector<float> keyBetween(KeyTrack& track, std::size_t k, float share, float span) {
  std::vector<float> made(track.key(k), track.key(k) + track.perKey);
  if (track.kind == ClipRepairKeys::kStep) return made;
  float* const value = made.data() + (track.kind == ClipRepairKeys::kCubic ? track.width : 0);
  if (track.kind == ClipRepairKeys::kLinear && track.turns) {
    const glm::quat turn =
        glm::slerp(glm::normalize(quatAt(track.value(k))), glm::normalize(quatAt(track.value(k + 1))), share);
    const float numbers[] = {turn.x, turn.y, turn.z, turn.w};
    std::ranges::copy(numbers, value);
    return made;
  }
  const float u2 = share * share;
  const float u3 = u2 * share;
  for (std::size_t i = 0; i < track.width; ++i) {
    const float a = track.value(k)[i];
    const float b = track.value(k + 1)[i];
    if (track.kind == ClipRepairKeys::kLinear) {
      value[i] = a + (b - a) * share;
      continue;
    }
    const float out = track.value(k)[track.width + i] * span;
    const float in = track.key(k + 1)[i] * span;
    value[i] = (2 * u3 - 3 * u2 + 1) * a + (u3 - 2 * u2 + share) * out + (-2 * u3 + 3 * u2) * b + (u3 - u2) * in;
    made[i] = 0.0f;
    value[track.width + i] =
        ((6 * u2 - 6 * share) * (a - b) + (3 * u2 - 4 * share + 1) * out + (3 * u2 - 2 * share) * in) / span;
  }
  return made;
}

/// Replaces keys before 0 by their value at 0.
bool beginAtZero(KeyTrack& track) {
  if (!(track.times.front() < 0.0f)) return false;
  const auto before = static_cast<std::size_t>(std::ranges::lower_bound(track.times, 0.0f) - track.times.begin());
  std::vector<float> first;
  if (before == track.times.size()) {
    first.assign(track.key(before - 1), track.key(before - 1) + track.perKey);
  } else if (track.times[before] > 0.0f) {
    const float span = track.times[before] - track.times[before - 1];
    first = keyBetween(track, before - 1, -track.times[before - 1] / span, span);
  }
  const std::size_t gone = first.empty() ? before : before - 1;
  track.times.erase(track.times.begin(), track.times.begin() + static_cast<std::ptrdiff_t>(gone));
  track.values.erase(track.values.begin(), track.values.begin() + static_cast<std::ptrdiff_t>(gone * track.perKey));
  if (first.empty()) return true;
  track.times.front() = 0.0f;
  std::ranges::copy(first, track.values.begin());
  return true;
}

/// Normalizes rotations, except in splines, whose values do not play as they are.
bool makeUnit(KeyTrack& track) {
  bool changed = false;
  for (std::size_t k = 0; track.turns && track.kind != ClipRepairKeys::kCubic && k < track.times.size(); ++k) {
    float* const value = track.value(k);
    const float length = std::sqrt(std::inner_product(value, value + 4, value, 0.0f));
    if (std::abs(length - 1.0f) <= kToldWithin) continue;
    changed = true;
    for (std::size_t i = 0; i < 4; ++i) value[i] = length > 0.0f ? value[i] / length : i == 3 ? 1.0f : 0.0f;
  }
  return changed;
}

class ClipRepair {
 public:
  ClipRepair(Source& source, GltfRewrite& rewrite, std::set<std::string>& left)
      : source_(source), rewrite_(rewrite), left_(left) {}

  void run() {
    const auto clips = static_cast<int>(rewrite_.root().at("animations").items().size());
    for (int clip = 0; clip < clips; ++clip) {
      Json made = rewrite_.element("animations", clip);
      repair(made, gltf::placeOf("animations", toIndex(clip)));
      rewrite_.element("animations", clip) = std::move(made);
    }
  }

 private:
  void repair(Json& clip, const std::string& place) {
    Json* const channels = memberOf(clip, "channels");
    Json* const samplers = memberOf(clip, "samplers");
    if (!channels || !samplers) return;
    std::set<std::pair<double, std::string>> driven;
    std::set<double> done;
    std::erase_if(channels->children, [&](const Json& channel) {
      const Json& target = channel.at("target");
      const double node = target.at("node").number(-1.0);
      const std::string path = target.at("path").text("");
      if (node < 0.0) return false;  // of an extension
      if (isPlacedByMatrix(node, path)) return leave("nodes that a matrix places: such nodes stay still");
      if (!driven.emplace(node, path).second) return leave("a property that another channel moves: the first plays");
      const double sampler = channel.at("sampler").number(-1.0);
      if (!(sampler >= 0.0 && sampler < static_cast<double>(samplers->children.size()))) {
        return leave("which there are no keys");
      }
      if (!done.insert(sampler).second) return false;
      const bool isRead = repairKeys(samplers->children[static_cast<std::size_t>(sampler)], node, path, place);
      return !isRead && leave("which the keys cannot be read");
    });
  }

  bool leave(const std::string& of) {
    left_.insert("animation channels for " + of);
    return true;
  }

  [[nodiscard]] bool isPlacedByMatrix(double node, const std::string& path) const {
    const std::vector<Json>& nodes = source_.root.at("nodes").items();
    return path != "weights" && node < static_cast<double>(nodes.size()) &&
           nodes[static_cast<std::size_t>(node)].find("matrix") != nullptr;
  }

  /// False: unreadable.
  bool repairKeys(Json& sampler, double node, const std::string& path, const std::string& place) {
    try {
      std::optional<KeyTrack> track = read(sampler, node, path, place);
      if (!track) return false;
      const bool isCut = track->values.size() != given_;
      const bool isSorted = sortKeys(*track);
      const bool isEarly = beginAtZero(*track);
      const bool isUnit = makeUnit(*track);
      if (isSorted)
        left_.insert("key times that fall or repeat, which glTF does not allow: they are sorted, as played");
      if (isEarly)
        left_.insert("keys before 0 seconds, which glTF does not allow: the clip begins with what they lead to");
      if (isUnit)
        left_.insert("rotations that are no unit quaternions, which glTF does not allow: they are, as played");
      if (isCut || isSorted || isEarly || isUnit) write(*track, sampler);
      return true;
    } catch (const gltf::Refusal&) {
      return false;
    }
  }

  /// nullopt: no keys, too few values, or values that are not finite.
  std::optional<KeyTrack> read(const Json& sampler, double node, const std::string& path, const std::string& place) {
    const gltf::Accessor& input = source_.accessors.open(sampler.at("input"), place, TINYGLTF_TYPE_SCALAR);
    const gltf::Accessor& output =
        source_.accessors.open(sampler.at("output"), place, typeOf(path), TINYGLTF_TYPE_SCALAR);
    KeyTrack track;
    const std::string mode = sampler.at("interpolation").text("LINEAR");
    track.kind = mode == "STEP"          ? ClipRepairKeys::kStep
                 : mode == "CUBICSPLINE" ? ClipRepairKeys::kCubic
                                         : ClipRepairKeys::kLinear;
    track.turns = path == "rotation";
    type_ = output.components() == 1 ? "SCALAR" : output.components() == 3 ? "VEC3" : "VEC4";
    track.width = path == "weights" ? targetsOf(node) : toIndex(output.components());
    track.perKey = track.width * (track.kind == ClipRepairKeys::kCubic ? 3 : 1);
    given_ = output.count() * toIndex(output.components());
    if (input.count() == 0 || track.perKey == 0 || given_ / track.perKey < input.count()) return std::nullopt;
    for (std::size_t k = 0; k < input.count(); ++k) track.times.push_back(static_cast<float>(input.number(k, 0)));
    track.values.reserve(input.count() * track.perKey);
    for (std::size_t i = 0; i < input.count() * track.perKey; ++i) {
      const std::size_t element = i / toIndex(output.components());
      track.values.push_back(static_cast<float>(output.number(element, static_cast<int>(i) % output.components())));
    }
    const auto isSound = [](float number) { return std::isfinite(number); };
    if (!std::ranges::all_of(track.times, isSound) || !std::ranges::all_of(track.values, isSound)) return std::nullopt;
    return track;
  }

  static int typeOf(const std::string& path) {
    if (path == "weights") return TINYGLTF_TYPE_SCALAR;
    return path == "rotation" ? TINYGLTF_TYPE_VEC4 : TINYGLTF_TYPE_VEC3;
  }

  [[nodiscard]] std::size_t targetsOf(double node) const {
    const std::vector<Json>& nodes = source_.root.at("nodes").items();
    if (!(node < static_cast<double>(nodes.size()))) return 0;
    const double mesh = nodes[static_cast<std::size_t>(node)].at("mesh").number(-1.0);
    const std::vector<Json>& meshes = source_.root.at("meshes").items();
    if (!(mesh >= 0.0 && mesh < static_cast<double>(meshes.size()))) return 0;
    const std::vector<Json>& primitives = meshes[static_cast<std::size_t>(mesh)].at("primitives").items();
    return primitives.empty() ? 0 : primitives.front().at("targets").items().size();
  }

  void write(const KeyTrack& track, Json& sampler) {
    sampler.set("input", addTimes(track.times, rewrite_));
    const std::size_t components = type_ == "SCALAR" ? 1 : type_ == "VEC3" ? 3 : 4;
    sampler.set("output", rewrite_.addAccessor({bytesOf(track.values), TINYGLTF_COMPONENT_TYPE_FLOAT, type_,
                                                track.values.size() / components}));
  }

  Source& source_;
  GltfRewrite& rewrite_;
  std::set<std::string>& left_;
  std::string type_;       ///< Of the current output.
  std::size_t given_ = 0;  ///< Numbers of the current output.
};

}  // namespace

void repairClips(Source& source, GltfRewrite& rewrite, std::set<std::string>& left) {
  ClipRepair(source, rewrite, left).run();
}

}  // namespace sinew::exporting
