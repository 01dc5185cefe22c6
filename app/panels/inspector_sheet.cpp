// app/panels/inspector_sheet.cpp: the numbers, profiles and lines of the selected sheets.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "app/document/listed_muscles.h"
#include "app/document/shown_names.h"
#include "app/editor/sheet_commands.h"
#include "app/panels/curve_editor.h"
#include "app/panels/field_edit.h"
#include "app/panels/inspector.h"
#include "app/viewport/tools/sheet_stroke.h"
#include "core/geometry/at.h"
#include "core/rig/sheet_edit.h"

namespace sinew::app {
namespace {

Possible withOneStrip(const EditorState& state) {
  const int sheet = activeSheet(state.document);
  const bool one = sheet >= 0 && at(state.document.rig().sheets, sheet).width > 0.0f;
  return withSheet(state).also(one, "A sheet of several strips is as wide as its edges");
}

/// A number of a sheet. All in shown units.
struct SheetNumber {
  Control control;  ///< Its label is also the number's name in the history.
  const char* format;
  float speed;
  float least;
  float most;
  float (*of)(const MuscleSheet&);
  void (*set)(MuscleSheet&, float);
  const char* hint;
  bool whole = false;
};

constexpr float kSheetPercent = 100.0f;
constexpr float kMostSheetPercent = kSheetPercent * kMostSheetHeight;

/// The widths of strips side by side follow from their distances; a single one needs its own.
void setStrips(MuscleSheet& sheet, float count) {
  sheet.strips = static_cast<int>(std::lround(count));
  if (sheet.strips > 1) sheet.width = 0.0f;
  else if (sheet.width == 0.0f) sheet.width = std::min(1.5f * sheet.thickness, kMostSheetHeight);
}

float softness(const MuscleSheet& sheet) {
  if (sheet.across.empty()) return 0.0f;
  return kSheetPercent * (1.0f - 0.5f * (sheet.across.front().y + sheet.across.back().y));
}

/// Lowers both ends of the profile across; where it has none of its own, it gets them.
void setSoftness(MuscleSheet& sheet, float percent) {
  const float end = 1.0f - percent / kSheetPercent;
  if (sheet.across.size() < 2) sheet.across = MuscleSheet{}.across;
  sheet.across.front().y = sheet.across.back().y = end;
}

const Control kSheetSection{"inspector/section/sheet", "Section Sheet", "strips bellies crest thickness", withSheet};
const Control kProfiles{"inspector/section/profiles", "Section Profiles", "curves across along height", withSheet};
const Control kProfileAcross{"inspector/sheet/across", "Across", "profile curve height strips", withSheet,
                             kProfiles.id};
const Control kProfileAlong{"inspector/sheet/along", "Along", "profile curve height fibres fibers", withSheet,
                            kProfiles.id};
const Control kOnLines{"inspector/sheet/on-lines", "On lines", "of the sheet muscle line flex stretch", withSheet};
const Control kMoreOfSheet{"inspector/sheet/more", "More", "of the sheet sunk reach spacing", withSheet};

const std::array kSheetNumbers{
    SheetNumber{
        Control("inspector/sheet/strips", "Strips", "of the sheet count side by side", withSheet, kSheetSection.id),
        "%.0f", 0.05f, 1.0f, static_cast<float>(kMostStrips),
        [](const MuscleSheet& s) { return static_cast<float>(s.strips); }, setStrips,
        "Strips side by side. Three are even; more follow the edges more closely.", true},
    SheetNumber{Control("inspector/sheet/bellies", "Bellies", "of a strip count segments", withSheet, kSheetSection.id),
                "%.0f", 0.05f, 1.0f, static_cast<float>(kMostStripBellies),
                [](const MuscleSheet& s) { return static_cast<float>(s.bellies); },
                [](MuscleSheet& s, float value) { s.bellies = static_cast<int>(std::lround(value)); },
                "Bellies along each strip: about three where the body is flat, four where it bends.", true},
    SheetNumber{
        Control("inspector/sheet/crest", "Crest", "of the sheet height rise bulge", withSheet, kSheetSection.id),
        "%.2f %%", 0.02f, -kMostSheetPercent, kMostSheetPercent,
        [](const MuscleSheet& s) { return kSheetPercent * s.crest; },
        [](MuscleSheet& s, float value) { s.crest = value / kSheetPercent; },
        "How high the sheet stands out of the skin where both profiles are 1, in per cent of the height."},
    SheetNumber{Control("inspector/sheet/thickness", "Thickness", "of the sheet depth half height", withSheet,
                        kSheetSection.id),
                "%.2f %%", 0.02f, kSheetPercent * 1e-4f, kMostSheetPercent,
                [](const MuscleSheet& s) { return kSheetPercent * s.thickness; },
                [](MuscleSheet& s, float value) { s.thickness = value / kSheetPercent; },
                "Half height of its bellies, in per cent of the height: how deep it reaches under the skin."},
    SheetNumber{
        Control("inspector/sheet/soft", "Soft edges", "of the sheet sides fade rim", withSheet, kSheetSection.id),
        "%.0f %%", 0.5f, 0.0f, kSheetPercent, softness, setSoftness,
        "How far its sides sink: at 0 % the outer strips stand as high as the middle, at 100 % they are as "
        "deep as its ends."}};

const SheetNumber kSheetWidth{Control("inspector/sheet/width", "Width", "of the strip", withOneStrip, kSheetSection.id),
                              "%.2f %%",
                              0.02f,
                              kSheetPercent * 1e-4f,
                              kMostSheetPercent,
                              [](const MuscleSheet& s) { return kSheetPercent * s.width; },
                              [](MuscleSheet& s, float value) { s.width = value / kSheetPercent; },
                              "Half width of the strip, in per cent of the height."};

const std::array kFurtherNumbers{
    SheetNumber{
        Control("inspector/sheet/sunk", "Sunk", "of the sheet ends depth under skin", withSheet, kMoreOfSheet.id),
        "%.2f %%", 0.02f, -kMostSheetPercent, kMostSheetPercent,
        [](const MuscleSheet& s) { return kSheetPercent * s.sunk; },
        [](MuscleSheet& s, float value) { s.sunk = value / kSheetPercent; },
        "Its height where a profile is 0, in per cent of the height: below the skin, ends leave no rim."},
    SheetNumber{Control("inspector/sheet/reach", "Reach", "of the sheet influence falloff softness", withSheet,
                        kMoreOfSheet.id),
                "%.3f", 0.005f, 1.01f, 8.0f, [](const MuscleSheet& s) { return s.reach; },
                [](MuscleSheet& s, float value) { s.reach = value; },
                "How far its bellies' influence reaches, in radii: 1.5 for forms, 1.7 for calm plates."},
    SheetNumber{
        Control("inspector/sheet/spacing", "Spacing", "of the sheet overlap even ripple", withSheet, kMoreOfSheet.id),
        "%.3f", 0.005f, kLeastSpacing, kMostSpacing, [](const MuscleSheet& s) { return s.spacing; },
        [](MuscleSheet& s, float value) { s.spacing = value; },
        "Distance between its bellies. At 0.644 their sum is even; more shows single bellies."}};

/// The selected sheets, with the rig as it was when drawing began.
struct SheetSubjects {
  std::shared_ptr<const Rig> rig;
  std::vector<int> indices;
  int active = -1;

