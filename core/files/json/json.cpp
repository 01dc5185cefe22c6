// core/files/json/json.cpp: making, reading and writing JSON values.
#include "core/files/json/json.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <unordered_set>

#include <nlohmann/json.hpp>

#include "core/geometry/at.h"

namespace sinew {
namespace {

using Library = nlohmann::ordered_json;
using Kind = Json::Kind;

constexpr std::size_t kInlineWidth = 100;  // Longest list of plain values on one line.

template <class Number>
void setShortest(Number value, Json& json) {
  if (!std::isfinite(value)) return;
  std::array<char, 64> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  json.kind = Kind::kNumber;
  json.content.assign(text.data(), end);
  if (json.content == "-0") json.content = "-0.0";  // Readers take "-0" for a whole number and lose its sign.
}

std::string quoted(const std::string& text) {
  return Library(text).dump(-1, ' ', false, Library::error_handler_t::replace);
}

bool isContainer(const Json& node) { return node.kind == Kind::kArray || node.kind == Kind::kObject; }

/// @param spaced  with a space after commas and colons, and inside braces
void writeFlat(const Json& node, bool spaced, std::string& out) {
  switch (node.kind) {
    case Kind::kNull:
      out += "null";
      return;
    case Kind::kFalse:
      out += "false";
      return;
    case Kind::kTrue:
      out += "true";
      return;
    case Kind::kNumber:
      out += node.content;
      return;
    case Kind::kString:
      out += quoted(node.content);
      return;
    case Kind::kArray:
    case Kind::kObject:
      break;
  }
  const bool object = node.kind == Kind::kObject;
  const bool padded = spaced && object && !node.children.empty();
  out += object ? '{' : '[';
  if (padded) out += ' ';
  bool first = true;
  for (const Json& child : node.children) {
    if (!first) out += spaced ? ", " : ",";
    first = false;
    if (object) out += quoted(child.key) + (spaced ? ": " : ":");
    writeFlat(child, spaced, out);
  }
  if (padded) out += ' ';
  out += object ? '}' : ']';
}

void writeIndented(const Json& node, std::size_t indent, std::string& out) {
  if (std::ranges::none_of(node.children, isContainer)) {
    std::string flat;
    writeFlat(node, true, flat);
    if (!isContainer(node) || node.children.empty() || indent + flat.size() <= kInlineWidth) {
      out += flat;
      return;
    }
  }
  const bool object = node.kind == Kind::kObject;
  out += object ? '{' : '[';
  bool first = true;
  for (const Json& child : node.children) {
    out += first ? "\n" : ",\n";
    first = false;
    out.append(indent + 2, ' ');
    if (object) out += quoted(child.key) + ": ";
    writeIndented(child, indent + 2, out);
  }
  out += '\n';
  out.append(indent, ' ');
  out += object ? '}' : ']';
}

}  // namespace

Json::Json(double value) { setShortest(value, *this); }
Json::Json(float value) { setShortest(value, *this); }

Json& Json::set(std::string name, Json value) {
  assert(kind == Kind::kObject);
  value.key = std::move(name);
  const auto present = std::ranges::find(children, value.key, &Json::key);
  if (present != children.end()) *present = std::move(value);
  else children.push_back(std::move(value));
  return *this;
}

Json& Json::push(Json value) {
  assert(kind == Kind::kArray);
  value.key.clear();
  children.push_back(std::move(value));
  return *this;
}

const Json* Json::find(std::string_view name) const {
  if (kind != Kind::kObject) return nullptr;
  const auto found = std::ranges::find(children, name, &Json::key);
  return found == children.end() ? nullptr : &*found;
}

const Json& Json::at(std::string_view name) const {
  static const Json kNothing;
  const Json* child = find(name);
  return child ? *child : kNothing;
}

const std::vector<Json>& Json::items() const {
  static const std::vector<Json> kNone;
  return kind == Kind::kArray ? children : kNone;
}

std::vector<std::string> Json::keys() const {
  std::vector<std::string> result;
  if (kind != Kind::kObject) return result;
  for (const Json& child : children) result.push_back(child.key);
  return result;
}

bool Json::boolean(bool fallback) const {
  if (kind == Kind::kTrue) return true;
  return kind == Kind::kFalse ? false : fallback;
}

double Json::number(double fallback) const {
  if (kind != Kind::kNumber) return fallback;
  double value = 0.0;
  // Numbers too small for a double are out of range and become 0; the parser refuses those too large.
  const auto [end, status] = std::from_chars(content.data(), content.data() + content.size(), value);
  return status == std::errc{} ? value : 0.0;
}

std::string Json::text(const std::string& fallback) const { return kind == Kind::kString ? content : fallback; }

std::string Json::dump(bool indented) const {
  std::string out;
  if (indented) writeIndented(*this, 0, out);
  else writeFlat(*this, false, out);
  return out;
}

std::string validUtf8(const std::string& text) { return Library::parse(quoted(text)).get<std::string>(); }

// Parsing: nlohmann's lexer drives a builder that knows the path and the limits.

namespace {

constexpr int kOutOfRangeId = 406;  // nlohmann: a number no double can hold.

/// "byte 61 (line 3, column 8)" of the last byte read.
std::string positionText(std::string_view text, std::size_t bytesRead) {
  const std::size_t byte = std::min(bytesRead, text.size());
  const std::string_view before = text.substr(0, byte == 0 ? 0 : byte - 1);
  const auto line = 1 + std::ranges::count(before, '\n');
  const std::size_t lineBreak = before.rfind('\n');
  const std::size_t column = before.size() - (lineBreak == std::string_view::npos ? 0 : lineBreak + 1) + 1;
  return "byte " + std::to_string(byte) + " (line " + std::to_string(line) + ", column " + std::to_string(column) + ')';
}

/// The library's message without its name and position.
std::string plainReason(const std::string& message) {
  const std::size_t column = message.find("column ");
  const std::size_t colon = column == std::string::npos ? column : message.find(": ", column);
  return colon == std::string::npos ? message : message.substr(colon + 2);
}

/// Receives the library's events and builds the tree. Returning false ends the parse.
class Builder {
 public:
  using number_integer_t = Library::number_integer_t;
  using number_unsigned_t = Library::number_unsigned_t;
  using number_float_t = Library::number_float_t;
  using string_t = Library::string_t;
  using binary_t = Library::binary_t;

