// app/command/surface_options.h: what `smooth` and `render` have in common: how the surface is made, and the clip it
// moves by.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/document/document.h"
#include "app/document/export_kinds.h"
#include "sinew/character/pose.h"
#include "sinew/geometry/result.h"

namespace CLI {
class App;
}

namespace sinew::app {

/// In place of the rig's own, where given.
struct SurfaceOptions {
  DetailOverride detail;
  std::optional<float> crease;  ///< Degrees.
  std::string mode;             ///< Empty: the rig's, as for the next.
  std::string patch;
  std::vector<std::string> shapes;  ///< "NAME=W"
};

/// --depth, --detail, --tolerance, --mode, --patch, --crease and --shape. `options` must outlive the parse.
void addSurfaceOptions(CLI::App& verb, SurfaceOptions& options);

/// --clips, once for each file.
void addClipsOption(CLI::App& verb, std::vector<std::string>& files);

/// openDocument; says what of the clips is left out. Error: also one of these files that cannot be read.
[[nodiscard]] Result<Document> openWithClips(const std::filesystem::path& file, const std::vector<std::string>& clips);

/// --depth, --detail and --tolerance alone.
void addDetailOptions(CLI::App& verb, DetailOverride& detail);

/// The document's rig with what the command line says instead. The words have passed the parser.
/// Error: no such shape, and those that there are.
[[nodiscard]] Result<Rig> overridden(const Document& document, const SurfaceOptions& options);

/// The clip of that name; nullopt: the first. Says so if the last time lies past its end.
/// Error: no such clip, and those that there are.
[[nodiscard]] Result<const AnimationClip*> clipOf(const Document& document, const std::optional<std::string>& name,
                                                  double lastTime);

/// @param clip  null: the bind pose
[[nodiscard]] Pose poseAt(const Character& character, const AnimationClip* clip, double seconds);

}  // namespace sinew::app
