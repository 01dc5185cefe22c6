// app/cli/export.cpp: open, fit, write for other programs, report.
#include <filesystem>
#include <memory>

#include "app/cli/console.h"
#include "app/cli/export_verb.h"
#include "app/cli/verb.h"
#include "app/document/document.h"
#include "core/rig/attachment.h"
#include "core/symmetry/motion_clip.h"
#include "sinew/base/threads.h"

namespace sinew::app {
namespace {

int exportInput(const ExportOptions& options, const BatchInput& input) {
  const std::filesystem::path& output = input.outputs.front();
  progress("reading " + input.file.string());
  const auto document = openDocument(input.file);
  if (!document) return badInput(document.error());
  Rig rig = document->rig();
  if (options.depth) rig.smoothing.depth = *options.depth;
  if (const auto missing = missingBones(rig, document->character->skeleton); !missing.empty()) {
    return badInput({input.file.string(), missing.front().place, missing.front().reason});
  }
  progress("exporting " + output.string());
  const auto put = [&](const auto& report) {
    return report ? putResult(reportText(options, output, report.value())) : badInput(report.error());
  };
  if (options.kind == "baked") {
    const BakedExportSettings settings = bakedSettings(options);
    // A clip made in memory has a place among points, but none in a file of clips.
    const auto character = isBakedPointsName(output) ? withClipNamed(document->character, settings.clip)
                                                     : std::shared_ptr<const Character>(document->character);
    return put(exportBaked(document->characterFile, character, rig, settings, output));
  }
  const auto moving = withRangeOfMotion(document->character);
  return put(
      exportSkinned(document->characterFile, document->character, *moving, rig, skinnedSettings(options), output));
}

int runExport(const ExportOptions& options) {
  if (const auto fits = checkExportOptions(options); !fits) return refused(fits.error());
  const auto batch = planBatch(options.batch, options.file, options.output);
  if (!batch) return refused(batch.error());
  const ThreadLimit limit(options.threads);
  return runBatch(batch.value(), options.batch.dryRun,
                  [&](const BatchInput& input) { return exportInput(options, input); });
}

}  // namespace

Verb exportVerb() {
  return makeVerb<ExportOptions>("export", "Write the character for games", addExportOptions, runExport);
}

}  // namespace sinew::app
