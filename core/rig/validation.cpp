// core/rig/validation.cpp: the checks of a rig; errors name JSON paths.
#include "core/rig/validation.h"

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/character/body_slots.h"
#include "core/geometry/affine_image.h"
#include "core/rig/mesh_layers.h"
#include "core/rig/rig_edit.h"
#include "core/rig/sheet_edit.h"

namespace sinew {

std::string numberText(float value) {
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value > 0.0f ? "infinity" : "-infinity";
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

Error outOfRange(std::string place, const std::string& expected, float value, std::string subject) {
  return errorAt(std::move(place), "expected " + expected + ", got " + numberText(value), std::move(subject));
}

std::string quoted(const char* what, const std::string& name) { return what + (" \"" + name + '"'); }

Error named(const char* subject, Error error) {
  error.subject = subject;
  return error;
}

std::string indexed(const char* list, std::size_t index) { return list + ('[' + std::to_string(index) + ']'); }

namespace {

constexpr double kValidationUnitTolerance = 1e-3;  // Of a quaternion's length; files written by hand have few digits.

std::string ofAxis(const std::string& what, int axis) { return what + ' ' + "XYZ"[axis]; }  ///< "radius Y"

/// Bytes of the UTF-8 sequence at the beginning of `text`; 0: ill-formed (overlong, surrogate, beyond U+10FFFF).
std::size_t utf8Length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const auto follows = [&](std::size_t i) { return (byte(i) & 0xC0u) == 0x80u; };
  const unsigned lead = byte(0);
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead <= 0xDF) return follows(1) ? 2 : 0;
  if (lead >= 0xE0 && lead <= 0xEF) {
    const bool badSecond = (lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xED && byte(1) > 0x9F);
    return follows(1) && follows(2) && !badSecond ? 3 : 0;
  }
  if (lead >= 0xF0 && lead <= 0xF4) {
    const bool badSecond = (lead == 0xF0 && byte(1) < 0x90) || (lead == 0xF4 && byte(1) > 0x8F);
    return follows(1) && follows(2) && follows(3) && !badSecond ? 4 : 0;
  }
  return 0;
}

bool isUtf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = utf8Length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

Result<void> validateRotation(const glm::quat& rotation, const std::string& place) {
  const std::array<float, 4> parts{rotation.x, rotation.y, rotation.z, rotation.w};
  double squared = 0.0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!std::isfinite(parts[i])) return outOfRange(place + indexed("", i), "a finite number", parts[i], "rotation");
    squared += static_cast<double>(parts[i]) * static_cast<double>(parts[i]);
  }
  const double length = std::sqrt(squared);
  if (std::abs(length - 1.0) <= kValidationUnitTolerance) return {};
  return outOfRange(place, "a quaternion x, y, z, w of length 1", static_cast<float>(length), "rotation");
}

/// @param reach  none: without limits that depend on the reach
Result<void> validateShape(const Shape& shape, const std::string& place, std::optional<float> reach = {}) {
  for (const std::span<const ShapeNumber> key : shapeKeys()) {
    for (std::size_t i = 0; i < key.size(); ++i) {
      const ShapeNumber& number = key[i];
      const float value = number.of(shape);
      const bool open = !reach && number.most != nullptr;
      const auto [low, high] = reach ? number.range(shape, *reach) : std::pair(number.low, number.high);
      // A little more than the limit, which is computed and rounded.
      const float room = reach ? 1.0f + 1e-5f : 1.0f;
      if (open ? std::isfinite(value) : value >= low * room && value <= high * room) continue;
      const std::string range = "a number from " + numberText(low) + " to " + numberText(high);
      std::string words = number.words;
      words[0] = static_cast<char>(std::tolower(words[0]));
      const std::string list = place + '.' + number.key;
      return outOfRange(key.size() == 1 ? list : indexed(list.c_str(), i),
                        open ? "a finite number" : range + (reach ? ", the most at this reach" : ""), value, words);
    }
  }
  return {};
}

Result<void> validateText(const std::string& text, const std::string& place) {
  if (isUtf8(text)) return {};
  return errorAt(place, "expected text in UTF-8", "text");
}

using NameIndex = std::unordered_map<std::string_view, std::size_t>;