  [[nodiscard]] const MuscleSheet& shown() const { return at(rig->sheets, active); }
};

/// A field of sheets: of a SheetNumber or a LineNumber.
struct SheetField {
  std::string id;
  std::string label;
  NumberLook look;
  std::string hint;
  std::function<float(const MuscleSheet&)> of;
  std::function<void(MuscleSheet&, float)> set;
};

/// The sheet as it was before the current edit.
const MuscleSheet& sheetAtStart(const PanelUi& ui, const MuscleSheet& sheet) {
  const Rig& rig = ui.state.document.commands.rigOfStep();
  const int index = findSheet(rig, sheet.name);
  return index < 0 ? sheet : at(rig.sheets, index);
}

Result<Rig> editedSheets(PanelUi& ui, const SheetSubjects& sheets, const SheetField& field, const SharedEdit& change) {
  const auto own = [&](const MuscleSheet& sheet) {
    return field.of(change.fromStart ? sheetAtStart(ui, sheet) : sheet);
  };
  const std::string active = sheets.shown().name;
  const float by = change.to - own(sheets.shown());
  return editSheets(ui.state.document.rig(), sheets.indices, [&](MuscleSheet& sheet) {
    const bool exact = change.same || sheet.name == active;
    field.set(sheet, exact ? change.to : std::clamp(own(sheet) + by, field.look.least, field.look.most));
  });
}

/// "1.50 % to 2.00 %" if all sheets had the same number and have the same now; else "".
std::string sheetValues(const PanelUi& ui, const SheetSubjects& sheets, const SheetField& field) {
  std::string text;
  for (const int index : sheets.indices) {
    const MuscleSheet& before = at(sheets.rig->sheets, index);
    const int now = findSheet(ui.state.document.rig(), before.name);
    if (now < 0) return {};
    const std::string own = numberText(field.look.format, field.of(sheetAtStart(ui, before))) + " to " +
                            numberText(field.look.format, field.of(at(ui.state.document.rig().sheets, now)));
    if (!text.empty() && text != own) return {};
    text = own;
  }
  return text;
}

void drawSheetField(PanelUi& ui, const SheetSubjects& sheets, const SheetField& field, std::optional<float> initial) {
  const float shown = field.of(sheets.shown());
  const bool differ =
      std::ranges::any_of(sheets.indices, [&](int index) { return field.of(at(sheets.rig->sheets, index)) != shown; });
  const std::string step = field.label + " of " + namedSheets(*sheets.rig, sheets.indices);
  drawSharedField(ui, field.id, {}, {}, {shown, differ, step.c_str()}, field.look,
                  [&](const SharedEdit& change) { edit(ui.state, step, editedSheets(ui, sheets, field, change)); });
  if (ImGui::IsItemDeactivated()) {
    const std::string values = sheetValues(ui, sheets, field);
    endFieldEdit(ui, values.empty() ? step : step + " " + values);
  }
  if (!ImGui::IsItemActive()) {
    const char* mixed = differ ? "\nThey differ: a drag keeps the differences, a typed number is for all." : "";
    tooltip(ui, field.label + "\n" + field.hint + mixed + "\nRight click: reset, copy, paste.");
  }
  if (!ImGui::BeginPopupContextItem(field.id.c_str())) return;
  const std::optional<float> chosen = numberMenu(ui, field.look.format, shown, initial);
  if (chosen) edit(ui.state, step, editedSheets(ui, sheets, field, {true, false, *chosen}));
  ImGui::EndPopup();
}

void sheetNumberRow(PanelUi& ui, const SheetSubjects& sheets, const SheetNumber& number) {
  beginRow(ui, number.control);
  ImGui::SetNextItemWidth(-1.0f);
  SheetField field{number.control.id,
                   number.control.label,
                   NumberLook{number.format, number.speed, number.least, number.most, 0.0f, number.whole},
                   number.hint,
                   number.of,
                   number.set};
  const MuscleSheet plain;
  const bool hasInitial = &number != &kSheetWidth;
  drawSheetField(ui, sheets, field, hasInitial ? std::optional(number.of(plain)) : std::nullopt);
}

void sheetLineRow(PanelUi& ui, const SheetSubjects& sheets, const LineRow& row) {
  beginRow(ui, row.label);
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const auto count = static_cast<float>(row.numbers.size());
  const float width = (ImGui::GetContentRegionAvail().x - (count - 1.0f) * gap) / count;
  for (const LineNumber& number : row.numbers) {
    if (&number != &row.numbers.front()) ImGui::SameLine(0.0f, gap);
    ImGui::SetNextItemWidth(width);
    const auto of = [&number](const MuscleSheet& sheet) {
      LineSettings settings = sheet.line.value_or(LineSettings{});
      return number.of(settings) * number.scale;
    };
    const std::string format = labelled(number, of(sheets.shown()), width);
    SheetField field{number.control.id,
                     number.control.label,
                     NumberLook{format.c_str(), number.speed, number.least, number.most},
                     number.hint,
                     of,
                     [&number](MuscleSheet& sheet, float value) {
                       if (sheet.line) number.of(*sheet.line) = value / number.scale;
                     }};
    MuscleSheet plain;
    plain.line = linesOfSheets();
    drawSheetField(ui, sheets, field, of(plain));
  }
}

/// Of the active sheet.
void sheetProfileRow(PanelUi& ui, const SheetSubjects& sheets, const Control& control, bool along) {
  const auto profileOf = [along](auto& sheet) -> auto& { return along ? sheet.along : sheet.across; };
  const MuscleSheet& shown = sheets.shown();
  const Profile& profile = profileOf(shown);
  if (profile.empty()) return;
  beginWideRow(ui, control.label);
  const std::string label = std::string("Profile ") + (along ? "along " : "across ") + shown.name;
  CurveView view;
  view.id = control.id;
  view.place.sheet = shown.name;
  view.place.along = along;
  view.inputText = [](float x) { return numberText("%.2f", x); };
  view.valueText = [](float y) { return numberText("%.2f", y); };
  view.label = label.c_str();
  view.drawn = [&](float x) { return profileAt(profile, x); };
  view.shown = glm::vec4(0.0f, 0.0f, 1.0f, 1.0f);
  view.hint = along ? "Height of the strips from the origin, at the left, to the insertion. Double-click adds a point"
                    : "Height from the first strip, at the left, to the last. Double-click adds a point";
  view.changed = [&](const Curve& curve) {
    return editSheets(ui.state.document.rig(), {sheets.active}, [&](MuscleSheet& sheet) {
      Profile& changed = profileOf(sheet);
      changed = curve.points;
      for (glm::vec2& point : changed) {
        point = {std::clamp(point.x, 0.0f, 1.0f), std::clamp(point.y, -kMostProfile, kMostProfile)};
      }
    });
  };
  const MuscleSheet& before = sheetAtStart(ui, shown);
  drawCurveEditor(ui, {profile, CurveKind::kSmooth}, {profileOf(before), CurveKind::kSmooth}, view);
}

void sheetOnLinesRow(PanelUi& ui, const SheetSubjects& sheets) {
  beginRow(ui, kOnLines);
  bool on = sheets.shown().line.has_value();
  const bool changed = ImGui::Checkbox("##on-lines", &on);
  ui.widgets.note(kOnLines.id);
  tooltip(ui, "Each strip stretches and flexes between the bones of origin and insertion. Off: it only follows bones.");
  if (changed) setOnLines(ui.state, on);
}

/// "chest to upper arm L"
std::string boneNamesOf(const PanelUi& ui, const MuscleSheet& sheet) {
  const Skeleton& skeleton = ui.state.character().skeleton;
  const std::string from = shownBoneName(skeleton, sheet.edges.front().points.front().bone);
  const std::string to = shownBoneName(skeleton, sheet.edges.back().points.front().bone);
  return from == to ? from : from + " to " + to;
}

void endsOfSheetRow(PanelUi& ui, const SheetSubjects& sheets) {
  if (sheets.indices.size() > 1) return;
  beginRow(ui, "Ends");
  ImGui::AlignTextToFramePadding();
  const std::string text = boneNamesOf(ui, sheets.shown());
  ImGui::TextUnformatted(fitted(text, ImGui::GetContentRegionAvail().x).c_str());
  ui.widgets.note("inspector/sheet/ends");
  tooltip(ui, text + "\nDrag the points of its edges in the picture: round at the origin, diamonds at the insertion.");
}

bool moreOfSheetRow(PanelUi& ui) {
  bool& open = ui.state.view.inspector.sheetOpen;
  beginRow(ui, kMoreOfSheet);
  const std::string text = open ? "less" : "sunk, reach, spacing";
  if (ImGui::Button((fitted(text, ImGui::GetContentRegionAvail().x - ui.px(12)) + "##more").c_str(), {-1.0f, 0.0f})) {
    open = !open;
  }
  ui.widgets.note(kMoreOfSheet.id);
  tooltip(ui, "Show or hide the numbers that rarely change.");
  return open;
}

}  // namespace

void drawSheetRows(PanelUi& ui) {
  const Document& document = ui.state.document;
  const SheetSubjects sheets{document.commands.sharedRig(), selectedSheets(document), activeSheet(document)};
  if (sheets.active < 0) return;
  endsOfSheetRow(ui, sheets);
  if (section(ui, kSheetSection, sheets.indices.size() > 1 ? "Sheets" : "Sheet")) {
    for (const SheetNumber& number : kSheetNumbers) sheetNumberRow(ui, sheets, number);
    if (sheets.shown().width > 0.0f) sheetNumberRow(ui, sheets, kSheetWidth);
    if (moreOfSheetRow(ui)) {
      for (const SheetNumber& number : kFurtherNumbers) sheetNumberRow(ui, sheets, number);
    }
  }
  if (section(ui, kProfiles, "Profiles")) {
    sheetProfileRow(ui, sheets, kProfileAcross, false);
    sheetProfileRow(ui, sheets, kProfileAlong, true);
  }
  sheetOnLinesRow(ui, sheets);
  if (sheets.shown().line && lineSection(ui, true)) {
    for (const LineRow& row : lineRows()) sheetLineRow(ui, sheets, row);
  }
  ImGui::Dummy({0.0f, ui.px(2)});
  rowButton(ui, "Break into strips", "inspector/sheet/break", "edit/break-sheet", ImGui::GetContentRegionAvail().x);
}

}  // namespace sinew::app
