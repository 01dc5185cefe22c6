// core/rig/references.cpp: references follow a new name.
#include "core/rig/references.h"

namespace sinew {

void renameReferences(Rig& rig, Named kind, const std::string& from, const std::string& to) {
  eachReference(rig, [&](Named named, std::string& name) {
    if (named == kind && name == from) name = to;
  });
}

}  // namespace sinew
