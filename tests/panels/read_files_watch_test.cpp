// tests/panels/read_files_watch_test.cpp: referenced files that change on disk: reported once, reread on request.
#include <chrono>

#include "app/editor/open_file.h"
#include "tests/panels/clip_files_editor.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

class FileWatch : public ClipFilesInEditor {
 protected:
  /// Polls twice, as an open window does. @return messages that name the file
  std::ptrdiff_t told(const std::string& file) {
    for (int look = 0; look < 2; ++look) watchReadFiles(state);
    settle();
    return messagesWith(file);
  }
  /// Changes the modification time, since file system clocks may be coarse.
  void touch(const std::string& name) {
    fs::last_write_time(folder_ / name, fs::last_write_time(folder_ / name) + std::chrono::seconds(++touched_));
  }
  /// Writes the post as name.gltf and name.bin. @return contents of the latter
  std::string gltfInTwoFiles(const std::string& name) {
    const test::Post post = test::makePost();
    write(name + ".gltf", post.file.gltfWithBufferAt(name + ".bin"));
    write(name + ".bin", post.file.binary());
    return post.file.binary();
  }
  int touched_ = 0;
};

TEST_F(FileWatch, ChangedClipFileIsReportedOnceAndReloaded) {
  open("still.glb");
  add("walk.glb");
  add("more.glb");
  EXPECT_EQ(told("walk.glb"), 0);
  motion("walk.glb", {"Stroll", "Run"});
  touch("walk.glb");
  EXPECT_EQ(told("walk.glb"), 1);
  EXPECT_EQ(told("more.glb"), 0);
  EXPECT_EQ(clips(), (Names{"Walk", "Run", "Walk 2"})) << "nothing changes unasked";
  motion("walk.glb", {"Stroll", "Run", "Jump"});  // Saved again before the next poll.
  touch("walk.glb");
  EXPECT_EQ(told("walk.glb"), 1);
  if (!state.open.clipList.shown) act("play/clip-files");
  ASSERT_TRUE(shown("clip-files/read/0"));
  EXPECT_FALSE(shown("clip-files/read/1"));
  click("clip-files/read/0");
  EXPECT_EQ(clips(), (Names{"Stroll", "Run", "Jump", "Walk"}));
  EXPECT_EQ(steps(), 2u) << "no step";
  EXPECT_FALSE(shown("clip-files/read/0"));
  EXPECT_EQ(told("walk.glb"), 1);
  motion("walk.glb", {"Crawl"});
  touch("walk.glb");
  told("walk.glb");
  EXPECT_TRUE(state.open.clipList.changed.contains("walk.glb")) << "the next change";
  act("play/read-clip-files");
  EXPECT_EQ(clips(), (Names{"Crawl", "Walk"}));
}

TEST_F(FileWatch, ComparesContentNotDate) {
  open("still.glb");
  add("walk.glb");
  told("walk.glb");
  touch("walk.glb");
  touch("still.glb");
  EXPECT_EQ(told("walk.glb") + told("still.glb"), 0);
  motion("walk.glb", {"Stroll"});
  EXPECT_EQ(told("walk.glb"), 1);
  motion("walk.glb", {"Walk", "Run"});
  touch("walk.glb");
  told("walk.glb");
  EXPECT_TRUE(state.open.clipList.changed.empty()) << "it is as it was";
}

TEST_F(FileWatch, WatchesBufferFilesOfAGltfClipFile) {
  const std::string keys = gltfInTwoFiles("walk");
  open("still.glb");
  add("walk.gltf");
  EXPECT_EQ(told("walk.gltf"), 0);
  touch("walk.gltf");
  touch("walk.bin");
  EXPECT_EQ(told("walk.gltf"), 0) << "they hold what was read";
  std::string other = keys;
  other.back() ^= 1;
  write("walk.bin", other);
  touch("walk.bin");
  EXPECT_EQ(told("walk.gltf"), 1);
  EXPECT_TRUE(state.open.clipList.changed.contains("walk.gltf"));
  act("play/read-clip-files");
  told("walk.gltf");
  EXPECT_TRUE(state.open.clipList.changed.empty());
  write("walk.bin", keys);
  touch("walk.bin");
  told("walk.gltf");
  EXPECT_TRUE(state.open.clipList.changed.contains("walk.gltf")) << "watched on";
  write("walk.bin", other);
  touch("walk.bin");
  told("walk.gltf");
  EXPECT_TRUE(state.open.clipList.changed.empty()) << "it is as it was";
  fs::remove(folder_ / "walk.bin");
  told("walk.gltf");
  EXPECT_TRUE(state.open.clipList.changed.contains("walk.gltf"));
}

TEST_F(FileWatch, WatchesBufferFilesOfTheCharacter) {
  std::string keys = gltfInTwoFiles("hero");
  open("hero.gltf");
  add("walk.glb");
  act("play/read-clip-files");
  EXPECT_EQ(told("hero.gltf"), 0);
  keys.back() ^= 1;
  write("hero.bin", keys);
  touch("hero.bin");
  EXPECT_EQ(told("hero.gltf"), 1);
}

TEST_F(FileWatch, RemovedAndRestoredClipFileIsReported) {
  open("still.glb");
  add("walk.glb");
  told("walk.glb");
  fs::rename(folder_ / "walk.glb", folder_ / "kept.glb");
  EXPECT_EQ(told("walk.glb"), 1);
  EXPECT_EQ(clips(), (Names{"Walk", "Run"})) << "they play on";
  act("play/read-clip-files");
  EXPECT_TRUE(clips().empty());
  ASSERT_TRUE(shown("clip-files/locate/0"));
  fs::rename(folder_ / "kept.glb", folder_ / "walk.glb");
  told("walk.glb");
  ASSERT_TRUE(shown("clip-files/read/0"));
  click("clip-files/read/0");
  EXPECT_EQ(clips(), (Names{"Walk", "Run"}));
}

TEST_F(FileWatch, ChangedCharacterIsReportedOnce) {
  open("whole.glb");
  EXPECT_EQ(told("whole.glb"), 0);
  fs::copy_file(folder_ / "still.glb", folder_ / "whole.glb", fs::copy_options::overwrite_existing);
  EXPECT_EQ(told("whole.glb"), 1);
  EXPECT_EQ(messagesWith("File > Reopen"), 1);
  act("file/reopen");
  EXPECT_TRUE(clips().empty());
  EXPECT_EQ(told("whole.glb"), 0);
  fs::remove(folder_ / "whole.glb");
  EXPECT_EQ(told("whole.glb"), 1);
  EXPECT_EQ(messagesWith("no longer on disk"), 1);
}

}  // namespace
}  // namespace sinew::app
