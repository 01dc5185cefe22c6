# tests/install/subproject_test.cmake: a project with Sinew below its own sees the public headers and no others.
# cmake -DSOURCE=... -DSUBPROJECT=... -DWORK=... -P subproject_test.cmake
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)
file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} -S ${SUBPROJECT} -B ${WORK} -G Ninja -DSINEW_SOURCE=${SOURCE})

# Their object files alone: the library need not be built for it.
run(${CMAKE_COMMAND} --build ${WORK} --target CMakeFiles/public_header.dir/public_header.cpp.o)
run_failing(1 ${CMAKE_COMMAND} --build ${WORK} --target CMakeFiles/private_header.dir/private_header.cpp.o)
expect_match("${output}" "core/geometry/at.h: No such file")
file(REMOVE_RECURSE ${WORK})
