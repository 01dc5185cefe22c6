// core/files/rig_json_parts.cpp: lines, keys, drivers and channels, written and read.
#include "core/files/rig_json_parts.h"

#include <utility>

#include "core/rig/validation.h"

namespace sinew {

void readName(Reader& reader, const Json& object, const Place& place, const char* key, const char* expected,
              std::string& name) {
  const Json* node = object.find(key);
  if (!node) return;
  name = reader.text(*node, Reader::join(place, key));
  if (name.empty()) reader.expect(Reader::join(place, key), expected, *node);
}

void readNeededPoint(Reader& reader, const Json& object, const Place& place, const char* key, glm::vec3& point) {
  const Json* node = reader.need(object, place, key, "an array of 3 numbers");
  if (!node) return;
  const auto [x, y, z] = reader.vector<3>(*node, Reader::join(place, key));
  point = {x, y, z};
}

// Lines.

Json anchorNode(const LineAnchor& anchor) {
  const glm::vec3& point = anchor.point;
  return ObjectWriter()
      .set("bone", anchor.bone)
      .set("point", numbers({point.x, point.y, point.z}))
      .finish(anchor.unknownKeys);
}

LineAnchor readAnchor(Reader& reader, const Json& node, const Place& place) {
  LineAnchor anchor;
  if (!reader.object(node, place)) return anchor;
  anchor.bone = readNeededText(reader, node, place, "bone");
  readNeededPoint(reader, node, place, "point", anchor.point);
  anchor.unknownKeys = unknownKeys(node, {"bone", "point"});
  return anchor;
}

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

void readActivation(Reader& reader, const Json& object, const Place& place, LineSettings& settings,
                    std::string& unknown) {
  const Json* node = object.find("activation");
  const Place own = Reader::join(place, "activation");
  if (!node || !reader.object(*node, own)) return;
  readFloat(reader, *node, own, "base", settings.base);
  readFloat(reader, *node, own, "gain", settings.gain);
  readFloat(reader, *node, own, "full", settings.full);
  unknown = unknownKeys(*node, {"base", "gain", "full"});
}

LineAnchor readNeededAnchor(Reader& reader, const Json& object, const Place& place, const char* key) {
  const Json* node = reader.need(object, place, key, "an object with bone and point");
  return node ? readAnchor(reader, *node, Reader::join(place, key)) : LineAnchor{};
}

}  // namespace

LineSettings readLineSettings(Reader& reader, const Json& node, const Place& place, std::string& unknownActivation) {
  LineSettings settings;
  readFloat(reader, node, place, "rest", settings.rest);
  readLinePair(reader, node, place, "tendons", settings.tendons);
  readFloat(reader, node, place, "volume", settings.volume);
  readLinePair(reader, node, place, "limits", settings.limits);
  readFloat(reader, node, place, "pivot", settings.pivot);
  readFloat(reader, node, place, "twist", settings.twist);
  readLinePair(reader, node, place, "flex", settings.flex);
  readActivation(reader, node, place, settings, unknownActivation);
  return settings;
}

void setLineSettings(ObjectWriter& writer, const LineSettings& settings, const std::string& unknownActivation) {
  const LineSettings usual;
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
  if (Json node = activation.finish(unknownActivation); !node.children.empty())
    writer.set("activation", std::move(node));
}

Json lineNode(const MuscleLine& line) {
  ObjectWriter writer;
  writer.set("name", line.name).set("origin", anchorNode(line.origin)).set("insertion", anchorNode(line.insertion));
  if (line.via) writer.set("via", anchorNode(*line.via));
  setLineSettings(writer, line.settings, line.unknownActivationKeys);
  if (!line.mirror.empty()) writer.set("mirror", line.mirror);
  setAnimated(writer, line.animated);
  return writer.finish(line.unknownKeys);
}

