// app/viewport/gpu/drawn_on_card.cpp: prepared once, then posed and computed for each picture.
#include "app/viewport/gpu/drawn_on_card.h"

#include <utility>

#include "app/viewport/render/view.h"
#include "core/geometry/at.h"

namespace sinew::app {

namespace {

constexpr float kBulge = 0.02f;  ///< Patches protrude from the control mesh's bounds by less than this of the height.

}  // namespace

CarriedBounds::CarriedBounds(const Character& character)
    : boxes_(character.skeleton.bindings.size()), bulge_(kBulge * character.height) {
  for (std::size_t v = 0; v < character.mesh.positions.size(); ++v) {
    for (const Influence& influence : character.mesh.influencesOf(static_cast<int>(v))) {
      if (influence.weight > 0.0f) sinew::at(boxes_, influence.binding).add(character.mesh.positions[v]);
    }
  }
}

Bounds CarriedBounds::at(std::span<const glm::mat4> matrices, std::span<const PosedPrimitive> muscles) const {
  Bounds around;
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    if (boxes_[i].isEmpty()) continue;
    for (const glm::vec3& corner : cornersOf(boxes_[i])) around.add(glm::vec3(matrices[i] * glm::vec4(corner, 1.0f)));
  }
  for (const PosedPrimitive& muscle : muscles) {
    around.add(muscle.influence.center - muscle.influence.boundingRadius);
    around.add(muscle.influence.center + muscle.influence.boundingRadius);
  }
  around.low -= bulge_;
  around.high += bulge_;
  return around;
}

DrawnOnCard::DrawnOnCard(std::shared_ptr<const StagePrograms> programs, CardSurface card)
    : programs_(std::move(programs)), card_(std::move(card)), bounds_(card_.preparation().character()) {
  shell_.refinement = card_.preparation().refined->refinement;
}

Result<std::unique_ptr<DrawnOnCard>> DrawnOnCard::create(std::shared_ptr<const StagePrograms> programs,
                                                         std::shared_ptr<const Preparation> preparation) {
  Result<CardSurface> card = CardSurface::create(*programs, std::move(preparation), {});
  if (!card) return card.error();
  return std::unique_ptr<DrawnOnCard>(new DrawnOnCard(std::move(programs), std::move(card).value()));
}

Result<std::unique_ptr<DrawnOnCard>> DrawnOnCard::create(std::shared_ptr<const Character> character, const Rig& rig) {
  BlendingGraphMemo graphs;
  auto preparation = prepare(characterTables(std::move(character)), rig, {}, nullptr, graphs);
  if (!preparation) return preparation.error();
  Result<StagePrograms> programs = StagePrograms::create();
  if (!programs) return programs.error();
  return create(std::make_shared<const StagePrograms>(std::move(programs).value()), std::move(preparation).value());
}

std::optional<std::string> DrawnOnCard::make(const Pose& pose) {
  if (const auto reason = card_.setPose(pose)) return reason;
  card_.make();
  shell_.classes = card_.classes();
  vertices_ = {card_.drawnVertices(), bounds_.at(card_.matrices(), card_.muscles())};
  return std::nullopt;
}

}  // namespace sinew::app
