// tests/surface/coherence_ceilings.h: recorded number and size of skin steps over 1 % H.
#pragma once

#include <array>

#include "tests/support/surface/coherence.h"

namespace sinew::test {

/// Which muscles a scene has.
enum class Laid {
  kOwn,     ///< Rig of the bundled scene.
  kTrial,   ///< trialRig: like a first attempt, half buried, some across joints.
  kBedded,  ///< beddedRig: like a careful designer's, in the flesh of one bone.
};

/// Steps over 1 % H with one cause.
struct Recorded {
  const char* scene;
  Laid laid;
  SurfaceMode mode;
  StepCause cause;
  double perMillion;  ///< Per vertex step.
  double largest;     ///< Fraction of H.
};

using enum Laid;
using enum SurfaceMode;
using enum StepCause;

/// A walk that is not listed has no such step. To record again, run `surface_tests --gtest_filter='*Coherence*'`, which
/// prints these rows.
constexpr std::array kRecorded{
    Recorded{"wrapped", kOwn, kSwell, kFolds, 72.45, 0.0162},
    Recorded{"wrapped", kOwn, kReplace, kShares, 196.64, 0.0772},
    Recorded{"wrapped", kOwn, kReplace, kOverhang, 113.84, 0.0473},
    Recorded{"wrapped", kOwn, kReplace, kMuscle, 175.94, 0.0139},
    Recorded{"wrapped", kOwn, kReplace, kSteepFlank, 20.70, 0.0220},
    Recorded{"tangle", kOwn, kSwell, kFolds, 65.59, 0.0155},
    Recorded{"tangle", kOwn, kSwell, kOverhang, 77.17, 0.0284},
    Recorded{"tangle", kOwn, kSwell, kMuscle, 270.08, 0.0181},
    Recorded{"tangle", kOwn, kSwell, kSteepFlank, 77.17, 0.0230},
    Recorded{"tangle", kOwn, kReplace, kFolds, 1504.73, 0.0449},
    Recorded{"tangle", kOwn, kReplace, kCrossing, 1034.02, 0.0536},
    Recorded{"tangle", kOwn, kReplace, kShares, 879.69, 0.0383},
    Recorded{"tangle", kOwn, kReplace, kOverhang, 46.30, 0.0391},
    Recorded{"tangle", kOwn, kReplace, kMuscle, 169.76, 0.0183},
    Recorded{"tangle", kOwn, kReplace, kSteepFlank, 30.87, 0.0158},
    Recorded{"Fox", kTrial, kSwell, kFolds, 14.64, 0.0128},
    Recorded{"Fox", kTrial, kSwell, kMuscle, 6.10, 0.0149},
    Recorded{"Fox", kTrial, kReplace, kFolds, 18.30, 0.0129},
    Recorded{"Fox", kTrial, kReplace, kCrossing, 7.32, 0.0126},
    Recorded{"greenman", kTrial, kReplace, kCrossing, 30.95, 0.0173},
    Recorded{"cesium_man", kTrial, kSwell, kMuscle, 0.80, 0.0137},
    Recorded{"robot", kTrial, kSwell, kOverhang, 0.46, 0.0159},
    Recorded{"robot", kTrial, kSwell, kMuscle, 22.09, 0.0225},
    Recorded{"robot", kTrial, kSwell, kSteepFlank, 0.12, 0.0110},
    Recorded{"robot", kTrial, kReplace, kCrossing, 5.81, 0.0178},
    Recorded{"robot", kTrial, kReplace, kShares, 0.92, 0.0183},
    Recorded{"robot", kTrial, kReplace, kOverhang, 0.40, 0.0147},
    Recorded{"robot", kTrial, kReplace, kMuscle, 3.16, 0.0173},
    Recorded{"Fox", kBedded, kSwell, kFolds, 2.44, 0.0110},
    Recorded{"greenman", kBedded, kReplace, kCrossing, 4.42, 0.0215},
};

}  // namespace sinew::test
