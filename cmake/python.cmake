# cmake/python.cmake: whether the Python module is built, and with which Python.
#
# Debian's own, where there is one: pybind11 and NumPy of the system's packages belong to it, whatever else is in PATH.
if(NOT DEFINED Python_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python_EXECUTABLE /usr/bin/python3)
endif()
find_package(Python 3.9 QUIET COMPONENTS Interpreter Development.Module)
find_package(pybind11 2.10 QUIET CONFIG)
if(Python_Development.Module_FOUND AND pybind11_FOUND)
  set(sinew_python_found ON)
else()
  set(sinew_python_found OFF)
endif()
# A sanitizer must be in the interpreter's process from its start; by hand: docs/python.md.
set(sinew_python_usual OFF)
if(PROJECT_IS_TOP_LEVEL AND sinew_python_found AND NOT SINEW_SANITIZE)
  set(sinew_python_usual ON)
endif()
option(SINEW_BUILD_PYTHON "Build the Python module (needs Python's headers and pybind11)" ${sinew_python_usual})
if(SINEW_BUILD_PYTHON AND NOT sinew_python_found)
  message(FATAL_ERROR "The Python module needs Python's headers and pybind11 (Debian: python3-dev, pybind11-dev). "
    "To build without it: -D SINEW_BUILD_PYTHON=OFF")
endif()
