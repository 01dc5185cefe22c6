// core/include/sinew/geometry/result.h: results that are either a value or an error for people.
#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>

#include "sinew/geometry/same_version.h"

namespace sinew {

/// Why data was refused. Each part may be empty.
struct Error {
  std::string file;    ///< Path as the user gave it.
  std::string place;   ///< JSON path, accessor, byte offset, joint name ...
  std::string reason;  ///< What is wrong and what was expected.
  /// The affected thing in words of the user interface: `muscle "biceps L", reach`. Shown instead of `place`.
  std::string subject = {};

  /// "file: place: reason" on one line; empty parts are left out, control characters become spaces.
  [[nodiscard]] std::string text() const;
  /// For the user interface: "File name: subject: reason"; text() if there is no subject.
  [[nodiscard]] std::string plainText() const;
};

/// An error without file, which is added by the caller.
[[nodiscard]] Error errorAt(std::string place, std::string reason, std::string subject = {});
/// Adds the larger thing to the subject: `muscle "biceps L"` to `reach`.
[[nodiscard]] Error about(const std::string& whole, Error error);

/// Value or Error, for users' data. Mistakes of callers are asserts, never Results. No exception leaves core.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}      // NOLINT: implicit on purpose
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}  // NOLINT: implicit on purpose

  [[nodiscard]] bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  /// Only when ok().
  [[nodiscard]] const T& value() const& {
    assert(ok());
    return *std::get_if<0>(&state_);
  }
  [[nodiscard]] T& value() & {
    assert(ok());
    return *std::get_if<0>(&state_);
  }
  [[nodiscard]] T&& value() && {
    assert(ok());
    return std::move(*std::get_if<0>(&state_));
  }
  const T* operator->() const { return &value(); }

  /// Only when not ok().
  [[nodiscard]] const Error& error() const {
    assert(!ok());
    return *std::get_if<1>(&state_);
  }

 private:
  std::variant<T, Error> state_;
};

template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)), ok_(false) {}  // NOLINT: implicit on purpose

  [[nodiscard]] bool ok() const { return ok_; }
  explicit operator bool() const { return ok_; }
  [[nodiscard]] const Error& error() const {
    assert(!ok_);
    return error_;
  }

 private:
  Error error_;
  bool ok_ = true;
};

}  // namespace sinew
