# tests/install/install_test.cmake: installs into a fresh folder, builds projects that find Sinew there, runs them.
# cmake -DBUILD=... -DCONSUMER=... -DSAMPLES=... -DWORK=... -DASSETS=... -DFLAGS=... -DAPP=ON|OFF -P install_test.cmake
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE ${WORK})
# What is installed can be moved.
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/staged)
file(RENAME ${WORK}/staged ${WORK}/prefix)

# A consumer sees the installed files alone: headers, archive and package, none of the project's own flags.
# No place of the machine that it was built on: a path begins at that of the file itself.
file(GLOB_RECURSE exported ${WORK}/prefix/*Sinew*.cmake ${WORK}/prefix/*.pc)
foreach(file ${exported})
  file(STRINGS ${file} lines)
  list(FILTER lines EXCLUDE REGEX "^ *#")
  foreach(line ${lines})
    if(line MATCHES "sinew_flags|-Werror|${BUILD}|${WORK}|(^|[^]}A-Za-z0-9_.)>-])/[A-Za-z][^ ]*")
      message(FATAL_ERROR "${file} leaks '${CMAKE_MATCH_0}'")
    endif()
  endforeach()
endforeach()
function(build_against_prefix source build)
  run(${CMAKE_COMMAND} -S ${source} -B ${build} -G Ninja -DCMAKE_PREFIX_PATH=${WORK}/prefix "-DCMAKE_CXX_FLAGS=${FLAGS}")
  run(${CMAKE_COMMAND} --build ${build})
endfunction()

build_against_prefix(${CONSUMER} ${WORK}/build)
run(${WORK}/build/consumer ${ASSETS}/demo.rig.json)
expect_match("${output}" "^[1-9][0-9]+ vertices")

build_against_prefix(${SAMPLES} ${WORK}/samples)
include(${CMAKE_CURRENT_LIST_DIR}/samples.cmake)

if(APP)
  include(${CMAKE_CURRENT_LIST_DIR}/games.cmake)
  run(${WORK}/prefix/bin/sinew inspect ${WORK}/prefix/share/sinew/assets/demo.glb)
  expect_match("${output}" "842")
  # By the sets of muscles that are installed.
  run(${WORK}/prefix/bin/sinew muscle ${WORK}/prefix/share/sinew/assets/demo.glb -o ${WORK}/athlete.rig.json)
  if(NOT EXISTS ${WORK}/prefix/share/sinew/assets/presets/athlete.json)
    message(FATAL_ERROR "the sets of muscles are not installed")
  endif()
  file(GLOB shaders ${WORK}/prefix/share/sinew/shaders/*)
  if(NOT shaders)
    message(FATAL_ERROR "no shader was installed")
  endif()
endif()
file(REMOVE_RECURSE ${WORK})
