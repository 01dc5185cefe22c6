// core/files/json/json.cpp: making, reading and writing JSON values.
#include "core/files/json/json.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>

#include <nlohmann/json.hpp>

namespace sinew {
namespace {

using Library = nlohmann::ordered_json;
using Kind = Json::Kind;

constexpr std::size_t kInlineWidth = 100;  // Lists of plain values up to this long stay on one line.

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

/// Appends the node's text. `spaced` puts a space after commas and colons, and inside braces.
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
  // What is too small for a double is reported as out of range and is 0; too large does not pass the parser.
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

}  // namespace sinew
