// app/ui/desktop_opener.h: files opened in the program that the desktop has for them.
#pragma once

#include <filesystem>
#include <vector>

namespace sinew::app {

/// Asks xdg-open, which may take as long as the program it starts: what becomes of it is asked for later.
class DesktopOpener {
 public:
  /// @return whether xdg-open was started; it is looked for in PATH.
  bool open(const std::filesystem::path& file);
  /// Those that nothing has opened, each once.
  [[nodiscard]] std::vector<std::filesystem::path> failed();
  /// What was asked for lately may fail yet: failed() is to be called again soon.
  [[nodiscard]] bool busy() const;

 private:
  struct Running {
    int process = 0;
    std::filesystem::path file;
    int looks = 0;
  };
  std::vector<Running> running_;
};

}  // namespace sinew::app
