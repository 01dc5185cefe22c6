// core/files/json/json.h: a JSON value: read from text, made by the program, written as text.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sinew/geometry/result.h"

namespace sinew {

/// Deeper nesting is refused, so that nothing that walks a tree can run out of stack.
inline constexpr int kMaxJsonDepth = 128;
/// More values than this are refused: a small file must not fill the memory.
inline constexpr int kMaxJsonValues = 4'000'000;

/// What a parse allows.
struct JsonLimits {
  int depth = kMaxJsonDepth;
  int values = kMaxJsonValues;
  std::string_view leftOut;   ///< Members of this name are checked and counted but not kept; "" for none.
  std::string_view keptIn{};  ///< But kept in the elements of the root's list of this name.
};

/// One JSON value, with value semantics. Objects keep the order of their keys. Numbers stay text, so that what is not
/// understood is written back as it was.
struct Json {
  enum class Kind { kNull, kFalse, kTrue, kNumber, kString, kArray, kObject };
  Kind kind = Kind::kNull;
  std::string key;             ///< In an object: its key there.
  std::string content;         ///< String: its characters, UTF-8. Number: its JSON token.
  std::vector<Json> children;  ///< Those of an array or object, in order. An object's keys are unique.

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

  /// Reads strictly RFC 8259 text. Error: a number out of range, a key that stands twice and what exceeds the limits
  /// are placed by their JSON path, all else by byte, line and column.
  [[nodiscard]] static Result<Json> parse(std::string_view text, const JsonLimits& limits = {});

  Json& set(std::string name, Json value);  ///< On an object: adds or replaces; returns *this.
  Json& push(Json value);                   ///< On an array; returns *this.

  // Reading: what is absent or of another type gives the fallback. References live as long as this value.
  [[nodiscard]] const Json* find(std::string_view name) const;  ///< Member of an object, or nullptr.
  [[nodiscard]] const Json& at(std::string_view name) const;    ///< Likewise; null if absent.
  [[nodiscard]] const std::vector<Json>& items() const;         ///< An array's, else empty.
  [[nodiscard]] std::vector<std::string> keys() const;          ///< An object's, else empty.
  [[nodiscard]] bool boolean(bool fallback) const;
  [[nodiscard]] double number(double fallback) const;
  [[nodiscard]] std::string text(const std::string& fallback) const;
  [[nodiscard]] bool isNull() const { return kind == Kind::kNull; }

  /// One line without spaces; or, indented, by two spaces with short lists of plain values kept on one line. Invalid
  /// UTF-8 is replaced by U+FFFD.
  [[nodiscard]] std::string dump(bool indented = false) const;

 private:
  Json(Kind of, std::vector<Json> items) : kind(of), children(std::move(items)) {}
};

/// The text with invalid UTF-8 replaced by U+FFFD.
[[nodiscard]] std::string validUtf8(const std::string& text);

/// A library's message cut to a length a person reads, in ASCII and on one line.
[[nodiscard]] std::string shortened(std::string message);

}  // namespace sinew
