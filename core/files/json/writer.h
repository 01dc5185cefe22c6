// core/files/json/writer.h: JSON objects in the making.
#pragma once

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "core/files/json/json.h"

namespace sinew {

inline Json numbers(std::initializer_list<float> values) {
  std::vector<Json> items;
  for (const float value : values) items.push_back(value);
  return Json::array(std::move(items));
}

/// An object in the making: known keys in order, then the unknown ones it came with.
class ObjectWriter {
 public:
  ObjectWriter& set(const char* key, Json value) {
    value.key = key;
    object_.children.push_back(std::move(value));
    return *this;
  }

  Json finish(const std::string& unknownKeys) {
    if (unknownKeys.empty()) return std::move(object_);
    auto unknown = Json::parse(unknownKeys);
    if (!unknown) return std::move(object_);
    for (Json& child : unknown.value().children) {
      if (!object_.find(child.key)) object_.children.push_back(std::move(child));
    }
    return std::move(object_);
  }

 private:
  Json object_ = Json::object();
};

}  // namespace sinew
