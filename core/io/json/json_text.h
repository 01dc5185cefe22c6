// core/io/json/json_text.h: JSON text <-> a plain tree in which numbers keep the digits they were written
#pragma once
// with.

#include <string>
#include <string_view>
#include <vector>

#include "sinew/base/result.h"

namespace sinew {

/// Deeper nesting is refused, so that nothing that walks a tree can run out of stack.
inline constexpr int kMaxJsonDepth = 128;
/// More values than this are refused: a small file must not fill the memory.
inline constexpr int kMaxJsonValues = 4'000'000;

/// One JSON value. Numbers stay text, so that what is not understood is written back as it was.
struct JsonNode {
  enum class Kind { kNull, kFalse, kTrue, kNumber, kString, kArray, kObject };
  Kind kind = Kind::kNull;
  std::string key;                 ///< In an object: its key there.
  std::string text;                ///< String: its content, UTF-8. Number: its JSON token.
  std::vector<JsonNode> children;  ///< Of an array or object, in order. Keys of an object are unique.

  [[nodiscard]] const JsonNode* find(std::string_view name) const;  ///< Child by key, or nullptr.
};

[[nodiscard]] JsonNode numberNode(float value);   ///< Shortest decimal that reads back bit-equal; not finite: null.
[[nodiscard]] JsonNode numberNode(double value);  ///< Likewise.
[[nodiscard]] JsonNode numberNode(long long value);
[[nodiscard]] JsonNode stringNode(std::string text);

/// Reads strictly RFC 8259 text. Error: a number out of range or a key that stands twice is placed by its JSON path,
/// all else by byte, line and column.
[[nodiscard]] Result<JsonNode> parseJson(std::string_view text);

/// One line without spaces; or, indented, by two spaces with short lists of plain values kept on one line.
/// Invalid UTF-8 is replaced by U+FFFD.
[[nodiscard]] std::string writeJson(const JsonNode& node, bool indented);

}  // namespace sinew
