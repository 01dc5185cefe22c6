// app/document/export_report.cpp: figures as a line, as a table and as JSON.
#include "app/document/export_report.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <iomanip>
#include <sstream>

#include "app/document/folder_listing.h"
#include "core/files/json/json.h"

namespace sinew::app {
namespace {

constexpr const char* kHeader = "  % of the height            poses       rms    99.9 %       max   largest at\n";
constexpr double kLoose = 1.5;     ///< Error between frames, in multiples of the bound, that gets a hint.
constexpr int kTargetsAtOnce = 8;  ///< Morph targets that some engines blend at most.

Json jsonOf(const ErrorFigures& error) {
  Json json = Json::object();
  json.set("poses", error.poses).set("rms", error.rms).set("percentile_99_9", error.percentile999);
  json.set("max", error.largest);
  if (error.farthest.vertex < 0) return json;
  Json farthest = Json::object();
  farthest.set("clip", error.farthest.clip).set("time", error.farthest.time);
  farthest.set("vertex", error.farthest.vertex).set("bone", error.farthest.bone);
  return json.set("farthest", std::move(farthest));
}

Json jsonOf(const std::vector<ClipError>& clips) {
  Json list = Json::array();
  for (const ClipError& clip : clips) {
    Json item = Json::object();
    item.set("name", clip.clip);
    for (const Json& member : jsonOf(clip.error).children) item.set(member.key, member);
    if (clip.between.poses > 0) item.set("between_keys", jsonOf(clip.between));
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

void setMembers(const ExportResult& result, const SkinnedExportReport& report, Json& json) {
  Json error = Json::object();
  error.set("fitted", jsonOf(report.fitted)).set("held_out", jsonOf(report.heldOut));
  error.set("all_clips", jsonOf(report.allClips)).set("between_keys", jsonOf(report.allBetween));
  error.set("clips", jsonOf(report.clips));
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
    json.set("substeps", settings.substeps);
    json.set("weights", nameOf(settings.weights)).set("bound", settings.bound);
    json.set("targets", report.targets).set("joints", report.joints);
  }
  setSizes(report, json);
  if (!hasTargets) return;
  Json error = Json::object();
  error.set("skinned", jsonOf(report.skinned)).set("baked", jsonOf(report.baked));
  error.set("between_frames", jsonOf(report.between));
  json.set("error_percent_of_height", std::move(error));
}

void writeRow(std::ostream& out, const std::string& name, const ErrorFigures& error, bool namesClip = false) {
  out << "  " << std::left << std::setw(23) << name << ' ' << std::right << std::setw(6) << error.poses << std::fixed
      << std::setprecision(3);
  for (const double percent : {error.rms, error.percentile999, error.largest}) out << ' ' << std::setw(9) << percent;
  const ErrorPlace& place = error.farthest;
  if (place.vertex >= 0) {
    out << "   " << place.time << " s" << (namesClip ? " of \"" + place.clip + '"' : "") << ", vertex " << place.vertex
        << " (" << place.bone << ')';
  }
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
  for (const ClipError& clip : report.clips) {
    writeRow(out, '"' + clip.clip + '"', clip.error);
    writeRow(out, "  between keys", clip.between);
  }
  if (report.clips.size() > 1) {
    writeRow(out, "all clips", report.allClips, true);
    writeRow(out, "  between keys", report.allBetween, true);
  }
  for (const ClipError& clip : report.further) writeRow(out, '(' + clip.clip + ')', clip.error);
  writeRow(out, "fitted poses", report.fitted, true);
  writeRow(out, "held-out poses", report.heldOut, true);
}

void writeLines(std::ostream& out, const ExportResult& result, const BakedExportReport& report) {
  const ExportSettings& settings = result.settings;
  out << "  \"" << settings.clips.front() << "\": " << report.frames << " frames, "
      << settings.framesPerSecond * settings.substeps << " a second; ";
  const bool hasTargets = result.kind.form == ExportForm::kTargets;
  if (hasTargets) out << report.targets << " targets, " << report.joints << " joints, ";
  writeSizes(out, report);
  out << (hasTargets ? "\n" : " in all files\n");
  if (!hasTargets) return;
  out << kHeader;
  writeRow(out, "joints alone", report.skinned);
  writeRow(out, "baked", report.baked);
  writeRow(out, "  between frames", report.between);
  out << "  bound" << std::setw(55) << settings.bound << '\n';
  if (report.between.largest > kLoose * settings.bound && report.between.largest > report.baked.largest &&
      settings.substeps < kMostSubsteps) {
    out << "  hint: the bound holds in baked frames; --substeps " << std::min(2 * settings.substeps, kMostSubsteps)
        << " bakes moments between them, too\n";
  }
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

const ErrorFigures& larger(const ErrorFigures& a, const ErrorFigures& b) { return b.largest > a.largest ? b : a; }

const ErrorFigures& largestIn(const SkinnedExportReport& report) {
  return report.allClips.poses > 0 ? larger(report.allClips, report.allBetween) : report.fitted;
}

const ErrorFigures& largestIn(const BakedExportReport& report) { return larger(report.baked, report.between); }

/// Over all clips, else over the fitted poses.
std::string figuresOf(const SkinnedExportReport& report) {
  const ErrorFigures& error = report.allClips.poses > 0 ? report.allClips : report.fitted;
  std::string text;
  if (error.poses > 0) {
    text = "RMS " + percentText(error.rms) + " of the height, largest " + largestText(largestIn(report)) + "; ";
  }
  return text + countText(report.joints, "joint") + sizeText(report.bytes);
}

std::string figuresOf(const BakedExportReport& report) {
  std::string text = std::to_string(report.frames) + " frames; ";
  if (report.targets > 0) {
    text += "largest distance " + largestText(largestIn(report)) + "; " + countText(report.targets, "morph target");
  }
  return text + sizeText(report.bytes);
}

}  // namespace

std::string largestText(const ErrorFigures& error) {
  std::array<char, 32> time{};
  std::snprintf(time.data(), time.size(), "%.2f s", static_cast<double>(error.farthest.time));
  return percentText(error.largest) + " in \"" + error.farthest.clip + "\" at " + time.data() + " on " +
         error.farthest.bone;
}

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

const ErrorFigures* farthestOf(const ExportReport& report) {
  return std::visit(
      [](const auto& own) {
        const ErrorFigures& figures = largestIn(own);
        return figures.farthest.vertex < 0 ? nullptr : &figures;
      },
      report);
}

std::shared_ptr<const ExportedSurface> playedBy(const ExportReport& report) {
  return std::visit([](const auto& own) { return own.played; }, report);
}

const std::vector<std::string>& leftOut(const ExportReport& report) {
  return std::visit([](const auto& own) -> const std::vector<std::string>& { return own.left; }, report);
}

}  // namespace sinew::app
