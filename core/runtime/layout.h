// core/runtime/layout.h: the layout of a game file. A member added to one of these structs does not compile here until
// it is written or left out on purpose; then raise kVersion in core/runtime/game_file.h.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/geometry/geometry.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew::gamefile {

// Writer and Reader have the same calls, so that fields() below defines the order for both.

static_assert(std::endian::native == std::endian::little, "numbers are copied as they lie in memory");

inline constexpr std::uint32_t kMostTextBytes = 65536;

/// Only floats, without padding.
template <class T>
inline constexpr bool kIsFloats =
    std::is_same_v<T, float> || std::is_same_v<T, glm::vec2> || std::is_same_v<T, glm::vec3> ||
    std::is_same_v<T, glm::vec4> || std::is_same_v<T, glm::quat> || std::is_same_v<T, glm::mat4>;

class Writer {
 public:
  template <class T>
  using Ref = const T&;

  void number(int value) { put(&value, sizeof value); }
  template <class T>
  void floats(const T& value) {
    static_assert(kIsFloats<T>);
    put(&value, sizeof value);
  }
  void flag(bool value) { byte(value ? 1 : 0); }
  /// @param last  the largest value
  template <class Enum>
  void choice(Enum value, Enum /*last*/) {
    byte(static_cast<std::uint8_t>(value));
  }
  void text(const std::string& value) {
    const std::size_t size = std::min<std::size_t>(value.size(), kMostTextBytes);
    count(size);
    put(value.data(), size);
  }
  template <class T>
  void floatList(const std::vector<T>& values) {
    static_assert(kIsFloats<T>);
    count(values.size());
    put(values.data(), values.size() * sizeof(T));
  }
  void numberList(const std::vector<int>& values) {
    count(values.size());
    put(values.data(), values.size() * sizeof(int));
  }
  /// List of items with fields(). @param least  bytes of the shortest item
  template <class T>
  void list(const std::vector<T>& values, std::size_t least) {
    list(values, least, [this](const T& value) { fields(*this, value); });
  }
  template <class T, class Item>
  void list(const std::vector<T>& values, std::size_t /*least*/, Item item) {
    count(values.size());
    for (const T& value : values) item(value);
  }
  template <class T, class Item>
  void maybe(const std::optional<T>& value, Item item) {
    flag(value.has_value());
    if (value) item(*value);
  }
  void section(const char* /*name*/) {}
  [[nodiscard]] bool failed() const { return false; }

  [[nodiscard]] std::vector<std::byte>& bytes() { return bytes_; }

 private:
  void byte(std::uint8_t value) { put(&value, 1); }
  void count(std::size_t size) {
    const auto number = static_cast<std::uint32_t>(size);
    put(&number, sizeof number);
  }
  void put(const void* from, std::size_t size) {
    const auto* const begin = static_cast<const std::byte*>(from);
    bytes_.insert(bytes_.end(), begin, begin + size);
  }

  std::vector<std::byte> bytes_;
};

/// After the first error, all that is read is empty and nothing more is allocated.
class Reader {
 public:
  template <class T>
  using Ref = T&;

  explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  void number(int& value) { take(&value, sizeof value); }
  template <class T>
  void floats(T& value) {
    static_assert(kIsFloats<T>);
    take(&value, sizeof value);
    if (!areFinite(&value, 1)) refuse("a number is not finite");
  }
  void flag(bool& value) { value = byteUpTo(1) != 0; }
  template <class Enum>
  void choice(Enum& value, Enum last) {
    value = static_cast<Enum>(byteUpTo(static_cast<std::uint8_t>(last)));
  }
  void text(std::string& value) {
    const std::size_t size = count(1);
    if (size > kMostTextBytes) return refuse("a text is longer than " + std::to_string(kMostTextBytes) + " bytes");
    value.resize(size);
    take(value.data(), size);
  }
  template <class T>
  void floatList(std::vector<T>& values) {
    static_assert(kIsFloats<T>);
    values.resize(count(sizeof(T)));
    take(values.data(), values.size() * sizeof(T));
    if (!areFinite(values.data(), values.size())) refuse("a number is not finite");
  }
  void numberList(std::vector<int>& values) {
    values.resize(count(sizeof(int)));
    take(values.data(), values.size() * sizeof(int));
  }
  template <class T>
  void list(std::vector<T>& values, std::size_t least) {
    list(values, least, [this](T& value) { fields(*this, value); });
  }
  template <class T, class Item>
  void list(std::vector<T>& values, std::size_t least, Item item) {
    values.resize(count(least));
    for (T& value : values) {
      if (failed()) return;
      item(value);
    }
  }
  template <class T, class Item>
  void maybe(std::optional<T>& value, Item item) {
    if (byteUpTo(1) != 0) item(value.emplace());
  }
  void section(const char* name) { section_ = name; }  ///< Names the part that is read next, for errors.

