// tests/smoothing/coherence_ceilings.h: how often and how far the skin stepped over 1 % H when this was last recorded.
#pragma once

#include <array>

#include "tests/support/surface/coherence.h"

namespace sinew::test {

/// Whose muscles a scene wears.
enum class Laid {
  kOwn,     ///< The rig that ships with the bundled scene.
  kTrial,   ///< trialRig: as a first try would set them, half buried, some across joints.
  kBedded,  ///< beddedRig: as a careful designer lays them, in the flesh of one bone.
};

/// The far steps of one cause.
struct Recorded {
  const char* scene;
  Laid laid;
  SurfaceMode mode;
  StepCause cause;
  double perMillion;  ///< Vertex steps.
  double largest;     ///< Fraction of H.
};

using enum Laid;
using enum SurfaceMode;
using enum StepCause;

/// A walk that is not named here takes no far step at all. To record anew, run `smoothing_tests
/// --gtest_filter='*Coherence*'`, which prints these rows.
constexpr std::array kRecorded{
    Recorded{"wrapped", kOwn, kSwell, kFolds, 31.05, 0.0137},
    Recorded{"wrapped", kOwn, kReplace, kShares, 196.64, 0.0772},
    Recorded{"wrapped", kOwn, kReplace, kOverhang, 113.84, 0.0473},
    Recorded{"wrapped", kOwn, kReplace, kMuscle, 175.94, 0.0139},
    Recorded{"wrapped", kOwn, kReplace, kSteepFlank, 20.70, 0.0220},
    Recorded{"tangle", kOwn, kSwell, kFolds, 158.19, 0.0355},
    Recorded{"tangle", kOwn, kSwell, kOverhang, 200.63, 0.0468},
    Recorded{"tangle", kOwn, kSwell, kMuscle, 297.09, 0.0182},
    Recorded{"tangle", kOwn, kSwell, kSteepFlank, 146.62, 0.0282},
    Recorded{"tangle", kOwn, kReplace, kFolds, 108.03, 0.0639},
    Recorded{"tangle", kOwn, kReplace, kCrossing, 1034.02, 0.1009},
    Recorded{"tangle", kOwn, kReplace, kShares, 906.70, 0.0755},
    Recorded{"tangle", kOwn, kReplace, kOverhang, 46.30, 0.0576},
    Recorded{"tangle", kOwn, kReplace, kMuscle, 196.77, 0.0194},
    Recorded{"tangle", kOwn, kReplace, kSteepFlank, 57.87, 0.0193},
    Recorded{"Fox", kTrial, kSwell, kFolds, 189.09, 0.0242},
    Recorded{"Fox", kTrial, kSwell, kOverhang, 2.44, 0.0122},
    Recorded{"Fox", kTrial, kSwell, kMuscle, 14.64, 0.0151},
    Recorded{"Fox", kTrial, kSwell, kSteepFlank, 9.76, 0.0297},
    Recorded{"Fox", kTrial, kReplace, kFolds, 113.46, 0.0265},
    Recorded{"Fox", kTrial, kReplace, kCrossing, 7.32, 0.0315},
    Recorded{"Fox", kTrial, kReplace, kShares, 1.22, 0.0106},
    Recorded{"Fox", kTrial, kReplace, kMuscle, 3.66, 0.0127},
    Recorded{"greenman", kTrial, kReplace, kCrossing, 30.95, 0.0173},
    Recorded{"cesium_man", kTrial, kSwell, kFolds, 22.38, 0.0296},
    Recorded{"cesium_man", kTrial, kSwell, kOverhang, 10.39, 0.0459},
    Recorded{"cesium_man", kTrial, kSwell, kMuscle, 2.00, 0.0318},
    Recorded{"cesium_man", kTrial, kSwell, kSteepFlank, 4.00, 0.0305},
    Recorded{"cesium_man", kTrial, kReplace, kFolds, 11.19, 0.0427},
    Recorded{"cesium_man", kTrial, kReplace, kOverhang, 4.00, 0.0128},
    Recorded{"cesium_man", kTrial, kReplace, kMuscle, 0.80, 0.0317},
    Recorded{"robot", kTrial, kSwell, kOverhang, 1.27, 0.0192},
    Recorded{"robot", kTrial, kSwell, kMuscle, 33.19, 0.0235},
    Recorded{"robot", kTrial, kSwell, kSteepFlank, 1.32, 0.0201},
    Recorded{"robot", kTrial, kReplace, kCrossing, 17.60, 0.0419},
    Recorded{"robot", kTrial, kReplace, kRoots, 1.15, 0.0227},
    Recorded{"robot", kTrial, kReplace, kShares, 5.18, 0.0339},
    Recorded{"robot", kTrial, kReplace, kOverhang, 0.69, 0.0158},
    Recorded{"robot", kTrial, kReplace, kMuscle, 4.31, 0.0241},
    Recorded{"Fox", kBedded, kSwell, kFolds, 37.82, 0.0176},
    Recorded{"Fox", kBedded, kReplace, kFolds, 12.20, 0.0136},
    Recorded{"greenman", kBedded, kReplace, kCrossing, 4.42, 0.0215},
};

}  // namespace sinew::test
