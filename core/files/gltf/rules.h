// core/files/gltf/rules.h: which members of a glTF file Sinew reads, and what each may hold.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace sinew::gltf {

inline constexpr std::uint64_t kMaxWhole = 1ULL << 53;  ///< The largest a double holds with all below it.

enum class Type {
  kAnything,
  kBoolean,
  kNumber,
  kNumbers,  ///< An array of `size` numbers.
  kText,
  kWhole,  ///< A whole number >= 0 (also written 3.0), at most kMaxWhole.
  kIndex,  ///< Index of an element of the file's list `list`.
  kComponentType,
  kShape,       ///< SCALAR, VEC3, ...
  kAttributes,  ///< A mesh primitive's: names with the indices of accessors.
  kMarker,      ///< Anything: only its presence counts.
  kObject,
  kList,
};

/// What a member may hold, and what tinygltf gets to see of it.
struct Rule {
  std::string_view key{};  ///< "" for the element of a list.
  Type type = Type::kAnything;
  std::string_view list{};          ///< kIndex
  std::span<const Rule> members{};  ///< kObject. What is not named here is taken out.
  const Rule* element = nullptr;    ///< kList
  std::uint64_t limit = 0;          ///< kNumbers: how many. kWhole: larger ones are cut to it. kList: elements.
  std::string_view beyond{};        ///< kList: the reason when there are more.
  std::string_view otherwise{};     ///< JSON written where it is absent, or wrong and not yet refused; "" for none.
  bool needed = false;              ///< Its absence is refused.
  bool whenUsed = false;            ///< Wrong ones are refused only when something uses them (Guarded::expectSound).
  bool aside = false;               ///< Checked, but not shown to tinygltf.

  [[nodiscard]] constexpr Rule required() const {
    Rule rule = *this;
    rule.needed = true;
    return rule;
  }
  [[nodiscard]] constexpr Rule orElse(std::string_view json) const {
    Rule rule = *this;
    rule.otherwise = json;
    return rule;
  }
  [[nodiscard]] constexpr Rule checkedWhenUsed(std::string_view json) const {
    Rule rule = orElse(json);
    rule.whenUsed = true;
    return rule;
  }
  [[nodiscard]] constexpr Rule atMost(std::uint64_t most, std::string_view reason) const {
    Rule rule = *this;
    rule.limit = most;
    rule.beyond = reason;
    return rule;
  }
  [[nodiscard]] constexpr Rule keptAside() const {
    Rule rule = *this;
    rule.aside = true;
    return rule;
  }
};

/// Rules of `asset`, and of all else.
[[nodiscard]] const Rule& assetRule();
[[nodiscard]] std::span<const Rule> fileRules();

}  // namespace sinew::gltf
