// app/bench/projections.h: work, time and agreement of the three projections on one character.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sinew/base/result.h"
#include "sinew/smoothing/smoother.h"

namespace sinew::app {

/// One mode and projection of one scene, over all its frames. Lengths are fractions of H.
struct ProjectionRow {
  std::string scene;
  SurfaceMode mode = SurfaceMode::kSwell;
  ProjectionKind projection = ProjectionKind::kNewton;
  double projected = 0.0;         ///< Vertices a root was sought for, mean of the frames.
  double fieldPerVertex = 0.0;    ///< Evaluations::field per such vertex.
  double quarticPerVertex = 0.0;  ///< Evaluations::quartic per such vertex.
  double frameSeconds = 0.0;      ///< Median of all timed frames: skin, patch and projection.
  double projectSeconds = 0.0;    ///< ... the projection alone.
  double frameRatio = 1.0;        ///< Median of time / newton's time for the same frame in the same round.
  double projectRatio = 1.0;
  double differenceMax = 0.0;    ///< Largest distance of a vertex from newton's.
  double differenceShare = 0.0;  ///< Share of the projected vertices further than 1e-4 from newton's.
  double unresolved = 0.0;       ///< Mean of the frames.
  double anchorFallbacks = 0.0;  ///< Mean of the frames.
};

struct ProjectionTrial {
  std::string scene;
  std::shared_ptr<const Character> character;
  Rig rig;  ///< Its mode and projection do not matter: all are tried.
  int frames = 8;
  int rounds = 15;
};

/// Frames are spread evenly over the first clip, or are the bind pose. In every round each frame is smoothed by all
/// three projections in turn, so that a slow moment of the machine meets them alike. @param report is called before
/// each mode. Error: the rig cannot be prepared.
[[nodiscard]] Result<std::vector<ProjectionRow>> measureProjections(
    const ProjectionTrial& trial, const std::function<void(const std::string&)>& report);

}  // namespace sinew::app