  [[nodiscard]] bool failed() const { return error_.has_value(); }
  [[nodiscard]] const Error& error() const { return *error_; }  ///< Only when failed().
  [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }
  void refuse(const std::string& reason) {
    if (!error_) error_ = errorAt(std::string(section_) + ", byte " + std::to_string(at_), reason);
  }

 private:
  template <class T>
  static bool areFinite(const T* values, std::size_t size) {
    const auto* const numbers = reinterpret_cast<const float*>(values);
    for (std::size_t i = 0; i < size * (sizeof(T) / sizeof(float)); ++i) {
      if (!std::isfinite(numbers[i])) return false;
    }
    return true;
  }
  std::uint8_t byteUpTo(std::uint8_t most) {
    std::uint8_t value = 0;
    take(&value, 1);
    if (value <= most) return value;
    refuse("expected a number from 0 to " + std::to_string(most) + ", got " + std::to_string(value));
    return 0;
  }
  /// Number of items of at least `least` bytes each: no more than the rest of the file can hold.
  std::size_t count(std::size_t least) {
    std::uint32_t size = 0;
    take(&size, sizeof size);
    if (size <= left() / least) return size;
    refuse(std::to_string(size) + " items are more than the rest of the file can hold");
    return 0;
  }
  void take(void* to, std::size_t size) {
    if (size == 0) return;
    if (failed() || size > left()) {
      refuse("the file ends too early");
      std::memset(to, 0, size);
      return;
    }
    std::memcpy(to, bytes_.data() + at_, size);
    at_ += size;
  }

  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
  const char* section_ = "";
  std::optional<Error> error_;
};

// Bytes of the shortest item of a list.
inline constexpr std::size_t kCountBytes = 4;
inline constexpr std::size_t kTextBytes = kCountBytes;

template <class A>
void fields(A& a, typename A::template Ref<std::string> text) {
  a.text(text);
}

template <class A>
void fields(A& a, typename A::template Ref<Node> value) {
  auto& [name, parent, rest] = value;
  auto& [translation, rotation, scale, matrix] = rest;
  a.text(name);
  a.number(parent);
  a.floats(translation);
  a.floats(rotation);
  a.floats(scale);
  a.maybe(matrix, [&](auto& m) { a.floats(m); });
}

/// Without members that follow from nodes and finishBones().
template <class A>
void fields(A& a, typename A::template Ref<Bone> value) {
  auto& [name, path, node, parent, children, bindInWorld, inverseBindInWorld, tip] = value;
  a.text(name);
  a.number(node);
  a.floats(bindInWorld);
}

template <class A>
void fields(A& a, typename A::template Ref<Binding> value) {
  auto& [bone, inverseBind] = value;
  a.number(bone);
  a.floats(inverseBind);
}

template <class A>
void fields(A& a, typename A::template Ref<Influence> value) {
  auto& [binding, weight] = value;
  a.number(binding);
  a.floats(weight);
}

/// Creases are made when a rig is prepared.
template <class A>
void fields(A& a, typename A::template Ref<Wedge> value) {
  auto& [vertex, uv, color, creased, normal, fan] = value;
  a.number(vertex);
  a.floats(uv);
  a.floats(color);
}

/// Edges follow from the vertices.
template <class A>
void fields(A& a, typename A::template Ref<ControlTriangle> value) {
  auto& [vertices, wedges, edges, material, part] = value;
  for (auto& vertex : vertices) a.number(vertex);
  for (auto& wedge : wedges) a.number(wedge);
  a.number(material);
  a.number(part);
}

/// Normals and edges follow from the rest.
template <class A>
void fields(A& a, typename A::template Ref<ControlMesh> value) {
  auto& [positions, normals, influenceBegin, influences, wedges, edges, triangles, trianglesDropped] = value;
  a.section("mesh");
  a.floatList(positions);
  a.numberList(influenceBegin);
  a.list(influences, 8);
  a.list(wedges, 28);
  a.list(triangles, 32);
}

template <class A>
void fields(A& a, typename A::template Ref<MorphTarget> value) {
  auto& [name, node, weight, vertices, deltas] = value;
  a.text(name);
  a.number(node);
  a.floats(weight);
  a.numberList(vertices);
  a.floatList(deltas);
}

