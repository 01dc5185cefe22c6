// core/io/gltf/json.cpp: checked reading of a glTF file's JSON.

#include "core/io/gltf/json.h"

#include <cmath>

#include <nlohmann/json.hpp>

namespace sinew::gltf {
namespace {

using nlohmann::json;

/// Real files need about ten levels; extras may have more.
constexpr int kDeepestNesting = 200;
/// A value takes up to about 130 bytes once parsed.
constexpr std::size_t kMostValues = 4'000'000;
constexpr double kLargestWhole = 9007199254740992.0;  // 2^53

/// One pass over the raw text before the parser allocates anything: nesting depth and number of values.
void checkSize(std::string_view text) {
  std::size_t values = 0;
  int depth = 0;
  bool inString = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (inString) {
      if (c == '\\') ++i;
      else if (c == '"') inString = false;
      continue;
    }
    if (c == '"') inString = true;
    if (c == '[' || c == '{') ++depth;
    if (c == ']' || c == '}') --depth;
    if (c == '[' || c == '{' || c == ',' || c == ':') ++values;
    if (depth > kDeepestNesting) refuse("byte " + std::to_string(i), "JSON nested deeper than 200 levels");
    if (values > kMostValues) refuse("byte " + std::to_string(i), "more than 4 million JSON values");
  }
}

/// The parser's message without its prefix, cut to a length a person reads.
std::string shortened(std::string message) {
  if (const std::size_t end = message.find("] "); end != std::string::npos) message.erase(0, end + 2);
  constexpr std::size_t kLongest = 160;
  if (message.size() > kLongest) message = message.substr(0, kLongest) + " ...";
  for (char& c : message) {
    if (static_cast<unsigned char>(c) >= 0x80) c = '?';  // the cut may have split a character
  }
  return message;
}

}  // namespace

void refuse(std::string place, std::string reason) { throw Refusal{errorAt(std::move(place), std::move(reason))}; }

std::shared_ptr<const json> parseJson(std::string_view text) {
  checkSize(text);
  try {
    auto document = std::make_shared<json>(json::parse(text));
    if (!document->is_object()) refuse("JSON", "a glTF file must be a JSON object");
    return document;
  } catch (const json::parse_error& error) {
    refuse("byte " + std::to_string(error.byte), "not valid JSON: " + shortened(error.what()));
  } catch (const json::exception& error) {
    refuse("JSON", shortened(error.what()));
  }
}

void Field::require() const {
  if (!exists()) refuse(place_, "missing");
}

Field Field::member(const std::string& key) const {
  std::string place = place_.empty() ? key : place_ + "." + key;
  if (!exists()) return {nullptr, std::move(place)};
  if (!value_->is_object()) refuse(place_, "expected an object");
  const auto found = value_->find(key);
  return {found == value_->end() ? nullptr : &*found, std::move(place)};
}

std::vector<std::string> Field::keys() const {
  std::vector<std::string> keys;
  if (!exists()) return keys;
  if (!value_->is_object()) refuse(place_, "expected an object");
  for (const auto& [key, value] : value_->items()) keys.push_back(key);
  return keys;
}

Field Field::item(std::size_t index) const {
  assert(index < size());
  return {&(*value_)[index], place_ + "[" + std::to_string(index) + "]"};
}

std::size_t Field::size() const {
  if (!exists()) return 0;
  if (!value_->is_array()) refuse(place_, "expected an array");
  return value_->size();
}

bool Field::boolean(bool fallback) const {
  if (!exists()) return fallback;
  if (!value_->is_boolean()) refuse(place_, "expected true or false");
  return value_->get<bool>();
}

double Field::number(double fallback) const {
  if (!exists()) return fallback;
  if (!value_->is_number()) refuse(place_, "expected a number");
  const double number = value_->get<double>();
  if (!std::isfinite(number)) refuse(place_, "expected a finite number");
  return number;
}

std::string_view Field::text(std::string_view fallback) const {
  if (!exists()) return fallback;
  if (!value_->is_string()) refuse(place_, "expected a string");
  return value_->get_ref<const std::string&>();
}

std::uint64_t Field::count(std::uint64_t fallback) const {
  if (!exists()) return fallback;
  const double value = number(0.0);
  if (value < 0.0 || value > kLargestWhole || value != std::floor(value))
    refuse(place_, "expected a whole number >= 0");
  return static_cast<std::uint64_t>(value);
}

std::uint64_t Field::requiredCount() const {
  require();
  return count(0);
}

std::optional<int> Field::index(std::size_t size, std::string_view what) const {
  if (!exists()) return std::nullopt;
  const std::uint64_t value = count(0);
  if (value >= size) {
    refuse(place_,
           "there is no " + std::string(what) + " " + std::to_string(value) + "; the file has " + std::to_string(size));
  }
  return static_cast<int>(value);
}

int Field::requiredIndex(std::size_t size, std::string_view what) const {
  require();
  return *index(size, what);
}

bool Field::numbers(std::span<double> out) const {
  if (!exists()) return false;
  if (size() != out.size()) refuse(place_, "expected " + std::to_string(out.size()) + " numbers");
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = item(i).number(0.0);
  return true;
}

}  // namespace sinew::gltf
