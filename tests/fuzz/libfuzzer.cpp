// tests/fuzz/libfuzzer.cpp: a target as libFuzzer calls it. Compiled once for each, with its function in
// SINEW_FUZZ_TARGET.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/gltf_mutator.h"

// libFuzzer's own change of bytes, in place. @return the new size
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  sinew::fuzz::SINEW_FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned int seed) {
  const auto mutateBytes = [](std::string bytes, std::size_t mostBytes) {
    const std::size_t before = bytes.size();
    bytes.resize(std::max(before, mostBytes));
    bytes.resize(LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(bytes.data()), before, bytes.size()));
    return bytes;
  };
  const std::string out = sinew::fuzz::mutated({reinterpret_cast<const char*>(data), size}, most, seed, mutateBytes);
  const std::size_t count = std::min(out.size(), most);
  std::copy_n(out.begin(), count, data);
  return count;
}
