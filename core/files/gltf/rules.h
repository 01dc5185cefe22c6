// core/files/gltf/rules.h: the members of a glTF file that are read, and their allowed values.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace sinew::gltf {

inline constexpr std::uint64_t kMaxWhole = 1ULL << 53;  ///< A double is exact up to this.

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
  kMarker,      ///< Anything: only its presence matters.
  kObject,
  kList,
};

/// Allowed values of a member, and what tinygltf sees of it.
struct Rule {
  std::string_view key{};  ///< "" for the element of a list.
  Type type = Type::kAnything;
  std::string_view list{};          ///< kIndex
  std::span<const Rule> members{};  ///< kObject. Others are removed.
  const Rule* element = nullptr;    ///< kList
  std::uint64_t limit = 0;          ///< kNumbers: how many. kWhole: larger ones become this. kList: most elements.
  std::string_view beyond{};        ///< kList: the reason for refusing more.
  std::string_view otherwise{};     ///< JSON if it is absent, or wrong and not yet refused; "" for none.
  bool needed = false;              ///< Refused if absent.
  bool whenUsed = false;            ///< Refused only when used (Guarded::expectSound).
  bool aside = false;               ///< Checked, but hidden from tinygltf.

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

[[nodiscard]] const Rule& assetRule();  ///< The rules of `asset`, and of everything else.
[[nodiscard]] std::span<const Rule> fileRules();

}  // namespace sinew::gltf
