// tests/install/subproject/public_header.cpp: what a project may include.
#include "sinew/sinew.h"

int bones(const sinew::Character& character) { return static_cast<int>(character.skeleton.bones.size()); }
