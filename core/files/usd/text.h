// core/files/usd/text.h: .usda text: names, numbers, strings, nested blocks.
#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/mat4x4.hpp>

#include "sinew/geometry/geometry.h"

namespace sinew::usd {

void appendNumber(std::string& out, float value);  ///< The shortest exact text; 0 if not finite.
void appendNumber(std::string& out, double value);
[[nodiscard]] std::string numberText(float value);
[[nodiscard]] std::string numberText(double value);

void appendItem(std::string& out, const glm::vec2& value);  ///< "(1, 2, 3)"; a rotation with its real part first.
void appendItem(std::string& out, const glm::vec3& value);
void appendItem(std::string& out, const glm::vec4& value);
void appendItem(std::string& out, const glm::quat& value);
/// In the order of USD, which multiplies row vectors from the left.
void appendItem(std::string& out, const glm::dmat4& value);

void appendItem(std::string& out, float value);
void appendItem(std::string& out, int value);

/// "[1, 2, 3]"
template <class Values>
[[nodiscard]] std::string arrayText(const Values& values) {
  std::string out = "[";
  for (const auto& value : values) {
    if (out.size() > 1) out += ", ";
    appendItem(out, value);
  }
  return out + ']';
}
template <class Value>
[[nodiscard]] std::string tupleText(const Value& value) {
  std::string out;
  appendItem(out, value);
  return out;
}

/// With quotation marks, escaped; invalid UTF-8 is replaced.
[[nodiscard]] std::string quoted(const std::string& text);
[[nodiscard]] std::string quotedList(std::span<const std::string> texts);  ///< `["a", "b"]`

/// Letters, digits, underscores, no digit first; others become underscores. @param otherwise  without letter or digit
[[nodiscard]] std::string identifierOf(const std::string& text, const std::string& otherwise);

/// Unique names of sibling prims.
class Siblings {
 public:
  /// A new name: as wanted, or with a number.
  std::string fresh(const std::string& wanted, std::string_view between = "_");

 private:
  std::set<std::string> taken_;
};

/// Blocks in braces, four spaces a level.
class Text {
 public:
  void line(std::string_view text);
  void open(std::string_view head, const std::vector<std::string>& metadata = {});  ///< head ( metadata ) {
  void openSamples(std::string_view declaration);                                   ///< "type name.timeSamples = {"
  void close();
  /// type name = value ( metadata )
  void attribute(std::string_view declaration, std::string_view value, const std::vector<std::string>& metadata = {});
  void append(std::string_view lines) { out_ += lines; }  ///< Indented lines.
  /// Without a value; samples follow.
  void declare(std::string_view declaration, const std::vector<std::string>& metadata);

  [[nodiscard]] std::string take() && { return std::move(out_); }

 private:
  void indent() { out_.append(4 * depth_, ' '); }
  void appendMetadata(const std::vector<std::string>& metadata);

  std::string out_;
  std::size_t depth_ = 0;
};

/// Metadata of a prim: its name before it became an identifier.
[[nodiscard]] std::vector<std::string> displayName(const std::string& name, const std::string& identifier);

}  // namespace sinew::usd
