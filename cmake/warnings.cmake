# cmake/warnings.cmake: one target carries the language level, the warnings and the sanitizers for all others.
add_library(sinew_flags INTERFACE)
target_compile_features(sinew_flags INTERFACE cxx_std_20)
target_compile_options(sinew_flags INTERFACE
  -Wall -Wextra -Wshadow -Wconversion -Wnon-virtual-dtor -Wold-style-cast
  # g++ 12 warns of overlapping copies inside its own std::string at -O3 (GCC bug 105329).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  # Same bytes everywhere: no fused multiply-add behind our back.
  -ffp-contract=off
  $<$<BOOL:${SINEW_WARNINGS_FATAL}>:-Werror>)
if(SINEW_SANITIZE)
  target_compile_options(sinew_flags INTERFACE
    -fsanitize=${SINEW_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(sinew_flags INTERFACE -fsanitize=${SINEW_SANITIZE})
endif()
