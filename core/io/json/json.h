// core/io/json/json.h: JSON values for the program's own small files (reports, state lines, preferences).
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "sinew/base/result.h"

namespace sinew {

/// A JSON value with value semantics; hides the library behind it, which only core/io knows. Keys keep their order.
class Json {
 public:
  Json();                          ///< null
  Json(bool value);                // NOLINT: implicit on purpose, so that set("key", 3) reads well
  Json(int value);                 // NOLINT
  Json(long long value);           // NOLINT
  Json(double value);              // NOLINT: not finite becomes null
  Json(float value);               // NOLINT: shortest text that reads back bit-equal
  Json(const char* value);         // NOLINT
  Json(const std::string& value);  // NOLINT
  Json(const Json& other);
  Json(Json&& other) noexcept;
  Json& operator=(Json other);
  ~Json();

  [[nodiscard]] static Json object();
  [[nodiscard]] static Json array();
  [[nodiscard]] static Result<Json> parse(std::string_view text);

  Json& set(const std::string& key, const Json& value);  ///< On an object; returns *this.
  Json& push(const Json& value);                         ///< On an array; returns *this.

  // Reading: what is absent or of another type gives the fallback.
  [[nodiscard]] Json at(const std::string& key) const;  ///< null if absent.
  [[nodiscard]] std::vector<Json> items() const;        ///< Of an array, else empty.
  [[nodiscard]] std::vector<std::string> keys() const;  ///< Of an object, else empty.
  [[nodiscard]] bool boolean(bool fallback) const;
  [[nodiscard]] double number(double fallback) const;
  [[nodiscard]] std::string text(const std::string& fallback) const;
  [[nodiscard]] bool isNull() const;

  /// One line, or indented by two spaces. Invalid UTF-8 is replaced.
  [[nodiscard]] std::string dump(bool indented = false) const;

 private:
  struct Impl;
  explicit Json(Impl&& impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace sinew
