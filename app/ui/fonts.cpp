// app/ui/fonts.cpp: fonts from Debian's packages.

#include "app/ui/fonts.h"

#include <imgui.h>
#include <imgui_freetype.h>

#include <filesystem>
#include <initializer_list>

namespace sinew::app {
namespace {

constexpr float kBodySize = 15.0f;
constexpr float kMonoSize = 13.0f;

// Latin, its extensions, Greek, Cyrillic, punctuation, arrows and mathematical signs: names in files come in many
// scripts.
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

}  // namespace sinew::app
