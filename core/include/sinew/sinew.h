// core/include/sinew/sinew.h: headers for most programs: load a rig, import its character, pose it, smooth it, write
// the surface. Exports for games have their own headers in sinew/files.
#pragma once

#include "sinew/character/character.h"
#include "sinew/character/character_pose.h"
#include "sinew/character/node_locals.h"
#include "sinew/character/pose.h"
#include "sinew/character/pose_check.h"
#include "sinew/files/gltf_import.h"
#include "sinew/files/rig_json.h"
#include "sinew/files/surface_export.h"
#include "sinew/geometry/result.h"
#include "sinew/geometry/threads.h"
#include "sinew/geometry/version.h"
#include "sinew/rig/rig.h"
#include "sinew/surface/crowd_smoother.h"
#include "sinew/surface/smoother.h"
