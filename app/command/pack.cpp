// app/command/pack.cpp: `sinew pack`: a character with its rig as one file for games.
#include <filesystem>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

#include "app/command/console.h"
#include "app/command/surface_options.h"
#include "app/command/verbs.h"
#include "app/document/document.h"
#include "core/files/disk/atomic_file.h"
#include "core/geometry/nearest_name.h"
#include "sinew/runtime/game_file.h"

namespace sinew::app {
namespace {

struct PackOptions {
  std::filesystem::path file;
  std::filesystem::path output;
  DetailOverride detail;
};

void addPackOptions(CLI::App& verb, PackOptions& options) {
  addPath(verb, "FILE", options.file, "Rig (.rig.json) or character (.glb, .gltf, .vrm)")->required();
  addPath(verb, "-o,--output", options.output, "File to write (.sinew)")->type_name("OUT.sinew")->required();
  addDetailOptions(verb, options.detail);
}

/// Reads the bytes again, as a game will, to find what a file cannot hold.
Result<std::vector<std::byte>> packed(const Document& document, const Rig& rig, const std::filesystem::path& file) {
  if (auto attached = checkBones(rig, document.character->skeleton, file); !attached) return attached.error();
  std::vector<std::byte> bytes = gameFile(*document.character, rig);
  if (const auto read = readGameFile(bytes); !read) {
    return Error{file.string(), read.error().place, read.error().reason};
  }
  return bytes;
}

int runPack(const PackOptions& options) {
  if (lowerEnding(options.output) != ".sinew") {
    return badCommandLine("--output: expected a name that ends in .sinew, got \"" + options.output.string() + '"');
  }
  const auto document = openDocument(options.file);
  if (!document) return badInput(document.error());
  Rig rig = document->rig();
  options.detail.apply(rig.smoothing);
  const auto bytes = packed(document.value(), rig, options.file);
  if (!bytes) return badInput(bytes.error());
  const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
  if (const auto written = writeFileAtomically(options.output, text); !written) return badInput(written.error());
  return putResult(options.output.string() + ": " + std::to_string(bytes->size()) + " bytes, " +
                   std::to_string(document->character->skeleton.bones.size()) + " bones, " +
                   std::to_string(document->character->clips.size()) + " clips, " +
                   std::to_string(rig.primitives.size()) + " muscles\n");
}

}  // namespace

Verb packVerb() {
  return makeVerb<PackOptions>("pack", "Write a character and its rig as one file that a game loads", addPackOptions,
                               runPack);
}

}  // namespace sinew::app
