// app/ui/data_files.h: the program's own files (shaders, assets, pages), its version, and opening files on the desktop.
#pragma once

#include <filesystem>
#include <vector>

namespace sinew::app {

/// Opens files in the desktop's programs by xdg-open, which may run as long as the program: poll failed().
class DesktopOpener {
 public:
  bool open(const std::filesystem::path& file);               ///< @return whether xdg-open was started
  [[nodiscard]] std::vector<std::filesystem::path> failed();  ///< Files that could not be opened, each once.
  [[nodiscard]] bool busy() const;  ///< A recent request may still fail: call failed() again soon.

 private:
  struct Running {
    int process = 0;
    std::filesystem::path file;
    int looks = 0;
  };
  std::vector<Running> running_;
};

/// "0.2.0 (4bbcc04d41e0)": the commit ends in "-dirty" if the tree was changed, and is "unknown" without git.
[[nodiscard]] const char* programVersion();

/// A file that ships with the program, by its path in the source tree ("shaders/surface.vert"). Searches the folder
/// named by the environment's SINEW_DATA_DIR, ../share/sinew of the executable's folder, the source tree, the
/// configured data folder, and the executable's folder. If none has it: the path in the first one, for the message.
[[nodiscard]] std::filesystem::path dataFile(const std::filesystem::path& relative);

/// Pages of the documentation: share/doc/sinew/docs of an installed program, else docs of the source tree, else "".
[[nodiscard]] std::filesystem::path pagesFolder();

}  // namespace sinew::app
