// app/viewport/gpu/drawn_on_card.cpp: prepared once, then posed and made for each picture.
#include "app/viewport/gpu/drawn_on_card.h"

#include <utility>

namespace sinew::app {

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
