// app/document/file_lock.h: locks between running editors, which the system releases however a process ends.
#pragma once

#include <filesystem>

namespace sinew::app {

/// An open file with a lock on it. Closing it releases the lock.
class FileLock {
 public:
  FileLock() = default;
  explicit FileLock(int descriptor) : descriptor_(descriptor) {}
  ~FileLock();
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;

  [[nodiscard]] bool held() const { return descriptor_ >= 0; }

 private:
  int descriptor_ = -1;
};

/// Waits for whoever else has locked the folder, half a second at most: a writer needs milliseconds, and one that hangs
/// must not stop the others. Not held: it came to that, or the folder cannot be opened.
[[nodiscard]] FileLock lockFolder(const std::filesystem::path& folder);

}  // namespace sinew::app
