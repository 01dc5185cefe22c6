// tests/fuzz/gltf_mutator.h: changes that leave a file readable enough to get far into the import.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace sinew::fuzz {

/// Other bytes, at most so many.
using MutateBytes = std::function<std::string(std::string bytes, std::size_t most)>;

/// A .glb: its JSON by meaning (a number, a key, an element), its JSON as text, or its binary chunk, with lengths that
/// are right again; now and then the whole file as bytes. Other JSON: by meaning or as bytes.
/// @return at most `most` bytes
[[nodiscard]] std::string mutated(std::string_view bytes, std::size_t most, unsigned seed,
                                  const MutateBytes& mutateBytes);

}  // namespace sinew::fuzz
