// app/panels/numbers.cpp: frame times and counts over the picture.

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/panels/overlay.h"
#include "core/geometry/index_table.h"

namespace sinew::app {
namespace {

constexpr float kNumbersWidth = 214.0f;  // Design pixels, as all here.
constexpr float kFoldedWidth = 168.0f;
constexpr float kHeadWidth = 100.0f;
constexpr float kGraphHeight = 34.0f;
constexpr float kFold = 14.0f;
constexpr float kSmallWidth = 420.0f;  // A narrower or lower picture shows only the frame rate.
constexpr float kSmallHeight = 300.0f;
constexpr std::size_t kFoldedRows = 3;

std::string milliseconds(double value) {
  char text[32];
  std::snprintf(text, sizeof text, value < 10.0 ? "%.2f" : "%.1f", value);
  return text;
}

/// A name and its value. The panel takes no mouse input, so the tooltip checks the pointer itself.
void row(PanelUi& ui, const char* name, const std::string& value, const char* hint = "") {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 high{low.x + ImGui::GetContentRegionAvail().x, low.y + ImGui::GetTextLineHeight()};
  const bool over = ImGui::IsWindowHovered(ImGuiHoveredFlags_RootWindow) && ImGui::IsMouseHoveringRect(low, high);
  tooltipWhile(ui, over && hint[0] != '\0', hint);
  mutedText(name);
  ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(value.c_str()).x);
  ImGui::TextUnformatted(value.c_str());
}

constexpr double kSmoothFrame = 1000.0 / 60.0;  ///< Milliseconds; the line to stay under.

/// Frame times of the last seconds, oldest at the left; the line is at 1/60 s.
void graph(PanelUi& ui) {
  const FrameStats& stats = ui.state.session.stats;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float height = ui.px(kGraphHeight);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(corner, {corner.x + width, corner.y + height}, palette::kBackground.faded(0.7f).packed(),
                     ui.px(3));
  const double top = std::max(stats.worst(), kSmoothFrame) * 1.15;  // The line and the worst frame are always visible.
  const auto heightOf = [&](double ms) { return corner.y + height * (1.0f - static_cast<float>(ms / top)); };
  std::vector<ImVec2> points;
  for (int i = 0; i < stats.count(); ++i) {
    const float x = stats.count() > 1 ? static_cast<float>(i) / static_cast<float>(stats.count() - 1) : 1.0f;
    points.push_back({corner.x + x * width, heightOf(stats.at(i))});
  }
  list.PushClipRect(corner, {corner.x + width, corner.y + height}, true);
  const float line = heightOf(kSmoothFrame);
  list.AddLine({corner.x, line}, {corner.x + width, line}, palette::kGood.faded(0.55f).packed(), 1.0f);
  list.AddPolyline(points.data(), static_cast<int>(points.size()), palette::kAccent.packed(), ImDrawFlags_None,
                   ui.px(1.4f));
  const char* label = "16.7";
  const float letters = 0.8f * ImGui::GetFontSize();
  const float above = line - letters - 1.0f;
  const ImVec2 at{corner.x + width - 2.2f * letters, above > corner.y ? above : line + 1.0f};
  list.AddRectFilled({at.x - ui.px(2), at.y}, {corner.x + width, at.y + letters},
                     palette::kBackground.faded(0.8f).packed(), ui.px(2));
  list.AddText(ImGui::GetFont(), letters, at, palette::kGood.faded(0.9f).packed(), label);
  list.PopClipRect();
  ImGui::Dummy({width, height});
}

/// The head, which folds the rest: frame rate and frame time. @param brief  the frame rate only
void head(PanelUi& ui, bool brief) {
  const FrameStats& stats = ui.state.session.stats;
  char text[64];
  std::snprintf(text, sizeof text, "   %.0f fps", stats.framesPerSecond());
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float size = ui.px(kFold);
  drawIcon(*ImGui::GetWindowDrawList(), ui.state.view.layout.stages ? Icon::kFoldOpen : Icon::kFoldClosed,
           {at.x - ui.px(2), at.y + 0.5f * (ImGui::GetTextLineHeight() - size)}, size, palette::kMuted.packed());
  if (brief) mutedText(text);
  else row(ui, text, milliseconds(stats.now()) + " ms");
}

struct Stage {
  const char* name;
  double seconds;
  const char* hint;
};

/// The surface's stages on the processor, or its parts on the graphics card, measured by the card.
std::vector<Stage> surfaceStages(const EditorState& state) {
  StageSeconds shown = state.session.stats.stages;
  double heights = 0.0, drawn = 0.0;
  const SurfaceMakerState& maker = state.session.surfaceMaker;
  if (maker.onCard) {
    const PartSeconds parts = maker.onCardSeconds.value_or(PartSeconds{});
    const auto of = [&](SurfacePart part) { return parts[static_cast<std::size_t>(part)]; };
    shown = {of(SurfacePart::kSkin), of(SurfacePart::kPatch), of(SurfacePart::kProject), of(SurfacePart::kFolds),
             of(SurfacePart::kNormals)};
    heights = of(SurfacePart::kHeights);
    drawn = of(SurfacePart::kDrawn);
  }
  std::vector<Stage> stages{{"follow bones", shown.skin, "The file's mesh follows the bones (skin)"},
                            {"round skin", shown.patch, "The skin is curved between the file's vertices (patch)"},
                            {"raise skin", shown.project, "The skin rises over the muscles (project)"}};
  if (maker.onCard) stages.push_back({"limit heights", heights, "What the bent skin cannot carry is lowered"});
  stages.push_back({"open folds", shown.folds, "Skin that has folded over is moved back (folds)"});
  stages.push_back({"normals", shown.normals, "Directions for the light"});
  if (maker.onCard) stages.push_back({"write", drawn, "Vertices are written where they are drawn"});
  return stages;
}

double surfaceSeconds(const EditorState& state) {
  double seconds = 0.0;
  for (const Stage& stage : surfaceStages(state)) seconds += stage.seconds;
  return seconds;
}

std::vector<Stage> allStages(const EditorState& state) {
  const FrameStats& stats = state.session.stats;
  std::vector<Stage> stages{
      {"edit", stats.prepare, "Once after an edit: refinement, which muscles reach which skin (prepare)"}};
  for (const Stage& stage : surfaceStages(state)) stages.push_back(stage);
  stages.push_back({"upload", stats.upload, "The surface goes to the graphics card"});
  stages.push_back({"draw", stats.draw, "The picture is drawn"});
  stages.push_back({"interface", stats.ui, "Panels and tools"});
  return stages;
}

void stageRows(PanelUi& ui, const std::vector<Stage>& stages) {
  const FrameStats& stats = ui.state.session.stats;
  row(ui, "median, worst", milliseconds(stats.median()) + ", " + milliseconds(stats.worst()));
  graph(ui);
  for (const Stage& stage : stages) row(ui, stage.name, milliseconds(stage.seconds * 1e3), stage.hint);
}

struct Count {
  const char* name;
  std::string value;
  const char* hint = "";
};

/// @param onCard  leaves out the counts that only the processor makes
std::vector<Count> counts(const SmoothingReport& report, bool onCard) {
  std::vector<Count> rows{
      {"triangles", grouped(report.refinedTriangles)},
      {"vertices", grouped(report.refinedVertices)},
      {"depth", std::to_string(report.depth), "Every triangle of the file becomes depth x depth triangles"},
      {"muscles", grouped(report.primitives)}};
  if (onCard) return rows;
  rows.push_back({"moved", grouped(report.projected), "Vertices that muscles move (projected)"});
  rows.push_back(
      {"on muscles", grouped(report.implicitTriangles), "The file's triangles that muscles shape (implicit)"});
  rows.push_back({"at edges", grouped(report.straddlingTriangles), "... that muscles shape in part (straddling)"});
  rows.push_back({"plain skin", grouped(report.normalTriangles), "... that no muscle reaches (normal)"});
  if (report.unresolved > 0) {
    rows.push_back({"not found", grouped(report.unresolved),
                    "Vertices whose place on the muscles was not found "
                    "(unresolved): they stay on the skin"});
  }
  return rows;
}

constexpr const char* kAuto = "auto";

ImVec2 autoDepthSize(PanelUi& ui) { return {ImGui::CalcTextSize(kAuto).x + ui.px(10), ImGui::GetTextLineHeight()}; }

/// The switch beside the word depth: whether it follows the size on screen. @return its position on the screen
ImVec2 drawAutoDepth(PanelUi& ui) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 corner{at.x + ImGui::CalcTextSize("depth").x + ui.px(8), at.y};
  const ImVec2 size = autoDepthSize(ui);
  const bool on = action("view/auto-depth").checked(ui.state);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Tint back = on ? palette::kAccent.faded(0.28f) : palette::kText.faded(0.08f);
  list.AddRectFilled(corner, {corner.x + size.x, corner.y + size.y}, back.packed(), ui.px(3));
  list.AddText({corner.x + ui.px(5), corner.y}, (on ? palette::kText : palette::kMuted).packed(), kAuto);
  return corner;
}

