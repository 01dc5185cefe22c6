// app/panels/panel_table.cpp: all panels and their regions.

#include "app/panels/panels.h"

#include "app/editor/visibility_commands.h"
#include "app/panels/dialogs.h"
#include "app/panels/inspector.h"
#include "app/panels/overlay.h"

namespace sinew::app {
namespace {

constexpr Panel kPanels[] = {
    {"outliner", "", Region::kLeftTop, drawLeftTabs},
    {"history", "History", Region::kLeftBottom, drawHistory},
    {"inspector", "Muscle", Region::kRight, drawInspector},
    {"surface", "Surface", Region::kRight, drawSurfacePanel},
    {"smoothing", "Smoothing", Region::kRight, drawSmoothingPanel},
    {"layers", "Layers", Region::kRight, drawLayersPanel, false, hasParts},
    {"timeline", "", Region::kBottom, drawTimeline},
    {"display", "", Region::kInViewport, drawDisplayBar},
    {"toolstrip", "", Region::kInViewport, drawToolStrip},
    {"overlay", "", Region::kInViewport, drawNumbers},
    {"legend", "", Region::kInViewport, drawLegend},
    {"flex", "", Region::kInViewport, drawFlex},
    {"driven-key", "", Region::kInViewport, drawDrivenKey},
    {"check", "", Region::kInViewport, drawCheckList},
    {"muscle-set", "", Region::kInViewport, drawMuscleSet},
    {"body-parts", "", Region::kInViewport, drawBodyParts},
    {"clip-files", "", Region::kInViewport, drawClipList},
    {"reference", "", Region::kInViewport, drawReference},
    {"first-steps", "", Region::kInViewport, drawFirstSteps},
    {"viewport-menu", "", Region::kInViewport, drawViewportMenu},
    {"messages", "", Region::kInViewport, drawMessages, true},
    {"toast", "", Region::kInViewport, drawToast, true},
    {"export", "", Region::kDialog, drawExportDialog},
    {"farm", "", Region::kDialog, drawFarmDialog},
    {"pictures", "", Region::kDialog, drawPicturesDialog},
    {"dialog", "", Region::kDialog, drawFileDialog, true},
    {"locate", "", Region::kDialog, drawLocateQuestion, true},
    {"keep-muscles", "", Region::kDialog, drawKeepMusclesQuestion, true},
    {"recovery", "", Region::kDialog, drawRecoveryQuestion, true},
    {"conflict", "", Region::kDialog, drawConflictQuestion, true},
    {"unsaved", "", Region::kDialog, drawUnsavedQuestion, true},
    {"export-question", "", Region::kDialog, drawExportQuestion, true},
    {"keys", "", Region::kDialog, drawKeySheet, true},
    {"preferences", "", Region::kDialog, drawPreferences, true},
    {"palette", "", Region::kDialog, drawPalette, true},
};

}  // namespace

std::span<const Panel> panels() { return kPanels; }

}  // namespace sinew::app
