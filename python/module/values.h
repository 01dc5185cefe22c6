// python/module/values.h: what Python passes, checked: numbers, texts, paths, vectors, matrices. A refusal says what
// was expected and what was got.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/pybind11.h>

#include "sinew/character/skeleton.h"
#include "sinew/geometry/geometry.h"

namespace sinew::python {

/// A finite number that floats hold. @param place  what it is, for the refusal: "reach"
[[nodiscard]] float numberFrom(pybind11::handle value, const std::string& place);
[[nodiscard]] double doubleFrom(pybind11::handle value, const std::string& place);
[[nodiscard]] int integerFrom(pybind11::handle value, const std::string& place);
/// 0: all cores.
[[nodiscard]] int threadsFrom(pybind11::handle value);
[[nodiscard]] bool truthFrom(pybind11::handle value, const std::string& place);
[[nodiscard]] std::string textFrom(pybind11::handle value, const std::string& place);
/// str, bytes or os.PathLike.
[[nodiscard]] std::filesystem::path pathFrom(pybind11::handle value, const std::string& place);
/// As Python has paths, whatever bytes they are.
[[nodiscard]] pybind11::str pathText(const std::filesystem::path& path);
/// As many finite numbers.
[[nodiscard]] std::vector<float> numbersFrom(pybind11::handle value, std::size_t count, const std::string& place);
[[nodiscard]] glm::vec3 vectorFrom(pybind11::handle value, const std::string& place);
/// x, y, z, w, as rig files have it; made unit. Refused where it is too far from unit length.
[[nodiscard]] glm::quat rotationFrom(pybind11::handle value, const std::string& place);
/// Texts of a list or tuple.
[[nodiscard]] std::vector<std::string> textsFrom(pybind11::handle value, const std::string& place);
/// Numbers by name, in the order of the dict. @param place  "shapes"
[[nodiscard]] std::vector<std::pair<std::string, float>> numbersByName(pybind11::handle value,
                                                                       const std::string& place);

/// [bones, 4, 4] of a skeleton, bone -> world, as matrices that multiply columns.
[[nodiscard]] std::vector<glm::mat4> bonesFrom(pybind11::handle value, const Skeleton& skeleton);

/// What a value is, in words: "a str", "shape (3, 4)".
[[nodiscard]] std::string kindOf(pybind11::handle value);

}  // namespace sinew::python
