// core/include/sinew/geometry/result.h: an outcome that is either a value or a reason a person can act on.
#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>

#include "sinew/geometry/same_version.h"

namespace sinew {

/// Why untrusted data was refused: which file, where in it, what was expected. Each part may be empty.
struct Error {
  std::string file;    ///< Path as the user gave it.
  std::string place;   ///< JSON path, accessor, byte offset, joint name ...
  std::string reason;  ///< What is wrong and what was expected.
  /// What it is about, in the interface's words: `muscle "biceps L", reach`. Instead of place where people read it who
  /// do not know the file from the inside. Empty: file and reason say it.
  std::string subject = {};

  /// "file: place: reason" on one line; empty parts are left out, control characters become spaces.
  [[nodiscard]] std::string text() const;
  /// The same for the interface: "File name: subject: reason". Without a subject it is text().
  [[nodiscard]] std::string plainText() const;
};

/// Error without a file or with a place only; the io layer adds the file.
[[nodiscard]] Error errorAt(std::string place, std::string reason, std::string subject = {});
/// What the error is about is part of something larger: `reach` of `muscle "biceps L"`.
[[nodiscard]] Error about(const std::string& whole, Error error);

/// Value or Error, for users' data. Callers' mistakes are asserts, never Results. No exception leaves core.
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
