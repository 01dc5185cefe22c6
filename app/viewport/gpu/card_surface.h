// app/viewport/gpu/card_surface.h: surfaces of one preparation made on the graphics card, straight into the buffer that
// is drawn.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/viewport/gpu/card_pose.h"
#include "app/viewport/gpu/card_tables.h"
#include "app/viewport/gpu/stages.h"
#include "app/viewport/gpu/surface_parts.h"
#include "app/viewport/render/gl_objects.h"
#include "core/surface/finish/fold_spread.h"
#include "core/surface/preparation.h"

namespace sinew::app {

// Which surfaces the graphics card computes. docs/performance.md.

/// What holds in every pose; poseMuscles (card_pose.h) tells what only some poses ask for.
///
/// Why the whole surface is left to the processor, in the user's words, one line; nullopt: the card computes it.
/// @param bodies  of a crowd, each in a pose of its own
[[nodiscard]] std::optional<std::string> leftToProcessor(const Preparation& preparation, int bodies = 1);

// How long the card takes for each part of a surface, by its own clock.

/// Time stamps between the parts of one surface.
class PartTimers {
 public:
  PartTimers();
  void begin();
  void end(SurfacePart part);
  /// Waits for the card.
  [[nodiscard]] PartSeconds seconds() const;
  /// nullopt: the card is not done, or has not begun.
  [[nodiscard]] std::optional<PartSeconds> secondsIfDone() const;

 private:
  std::vector<GlQuery> stamps_;  ///< [kSurfaceParts + 1]
  bool begun_ = false;
};

// Work groups of a stage, in two dimensions.

inline constexpr std::uint32_t kGroupSize = 64;  ///< Invocations: local_size_x of shaders/compute/items.glsl.

/// What every card allows along an axis, and some no more.
inline constexpr std::uint32_t kMostGroupsAlong = 65'535;

struct Groups {
  std::uint32_t x = 0;
  std::uint32_t y = 1;
};

/// So many groups that each of `items` has an invocation; surplus ones have nothing to do.
/// @param most  along an axis
[[nodiscard]] constexpr Groups groupsFor(std::uint32_t items, std::uint32_t most = kMostGroupsAlong) {
  const std::uint32_t groups = (items + kGroupSize - 1) / kGroupSize;
  if (groups <= most) return {groups, 1};
  const std::uint32_t rows = (groups + most - 1) / most;
  return {(groups + rows - 1) / rows, rows};
}

/// The stages of the one pipeline (core/surface/smooth.h) as compute shaders. A preparation is uploaded once; a pose
/// is bones and placed muscles. Nothing is read back unless a caller asks. Needs a current OpenGL 4.5 context.
class CardSurface {
 public:
  struct Options {
    int bodies = 1;                               ///< Of a crowd, made together.
    std::uint32_t mostGroups = kMostGroupsAlong;  ///< Along an axis; tests force less.
  };

  /// @param programs  must outlive this.
  /// Error: leftToProcessor, or a buffer that the card does not hold.
  [[nodiscard]] static Result<CardSurface> create(const StagePrograms& programs,
                                                  std::shared_ptr<const Preparation> preparation,
                                                  const Options& options);
  [[nodiscard]] static Result<CardSurface> create(const StagePrograms& programs,
                                                  std::shared_ptr<const Preparation> preparation) {
    return create(programs, std::move(preparation), Options{});
  }

  /// The pose of one body. @return why it is left to the processor, or nullopt
  [[nodiscard]] std::optional<std::string> setPose(const Pose& pose, int body = 0);
  /// Uploads the poses and makes the surfaces of all bodies. Does not wait.
  /// @param last  tests look at what the parts up to this one have left in readSurface()
  void make(SurfacePart last = SurfacePart::kDrawn);

  /// card::Drawn, [bodies * D]; what is drawn.
  [[nodiscard]] GLuint drawnVertices() const { return of(Buffer::kDrawn).id(); }
  [[nodiscard]] const Preparation& preparation() const { return *preparation_; }
  /// Of the last body that was posed.
  [[nodiscard]] std::span<const PosedPrimitive> muscles() const { return posed_.field.primitives; }
  [[nodiscard]] const std::vector<TriangleClass>& classes() const { return posed_.field.bind->classes; }
  [[nodiscard]] std::span<const glm::mat4> matrices() const { return matrices_; }  ///< [bodies * bindings]
  /// Bytes on the card: of the preparation and of the bodies; and uploaded for each frame.
  [[nodiscard]] std::size_t tableBytes() const { return tableBytes_; }
  [[nodiscard]] std::size_t bodyBytes() const { return bodyBytes_; }
  [[nodiscard]] std::size_t poseBytes() const;

  /// Of a make() that the card has finished.
  [[nodiscard]] std::optional<PartSeconds> secondsIfDone() const { return timers_.secondsIfDone(); }

  // For tests and measurements: these wait for the card.
  [[nodiscard]] PartSeconds seconds() const { return timers_.seconds(); }
  [[nodiscard]] std::vector<card::Root> readRoots() const;      ///< [bodies * V']
  [[nodiscard]] std::vector<card::Vertex> readPatches() const;  ///< [bodies * V']
  [[nodiscard]] std::vector<card::Vertex> readSurface() const;  ///< [bodies * V']
  /// Vertices of the last make() that were left to double precision.
  [[nodiscard]] std::uint32_t readUnsure() const;
  /// Whether the bound on slopes has come to rest.
  [[nodiscard]] bool readSlopesRest() const;

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
    kRoots,  ///< In `replace` the anchors.
    kUnsure,
    kMarks,
    kHeights,
    kFiltered,
    kFolded,  ///< Later the turns of normals.
    kBends,   ///< Later normals softened at rims, then their teeth.
    kAsks,
    kWays,
    kRoundsAsked,
    kDrawn,
    kMaking
  };
  // Rounds, and their places in the buffer in which each is asked for by the one before.
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
  /// Into what is reserved.
  template <class T>
  void refill(Buffer buffer, std::span<const T> values);
  void uploadTables();
  void reserveBodies();
  [[nodiscard]] std::optional<std::string> tooLarge() const;
  void uploadPoses();
  [[nodiscard]] std::array<std::uint32_t, 4> groupsOf(int items) const;  ///< x, y, bodies.
  /// @param buffers  bound in this order
  void bind(Stage stage, std::initializer_list<Buffer> buffers) const;
  void run(Stage stage, int items, std::initializer_list<Buffer> buffers) const;
  /// As often as the rounds before asked for it.
  void runAsked(Stage stage, std::size_t offset, std::initializer_list<Buffer> buffers) const;
  /// The first round over all items, the others as asked.
  void runRound(Stage stage, bool isFirst, int items, std::size_t offset, std::initializer_list<Buffer> buffers) const;
  void runListed(Stage stage, std::initializer_list<Buffer> buffers) const;
  /// A surface that wraps the body may lie across its patch: nothing is bounded, and normals are the field's.
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
  std::vector<card::Control> bindControls_;  ///< [V] as uploaded, with morph targets.
  std::vector<float> morphedWith_;           ///< Weights of those.
};

}  // namespace sinew::app
