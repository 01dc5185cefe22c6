// app/editor/possible.h: whether an action can run now and, if not, the reason that the user is shown.
#pragma once

namespace sinew::app {

/// Yes, or no with a reason: a short clause that names what is missing ("Select a muscle first"), without a full stop.
class Possible {
 public:
  /// Yes.
  constexpr Possible() = default;
  /// @param reason  used if `holds` is false; outlives everything (a literal)
  constexpr Possible(bool holds, const char* reason) : reason_(holds ? nullptr : reason) {}

  constexpr operator bool() const { return reason_ == nullptr; }  // NOLINT: implicit on purpose, it is a condition
  /// "" if it is possible.
  [[nodiscard]] constexpr const char* reason() const { return reason_ == nullptr ? "" : reason_; }
  /// The same, and one thing more; the first reason is the one that counts.
  [[nodiscard]] constexpr Possible also(bool holds, const char* reason) const {
    return *this ? Possible(holds, reason) : *this;
  }

 private:
  const char* reason_ = nullptr;
};

}  // namespace sinew::app
