// tests/fuzz/write_seeds.cpp: writes the seeds of all targets. Usage: fuzz_seeds FOLDER

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/seeds.h"

int main(int count, char** arguments) {
  if (count != 2) {
    std::fputs("usage: fuzz_seeds FOLDER\n", stderr);
    return 2;
  }
  for (const sinew::fuzz::Target& target : sinew::fuzz::allTargets()) {
    const std::filesystem::path folder = std::filesystem::path(arguments[1]) / target.name;
    std::filesystem::create_directories(folder);
    for (const sinew::fuzz::Seed& seed : sinew::fuzz::seedsOf(target.name)) {
      std::ofstream out(folder / seed.name, std::ios::binary);
      out.write(seed.bytes.data(), static_cast<std::streamsize>(seed.bytes.size()));
      if (!out.flush()) {
        std::fprintf(stderr, "fuzz_seeds: cannot write %s\n", (folder / seed.name).c_str());
        return 1;
      }
    }
  }
  return 0;
}