  Builder(std::string_view text, const JsonLimits& limits) : text_(text), limits_(limits) {}

  bool null() { return leaf(Kind::kNull, {}); }
  bool boolean(bool value) { return leaf(value ? Kind::kTrue : Kind::kFalse, {}); }
  bool number_integer(number_integer_t value) { return leaf(Kind::kNumber, std::to_string(value)); }
  bool number_unsigned(number_unsigned_t value) { return leaf(Kind::kNumber, std::to_string(value)); }
  bool number_float(number_float_t, const string_t& token) { return leaf(Kind::kNumber, token); }
  bool string(string_t& value) { return leaf(Kind::kString, std::move(value)); }
  bool binary(binary_t&) { return false; }
  bool start_object(std::size_t) { return open(Kind::kObject); }
  bool start_array(std::size_t) { return open(Kind::kArray); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

  bool key(string_t& name) {
    pendingKey_ = name;
    if (leftOutAt_ == 0 && !limits_.leftOut.empty() && name == limits_.leftOut && !kept()) leftOutAt_ = stack_.size();
    if (stack_.back().keys.insert(name).second) return true;
    return fail(shortPath(), "this key appears twice in its object");
  }

  bool parse_error(std::size_t bytesRead, const std::string& token, const Library::exception& error) {
    if (error.id == kOutOfRangeId) return fail(shortPath(), "expected a finite number, got " + shortened(token));
    const std::string where = shortPath();
    return fail(positionText(text_, bytesRead),
                "not JSON" + (where.empty() ? "" : " in " + where) + ": " + shortened(plainReason(error.what())));
  }

  Result<Json> take(bool parsed) {
    if (error_) return *error_;
    if (!parsed) return errorAt({}, "not JSON");
    return std::move(root_);
  }

 private:
  struct Frame {
    Json node;
    std::unordered_set<std::string> keys;
  };

  bool fail(std::string place, std::string reason) {
    if (!error_) error_ = errorAt(std::move(place), std::move(reason));
    return false;
  }

  /// Path of the next value, "primitives[2].radii[1]".
  [[nodiscard]] std::string path() const {
    std::string result;
    for (std::size_t i = 0; i < stack_.size(); ++i) {
      const Json& node = stack_[i].node;
      if (node.kind == Kind::kArray) {
        result += '[' + std::to_string(node.children.size()) + ']';
      } else if (const std::string& name = i + 1 < stack_.size() ? stack_[i + 1].node.key : pendingKey_;
                 !name.empty()) {
        if (!result.empty()) result += '.';
        result += name;
      }
    }
    return result;
  }

  bool add(Json node) {
    if (leftOutAt_ > 0) {
      if (stack_.size() == leftOutAt_) leftOutAt_ = 0;
      return true;
    }
    if (stack_.empty()) root_ = std::move(node);
    else stack_.back().node.children.push_back(std::move(node));
    return true;
  }

  /// Whether the current object is an element of keptIn.
  [[nodiscard]] bool kept() const {
    return stack_.size() == 3 && !limits_.keptIn.empty() && stack_[1].node.key == limits_.keptIn;
  }

  bool count() {
    if (++values_ <= limits_.values) return true;
    constexpr int kMillion = 1'000'000;
    const bool round = limits_.values % kMillion == 0;
    return fail(shortPath(), "more than " + std::to_string(round ? limits_.values / kMillion : limits_.values) +
                                 (round ? " million" : "") + " JSON values");
  }

  std::string takeKey() { return std::exchange(pendingKey_, {}); }

  bool leaf(Kind kind, std::string content) {
    if (!count()) return false;
    Json node;
    node.kind = kind;
    node.key = takeKey();
    node.content = std::move(content);
    return add(std::move(node));
  }

  bool open(Kind kind) {
    if (!count()) return false;
    if (stack_.size() >= toIndex(limits_.depth)) {
      return fail(shortPath(), "JSON nested deeper than " + std::to_string(limits_.depth) + " levels");
    }
    stack_.emplace_back();
    stack_.back().node.kind = kind;
    stack_.back().node.key = takeKey();
    return true;
  }

  /// The beginning of a long path.
  [[nodiscard]] std::string shortPath() const {
    constexpr std::size_t kMaxLength = 60;
    const std::string whole = path();
    if (whole.size() <= kMaxLength) return whole;
    return whole.substr(0, std::min(whole.find_last_of(".[", kMaxLength), kMaxLength)) + "...";
  }

  bool close() {
    Json node = std::move(stack_.back().node);
    stack_.pop_back();
    return add(std::move(node));
  }

  std::string_view text_;
  JsonLimits limits_;
  std::size_t leftOutAt_ = 0;  // Depth of the object whose member is being dropped; 0: none.
  std::vector<Frame> stack_;
  std::string pendingKey_;
  int values_ = 0;
  Json root_;
  std::optional<Error> error_;
};

}  // namespace

Result<Json> Json::parse(std::string_view text, const JsonLimits& limits) {
  Builder builder(text, limits);
  const bool parsed = Library::sax_parse(text.begin(), text.end(), &builder);
  return builder.take(parsed);
}

std::string shortened(std::string message) {
  constexpr std::size_t kMaxLength = 160;
  if (message.size() > kMaxLength) {
    message.resize(kMaxLength);
    message += " ...";
  }
  for (char& c : message) {
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
    if (static_cast<unsigned char>(c) >= 0x7f) c = '?';  // the cut may have split a character
  }
  return message;
}

// Reading values out of nodes.

namespace {

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
  // Out of a float's range: small numbers become 0, large ones are refused.
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
