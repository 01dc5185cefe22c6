// app/panels/body_parts.cpp: the panel Parts of the body: a table that assigns bones, and a figure.

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <vector>

#include "app/document/shown_names.h"
#include "app/editor/muscle_set_commands.h"
#include "app/panels/overlay.h"
#include "core/character/bindings.h"
#include "core/geometry/at.h"

namespace sinew::app {
namespace {

constexpr float kWidth = 470.0f;  // Design pixels, as all here.
constexpr float kFigure = 150.0f;
constexpr float kLeast = 360.0f;  // A narrower panel has no figure.
constexpr float kName = 104.0f;
constexpr float kBodyPartsTop = 96.0f;  // Under the display bar.

struct Confidence {
  Tint tint;
  const char* words;
};
Confidence confidenceOf(SlotConfidence confidence) {
  switch (confidence) {
    case SlotConfidence::kMissing:
      break;
    case SlotConfidence::kPlaced:
      return {palette::kWarning, "found by its position only"};
    case SlotConfidence::kNamed:
      return {palette::kWarning, "found by its name only"};
    case SlotConfidence::kSure:
      return {palette::kGood, "found by its name and its position"};
    case SlotConfidence::kGiven:
      return {palette::kAccent, "set by you"};
  }
  return {palette::kLine, "not found"};
}

/// "upperArm" -> "Upper arm"
std::string readable(Slot slot) {
  std::string text;
  for (const char* c = nameOf(slot); *c != '\0'; ++c) {
    if (std::isupper(static_cast<unsigned char>(*c)) != 0) text += ' ';
    text += static_cast<char>(std::tolower(static_cast<unsigned char>(*c)));
  }
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

bool isAnimal(const BodyPartsState& parts) {
  return parts.slots.kind == BodyKind::kUnknown ? parts.asAnimal : parts.slots.kind == BodyKind::kQuadruped;
}

/// The parts that this kind of body has.
std::vector<Slot> listedSlots(bool animal) {
  std::vector<Slot> slots;
  for (int i = 0; i < kSlotCount; ++i) {
    const auto slot = static_cast<Slot>(i);
    const bool ofAnimals = slot >= Slot::kFrontUpper;
    const bool ofPeople = slot >= Slot::kUpperArm && !ofAnimals;
    if (animal ? !ofPeople : !ofAnimals && slot != Slot::kTail) slots.push_back(slot);
  }
  return slots;
}

/// Choices besides bones: the bone that was found, or no such part.
void offerOthers(PanelUi& ui, BodySlot slot, const std::string& id) {
  const auto& corrections = ui.state.document.rig().slots;
  const bool given = std::ranges::any_of(corrections, [&](const auto& each) { return each.slot == nameOf(slot); });
  if (given && ImGui::Selectable("As found")) forgetBodyPart(ui.state, slot);
  if (given) ui.widgets.note(id + "-as-found");
  if (ImGui::Selectable("No such part")) setBodyPart(ui.state, slot, -1);
  ui.widgets.note(id + "-none");
  ImGui::Separator();
}

void drawPart(PanelUi& ui, BodySlot slot, float width, int& hovered) {
  BodyPartsState& parts = ui.state.open.bodyParts;
  const SlotBone& found = parts.slots[slot];
  const Confidence confidence = confidenceOf(found.confidence);
  const std::string id = std::string("body-parts/") + nameOf(slot);
  const std::string name = found.bone < 0 ? "\xe2\x80\x93" : shownBoneName(ui.state.character().skeleton, found.bone);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetFrameHeight();
  ImGui::GetWindowDrawList()->AddCircleFilled({corner.x + ui.px(5), corner.y + 0.5f * height}, ui.px(4),
                                              confidence.tint.packed(), 16);
  ImGui::SetCursorScreenPos({corner.x + ui.px(14), corner.y});
  ImGui::SetNextItemWidth(width - ui.px(18));
  ImGui::PushID(id.c_str());
  const bool open = ImGui::BeginCombo("##bone", fitted(name, width - ui.px(50)).c_str(), ImGuiComboFlags_HeightLarge);
  ui.widgets.note(id);
  if (ImGui::IsItemHovered()) hovered = static_cast<int>(indexOf(slot));
  if (!open) {
    tooltip(ui, (found.bone < 0 ? std::string() : name + ": ") + confidence.words);
  } else {
    hovered = static_cast<int>(indexOf(slot));
    const int bone = boneList(
        ui, id, found.bone, found.bone, [](int) { return true; }, [&] { offerOthers(ui, slot, id); });
    if (bone >= 0) setBodyPart(ui.state, slot, bone);
    ImGui::EndCombo();
  }
  ImGui::PopID();
}

void drawTable(PanelUi& ui, const std::vector<Slot>& slots, int& hovered) {
  const float left = ImGui::GetCursorPosX();
  const float room = ImGui::GetContentRegionAvail().x - ui.px(kName);
  mutedText("");
  ImGui::SameLine(left + ui.px(kName + 14));
  mutedText("Left, or middle");
  ImGui::SameLine(left + ui.px(kName + 14) + 0.5f * room);
  mutedText("Right");
  for (const Slot slot : slots) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(readable(slot).c_str());
    const BodySlot leftSide{slot, BodySide::kLeft};
    ImGui::SameLine(left + ui.px(kName));
    drawPart(ui, leftSide, 0.5f * room, hovered);
    if (!leftSide.isSided()) continue;
    ImGui::SameLine(left + ui.px(kName) + 0.5f * room);
    drawPart(ui, {slot, BodySide::kRight}, 0.5f * room, hovered);
  }
}

/// Projects the bind pose into a box: the front of people, the left side of animals.
class Figure {
 public:
  Figure(const Character& character, const BodySlots& slots, bool animal, const ImVec2& corner, const ImVec2& size)
      : character_(character), across_(animal ? -slots.forward : slots.left) {
    for (const glm::vec3& position : character.mesh.positions) {
      const glm::vec2 p = flat(position);
      least_ = glm::min(least_, p);
      most_ = glm::max(most_, p);
    }
    const glm::vec2 extent = glm::max(most_ - least_, glm::vec2(1e-6f));
    scale_ = std::min(size.x / extent.x, size.y / extent.y);
    corner_ = {corner.x + 0.5f * size.x, corner.y + 0.5f * size.y};
  }

