// app/command/surface_options.h: options shared by verbs that make surfaces: detail, mode, clips and frames.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/command/batch.h"
#include "app/document/document.h"
#include "app/document/export_kinds.h"
#include "sinew/character/animation_clip.h"
#include "sinew/character/pose.h"
#include "sinew/geometry/result.h"

namespace CLI {
class App;
}

namespace sinew::app {

/// Overrides of the rig's settings.
struct SurfaceOptions {
  DetailOverride detail;
  std::optional<float> crease;  ///< Degrees.
  std::string mode;             ///< Empty: the rig's.
  std::string patch;
  std::vector<std::string> shapes;  ///< "NAME=W"
};

/// --depth, --detail, --tolerance, --mode, --patch, --crease and --shape. `options` must outlive the parse.
void addSurfaceOptions(CLI::App& verb, SurfaceOptions& options);

void addClipsOption(CLI::App& verb, std::vector<std::string>& files);  ///< --clips, once for each file.

/// openDocument; reports clips that are left out. Error: also if one of these files cannot be read.
[[nodiscard]] Result<Document> openWithClips(const std::filesystem::path& file, const std::vector<std::string>& clips);

void addDetailOptions(CLI::App& verb, DetailOverride& detail);  ///< --depth, --detail and --tolerance only.

/// The document's rig with the overrides, whose words have passed the parser. Error: no such shape; lists all shapes.
[[nodiscard]] Result<Rig> overridden(const Document& document, const SurfaceOptions& options);

/// Error: the rig uses a bone that the skeleton lacks. @param file  for the error
[[nodiscard]] Result<void> checkBones(const Rig& rig, const Skeleton& skeleton, const std::filesystem::path& file);

/// The clip of that name; nullopt: the first. Reports a last time past its end. Error: no such clip; lists all clips.
[[nodiscard]] Result<const AnimationClip*> clipOf(const Document& document, const std::optional<std::string>& name,
                                                  double lastTime);

/// @param clip  null: the bind pose
[[nodiscard]] Pose poseAt(const Character& character, const AnimationClip* clip, double seconds);

struct ClipFrames {
  std::size_t count = 1;            ///< Moments that the clip holds: the job's first ones.
  std::vector<std::size_t> wanted;  ///< The wanted ones among them.
  std::string left;                 ///< Frames left out, as a message; "" for none.
};

/// Leaves out frames past a clip's end, which would all show its last pose.
/// @param frames  of the job; empty: one moment  @param wanted  BatchInput::wanted
/// @param clip  null: the bind pose  @param file  named in the error
/// Error: the clip ends before the first frame.
[[nodiscard]] Result<ClipFrames> framesInClip(const std::vector<int>& frames, const BatchOptions& options,
                                              const std::vector<std::size_t>& wanted, const AnimationClip* clip,
                                              const std::filesystem::path& file);

}  // namespace sinew::app
