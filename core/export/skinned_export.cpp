// core/export/skinned_export.cpp: pose by pose the live surface, then weights, then the file, then how close it comes.
#include "sinew/export/skinned_export.h"

#include <algorithm>
#include <cctype>
#include <exception>
#include <new>
#include <set>

#include "core/base/at.h"
#include "core/export/candidates.h"
#include "core/export/error_meter.h"
#include "core/export/poses.h"
#include "core/export/skinned_file.h"
#include "core/export/weight_fit.h"
#include "core/io/files/atomic_file.h"
#include "sinew/smoothing/smoother.h"

namespace sinew {
namespace {

using namespace exporting;

/// What the range of motion counts beside all clips together: it holds poses that no clip may ever come near.
constexpr double kShareOfFurther = 0.25;
/// Of the height: weights that bring a vertex as near as that are not fitted.
constexpr double kNearEnough = 1e-5;

// What share of the work each stage is, about.
constexpr double kGathering = 0.2;
constexpr double kSolving = 0.5;
constexpr double kMeasuring = 0.3;

std::string lowerEnding(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

/// The stages of one export, in order.
class SkinnedExport {
 public:
  SkinnedExport(std::shared_ptr<const Character> character, const Character& moving, const Rig& rig,
                const SkinnedExportSettings& settings, const ExportProgress& progress)
      : character_(std::move(character)),
        moving_(moving),
        rig_(rig),
        settings_(settings),
        progress_(progress),
        smoother_(character_) {}

  Result<void> findWeights() {
    if (const auto prepared = smoother_.prepare(rig_); !prepared) return prepared;
    smoother_.smooth(bindPose(character_->skeleton), bind_);
    const Refinement& refinement = *bind_.refinement;
    const bool refined = settings_.mesh == ExportMesh::kRefined;
    count_ = toIndex(refined ? refinement.vertexCount : refinement.controlVertices);
    choosePoses();
    std::vector<std::vector<Share>> shares = interpolatedWeights(character_->mesh, refinement);
    for (std::size_t v = 0; v < count_; ++v) weights_.push_back(fourLargest(shares[v]));
    if (settings_.weights == ExportWeights::kTransferred) return {};
    auto candidates = weightCandidates(*character_, rig_, refinement, shares);
    if (!candidates) return candidates.error();
    refit(std::move(candidates).value());
    return {};
  }

  /// Throws gltf::Refusal.
  SkinnedFile makeFile(Source& source) const {
    return skinnedFile(source, character_->mesh, bind_, weights_, settings_);
  }

  void measure(SkinnedExportReport& report) {
    const auto height = static_cast<double>(character_->height);
    std::vector<ErrorMeter> meters(moving_.clips.size(), ErrorMeter(height));
    ErrorMeter fitted(height);
    ErrorMeter heldOut(height);
    ErrorMeter all(height);
    progress_.begin(kMeasuring);
    forEachPose([](PoseUse) { return true; },
                [&](const ExportPose& pose) {
                  std::vector<ErrorMeter*> meant{&at(meters, pose.clip)};
                  if (isOwn(pose)) meant.push_back(&all);
                  if (pose.use == PoseUse::kFitted) meant.push_back(&fitted);
                  if (pose.use == PoseUse::kHeldOut) meant.push_back(&heldOut);
                  for (ErrorMeter* meter : meant) meter->addPose();
                  for (std::size_t v = 0; v < count_; ++v) {
                    const glm::dvec3 exported = skinned(matrices_, weights_[v], glm::dvec3(bind_.positions[v]));
                    const double distance = glm::length(exported - glm::dvec3(live_.positions[v]));
                    for (ErrorMeter* meter : meant) meter->add(distance);
                  }
                });
    for (const int clip : clips_) report.clips.push_back({at(moving_.clips, clip).name, at(meters, clip).figures()});
    for (std::size_t clip = character_->clips.size(); clip < moving_.clips.size(); ++clip) {
      report.further.push_back({moving_.clips[clip].name, meters[clip].figures()});
    }
    report.allClips = all.figures();
    report.fitted = fitted.figures();
    report.heldOut = heldOut.figures();
  }

 private:
  void choosePoses() {
    const int own = static_cast<int>(character_->clips.size());
    std::vector<int> further;
    for (int clip = 0; clip < static_cast<int>(moving_.clips.size()); ++clip) {
      const bool asked = settings_.clips.empty() || std::ranges::count(settings_.clips, at(moving_.clips, clip).name);
      if (clip >= own) further.push_back(clip);
      else if (asked) clips_.push_back(clip);
    }
    poses_ = exportPoses(moving_, clips_, further);
  }

  /// Smooths the poses that are meant and calls use(pose) after each, the live surface and the matrices at hand.
  template <class Means, class Use>
  void forEachPose(Means means, Use use) {
    double done = 0.0;
    for (const ExportPose& pose : poses_) {
      progress_.tell(done++ / static_cast<double>(poses_.size()));
      if (!means(pose.use)) continue;
      const Pose moment = samplePose(character_->skeleton, at(moving_.clips, pose.clip), pose.time);
      smoother_.smooth(moment, live_);
      bindingMatrices(character_->skeleton, moment, matrices_);
      use(pose);
    }
  }

  void refit(std::vector<std::vector<int>> candidates) {
    candidates.resize(count_);
    std::vector<glm::vec3> rest = bind_.positions;
    rest.resize(count_);
    WeightFit fit(std::move(rest), std::move(candidates), weights_);
    progress_.begin(kGathering);
    forEachPose([](PoseUse use) { return use == PoseUse::kFitted; },
                [&](const ExportPose& pose) { fit.add(matrices_, live_.positions, !isOwn(pose)); });
    progress_.begin(kSolving);
    weights_ =
        fit.solve(trianglesOfFit(), furtherShare(), kNearEnough * static_cast<double>(character_->height), progress_);
  }

  [[nodiscard]] bool isOwn(const ExportPose& pose) const { return toIndex(pose.clip) < character_->clips.size(); }

  /// What a further pose counts, where a pose of a clip that is exported counts 1.
  [[nodiscard]] double furtherShare() const {
    const auto isFitted = [](const ExportPose& pose) { return pose.use == PoseUse::kFitted; };
    const auto all = std::ranges::count_if(poses_, isFitted);
    const auto own =
        std::ranges::count_if(poses_, [&](const ExportPose& pose) { return isFitted(pose) && isOwn(pose); });
    if (own == 0 || own == all) return 1.0;
    return std::min(1.0, kShareOfFurther * static_cast<double>(own) / static_cast<double>(all - own));
  }

  [[nodiscard]] std::vector<std::array<int, 3>> trianglesOfFit() const {
    if (settings_.mesh == ExportMesh::kRefined) return bind_.refinement->triangles;
    std::vector<std::array<int, 3>> triangles;
    for (const ControlTriangle& triangle : character_->mesh.triangles) triangles.push_back(triangle.vertices);
    return triangles;
  }

  std::shared_ptr<const Character> character_;
  const Character& moving_;
  const Rig& rig_;
  const SkinnedExportSettings& settings_;
  StageProgress progress_;
  Smoother smoother_;
  Surface bind_;
  std::size_t count_ = 0;  ///< Refined vertices that are exported: the first so many.
  std::vector<int> clips_;
  std::vector<ExportPose> poses_;
  std::vector<FourWeights> weights_;
  Surface live_;
  std::vector<glm::dmat4> matrices_;
};

Result<void> checkClips(const std::filesystem::path& file, const Character& character,
                        const std::vector<std::string>& asked) {
  for (const std::string& name : asked) {
    if (std::ranges::find(character.clips, name, &AnimationClip::name) != character.clips.end()) continue;
    std::string known;
    for (const AnimationClip& clip : character.clips) known += (known.empty() ? "\"" : ", \"") + clip.name + '"';
    return Error{
        file.string(), "clip \"" + name + '"',
        known.empty() ? "it has no clips" : "expected " + (character.clips.size() > 1 ? "one of " + known : known)};
  }
  return {};
}

/// Files that an export writes, the one named last.
std::vector<std::filesystem::path> filesOf(const std::filesystem::path& file) {
  if (lowerEnding(file) == ".glb") return {file};
  std::filesystem::path binary = file;
  return {binary.replace_extension(".bin"), file};
}

Result<void> checkPlaces(const Source& source, const std::filesystem::path& file) {
  std::error_code unknown;
  if (file.has_parent_path() && !std::filesystem::is_directory(file.parent_path(), unknown)) {
    return Error{file.string(), {}, "cannot be written: there is no such folder"};
  }
  for (const std::filesystem::path& place : filesOf(file)) {
    if (std::filesystem::is_directory(place, unknown)) {
      return Error{place.string(), {}, "cannot be written: it is a folder"};
    }
    if (source.reads(place)) {
      return Error{place.string(), {}, "cannot be written: the character is read from it"};
    }
  }
  return {};
}

Result<std::uint64_t> write(const PackedGltf& packed, const std::filesystem::path& file) {
  const std::vector<std::filesystem::path> files = filesOf(file);
  if (files.size() == 1) {
    const Result<std::string> bytes = glbOf(packed);
    if (!bytes) return Error{file.string(), {}, bytes.error().reason};
    if (auto written = writeFileAtomically(file, bytes.value()); !written) return written.error();
    return std::uint64_t{bytes->size()};
  }
  const std::string text = gltfOf(packed, files.front().filename().string());
  if (auto written = writeFilesAtomically({{files.front(), packed.binary}, {file, text}}); !written) {
    return written.error();
  }
  return std::uint64_t{text.size() + packed.binary.size()};
}

Result<SkinnedExportReport> exported(Source& source, SkinnedExport& work, const std::filesystem::path& file) {
  if (auto free = checkPlaces(source, file); !free) return free.error();
  if (auto found = work.findWeights(); !found) return found.error();
  SkinnedFile made = work.makeFile(source);
  SkinnedExportReport report;
  report.joints = made.joints;
  report.vertices = made.vertices;
  report.triangles = made.triangles;
  report.left = std::move(made.left);
  work.measure(report);
  const Result<std::uint64_t> bytes = write(made.packed, file);
  if (!bytes) return bytes.error();
  report.bytes = bytes.value();
  return report;
}

}  // namespace

bool isSkinnedExportName(const std::filesystem::path& file) {
  const std::string ending = lowerEnding(file);
  return ending == ".glb" || ending == ".gltf";
}

Result<SkinnedExportReport> exportSkinned(const std::filesystem::path& characterFile,
                                          const std::shared_ptr<const Character>& character, const Character& moving,
                                          const Rig& rig, const SkinnedExportSettings& settings,
                                          const std::filesystem::path& file, const ExportProgress& progress) {
  if (!isSkinnedExportName(file)) return Error{file.string(), {}, "expected a name that ends in .glb or .gltf"};
  if (auto known = checkClips(characterFile, *character, settings.clips); !known) return known.error();
  try {
    Source source(characterFile);
    SkinnedExport work(character, moving, rig, settings, progress);
    return exported(source, work, file);
  } catch (const gltf::Refusal& refusal) {
    return Error{characterFile.string(), refusal.error.place, refusal.error.reason};
  } catch (const Cancelled&) {
    return Error{file.string(), {}, std::string(kCancelled)};
  } catch (const std::bad_alloc&) {
    return Error{characterFile.string(), {}, "there is not enough memory to export it"};
  } catch (const std::exception& error) {
    return Error{characterFile.string(), {}, shortened(error.what())};
  }
}

}  // namespace sinew
