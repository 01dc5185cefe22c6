// core/bodies/mend_rig.cpp: lines, then bellies, then territories.
#include "core/bodies/mend_rig.h"

#include <algorithm>
#include <utility>

#include "core/bodies/mend_belly.h"
#include "core/geometry/at.h"
#include "core/rig/twins.h"

namespace sinew {

std::vector<Finding> findingsFrom(const Rig& rig, std::size_t first, const Motions& motions) {
  std::vector<Finding> findings = check(rig, motions);
  std::erase_if(findings, [&](const Finding& finding) { return static_cast<std::size_t>(finding.primitive) < first; });
  return findings;
}

Result<MendedRig> withMendedRig(Rig rig, std::size_t first, const Motions& motions, const MirrorPlan* plan) {
  const std::vector<Finding> found = findingsFrom(rig, first, motions);
  if (found.empty()) return MendedRig{std::move(rig), {}};
  Result<MendedRig> lines = withMendedFindings(std::move(rig), found, motions, plan);
  if (!lines) return lines;
  MendedRig mended = std::move(lines).value();
  std::vector<int> done;
  for (const Finding& finding : findingsFrom(mended.rig, first, motions)) {
    const std::string name = at(mended.rig.primitives, finding.primitive).name;
    const int twin = plan == nullptr ? -1 : twinOf(mended.rig, finding.primitive);
    const bool twinDone = twin >= 0 && std::ranges::find(done, twin) != done.end();
    if (finding.kind == FindingKind::kReachesAcross) {
      mended.rig = withoutFarSkin(std::move(mended.rig), finding, plan);
      // Of twins the first is named.
      if (twin < 0 || finding.primitive < twin) mended.said.push_back(name + ": does not move skin of " + finding.bone);
    } else if (!twinDone && std::ranges::find(done, finding.primitive) == done.end()) {
      done.push_back(finding.primitive);
      Result<MendedBelly> belly = withMendedBelly(std::move(mended.rig), finding.primitive, motions, plan);
      if (!belly) return belly.error();
      mended.rig = std::move(belly.value().rig);
      if (belly->said.empty()) continue;
      // What was done to its line counts no more.
      const std::string twinName = twin >= 0 ? at(mended.rig.primitives, twin).name : name;
      std::erase_if(mended.said, [&](const std::string& said) {
        return said.starts_with(name + ": ") || said.starts_with(twinName + ": ");
      });
      mended.said.push_back(name + ": " + belly->said);
    }
  }
  return mended;
}

}  // namespace sinew
