// app/gpu/drawn_on_card.cpp: prepared once, then posed and made for each picture.
#include "app/gpu/drawn_on_card.h"

#include <utility>

namespace sinew::app {

DrawnOnCard::DrawnOnCard(StagePrograms programs, const Preparation& preparation)
    : programs_(std::move(programs)), bounds_(preparation.character()) {
  shell_.refinement = preparation.refined->refinement;
}

Result<std::unique_ptr<DrawnOnCard>> DrawnOnCard::create(std::shared_ptr<const Character> character, const Rig& rig) {
  BlendingGraphMemo graphs;
  auto preparation = prepare(characterTables(std::move(character)), rig, {}, nullptr, graphs);
  if (!preparation) return preparation.error();
  Result<StagePrograms> programs = StagePrograms::create();
  if (!programs) return programs.error();
  std::unique_ptr<DrawnOnCard> drawn(new DrawnOnCard(std::move(programs).value(), *preparation.value()));
  Result<CardSurface> card = CardSurface::create(drawn->programs_, preparation.value());
  if (!card) return card.error();
  drawn->card_.emplace(std::move(card).value());
  return drawn;
}

std::optional<std::string> DrawnOnCard::make(const Pose& pose) {
  if (const auto reason = card_->setPose(pose)) return reason;
  card_->make();
  shell_.classes = card_->classes();
  vertices_ = {card_->drawnVertices(), bounds_.at(card_->matrices(), card_->muscles())};
  return std::nullopt;
}

}  // namespace sinew::app
