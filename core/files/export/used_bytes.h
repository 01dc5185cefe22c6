// core/files/export/used_bytes.h: which bytes of a view accessors refer to, and where they come to lie without the
// others.
#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "core/files/json/json.h"

namespace sinew::exporting {

/// Stretches of a view. They begin at multiples of 4 and keep their order, so that numbers stay aligned.
class UsedBytes {
 public:
  void add(std::uint64_t begin, std::uint64_t end);
  /// All that is used has been added. @param length  of the view
  void close(std::uint64_t length);

  /// After close(): in order, each behind the one before, with bytes between that nothing refers to.
  [[nodiscard]] const std::vector<std::pair<std::uint64_t, std::uint64_t>>& stretches() const { return stretches_; }
  /// Of all of them together.
  [[nodiscard]] std::uint64_t length() const;
  /// Where a byte that is used comes to lie.
  [[nodiscard]] std::uint64_t placeOf(std::uint64_t byte) const;

 private:
  std::vector<std::pair<std::uint64_t, std::uint64_t>> stretches_;  ///< Begin and end.
};

/// Calls visit(what names a bufferView, bytes from its byteOffset on, of the view) for all accessors and their sparse
/// parts; 0 bytes: it is not known how many.
void visitUses(Json& root, const std::function<void(Json& user, std::uint64_t bytes)>& visit);

}  // namespace sinew::exporting
