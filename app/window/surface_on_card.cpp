// app/window/surface_on_card.cpp: measures once, then follows; on any failure the processor takes over.
#include "app/window/surface_on_card.h"

#include <array>
#include <cstdio>
#include <vector>

#include "app/editor/edit.h"
#include "app/editor/export_error.h"
#include "app/editor/fit_sculpt_commands.h"
#include "app/viewport/gpu/card_figures.h"
#include "app/viewport/render/gl_objects.h"

namespace sinew::app {
namespace {

constexpr std::size_t kRounds = 3;  ///< The median counts.

std::string millisecondsText(double seconds) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f ms", 1e3 * seconds);
  return text.data();
}

/// The card cannot draw the current view.
bool needsProcessor(const EditorState& state) { return showsExportError(state) || showsLeft(state); }

}  // namespace

std::optional<std::string> SurfaceOnCard::compilePrograms() {
  if (programs_) return std::nullopt;
  Result<StagePrograms> programs = StagePrograms::create();
  if (!programs) return programs.error().text();
  programs_ = std::make_shared<const StagePrograms>(std::move(programs).value());
  return std::nullopt;
}

std::optional<std::string> SurfaceOnCard::prepare(const std::shared_ptr<const Preparation>& preparation) {
  if (card_ && &card_->preparation() == preparation.get()) return std::nullopt;
  if (refused_ == preparation) return refusedWhy_;
  card_.reset();  // Frees its memory for the next one.
  auto card = DrawnOnCard::create(programs_, preparation);
  if (card) {
    card_ = std::move(card).value();
    made_ = 0;
    return std::nullopt;
  }
  refused_ = preparation;
  refusedWhy_ = card.error().text();
  return refusedWhy_;
}

std::optional<std::string> SurfaceOnCard::make(const EditorState& state) {
  if (const auto reason = prepare(state.live->preparation())) return reason;
  const bool current = made_ == state.live->revision() && madeOf_ == state.session.documentsOpened;
  if (current) return std::nullopt;
  if (const auto reason = card_->make(state.live->pose())) return reason;
  const GLenum error = glGetError();
  if (error == GL_OUT_OF_MEMORY || error == GL_CONTEXT_LOST) {
    broken_ = error == GL_CONTEXT_LOST ? "the graphics card was reset" : "the graphics card has no memory left";
    return broken_;
  }
  made_ = state.live->revision();
  madeOf_ = state.session.documentsOpened;
  return std::nullopt;
}

/// Measures both with the shown surface, again once it has muscles. A failed measurement is tried again.
bool SurfaceOnCard::measuredFaster(EditorState& state) {
  std::string& why = state.session.surfaceMaker.why;
  const std::pair of(state.session.documentsOpened, !state.document.rig().primitives.empty());
  if (measuredOf_ != of) {
    if (const auto reason = prepare(state.live->preparation())) {
      why = *reason;
      return false;
    }
    const std::vector<Pose> frames(kRounds, state.live->pose());
    const auto figures = measureCard(*programs_, state.live->preparation(), frames, 1);
    if (!figures) {
      why = figures.error().text();
      return false;
    }
    const double card = total(figures->card), processor = figures->processor.total();
    measuredOf_ = of;
    cardIsFaster_ = card < processor;
    measurement_ =
        "measured: " + millisecondsText(card) + " on the card, " + millisecondsText(processor) + " on the processor";
  }
  why = measurement_;
  return cardIsFaster_;
}

bool SurfaceOnCard::wanted(EditorState& state) {
  SurfaceMakerState& maker = state.session.surfaceMaker;
  const SurfaceBy by = state.session.preferences.surfaceBy;
  if (!state.hasCharacter() || by == SurfaceBy::kProcessor) {
    maker.why.clear();
    return false;
  }
  if (!broken_.empty()) {
    maker.why = broken_;
    return false;
  }
  if (by == SurfaceBy::kAutomatic && isSoftwareRenderer()) {
    maker.why = "there is no graphics card";
    return false;
  }
  if (needsProcessor(state)) {
    maker.why = "only it can draw the current view";
    return false;
  }
  if (const auto reason = compilePrograms()) {
    broken_ = *reason;
    leave(state, broken_);
    return false;
  }
  if (by == SurfaceBy::kAutomatic) return measuredFaster(state);
  maker.why.clear();
  return true;
}

/// Reports each new reason once.
void SurfaceOnCard::leave(EditorState& state, const std::string& why) {
  state.session.surfaceMaker.why = why;
  const bool asked = state.session.preferences.surfaceBy == SurfaceBy::kCard || !broken_.empty();
  if (!asked || said_ == why) return;
  said_ = why;
  addMessage(state.session, broken_.empty() ? MessageKind::kNote : MessageKind::kWarning,
             "The surface is computed by the processor: " + why);
}

void SurfaceOnCard::follow(EditorState& state) {
  SurfaceMakerState& maker = state.session.surfaceMaker;
  shows_ = false;
  if (wanted(state)) {
    if (card_) maker.onCardSeconds = card_->secondsIfDone();  // Of an earlier frame: no wait.
    if (const auto reason = make(state)) leave(state, *reason);
    else shows_ = true;
  } else if (!state.hasCharacter()) {
    card_.reset();
  }
  maker.onCard = shows_;
  if (!shows_) maker.onCardSeconds.reset();
}

}  // namespace sinew::app
