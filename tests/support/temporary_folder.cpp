// tests/support/temporary_folder.cpp: made by mkdtemp, removed with all that is in it.
#include "tests/support/temporary_folder.h"

#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>

namespace sinew::test {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (fs::temp_directory_path() / "sinew-test-XXXXXX").string();
  if (!::mkdtemp(pattern.data())) ADD_FAILURE() << "no temporary folder";
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code error;
  fs::remove_all(path_, error);
}

fs::path TemporaryFolder::write(const std::string& name, std::string_view bytes) const {
  const fs::path file = path_ / name;
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return file;
}

}  // namespace sinew::test
