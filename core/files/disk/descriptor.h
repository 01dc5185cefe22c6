// core/files/disk/descriptor.h: an open file of the system, closed at the end of its scope.
#pragma once

#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace sinew {

class Descriptor {
 public:
  Descriptor() = default;
  /// @param number  as the system gave it; -1: not open
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() { close(); }

  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] bool isOpen() const { return number_ >= 0; }
  /// Another number for the same open file: locks on it last until both are closed.
  [[nodiscard]] Descriptor copy() const { return Descriptor(::fcntl(number_, F_DUPFD_CLOEXEC, 0)); }
  /// False if the system reports a late failure; errno says which.
  bool close() {
    if (number_ < 0) return true;
    return ::close(std::exchange(number_, -1)) == 0;
  }

 private:
  int number_ = -1;
};

}  // namespace sinew