/// The panel takes no mouse input, so the button is in the viewport behind it.
void pressAutoDepth(PanelUi& ui, const ImVec2& corner) {
  ImGui::SetCursorScreenPos(corner);
  const bool pressed = ImGui::InvisibleButton("auto-depth", autoDepthSize(ui));
  ui.widgets.note("overlay/auto-depth");
  tooltip(ui, tooltipOf(ui, action("view/auto-depth")));
  if (pressed) run(action("view/auto-depth"), ui.state);
}

/// The same for the head.
void pressHead(PanelUi& ui, const ImVec2& low, float width) {
  ImGui::SetCursorScreenPos(low);
  const bool pressed = ImGui::InvisibleButton("numbers-fold", {width, ImGui::GetTextLineHeight() + ui.px(6)});
  ui.widgets.note("overlay/fold");
  tooltip(ui, ui.state.view.layout.stages ? "Fewer numbers" : "All numbers: the time of each stage, counts");
  if (pressed) ui.state.view.layout.stages = !ui.state.view.layout.stages;
}

bool isSmall(const PanelUi& ui, const glm::vec4& viewport) {
  return viewport.z < ui.px(kSmallWidth) || viewport.w < ui.px(kSmallHeight);
}

void foldedRows(PanelUi& ui) {
  row(ui, "triangles", grouped(ui.state.live->report().refinedTriangles));
  const bool onCard = ui.state.session.surfaceMaker.onCard;
  row(ui, onCard ? "on card" : "smoothing", milliseconds(1e3 * surfaceSeconds(ui.state)) + " ms",
      onCard ? "Time to compute the surface of a frame on the graphics card"
             : "Time to compute the surface of a frame");
}

