// app/cli/export_report.cpp: figures as JSON and as a table.
#include "app/cli/export_verb.h"

#include <iomanip>
#include <sstream>
#include <vector>

#include "core/io/json/json.h"

namespace sinew::app {
namespace {

constexpr const char* kRefined = "refined";
constexpr const char* kRefitted = "refitted";
constexpr const char* kHeader = "  % of the height            poses       rms    99.9 %       max\n";
/// Targets that some engines blend at once; the others are passed over.
constexpr int kTargetsAtOnce = 8;

Json jsonOf(const ErrorFigures& error) {
  Json json = Json::object();
  json.set("poses", error.poses).set("rms", error.rms).set("percentile_99_9", error.percentile999);
  json.set("max", error.largest);
  return json;
}

Json clipsOf(const std::vector<ClipError>& clips) {
  Json list = Json::array();
  for (const ClipError& clip : clips) {
    Json item = Json::object();
    item.set("name", clip.clip);
    for (const Json& member : jsonOf(clip.error).children) item.set(member.key, member);
    list.push(std::move(item));
  }
  return list;
}

Json linesOf(const std::vector<std::string>& lines) {
  Json list = Json::array();
  for (const std::string& line : lines) list.push(line);
  return list;
}

void writeRow(std::ostream& out, const std::string& name, const ErrorFigures& error) {
  out << "  " << std::left << std::setw(23) << name << ' ' << std::right << std::setw(6) << error.poses << std::fixed
      << std::setprecision(3);
  for (const double percent : {error.rms, error.percentile999, error.largest}) out << ' ' << std::setw(9) << percent;
  out << '\n';
}

void writeLeft(std::ostream& out, const std::vector<std::string>& left) {
  for (const std::string& line : left) out << "  left out: " << line << '\n';
}

std::string jsonText(const ExportOptions& options, const std::filesystem::path& output,
                     const SkinnedExportReport& report) {
  Json error = Json::object();
  error.set("fitted", jsonOf(report.fitted)).set("held_out", jsonOf(report.heldOut));
  error.set("all_clips", jsonOf(report.allClips)).set("clips", clipsOf(report.clips));
  error.set("further", clipsOf(report.further));
  Json json = Json::object();
  json.set("file", output.string()).set("as", options.kind).set("mesh", options.mesh.value_or(kRefined));
  json.set("weights", options.weights.value_or(kRefitted)).set("joints", report.joints);
  json.set("line_joints", report.lineJoints).set("rigid_helpers", report.rigidHelpers);
  json.set("vertices", static_cast<long long>(report.vertices));
  json.set("triangles", static_cast<long long>(report.triangles));
  json.set("bytes", static_cast<long long>(report.bytes));
  json.set("error_percent_of_height", std::move(error)).set("left_out", linesOf(report.left));
  return json.dump(true) + '\n';
}

std::string addedText(const SkinnedExportReport& report) {
  const int added = report.lineJoints + report.rigidHelpers;
  if (added == 0) return {};
  return " (" + std::to_string(added) + " added: " + std::to_string(report.lineJoints) + " of muscle lines, " +
         std::to_string(report.rigidHelpers) + " rigid)";
}

std::string plainText(const ExportOptions& options, const std::filesystem::path& output,
                      const SkinnedExportReport& report) {
  std::ostringstream out;
  out << output.string() << '\n';
  out << "  " << options.mesh.value_or(kRefined) << " mesh, " << options.weights.value_or(kRefitted)
      << " weights: " << report.joints << " joints" << addedText(report) << ", " << report.vertices << " vertices, "
      << report.triangles << " triangles, " << report.bytes << " bytes\n";
  out << kHeader;
  for (const ClipError& clip : report.clips) writeRow(out, '"' + clip.clip + '"', clip.error);
  if (report.clips.size() > 1) writeRow(out, "all clips", report.allClips);
  for (const ClipError& clip : report.further) writeRow(out, '(' + clip.clip + ')', clip.error);
  writeRow(out, "fitted poses", report.fitted);
  writeRow(out, "held-out poses", report.heldOut);
  writeLeft(out, report.left);
  return out.str();
}

std::string jsonText(const ExportOptions& options, const std::filesystem::path& output,
                     const BakedExportReport& report) {
  const BakedExportSettings settings = bakedSettings(options);
  const bool arePoints = isBakedPointsName(output);
  Json json = Json::object();
  json.set("file", output.string()).set("as", options.kind).set("clip", settings.clip);
  json.set("fps", settings.framesPerSecond).set("frames", report.frames);
  if (!arePoints) {
    json.set("weights", options.weights.value_or(kRefitted)).set("bound", settings.bound);
    json.set("targets", report.targets).set("joints", report.joints);
  }
  json.set("vertices", static_cast<long long>(report.vertices));
  json.set("triangles", static_cast<long long>(report.triangles));
  json.set("bytes", static_cast<long long>(report.bytes));
  if (!arePoints) {
    Json error = Json::object();
    error.set("skinned", jsonOf(report.skinned)).set("baked", jsonOf(report.baked));
    json.set("error_percent_of_height", std::move(error));
  }
  json.set("left_out", linesOf(report.left));
  return json.dump(true) + '\n';
}

std::string plainText(const ExportOptions& options, const std::filesystem::path& output,
                      const BakedExportReport& report) {
  const BakedExportSettings settings = bakedSettings(options);
  std::ostringstream out;
  out << output.string() << "\n  \"" << settings.clip << "\": " << report.frames << " frames, "
      << settings.framesPerSecond << " a second; ";
  if (isBakedPointsName(output)) {
    out << report.vertices << " vertices, " << report.triangles << " triangles, " << report.bytes
        << " bytes in all files\n";
    writeLeft(out, report.left);
    return out.str();
  }
  out << report.targets << " targets, " << report.joints << " joints, " << report.vertices << " vertices, "
      << report.triangles << " triangles, " << report.bytes << " bytes\n"
      << kHeader;
  writeRow(out, "joints alone", report.skinned);
  writeRow(out, "baked", report.baked);
  out << "  bound" << std::setw(55) << settings.bound << '\n';
  if (report.targets > kTargetsAtOnce) {
    out << "  hint: some engines blend " << kTargetsAtOnce << " targets at most; a looser --bound needs fewer\n";
  }
  writeLeft(out, report.left);
  return out.str();
}

}  // namespace

std::string reportText(const ExportOptions& options, const std::filesystem::path& output,
                       const SkinnedExportReport& report) {
  return options.json ? jsonText(options, output, report) : plainText(options, output, report);
}

std::string reportText(const ExportOptions& options, const std::filesystem::path& output,
                       const BakedExportReport& report) {
  return options.json ? jsonText(options, output, report) : plainText(options, output, report);
}

}  // namespace sinew::app
