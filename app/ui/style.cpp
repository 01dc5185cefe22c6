// app/ui/style.cpp: fonts from Debian's packages, colors and spacing.
#include "app/ui/style.h"

#include <filesystem>
#include <initializer_list>

#include <imgui_freetype.h>

namespace sinew::app {

namespace {

constexpr float kBodySize = 15.0f;
constexpr float kMonoSize = 13.0f;

// Latin, its extensions, Greek, Cyrillic, punctuation, arrows and mathematical signs.
constexpr ImWchar kRanges[] = {0x0020, 0x024F, 0x0370, 0x052F, 0x2010, 0x205E, 0x2190, 0x21FF, 0x2200, 0x22FF, 0};

ImFont* firstOf(std::initializer_list<const char*> files, float size) {
  ImFontConfig config;
  config.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
  config.OversampleH = 1;
  for (const char* file : files) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored)) continue;
    if (ImFont* font = ImGui::GetIO().Fonts->AddFontFromFileTTF(file, size, &config, kRanges)) return font;
  }
  return nullptr;
}

ImFont* builtIn(float size) {
  ImFontConfig config;
  config.SizePixels = size;
  return ImGui::GetIO().Fonts->AddFontDefault(&config);
}

}  // namespace

Fonts loadFonts(float scale) {
  ImGui::GetIO().Fonts->FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  Fonts fonts;
  fonts.body = firstOf({"/usr/share/fonts/opentype/inter/Inter-Regular.otf",
                        "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Regular.ttf",
                        "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"},
                       kBodySize * scale);
  if (fonts.body == nullptr) fonts.body = builtIn(13.0f * scale);
  fonts.strong = firstOf({"/usr/share/fonts/opentype/inter/Inter-SemiBold.otf",
                          "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Medium.ttf",
                          "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"},
                         kBodySize * scale);
  if (fonts.strong == nullptr) fonts.strong = fonts.body;
  fonts.mono = firstOf({"/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf"}, kMonoSize * scale);
  if (fonts.mono == nullptr) fonts.mono = fonts.body;
  return fonts;
}

namespace {

void setSpacing(ImGuiStyle& style) {
  style.WindowPadding = {12.0f, 10.0f};
  style.FramePadding = {8.0f, 4.0f};
  style.CellPadding = {6.0f, 3.0f};
  style.ItemSpacing = {8.0f, 6.0f};
  style.ItemInnerSpacing = {6.0f, 4.0f};
  style.IndentSpacing = 12.0f;
  style.ScrollbarSize = 11.0f;
  style.GrabMinSize = 10.0f;
  style.WindowBorderSize = 0.0f;
  style.ChildBorderSize = 0.0f;
  style.PopupBorderSize = 1.0f;
  style.FrameBorderSize = 0.0f;
  style.WindowRounding = 0.0f;
  style.ChildRounding = 6.0f;
  style.FrameRounding = 5.0f;
  style.PopupRounding = 7.0f;
  style.ScrollbarRounding = 6.0f;
  style.GrabRounding = 4.0f;
  style.TabRounding = 5.0f;
  style.WindowTitleAlign = {0.0f, 0.5f};
  style.SelectableTextAlign = {0.0f, 0.5f};
  style.DisabledAlpha = 0.42f;
}

void setSurfaces(ImVec4* colors) {
  using namespace palette;
  colors[ImGuiCol_Text] = kText;
  colors[ImGuiCol_TextDisabled] = kMuted;
  colors[ImGuiCol_WindowBg] = kPanel;
  colors[ImGuiCol_ChildBg] = kPanel.faded(0.0f);
  colors[ImGuiCol_PopupBg] = {0.137f, 0.149f, 0.173f, 0.985f};
  colors[ImGuiCol_Border] = kLine;
  colors[ImGuiCol_MenuBarBg] = kBackground;
  colors[ImGuiCol_TitleBg] = kRaised;
  colors[ImGuiCol_TitleBgActive] = kRaised;
  colors[ImGuiCol_Separator] = kLine;
  colors[ImGuiCol_ScrollbarBg] = kPanel.faded(0.0f);
  colors[ImGuiCol_ScrollbarGrab] = kLine;
  colors[ImGuiCol_ScrollbarGrabHovered] = {0.31f, 0.33f, 0.38f, 1.0f};
  colors[ImGuiCol_ScrollbarGrabActive] = kMuted;
  colors[ImGuiCol_ModalWindowDimBg] = {0.0f, 0.0f, 0.0f, 0.55f};
  colors[ImGuiCol_TableHeaderBg] = kRaised;
  colors[ImGuiCol_TableBorderLight] = kLine;
  colors[ImGuiCol_TableBorderStrong] = kLine;
  colors[ImGuiCol_PlotLines] = kAccent;
  colors[ImGuiCol_PlotHistogram] = kAccent.faded(0.85f);
}

void setControls(ImVec4* colors) {
  using namespace palette;
  constexpr Tint kHover{0.227f, 0.247f, 0.286f, 1.0f};
  constexpr Tint kPressed{0.275f, 0.298f, 0.345f, 1.0f};
  colors[ImGuiCol_FrameBg] = {0.082f, 0.090f, 0.106f, 1.0f};
  colors[ImGuiCol_FrameBgHovered] = {0.106f, 0.118f, 0.137f, 1.0f};
  colors[ImGuiCol_FrameBgActive] = {0.133f, 0.145f, 0.169f, 1.0f};
  colors[ImGuiCol_Button] = kRaised;
  colors[ImGuiCol_ButtonHovered] = kHover;
  colors[ImGuiCol_ButtonActive] = kPressed;
  colors[ImGuiCol_Header] = kAccent.faded(0.22f);
  colors[ImGuiCol_HeaderHovered] = {0.200f, 0.216f, 0.251f, 1.0f};
  colors[ImGuiCol_HeaderActive] = kAccent.faded(0.34f);
  colors[ImGuiCol_CheckMark] = kAccent;
  colors[ImGuiCol_SliderGrab] = kAccent.faded(0.80f);
  colors[ImGuiCol_SliderGrabActive] = kAccent;
  colors[ImGuiCol_SeparatorHovered] = kAccent.faded(0.6f);
  colors[ImGuiCol_SeparatorActive] = kAccent;
  colors[ImGuiCol_ResizeGrip] = kLine.faded(0.0f);
  colors[ImGuiCol_TextSelectedBg] = kAccent.faded(0.35f);
  colors[ImGuiCol_NavHighlight] = kAccent;
  colors[ImGuiCol_DragDropTarget] = kAccent;
  colors[ImGuiCol_Tab] = kPanel;
  colors[ImGuiCol_TabHovered] = kHover;
  colors[ImGuiCol_TabActive] = kRaised;
}

}  // namespace

void applyStyle(float scale) {
  ImGuiStyle style;
  ImGui::StyleColorsDark(&style);
  setSpacing(style);
  setSurfaces(style.Colors);
  setControls(style.Colors);
  style.ScaleAllSizes(scale);
  ImGui::GetStyle() = style;
}

}  // namespace sinew::app
