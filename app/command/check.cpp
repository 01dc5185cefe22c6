// app/command/check.cpp: `sinew check`: problems of a rig's muscles in all clips and the range of motion, and mending.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/command/console.h"
#include "app/command/verbs.h"
#include "app/document/document.h"
#include "core/bodies/check.h"
#include "core/bodies/cloth_check.h"
#include "core/bodies/mend.h"
#include "core/files/json/json.h"
#include "core/geometry/at.h"

namespace sinew::app {
namespace {

struct CheckOptions {
  std::filesystem::path file;
  std::filesystem::path output;  ///< For the mended rig; empty: only check.
  bool json = false;
  bool strict = false;
  bool cloth = false;
};

void addCheckOptions(CLI::App& verb, CheckOptions& options) {
  addPath(verb, "RIG", options.file, "Rig (.rig.json)")->required();
  verb.add_flag("--json", options.json, "JSON instead of text");
  verb.add_flag("--strict", options.strict, "Exit status 1 if anything is found, after mending if that is asked for");
  verb.add_flag("--cloth", options.cloth,
                "Count the vertices of cloth that are below the skin, with and without muscles; takes a while");
  addPath(verb, "--mend", options.output, "Mend the lines with findings, and write the rig there")
      ->type_name("OUT.rig.json");
}

Json jsonOf(const Rig& rig, const std::vector<Finding>& findings) {
  return jsonList(findings, [&](const Finding& finding) {
    Json item = Json::object();
    item.set("muscle", at(rig.primitives, finding.primitive).name).set("kind", std::string(nameOf(finding.kind)));
    item.set("clip", finding.clip).set("time", finding.time).set("measure", finding.measure);
    return item.set("text", textOf(finding));
  });
}

std::string whenOf(const Finding& finding) {
  if (finding.clip.empty()) return "bind pose";
  char time[32];
  std::snprintf(time, sizeof time, " %.2f s", static_cast<double>(finding.time));
  return finding.clip + time;
}

void put(std::ostream& out, const Rig& rig, const std::vector<Finding>& findings) {
  for (const Finding& finding : findings) {
    out << "  " << at(rig.primitives, finding.primitive).name << ": " << textOf(finding) << " (" << whenOf(finding)
        << ")\n";
  }
}

std::string countText(const std::vector<Finding>& findings) {
  if (findings.empty()) return "nothing found";
  return std::to_string(findings.size()) + (findings.size() == 1 ? " finding" : " findings");
}

/// "cloth: 0 of 3120 vertices below the skin beyond those the file has ..."
std::string textOf(const ClothCount& count, std::size_t poses) {
  if (count.vertices == 0) return "cloth: none\n";
  char deepest[48] = "";
  std::string seen;
  if (count.more > 0) {
    std::snprintf(deepest, sizeof deepest, ", %.2f %% of the height at most",
                  100.0 * static_cast<double>(count.deepest));
    seen = "; " + (count.seen == 0 ? std::string("none") : std::to_string(count.seen)) + " of them in sight";
  }
  return "cloth: " + std::to_string(count.more) + " vertices are below the skin that are not without muscles" +
         deepest + seen + "; " + std::to_string(count.below) + " with muscles, " + std::to_string(count.bare) +
         " without (" + std::to_string(count.vertices) + " vertices, " + std::to_string(poses) + " poses)\n";
}

Json jsonOf(const ClothCount& count) {
  return Json::object()
      .set("vertices", count.vertices)
      .set("below", static_cast<double>(count.below))
      .set("below_without_muscles", static_cast<double>(count.bare))
      .set("more", static_cast<double>(count.more))
      .set("in_sight", static_cast<double>(count.seen))
      .set("deepest", count.deepest);
}

int runCheck(const CheckOptions& options) {
  Result<Document> opened = openDocument(options.file);
  if (!opened) return badInput(opened.error());
  Document& document = opened.value();
  if (document.rigFile.empty()) return badInput({options.file.string(), "", "expected a rig: this is a character"});
  const Motions motions(document.character);
  std::vector<Finding> findings = check(document.rig(), motions);
  const auto clips = motions.character().clips.size();
  std::ostringstream text;
  text << options.file.string() << ": " << countText(findings) << " in " << motions.poses().size() << " poses of "
       << clips << (clips == 1 ? " clip\n" : " clips\n");
  put(text, document.rig(), findings);
  Json json = Json::object();
  std::int64_t sunk = 0;  // In sight.
  if (options.cloth) {
    const Result<ClothCount> count = countClothBelow(document.character, document.rig(), motions.poses());
    if (!count) return badInput(count.error());
    text << "  " << textOf(count.value(), motions.poses().size());
    json.set("cloth", jsonOf(count.value()));
    sunk = count->seen;
  }
  json.set("poses", static_cast<int>(motions.poses().size())).set("findings", jsonOf(document.rig(), findings));
  if (!options.output.empty()) {
    Result<MendedRig> mended = withMendedRig(document.rig(), 0, motions, document.mirror.get());
    if (!mended) return badInput(mended.error());
    findings = check(mended->rig, motions);
    json.set("left", jsonOf(mended->rig, findings));
    for (const std::string& said : mended->said) text << "  mended " << said << '\n';
    json.set("mended", jsonList(mended->said));
    text << "after mending: " << countText(findings) << '\n';
    put(text, mended->rig, findings);
    document.commands.apply("Mend", std::move(mended.value().rig));
    if (const auto saved = saveDocument(document, options.output); !saved) return badInput(saved.error());
  }
  const int put = putResult(options.json ? json.dump(true) + '\n' : text.str());
  if (put != kDone) return put;
  return options.strict && (!findings.empty() || sunk > 0) ? kBadInput : kDone;
}

}  // namespace

Verb checkRigVerb() {
  return makeVerb<CheckOptions>("check", "Find muscles that leave the flesh, and mend them", addCheckOptions, runCheck);
}

}  // namespace sinew::app
