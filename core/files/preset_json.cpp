// core/files/preset_json.cpp: presets from JSON and to JSON.
#include "core/files/preset_json.h"

#include <cmath>
#include <utility>

#include "core/files/disk/atomic_file.h"
#include "core/files/json/json.h"
#include "core/files/rig_json_parts.h"
#include "core/rig/sheet_edit.h"
#include "core/rig/validation.h"

namespace sinew {
namespace {

constexpr std::uintmax_t kPresetJsonMostBytes = std::uintmax_t{4} << 20;
constexpr std::size_t kMostMuscles = 1000;

/// ["upperArm", 0.56, -5] or with the depth: ["lowerArm", 0.06, 0, 0.75].
Mark readMark(Reader& reader, const Json& node, const Place& place) {
  Mark mark;
  const std::string expected = "[part, position along it, angle] or [part, position along it, angle, depth]";
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
  if (std::abs(mark.u) > kMostU) reader.refuse(Reader::at(place, 1), "expected a number from -3 to 3");
  if (!(mark.depth >= 0.0f && mark.depth <= 1.0f)) reader.refuse(Reader::at(place, 3), "expected a number from 0 to 1");
  return mark;
}

/// A number within a range; unchanged if absent.
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

LineSettings readPresetLine(Reader& reader, const Json& node, const Place& place) {
  LineSettings line;
  line.volume = 0.8f;
  line.limits = {0.5f, 1.6f};
  line.flex = {0.15f, 0.05f};
  line.full = 0.8f;
  readPair(reader, node, place, "tendons", line.tendons);
  readIn(reader, node, place, "volume", 0.0f, kMostVolume, line.volume);
  readPair(reader, node, place, "limits", line.limits);
  readIn(reader, node, place, "pivot", 0.0f, 1.0f, line.pivot);
  readIn(reader, node, place, "twist", 0.0f, 1.0f, line.twist);
  readIn(reader, node, place, "gain", 0.0f, kMostGain, line.gain);
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
  for (const auto& [key, name] : {std::pair{"name", &muscle.name}, std::pair{"group", &muscle.group}}) {
    *name = readNeededText(reader, node, place, key);
    if (!reader.error() && name->empty()) reader.refuse(Reader::join(place, key), "expected a name, got nothing");
  }
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
  if (muscle.origin && node.find("half_length") == nullptr) muscle.halfLength = 0.0f;
  else if (reader.need(node, place, "half_length", "a number") != nullptr)
    readIn(reader, node, place, "half_length", kLeastHalfLength, kMostHalfLength, muscle.halfLength);
  readIn(reader, node, place, "height", kLeastPresetHeight, kMostPresetHeight, muscle.height);
  readIn(reader, node, place, "width", kLeastPresetWidth, kMostPresetWidth, muscle.width);
  readIn(reader, node, place, "turn", -180.0f, 180.0f, muscle.turn);
  readIn(reader, node, place, "tilt", -90.0f, 90.0f, muscle.tilt);
  readIn(reader, node, place, "roll", -180.0f, 180.0f, muscle.roll);
  readIn(reader, node, place, "definition", 0.0f, kMostDefinition, muscle.definition);
  if (node.find("reach") != nullptr) {
    muscle.reach = 2.0f;
    readIn(reader, node, place, "reach", kLeastPresetReach, kMostPresetReach, muscle.reach);
  }
  readIn(reader, node, place, "amount", 0.0f, kMostAmount, muscle.amount);
  readSwitch(reader, node, place, "carves", muscle.carves);
  readSwitch(reader, node, place, "midline", muscle.midline);
  readSwitch(reader, node, place, "single", muscle.single);
  readSwitch(reader, node, place, "as_laid", muscle.asLaid);
  readIn(reader, node, place, "core", 0.0f, kMostCore, muscle.shape.core);
  readIn(reader, node, place, "thickest", -kMostThickest, kMostThickest, muscle.shape.belly);
  readPair(reader, node, place, "bend", muscle.shape.bend);
  if (!(std::abs(muscle.shape.bend.x) <= kMostBend && std::abs(muscle.shape.bend.y) <= kMostBend))
    reader.refuse(Reader::join(place, "bend"), "expected two numbers from -1 to 1");
  muscle.line = readPresetLine(reader, node, place);
  return muscle;
}

Json markJson(const Mark& mark) {
  Json json = Json::array();
  json.push(mark.slot == Slot::kSpine ? "trunk" : nameOf(mark.slot)).push(mark.u).push(mark.angle);
  if (mark.depth > 0.0f) json.push(mark.depth);
  return json;
}

std::vector<Mark> readEdgeMarks(Reader& reader, const Json& node, const Place& place) {
  std::vector<Mark> marks;
  reader.each(node, place, [&](const Json& one, const Place& own) { marks.push_back(readMark(reader, one, own)); });
  if (marks.empty()) reader.refuse(place, "expected at least one mark, got none");
  return marks;
}

PresetSheet readPresetSheet(Reader& reader, const Json& node, const Place& place) {
  PresetSheet sheet;
  if (!reader.object(node, place)) return sheet;
  sheet.sheet.name = readNeededText(reader, node, place, "name");
  sheet.sheet.group = readNeededText(reader, node, place, "group");
  if (const Json* edges = reader.need(node, place, "edges", "a list of edges")) {
    reader.each(*edges, Reader::join(place, "edges"),
                [&](const Json& one, const Place& own) { sheet.edges.push_back(readEdgeMarks(reader, one, own)); });
    if (sheet.edges.size() < 2) reader.refuse(Reader::join(place, "edges"), "expected at least two edges");
  }
  readSheetSettings(reader, node, place, sheet.sheet);
  readSwitch(reader, node, place, "single", sheet.single);
  if (reader.error()) return sheet;
  if (const auto valid = validateSheetSettings(sheet.sheet, place.path); !valid) {
    reader.refuse({valid.error().place, place.words + ", " + valid.error().subject}, valid.error().reason);
  }
  return sheet;
}

Json presetSheetJson(const PresetSheet& sheet) {
  ObjectWriter writer;
  writer.set("name", sheet.sheet.name).set("group", sheet.sheet.group);
  writer.set("edges", jsonList(sheet.edges, [](const std::vector<Mark>& edge) { return jsonList(edge, markJson); }));
  setSheetSettings(writer, sheet.sheet);
  if (sheet.single) writer.set("single", true);
  return writer.finish("");
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
  readIn(reader, root, "", "reach", kLeastPresetReach, kMostPresetReach, preset.reach);
  readIn(reader, root, "", "skin_blend", 0.0001f, kMostSkinBlend, preset.skinBlend);
  readIn(reader, root, "", "grooves", 0.0f, kMostGrooves, preset.grooves);
  if (const Json* muscles = reader.need(root, "", "muscles", "an array")) {
    if (muscles->children.size() > kMostMuscles) reader.refuse("muscles", "expected at most 1000");
    reader.each(*muscles, {"muscles", "muscle"}, [&](const Json& node, const Place& place) {
      preset.muscles.push_back(readMuscle(reader, node, place));
    });
  }
  if (const Json* sheets = root.find("sheets")) {
    reader.each(*sheets, {"sheets", "sheet"}, [&](const Json& node, const Place& place) {
      preset.sheets.push_back(readPresetSheet(reader, node, place));
    });
  }
  return preset;
}

Json pairJson(const glm::vec2& pair) { return Json::array({pair.x, pair.y}); }

void writeLine(Json& json, const LineSettings& line) {
  json.set("tendons", pairJson(line.tendons)).set("volume", line.volume).set("limits", pairJson(line.limits));
  json.set("pivot", line.pivot).set("twist", line.twist).set("gain", line.gain);
  json.set("flex", pairJson(line.flex)).set("full", line.full);
}

/// Omits defaults.
Json muscleJson(const PresetMuscle& muscle) {
  const PresetMuscle usual;
  Json json = Json::object();
  json.set("name", muscle.name).set("group", muscle.group).set("belly", markJson(muscle.belly));
  if (muscle.origin) json.set("origin", markJson(*muscle.origin)).set("insertion", markJson(*muscle.insertion));
  if (muscle.halfLength > 0.0f) json.set("half_length", muscle.halfLength);
  json.set("height", muscle.height).set("width", muscle.width);
  const auto unless = [&](const char* key, auto value, auto same) {
    if (value != same) json.set(key, value);
  };
  unless("turn", muscle.turn, usual.turn);
  unless("tilt", muscle.tilt, usual.tilt);
  unless("roll", muscle.roll, usual.roll);
  unless("definition", muscle.definition, usual.definition);
  unless("reach", muscle.reach, usual.reach);
  unless("amount", muscle.amount, usual.amount);
  unless("carves", muscle.carves, usual.carves);
  unless("midline", muscle.midline, usual.midline);
  unless("single", muscle.single, usual.single);
  unless("as_laid", muscle.asLaid, usual.asLaid);
  unless("core", muscle.shape.core, usual.shape.core);
  unless("thickest", muscle.shape.belly, usual.shape.belly);
  if (muscle.shape.bend != usual.shape.bend) json.set("bend", pairJson(muscle.shape.bend));
  if (muscle.origin) writeLine(json, muscle.line);
  return json;
}

}  // namespace

std::string presetToJson(const Preset& preset) {
  Json json = Json::object();
  json.set("format", "sinew-preset").set("version", 1).set("title", preset.title).set("body", nameOf(preset.body));
  json.set("definition", preset.definition).set("reach", preset.reach).set("skin_blend", preset.skinBlend);
  json.set("grooves", preset.grooves);
  json.set("muscles", jsonList(preset.muscles, muscleJson));
  if (!preset.sheets.empty()) json.set("sheets", jsonList(preset.sheets, presetSheetJson));
  return json.dump(true) + '\n';
}

Result<void> savePreset(const Preset& preset, const std::filesystem::path& file) {
  return writeFileAtomically(file, presetToJson(preset));
}

Result<Preset> presetFromJson(const std::string& text) {
  const auto root = Json::parse(text);
  if (!root) return about("damaged", root.error());
  Reader reader;
  Preset preset = readPreset(reader, root.value());
  if (reader.error()) return *reader.error();
  return preset;
}

Result<Preset> loadPreset(const std::filesystem::path& file) {
  const auto text = readWholeFile(file, kPresetJsonMostBytes);
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
