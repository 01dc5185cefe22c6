// core/files/export/formats.cpp: the table; a new format is one row and its writer.
#include "core/files/export/formats.h"

#include <algorithm>
#include <iterator>

#include "core/files/surface_formats.h"
#include "core/geometry/nearest_name.h"

namespace sinew {
namespace exporting {
namespace {

constexpr ExportFormat kFormats[] = {
    {".glb", ExportForm::kSkin, writeGlb},
    {".gltf", ExportForm::kSkin, writeGltf, nullptr, {".bin"}},
    {".usda", ExportForm::kSkin, writeUsd},
    {".glb", ExportForm::kTargets, nullptr, bakeTargets},
    {".gltf", ExportForm::kTargets, nullptr, bakeTargets, {".bin"}},
    {".usda", ExportForm::kStage, nullptr, bakeStage},
    {".pc2", ExportForm::kCache, nullptr, bakeCache, {".obj", ".mtl"}},
    {".mdd", ExportForm::kCache, nullptr, bakeCache, {".obj", ".mtl"}},
};

bool isOneOf(ExportForm form, const std::vector<ExportForm>& forms) {
  return std::ranges::find(forms, form) != forms.end();
}

}  // namespace

const ExportFormat* findFormat(const std::filesystem::path& file, const std::vector<ExportForm>& forms) {
  const std::string ending = lowerEnding(file);
  const auto* const found = std::ranges::find_if(
      kFormats, [&](const ExportFormat& format) { return format.ending == ending && isOneOf(format.form, forms); });
  return found == std::end(kFormats) ? nullptr : found;
}

Error unknownEnding(const std::filesystem::path& file, const std::vector<ExportForm>& forms) {
  return {file.string(), {}, "expected a name that ends in " + listed(exportEndings(forms), "or")};
}

}  // namespace exporting

using namespace exporting;

std::vector<std::string> exportEndings(const std::vector<ExportForm>& forms) {
  std::vector<std::string> endings;
  for (const ExportFormat& format : kFormats) {
    if (isOneOf(format.form, forms) && std::ranges::find(endings, format.ending) == endings.end()) {
      endings.emplace_back(format.ending);
    }
  }
  return endings;
}

bool hasExportEnding(const std::filesystem::path& file, const std::vector<ExportForm>& forms) {
  return findFormat(file, forms) != nullptr;
}

std::vector<std::filesystem::path> exportedFiles(const std::filesystem::path& file) {
  const std::string ending = lowerEnding(file);
  const auto* const format = std::ranges::find(kFormats, ending, &ExportFormat::ending);
  std::vector<std::filesystem::path> files;
  if (format != std::end(kFormats)) {
    for (const std::string_view beside : format->besides) {
      std::filesystem::path other = file;
      other.replace_extension(beside);
      if (beside == ".mtl") other.replace_filename(asWord(file.stem().string()) + ".mtl");  // As the .obj names it.
      if (!beside.empty()) files.push_back(std::move(other));
    }
  }
  files.push_back(file);
  return files;
}

}  // namespace sinew
