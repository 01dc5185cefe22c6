// python/module/values.cpp: what Python passes, checked.
#include "python/module/values.h"

#include <cmath>
#include <limits>
#include <string>

#include <pybind11/numpy.h>
#include <glm/gtc/quaternion.hpp>

#include "core/geometry/at.h"
#include "python/module/errors.h"

namespace sinew::python {
namespace {

namespace py = pybind11;

constexpr float kFarFromUnit = 1e-2f;
constexpr double kSameRow = 1e-5;  ///< Of the last row of a matrix, which says nothing of where a bone is.

std::string shapeText(const py::array& array) {
  std::string text = "(";
  for (py::ssize_t i = 0; i < array.ndim(); ++i) text += (i > 0 ? ", " : "") + std::to_string(array.shape(i));
  return text + (array.ndim() == 1 ? ",)" : ")");
}

std::string numberText(double number) { return py::repr(py::float_(number)).cast<std::string>(); }

/// Text and truth values are no numbers, although Python converts the latter.
bool isNumber(py::handle value) {
  return PyNumber_Check(value.ptr()) != 0 && PyBool_Check(value.ptr()) == 0 && PyComplex_Check(value.ptr()) == 0;
}

bool isText(py::handle value) { return PyUnicode_Check(value.ptr()) != 0 || PyBytes_Check(value.ptr()) != 0; }

std::string placeOfBone(const Skeleton& skeleton, std::size_t bone) {
  return "bones[" + std::to_string(bone) + "] (" + skeleton.fileName(static_cast<int>(bone)) + ')';
}

py::array_t<double, py::array::c_style | py::array::forcecast> matricesFrom(py::handle value,
                                                                            const Skeleton& skeleton) {
  const py::array given = py::array::ensure(value);
  if (!given) {
    PyErr_Clear();
    refuse("bones", "expected an array of numbers, got " + kindOf(value));
  }
  const char kind = given.dtype().kind();
  if (kind != 'f' && kind != 'i' && kind != 'u') {
    refuse("bones", "expected numbers, got an array of dtype " + std::string(py::str(given.dtype())));
  }
  const auto count = static_cast<py::ssize_t>(skeleton.bones.size());
  if (given.ndim() != 3 || given.shape(0) != count || given.shape(1) != 4 || given.shape(2) != 4) {
    refuse("bones",
           "expected the shape (" + std::to_string(count) + ", 4, 4), a matrix for each bone, got " + shapeText(given));
  }
  return {given};
}

}  // namespace

std::string kindOf(py::handle value) {
  if (value.is_none()) return "None";
  const std::string name = Py_TYPE(value.ptr())->tp_name;
  const std::string shortName = name.substr(name.find_last_of('.') + 1);
  const bool vowel = shortName.find_first_of("aeiouAEIOU") == 0;
  return (vowel ? "an " : "a ") + shortName;
}

double doubleFrom(py::handle value, const std::string& place) {
  if (!isNumber(value)) refuse(place, "expected a number, got " + kindOf(value));
  const double number = PyFloat_AsDouble(value.ptr());
  if (PyErr_Occurred() != nullptr) {
    PyErr_Clear();
    refuse(place, "expected a number, got " + kindOf(value));
  }
  if (!std::isfinite(number)) refuse(place, "expected a finite number, got " + numberText(number));
  return number;
}

float numberFrom(py::handle value, const std::string& place) {
  const double number = doubleFrom(value, place);
  if (std::abs(number) > static_cast<double>(std::numeric_limits<float>::max())) {
    refuse(place, "expected a number that a float of 32 bits holds, got " + std::string(py::str(value)));
  }
  return static_cast<float>(number);
}

int integerFrom(py::handle value, const std::string& place) {
  const py::object index = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
  if (!index || PyBool_Check(value.ptr()) != 0) {
    PyErr_Clear();
    refuse(place, "expected a whole number, got " + kindOf(value));
  }
  const long long number = PyLong_AsLongLong(index.ptr());
  if (PyErr_Occurred() != nullptr || number > std::numeric_limits<int>::max() ||
      number < std::numeric_limits<int>::min()) {
    PyErr_Clear();
    refuse(place, "expected a smaller whole number, got " + std::string(py::str(value)));
  }
  return static_cast<int>(number);
}

int threadsFrom(py::handle value) {
  const int threads = integerFrom(value, "threads");
  if (threads < 0) refuse("threads", "expected 0, for all cores, or more, got " + std::to_string(threads));
  return threads;
}

bool truthFrom(py::handle value, const std::string& place) {
  if (PyBool_Check(value.ptr()) == 0) refuse(place, "expected True or False, got " + kindOf(value));
  return value.ptr() == Py_True;
}

std::string textFrom(py::handle value, const std::string& place) {
  if (PyUnicode_Check(value.ptr()) == 0) refuse(place, "expected a str, got " + kindOf(value));
  Py_ssize_t length = 0;
  const char* const text = PyUnicode_AsUTF8AndSize(value.ptr(), &length);
  if (text == nullptr) {
    PyErr_Clear();
    refuse(place, "expected text that UTF-8 can hold");
  }
  return {text, static_cast<std::size_t>(length)};
}

std::filesystem::path pathFrom(py::handle value, const std::string& place) {
  PyObject* bytes = nullptr;
  if (PyUnicode_FSConverter(value.ptr(), &bytes) == 0) {
    const bool wrongType = PyErr_ExceptionMatches(PyExc_TypeError) != 0;
    PyErr_Clear();
    refuse(place, wrongType ? "expected a path, as str or os.PathLike, got " + kindOf(value)
                            : "expected a path that the file system can hold");
  }
  const py::object held = py::reinterpret_steal<py::object>(bytes);
  return std::string(PyBytes_AS_STRING(bytes), static_cast<std::size_t>(PyBytes_GET_SIZE(bytes)));
}

py::str pathText(const std::filesystem::path& path) {
  const std::string& bytes = path.native();
  PyObject* const text = PyUnicode_DecodeFSDefaultAndSize(bytes.data(), static_cast<Py_ssize_t>(bytes.size()));
  if (text == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::str>(text);
}

std::vector<float> numbersFrom(py::handle value, std::size_t count, const std::string& place) {
  const std::string expected = "expected " + std::to_string(count) + " numbers, got ";
  if (isText(value) || PyDict_Check(value.ptr()) != 0) refuse(place, expected + kindOf(value));
  const py::object items = py::reinterpret_steal<py::object>(PySequence_Fast(value.ptr(), ""));
  if (!items) {
    PyErr_Clear();
    refuse(place, expected + kindOf(value));
  }
  const auto got = static_cast<std::size_t>(PySequence_Fast_GET_SIZE(items.ptr()));
  if (got != count) refuse(place, expected + std::to_string(got));
  std::vector<float> numbers(count);
  for (std::size_t i = 0; i < count; ++i) {
    const py::handle item = PySequence_Fast_GET_ITEM(items.ptr(), static_cast<Py_ssize_t>(i));
    numbers[i] = numberFrom(item, place + '[' + std::to_string(i) + ']');
  }
  return numbers;
}

glm::vec3 vectorFrom(py::handle value, const std::string& place) {
  const std::vector<float> numbers = numbersFrom(value, 3, place);
  return {numbers[0], numbers[1], numbers[2]};
}

glm::quat rotationFrom(py::handle value, const std::string& place) {
  const std::vector<float> numbers = numbersFrom(value, 4, place);
  const glm::quat rotation(numbers[3], numbers[0], numbers[1], numbers[2]);
  const float length = glm::length(rotation);
  if (std::abs(length - 1.0f) > kFarFromUnit) {
    refuse(place, "expected a unit quaternion x, y, z, w, got one of length " + std::to_string(length));
  }
  // What is unit already keeps its bits.
  return std::abs(length - 1.0f) < 1e-6f ? rotation : glm::normalize(rotation);
}

std::vector<std::string> textsFrom(py::handle value, const std::string& place) {
  if (isText(value)) refuse(place, "expected a list of names, got " + kindOf(value));
  const py::object items = py::reinterpret_steal<py::object>(PySequence_Fast(value.ptr(), ""));
  if (!items) {
    PyErr_Clear();
    refuse(place, "expected a list of names, got " + kindOf(value));
  }
  std::vector<std::string> texts;
  for (Py_ssize_t i = 0; i < PySequence_Fast_GET_SIZE(items.ptr()); ++i) {
    texts.push_back(textFrom(PySequence_Fast_GET_ITEM(items.ptr(), i), place + '[' + std::to_string(i) + ']'));
  }
  return texts;
}

std::vector<std::pair<std::string, float>> numbersByName(py::handle value, const std::string& place) {
  if (PyDict_Check(value.ptr()) == 0) refuse(place, "expected a dict of numbers by name, got " + kindOf(value));
  std::vector<std::pair<std::string, float>> numbers;
  for (const auto& [name, number] : py::reinterpret_borrow<py::dict>(value)) {
    const std::string text = textFrom(name, place);
    numbers.emplace_back(text, numberFrom(number, place + "[\"" + text + "\"]"));
  }
  return numbers;
}

std::vector<glm::mat4> bonesFrom(py::handle value, const Skeleton& skeleton) {
  const auto given = matricesFrom(value, skeleton);
  const auto numbers = given.unchecked<3>();
  std::vector<glm::mat4> bones(skeleton.bones.size());
  for (std::size_t bone = 0; bone < bones.size(); ++bone) {
    for (py::ssize_t row = 0; row < 4; ++row) {
      for (py::ssize_t column = 0; column < 4; ++column) {
        const double number = numbers(static_cast<py::ssize_t>(bone), row, column);
        if (!(std::abs(number) <= static_cast<double>(std::numeric_limits<float>::max()))) {
          const std::string where = " in row " + std::to_string(row) + ", column " + std::to_string(column);
          refuse(placeOfBone(skeleton, bone), "expected finite numbers of 32 bits, got " + numberText(number) + where);
        }
        bones[bone][static_cast<int>(column)][static_cast<int>(row)] = static_cast<float>(number);
      }
    }
    for (py::ssize_t column = 0; column < 4; ++column) {
      const double expected = column == 3 ? 1.0 : 0.0;
      if (std::abs(numbers(static_cast<py::ssize_t>(bone), 3, column) - expected) > kSameRow) {
        refuse(placeOfBone(skeleton, bone),
               "expected the last row 0, 0, 0, 1, as of matrices that multiply columns; is it transposed?");
      }
    }
  }
  return bones;
}

}  // namespace sinew::python
