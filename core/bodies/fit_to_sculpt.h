// core/bodies/fit_to_sculpt.h: changes muscles until the skin over them looks like a sculpt of the same body.
// docs/muscles.md, Fit to a sculpt.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/bodies/motions.h"
#include "core/rig/mirror.h"
#include "sinew/character/character.h"
#include "sinew/geometry/control_mesh.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

inline constexpr float kLeastHold = 0.01f;
inline constexpr float kMostHold = 1.0f;
inline constexpr float kDefaultHold = 0.1f;
inline constexpr int kMostFitCarves = 100;

struct SculptFitOptions {
  float hold = kDefaultHold;  ///< kLeastHold: match the sculpt; kMostHold: keep the muscles.
  int carves = 0;             ///< Carves to add at most, where the sculpt is lower; 0..kMostFitCarves. A pair is one.
  bool mirror = true;         ///< Twins stay mirror images. False: each side follows the sculpt, and links are dropped.
  /// Called with the finished share, 0..1, never falling. False cancels. May be empty.
  std::function<bool(double share)> progress{};
};

inline constexpr std::string_view kFitCanceled = "cancelled";  ///< Reason of the error after it was canceled.

/// How near the skin is to the sculpt, by area, where muscles can move it and the sculpt's height is known.
struct SculptMatch {
  double explained = 0.0;  ///< 1 - (square of what is left) / (square of the sculpt's height over the bare skin).
  double rms = 0.0;        ///< Root of the mean square of what is left, fraction of H.
};

struct SculptFit {
  Rig rig;
  SculptMatch before;
  SculptMatch after;
  double covered = 0.0;     ///< Part of the skin that muscles can move, over which the sculpt lies.
  double moved = 0.0;       ///< Mean way of the muscles' centers, fraction of H.
  int muscles = 0;          ///< That were changed, twins counted.
  int carves = 0;           ///< Added, twins counted.
  std::vector<float> left;  ///< [V] sculpt minus skin at the control vertices, fraction of H; 0 where not known.
  std::vector<std::string> heldBack;  ///< Muscles that follow the sculpt less, since check() would find them.
};

/// Levenberg-Marquardt over all muscles at once: squares of what is left of the heights and of their differences along
/// edges, and a pull to the start of `hold`. Sheets are broken into strips. Territories, lines, groups, reaches and
/// shapes stay. A muscle that check() would find only after the fit is held back. Error: kFitCanceled; the sculpt does
/// not fit this body; the rig has no muscles to change, or swells not.
/// @param rig  valid  @param motions  of the rig's character  @param sculpt  in the bind pose (loadSculpt)
[[nodiscard]] Result<SculptFit> fitToSculpt(const Rig& rig, const std::shared_ptr<const Character>& character,
                                            const MirrorPlan& plan, const Motions& motions, const ControlMesh& sculpt,
                                            const SculptFitOptions& options);

}  // namespace sinew
