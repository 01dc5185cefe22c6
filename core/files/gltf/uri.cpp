// core/files/gltf/uri.cpp: data: uris and the folder rule.

#include "core/files/gltf/uri.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>

#include "core/geometry/lower_case.h"

namespace sinew::gltf {
namespace {

namespace fs = std::filesystem;

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

/// nullopt where a % is not followed by two hexadecimal digits.
std::optional<std::string> percentDecoded(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      result += text[i];
      continue;
    }
    if (i + 2 >= text.size()) return std::nullopt;
    const int high = hexDigit(text[i + 1]);
    const int low = hexDigit(text[i + 2]);
    if (high < 0 || low < 0) return std::nullopt;
    result += static_cast<char>(16 * high + low);
    i += 2;
  }
  return result;
}

std::array<std::int8_t, 256> base64Values() {
  std::array<std::int8_t, 256> values;
  values.fill(-1);
  constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < kAlphabet.size(); ++i) {
    values[static_cast<unsigned char>(kAlphabet[i])] = static_cast<std::int8_t>(i);
  }
  return values;
}

/// nullopt for characters outside the alphabet or a length that cannot be; padding may be missing.
std::optional<std::vector<std::uint8_t>> base64Decoded(std::string_view text) {
  static const std::array<std::int8_t, 256> kValues = base64Values();
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  if (text.size() % 4 == 1) return std::nullopt;
  std::vector<std::uint8_t> result;
  result.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const int value = kValues[static_cast<unsigned char>(c)];
    if (value < 0) return std::nullopt;
    bits = (bits << 6 | static_cast<std::uint32_t>(value)) & 0xffffff;
    count += 6;
    if (count < 8) continue;
    count -= 8;
    result.push_back(static_cast<std::uint8_t>(bits >> count & 0xff));
  }
  return result;
}

bool hasScheme(std::string_view uri) {
  const std::size_t colon = uri.find(':');
  if (colon == std::string_view::npos || colon == 0 || std::isalpha(static_cast<unsigned char>(uri[0])) == 0)
    return false;
  return std::ranges::all_of(uri.substr(0, colon), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '+' || c == '-' || c == '.';
  });
}

}  // namespace

bool isDataUri(std::string_view uri) {
  constexpr std::string_view kScheme = "data:";
  return uri.size() >= kScheme.size() && std::ranges::equal(uri.substr(0, kScheme.size()), kScheme, {}, toLower);
}

Result<std::vector<std::uint8_t>> decodeDataUri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) return errorAt("", "a data: uri without a comma");
  const std::string_view data = uri.substr(comma + 1);
  if (uri.substr(0, comma).ends_with(";base64")) {
    std::optional<std::vector<std::uint8_t>> bytes = base64Decoded(data);
    if (!bytes) return errorAt("", "a data: uri that is not base64");
    return std::move(*bytes);
  }
  const std::optional<std::string> text = percentDecoded(data);
  if (!text) return errorAt("", "a data: uri with a bad % sequence");
  return std::vector<std::uint8_t>(text->begin(), text->end());
}

Result<fs::path> relativePathOf(std::string_view uri) {
  const auto refused = [](const char* why) {
    return errorAt("", std::string("only data: uris and files in this file's own folder may be read; this one ") + why);
  };
  const std::optional<std::string> decoded = percentDecoded(uri);
  if (!decoded) return refused("has a bad % sequence");
  if (decoded->empty()) return refused("is empty");
  if (hasScheme(uri) || hasScheme(*decoded)) return refused("has a scheme");
  for (const char c : *decoded) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) return refused("has a control character");
    if (c == '\\') return refused("has a backslash");
  }
  const fs::path path(*decoded);
  if (path.is_absolute() || path.has_root_path()) return refused("is an absolute path");
  for (const fs::path& part : path) {
    if (part == "..") return refused("has \"..\" in it");
  }
  return path;
}

std::optional<fs::path> placeInside(const fs::path& folder, const fs::path& relative) {
  std::error_code error;
  const fs::path root = fs::canonical(folder, error);
  if (error) return std::nullopt;
  const fs::path target = fs::canonical(root / relative, error);
  if (error) return std::nullopt;
  const auto [rootEnd, targetEnd] = std::ranges::mismatch(root, target);
  return rootEnd == root.end() ? std::optional(target) : std::nullopt;
}

}  // namespace sinew::gltf
