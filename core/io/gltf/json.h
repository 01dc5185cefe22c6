// core/io/gltf/json.h: a glTF file's JSON with checked reading; what is refused names its JSON path.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "sinew/base/result.h"

namespace sinew::gltf {

/// How the stages of the import give up. importGltf turns it into a Result; it never leaves core/io.
struct Refusal {
  Error error;
};
[[noreturn]] void refuse(std::string place, std::string reason);

/// A place in the JSON: a value, or its absence, and the path to it. Refuses values of the wrong type or range.
/// Lives as long as the document it points into.
class Field {
 public:
  Field(const nlohmann::json* value, std::string place) : value_(value), place_(std::move(place)) {}

  [[nodiscard]] bool exists() const { return value_ != nullptr; }
  [[nodiscard]] const std::string& place() const { return place_; }  ///< For example meshes[2].primitives[0].indices

  /// Of an object; absent where this is absent or has no such key.
  [[nodiscard]] Field member(const std::string& key) const;
  [[nodiscard]] std::vector<std::string> keys() const;
  /// Of an array; the index must be < size().
  [[nodiscard]] Field item(std::size_t index) const;
  [[nodiscard]] std::size_t size() const;

  [[nodiscard]] bool boolean(bool fallback) const;
  [[nodiscard]] double number(double fallback) const;
  [[nodiscard]] std::string_view text(std::string_view fallback) const;
  /// A whole number >= 0 (also written 3.0) up to 2^53.
  [[nodiscard]] std::uint64_t count(std::uint64_t fallback) const;
  [[nodiscard]] std::uint64_t requiredCount() const;
  /// A whole number < `size`: the index of one of `size` things called `what`.
  [[nodiscard]] std::optional<int> index(std::size_t size, std::string_view what) const;
  [[nodiscard]] int requiredIndex(std::size_t size, std::string_view what) const;
  /// Fills `out` from an array of exactly as many finite numbers; false (and `out` untouched) where absent.
  bool numbers(std::span<double> out) const;

 private:
  void require() const;

  const nlohmann::json* value_;
  std::string place_;
};

/// Parsed JSON. Refuses text that is no JSON object, is nested deeper than any glTF file needs, or holds so many values
/// that they would not fit memory; the place is the byte.
[[nodiscard]] std::shared_ptr<const nlohmann::json> parseJson(std::string_view text);

}  // namespace sinew::gltf
