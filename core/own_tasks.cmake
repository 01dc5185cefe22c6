# core/own_tasks.cmake: the one file that includes oneTBB, without oneTBB's templates in the archive.
#
# A game has them too, perhaps made for other vectors; the linker keeps one of each name for both. So the object's weak
# symbols are made its own: groups of sections that linkers merge become plain sections, then all names but Sinew's are
# local. Left out where the tools of GNU are not at hand, and with sanitizers, which do not expect it.
add_library(sinew_own_tasks OBJECT geometry/own_tasks.cpp)
target_include_directories(sinew_own_tasks PRIVATE include)
target_compile_definitions(sinew_own_tasks PRIVATE SINEW_WITH_TBB)
target_link_libraries(sinew_own_tasks PRIVATE sinew_flags TBB::tbb)
set_target_properties(sinew_own_tasks PROPERTIES POSITION_INDEPENDENT_CODE ON INTERPROCEDURAL_OPTIMIZATION OFF
  CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)

list(REMOVE_ITEM runtime_sources geometry/own_tasks.cpp)
execute_process(COMMAND ${CMAKE_LINKER} --version OUTPUT_VARIABLE linker_version ERROR_QUIET)
if(CMAKE_OBJCOPY AND linker_version MATCHES "GNU ld" AND NOT SINEW_SANITIZE)
  set(object ${CMAKE_CURRENT_BINARY_DIR}/own_tasks.o)
  add_custom_command(OUTPUT ${object} DEPENDS $<TARGET_OBJECTS:sinew_own_tasks> COMMAND_EXPAND_LISTS VERBATIM
    COMMAND ${CMAKE_LINKER} -r --force-group-allocation $<TARGET_OBJECTS:sinew_own_tasks> -o ${object}
    COMMAND ${CMAKE_OBJCOPY} --wildcard --keep-global-symbol=_ZN5sinew8parallel* ${object})
  list(APPEND runtime_sources ${object})
else()
  list(APPEND runtime_sources $<TARGET_OBJECTS:sinew_own_tasks>)
endif()
