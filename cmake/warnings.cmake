# cmake/warnings.cmake: one target carries the language level, the warnings, the sanitizers and the tree's own
# include path for all others. They link it privately, so that a project which links Sinew::core gets none of it.
add_library(sinew_flags INTERFACE)
target_compile_features(sinew_flags INTERFACE cxx_std_20)
target_include_directories(sinew_flags INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(sinew_flags INTERFACE
  -Wall -Wextra -Wshadow -Wconversion -Wnon-virtual-dtor -Wold-style-cast
  # g++ 12 warns of overlapping copies inside its own std::string at -O3 (GCC bug 105329).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  # g++ would walk its heap, the precompiled headers among it, several times per file.
  $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-expand=1000>
  $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=1000000>
  # Same bytes everywhere: no fused multiply-add behind our back.
  -ffp-contract=off
  $<$<BOOL:${SINEW_WARNINGS_FATAL}>:-Werror>)
if(SINEW_SANITIZE)
  target_compile_options(sinew_flags INTERFACE
    -fsanitize=${SINEW_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(sinew_flags INTERFACE -fsanitize=${SINEW_SANITIZE})
endif()
