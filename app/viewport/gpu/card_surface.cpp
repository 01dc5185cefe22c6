// app/viewport/gpu/card_surface.cpp: buffers on the card, and the stages in order.

#include "app/viewport/gpu/card_surface.h"

#include <algorithm>
#include <utility>

#include <glm/vec2.hpp>

#include "core/surface/finish/lifted_heights.h"

namespace sinew::app {

namespace {

/// By Stage.
constexpr std::array<const char*, kStages> kFiles{
    "shaders/compute/skin.comp",         "shaders/compute/patch.comp",       "shaders/compute/patch.comp",
    "shaders/compute/replace.comp",      "shaders/compute/swell.comp",       "shaders/compute/swell_exact.comp",
    "shaders/compute/swell_shaped.comp", "shaders/compute/place.comp",       "shaders/compute/swell.comp",
    "shaders/compute/swell_shaped.comp", "shaders/compute/place.comp",       "shaders/compute/near.comp",
    "shaders/compute/crease_front.comp", "shaders/compute/crease.comp",      "shaders/compute/slope.comp",
    "shaders/compute/lower.comp",        "shaders/compute/bend.comp",        "shaders/compute/weigh.comp",
    "shaders/compute/filter.comp",       "shaders/compute/fold_start.comp",  "shaders/compute/spread_ask.comp",
    "shaders/compute/spread_move.comp",  "shaders/compute/fold_height.comp", "shaders/compute/rims.comp",
    "shaders/compute/soften.comp",       "shaders/compute/hold.comp",        "shaders/compute/teeth.comp",
    "shaders/compute/even.comp",         "shaders/compute/drawn.comp"};
static_assert(kFiles.back() != nullptr, "a file for each stage");

}  // namespace

Result<StagePrograms> StagePrograms::create() {
  if (epoxy_gl_version() < 45) return Error{"", "", "the graphics driver does not offer OpenGL 4.5: " + rendererName()};
  StagePrograms programs;
  for (std::size_t i = 0; i < kStages; ++i) {
    const auto stage = static_cast<Stage>(i);
    std::vector<const char*> defines{stage == Stage::kFlatPatch ? "REPLACE" : "SWELL"};
    if (stage >= Stage::kSoftSwell && stage <= Stage::kSoftPlace) defines.push_back("SOFT");
    Result<GlProgram> program = GlProgram::load({kFiles[i]}, defines);
    if (!program) return program.error();
    programs.programs_[i] = std::move(program).value();
  }
  return programs;
}

const char* nameOf(SurfacePart part) {
  constexpr std::array<const char*, kSurfaceParts> kNames{"skin",  "patch",   "project", "heights",
                                                          "folds", "normals", "drawn"};
  return kNames[static_cast<std::size_t>(part)];
}

namespace {

/// The limit that the lists of muscles exceed.
std::optional<std::string> tooMany(const CandidateLists& lists) {
  std::size_t muscles = 0;
  int groups = 0;
  for (std::size_t carrier = 0; carrier + 1 < lists.begin.size(); ++carrier) {
    const auto own = lists.of(static_cast<int>(carrier));
    muscles = std::max(muscles, own.size());
    for (const CarrierCandidate& one : own) groups = std::max(groups, one.slot + 1);
  }
  const auto most = [](const auto& number) { return " one place of the skin, at most " + std::to_string(number); };
  if (muscles > card::kMostCandidates) {
    return std::to_string(muscles) + " muscles reach" + most(card::kMostCandidates);
  }
  if (groups > card::kMostSlots) return std::to_string(groups) + " groups reach" + most(card::kMostSlots);
  return tooManyWays(lists, nullptr);
}

}  // namespace

std::optional<std::string> leftToProcessor(const Preparation& preparation, int bodies) {
  if (!preparation.swells() && preparation.poser->drivesMuscles()) {
    return "in replace, keys or drivers change muscles";
  }
  if (!preparation.swells() && preparation.poser->drawn().grooves > 0.0f) {
    return kSoftInReplace;
  }
  if (!preparation.swells() && preparation.poser->drivesLinks()) return "in replace, keys or drivers change links";
  const auto inPart = [](const CliqueSet& set) { return set.drawn.size() > 1; };
  if (!preparation.swells() && std::ranges::any_of(preparation.seen->cliqueSets, inPart))
    return "in replace, groups are linked in part";
  if (preparation.layered && preparation.layered->layers.hasCloth()) return "the character wears cloth";
  if (preparation.refined->creased) return "the surface has creases";
  if (bodies > 1 && !preparation.character().morphTargets.empty()) return "a crowd's bodies have morph targets";
  if (bodies > 1 && preparation.poser->drivesLinks()) return "keys or drivers change links of a crowd's bodies";
  return tooMany(*preparation.seen);
}

PartTimers::PartTimers() {
  for (std::size_t i = 0; i <= kSurfaceParts; ++i) stamps_.push_back(makeQuery(GL_TIMESTAMP));
}

void PartTimers::begin() {
  glQueryCounter(stamps_.front().id(), GL_TIMESTAMP);
  begun_ = true;
}

void PartTimers::end(SurfacePart part) {
  glQueryCounter(stamps_[static_cast<std::size_t>(part) + 1].id(), GL_TIMESTAMP);
}

PartSeconds PartTimers::seconds() const {
  std::array<GLuint64, kSurfaceParts + 1> at{};
  for (std::size_t i = 0; i <= kSurfaceParts; ++i) glGetQueryObjectui64v(stamps_[i].id(), GL_QUERY_RESULT, &at[i]);
  PartSeconds seconds{};
  for (std::size_t i = 0; i < kSurfaceParts; ++i) seconds[i] = static_cast<double>(at[i + 1] - at[i]) * 1e-9;
  return seconds;
}

std::optional<PartSeconds> PartTimers::secondsIfDone() const {
  if (!begun_) return std::nullopt;
  GLint done = GL_FALSE;
  glGetQueryObjectiv(stamps_.back().id(), GL_QUERY_RESULT_AVAILABLE, &done);
  if (done == GL_FALSE) return std::nullopt;
  return seconds();
}

namespace {

constexpr GLuint kMakingBinding = 2;  ///< shaders/compute/items.glsl.

// Places of a round's groups in kRoundsAsked.
constexpr std::size_t verticesOf(int round) { return static_cast<std::size_t>(round) * sizeof(card::Round); }
constexpr std::size_t trianglesOf(int round) { return verticesOf(round) + offsetof(card::Round, triangleGroups); }

}  // namespace

CardSurface::CardSurface(const StagePrograms& programs, std::shared_ptr<const Preparation> preparation,
                         const Options& options)
    : programs_(&programs), preparation_(std::move(preparation)), options_(options) {
  for (GlBuffer& buffer : buffers_) buffer = makeBuffer();
  uploadTables();
  reserveBodies();
}

Result<CardSurface> CardSurface::create(const StagePrograms& programs, std::shared_ptr<const Preparation> preparation,
                                        const Options& options) {
  if (const auto reason = leftToProcessor(*preparation, options.bodies)) return Error{"", "", *reason};
  CardSurface surface(programs, std::move(preparation), options);
  if (const auto reason = surface.tooLarge()) return Error{"", "", *reason};
  return surface;
}

template <class T>
void CardSurface::fill(Buffer buffer, std::span<const T> values) {
  uploadBuffer(of(buffer), values, GL_STATIC_DRAW);
  bytes_[static_cast<std::size_t>(buffer)] = values.size_bytes();
  tableBytes_ += values.size_bytes();
}

void CardSurface::reserve(Buffer buffer, std::size_t bytes) {
  const std::size_t some = std::max(bytes, std::size_t{16});
  glNamedBufferData(of(buffer).id(), static_cast<GLsizeiptr>(some), nullptr, GL_DYNAMIC_COPY);
  bytes_[static_cast<std::size_t>(buffer)] = some;
  bodyBytes_ += some;
}

template <class T>
void CardSurface::refill(Buffer buffer, std::span<const T> values) {
  if (values.empty()) return;
  glNamedBufferSubData(of(buffer).id(), 0, static_cast<GLsizeiptr>(values.size_bytes()), values.data());
}

void CardSurface::uploadTables() {
  const CardTables tables = cardTables(*preparation_);
  making_ = tables.making;
  making_.vertexGroups = groupsOf(making_.refinedVertices);
  making_.triangleGroups = groupsOf(making_.refinedTriangles);
  fill(Buffer::kInfluenceBegin, std::span(tables.influenceBegin));
  fill(Buffer::kInfluences, std::span(tables.influences));
  fill(Buffer::kBindControls, std::span(tables.controls));
  fill(Buffer::kFans, std::span(tables.fans));
  fill(Buffer::kControlTriangles, std::span(tables.controlTriangles));
  fill(Buffer::kRefined, std::span(tables.refined));
  fill(Buffer::kSeen, std::span(tables.seen));
  fill(Buffer::kCandidates, std::span(tables.candidates));
  fill(Buffer::kRings, std::span(tables.rings));
  fill(Buffer::kNeighbors, std::span(tables.neighbors));
  fill(Buffer::kCorners, std::span(tables.corners));
  fill(Buffer::kTriangles, std::span(tables.triangles));
  fill(Buffer::kDrawVertices, std::span(tables.drawVertices));
  fill(Buffer::kBoundAnchors, std::span(tables.anchors));
  fill(Buffer::kOmegas, std::span(tables.omegas));
  if (!preparation_->character().morphTargets.empty()) bindControls_ = tables.controls;
}

void CardSurface::reserveBodies() {
  const auto bodies = static_cast<std::size_t>(options_.bodies);
  const std::size_t vertices = bodies * static_cast<std::size_t>(making_.refinedVertices);
  const std::size_t triangles = bodies * static_cast<std::size_t>(making_.refinedTriangles);
  matrices_.resize(bodies * static_cast<std::size_t>(making_.bindings));
  primitives_.resize(bodies * static_cast<std::size_t>(making_.primitives));
  if (!preparation_->swells()) bones_.resize(bodies * static_cast<std::size_t>(making_.bones));
  reserve(Buffer::kBones, bones_.size() * sizeof(glm::mat4));
  reserve(Buffer::kMatrices, matrices_.size() * sizeof(glm::mat4));
  reserve(Buffer::kPrimitives, primitives_.size() * sizeof(card::Primitive));
  reserve(Buffer::kControls, bodies * static_cast<std::size_t>(making_.controlVertices) * sizeof(card::Control));
  reserve(Buffer::kPatches, vertices * sizeof(card::Vertex));
  reserve(Buffer::kLines, vertices * sizeof(card::Line));
  reserve(Buffer::kSurface, vertices * sizeof(card::Vertex));
  reserve(Buffer::kRoots, vertices * sizeof(card::Root));
  reserve(Buffer::kUnsure, sizeof(card::ListHead) + vertices * sizeof(std::uint32_t));
  reserve(Buffer::kMarks, vertices * sizeof(card::Mark));
  reserve(Buffer::kHeights, vertices * sizeof(float));
  reserve(Buffer::kFiltered, vertices * sizeof(float));
  reserve(Buffer::kFolded, vertices * sizeof(glm::vec4));
  reserve(Buffer::kBends, vertices * sizeof(glm::vec4));
  reserve(Buffer::kAsks, triangles * sizeof(float));
  reserve(Buffer::kWays, 3 * triangles * sizeof(glm::vec4));
  reserve(Buffer::kRoundsAsked, kRounds * sizeof(card::Round));
  reserve(Buffer::kDrawn, bodies * static_cast<std::size_t>(making_.drawnVertices) * sizeof(card::Drawn));
  reserve(Buffer::kMaking, sizeof(card::Making));
}

std::optional<std::string> CardSurface::tooLarge() const {
  GLint64 most = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
  if (glGetError() == GL_OUT_OF_MEMORY) return "the surface does not fit the graphics card's memory";
  const std::size_t largest = *std::ranges::max_element(bytes_);
  if (largest <= static_cast<std::size_t>(most)) return std::nullopt;
  return "the surface needs a buffer of " + std::to_string(largest >> 20) + " MiB, the graphics card allows " +
         std::to_string(most >> 20) + " MiB";
}

std::optional<std::string> CardSurface::setPose(const Pose& pose, int body) {
  if (const auto reason = poseMuscles(preparation_, pose, posed_)) return reason;
  const auto b = static_cast<std::size_t>(body);
  const auto bindings = static_cast<std::size_t>(making_.bindings);
  const auto muscles = static_cast<std::size_t>(making_.primitives);
  fillMatrices(*preparation_, pose, std::span(matrices_).subspan(b * bindings, bindings));
  fillPrimitives(*preparation_, posed_.field, std::span(primitives_).subspan(b * muscles, muscles));
  const auto bones = static_cast<std::size_t>(making_.bones);
  if (preparation_->poser->drivesLinks()) seenOf(*preparation_->seen, &posed_.field.cliqueSets, seen_);
  if (!bones_.empty()) std::ranges::copy(pose.boneInWorld, std::span(bones_).subspan(b * bones, bones).begin());
  return std::nullopt;
}

std::size_t CardSurface::poseBytes() const {
  return std::span(bones_).size_bytes() + std::span(matrices_).size_bytes() + std::span(primitives_).size_bytes() +
         std::span(seen_).size_bytes();
}

void CardSurface::uploadPoses() {
  refill(Buffer::kMatrices, std::span<const glm::mat4>(matrices_));
  refill(Buffer::kPrimitives, std::span<const card::Primitive>(primitives_));
  refill(Buffer::kBones, std::span<const glm::mat4>(bones_));
  if (!seen_.empty()) uploadBuffer(of(Buffer::kSeen), std::span<const std::int32_t>(seen_), GL_DYNAMIC_DRAW);
  refill(Buffer::kMaking, std::span<const card::Making>(&making_, 1));
  glBindBufferBase(GL_UNIFORM_BUFFER, kMakingBinding, of(Buffer::kMaking).id());
  const MorphedMesh& morphed = posed_.field.control.morphed;
  if (bindControls_.empty() || morphed.madeWith == morphedWith_) return;
  const ControlMesh& mesh = preparation_->mesh();
  for (std::size_t v = 0; v < bindControls_.size(); ++v) {
    bindControls_[v].position = glm::vec4(morphed.isMorphed ? morphed.positions[v] : mesh.positions[v], 1.0f);
    bindControls_[v].normal = glm::vec4(morphed.isMorphed ? morphed.normals[v] : mesh.normals[v], 0.0f);
  }
  refill(Buffer::kBindControls, std::span<const card::Control>(bindControls_));
  morphedWith_ = morphed.madeWith;
}

void CardSurface::bind(Stage stage, std::initializer_list<Buffer> buffers) const {
  programs_->of(stage).use();
  GLuint binding = 0;
  for (const Buffer buffer : buffers) glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding++, of(buffer).id());
}