MuscleLine readLine(Reader& reader, const Json& node, const Place& listed) {
  MuscleLine line;
  if (!reader.object(node, listed)) return line;
  line.name = readNeededText(reader, node, listed, "name");
  const Place place{listed.path, line.name.empty() ? listed.words : "muscle line \"" + line.name + '"'};
  line.origin = readNeededAnchor(reader, node, place, "origin");
  line.insertion = readNeededAnchor(reader, node, place, "insertion");
  if (const Json* via = node.find("via")) line.via = readAnchor(reader, *via, Reader::join(place, "via"));
  line.settings = readLineSettings(reader, node, place, line.unknownActivationKeys);
  readName(reader, node, place, "mirror", "the name of another line", line.mirror);
  line.animated = readAnimated(reader, node, place);
  line.unknownKeys = unknownKeys(node, {"name", "origin", "insertion", "via", "rest", "tendons", "volume", "limits",
                                        "pivot", "twist", "flex", "activation", "mirror", "animated"});
  return line;
}

// Keys, drivers and channels.

namespace {

void setTrack(ObjectWriter& writer, const KeyTrack& track) {
  if (!track.clip.empty()) writer.set("clip", track.clip);
  writer.set("times", jsonList(track.curve.points, [](const glm::vec2& point) { return point.x; }));
  writer.set("values", jsonList(track.curve.points, [](const glm::vec2& point) { return point.y; }));
  if (track.curve.kind != CurveKind::kSmooth) writer.set("interpolation", nameOf(track.curve.kind));
}

Json trackNode(const KeyTrack& track) {
  ObjectWriter writer;
  setTrack(writer, track);
  return writer.finish(track.unknownKeys);
}

Json inputNode(const DriverInput& input) {
  ObjectWriter writer;
  writer.set("kind", nameOf(input.kind));
  switch (input.kind) {
    case DriverInputKind::kPose: {
      const glm::quat& q = input.rotation;
      writer.set("bone", input.bone).set("rotation", numbers({q.x, q.y, q.z, q.w}));
      if (input.width != kDefaultPoseWidth) writer.set("width", input.width);
      break;
    }
    case DriverInputKind::kAxis:
      writer.set("bone", input.bone).set("axis", numbers({input.axis.x, input.axis.y, input.axis.z}));
      break;
    case DriverInputKind::kBend:
    case DriverInputKind::kTwist:
      writer.set("bone", input.bone);
      break;
    case DriverInputKind::kLength:
      writer.set("line", input.line);
      break;
    case DriverInputKind::kDistance:
      writer.set("from", anchorNode(input.from)).set("to", anchorNode(input.to));
      break;
    case DriverInputKind::kChannel:
      writer.set("channel", input.channel);
      break;
  }
  return writer.finish(input.unknownKeys);
}

Json driverNode(const Driver& driver) {
  ObjectWriter writer;
  writer.set("input", inputNode(driver.input));
  writer.set("curve", jsonList(driver.curve.points, [](const glm::vec2& point) {
               return numbers({point.x, point.y});
             }));
  if (driver.curve.kind != CurveKind::kSmooth) writer.set("interpolation", nameOf(driver.curve.kind));
  if (driver.mode != DriverMode::kAdd) writer.set("mode", nameOf(driver.mode));
  return writer.finish(driver.unknownKeys);
}

Json animatedNode(const AnimatedNumber& number) {
  ObjectWriter writer;
  writer.set("parameter", nameOf(number.parameter));
  if (!number.keys.empty()) writer.set("keys", jsonList(number.keys, trackNode));
  if (!number.drivers.empty()) writer.set("drivers", jsonList(number.drivers, driverNode));
  return writer.finish(number.unknownKeys);
}

constexpr const char* kCurveWords = "\"smooth\", \"linear\" or \"step\"";

std::vector<float> readNumbers(Reader& reader, const Json& object, const Place& place, const char* key) {
  std::vector<float> values;
  const Json* node = reader.need(object, place, key, "an array of numbers");
  if (!node) return values;
  reader.each(*node, Reader::join(place, key),
              [&](const Json& item, const Place& own) { values.push_back(reader.number(item, own)); });
  return values;
}

KeyTrack readTrack(Reader& reader, const Json& node, const Place& place,
                   std::initializer_list<std::string_view> known) {
  KeyTrack track;
  if (!reader.object(node, place)) return track;
  readName(reader, node, place, "clip", "the name of a clip", track.clip);
  const std::vector<float> times = readNumbers(reader, node, place, "times");
  const std::vector<float> values = readNumbers(reader, node, place, "values");
  if (times.size() != values.size()) {
    reader.refuse(Reader::join(place, "values"), "expected " + std::to_string(times.size()) +
                                                     " values, as many as times, got " + std::to_string(values.size()));
    return track;
  }
  for (std::size_t i = 0; i < times.size(); ++i) track.curve.points.push_back({times[i], values[i]});
  readWord(reader, node, place, "interpolation", kCurveWords, curveKindNamed, track.curve.kind);
  track.unknownKeys = unknownKeys(node, known);
  return track;
}

void readPose(Reader& reader, const Json& node, const Place& place, DriverInput& input) {
  if (const Json* rotation = reader.need(node, place, "rotation", "an array of 4 numbers")) {
    const auto [x, y, z, w] = reader.vector<4>(*rotation, Reader::join(place, "rotation"));
    input.rotation = glm::quat(w, x, y, z);
  }
  readFloat(reader, node, place, "width", input.width);
}

DriverInput readInput(Reader& reader, const Json& node, const Place& place) {
  DriverInput input;
  if (!reader.object(node, place)) return input;
  const char* kinds = "\"bend\", \"twist\", \"axis\", \"pose\", \"length\", \"distance\" or \"channel\"";
  if (!reader.need(node, place, "kind", kinds)) return input;
  readWord(reader, node, place, "kind", kinds, driverInputKindNamed, input.kind);
  if (reader.error()) return input;
  switch (input.kind) {
    case DriverInputKind::kBend:
    case DriverInputKind::kTwist:
    case DriverInputKind::kAxis:
    case DriverInputKind::kPose:
      input.bone = readNeededText(reader, node, place, "bone");
      if (input.kind == DriverInputKind::kAxis) readNeededPoint(reader, node, place, "axis", input.axis);
      if (input.kind == DriverInputKind::kPose) readPose(reader, node, place, input);
      break;
    case DriverInputKind::kLength:
      input.line = readNeededText(reader, node, place, "line");
      break;
    case DriverInputKind::kDistance:
      input.from = readNeededAnchor(reader, node, place, "from");
      input.to = readNeededAnchor(reader, node, place, "to");
      break;
    case DriverInputKind::kChannel:
      input.channel = readNeededText(reader, node, place, "channel");
      break;
  }
  input.unknownKeys = unknownKeys(node, {"kind", "bone", "axis", "rotation", "width", "line", "from", "to", "channel"});
  return input;
}

Driver readDriver(Reader& reader, const Json& node, const Place& place) {
  Driver driver;
  if (!reader.object(node, place)) return driver;
  if (const Json* input = reader.need(node, place, "input", "an object with kind")) {
    driver.input = readInput(reader, *input, Reader::join(place, "input"));
  }
  if (const Json* curve = reader.need(node, place, "curve", "an array of [x, y]")) {
    reader.each(*curve, Reader::join(place, "curve"), [&](const Json& item, const Place& own) {
      const auto [x, y] = reader.vector<2>(item, own);
      driver.curve.points.push_back({x, y});
    });
  }
  readWord(reader, node, place, "interpolation", kCurveWords, curveKindNamed, driver.curve.kind);
  readWord(reader, node, place, "mode", "\"add\", \"multiply\" or \"replace\"", driverModeNamed, driver.mode);
  driver.unknownKeys = unknownKeys(node, {"input", "curve", "interpolation", "mode"});
  return driver;
}

AnimatedNumber readNumber(Reader& reader, const Json& node, const Place& listed) {
  AnimatedNumber number;
  if (!reader.object(node, listed)) return number;
  const std::string name = readNeededText(reader, node, listed, "parameter");
  const std::optional<Parameter> parameter = parameterNamed(name);
  if (!parameter) {
    reader.refuse(Reader::join(listed, "parameter"), "there is no parameter \"" + name + '"');
    return number;
  }
  number.parameter = *parameter;
  const Place place{listed.path, listed.words + ", " + wordsFor(*parameter)};
  number.keys = readList(reader, node, place, "keys", "keys", [](Reader& tracks, const Json& item, const Place& own) {
    return readTrack(tracks, item, own, {"clip", "times", "values", "interpolation"});
  });
  number.drivers = readList(reader, node, place, "drivers", "driver", readDriver);
  number.unknownKeys = unknownKeys(node, {"parameter", "keys", "drivers"});
  return number;
}

}  // namespace

