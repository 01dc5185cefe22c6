# tests/install/without_tests.cmake: who only runs the program needs no test library; who wants tests is told what is missing.
# The same holds for the Python module.
# cmake -DSOURCE=... -DWORK=... -P without_tests.cmake
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)
file(REMOVE_RECURSE ${WORK})
set(hidden -DCMAKE_DISABLE_FIND_PACKAGE_GTest=ON -DCMAKE_DISABLE_FIND_PACKAGE_benchmark=ON
  -DCMAKE_DISABLE_FIND_PACKAGE_pybind11=ON)
run(bash -c "source '${SOURCE}/cmake/packages.sh' && echo \"\${sinewRunPackages[@]}\"")
if(output MATCHES "gtest|benchmark|pybind11|python3-dev")
  message(FATAL_ERROR "run.sh installs '${CMAKE_MATCH_0}'")
endif()

# As run.sh configures, then as somebody who develops does, in the same folder.
run(${CMAKE_COMMAND} -S ${SOURCE} --preset release -B ${WORK} ${hidden} -D SINEW_BUILD_TESTS=OFF)
run_failing(1 ${CMAKE_COMMAND} -S ${SOURCE} --preset release -B ${WORK})
expect_match("${output}" "libgtest-dev")
run_failing(1 ${CMAKE_COMMAND} -S ${SOURCE} --preset release -B ${WORK} -D SINEW_BUILD_TESTS=OFF -D SINEW_BUILD_PYTHON=ON)
expect_match("${output}" "pybind11-dev")
run(${CMAKE_COMMAND} -S ${SOURCE} --preset release -B ${WORK} -USINEW_BUILD_PYTHON -UCMAKE_DISABLE_FIND_PACKAGE_*)
run(${CMAKE_COMMAND} --build ${WORK} --target help)
expect_match("${output}" "rig_tests")
file(REMOVE_RECURSE ${WORK})
