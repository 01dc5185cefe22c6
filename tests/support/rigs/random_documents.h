// tests/support/rigs/random_documents.h: rigs as in files: any floats, any names, keys of future versions.
#pragma once

#include <cstdint>

#include "sinew/rig/rig.h"

namespace sinew::test {

/// A valid rig that belongs to no character: floats over all magnitudes down to denormals, names in many scripts with
/// quotes and control characters, twins, territories, links, unknown keys at every level. Same seed, same rig.
[[nodiscard]] Rig randomDocument(std::uint64_t seed);

/// Bit for bit, where operator== takes 0 for -0.
[[nodiscard]] bool sameFloatBits(const Rig& a, const Rig& b);

}  // namespace sinew::test