std::array<std::uint32_t, 4> CardSurface::groupsOf(int items) const {
  const Groups groups = groupsFor(static_cast<std::uint32_t>(items), options_.mostGroups);
  return {groups.x, groups.y, static_cast<std::uint32_t>(options_.bodies), 0};
}

void CardSurface::run(Stage stage, int items, std::initializer_list<Buffer> buffers) const {
  if (items == 0) return;
  bind(stage, buffers);
  const std::array<std::uint32_t, 4> groups = groupsOf(items);
  glDispatchCompute(groups[0], groups[1], groups[2]);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
}

void CardSurface::runRound(Stage stage, bool isFirst, int items, std::size_t offset,
                           std::initializer_list<Buffer> buffers) const {
  if (isFirst) return run(stage, items, buffers);
  bind(stage, buffers);
  glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, of(Buffer::kRoundsAsked).id());
  glDispatchComputeIndirect(static_cast<GLintptr>(offset));
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
}

void CardSurface::runListed(Stage stage, std::initializer_list<Buffer> buffers) const {
  bind(stage, buffers);
  glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, of(Buffer::kUnsure).id());
  glDispatchComputeIndirect(0);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void CardSurface::findRoots() const {
  using enum Buffer;
  const int vertices = making_.refinedVertices;
  if (!preparation_->swells()) {
    return run(Stage::kReplace, vertices,
               {kRefined, kSeen, kCandidates, kPrimitives, kLines, kRoots, kOmegas, kSurface});
  }
  constexpr card::ListHead kEmpty;
  glClearNamedBufferSubData(of(Buffer::kUnsure).id(), GL_RGBA32UI, 0, sizeof kEmpty, GL_RGBA_INTEGER, GL_UNSIGNED_INT,
                            &kEmpty);
  const bool soft = std::ranges::any_of(primitives_, [](const card::Primitive& one) { return one.groove.x > 0.0f; });
  run(soft ? Stage::kSoftSwell : Stage::kSwell, vertices,
      {kRefined, kSeen, kCandidates, kPrimitives, kLines, kUnsure, kRoots});
  runListed(Stage::kSwellExact, {kRefined, kSeen, kCandidates, kPrimitives, kLines, kUnsure, kRoots});
  runListed(soft ? Stage::kSoftSwellShaped : Stage::kSwellShaped,
            {kRefined, kSeen, kCandidates, kPrimitives, kLines, kUnsure, kRoots});
  run(soft ? Stage::kSoftPlace : Stage::kPlace, vertices,
      {kRefined, kSeen, kCandidates, kPrimitives, kLines, kRoots, kSurface});
}