template <class A>
void fields(A& a, typename A::template Ref<MorphSet::Share> value) {
  auto& [target, share] = value;
  a.number(target);
  a.floats(share);
}

template <class A>
void fields(A& a, typename A::template Ref<MorphSet> value) {
  auto& [name, shares] = value;
  a.text(name);
  a.list(shares, 8);
}

template <class A>
void fields(A& a, typename A::template Ref<BodyPart> value) {
  auto& [slot, bone] = value;
  a.text(slot);
  a.number(bone);
}

template <class A>
void fields(A& a, typename A::template Ref<Channel> value) {
  auto& [node, path, interpolation, times, values] = value;
  a.number(node);
  a.choice(path, ChannelPath::kScale);
  a.choice(interpolation, Interpolation::kCubicSpline);
  a.floatList(times);
  a.floatList(values);
}

template <class A>
void fields(A& a, typename A::template Ref<MorphChannel> value) {
  auto& [firstTarget, targets, interpolation, times, values] = value;
  a.number(firstTarget);
  a.number(targets);
  a.choice(interpolation, Interpolation::kCubicSpline);
  a.floatList(times);
  a.floatList(values);
}

template <class A>
void fields(A& a, typename A::template Ref<AnimationClip> value) {
  auto& [name, duration, channels, turnsBindPose, morphChannels, addedFrom] = value;
  a.text(name);
  a.floats(duration);
  a.flag(turnsBindPose);
  a.list(channels, 14);
  a.list(morphChannels, 17);
}

/// Only the name.
template <class A>
void fields(A& a, typename A::template Ref<Material> value) {
  a.text(value.name);
}

template <class A>
void fields(A& a, typename A::template Ref<MeshPart> value) {
  auto& [name, material] = value;
  a.text(name);
  a.number(material);
}

template <class A>
void fields(A& a, typename A::template Ref<Character> value) {
  auto& [name, mesh, morphTargets, morphSets, skeleton, bodyParts, clips, materials, textures, parts, ignored, height] =
      value;
  a.section("character");
  a.text(name);
  a.floats(height);
  a.list(materials, kTextBytes);
  a.list(parts, kTextBytes + 4);
  a.section("skeleton");
  a.list(skeleton.nodes, 49);
  a.list(skeleton.bones, 72);
  a.list(skeleton.bindings, 68);
  a.list(bodyParts, kTextBytes + 4);
  fields(a, mesh);
  a.section("morph targets");
  a.list(morphTargets, 20);
  a.list(morphSets, kTextBytes + kCountBytes);
  a.section("clips");
  a.list(clips, 17);
}

template <class A>
void fields(A& a, typename A::template Ref<Curve> value) {
  auto& [points, kind] = value;
  a.floatList(points);
  a.choice(kind, CurveKind::kStep);
}

template <class A>
void fields(A& a, typename A::template Ref<KeyTrack> value) {
  auto& [clip, curve, unknownKeys] = value;
  a.text(clip);
  fields(a, curve);
}

template <class A>
void fields(A& a, typename A::template Ref<LineAnchor> value) {
  auto& [bone, point, unknownKeys] = value;
  a.text(bone);
  a.floats(point);
}

template <class A>
void fields(A& a, typename A::template Ref<DriverInput> value) {
  auto& [kind, bone, axis, rotation, width, line, channel, from, to, unknownKeys] = value;
  a.choice(kind, DriverInputKind::kChannel);
  a.text(bone);
  a.floats(axis);
  a.floats(rotation);
  a.floats(width);
  a.text(line);
  a.text(channel);
  fields(a, from);
  fields(a, to);
}

template <class A>
void fields(A& a, typename A::template Ref<Driver> value) {
  auto& [input, curve, mode, unknownKeys] = value;
  fields(a, input);
  fields(a, curve);
  a.choice(mode, DriverMode::kReplace);
}

template <class A>
void fields(A& a, typename A::template Ref<AnimatedNumber> value) {
  auto& [parameter, keys, drivers, unknownKeys] = value;
  a.choice(parameter, Parameter::kLinkAmount);
  a.list(keys, kTextBytes + kCountBytes + 1);
  a.list(drivers, 80);
}

template <class A>
void fields(A& a, typename A::template Ref<RigChannel> value) {
  auto& [name, track] = value;
  a.text(name);
  fields(a, track);
}

inline constexpr std::size_t kAnimatedBytes = 1 + 2 * kCountBytes;

