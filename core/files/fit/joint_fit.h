// core/files/fit/joint_fit.h: joints and weights fitted to the live surface, and their error.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "core/files/fit/helper_fit.h"
#include "core/files/fit/helper_motion.h"
#include "core/files/fit/played_surface.h"
#include "core/files/fit/poses.h"
#include "core/files/fit/weight_fit.h"
#include "core/geometry/at.h"
#include "sinew/character/character.h"
#include "sinew/character/character_pose.h"
#include "sinew/files/skinned_export.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew::exporting {

/// Up to kMostCandidates different bindings for each refined vertex: its own from interpolatedWeights(), the largest
/// first; then the bones of muscles that reach it; then those of the vertices around its control triangle, the largest
/// first; then the bones of the skin nearest in the skeleton to that of its largest weight. Error: the rig does not fit
/// the character.
[[nodiscard]] Result<std::vector<std::vector<int>>> weightCandidates(const Character& character, const Rig& rig,
                                                                     const Refinement& refinement,
                                                                     const std::vector<std::vector<Share>>& own);

/// Vertices that represent all while joints are fitted, spread evenly, so that all count alike.
struct FitSample {
  std::vector<int> vertices;                  ///< Ascending.
  std::vector<int> cell;                      ///< [all] index in `vertices` of the nearest one along edges.
  std::vector<std::array<int, 3>> triangles;  ///< Indices in `vertices`: where three cells meet.

  [[nodiscard]] bool isWhole() const { return vertices.size() == cell.size(); }
};

/// About `most` vertices along a Morton curve, at least one of each connected part; all vertices, with their own
/// triangles, if there are no more. @param triangles  between the vertices; those with a corner beyond them are skipped
[[nodiscard]] FitSample sampleVertices(std::span<const glm::vec3> rest, std::span<const std::array<int, 3>> triangles,
                                       std::size_t most);

/// [all] candidate bindings: the vertex's own, then those of its cell and the cells around it, the largest first; up to
/// kMostNear, or only its own if these are more. @param weights  [sample.vertices]  @param own  [all]
[[nodiscard]] std::vector<std::vector<int>> candidatesNear(const FitSample& sample,
                                                           std::span<const FourWeights> weights,
                                                           std::span<const FourWeights> own);

inline constexpr std::size_t kMostNear = 12;

class ErrorMeter;

/// Joints and weights that reproduce the live surface by linear blend skinning.
///
/// The surface is smoothed in the poses of the exported clips and of a range of motion. Weights are fitted to it by
/// least squares (WeightFit): muscles near a joint deform nearly linearly in the bones' matrices, so most of it needs
/// no new joint. The rest goes to joints of muscle lines, which move exactly as lines deform (LineJoints), and to rigid
/// ones (fitHelpers). For many vertices a sample represents all until the joints are found (FitSample); then every
/// vertex is fitted. Morph targets are not part of it: programs add them before skinning, as the live surface adds them
/// before muscles. Every fifth pose is held out: its error shows whether the fit generalizes. docs/export.md.
class JointFit {
 public:
  /// As exportSkinned(); all except `progress` must outlive this.
  JointFit(std::shared_ptr<const Character> character, const Character& moving, const Rig& rig,
           const SkinnedExportSettings& settings, const ExportProgress& progress);

  Result<void> findWeights();                 ///< Error: the rig does not fit the character.
  void measure(SkinnedExportReport& report);  ///< Compares all poses, and finds the keys of the added joints.
  /// After measure(): compares the clips between their keys, as a program plays them.
  void measureBetween(SkinnedExportReport& report);

  [[nodiscard]] const Surface& bind() const { return bind_; }
  [[nodiscard]] const std::vector<FourWeights>& weights() const { return weights_; }  ///< [exported vertices]
  [[nodiscard]] std::vector<HelperJoint> helpers() const;  ///< Added joints: those of lines first.
  [[nodiscard]] const LineJoints& lines() const { return lines_; }
  /// After measure(): one for each exported clip, in the character's order.
  [[nodiscard]] const std::vector<HelperClip>& helperClips() const { return helperClips_; }
  /// After measure(): the exported surface, without the distances.
  [[nodiscard]] const std::shared_ptr<PlayedSurface>& played() const { return played_; }
  /// After findWeights(); empty without exported targets.
  [[nodiscard]] const PlayedMorphs& morphs() const { return morphs_; }

