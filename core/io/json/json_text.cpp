// core/io/json/json_text.cpp: nlohmann's lexer drives a small builder that knows the path.
#include "core/io/json/json_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <unordered_set>
#include <utility>

#include <nlohmann/json.hpp>

namespace sinew {
namespace {

using Library = nlohmann::ordered_json;
using Kind = JsonNode::Kind;

constexpr int kOutOfRangeId = 406;         // nlohmann: a number no double can hold.
constexpr std::size_t kInlineWidth = 100;  // Lists of plain values up to this long stay on one line.

template <class Number>
JsonNode shortestNumber(Number value) {
  if (!std::isfinite(value)) return {};
  std::array<char, 64> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  std::string token(text.data(), end);
  if (token == "-0") token = "-0.0";  // Readers take "-0" for a whole number and lose its sign.
  return {Kind::kNumber, {}, std::move(token), {}};
}

/// "byte 61 (line 3, column 8)" of the last byte read.
std::string positionText(std::string_view text, std::size_t bytesRead) {
  const std::size_t byte = std::min(bytesRead, text.size());
  const std::string_view before = text.substr(0, byte == 0 ? 0 : byte - 1);
  const auto line = 1 + std::ranges::count(before, '\n');
  const std::size_t lineBreak = before.rfind('\n');
  const std::size_t column = before.size() - (lineBreak == std::string_view::npos ? 0 : lineBreak + 1) + 1;
  return "byte " + std::to_string(byte) + " (line " + std::to_string(line) + ", column " + std::to_string(column) + ')';
}

/// What the library says, without its own name and position.
std::string plainReason(const std::string& message) {
  const std::size_t column = message.find("column ");
  const std::size_t colon = column == std::string::npos ? column : message.find(": ", column);
  return colon == std::string::npos ? message : message.substr(colon + 2);
}

/// Receives the library's events and grows the tree. Returning false ends the parse.
class Builder {
 public:
  using number_integer_t = Library::number_integer_t;
  using number_unsigned_t = Library::number_unsigned_t;
  using number_float_t = Library::number_float_t;
  using string_t = Library::string_t;
  using binary_t = Library::binary_t;

  explicit Builder(std::string_view text) : text_(text) {}

  bool null() { return leaf(Kind::kNull, {}); }
  bool boolean(bool value) { return leaf(value ? Kind::kTrue : Kind::kFalse, {}); }
  bool number_integer(number_integer_t value) { return leaf(Kind::kNumber, std::to_string(value)); }
  bool number_unsigned(number_unsigned_t value) { return leaf(Kind::kNumber, std::to_string(value)); }
  bool number_float(number_float_t, const string_t& token) { return leaf(Kind::kNumber, token); }
  bool string(string_t& value) { return leaf(Kind::kString, value); }
  bool binary(binary_t&) { return false; }
  bool start_object(std::size_t) { return open(Kind::kObject); }
  bool start_array(std::size_t) { return open(Kind::kArray); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

  bool key(string_t& name) {
    pendingKey_ = name;
    if (stack_.back().keys.insert(name).second) return true;
    return fail(path(), "this key stands twice in its object");
  }

  bool parse_error(std::size_t bytesRead, const std::string& token, const Library::exception& error) {
    if (error.id == kOutOfRangeId) return fail(path(), "expected a finite number, got " + token);
    const std::string where = path();
    return fail(positionText(text_, bytesRead),
                "not JSON" + (where.empty() ? "" : " in " + where) + ": " + plainReason(error.what()));
  }

  Result<JsonNode> take(bool parsed) {
    if (error_) return *error_;
    if (!parsed) return errorAt({}, "not JSON");
    return std::move(root_);
  }

 private:
  struct Frame {
    JsonNode node;
    std::unordered_set<std::string> keys;
  };

  bool fail(std::string place, std::string reason) {
    if (!error_) error_ = errorAt(std::move(place), std::move(reason));
    return false;
  }

  /// Of the value that comes next, "primitives[2].radii[1]".
  [[nodiscard]] std::string path() const {
    std::string result;
    for (std::size_t i = 0; i < stack_.size(); ++i) {
      const JsonNode& node = stack_[i].node;
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

  bool add(JsonNode node) {
    if (stack_.empty()) {
      root_ = std::move(node);
    } else {
      stack_.back().node.children.push_back(std::move(node));
    }
    return true;
  }

  std::string takeKey() { return std::exchange(pendingKey_, {}); }

  bool leaf(Kind kind, std::string text) {
    if (++values_ > kMaxJsonValues) return fail(path(), "more than " + std::to_string(kMaxJsonValues) + " values");
    return add({kind, takeKey(), std::move(text), {}});
  }

  bool open(Kind kind) {
    if (++values_ > kMaxJsonValues) return fail(path(), "more than " + std::to_string(kMaxJsonValues) + " values");
    if (stack_.size() >= static_cast<std::size_t>(kMaxJsonDepth)) {
      return fail(deepPlace(), "nested deeper than " + std::to_string(kMaxJsonDepth) + " levels");
    }
    stack_.push_back({{kind, takeKey(), {}, {}}, {}});
    return true;
  }

  /// The path of something too deep is itself too long to read: its beginning says enough.
  [[nodiscard]] std::string deepPlace() const {
    const std::string whole = path();
    return whole.size() <= 60 ? whole : whole.substr(0, whole.find_last_of(".[", 60)) + "...";
  }

  bool close() {
    JsonNode node = std::move(stack_.back().node);
    stack_.pop_back();
    return add(std::move(node));
  }

  std::string_view text_;
  std::vector<Frame> stack_;
  std::string pendingKey_;
  int values_ = 0;
  JsonNode root_;
  std::optional<Error> error_;
};

std::string quoted(const std::string& text) {
  return Library(text).dump(-1, ' ', false, Library::error_handler_t::replace);
}

bool isContainer(const JsonNode& node) { return node.kind == Kind::kArray || node.kind == Kind::kObject; }

/// Appends the node's text. `spaced` puts a space after commas and colons, and inside braces.
void writeFlat(const JsonNode& node, bool spaced, std::string& out) {
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
      out += node.text;
      return;
    case Kind::kString:
      out += quoted(node.text);
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
  for (const JsonNode& child : node.children) {
    if (!first) out += spaced ? ", " : ",";
    first = false;
    if (object) out += quoted(child.key) + (spaced ? ": " : ":");
    writeFlat(child, spaced, out);
  }
  if (padded) out += ' ';
  out += object ? '}' : ']';
}

void writeIndented(const JsonNode& node, std::size_t indent, std::string& out) {
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
  for (const JsonNode& child : node.children) {
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

const JsonNode* JsonNode::find(std::string_view name) const {
  if (kind != Kind::kObject) return nullptr;
  const auto found = std::ranges::find(children, name, &JsonNode::key);
  return found == children.end() ? nullptr : &*found;
}

JsonNode numberNode(float value) { return shortestNumber(value); }
JsonNode numberNode(double value) { return shortestNumber(value); }
JsonNode numberNode(long long value) { return {Kind::kNumber, {}, std::to_string(value), {}}; }
JsonNode stringNode(std::string text) { return {Kind::kString, {}, std::move(text), {}}; }

Result<JsonNode> parseJson(std::string_view text) {
  Builder builder(text);
  const bool parsed = Library::sax_parse(text.begin(), text.end(), &builder);
  return builder.take(parsed);
}

std::string writeJson(const JsonNode& node, bool indented) {
  std::string out;
  if (indented) {
    writeIndented(node, 0, out);
  } else {
    writeFlat(node, false, out);
  }
  return out;
}

}  // namespace sinew
