// core/include/sinew/sinew.h: what most programs need: load a rig, import its character, pose it, smooth it, write the
// surface. Exports for games (sinew/export) are headers of their own.
#pragma once

#include "sinew/base/result.h"
#include "sinew/base/threads.h"
#include "sinew/base/version.h"
#include "sinew/character/character.h"
#include "sinew/character/character_pose.h"
#include "sinew/character/pose_check.h"
#include "sinew/io/gltf_import.h"
#include "sinew/io/rig_json.h"
#include "sinew/io/surface_export.h"
#include "sinew/rig/rig.h"
#include "sinew/skeleton/node_locals.h"
#include "sinew/skeleton/pose.h"
#include "sinew/smoothing/crowd_smoother.h"
#include "sinew/smoothing/smoother.h"
