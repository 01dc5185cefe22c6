// core/runtime/layout.h: the order of everything in a game file. A member that is added to one of these structs does
// not compile here until it is written, or left out on purpose; then kVersion in core/runtime/game_file.h counts on.
#pragma once

#include "core/runtime/archive.h"
#include "sinew/character/character.h"
#include "sinew/rig/rig.h"

namespace sinew::gamefile {

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

/// What finishBones() and the nodes do not tell.
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

/// The name alone.
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
  a.choice(parameter, Parameter::kMorphWeight);
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
  auto& [mode, iso, skinBlend, animated, unknownKeys] = value;
  a.choice(mode, SurfaceMode::kReplace);
  a.floats(iso);
  a.floats(skinBlend);
  a.list(animated, kAnimatedBytes);
}

template <class A>
void fields(A& a, typename A::template Ref<SmoothingSettings> value) {
  auto& [depth, patch, creaseAngle, detail, tolerance, autoDepth, unknownKeys] = value;
  a.number(depth);
  a.choice(patch, PatchKind::kFlat);
  std::uint8_t projection = 0;  // Once one of three; without meaning now.
  a.choice(projection, std::uint8_t{2});
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
void fields(A& a, typename A::template Ref<std::array<std::string, 2>> value) {
  for (auto& name : value) a.text(name);
}

template <class A>
void fields(A& a, typename A::template Ref<MuscleLine> value) {
  auto& [name, origin, insertion, via, settings, unknownActivationKeys, mirror, animated, unknownKeys, identity] =
      value;
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
  auto& [name, bone, group, line, placement, reach, amount, sign, mirror, territory, animated, unknownKeys, identity] =
      value;
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

/// Without what only an editor asks: paths, corrected parts of the body, keys from the future.
template <class A>
void fields(A& a, typename A::template Ref<Rig> value) {
  auto& [character, surface, smoothing, groups, links, channels, lines, primitives, slots, morphs, clipFiles, layers,
         unknownKeys] = value;
  a.section("rig");
  fields(a, surface);
  fields(a, smoothing);
  a.list(groups, kTextBytes);
  a.list(links, 2 * kTextBytes);
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
