// core/files/usd/text.h: USD's text form: names, numbers, strings, nested blocks.
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

/// The shortest text that reads back bit-equal; 0 for what is not finite.
void appendNumber(std::string& out, float value);
void appendNumber(std::string& out, double value);
[[nodiscard]] std::string numberText(double value);

/// "(1, 2, 3)"; a rotation with its real part first.
void appendTuple(std::string& out, const glm::vec2& value);
void appendTuple(std::string& out, const glm::vec3& value);
void appendTuple(std::string& out, const glm::quat& value);
/// As rows that vectors are multiplied with from the left, as USD has them: the transpose of how it is written here.
void appendTuple(std::string& out, const glm::dmat4& value);

void appendItem(std::string& out, float value);
void appendItem(std::string& out, int value);
template <class Value>
void appendItem(std::string& out, const Value& value) {
  appendTuple(out, value);
}
/// "[1, 2, 3]"
template <class Values>
void appendArray(std::string& out, const Values& values) {
  out += '[';
  const char* between = "";
  for (const auto& value : values) {
    out += between;
    appendItem(out, value);
    between = ", ";
  }
  out += ']';
}
template <class Values>
[[nodiscard]] std::string arrayText(const Values& values) {
  std::string out;
  appendArray(out, values);
  return out;
}
template <class Value>
[[nodiscard]] std::string tupleText(const Value& value) {
  std::string out;
  appendTuple(out, value);
  return out;
}

/// With quotation marks, escaped; invalid UTF-8 is replaced.
[[nodiscard]] std::string quoted(const std::string& text);
/// `["a", "b"]`
[[nodiscard]] std::string quotedList(std::span<const std::string> texts);

/// Letters, digits and underscores, no digit first; all else becomes underscores.
/// @param otherwise  stands for a text without any letter or digit
[[nodiscard]] std::string identifierOf(const std::string& text, const std::string& otherwise);

/// Names that stand side by side.
class Siblings {
 public:
  /// A name that was not given yet: as it is, or with a number.
  std::string fresh(const std::string& wanted, std::string_view between = "_");

 private:
  std::set<std::string> taken_;
};

/// Blocks in braces, four spaces a level.
class Text {
 public:
  void line(std::string_view text);
  /// head ( metadata ) { ; without the parentheses where there is none.
  void open(std::string_view head, const std::vector<std::string>& metadata = {});
  /// "type name.timeSamples = {"
  void openSamples(std::string_view declaration);
  void close();
  /// `type name = value`, with `( metadata )` where there is some.
  void attribute(std::string_view declaration, std::string_view value, const std::vector<std::string>& metadata = {});
  /// Lines that are indented already.
  void append(std::string_view lines) { out_ += lines; }
  /// Without a value, for one whose samples follow.
  void declare(std::string_view declaration, const std::vector<std::string>& metadata);

  [[nodiscard]] std::string take() && { return std::move(out_); }

 private:
  void indent() { out_.append(4 * depth_, ' '); }
  void appendMetadata(const std::vector<std::string>& metadata);

  std::string out_;
  std::size_t depth_ = 0;
};

/// Metadata of a prim: what it was called before its name became an identifier.
[[nodiscard]] std::vector<std::string> displayName(const std::string& name, const std::string& identifier);

}  // namespace sinew::usd
