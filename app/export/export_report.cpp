// app/export/export_report.cpp: figures as a line, as a table and as JSON.
#include "app/export/export_report.h"

#include <array>
#include <cstdio>
#include <iomanip>
#include <sstream>

#include "app/document/folder_listing.h"
#include "core/io/json/json.h"

namespace sinew::app {
namespace {

constexpr const char* kHeader = "  % of the height            poses       rms    99.9 %       max\n";
/// Targets that some engines blend at once; the others are passed over.
constexpr int kTargetsAtOnce = 8;

Json jsonOf(const ErrorFigures& error) {
  Json json = Json::object();
  json.set("poses", error.poses).set("rms", error.rms).set("percentile_99_9", error.percentile999);
  json.set("max", error.largest);
  return json;
}

Json jsonOf(const std::vector<ClipError>& clips) {
  Json list = Json::array();
  for (const ClipError& clip : clips) {
    Json item = Json::object();
    item.set("name", clip.clip);
    for (const Json& member : jsonOf(clip.error).children) item.set(member.key, member);
    list.push(std::move(item));
  }
  return list;
}

template <class Report>
void setSizes(const Report& report, Json& json) {
  json.set("vertices", static_cast<long long>(report.vertices));
  json.set("triangles", static_cast<long long>(report.triangles));
  json.set("bytes", static_cast<long long>(report.bytes));
}

/// After file and kind.
void setMembers(const ExportResult& result, const SkinnedExportReport& report, Json& json) {
  Json error = Json::object();
  error.set("fitted", jsonOf(report.fitted)).set("held_out", jsonOf(report.heldOut));
  error.set("all_clips", jsonOf(report.allClips)).set("clips", jsonOf(report.clips));
  error.set("further", jsonOf(report.further));
  json.set("mesh", nameOf(result.settings.mesh)).set("weights", nameOf(result.settings.weights));
  json.set("joints", report.joints).set("line_joints", report.lineJoints).set("rigid_helpers", report.rigidHelpers);
  setSizes(report, json);
  json.set("error_percent_of_height", std::move(error));
}

void setMembers(const ExportResult& result, const BakedExportReport& report, Json& json) {
  const ExportSettings& settings = result.settings;
  json.set("clip", settings.clips.front()).set("fps", settings.framesPerSecond).set("frames", report.frames);
  const bool hasTargets = result.kind.form == ExportForm::kTargets;
  if (hasTargets) {
    json.set("weights", nameOf(settings.weights)).set("bound", settings.bound);
    json.set("targets", report.targets).set("joints", report.joints);
  }
  setSizes(report, json);
  if (!hasTargets) return;
  Json error = Json::object();
  error.set("skinned", jsonOf(report.skinned)).set("baked", jsonOf(report.baked));
  json.set("error_percent_of_height", std::move(error));
}

void writeRow(std::ostream& out, const std::string& name, const ErrorFigures& error) {
  out << "  " << std::left << std::setw(23) << name << ' ' << std::right << std::setw(6) << error.poses << std::fixed
      << std::setprecision(3);
  for (const double percent : {error.rms, error.percentile999, error.largest}) out << ' ' << std::setw(9) << percent;
  out << '\n';
}

template <class Report>
void writeSizes(std::ostream& out, const Report& report) {
  out << report.vertices << " vertices, " << report.triangles << " triangles, " << report.bytes << " bytes";
}

void writeLines(std::ostream& out, const ExportResult& result, const SkinnedExportReport& report) {
  out << "  " << nameOf(result.settings.mesh) << " mesh, " << nameOf(result.settings.weights)
      << " weights: " << report.joints << " joints";
  if (const int added = report.lineJoints + report.rigidHelpers; added > 0) {
    out << " (" << added << " added: " << report.lineJoints << " of muscle lines, " << report.rigidHelpers << " rigid)";
  }
  out << ", ";
  writeSizes(out, report);
  out << '\n' << kHeader;
  for (const ClipError& clip : report.clips) writeRow(out, '"' + clip.clip + '"', clip.error);
  if (report.clips.size() > 1) writeRow(out, "all clips", report.allClips);
  for (const ClipError& clip : report.further) writeRow(out, '(' + clip.clip + ')', clip.error);
  writeRow(out, "fitted poses", report.fitted);
  writeRow(out, "held-out poses", report.heldOut);
}

void writeLines(std::ostream& out, const ExportResult& result, const BakedExportReport& report) {
  const ExportSettings& settings = result.settings;
  out << "  \"" << settings.clips.front() << "\": " << report.frames << " frames, " << settings.framesPerSecond
      << " a second; ";
  const bool hasTargets = result.kind.form == ExportForm::kTargets;
  if (hasTargets) out << report.targets << " targets, " << report.joints << " joints, ";
  writeSizes(out, report);
  out << (hasTargets ? "\n" : " in all files\n");
  if (!hasTargets) return;
  out << kHeader;
  writeRow(out, "joints alone", report.skinned);
  writeRow(out, "baked", report.baked);
  out << "  bound" << std::setw(55) << settings.bound << '\n';
  if (report.targets > kTargetsAtOnce) {
    out << "  hint: some engines blend " << kTargetsAtOnce << " targets at most; a looser --bound needs fewer\n";
  }
}

std::string percentText(double percent) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), percent < 0.01 ? "%.1g %%" : "%.2g %%", percent);
  return text.data();
}

std::string countText(int count, const std::string& one) {
  return std::to_string(count) + ' ' + one + (count == 1 ? "; " : "s; ");
}

/// How close it comes over its clips; without any over the poses that it was measured in.
std::string figuresOf(const SkinnedExportReport& report) {
  const ErrorFigures& error = report.allClips.poses > 0 ? report.allClips : report.fitted;
  std::string text;
  if (error.poses > 0) {
    text = "RMS " + percentText(error.rms) + " of the height, largest " + percentText(error.largest) + "; ";
  }
  return text + countText(report.joints, "joint") + sizeText(report.bytes);
}

std::string figuresOf(const BakedExportReport& report) {
  std::string text = std::to_string(report.frames) + " frames; ";
  if (report.targets > 0) {
    text += "largest distance " + percentText(report.baked.largest) + " of the height; " +
            countText(report.targets, "morph target");
  }
  return text + sizeText(report.bytes);
}

}  // namespace

std::string exportJson(const ExportResult& result) {
  Json json = Json::object();
  json.set("file", result.file.string()).set("as", result.kind.word);
  std::visit([&](const auto& report) { setMembers(result, report, json); }, result.report);
  Json left = Json::array();
  for (const std::string& line : leftOut(result.report)) left.push(line);
  return json.set("left_out", std::move(left)).dump(true) + '\n';
}

std::string exportText(const ExportResult& result) {
  std::ostringstream out;
  out << result.file.string() << '\n';
  std::visit([&](const auto& report) { writeLines(out, result, report); }, result.report);
  for (const std::string& line : leftOut(result.report)) out << "  left out: " << line << '\n';
  return out.str();
}

std::string exportFigures(const ExportReport& report) {
  return std::visit([](const auto& own) { return figuresOf(own); }, report);
}

const std::vector<std::string>& leftOut(const ExportReport& report) {
  return std::visit([](const auto& own) -> const std::vector<std::string>& { return own.left; }, report);
}

}  // namespace sinew::app
