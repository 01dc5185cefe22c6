// core/runtime/archive.h: numbers, texts and lists as bytes, and back. Both ways have the same calls, so that
// core/runtime/layout.h says the order once.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "sinew/geometry/geometry.h"
#include "sinew/geometry/result.h"

namespace sinew::gamefile {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they lie in memory");

inline constexpr std::uint32_t kMostTextBytes = 65536;

/// Nothing but floats, without space between them.
template <class T>
inline constexpr bool kIsFloats =
    std::is_same_v<T, float> || std::is_same_v<T, glm::vec2> || std::is_same_v<T, glm::vec3> ||
    std::is_same_v<T, glm::vec4> || std::is_same_v<T, glm::quat> || std::is_same_v<T, glm::mat4>;

class Writer {
 public:
  template <class T>
  using Ref = const T&;

  void number(int value) { put(&value, sizeof value); }
  template <class T>
  void floats(const T& value) {
    static_assert(kIsFloats<T>);
    put(&value, sizeof value);
  }
  void flag(bool value) { byte(value ? 1 : 0); }
  /// @param last  the largest value
  template <class Enum>
  void choice(Enum value, Enum /*last*/) {
    byte(static_cast<std::uint8_t>(value));
  }
  void text(const std::string& value) {
    const std::size_t size = std::min<std::size_t>(value.size(), kMostTextBytes);
    count(size);
    put(value.data(), size);
  }
  template <class T>
  void floatList(const std::vector<T>& values) {
    static_assert(kIsFloats<T>);
    count(values.size());
    put(values.data(), values.size() * sizeof(T));
  }
  void numberList(const std::vector<int>& values) {
    count(values.size());
    put(values.data(), values.size() * sizeof(int));
  }
  /// Of things that have fields(). @param least  bytes of the shortest one
  template <class T>
  void list(const std::vector<T>& values, std::size_t least) {
    list(values, least, [this](const T& value) { fields(*this, value); });
  }
  template <class T, class Item>
  void list(const std::vector<T>& values, std::size_t /*least*/, Item item) {
    count(values.size());
    for (const T& value : values) item(value);
  }
  template <class T, class Item>
  void maybe(const std::optional<T>& value, Item item) {
    flag(value.has_value());
    if (value) item(*value);
  }
  void section(const char* /*name*/) {}
  [[nodiscard]] bool failed() const { return false; }

  [[nodiscard]] std::vector<std::byte>& bytes() { return bytes_; }

 private:
  void byte(std::uint8_t value) { put(&value, 1); }
  void count(std::size_t size) {
    const auto number = static_cast<std::uint32_t>(size);
    put(&number, sizeof number);
  }
  void put(const void* from, std::size_t size) {
    const auto* const begin = static_cast<const std::byte*>(from);
    bytes_.insert(bytes_.end(), begin, begin + size);
  }

  std::vector<std::byte> bytes_;
};

/// After the first mistake all that is read is empty, and nothing is allocated any more.
class Reader {
 public:
  template <class T>
  using Ref = T&;

  explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  void number(int& value) { take(&value, sizeof value); }
  template <class T>
  void floats(T& value) {
    static_assert(kIsFloats<T>);
    take(&value, sizeof value);
    if (!areFinite(&value, 1)) refuse("a number is not finite");
  }
  void flag(bool& value) { value = byteUpTo(1) != 0; }
  template <class Enum>
  void choice(Enum& value, Enum last) {
    value = static_cast<Enum>(byteUpTo(static_cast<std::uint8_t>(last)));
  }
  void text(std::string& value) {
    const std::size_t size = count(1);
    if (size > kMostTextBytes) return refuse("a text is longer than " + std::to_string(kMostTextBytes) + " bytes");
    value.resize(size);
    take(value.data(), size);
  }
  template <class T>
  void floatList(std::vector<T>& values) {
    static_assert(kIsFloats<T>);
    values.resize(count(sizeof(T)));
    take(values.data(), values.size() * sizeof(T));
    if (!areFinite(values.data(), values.size())) refuse("a number is not finite");
  }
  void numberList(std::vector<int>& values) {
    values.resize(count(sizeof(int)));
    take(values.data(), values.size() * sizeof(int));
  }
  template <class T>
  void list(std::vector<T>& values, std::size_t least) {
    list(values, least, [this](T& value) { fields(*this, value); });
  }
  template <class T, class Item>
  void list(std::vector<T>& values, std::size_t least, Item item) {
    values.resize(count(least));
    for (T& value : values) {
      if (failed()) return;
      item(value);
    }
  }
  template <class T, class Item>
  void maybe(std::optional<T>& value, Item item) {
    if (byteUpTo(1) != 0) item(value.emplace());
  }
  /// What is read from here on: the place of a mistake.
  void section(const char* name) { section_ = name; }

  [[nodiscard]] bool failed() const { return error_.has_value(); }
  /// Only when failed().
  [[nodiscard]] const Error& error() const { return *error_; }
  [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }
  void refuse(const std::string& reason) {
    if (!error_) error_ = errorAt(std::string(section_) + ", byte " + std::to_string(at_), reason);
  }

 private:
  template <class T>
  static bool areFinite(const T* values, std::size_t size) {
    const auto* const numbers = reinterpret_cast<const float*>(values);
    for (std::size_t i = 0; i < size * (sizeof(T) / sizeof(float)); ++i) {
      if (!std::isfinite(numbers[i])) return false;
    }
    return true;
  }
  std::uint8_t byteUpTo(std::uint8_t most) {
    std::uint8_t value = 0;
    take(&value, 1);
    if (value <= most) return value;
    refuse("expected a number from 0 to " + std::to_string(most) + ", got " + std::to_string(value));
    return 0;
  }
  /// Of items of so many bytes at least: no more than the rest of the file can hold.
  std::size_t count(std::size_t least) {
    std::uint32_t size = 0;
    take(&size, sizeof size);
    if (size <= left() / least) return size;
    refuse(std::to_string(size) + " items are more than the rest of the file can hold");
    return 0;
  }
  void take(void* to, std::size_t size) {
    if (size == 0) return;
    if (failed() || size > left()) {
      refuse("the file ends too early");
      std::memset(to, 0, size);
      return;
    }
    std::memcpy(to, bytes_.data() + at_, size);
    at_ += size;
  }

  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
  const char* section_ = "";
  std::optional<Error> error_;
};

}  // namespace sinew::gamefile
