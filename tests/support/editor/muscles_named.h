// tests/support/editor/muscles_named.h: a document's muscles by name.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "app/document/document.h"

namespace sinew::app {

/// Fails the test if there is none of that name.
inline PrimitiveId idOf(const Document& document, const std::string& name) {
  const int index = findPrimitive(document.rig(), name);
  EXPECT_GE(index, 0) << name;
  return index < 0 ? PrimitiveId{} : document.idAt(index);
}

/// In order of picking: the last is the active one.
inline void select(Document& document, const std::vector<std::string>& names) {
  document.selection.primitives.clear();
  for (const std::string& name : names) document.selection.primitives.push_back(idOf(document, name));
}

inline std::vector<std::string> selectedNames(const Document& document) {
  std::vector<std::string> names;
  for (const PrimitiveId id : document.selection.primitives) {
    const int index = findPrimitive(document.rig(), id);
    names.push_back(index < 0 ? "(gone)" : document.rig().primitives[static_cast<std::size_t>(index)].name);
  }
  return names;
}

}  // namespace sinew::app
