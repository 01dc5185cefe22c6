// app/viewport/gpu/card_surface.h: surfaces of one preparation computed on the graphics card.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/viewport/gpu/card_tables.h"
#include "app/viewport/gpu/surface_parts.h"
#include "app/viewport/render/gl_objects.h"
#include "core/surface/finish/fold_spread.h"
#include "core/surface/preparation.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

/// Compute shaders in the order in which they run.
enum class Stage {
  kSkin,
  kPatch,
  kFlatPatch,  ///< With the lines of `replace`.
  kReplace,
  kSwell,
  kSwellExact,
  kSwellShaped,
  kPlace,
  kSoftSwell,  ///< The same with soft grooves.
  kSoftSwellShaped,
  kSoftPlace,
  kNear,
  kCreaseFront,
  kCrease,
  kSlope,
  kLower,
  kBend,
  kWeigh,
  kFilter,
  kFoldStart,
  kSpreadAsk,
  kSpreadMove,
  kFoldHeight,
  kRims,
  kSoften,
  kHold,
  kTeeth,
  kEven,
  kDrawn
};
inline constexpr std::size_t kStages = static_cast<std::size_t>(Stage::kDrawn) + 1;

/// Compiled shaders for any number of surfaces in one context.
class StagePrograms {
 public:
  [[nodiscard]] static Result<StagePrograms> create();  ///< Error: the driver lacks OpenGL 4.5, or refuses a shader.
  [[nodiscard]] const GlProgram& of(Stage stage) const { return programs_[static_cast<std::size_t>(stage)]; }

 private:
  std::array<GlProgram, kStages> programs_;
};

/// Why surfaces of this preparation need the processor, as one line for the user; nullopt: the card computes them.
/// poseMuscles (card_tables.h) checks single poses. @param bodies  of a crowd, each in a pose of its own
[[nodiscard]] std::optional<std::string> leftToProcessor(const Preparation& preparation, int bodies = 1);

/// Time stamps between the parts of one surface.
class PartTimers {
 public:
  PartTimers();
  void begin();
  void end(SurfacePart part);
  [[nodiscard]] PartSeconds seconds() const;                       ///< Waits for the card.
  [[nodiscard]] std::optional<PartSeconds> secondsIfDone() const;  ///< nullopt: not finished or not begun.

 private:
  std::vector<GlQuery> stamps_;  ///< [kSurfaceParts + 1]
  bool begun_ = false;
};

inline constexpr std::uint32_t kGroupSize = 64;  ///< Invocations: local_size_x of shaders/compute/items.glsl.

inline constexpr std::uint32_t kMostGroupsAlong = 65'535;  ///< Along an axis, guaranteed by OpenGL.

/// Work groups of a stage in two dimensions.
struct Groups {
  std::uint32_t x = 0;
  std::uint32_t y = 1;
};

/// At least one invocation for each item; the surplus does nothing. @param most  along an axis
[[nodiscard]] constexpr Groups groupsFor(std::uint32_t items, std::uint32_t most = kMostGroupsAlong) {
  const std::uint32_t groups = (items + kGroupSize - 1) / kGroupSize;
  if (groups <= most) return {groups, 1};
  const std::uint32_t rows = (groups + most - 1) / most;
  return {(groups + rows - 1) / rows, rows};
}

/// The stages of core/surface/smooth.h as compute shaders. The preparation is uploaded once, for each pose matrices and
/// placed muscles; nothing is read back unless asked for. Needs a current OpenGL 4.5 context.
class CardSurface {
 public:
  struct Options {
    int bodies = 1;                               ///< Computed together.
    std::uint32_t mostGroups = kMostGroupsAlong;  ///< Along an axis; fewer in tests.
  };

  /// @param programs  must outlive this. Error: leftToProcessor, or a buffer is too large for the card.
  [[nodiscard]] static Result<CardSurface> create(const StagePrograms& programs,
                                                  std::shared_ptr<const Preparation> preparation,
                                                  const Options& options);
  /// Sets the pose of one body. @return why it needs the processor, or nullopt
  [[nodiscard]] std::optional<std::string> setPose(const Pose& pose, int body = 0);
  /// Uploads the poses and computes all bodies; does not wait. @param last  stops after this part
  void make(SurfacePart last = SurfacePart::kDrawn);

  /// Buffer of card::Drawn, [bodies * D].
  [[nodiscard]] GLuint drawnVertices() const { return of(Buffer::kDrawn).id(); }
  [[nodiscard]] const Preparation& preparation() const { return *preparation_; }
  /// Muscles of the last posed body.
  [[nodiscard]] std::span<const PosedPrimitive> muscles() const { return posed_.field.primitives; }
  [[nodiscard]] const std::vector<TriangleClass>& classes() const { return posed_.field.bind->classes; }
  [[nodiscard]] std::span<const glm::mat4> matrices() const { return matrices_; }  ///< [bodies * bindings]
  /// Bytes on the card for the preparation and for the bodies; bytes uploaded per frame.
  [[nodiscard]] std::size_t tableBytes() const { return tableBytes_; }
  [[nodiscard]] std::size_t bodyBytes() const { return bodyBytes_; }
  [[nodiscard]] std::size_t poseBytes() const;

