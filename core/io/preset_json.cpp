// core/io/preset_json.cpp: text -> Preset, every refusal with its JSON path.
#include "core/io/preset_json.h"

#include <cmath>
#include <utility>

#include "core/io/files/atomic_file.h"
#include "core/io/json/reader.h"
#include "core/rig/validation.h"

namespace sinew {
namespace {

constexpr std::uintmax_t kMostBytes = std::uintmax_t{4} << 20;
constexpr std::size_t kMostMuscles = 1000;

/// ["upperArm", 0.56, -5] or with the depth: ["lowerArm", 0.06, 0, 0.75].
Mark readMark(Reader& reader, const Json& node, const Place& place) {
  Mark mark;
  const std::string expected = "[part, way along it, angle] or [part, way along it, angle, depth]";
  if (node.kind != Json::Kind::kArray || node.children.size() < 3 || node.children.size() > 4) {
    reader.expect(place, expected, node);
    return mark;
  }
  const std::string part = reader.text(node.children[0], Reader::at(place, 0));
  if (part == "trunk") mark.slot = Slot::kSpine;
  else if (const auto slot = slotNamed(part)) mark.slot = *slot;
  else
    reader.refuse(Reader::at(place, 0),
                  "expected a part of the body, such as \"upperArm\" or \"trunk\", got \"" + part + '"');
  mark.u = reader.number(node.children[1], Reader::at(place, 1));
  mark.angle = reader.number(node.children[2], Reader::at(place, 2));
  if (node.children.size() > 3) mark.depth = reader.number(node.children[3], Reader::at(place, 3));
  if (std::abs(mark.u) > 3.0f) reader.refuse(Reader::at(place, 1), "expected a number from -3 to 3");
  if (!(mark.depth >= 0.0f && mark.depth <= 1.0f)) reader.refuse(Reader::at(place, 3), "expected a number from 0 to 1");
  return mark;
}

/// A number within a range; absent: as it was.
void readIn(Reader& reader, const Json& node, const Place& place, const char* key, float least, float most,
            float& value) {
  readFloat(reader, node, place, key, value);
  if (value >= least && value <= most) return;
  const auto text = [](float number) { return Json(number).dump(); };
  reader.refuse(Reader::join(place, key),
                "expected a number from " + text(least) + " to " + text(most) + ", got " + text(value));
}

void readPair(Reader& reader, const Json& node, const Place& place, const char* key, glm::vec2& pair) {
  const Json* found = node.find(key);
  if (found == nullptr) return;
  const auto [x, y] = reader.vector<2>(*found, Reader::join(place, key));
  pair = {x, y};
}

LineSettings readLineSettings(Reader& reader, const Json& node, const Place& place) {
  LineSettings line;
  line.volume = 0.8f;
  line.limits = {0.5f, 1.6f};
  line.flex = {0.15f, 0.05f};
  line.full = 0.8f;
  readPair(reader, node, place, "tendons", line.tendons);
  readIn(reader, node, place, "volume", 0.0f, kMostVolume, line.volume);
  readPair(reader, node, place, "limits", line.limits);
  readIn(reader, node, place, "pivot", 0.0f, 1.0f, line.pivot);
  readPair(reader, node, place, "flex", line.flex);
  readIn(reader, node, place, "full", kLeastFull, kMostFull, line.full);
  if (!(line.tendons.x >= 0.0f && line.tendons.y >= 0.0f && line.tendons.x + line.tendons.y <= kMostTendons)) {
    reader.refuse(Reader::join(place, "tendons"), "expected two numbers >= 0, together at most 0.8");
  }
  if (!(line.limits.x > 0.0f && line.limits.x < 1.0f && line.limits.y > 1.0f)) {
    reader.refuse(Reader::join(place, "limits"), "expected two numbers, 0 < x < 1 < y");
  }
  for (const float flex : {line.flex.x, line.flex.y}) {
    if (!(flex >= kLeastFlex && flex <= kMostFlex))
      reader.refuse(Reader::join(place, "flex"), "expected numbers from -0.9 to 4");
  }
  return line;
}

PresetMuscle readMuscle(Reader& reader, const Json& node, const Place& place) {
  PresetMuscle muscle;
  if (!reader.object(node, place)) return muscle;
  muscle.name = readNeededText(reader, node, place, "name");
  if (!reader.error() && muscle.name.empty())
    reader.refuse(Reader::join(place, "name"), "expected a name, got nothing");
  muscle.group = readNeededText(reader, node, place, "group");
  if (!reader.error() && muscle.group.empty())
    reader.refuse(Reader::join(place, "group"), "expected a name, got nothing");
  const auto mark = [&](const char* key) -> std::optional<Mark> {
    const Json* found = node.find(key);
    return found == nullptr ? std::nullopt : std::optional(readMark(reader, *found, Reader::join(place, key)));
  };
  if (reader.need(node, place, "belly", "a mark") != nullptr) muscle.belly = *mark("belly");
  muscle.origin = mark("origin");
  muscle.insertion = mark("insertion");
  if (muscle.origin.has_value() != muscle.insertion.has_value()) {
    reader.refuse(place, "expected origin and insertion, or neither");
  }
  if (!muscle.origin) {
    if (reader.need(node, place, "half_length", "a number") != nullptr)
      readIn(reader, node, place, "half_length", 0.005f, 2.0f, muscle.halfLength);
  }
  readIn(reader, node, place, "height", 0.01f, 4.0f, muscle.height);
  readIn(reader, node, place, "width", 0.1f, 10.0f, muscle.width);
  readIn(reader, node, place, "turn", -180.0f, 180.0f, muscle.turn);
  readIn(reader, node, place, "definition", 0.0f, 4.0f, muscle.definition);
  if (node.find("reach") != nullptr) {
    muscle.reach = 2.0f;
    readIn(reader, node, place, "reach", 1.01f, 10.0f, muscle.reach);
  }
  readSwitch(reader, node, place, "midline", muscle.midline);
  readIn(reader, node, place, "core", 0.0f, kMostCore, muscle.shape.core);
  readIn(reader, node, place, "thickest", -0.9f, 0.9f, muscle.shape.belly);
  muscle.line = readLineSettings(reader, node, place);
  return muscle;
}

Preset readPreset(Reader& reader, const Json& root) {
  Preset preset;
  if (!reader.object(root, {"", "not a set of muscles"})) return preset;
  const std::string format = readNeededText(reader, root, "", "format");
  if (!reader.error() && format != "sinew-preset")
    reader.refuse("format", "expected \"sinew-preset\", got \"" + format + '"');
  const Json* version = reader.need(root, "", "version", "1");
  if (version != nullptr && reader.wholeNumber(*version, "version", "1") != 1) reader.refuse("version", "expected 1");
  preset.title = readNeededText(reader, root, "", "title");
  const std::string body = readNeededText(reader, root, "", "body");
  if (body == "quadruped") preset.body = BodyKind::kQuadruped;
  else if (body != "humanoid" && !reader.error())
    reader.refuse("body", "expected \"humanoid\" or \"quadruped\", got \"" + body + '"');
  readIn(reader, root, "", "definition", 0.0f, 1.0f, preset.definition);
  readIn(reader, root, "", "reach", 1.01f, 10.0f, preset.reach);
  readIn(reader, root, "", "skin_blend", 0.0001f, kMostSkinBlend, preset.skinBlend);
  if (const Json* muscles = reader.need(root, "", "muscles", "an array")) {
    if (muscles->children.size() > kMostMuscles) reader.refuse("muscles", "expected at most 1000");
    reader.each(*muscles, {"muscles", "muscle"}, [&](const Json& node, const Place& place) {
      preset.muscles.push_back(readMuscle(reader, node, place));
    });
  }
  return preset;
}

}  // namespace

Result<Preset> presetFromJson(const std::string& text) {
  const auto root = Json::parse(text);
  if (!root) return about("damaged", root.error());
  Reader reader;
  Preset preset = readPreset(reader, root.value());
  if (reader.error()) return *reader.error();
  return preset;
}

Result<Preset> loadPreset(const std::filesystem::path& file) {
  const auto text = readWholeFile(file, kMostBytes);
  if (!text) return text.error();
  auto preset = presetFromJson(text.value());
  if (!preset) {
    Error error = preset.error();
    error.file = file.string();
    return error;
  }
  preset.value().name = file.stem().string();
  return preset;
}

}  // namespace sinew