template <class Named>
Result<NameIndex> indexNames(const std::vector<Named>& items, const char* list, const char* one) {
  NameIndex index;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::string place = indexed(list, i) + ".name";
    const std::string which = one + (' ' + std::to_string(i + 1));
    if (const auto name = validateName(items[i].name, place); !name) return about(which, name.error());
    if (const auto [first, isNew] = index.emplace(items[i].name, i); !isNew) {
      return errorAt(place,
                     "expected a name of its own, but \"" + items[i].name + "\" is also the name of " +
                         indexed(list, first->second),
                     which);
    }
  }
  return index;
}

/// Words for the items of a list of the rig.
struct Called {
  const char* list;
  const char* one;     ///< In files.
  const char* muscle;  ///< In the user interface.
};

template <class Twinned>
Result<void> validateMirror(const std::vector<Twinned>& items, std::size_t i, const NameIndex& names,
                            const Called& called) {
  const Twinned& item = items[i];
  if (item.mirror.empty()) return {};
  const std::string place = indexed(called.list, i) + ".mirror";
  const std::string subject = quoted(called.muscle, item.name) + ", twin";
  std::string another = "expected the name of another ";
  another += called.one;
  const auto twin = names.find(item.mirror);
  if (twin == names.end()) return errorAt(place, another + ", but there is no \"" + item.mirror + '"', subject);
  if (twin->second == i) return errorAt(place, another + ", got its own", subject);
  if (items[twin->second].mirror == item.name) return {};
  return errorAt(place,
                 std::string("expected a ") + called.one + " whose mirror is this one, but that of \"" + item.mirror +
                     "\" is \"" + items[twin->second].mirror + '"',
                 subject);
}

Result<void> validateAmount(const Link& link, const std::string& place, const std::string& subject) {
  if (link.amount > 0.0f && link.amount <= 1.0f) return {};
  return outOfRange(place + (isList(link) ? "[2]" : ".amount"), "an amount above 0, at most 1", link.amount, subject);
}

Result<void> validateLinksAmong(const Rig& rig, const NameIndex& groups, BlendingGraphMemo& graphs) {
  std::vector<GroupLink> links;
  links.reserve(rig.links.size());
  for (std::size_t i = 0; i < rig.links.size(); ++i) {
    const Link& link = rig.links[i];
    const std::string subject = "link " + std::to_string(i + 1);
    const std::string place = indexed("links", i);
    std::array<int, 2> ends{};
    for (std::size_t end = 0; end < 2; ++end) {
      const auto group = groups.find(link.groups[end]);
      if (group == groups.end()) {
        return errorAt(place + indexed(isList(link) ? "" : ".groups", end),
                       "expected the name of a group, but there is no \"" + link.groups[end] + '"', subject);
      }
      ends[end] = static_cast<int>(group->second);
    }
    if (ends[0] == ends[1])
      return errorAt(place, "expected two different groups, got \"" + link.groups[0] + "\" twice", subject);
    if (auto amount = validateAmount(link, place, subject); !amount) return amount;
    if (auto animated = validateAnimated(link.animated, ParameterOwner::kLink, place); !animated)
      return about(subject, animated.error());
    links.push_back({ends[0], ends[1], link.amount, !link.animated.empty()});
  }
  if (const auto graph = graphs.graph(static_cast<int>(rig.groups.size()), links); !graph) {
    return errorAt("links", graph.error().reason, "links");
  }
  return {};
}

}  // namespace

Result<void> validateName(const std::string& name, const std::string& place) {
  if (name.empty()) return errorAt(place, "expected a name, got nothing", "name");
  return validateText(name, place);
}

Result<void> validateCount(const char* list, const char* items, std::size_t count, std::size_t most) {
  if (count <= most) return {};
  return errorAt(list, "expected at most " + std::to_string(most) + ' ' + items + ", got " + std::to_string(count),
                 "the rig");
}

