// core/files/usd/text.cpp: .usda text.
#include "core/files/usd/text.h"

#include <array>
#include <charconv>
#include <cmath>

#include "core/files/json/json.h"

namespace sinew::usd {
namespace {

template <class Number>
void appendShortest(std::string& out, Number value) {
  if (!std::isfinite(value)) value = 0;
  std::array<char, 40> text{};
  out.append(text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr);
}

void appendEscaped(std::string& out, char c, char mark) {
  static constexpr std::string_view kHex = "0123456789abcdef";
  const auto byte = static_cast<unsigned char>(c);
  if (c == mark || c == '\\') out += {'\\', c};
  else if (c == '\n') out += "\\n";
  else if (c == '\t') out += "\\t";
  else if (byte < 0x20 || byte == 0x7f) out += {'\\', 'x', kHex[byte >> 4U], kHex[byte & 15U]};
  else out += c;
}

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isPlain(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || isDigit(c); }

}  // namespace

void appendNumber(std::string& out, float value) { appendShortest(out, value); }
void appendNumber(std::string& out, double value) { appendShortest(out, value); }

std::string numberText(float value) {
  std::string out;
  appendNumber(out, value);
  return out;
}

std::string numberText(double value) {
  std::string out;
  appendNumber(out, value);
  return out;
}

void appendItem(std::string& out, float value) { appendNumber(out, value); }
void appendItem(std::string& out, int value) { appendShortest(out, value); }

namespace {

template <class Number>
void appendNumbers(std::string& out, std::initializer_list<Number> values) {
  const char* between = "(";
  for (const Number value : values) {
    out += between;
    appendNumber(out, value);
    between = ", ";
  }
  out += ')';
}

}  // namespace

void appendItem(std::string& out, const glm::vec2& value) { appendNumbers(out, {value.x, value.y}); }
void appendItem(std::string& out, const glm::vec3& value) { appendNumbers(out, {value.x, value.y, value.z}); }
void appendItem(std::string& out, const glm::vec4& value) { appendNumbers(out, {value.x, value.y, value.z, value.w}); }
void appendItem(std::string& out, const glm::quat& value) { appendNumbers(out, {value.w, value.x, value.y, value.z}); }

void appendItem(std::string& out, const glm::dmat4& value) {
  out += "( ";
  for (int column = 0; column < 4; ++column) {
    const glm::dvec4& row = value[column];
    appendNumbers(out, {row.x, row.y, row.z, row.w});
    out += column < 3 ? ", " : " )";
  }
}

std::string quoted(const std::string& text) {
  // Some readers end a token at an escaped mark.
  const char mark = text.find('"') != std::string::npos && text.find('\'') == std::string::npos ? '\'' : '"';
  std::string out(1, mark);
  for (const char c : validUtf8(text)) appendEscaped(out, c, mark);
  return out + mark;
}

std::string quotedList(std::span<const std::string> texts) {
  std::string out = "[";
  for (const std::string& text : texts) out += (out.size() > 1 ? ", " : "") + quoted(text);
  return out + ']';
}

std::string identifierOf(const std::string& text, const std::string& otherwise) {
  std::string name;
  bool says = false;
  for (const char c : text) {
    const bool goesOn = (static_cast<unsigned char>(c) & 0xc0U) == 0x80U;  // inside UTF-8
    says = says || isPlain(c);
    if (isPlain(c)) name += c;
    else if (!goesOn) name += '_';
  }
  if (!says) return otherwise;
  return isDigit(name.front()) ? '_' + name : name;
}

std::string Siblings::fresh(const std::string& wanted, std::string_view between) {
  std::string name = wanted;
  for (int number = 2; !taken_.insert(name).second; ++number) {
    name = wanted + std::string(between) + std::to_string(number);
  }
  return name;
}

void Text::line(std::string_view text) {
  indent();
  out_ += text;
  out_ += '\n';
}

void Text::appendMetadata(const std::vector<std::string>& metadata) {
  out_ += " (\n";
  ++depth_;
  for (const std::string& each : metadata) line(each);
  --depth_;
  indent();
  out_ += ')';
}

void Text::open(std::string_view head, const std::vector<std::string>& metadata) {
  indent();
  out_ += head;
  if (!metadata.empty()) appendMetadata(metadata);
  out_ += '\n';
  line("{");
  ++depth_;
}

void Text::openSamples(std::string_view declaration) {
  line(std::string(declaration) + ".timeSamples = {");
  ++depth_;
}

void Text::close() {
  --depth_;
  line("}");
}

void Text::attribute(std::string_view declaration, std::string_view value, const std::vector<std::string>& metadata) {
  indent();
  out_ += declaration;
  out_ += " = ";
  out_ += value;
  if (!metadata.empty()) appendMetadata(metadata);
  out_ += '\n';
}

void Text::declare(std::string_view declaration, const std::vector<std::string>& metadata) {
  indent();
  out_ += declaration;
  appendMetadata(metadata);
  out_ += '\n';
}

std::vector<std::string> displayName(const std::string& name, const std::string& identifier) {
  if (name.empty() || name == identifier) return {};
  return {"displayName = " + quoted(name)};
}

}  // namespace sinew::usd
