// core/include/sinew/runtime/runtime.h: all that Sinew::runtime has for C++.
#pragma once

#include "sinew/base/result.h"
#include "sinew/base/task_system.h"
#include "sinew/base/threads.h"
#include "sinew/base/version.h"
#include "sinew/character/character.h"
#include "sinew/character/character_pose.h"
#include "sinew/character/pose_check.h"
#include "sinew/rig/rig.h"
#include "sinew/rig/rig_edit.h"
#include "sinew/runtime/game_file.h"
#include "sinew/runtime/vertex_buffer.h"
#include "sinew/skeleton/local_pose.h"
#include "sinew/skeleton/pose.h"
#include "sinew/smoothing/crowd_smoother.h"
#include "sinew/smoothing/smoother.h"
#include "sinew/symmetry/mirror_edit.h"