/// @return the position of the depth's switch on the screen
ImVec2 unfoldedRows(PanelUi& ui, const std::vector<Stage>& stages, const std::vector<Count>& lines) {
  stageRows(ui, stages);
  ImGui::Dummy({0.0f, ui.px(2)});
  ImVec2 depth{0.0f, 0.0f};
  for (const Count& line : lines) {
    if (std::string_view(line.name) == "depth") depth = drawAutoDepth(ui);
    row(ui, line.name, line.value, line.hint);
  }
  return depth;
}

}  // namespace

float numbersWidth(const PanelUi& ui) {
  if (!ui.state.view.layout.overlay) return 0.0f;
  if (ui.state.view.layout.stages) return ui.px(kNumbersWidth + 10.0f);
  return ui.px((isSmall(ui, ui.state.frame.viewport) ? kHeadWidth : kFoldedWidth) + 10.0f);
}

void drawNumbers(PanelUi& ui) {
  if (!ui.state.view.layout.overlay) return;
  const bool onCard = ui.state.session.surfaceMaker.onCard;
  const std::vector<Count> lines = counts(ui.state.live->report(), onCard);
  const std::vector<Stage> stages = allStages(ui.state);
  ImGui::PushFont(ui.fonts.mono);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(6), ui.px(3)});
  const float line = ImGui::GetTextLineHeightWithSpacing();
  const float all = static_cast<float>(stages.size() + 2 + lines.size()) * line + ui.px(kGraphHeight + 3 + 14 + 8);
  const glm::vec4& viewport = ui.state.frame.viewport;
  // A small picture shows only the frame rate, until it is unfolded.
  const bool headOnly = isSmall(ui, viewport) && !ui.state.view.layout.stages;
  const float few = static_cast<float>(headOnly ? 1 : kFoldedRows) * line + ui.px(headOnly ? 11 : 16);
  const float room = viewport.w - ui.px(54 + 10);
  const bool unfolded = ui.state.view.layout.stages && all <= room && ui.px(kNumbersWidth + 70) <= viewport.z;
  const float width = ui.px(unfolded ? kNumbersWidth : (headOnly ? kHeadWidth : kFoldedWidth));
  // Hidden if there is no room beside the tools.
  if (few <= room && width + ui.px(70) <= viewport.z) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(10), ui.px(8)});
    ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::kPanel.faded(0.80f));
    ImGui::SetCursorPos({viewport.z - width - ui.px(10), ui.px(54)});
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::BeginChild(
        "numbers", {width, unfolded ? all : few}, true,
        ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_AlwaysUseWindowPadding);
    head(ui, headOnly);
    ImVec2 depth{0.0f, 0.0f};
    if (unfolded) depth = unfoldedRows(ui, stages, lines);
    else if (!headOnly) foldedRows(ui);
    ImGui::EndChild();
    ui.widgets.note("overlay/numbers");
    pressHead(ui, {corner.x, corner.y + ui.px(4)}, width);
    if (unfolded) pressAutoDepth(ui, depth);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
  }
  ImGui::PopStyleVar();
  ImGui::PopFont();
}

}  // namespace sinew::app
