// core/files/rig_json_animated.cpp: keys, drivers and channels, there and back.
#include "core/files/rig_json_animated.h"

#include <utility>

namespace sinew {
namespace {

Json listOf(std::vector<Json> items) { return Json::array(std::move(items)); }

void setTrack(ObjectWriter& writer, const KeyTrack& track) {
  if (!track.clip.empty()) writer.set("clip", track.clip);
  std::vector<Json> times;
  std::vector<Json> values;
  for (const glm::vec2& point : track.curve.points) {
    times.push_back(point.x);
    values.push_back(point.y);
  }
  writer.set("times", listOf(std::move(times))).set("values", listOf(std::move(values)));
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
  std::vector<Json> points;
  for (const glm::vec2& point : driver.curve.points) points.push_back(numbers({point.x, point.y}));
  ObjectWriter writer;
  writer.set("input", inputNode(driver.input)).set("curve", listOf(std::move(points)));
  if (driver.curve.kind != CurveKind::kSmooth) writer.set("interpolation", nameOf(driver.curve.kind));
  if (driver.mode != DriverMode::kAdd) writer.set("mode", nameOf(driver.mode));
  return writer.finish(driver.unknownKeys);
}

Json animatedNode(const AnimatedNumber& number) {
  ObjectWriter writer;
  writer.set("parameter", nameOf(number.parameter));
  std::vector<Json> keys;
  for (const KeyTrack& track : number.keys) keys.push_back(trackNode(track));
  if (!keys.empty()) writer.set("keys", listOf(std::move(keys)));
  std::vector<Json> drivers;
  for (const Driver& driver : number.drivers) drivers.push_back(driverNode(driver));
  if (!drivers.empty()) writer.set("drivers", listOf(std::move(drivers)));
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
  if (const Json* clip = node.find("clip")) {
    track.clip = reader.text(*clip, Reader::join(place, "clip"));
    if (track.clip.empty()) reader.expect(Reader::join(place, "clip"), "the name of a clip", *clip);
  }
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

void readAxis(Reader& reader, const Json& node, const Place& place, DriverInput& input) {
  const Json* axis = reader.need(node, place, "axis", "an array of 3 numbers");
  if (!axis) return;
  const auto [x, y, z] = reader.vector<3>(*axis, Reader::join(place, "axis"));
  input.axis = {x, y, z};
}

void readDistance(Reader& reader, const Json& node, const Place& place, DriverInput& input) {
  const auto anchor = [&](const char* key) {
    const Json* end = reader.need(node, place, key, "an object with bone and point");
    return end ? readAnchor(reader, *end, Reader::join(place, key)) : LineAnchor{};
  };
  input.from = anchor("from");
  input.to = anchor("to");
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
      if (input.kind == DriverInputKind::kAxis) readAxis(reader, node, place, input);
      if (input.kind == DriverInputKind::kPose) readPose(reader, node, place, input);
      break;
    case DriverInputKind::kLength:
      input.line = readNeededText(reader, node, place, "line");
      break;
    case DriverInputKind::kDistance:
      readDistance(reader, node, place, input);
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
  if (const Json* keys = node.find("keys")) {
    reader.each(*keys, Reader::join(place, "keys"), [&](const Json& item, const Place& own) {
      number.keys.push_back(readTrack(reader, item, own, {"clip", "times", "values", "interpolation"}));
    });
  }
  if (const Json* drivers = node.find("drivers")) {
    reader.each(*drivers, {place.path + ".drivers", place.words + ", driver"},
                [&](const Json& item, const Place& own) { number.drivers.push_back(readDriver(reader, item, own)); });
  }
  number.unknownKeys = unknownKeys(node, {"parameter", "keys", "drivers"});
  return number;
}

}  // namespace

void setAnimated(ObjectWriter& writer, const std::vector<AnimatedNumber>& animated) {
  if (animated.empty()) return;
  std::vector<Json> items;
  for (const AnimatedNumber& number : animated) items.push_back(animatedNode(number));
  writer.set("animated", listOf(std::move(items)));
}

std::vector<AnimatedNumber> readAnimated(Reader& reader, const Json& owner, const Place& place) {
  std::vector<AnimatedNumber> animated;
  const Json* node = owner.find("animated");
  if (!node) return animated;
  reader.each(*node, {Reader::join(place, "animated").path, place.words + ", animated number"},
              [&](const Json& item, const Place& own) { animated.push_back(readNumber(reader, item, own)); });
  return animated;
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
  if (const Json* point = reader.need(node, place, "point", "an array of 3 numbers")) {
    const auto [x, y, z] = reader.vector<3>(*point, Reader::join(place, "point"));
    anchor.point = {x, y, z};
  }
  anchor.unknownKeys = unknownKeys(node, {"bone", "point"});
  return anchor;
}

}  // namespace sinew
