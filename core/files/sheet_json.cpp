// core/files/sheet_json.cpp: sheets of a rig file, written and read. docs/formats.md.
#include <array>
#include <utility>

#include "core/files/rig_json_parts.h"

namespace sinew {
namespace {

/// A number of a sheet by its key.
struct SheetNumber {
  const char* key;
  float MuscleSheet::*member;
};

constexpr std::array kSheetNumbers{
    SheetNumber{"thickness", &MuscleSheet::thickness}, SheetNumber{"width", &MuscleSheet::width},
    SheetNumber{"crest", &MuscleSheet::crest},         SheetNumber{"sunk", &MuscleSheet::sunk},
    SheetNumber{"reach", &MuscleSheet::reach},         SheetNumber{"spacing", &MuscleSheet::spacing},
    SheetNumber{"amount", &MuscleSheet::amount},
};

Json edgeNode(const SheetEdge& edge) {
  return ObjectWriter().set("points", jsonList(edge.points, anchorNode)).finish(edge.unknownKeys);
}

SheetEdge readEdge(Reader& reader, const Json& node, const Place& place) {
  if (!reader.object(node, place)) return {};
  return {readList(reader, node, place, "points", "point", readAnchor), unknownKeys(node, {"points"})};
}

Json profileNode(const Profile& profile) {
  return jsonList(profile, [](const glm::vec2& point) { return numbers({point.x, point.y}); });
}

glm::vec2 readProfilePoint(Reader& reader, const Json& node, const Place& place) {
  const auto [x, y] = reader.vector<2>(node, place);
  return {x, y};
}

void readProfile(Reader& reader, const Json& object, const Place& place, const char* key, Profile& profile) {
  if (object.find(key)) profile = readList(reader, object, place, key, "point", readProfilePoint);
}

Json settingsNode(const MuscleSheet& sheet) {
  ObjectWriter writer;
  setLineSettings(writer, *sheet.line, sheet.unknownActivationKeys);
  return writer.finish(sheet.unknownLineKeys);
}

void readSettings(Reader& reader, const Json& node, const Place& place, MuscleSheet& sheet) {
  if (!reader.object(node, place)) return;
  sheet.line = readLineSettings(reader, node, place, sheet.unknownActivationKeys);
  sheet.unknownLineKeys =
      unknownKeys(node, {"rest", "tendons", "volume", "limits", "pivot", "twist", "flex", "activation"});
}

}  // namespace

void setSheetSettings(ObjectWriter& writer, const MuscleSheet& sheet) {
  const MuscleSheet usual;
  writer.set("strips", sheet.strips).set("bellies", sheet.bellies);
  for (const auto& [key, member] : kSheetNumbers) {
    if (sheet.*member != usual.*member) writer.set(key, sheet.*member);
  }
  if (sheet.across != usual.across) writer.set("across", profileNode(sheet.across));
  if (sheet.along != usual.along) writer.set("along", profileNode(sheet.along));
  if (sheet.sign != 1) writer.set("sign", sheet.sign);
  if (sheet.line) writer.set("line", settingsNode(sheet));
}

void readSheetSettings(Reader& reader, const Json& node, const Place& place, MuscleSheet& sheet) {
  const auto readCount = [&](const char* key, int& count) {
    if (const Json* found = node.find(key)) {
      count = reader.wholeNumber(*found, Reader::join(place, key), "a whole number from 1 to 16");
    }
  };
  readCount("strips", sheet.strips);
  readCount("bellies", sheet.bellies);
  for (const auto& [key, member] : kSheetNumbers) readFloat(reader, node, place, key, sheet.*member);
  readProfile(reader, node, place, "across", sheet.across);
  readProfile(reader, node, place, "along", sheet.along);
  if (const Json* sign = node.find("sign")) {
    sheet.sign = reader.wholeNumber(*sign, Reader::join(place, "sign"), "1 or -1");
  }
  if (const Json* line = node.find("line")) readSettings(reader, *line, Reader::join(place, "line"), sheet);
}

Json sheetNode(const MuscleSheet& sheet) {
  ObjectWriter writer;
  writer.set("name", sheet.name).set("group", sheet.group).set("edges", jsonList(sheet.edges, edgeNode));
  setSheetSettings(writer, sheet);
  if (!sheet.mirror.empty()) writer.set("mirror", sheet.mirror);
  return writer.finish(sheet.unknownKeys);
}

MuscleSheet readSheet(Reader& reader, const Json& node, const Place& listed) {
  MuscleSheet sheet;
  if (!reader.object(node, listed)) return sheet;
  sheet.name = readNeededText(reader, node, listed, "name");
  const Place place{listed.path, sheet.name.empty() ? listed.words : "sheet \"" + sheet.name + '"'};
  sheet.group = readNeededText(reader, node, place, "group");
  if (reader.need(node, place, "edges", "a list of edges")) {
    sheet.edges = readList(reader, node, place, "edges", "edge", readEdge);
  }
  readSheetSettings(reader, node, place, sheet);
  readName(reader, node, place, "mirror", "the name of another sheet", sheet.mirror);
  std::vector<std::string_view> known{"name",   "group", "edges", "strips", "bellies",
                                      "across", "along", "sign",  "line",   "mirror"};
  for (const SheetNumber& number : kSheetNumbers) known.emplace_back(number.key);
  sheet.unknownKeys = unknownKeys(node, known);
  return sheet;
}

}  // namespace sinew
