// app/panels/inspector.h: the inspector's panels, and what its parts share: the muscles and their number fields.
#pragma once

#include <cfloat>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/editor/line_commands.h"
#include "app/panels/panel_ui.h"
#include "core/geometry/at.h"
#include "sinew/rig/parameter.h"

namespace sinew::app {

// The panels.
void drawInspector(PanelUi& ui);
void drawSurfacePanel(PanelUi& ui);
void drawSmoothingPanel(PanelUi& ui);
void drawLayersPanel(PanelUi& ui);

/// The muscles that the inspector shows, with the rig as it was when drawing began.
struct Subjects {
  std::shared_ptr<const Rig> rig;
  std::vector<int> indices;  ///< Rig indices of all selected muscles, ascending.
  int active = -1;           ///< The muscle whose values are shown where they differ.
  int bone = -1;             ///< The active muscle's; -1: unattached.

  [[nodiscard]] const Primitive& shown() const { return at(rig->primitives, active); }
  [[nodiscard]] bool several() const { return indices.size() > 1; }
  /// Whether `part` gives different values for the muscles.
  template <class Part>
  [[nodiscard]] bool differ(Part part) const {
    for (const int index : indices) {
      if (!(part(at(rig->primitives, index)) == part(shown()))) return true;
    }
    return false;
  }
};

enum class Together { kAdd, kMultiply };  ///< How a drag changes values that differ; a typed number is assigned to all.

/// A number of a muscle as a field.
struct NumberField {
  std::string id;         ///< "inspector/reach"
  const char* undoLabel;  ///< The muscles follow: "Move", "Reach of".
  const char* format;
  float speed = 0.01f;     ///< Shown units per pixel.
  float least = -FLT_MAX;  ///< Shown units.
  float most = FLT_MAX;
  std::function<float(const Primitive&)> get = {};
  std::function<void(Primitive&, float)> set = {};
  std::function<float(const Primitive&)> scale = {};  ///< Shown units per unit of the rig; empty: 1.
  std::optional<float> initial = {};                  ///< Shown units; the value that Reset sets.
  Together together = Together::kAdd;
  std::string hint = {};
  float step = 0.0f;                        ///< Shown units: the steps of a drag with Ctrl.
  std::string name = {};                    ///< "Radius Y": in the history, before the values.
  std::optional<Parameter> parameter = {};  ///< None: keys and drivers cannot change it.
};

/// A drag or a typed number is one undo step for all muscles; a right click resets, copies and pastes. The caller sets
/// the item's width. Notes itself as its id.
void drawNumberField(PanelUi& ui, const Subjects& subjects, const NumberField& field);

/// A button for an action in a row.
void rowButton(PanelUi& ui, const char* text, const std::string& id, const char* actionId, float width);

/// Rows of an open menu: reset, copy, paste. All in shown units. @return the number to set, if one was chosen
[[nodiscard]] std::optional<float> numberMenu(PanelUi& ui, const char* format, float shown,
                                              std::optional<float> initial);

/// Changes all subjects, in the current gesture or as a step of its own. @param label  the muscles' names are appended
void editSubjects(PanelUi& ui, const Subjects& subjects, const char* label,
                  const std::function<void(Primitive&)>& change);

/// A title whose click folds the rows under it, which is saved with the layout.
/// @param room  left free at its right end, design pixels  @return whether it is unfolded
[[nodiscard]] bool section(PanelUi& ui, const Control& control, const char* title, float room = 0.0f);

// The parts, each in a file of its own.
void drawTwinRow(PanelUi& ui, const Subjects& subjects);
void drawShapeRows(PanelUi& ui, const Subjects& subjects);
void drawPlacementRows(PanelUi& ui, const Subjects& subjects);
void drawTerritoryRows(PanelUi& ui, const Subjects& subjects);
void drawAnimationRows(PanelUi& ui, const Subjects& subjects);  ///< Only where something is keyed or driven.
void drawSurfaceAnimation(PanelUi& ui);
void drawMorphAnimation(PanelUi& ui, int morph);  ///< @param morph  index into Rig::morphs
void drawLinkAnimation(PanelUi& ui, int link);    ///< @param link  index into Rig::links

// The inspector's rows about the lines of the selected muscles.

/// A number of a line. All in shown units.
struct LineNumber {
  Control control;  ///< Its label is also the number's name in the history.
  const char* format;
  float speed;
  float least;
  float most;
  float scale;  ///< Shown units per unit of the rig.
  float& (*of)(LineSettings&);
  const char* hint;
  std::optional<Parameter> parameter = std::nullopt;  ///< None: keys and drivers cannot change it.
  const char* word = "";                              ///< Shown in the field if several share a row.
};

struct LineRow {
  const char* label;
  std::span<const LineNumber> numbers;
};
[[nodiscard]] std::span<const LineRow> lineRows();          ///< Flex first.
[[nodiscard]] bool lineSection(PanelUi& ui, bool several);  ///< The title over the others. @return as section()
/// The number's format with its word, if that fits.
[[nodiscard]] std::string labelled(const LineNumber& number, float value, float width);

void drawLineRows(PanelUi& ui, const Subjects& subjects);  ///< Ends, length and buttons.
void drawFlexRow(PanelUi& ui, const SelectedLines& lines);
void drawLineNumbers(PanelUi& ui);                            ///< The rest of their numbers.
void drawOtherEndRow(PanelUi& ui, const Subjects& subjects);  ///< For muscles that ride one bone.

/// All rows of sheets, below name, group, twin and effect.
void drawSheetRows(PanelUi& ui);

}  // namespace sinew::app