void CardSurface::boundHeights() const {
  const int vertices = making_.refinedVertices;
  using enum Buffer;
  run(Stage::kNear, vertices, {kRings, kNeighbors, kPatches, kSurface, kMarks});
  run(Stage::kCreaseFront, making_.controlVertices, {kFans, kControlTriangles, kControls});
  run(Stage::kCrease, vertices, {kRefined, kControls, kSurface, kMarks, kHeights});
  for (int round = kFirstSlope; round < kFirstSlope + kSlopeRounds; ++round) {
    const auto buffers = {kRings, kNeighbors, kPatches, kSurface, kMarks, kHeights, kRoundsAsked};
    programs_->of(Stage::kSlope).set("round", round);
    runRound(Stage::kSlope, round == kFirstSlope, vertices, verticesOf(round), buffers);
  }
  run(Stage::kLower, vertices, {kPatches, kSurface, kMarks, kHeights});
}

void CardSurface::filterHeights() const {
  const int vertices = making_.refinedVertices;
  using enum Buffer;
  run(Stage::kBend, vertices, {kRings, kNeighbors, kPatches, kSurface, kMarks, kFiltered, kBends});
  run(Stage::kWeigh, vertices, {kRings, kNeighbors, kMarks, kBends});
  for (int round = 0; round < LiftFilter::kRounds; ++round) {
    const Buffer before = round % 2 == 0 ? kFiltered : kHeights;
    const Buffer after = round % 2 == 0 ? kHeights : kFiltered;
    programs_->of(Stage::kFilter).set("isLast", round + 1 == LiftFilter::kRounds ? 1 : 0);
    run(Stage::kFilter, vertices, {kRings, kNeighbors, kPatches, kSurface, kMarks, before, after});
  }
}