  /// Times of the last make(), when finished.
  [[nodiscard]] std::optional<PartSeconds> secondsIfDone() const { return timers_.secondsIfDone(); }

  // For tests and measurements: these wait for the card.
  [[nodiscard]] PartSeconds seconds() const { return timers_.seconds(); }
  [[nodiscard]] std::vector<card::Vertex> readSurface() const;  ///< [bodies * V']
  [[nodiscard]] std::uint32_t readUnsure() const;  ///< Vertices of the last make() computed in double precision.
  [[nodiscard]] bool readSlopesRest() const;       ///< Whether the bound on slopes has converged.

 private:
  enum class Buffer {
    kInfluenceBegin,
    kInfluences,
    kBindControls,
    kFans,
    kControlTriangles,
    kRefined,
    kSeen,
    kCandidates,
    kRings,
    kNeighbors,
    kCorners,
    kTriangles,
    kDrawVertices,
    kBoundAnchors,
    kOmegas,
    kMatrices,
    kBones,
    kPrimitives,
    kControls,
    kPatches,
    kLines,
    kSurface,
    kRoots,  ///< Anchors in `replace`.
    kUnsure,
    kMarks,
    kHeights,
    kFiltered,
    kFolded,  ///< Later rotations of normals.
    kBends,   ///< Later softened normals at rims, then their teeth.
    kAsks,
    kWays,
    kRoundsAsked,
    kDrawn,
    kMaking
  };
  // Rounds and their places in kRoundsAsked, where each is requested by the one before.
  static constexpr int kSlopeRounds = 48;
  static constexpr int kSpreadRounds = FoldSpread::kMostRounds;
  static constexpr int kFirstSlope = 0;
  static constexpr int kFirstSpread = kFirstSlope + kSlopeRounds + 1;
  static constexpr int kRounds = kFirstSpread + kSpreadRounds + 1;
  static constexpr std::size_t kBuffers = static_cast<std::size_t>(Buffer::kMaking) + 1;

  CardSurface(const StagePrograms& programs, std::shared_ptr<const Preparation> preparation, const Options& options);
  [[nodiscard]] const GlBuffer& of(Buffer buffer) const { return buffers_[static_cast<std::size_t>(buffer)]; }
  template <class T>
  void fill(Buffer buffer, std::span<const T> values);
  void reserve(Buffer buffer, std::size_t bytes);
  /// Fills reserved memory.
  template <class T>
  void refill(Buffer buffer, std::span<const T> values);
  void uploadTables();
  void reserveBodies();
  [[nodiscard]] std::optional<std::string> tooLarge() const;
  void uploadPoses();
  [[nodiscard]] std::array<std::uint32_t, 4> groupsOf(int items) const;  ///< x, y, bodies.
  void bind(Stage stage, std::initializer_list<Buffer> buffers) const;
  void run(Stage stage, int items, std::initializer_list<Buffer> buffers) const;
  /// The first round over all items, the others as requested by the round before.
  void runRound(Stage stage, bool isFirst, int items, std::size_t offset, std::initializer_list<Buffer> buffers) const;
  void runListed(Stage stage, std::initializer_list<Buffer> buffers) const;
  /// Such a surface may cross its patch: heights are not bounded, and the normals are those of the field.
  [[nodiscard]] bool wrapsBody() const { return !preparation_->swells() && making_.wraps != 0; }
  void runPart(SurfacePart part) const;
  void findRoots() const;
  void boundHeights() const;
  void filterHeights() const;
  void removeFolds() const;
  void makeNormals() const;
  template <class T>
  [[nodiscard]] std::vector<T> read(Buffer buffer, std::size_t count) const;

  const StagePrograms* programs_;
  std::shared_ptr<const Preparation> preparation_;
  Options options_;
  card::Making making_;
  PartTimers timers_;
  std::array<GlBuffer, kBuffers> buffers_;
  std::array<std::size_t, kBuffers> bytes_{};
  std::size_t tableBytes_ = 0;
  std::size_t bodyBytes_ = 0;
  PosedMuscles posed_;
  std::vector<glm::mat4> bones_;             ///< [bodies * bones] in `replace`, else empty.
  std::vector<glm::mat4> matrices_;          ///< [bodies * bindings]
  std::vector<card::Primitive> primitives_;  ///< [bodies * primitives]
  std::vector<std::int32_t> seen_;           ///< Uploaded, if keys or drivers change links.
  std::vector<card::Control> bindControls_;  ///< [V] uploaded, with morph targets.
  std::vector<float> morphedWith_;           ///< Weights of the morph targets.
};

}  // namespace sinew::app
