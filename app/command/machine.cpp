// app/command/machine.cpp: which machine and which build the figures of a benchmark are of.
#include "app/command/machine.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>

#include <sched.h>

#include "app/ui/data_files.h"
#include "core/geometry/instruction_set.h"

namespace sinew::app {
namespace {

int usableThreads() {
  cpu_set_t set;
  CPU_ZERO(&set);
  return ::sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
}

std::string compilerName() {
#ifdef __clang__
  return __VERSION__;  // Begins with its name.
#else
  return std::string("GCC ") + __VERSION__;
#endif
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

}  // namespace

std::string processorName(std::istream& cpuinfo) {
  for (std::string line; std::getline(cpuinfo, line);) {
    const std::size_t colon = line.find(':');
    if (!line.starts_with("model name") || colon == std::string::npos) continue;
    if (std::string name = trimmed(line.substr(colon + 1)); !name.empty()) return name;
  }
  return "unknown";
}

Machine machineHere() {
  Machine machine;
  std::ifstream cpuinfo("/proc/cpuinfo");
  machine.processor = processorName(cpuinfo);
  for (const InstructionSet set : availableInstructionSets()) machine.instructionSets.emplace_back(nameOf(set));
  machine.threads = usableThreads();
  if (::getloadavg(&machine.load, 1) < 1) machine.load = 0.0;
  machine.compiler = compilerName();
  const std::string build = trimmed(SINEW_BUILD_TYPE);
  machine.buildType = build.empty() ? "none" : build;
#ifndef NDEBUG
  machine.assertions = true;
#endif
  machine.version = programVersion();
  return machine;
}

Json jsonOf(const Machine& machine) {
  Json sets = Json::array();
  for (const std::string& set : machine.instructionSets) sets.push(set);
  Json json = Json::object();
  json.set("processor", machine.processor).set("instruction_sets", std::move(sets)).set("threads", machine.threads);
  json.set("load", machine.load);
  json.set("compiler", machine.compiler).set("build_type", machine.buildType).set("assertions", machine.assertions);
  json.set("version", machine.version);
  return json;
}

std::string textOf(const Machine& machine) {
  char load[32];
  std::snprintf(load, sizeof load, "%.1f", machine.load);
  std::string sets;
  for (const std::string& set : machine.instructionSets) sets += (sets.empty() ? "" : " ") + set;
  return "sinew " + machine.version + ", built with " + machine.compiler + ", build type " + machine.buildType +
         (machine.assertions ? ", assertions on\n" : "\n") + machine.processor + ", " +
         std::to_string(machine.threads) + (machine.threads == 1 ? " thread" : " threads") + ", load " + load +
         ", sets: " + sets + '\n';
}

}  // namespace sinew::app
