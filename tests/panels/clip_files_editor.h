// tests/panels/clip_files_editor.h: editor with a folder that holds a post in several files, to add clips from.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "app/editor/clip_commands.h"
#include "app/editor/open_file.h"
#include "tests/support/characters/gltf_builder.h"
#include "tests/support/editor/headless_editor.h"
#include "tests/support/temporary_folder.h"

namespace sinew::app {

/// A post in several files: still.glb has no clip, the others have.
class ClipFilesInEditor : public HeadlessEditor {
 protected:
  void SetUp() override {
    HeadlessEditor::SetUp();
    test::Post still = test::makePost();
    still.file.json.erase("animations");
    write("still.glb", still.file.glb());
    write("whole.glb", test::makePost().file.glb());
    motion("walk.glb", {"Walk", "Run"});
    motion("more.glb", {"Walk"});
  }
  void write(const std::string& name, const std::string& bytes) {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
  }
  /// Writes a file without a mesh and with one clip of each name.
  void motion(const std::string& name, const std::vector<std::string>& clips) {
    test::Post post = test::makePost();
    for (const char* list : {"meshes", "skins"}) post.file.json.erase(list);
    for (const char* member : {"mesh", "skin"}) post.file.json["nodes"][0].erase(member);
    nlohmann::ordered_json clip = post.file.json["animations"][0];
    post.file.json["animations"].clear();
    for (const std::string& each : clips) {
      clip["name"] = each;
      post.file.json["animations"].push_back(clip);
    }
    write(name, post.file.glb());
  }
  /// Writes a relative: the knee has another name, and both joints rotate. @param mesh  whether it has a mesh
  void relative(const std::string& name, bool mesh) {
    test::Post post = test::makePost();
    nlohmann::ordered_json& json = post.file.json;
    json["nodes"][2]["name"] = "crank";
    json["animations"][0]["channels"].push_back({{"sampler", 0}, {"target", {{"node", 1}, {"path", "rotation"}}}});
    if (!mesh) {
      for (const char* list : {"meshes", "skins"}) json.erase(list);
      for (const char* member : {"mesh", "skin"}) json["nodes"][0].erase(member);
    }
    write(name, post.file.glb());
  }
  void open(const std::string& name) {
    ASSERT_TRUE(openFile(state, folder_ / name));
    state.open.transport.playing = false;
    settle();
  }
  void add(const std::string& name) {
    EXPECT_EQ(addClips(state, folder_ / name), "");
    state.open.transport.playing = false;
    settle();
  }
  void drop(const std::string& name) {
    dropFile(state, folder_ / name);
    state.open.transport.playing = false;
    settle();
  }
  void act(const char* id) {
    run(action(id), state);
    settle();
  }
  [[nodiscard]] std::vector<std::string> clips() const {
    std::vector<std::string> names;
    for (const AnimationClip& clip : state.character().clips) names.push_back(clip.name);
    return names;
  }
  [[nodiscard]] std::string playing() const {
    const int clip = state.open.transport.clip;
    return clip < 0 ? "" : state.character().clips.at(static_cast<std::size_t>(clip)).name;
  }
  [[nodiscard]] const std::vector<std::string>& files() const { return state.document.rig().clipFiles; }
  void choose(int clip) { chooseClip(state.open.transport, clip, state.character()); }
  [[nodiscard]] std::ptrdiff_t messagesWith(const std::string& words) const {
    return std::ranges::count_if(state.session.messages,
                                 [&](const Message& message) { return message.text.find(words) != std::string::npos; });
  }
  using Names = std::vector<std::string>;

  const test::TemporaryFolder own_;
  const std::filesystem::path folder_ = own_.path();
};

}  // namespace sinew::app
