// core/bodies/sheets/keep_sheets.h: keeps the bellies and lines of sheets up to date in a rig.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/bodies/sheets/sheet_skin.h"
#include "core/rig/mirror.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// A sheet that cannot be laid on a character.
struct UnlaidSheet {
  std::string name;
  std::string why;
};

/// Lays all sheets of a rig; muscles of its own come first. Unchanged without sheets.
/// @param unlaid  if given, the sheets without bellies
[[nodiscard]] Rig withSheets(Rig rig, const std::shared_ptr<const Character>& character,
                             std::vector<UnlaidSheet>* unlaid = nullptr);

/// Lays what has changed between two states of a document, and keeps what has not. Twins of edited sheets follow.
class SheetKeeper {
 public:
  explicit SheetKeeper(std::shared_ptr<const Character> character) : character_(std::move(character)) {}

  /// @param shown  the state before, with its sheets laid  @param plan  usable, or twins do not follow
  [[nodiscard]] Rig keep(const Rig& shown, Rig wanted, const MirrorPlan& plan);

 private:
  const SheetSkin& skinOf(const Rig& rig);

  std::shared_ptr<const Character> character_;
  std::unique_ptr<SheetSkin> skin_;  ///< Made when first needed.
  std::vector<LayerChoice> layers_;  ///< Those that it was made with.
  PatchKind patch_ = PatchKind::kPn;
};

}  // namespace sinew
