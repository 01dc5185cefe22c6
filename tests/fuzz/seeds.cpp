// tests/fuzz/seeds.cpp: the post of the tests in all its forms, and the bundled rigs.

#include "tests/fuzz/seeds.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/support/characters/compressed_post.h"
#include "tests/support/characters/gltf_builder.h"
#include "tests/support/characters/morphing_post.h"

namespace sinew::fuzz {
namespace {

namespace fs = std::filesystem;

std::string readAll(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string dracoFile(test::DracoMethod method) {
  test::Post post = test::makePost();
  useDraco(post, dracoPost(post, method));
  return post.file.glb();
}

std::vector<Seed> characters() {
  const test::Post post = test::makePost();
  return {{"post.glb", post.file.glb()},
          {"post.gltf", post.file.gltf()},
          {"morphs.glb", test::makeMorphingPost(3, 1).file.glb()},
          {"sparse_morphs.glb", test::makeMorphingPost(2, 2, test::DeltaForm::kSparse).file.glb()},
          {"quantized_morphs.glb", test::makeMorphingPost(2, 3, test::DeltaForm::kShorts).file.glb()},
          {"draco.glb", dracoFile(test::DracoMethod::kEdgebreaker)},
          {"draco_sequential.glb", dracoFile(test::DracoMethod::kSequential)},
          {"meshopt.glb", test::meshoptPost().file.glb()},
          {"meshopt_indices.glb", test::meshoptPost(true).file.glb()}};
}

std::vector<Seed> rigs() {
  std::vector<Seed> all;
  for (const auto& entry : fs::directory_iterator(fs::path(SINEW_SOURCE_DIR) / "assets")) {
    const std::string name = entry.path().filename().string();
    if (name.ends_with(".rig.json")) all.push_back({name, readAll(entry.path())});
  }
  std::ranges::sort(all, {}, &Seed::name);
  return all;
}

}  // namespace

std::vector<Seed> seedsOf(std::string_view target) { return target == "rig" ? rigs() : characters(); }

}  // namespace sinew::fuzz