void CardSurface::removeFolds() const {
  const int vertices = making_.refinedVertices;
  const int triangles = making_.refinedTriangles;
  using enum Buffer;
  run(Stage::kFoldStart, vertices, {kSurface, kFolded});
  const auto askers = {kTriangles, kPatches, kMarks, kFolded, kAsks, kWays};
  for (int round = kFirstSpread; round < kFirstSpread + kSpreadRounds; ++round) {
    const bool first = round == kFirstSpread;
    const auto movers = {kRings, kCorners, kPatches, kSurface, kFolded, kAsks, kWays, kRoundsAsked};
    programs_->of(Stage::kSpreadAsk).set("isFirst", first ? 1 : 0);
    programs_->of(Stage::kSpreadMove).set("round", round);
    runRound(Stage::kSpreadAsk, first, triangles, trianglesOf(round), askers);
    runRound(Stage::kSpreadMove, first, vertices, verticesOf(round), movers);
  }
  run(Stage::kFoldHeight, vertices, {kPatches, kSurface, kFolded});
}

void CardSurface::makeNormals() const {
  const int vertices = making_.refinedVertices;
  using enum Buffer;
  constexpr Buffer kTurns = kFolded;
  constexpr Buffer kTeeth = kBends;
  if (preparation_->softensRims()) {
    constexpr Buffer kRims = kBends;
    run(Stage::kRims, vertices, {kRings, kNeighbors, kPatches, kSurface, kMarks, kRims});
    run(Stage::kSoften, vertices, {kSurface, kRims});
  }
  run(Stage::kHold, vertices, {kRings, kCorners, kTriangles, kPatches, kSurface, kMarks, kTurns});
  run(Stage::kTeeth, vertices, {kRings, kNeighbors, kMarks, kTurns, kTeeth});
  run(Stage::kEven, vertices, {kRings, kNeighbors, kPatches, kSurface, kTurns, kTeeth});
}

