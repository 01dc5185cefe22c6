// core/files/rig_json_lines.cpp: a line's members, there and back.
#include "core/files/rig_json_lines.h"

#include "core/files/json/writer.h"
#include "core/files/rig_json_animated.h"

namespace sinew {
namespace {

void setPair(ObjectWriter& writer, const char* key, const glm::vec2& pair, const glm::vec2& usual) {
  if (pair != usual) writer.set(key, numbers({pair.x, pair.y}));
}

void setNumber(ObjectWriter& writer, const char* key, float value, float usual) {
  if (value != usual) writer.set(key, value);
}

void readLinePair(Reader& reader, const Json& object, const Place& place, const char* key, glm::vec2& pair) {
  const Json* node = object.find(key);
  if (!node) return;
  const auto [x, y] = reader.vector<2>(*node, Reader::join(place, key));
  pair = {x, y};
}

void readActivation(Reader& reader, const Json& object, const Place& place, MuscleLine& line) {
  const Json* node = object.find("activation");
  const Place own = Reader::join(place, "activation");
  if (!node || !reader.object(*node, own)) return;
  readFloat(reader, *node, own, "base", line.settings.base);
  readFloat(reader, *node, own, "gain", line.settings.gain);
  readFloat(reader, *node, own, "full", line.settings.full);
  line.unknownActivationKeys = unknownKeys(*node, {"base", "gain", "full"});
}

LineSettings readSettings(Reader& reader, const Json& node, const Place& place) {
  LineSettings settings;
  readFloat(reader, node, place, "rest", settings.rest);
  readLinePair(reader, node, place, "tendons", settings.tendons);
  readFloat(reader, node, place, "volume", settings.volume);
  readLinePair(reader, node, place, "limits", settings.limits);
  readFloat(reader, node, place, "pivot", settings.pivot);
  readFloat(reader, node, place, "twist", settings.twist);
  readLinePair(reader, node, place, "flex", settings.flex);
  return settings;
}

}  // namespace

Json lineNode(const MuscleLine& line) {
  const LineSettings usual;
  const LineSettings& settings = line.settings;
  ObjectWriter writer;
  writer.set("name", line.name).set("origin", anchorNode(line.origin)).set("insertion", anchorNode(line.insertion));
  if (line.via) writer.set("via", anchorNode(*line.via));
  setNumber(writer, "rest", settings.rest, usual.rest);
  setPair(writer, "tendons", settings.tendons, usual.tendons);
  setNumber(writer, "volume", settings.volume, usual.volume);
  setPair(writer, "limits", settings.limits, usual.limits);
  setNumber(writer, "pivot", settings.pivot, usual.pivot);
  setNumber(writer, "twist", settings.twist, usual.twist);
  setPair(writer, "flex", settings.flex, usual.flex);
  ObjectWriter activation;
  setNumber(activation, "base", settings.base, usual.base);
  setNumber(activation, "gain", settings.gain, usual.gain);
  setNumber(activation, "full", settings.full, usual.full);
  if (Json node = activation.finish(line.unknownActivationKeys); !node.children.empty())
    writer.set("activation", std::move(node));
  if (!line.mirror.empty()) writer.set("mirror", line.mirror);
  setAnimated(writer, line.animated);
  return writer.finish(line.unknownKeys);
}

MuscleLine readLine(Reader& reader, const Json& node, const Place& listed) {
  MuscleLine line;
  if (!reader.object(node, listed)) return line;
  line.name = readNeededText(reader, node, listed, "name");
  const Place place{listed.path, line.name.empty() ? listed.words : "muscle line \"" + line.name + '"'};
  const auto anchor = [&](const char* key) {
    const Json* end = reader.need(node, place, key, "an object with bone and point");
    return end ? readAnchor(reader, *end, Reader::join(place, key)) : LineAnchor{};
  };
  line.origin = anchor("origin");
  line.insertion = anchor("insertion");
  if (const Json* via = node.find("via")) line.via = readAnchor(reader, *via, Reader::join(place, "via"));
  line.settings = readSettings(reader, node, place);
  readActivation(reader, node, place, line);
  if (const Json* mirror = node.find("mirror")) {
    line.mirror = reader.text(*mirror, Reader::join(place, "mirror"));
    if (line.mirror.empty()) reader.expect(Reader::join(place, "mirror"), "the name of another line", *mirror);
  }
  line.animated = readAnimated(reader, node, place);
  line.unknownKeys = unknownKeys(node, {"name", "origin", "insertion", "via", "rest", "tendons", "volume", "limits",
                                        "pivot", "twist", "flex", "activation", "mirror", "animated"});
  return line;
}

}  // namespace sinew
