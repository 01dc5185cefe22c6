// app/document/task_needs.h: how much memory and how many cores a task of a farm job takes.
#pragma once

#include <memory>
#include <string>

#include "sinew/character/character.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew::app {

struct TaskNeeds {
  int cores = 1;
  int megabytes = 0;  ///< At its most.
};

/// Of one input. More cores than one are asked for where the verb is told to use them: many tasks on a core each make
/// more of a machine than few on several.
/// @param verb  "smooth", "export" or "render"  @param rig  with what the command line changes
/// @param threads  of --threads; 0: not said
/// @param heldFrames  of a clip that is held in memory as a whole
/// Error: the rig does not fit the character.
[[nodiscard]] Result<TaskNeeds> taskNeeds(const std::string& verb, const std::shared_ptr<const Character>& character,
                                          const Rig& rig, int threads, double heldFrames = 0.0);

/// What both can be made with.
[[nodiscard]] TaskNeeds larger(const TaskNeeds& a, const TaskNeeds& b);

}  // namespace sinew::app
