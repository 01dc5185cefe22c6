// app/ui/letter_fonts.cpp: paths of Debian's font packages.

#include "app/ui/letter_fonts.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "app/ui/code_points.h"

namespace sinew::app {
namespace {

constexpr float kWideEm = 0.87f;  ///< Of the height of the line.

/// Of fonts-noto-cjk, which has one face a region, in this order.
int faceOfRegion(HanRegion region) {
  switch (region) {
    case HanRegion::kJapan:
      return 0;
    case HanRegion::kKorea:
      return 1;
    case HanRegion::kMainland:
      return 2;
    case HanRegion::kTaiwan:
      return 3;
    case HanRegion::kHongKong:
      return 4;
  }
  return 0;
}

void addWideFonts(std::vector<FontFile>& files, bool strong, HanRegion region) {
  if (strong) files.push_back({"/usr/share/fonts/opentype/noto/NotoSansCJK-Bold.ttc", faceOfRegion(region)});
  files.push_back({"/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc", faceOfRegion(region)});
  // Smaller packages that a machine may have instead.
  for (const char* other :
       {"/usr/share/fonts/truetype/droid/DroidSansFallbackFull.ttf", "/usr/share/fonts/truetype/wqy/wqy-microhei.ttc",
        "/usr/share/fonts/truetype/wqy/wqy-zenhei.ttc", "/usr/share/fonts/opentype/ipafont-gothic/ipag.ttf",
        "/usr/share/fonts/truetype/nanum/NanumGothic.ttf"}) {
    files.push_back({other, 0});
  }
}

void addOtherFonts(std::vector<FontFile>& files, bool strong) {
  if (strong) files.push_back({"/usr/share/fonts/opentype/inter/Inter-SemiBold.otf", 0});
  files.push_back({"/usr/share/fonts/opentype/inter/Inter-Regular.otf", 0});
  if (strong) files.push_back({"/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf", 0});
  files.push_back({"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", 0});
  // fonts-noto-core, by script.
  for (const char* other : {"/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
                            "/usr/share/fonts/truetype/noto/NotoSansThai-Regular.ttf",
                            "/usr/share/fonts/truetype/noto/NotoSansDevanagari-Regular.ttf",
                            "/usr/share/fonts/truetype/noto/NotoSansSymbols-Regular.ttf",
                            "/usr/share/fonts/truetype/noto/NotoSansSymbols2-Regular.ttf"}) {
    files.push_back({other, 0});
  }
}

}  // namespace

HanRegion hanRegion(std::u32string_view letters, std::string_view locale) {
  if (std::ranges::any_of(letters, isKana)) return HanRegion::kJapan;
  if (std::ranges::any_of(letters, isHangul)) return HanRegion::kKorea;
  if (locale.starts_with("ja")) return HanRegion::kJapan;
  if (locale.starts_with("ko")) return HanRegion::kKorea;
  if (locale.starts_with("zh_TW")) return HanRegion::kTaiwan;
  if (locale.starts_with("zh_HK") || locale.starts_with("zh_MO")) return HanRegion::kHongKong;
  return HanRegion::kMainland;
}

std::string_view localeOfEnvironment() {
  for (const char* name : {"LC_ALL", "LC_CTYPE", "LANG"}) {
    const char* value = std::getenv(name);
    if (value != nullptr && *value != '\0') return value;
  }
  return "";
}

std::vector<FontFile> fontFilesFor(char32_t c, bool strong, HanRegion region) {
  std::vector<FontFile> files;
  const bool wide = isWide(c) || isKana(c);
  if (wide) addWideFonts(files, strong, region);
  addOtherFonts(files, strong);
  if (!wide) addWideFonts(files, strong, region);
  return files;
}

int wideEm(float fontSize) { return static_cast<int>(std::lround(kWideEm * fontSize)); }

}  // namespace sinew::app