Result<void> validatePlacement(const Placement& placement, const std::string& place) {
  for (int i = 0; i < 3; ++i) {
    if (std::isfinite(placement.center[i])) continue;
    return outOfRange(place + indexed(".center", static_cast<std::size_t>(i)), "a finite number", placement.center[i],
                      ofAxis("centre", i));
  }
  if (auto rotation = validateRotation(placement.rotation, place + ".rotation"); !rotation) return rotation;
  for (int i = 0; i < 3; ++i) {
    if (std::isfinite(placement.radii[i]) && placement.radii[i] > 0.0f) continue;
    return outOfRange(place + indexed(".radii", static_cast<std::size_t>(i)), "a number > 0", placement.radii[i],
                      ofAxis("radius", i));
  }
  return validateShape(placement.shape, place);
}

namespace {

Result<void> validateParts(const Primitive& primitive, const std::string& place) {
  if (auto name = validateName(primitive.name, place + ".name"); !name) return name;
  if (auto bone = validateName(primitive.bone, place + ".bone"); !bone) return named("bone", bone.error());
  if (auto placement = validatePlacement(primitive.placement, place); !placement) return placement;
  if (!std::isfinite(primitive.reach) || !(primitive.reach > 1.0f)) {
    return outOfRange(place + ".reach", "a number > 1", primitive.reach, "reach");
  }
  if (auto limits = validateShape(primitive.placement.shape, place, primitive.reach); !limits) return limits;
  if (primitive.sign != 1 && primitive.sign != -1) {
    return errorAt(place + ".sign", "expected 1 or -1, got " + std::to_string(primitive.sign), "sign");
  }
  if (!(primitive.amount >= 0.0f && primitive.amount <= kMostAmount)) {
    return outOfRange(place + ".amount", "a number from 0 to 2", primitive.amount, "amount");
  }
  if (auto animated = validateAnimated(primitive.animated, ParameterOwner::kPrimitive, place); !animated) {
    return animated;
  }
  if (!primitive.territory) return {};
  for (std::size_t i = 0; i < primitive.territory->size(); ++i) {
    if (auto bone = validateName((*primitive.territory)[i], place + indexed(".territory", i)); !bone)
      return named("territory", bone.error());
  }
  return {};
}

}  // namespace

Result<void> validatePrimitive(const Primitive& primitive, const std::string& place) {
  if (auto parts = validateParts(primitive, place); !parts) {
    return about(primitive.name.empty() ? "a muscle" : quoted("muscle", primitive.name), parts.error());
  }
  return {};
}

Result<void> validateSurface(const SurfaceSettings& surface) {
  if (!(surface.iso >= kLeastIso && surface.iso <= kMostIso)) {
    return outOfRange("surface.iso", "a number from 0.001 to 0.999", surface.iso, "tightness");
  }
  if (!(surface.skinBlend > 0.0f && surface.skinBlend <= kMostSkinBlend)) {
    return outOfRange("surface.skin_blend", "a number > 0 and at most 10", surface.skinBlend, "skin blend");
  }
  if (!(surface.grooves >= 0.0f && surface.grooves <= kMostGrooves)) {
    return outOfRange("surface.grooves", "a number from 0 to 1", surface.grooves, "grooves");
  }
  return validateAnimated(surface.animated, ParameterOwner::kSurface, "surface");
}

Result<void> validateSmoothing(const SmoothingSettings& smoothing) {
  if (smoothing.depth < 1 || smoothing.depth > kMaxDepth) {
    return errorAt(
        "smoothing.depth",
        "expected a whole number from 1 to " + std::to_string(kMaxDepth) + ", got " + std::to_string(smoothing.depth),
        "depth");
  }
  if (!(smoothing.creaseAngle >= 0.0f && smoothing.creaseAngle <= 180.0f)) {
    return outOfRange("smoothing.crease_angle", "degrees from 0 to 180", smoothing.creaseAngle, "crease angle");
  }
  if (!(smoothing.tolerance >= kLeastTolerance && smoothing.tolerance <= kMostTolerance)) {
    return outOfRange("smoothing.tolerance", "a number from 0.0001 to 0.01", smoothing.tolerance, "tolerance");
  }
  return {};
}