void setAnimated(ObjectWriter& writer, const std::vector<AnimatedNumber>& animated) {
  if (!animated.empty()) writer.set("animated", jsonList(animated, animatedNode));
}

std::vector<AnimatedNumber> readAnimated(Reader& reader, const Json& owner, const Place& place) {
  return readList(reader, owner, place, "animated", "animated number", readNumber);
}

Json linkNode(const Link& link) {
  if (isList(link)) {
    Json node = jsonList(link.groups);
    if (link.amount != 1.0f) node.push(link.amount);
    return node;
  }
  ObjectWriter writer;
  writer.set("groups", jsonList(link.groups));
  setNumber(writer, "amount", link.amount, 1.0f);
  setAnimated(writer, link.animated);
  return writer.finish(link.unknownKeys);
}

namespace {

/// Names of two groups, then perhaps the amount.
Link readLinkList(Reader& reader, const Json& node, const Place& place) {
  const std::size_t size = node.kind == Json::Kind::kArray ? node.children.size() : 0;
  if (size != 2 && size != 3) {
    reader.expect(place, "an array of two groups' names, and an amount if it is not 1", node);
    return {};
  }
  const auto nameAt = [&](std::size_t i) { return reader.text(node.children[i], Reader::at(place, i)); };
  Link link{{nameAt(0), nameAt(1)}};
  if (size == 3) link.amount = reader.number(node.children[2], Reader::at(place, 2));
  return link;
}

}  // namespace

