// core/files/json/reader.cpp: values out of nodes.
#include "core/files/json/reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace sinew {
namespace {

using Kind = Json::Kind;

std::string describe(const Json& node) {
  switch (node.kind) {
    case Kind::kNull:
      return "null";
    case Kind::kFalse:
      return "false";
    case Kind::kTrue:
      return "true";
    case Kind::kNumber:
      return node.content;
    case Kind::kString:
      return node.content.size() <= 40 ? '"' + node.content + '"' : "a text";
    case Kind::kArray:
      return "an array of " + std::to_string(node.children.size());
    case Kind::kObject:
      break;
  }
  return "an object";
}

}  // namespace

void Reader::expect(const Place& place, const std::string& expected, const Json& node) {
  refuse(place, "expected " + expected + ", got " + describe(node));
}

std::string Reader::text(const Json& node, const Place& place) {
  if (node.kind == Kind::kString) return node.content;
  expect(place, "a text", node);
  return {};
}

float Reader::number(const Json& node, const Place& place) {
  if (node.kind != Kind::kNumber) {
    expect(place, "a number", node);
    return 0.0f;
  }
  float value = 0.0f;
  const char* const end = node.content.data() + node.content.size();
  if (std::from_chars(node.content.data(), end, value).ec == std::errc{}) return value;
  // Out of a float's range: too close to 0 rounds to 0, too far from it is no number we can keep.
  double wide = 0.0;
  if (std::from_chars(node.content.data(), end, wide).ec != std::errc{} || std::abs(wide) < 1.0) return 0.0f;
  expect(place, "a number of at most 3.4028235e+38", node);
  return 0.0f;
}

void Reader::vector(const Json& node, const Place& place, std::span<float> values) {
  if (node.kind != Kind::kArray || node.children.size() != values.size()) {
    return expect(place, "an array of " + std::to_string(values.size()) + " numbers", node);
  }
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = number(node.children[i], at(place, i));
}

int Reader::wholeNumber(const Json& node, const Place& place, const std::string& expected) {
  int value = 0;
  const char* const end = node.content.data() + node.content.size();
  const auto [stop, status] = std::from_chars(node.content.data(), end, value);
  if (node.kind == Kind::kNumber && status == std::errc{} && stop == end) return value;
  expect(place, expected, node);
  return 0;
}

std::string unknownKeys(const Json& object, std::span<const std::string_view> known) {
  Json rest = Json::object();
  for (const Json& child : object.children) {
    if (std::ranges::find(known, child.key) == known.end()) rest.children.push_back(child);
  }
  return rest.children.empty() ? std::string() : rest.dump();
}

void readFloat(Reader& reader, const Json& object, const Place& place, const char* key, float& value) {
  if (const Json* node = object.find(key)) value = reader.number(*node, Reader::join(place, key));
}

void readSwitch(Reader& reader, const Json& object, const Place& place, const char* key, bool& value) {
  const Json* node = object.find(key);
  if (!node) return;
  value = node->kind == Kind::kTrue;
  if (!value && node->kind != Kind::kFalse) reader.expect(Reader::join(place, key), "true or false", *node);
}

std::string readNeededText(Reader& reader, const Json& object, const Place& place, const char* key) {
  const Json* node = reader.need(object, place, key, "a text");
  return node ? reader.text(*node, Reader::join(place, key)) : std::string();
}

}  // namespace sinew
