// core/files/json/reader.h: takes a JSON tree apart, every refusal with its place.
#pragma once

#include <array>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "core/files/json/json.h"
#include "sinew/geometry/result.h"

namespace sinew {

/// Where in the file, twice: as a JSON path, and in the interface's words.
struct Place {
  std::string path;
  std::string words;

  Place(const char* both) : Place(both, both) {}  // NOLINT: implicit on purpose, most keys are their own words
  Place(std::string json, std::string named) : path(std::move(json)), words(std::move(named)) {}
};

/// Takes a tree apart. The first thing found wrong is kept; after it every answer is a default.
class Reader {
 public:
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }

  void refuse(const Place& place, std::string reason) {
    if (!error_) error_ = errorAt(place.path, std::move(reason), place.words);
  }

  void expect(const Place& place, const std::string& expected, const Json& node);

  /// Null, after a refusal, if the key is missing.
  const Json* need(const Json& object, const Place& place, const char* key, const std::string& expected) {
    const Json* child = object.find(key);
    if (!child) refuse(join(place, key), "expected " + expected + ", but the key is missing");
    return child;
  }

  std::string text(const Json& node, const Place& place);

  float number(const Json& node, const Place& place);

  int wholeNumber(const Json& node, const Place& place, const std::string& expected);

  template <std::size_t N>
  std::array<float, N> vector(const Json& node, const Place& place) {
    std::array<float, N> values{};
    vector(node, place, values);
    return values;
  }
  /// As many numbers as `values` has room for; after a refusal they stay as they are.
  void vector(const Json& node, const Place& place, std::span<float> values);

  /// The children, each with its place; none, after a refusal, if the node is no array.
  template <class Read>
  void each(const Json& node, const Place& place, Read read) {
    if (node.kind != Json::Kind::kArray) expect(place, "an array", node);
    for (std::size_t i = 0; !error_ && i < node.children.size(); ++i) read(node.children[i], at(place, i));
  }

  bool object(const Json& node, const Place& place) {
    if (node.kind != Json::Kind::kObject) expect(place, "an object", node);
    return node.kind == Json::Kind::kObject;
  }

  static Place join(const Place& place, const char* key) {
    if (place.path.empty()) return key;
    return {place.path + '.' + key, place.words + ", " + key};
  }
  static Place at(const Place& place, std::size_t i) {
    return {place.path + '[' + std::to_string(i) + ']', place.words + ' ' + std::to_string(i + 1)};
  }

 private:
  std::optional<Error> error_;
};

/// What the object holds beyond `known`, as the text of an object; "" for nothing.
[[nodiscard]] std::string unknownKeys(const Json& object, std::span<const std::string_view> known);
[[nodiscard]] inline std::string unknownKeys(const Json& object, std::initializer_list<std::string_view> known) {
  return unknownKeys(object, std::span(known.begin(), known.size()));
}

/// A member that is one of a few words; absent: as it was.
template <class Enum>
void readWord(Reader& reader, const Json& object, const Place& place, const char* key, const char* words,
              std::optional<Enum> (*named)(const std::string&), Enum& value) {
  const Json* node = object.find(key);
  if (!node) return;
  const auto found = node->kind == Json::Kind::kString ? named(node->content) : std::nullopt;
  if (found) {
    value = *found;
  } else {
    reader.expect(Reader::join(place, key), words, *node);
  }
}

/// Members that may be absent: then the value stays as it was.
void readFloat(Reader& reader, const Json& object, const Place& place, const char* key, float& value);
void readSwitch(Reader& reader, const Json& object, const Place& place, const char* key, bool& value);
/// "" after a refusal.
std::string readNeededText(Reader& reader, const Json& object, const Place& place, const char* key);

}  // namespace sinew