Link readLink(Reader& reader, const Json& node, const Place& place) {
  if (node.kind != Json::Kind::kObject) return readLinkList(reader, node, place);
  Link link;
  const std::vector<std::string> groups =
      readList(reader, node, place, "groups", "group",
               [](Reader& names, const Json& item, const Place& own) { return names.text(item, own); });
  if (groups.size() != 2) {
    reader.refuse(Reader::join(place, "groups"), "expected two groups' names, got " + std::to_string(groups.size()));
    return link;
  }
  link.groups = {groups[0], groups[1]};
  readFloat(reader, node, place, "amount", link.amount);
  link.animated = readAnimated(reader, node, place);
  link.unknownKeys = unknownKeys(node, {"groups", "amount", "animated"});
  return link;
}

Json channelNode(const RigChannel& channel) {
  ObjectWriter writer;
  writer.set("name", channel.name);
  setTrack(writer, channel.track);
  return writer.finish(channel.track.unknownKeys);
}

RigChannel readChannel(Reader& reader, const Json& node, const Place& place) {
  RigChannel channel;
  if (!reader.object(node, place)) return channel;
  channel.name = readNeededText(reader, node, place, "name");
  channel.track = readTrack(reader, node, place, {"name", "clip", "times", "values", "interpolation"});
  return channel;
}

}  // namespace sinew