  [[nodiscard]] ImVec2 at(const glm::vec3& world) const {
    const glm::vec2 p = scale_ * (flat(world) - 0.5f * (least_ + most_));
    return {corner_.x + p.x, corner_.y - p.y};
  }
  [[nodiscard]] ImVec2 head(int bone) const { return at(matrixOf(bone)[3]); }
  [[nodiscard]] ImVec2 tip(int bone) const {
    return at(matrixOf(bone) * glm::vec4(sinew::at(character_.skeleton.bones, bone).tip, 1.0f));
  }

 private:
  [[nodiscard]] glm::vec2 flat(const glm::vec3& world) const { return {glm::dot(world, across_), world.y}; }
  [[nodiscard]] const glm::mat4& matrixOf(int bone) const {
    return sinew::at(character_.skeleton.bones, bone).bindInWorld;
  }

  const Character& character_;
  glm::vec3 across_;
  glm::vec2 least_{FLT_MAX};
  glm::vec2 most_{-FLT_MAX};
  float scale_ = 1.0f;
  ImVec2 corner_;
};

void drawFigure(PanelUi& ui, const std::vector<Slot>& slots, const ImVec2& size, int& hovered) {
  const BodyPartsState& parts = ui.state.open.bodyParts;
  const Character& character = ui.state.character();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float inset = ui.px(8);
  const Figure figure(character, parts.slots, isAnimal(parts), {corner.x + inset, corner.y + inset},
                      {size.x - 2.0f * inset, size.y - 2.0f * inset});
  const std::vector<bool> carries = bonesWithSkin(character);
  for (std::size_t bone = 0; bone < carries.size(); ++bone) {
    if (!carries[bone]) continue;
    list.AddLine(figure.head(static_cast<int>(bone)), figure.tip(static_cast<int>(bone)), palette::kLine.packed(),
                 ui.px(2));
  }
  const ImVec2 mouse = ImGui::GetMousePos();
  for (const BodySlot slot : allBodySlots()) {
    const SlotBone& found = parts.slots[slot];
    if (found.bone < 0 || std::ranges::find(slots, slot.slot) == slots.end()) continue;
    const ImVec2 head = figure.head(found.bone);  // A part may begin in the middle of a bone.
    const ImVec2 tip = figure.tip(found.bone);
    const ImVec2 place{head.x + found.from * (tip.x - head.x), head.y + found.from * (tip.y - head.y)};
    const float away = std::max(std::abs(mouse.x - place.x), std::abs(mouse.y - place.y));
    if (ImGui::IsWindowHovered() && away < ui.px(6)) {
      hovered = static_cast<int>(indexOf(slot));
      tooltipWhile(ui, true, readable(slot.slot) + ": " + shownBoneName(character.skeleton, found.bone));
    }
    const bool lit = parts.hovered == static_cast<int>(indexOf(slot));
    if (lit) list.AddLine(head, tip, palette::kAccent.packed(), ui.px(4));
    list.AddCircleFilled(place, ui.px(lit ? 6.0f : 4.0f), confidenceOf(found.confidence).tint.packed(), 16);
  }
  ImGui::Dummy(size);
  ui.widgets.note("body-parts/figure");
}

std::string headingOf(const BodySlots& slots) {
  if (slots.kind == BodyKind::kUnknown) return "Neither arms nor legs were found: name their bones";
  return slots.kind == BodyKind::kQuadruped ? "Parts of an animal on four legs" : "Parts of a person";
}

void drawHeading(PanelUi& ui) {
  BodyPartsState& parts = ui.state.open.bodyParts;
  ImGui::TextUnformatted(headingOf(parts.slots).c_str());
  ui.widgets.note("body-parts/heading");
  if (parts.slots.kind != BodyKind::kUnknown) return;
  constexpr std::array kKinds{"Person", "Animal"};
  const int chosen = segmented(ui, "body-parts/kind", kKinds.data(), static_cast<int>(kKinds.size()),
                               parts.asAnimal ? 1 : 0, ui.px(200));
  if (chosen >= 0) parts.asAnimal = chosen == 1;
}

void drawInside(PanelUi& ui, float width) {
  BodyPartsState& parts = ui.state.open.bodyParts;
  const std::size_t revision = ui.state.document.commands.revision();
  if (parts.revision != revision) parts.slots = bodyPartsOf(ui.state);
  parts.revision = revision;
  const std::vector<Slot> slots = listedSlots(isAnimal(parts));
  drawHeading(ui);
  const float figure = width < ui.px(kLeast) ? 0.0f : ui.px(kFigure);
  const float height = ImGui::GetContentRegionAvail().y - ImGui::GetFrameHeightWithSpacing();
  int hovered = -1;
  ImGui::BeginChild("parts", {ImGui::GetContentRegionAvail().x - figure, height});
  drawTable(ui, slots, hovered);
  ImGui::EndChild();
  if (figure > 0.0f) {
    ImGui::SameLine();
    ImGui::BeginChild("figure", {0.0f, height});
    drawFigure(ui, slots, ImGui::GetContentRegionAvail(), hovered);
    ImGui::EndChild();
  }
  parts.hovered = hovered;
  if (textButton(ui, "body-parts/close", "Close")) parts.shown = false;
}

}  // namespace

void drawBodyParts(PanelUi& ui) {
  EditorState& state = ui.state;
  if (!state.open.bodyParts.shown) return;
  const glm::vec4& v = state.frame.viewport;
  const float width = std::min(ui.px(kWidth + kFigure), v.z - ui.px(2.0f * kFromEdges));
  const auto rows = static_cast<float>(listedSlots(isAnimal(state.open.bodyParts)).size() + 3);
  const float wanted = rows * ImGui::GetFrameHeightWithSpacing() + ui.px(20);
  const float top = ui.px(kBodyPartsTop);
  const float height = std::min(wanted, v.w - top - ui.px(kFromEdges));
  beginInPicture(ui, "body-parts", {ui.px(kBesideTools), top},
                 {std::min(width, v.z - ui.px(kBesideTools + kFromEdges)), height}, 0.97f, {10, 8});
  drawInside(ui, width);
  endInPicture();
}

}  // namespace sinew::app