 private:
  void choosePoses();
  void findMorphs();
  /// Smooths the poses with morph targets and calls use(pose, distances to the played surface).
  template <class Use>
  void forEachPlayed(std::span<const ExportPose> poses, Use use);
  void layLines();
  void fitSample(const std::vector<std::vector<int>>& candidates);
  [[nodiscard]] std::function<bool(const ExportPose&)> someFitted(std::size_t mostOwn) const;
  void addHelpers(const std::vector<FitPose>& poses);
  void weighAll(std::vector<std::vector<int>> candidates);
  void moveHelpers(const Pose& moment, bool isKeyed, const HelperMotion& motion);
  void keep(const ExportPose& pose);
  void noteLargest(std::span<const double> distances);
  [[nodiscard]] ErrorFigures figuresOf(const ErrorMeter& meter) const;
  [[nodiscard]] double measuringShare() const;
  template <class Means, class Use>
  void forEachPose(Means means, Use use);

  [[nodiscard]] bool isOwn(const ExportPose& pose) const;
  [[nodiscard]] double furtherShare() const;
  [[nodiscard]] std::vector<std::array<int, 3>> trianglesOfFit() const;
  [[nodiscard]] std::vector<glm::vec3> restOfAll() const;
  [[nodiscard]] int firstRigid() const;

  std::shared_ptr<const Character> character_;
  const Character& moving_;
  const Rig& rig_;
  const SkinnedExportSettings& settings_;
  Rig still_;  ///< The rig without weights of morph targets.
  StageProgress progress_;
  LiveSurfaces surfaces_;
  Surface bind_;
  std::size_t count_ = 0;  ///< Number of exported vertices, the first refined ones.
  std::vector<int> clips_;
  std::vector<ExportPose> poses_;
  std::vector<FourWeights> weights_;
  FitSample sample_;
  std::vector<glm::vec3> sampleRest_;
  std::vector<FourWeights> sampleWeights_;
  LineJoints lines_;
  PlayedMorphs morphs_;
  std::vector<HelperJoint> rigid_;
  std::vector<HelperClip> helperClips_;
  std::shared_ptr<PlayedSurface> played_;
  std::vector<float> largest_;  ///< [exported vertices] percent of the height.
  // The current pose.
  const Surface* live_ = nullptr;
  std::vector<glm::vec3> sampleLive_;
  std::vector<glm::dmat4> matrices_;  ///< [bindings, lines' joints, rigid helpers]
  std::vector<Trs> lineLocals_;
  std::vector<Trs> rigidLocals_;
};

/// Smooths the poses that `means` selects, without morph targets, and calls use(pose, moment) with live_ and matrices_
/// of bindings and lines' joints set.
template <class Means, class Use>
void JointFit::forEachPose(Means means, Use use) {
  std::vector<const ExportPose*> meant;
  for (const ExportPose& pose : poses_) {
    if (means(pose)) meant.push_back(&pose);
  }
  const auto momentOf = [&](std::size_t i) {
    return withoutMorphs(*character_, samplePose(*character_, at(moving_.clips, meant[i]->clip), meant[i]->time));
  };
  surfaces_.forEach(meant.size(), momentOf, [&](std::size_t i, const Pose& moment, const Surface& live) {
    progress_.tell(static_cast<double>(i) / static_cast<double>(meant.size()));
    live_ = &live;
    sampleLive_.clear();
    for (const int v : sample_.vertices) sampleLive_.push_back(at(live.positions, v));
    bindingMatrices(character_->skeleton, moment, matrices_);
    lines_.pose(moment, lineLocals_);
    for (std::size_t j = 0; j < lineLocals_.size(); ++j) {
      matrices_.push_back(helperMatrix(lines_.joints()[j], moment, lineLocals_[j]));
    }
    use(*meant[i], moment);
  });
}

}  // namespace sinew::exporting
