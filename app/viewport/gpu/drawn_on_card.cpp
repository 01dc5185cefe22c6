// app/viewport/gpu/drawn_on_card.cpp: prepared once, then posed and made for each picture.
#include "app/viewport/gpu/drawn_on_card.h"

#include <utility>

#include "core/geometry/at.h"

namespace sinew::app {

// Boxes that follow the bones.

namespace {

constexpr float kBulge = 0.02f;  ///< Of the height: how far patches may stand out of the control mesh's box.

glm::vec3 corner(const Bounds& box, unsigned i) {
  return {(i & 1u) != 0 ? box.high.x : box.low.x, (i & 2u) != 0 ? box.high.y : box.low.y,
          (i & 4u) != 0 ? box.high.z : box.low.z};
}

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
    for (unsigned c = 0; c < 8; ++c) around.add(glm::vec3(matrices[i] * glm::vec4(corner(boxes_[i], c), 1.0f)));
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
  Result<CardSurface> card = CardSurface::create(*programs, std::move(preparation));
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
