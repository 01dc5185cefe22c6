# tests/install/install_test.cmake: installs into a fresh folder, builds a project that finds Sinew there, runs it.
# cmake -DBUILD=... -DCONSUMER=... -DWORK=... -DASSETS=... -DFLAGS=... -DAPP=ON|OFF -P install_test.cmake
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGV}\nexit ${status}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

function(expect_match text pattern)
  if(NOT text MATCHES "${pattern}")
    message(FATAL_ERROR "expected '${pattern}' in:\n${text}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)

# A consumer sees the installed files alone: headers, archive and package, none of the project's own flags.
file(GLOB_RECURSE exported ${WORK}/prefix/*Sinew*.cmake)
foreach(file ${exported})
  file(READ ${file} text)
  if(text MATCHES "sinew_flags|-Werror|${BUILD}")
    message(FATAL_ERROR "${file} leaks '${CMAKE_MATCH_0}'")
  endif()
endforeach()
run(${CMAKE_COMMAND} -S ${CONSUMER} -B ${WORK}/build -G Ninja
  -DCMAKE_PREFIX_PATH=${WORK}/prefix "-DCMAKE_CXX_FLAGS=${FLAGS}")
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/consumer ${ASSETS}/demo.rig.json)
expect_match("${output}" "^[1-9][0-9]+ vertices")

if(APP)
  run(${WORK}/prefix/bin/sinew inspect ${WORK}/prefix/share/sinew/assets/demo.glb)
  expect_match("${output}" "842")
  file(GLOB shaders ${WORK}/prefix/share/sinew/shaders/*)
  if(NOT shaders)
    message(FATAL_ERROR "no shader was installed")
  endif()
endif()
file(REMOVE_RECURSE ${WORK})