template <class A>
void fields(A& a, typename A::template Ref<SurfaceSettings> value) {
  auto& [mode, iso, skinBlend, grooves, animated, unknownKeys] = value;
  a.choice(mode, SurfaceMode::kReplace);
  a.floats(iso);
  a.floats(skinBlend);
  a.floats(grooves);
  a.list(animated, kAnimatedBytes);
}

template <class A>
void fields(A& a, typename A::template Ref<SmoothingSettings> value) {
  auto& [depth, patch, alongNormals, creaseAngle, detail, tolerance, autoDepth, unknownKeys] = value;
  a.number(depth);
  a.choice(patch, PatchKind::kFlat);
  std::uint8_t projection = alongNormals ? 2 : 0;  // Formerly one of three searches.
  a.choice(projection, std::uint8_t{2});
  if constexpr (!std::is_const_v<std::remove_reference_t<decltype(value)>>) alongNormals = projection == 2;
  a.floats(creaseAngle);
  a.choice(detail, DetailKind::kAdaptive);
  a.floats(tolerance);
  a.flag(autoDepth);
}

template <class A>
void fields(A& a, typename A::template Ref<Group> value) {
  auto& [name, unknownKeys, identity] = value;
  a.text(name);
}

template <class A>
void fields(A& a, typename A::template Ref<Link> value) {
  auto& [groups, amount, animated, unknownKeys] = value;
  for (auto& name : groups) a.text(name);
  a.floats(amount);
  a.list(animated, kAnimatedBytes);
}

template <class A>
void fields(A& a, typename A::template Ref<MuscleLine> value) {
  auto& [name, origin, insertion, via, settings, unknownActivationKeys, mirror, sheet, animated, unknownKeys,
         identity] = value;
  auto& [rest, tendons, volume, limits, pivot, twist, flex, base, gain, full] = settings;
  a.text(name);
  fields(a, origin);
  fields(a, insertion);
  a.maybe(via, [&](auto& anchor) { fields(a, anchor); });
  for (auto* number : {&rest, &volume, &pivot, &twist, &base, &gain, &full}) a.floats(*number);
  for (auto* pair : {&tendons, &limits, &flex}) a.floats(*pair);
  a.text(mirror);
  a.list(animated, kAnimatedBytes);
}

template <class A>
void fields(A& a, typename A::template Ref<Placement> value) {
  auto& [center, rotation, radii, shape] = value;
  auto& [core, belly, bend] = shape;
  a.floats(center);
  a.floats(rotation);
  a.floats(radii);
  a.floats(core);
  a.floats(belly);
  a.floats(bend);
}

template <class A>
void fields(A& a, typename A::template Ref<Primitive> value) {
  auto& [name, bone, group, line, sheet, placement, reach, amount, sign, mirror, territory, animated, unknownKeys,
         identity] = value;
  for (auto* text : {&name, &bone, &group, &line, &mirror}) a.text(*text);
  fields(a, placement);
  a.floats(reach);
  a.floats(amount);
  a.number(sign);
  a.maybe(territory, [&](auto& bones) { a.list(bones, kTextBytes); });
  a.list(animated, kAnimatedBytes);
}

template <class A>
void fields(A& a, typename A::template Ref<MorphWeight> value) {
  auto& [name, weight, animated, unknownKeys] = value;
  a.text(name);
  a.floats(weight);
  a.list(animated, kAnimatedBytes);
}

template <class A>
void fields(A& a, typename A::template Ref<LayerChoice> value) {
  auto& [part, layer] = value;
  a.text(part);
  a.choice(layer, SkinLayer::kRigid);
}

/// Without members for editors: paths, corrected parts of the body, sheets, whose bellies are muscles, unknown keys.
template <class A>
void fields(A& a, typename A::template Ref<Rig> value) {
  auto& [character, surface, smoothing, groups, links, channels, lines, sheets, primitives, slots, morphs, clipFiles,
         layers, unknownKeys] = value;
  a.section("rig");
  fields(a, surface);
  fields(a, smoothing);
  a.list(groups, kTextBytes);
  a.list(links, 2 * kTextBytes + 4 + kCountBytes);
  a.list(channels, 2 * kTextBytes + kCountBytes + 1);
  a.section("lines");
  a.list(lines, 90);
  a.section("muscles");
  a.list(primitives, 93);
  a.section("shapes");
  a.list(morphs, kTextBytes + 8);
  a.list(layers, kTextBytes + 1);
}

}  // namespace sinew::gamefile
