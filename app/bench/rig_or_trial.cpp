// app/bench/rig_or_trial.cpp: what is measured of a file.
#include "app/bench/rig_or_trial.h"

#include "app/bench/trial_rig.h"

namespace sinew::app {
namespace {

constexpr int kTrialMuscles = 12;
constexpr std::uint64_t kTrialSeed = 1;

}  // namespace

Rig rigOrTrial(const Document& document) {
  if (!document.rig().primitives.empty()) return document.rig();
  return trialRig(*document.character, kTrialMuscles, kTrialSeed);
}

std::string sceneName(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  return name.substr(0, name.find('.', 1));
}

}  // namespace sinew::app
