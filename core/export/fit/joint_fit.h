// core/export/fit/joint_fit.h: joints and weights that come near the live surface, and how near.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/export/fit/four_weights.h"
#include "core/export/fit/helper_motion.h"
#include "core/export/fit/line_joints.h"
#include "core/export/fit/live_surfaces.h"
#include "core/export/fit/poses.h"
#include "core/export/fit/stage_progress.h"
#include "sinew/export/skinned_export.h"

namespace sinew::exporting {

/// Joints and weights that play back, by linear blend skinning, what the live surface does.
///
/// The surface is smoothed in the poses of the exported clips and of a range of motion. Weights are fitted to it by
/// least squares (weight_fit.h): what muscles do near a joint is nearly linear in the bones' matrices, so most of it
/// needs no new joint. What is left goes to joints of muscle lines, which move exactly as lines deform (line_joints.h),
/// and to rigid ones (helper_fit.h). Every fifth pose is kept from the fit: its error tells whether the fit holds
/// beyond the poses it has seen. docs/export.md.
class JointFit {
 public:
  /// As exportSkinned(); all but `progress` must outlive this.
  JointFit(std::shared_ptr<const Character> character, const Character& moving, const Rig& rig,
           const SkinnedExportSettings& settings, const ExportProgress& progress);

  /// Error: the rig does not fit the character.
  Result<void> findWeights();
  /// Compares all poses, and finds the keys of the added joints on the way.
  void measure(SkinnedExportReport& report);

  [[nodiscard]] const Surface& bind() const { return bind_; }
  /// [vertices that are exported]
  [[nodiscard]] const std::vector<FourWeights>& weights() const { return weights_; }
  /// Those added: lines' first.
  [[nodiscard]] std::vector<HelperJoint> helpers() const;
  [[nodiscard]] const LineJoints& lines() const { return lines_; }
  /// After measure(): one for each clip that is exported, in the character's order.
  [[nodiscard]] const std::vector<HelperClip>& helperClips() const { return helperClips_; }

 private:
  void choosePoses();
  void layLines();
  void refit(std::vector<std::vector<int>> candidates);
  [[nodiscard]] std::vector<FitPose> fitPoses();
  void addHelpers(const std::vector<FitPose>& poses);
  void moveHelpers(const Pose& moment, bool isKeyed, const HelperMotion& motion);
  void keep(const ExportPose& pose);
  template <class Means, class Use>
  void forEachPose(Means means, Use use);

  [[nodiscard]] bool isOwn(const ExportPose& pose) const;
  [[nodiscard]] double furtherShare() const;
  [[nodiscard]] std::vector<std::array<int, 3>> trianglesOfFit() const;
  [[nodiscard]] std::vector<glm::vec3> restOfFit() const;
  [[nodiscard]] int firstRigid() const;

  std::shared_ptr<const Character> character_;
  const Character& moving_;
  const Rig& rig_;
  const SkinnedExportSettings& settings_;
  StageProgress progress_;
  LiveSurfaces surfaces_;
  Surface bind_;
  std::size_t count_ = 0;  ///< Refined vertices that are exported: the first so many.
  std::vector<int> clips_;
  std::vector<ExportPose> poses_;
  std::vector<FourWeights> weights_;
  LineJoints lines_;
  std::vector<HelperJoint> rigid_;
  std::vector<HelperClip> helperClips_;
  // The pose at hand.
  const Surface* live_ = nullptr;
  std::vector<glm::dmat4> matrices_;  ///< [bindings, lines' joints, rigid helpers]
  std::vector<Trs> lineLocals_;
  std::vector<Trs> rigidLocals_;
};

}  // namespace sinew::exporting
