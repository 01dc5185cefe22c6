// core/files/json/json.h: a JSON value: read from text, made by the program, written as text.
#pragma once

#include <array>
#include <functional>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sinew/geometry/result.h"

namespace sinew {

/// Deeper nesting is refused, so that walking a tree cannot overflow the stack.
inline constexpr int kMaxJsonDepth = 128;
inline constexpr int kMaxJsonValues = 4'000'000;  ///< More values are refused: a small file must not fill the memory.

struct JsonLimits {
  int depth = kMaxJsonDepth;
  int values = kMaxJsonValues;
  std::string_view leftOut;   ///< Members of this name are checked and counted but dropped; "" for none.
  std::string_view keptIn{};  ///< But kept in elements of the root's list of this name.
};

/// A JSON value. Objects keep their order of keys; numbers stay text, so that unknown members are rewritten unchanged.
struct Json {
  enum class Kind { kNull, kFalse, kTrue, kNumber, kString, kArray, kObject };
  Kind kind = Kind::kNull;
  std::string key;             ///< Its key in an object.
  std::string content;         ///< String: its characters, UTF-8. Number: its JSON token.
  std::vector<Json> children;  ///< Of an array or object, in order. Keys are unique.

  Json() = default;                                               ///< null
  Json(bool value) : kind(value ? Kind::kTrue : Kind::kFalse) {}  // NOLINT: implicit on purpose, so that
  Json(int value) : Json(static_cast<long long>(value)) {}        // NOLINT  set("key", 3) reads well
  Json(long long value) : kind(Kind::kNumber), content(std::to_string(value)) {}  // NOLINT
  Json(double value);                                                             // NOLINT: not finite becomes null
  Json(float value);                                                           // NOLINT: shortest text that reads back
  Json(const char* value) : Json(std::string(value)) {}                        // NOLINT  bit-equal
  Json(std::string value) : kind(Kind::kString), content(std::move(value)) {}  // NOLINT

  [[nodiscard]] static Json object() { return Json(Kind::kObject, {}); }
  [[nodiscard]] static Json array(std::vector<Json> items = {}) { return Json(Kind::kArray, std::move(items)); }

  /// Parses RFC 8259 text strictly. Error: its place is the JSON path for numbers out of range, duplicate keys and
  /// exceeded limits, else byte, line and column.
  [[nodiscard]] static Result<Json> parse(std::string_view text, const JsonLimits& limits = {});

  Json& set(std::string name, Json value);  ///< On an object: adds or replaces; returns *this.
  Json& push(Json value);                   ///< On an array; returns *this.

  // Reading: an absent value or one of another type gives the fallback. References live as long as this value.
  [[nodiscard]] const Json* find(std::string_view name) const;  ///< Member of an object, or nullptr.
  [[nodiscard]] const Json& at(std::string_view name) const;    ///< Likewise; null if absent.
  [[nodiscard]] const std::vector<Json>& items() const;         ///< An array's, else empty.
  [[nodiscard]] std::vector<std::string> keys() const;          ///< An object's, else empty.
  [[nodiscard]] bool boolean(bool fallback) const;
  [[nodiscard]] double number(double fallback) const;
  [[nodiscard]] std::string text(const std::string& fallback) const;
  [[nodiscard]] bool isNull() const { return kind == Kind::kNull; }

  /// One line without spaces; or, indented by two spaces, short lists of plain values on one line. Bad UTF-8 -> U+FFFD.
  [[nodiscard]] std::string dump(bool indented = false) const;

 private:
  Json(Kind of, std::vector<Json> items) : kind(of), children(std::move(items)) {}
};

[[nodiscard]] std::string validUtf8(const std::string& text);  ///< The text with invalid UTF-8 replaced by U+FFFD.

/// A library's message cut to a length a person reads, in ASCII and on one line.
[[nodiscard]] std::string shortened(std::string message);

// Building JSON.

/// An array of what `write` makes of each item.
template <class Items, class Write = std::identity>
[[nodiscard]] Json jsonList(const Items& items, const Write& write = {}) {
  std::vector<Json> list;
  for (const auto& item : items) list.push_back(write(item));
  return Json::array(std::move(list));
}

inline Json numbers(std::initializer_list<float> values) { return jsonList(values); }

/// Builds an object: known keys in order, then unknown ones from the file.
class ObjectWriter {
 public:
  ObjectWriter& set(const char* key, Json value) {
    value.key = key;
    object_.children.push_back(std::move(value));
    return *this;
  }

  Json finish(const std::string& unknownKeys) {
    if (unknownKeys.empty()) return std::move(object_);
    auto unknown = Json::parse(unknownKeys);
    if (!unknown) return std::move(object_);
    for (Json& child : unknown.value().children) {
      if (!object_.find(child.key)) object_.children.push_back(std::move(child));
    }
    return std::move(object_);
  }

 private:
  Json object_ = Json::object();
};

// Reading a tree. Every refusal names its place.

/// Where in the file, twice: as a JSON path, and in the interface's words.
struct Place {
  std::string path;
  std::string words;

  Place(const char* both) : Place(both, both) {}  // NOLINT: implicit on purpose, most keys are their own words
  Place(std::string json, std::string named) : path(std::move(json)), words(std::move(named)) {}
};

/// Keeps the first error; after it every answer is a default.
class Reader {
 public:
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }

  void refuse(const Place& place, std::string reason) {
    if (!error_) error_ = errorAt(place.path, std::move(reason), place.words);
  }

  void expect(const Place& place, const std::string& expected, const Json& node);

  /// Null after refusing a missing key.
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
  /// values.size() numbers; unchanged after a refusal.
  void vector(const Json& node, const Place& place, std::span<float> values);

  /// Calls read(child, place) for each; none after refusing a node that is not an array.
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

/// Members of an object beyond `known`, as the text of an object; "" for none.
[[nodiscard]] std::string unknownKeys(const Json& object, std::span<const std::string_view> known);
[[nodiscard]] inline std::string unknownKeys(const Json& object, std::initializer_list<std::string_view> known) {
  return unknownKeys(object, std::span(known.begin(), known.size()));
}

/// A member that is one of several words; unchanged if absent.
template <class Enum>
void readWord(Reader& reader, const Json& object, const Place& place, const char* key, const char* words,
              std::optional<Enum> (*named)(const std::string&), Enum& value) {
  const Json* node = object.find(key);
  if (!node) return;
  const auto found = node->kind == Json::Kind::kString ? named(node->content) : std::nullopt;
  if (found) value = *found;
  else reader.expect(Reader::join(place, key), words, *node);
}

/// What `read` makes of each element of a list; none where the member is absent.
/// @param words  for one element, in the interface  @param read  (Reader&, const Json&, const Place&)
template <class Read>
auto readList(Reader& reader, const Json& object, const Place& place, const char* key, const std::string& words,
              const Read& read) {
  std::vector<decltype(read(reader, object, place))> items;
  const Json* node = object.find(key);
  if (!node) return items;
  const Place own{Reader::join(place, key).path, place.path.empty() ? words : place.words + ", " + words};
  reader.each(*node, own, [&](const Json& item, const Place& at) { items.push_back(read(reader, item, at)); });
  return items;
}

/// Optional members; unchanged if absent.
void readFloat(Reader& reader, const Json& object, const Place& place, const char* key, float& value);
void readSwitch(Reader& reader, const Json& object, const Place& place, const char* key, bool& value);
/// "" after a refusal.
std::string readNeededText(Reader& reader, const Json& object, const Place& place, const char* key);

}  // namespace sinew