namespace {

Result<NameIndex> validateLines(const Rig& rig) {
  if (auto count = validateCount("lines", "lines", rig.lines.size(), kMaxPrimitives); !count) return count.error();
  auto names = indexNames(rig.lines, "lines", "muscle line");
  if (!names) return names;
  for (std::size_t i = 0; i < rig.lines.size(); ++i) {
    if (auto own = validateLine(rig.lines[i], indexed("lines", i)); !own) return own.error();
    const Called called{"lines", "line", "muscle line"};
    if (auto mirror = validateMirror(rig.lines, i, names.value(), called); !mirror) return mirror.error();
  }
  return names;
}

Result<void> validateSlots(const Rig& rig) {
  for (std::size_t i = 0; i < rig.slots.size(); ++i) {
    const auto& [slot, bone] = rig.slots[i];
    const std::string place = "slots." + slot;
    if (!bodySlotNamed(slot)) {
      return errorAt(place, "expected a part of the body, such as \"upperArm.L\", got \"" + slot + '"', "body parts");
    }
    if (const auto text = validateText(bone, place); !text) return about(quoted("slot", slot), text.error());
    for (std::size_t j = 0; j < i; ++j) {
      if (rig.slots[j].slot == slot) return errorAt(place, "this part is named twice", "body parts");
    }
  }
  return {};
}

Result<void> validateClipFiles(const Rig& rig) {
  for (std::size_t i = 0; i < rig.clipFiles.size(); ++i) {
    const std::string& file = rig.clipFiles[i];
    const std::string place = "clips[" + std::to_string(i) + ']';
    if (file.empty()) return errorAt(place, "expected the path of a file, got nothing", "clip files");
    if (auto text = validateText(file, place); !text) return about("clip files", text.error());
    const auto own = rig.clipFiles.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find(rig.clipFiles.begin(), own, file) != own) {
      return errorAt(place, "the file \"" + file + "\" is named twice", "clip files");
    }
  }
  return {};
}

}  // namespace

Result<void> validateLinks(const Rig& rig) {
  const auto groups = indexNames(rig.groups, "groups", "group");
  if (!groups) return groups.error();
  BlendingGraphMemo graphs;
  return validateLinksAmong(rig, groups.value(), graphs);
}

Result<void> validate(const Rig& rig) {
  BlendingGraphMemo graphs;
  return validate(rig, graphs);
}

Result<void> validate(const Rig& rig, BlendingGraphMemo& graphs) {
  if (auto character = validateText(rig.character, "character"); !character)
    return named("character", character.error());
  if (auto surface = validateSurface(rig.surface); !surface) return surface;
  if (auto smoothing = validateSmoothing(rig.smoothing); !smoothing) return smoothing;
  const auto groups = indexNames(rig.groups, "groups", "group");
  if (!groups) return groups.error();
  if (auto links = validateLinksAmong(rig, groups.value(), graphs); !links) return links;
  if (auto clips = validateClipFiles(rig); !clips) return clips;
  if (auto slots = validateSlots(rig); !slots) return slots;
  if (auto layers = validateLayers(rig); !layers) return layers;

  if (auto channels = validateChannels(rig); !channels) return channels;
  if (auto morphs = validateMorphs(rig); !morphs) return morphs;
  const auto lines = validateLines(rig);
  if (!lines) return lines.error();
  if (auto sheets = validateSheets(rig); !sheets) return sheets;
  auto count = validateCount("primitives", "primitives", rig.primitives.size(), kMaxPrimitives);
  if (!count) return count;
  const auto primitives = indexNames(rig.primitives, "primitives", "muscle");
  if (!primitives) return primitives.error();
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    const Primitive& primitive = rig.primitives[i];
    const std::string place = indexed("primitives", i);
    if (auto own = validatePrimitive(primitive, place); !own) return own;
    if (!groups->contains(primitive.group)) {
      return errorAt(place + ".group", "expected the name of a group, but there is no \"" + primitive.group + '"',
                     quoted("muscle", primitive.name) + ", group");
    }
    if (!primitive.line.empty() && !lines->contains(primitive.line)) {
      return errorAt(place + ".line", "expected the name of a line, but there is no \"" + primitive.line + '"',
                     quoted("muscle", primitive.name) + ", line");
    }
    const Called called{"primitives", "primitive", "muscle"};
    if (auto mirror = validateMirror(rig.primitives, i, primitives.value(), called); !mirror) return mirror;
  }
  return validateInputs(rig);
}

}  // namespace sinew