void CardSurface::runPart(SurfacePart part) const {
  using enum Buffer;
  switch (part) {
    case SurfacePart::kSkin:
      return run(Stage::kSkin, making_.controlVertices,
                 {kInfluenceBegin, kInfluences, kBindControls, kMatrices, kControls});
    case SurfacePart::kPatch:
      if (preparation_->swells()) {
        return run(Stage::kPatch, making_.refinedVertices, {kControls, kRefined, kPatches, kLines, kSurface});
      }
      return run(Stage::kFlatPatch, making_.refinedVertices,
                 {kControls, kRefined, kPatches, kLines, kSurface, kBoundAnchors, kBones, kRoots});
    case SurfacePart::kProject:
      return findRoots();
    case SurfacePart::kHeights:
      if (wrapsBody()) return;
      boundHeights();
      if (preparation_->filtersHeights()) filterHeights();
      return;
    case SurfacePart::kFolds:
      return wrapsBody() ? void() : removeFolds();
    case SurfacePart::kNormals:
      return wrapsBody() ? void() : makeNormals();
    case SurfacePart::kDrawn:
      return run(Stage::kDrawn, making_.drawnVertices, {kDrawVertices, kSurface, kDrawn});
  }
}

void CardSurface::make(SurfacePart last) {
  uploadPoses();
  constexpr std::uint32_t kZero = 0;
  glClearNamedBufferData(of(Buffer::kRoundsAsked).id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &kZero);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
  timers_.begin();
  for (std::size_t i = 0; i < kSurfaceParts; ++i) {
    const auto part = static_cast<SurfacePart>(i);
    if (part <= last) runPart(part);
    timers_.end(part);
  }
  glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);
}

template <class T>
std::vector<T> CardSurface::read(Buffer buffer, std::size_t count) const {
  std::vector<T> values(count);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glGetNamedBufferSubData(of(buffer).id(), 0, static_cast<GLsizeiptr>(count * sizeof(T)), values.data());
  return values;
}

std::vector<card::Vertex> CardSurface::readSurface() const {
  return read<card::Vertex>(Buffer::kSurface, static_cast<std::size_t>(options_.bodies * making_.refinedVertices));
}

std::uint32_t CardSurface::readUnsure() const { return read<card::ListHead>(Buffer::kUnsure, 1).front().count; }

bool CardSurface::readSlopesRest() const {
  return read<card::Round>(Buffer::kRoundsAsked, kRounds)[kFirstSlope + kSlopeRounds].vertexGroups[0] == 0;
}

}  // namespace sinew::app
