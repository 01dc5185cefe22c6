# cmake/install.cmake: what `cmake --install` puts where, and the package other projects find with find_package(Sinew).
include(CMakePackageConfigHelpers)
set(sinew_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/Sinew)

install(TARGETS sinew_runtime EXPORT SinewRuntimeTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(TARGETS sinew_core EXPORT SinewTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/core/include/sinew DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  COMPONENT development)
install(EXPORT SinewRuntimeTargets NAMESPACE Sinew:: DESTINATION ${sinew_package_dir} COMPONENT development)
install(EXPORT SinewTargets NAMESPACE Sinew:: DESTINATION ${sinew_package_dir} COMPONENT development)

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/SinewConfig.cmake.in ${PROJECT_BINARY_DIR}/SinewConfig.cmake
  INSTALL_DESTINATION ${sinew_package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/SinewConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/SinewConfig.cmake ${PROJECT_BINARY_DIR}/SinewConfigVersion.cmake
  DESTINATION ${sinew_package_dir} COMPONENT development)
# The runtime for build systems other than CMake. Paths are relative to it.
set(sinew_pc_requires "libhwy")
if(SINEW_WITH_TBB)
  string(APPEND sinew_pc_requires ", tbb")
endif()
file(RELATIVE_PATH sinew_pc_include /${CMAKE_INSTALL_LIBDIR}/pkgconfig /${CMAKE_INSTALL_INCLUDEDIR})
configure_file(${PROJECT_SOURCE_DIR}/cmake/sinew-runtime.pc.in ${PROJECT_BINARY_DIR}/sinew-runtime.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/sinew-runtime.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples/cpp DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/sinew/examples
  COMPONENT development)

if(SINEW_BUILD_APP)
  # A package of the program leaves the library out.
  set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME program)
  set(packaging ${PROJECT_SOURCE_DIR}/packaging)
  install(TARGETS sinew RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/shaders DESTINATION ${CMAKE_INSTALL_DATADIR}/sinew)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/core/geometry/formulas DESTINATION ${CMAKE_INSTALL_DATADIR}/sinew/core/geometry)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/assets DESTINATION ${CMAKE_INSTALL_DATADIR}/sinew
    FILES_MATCHING PATTERN "*.glb" PATTERN "*.rig.json" PATTERN "presets/*.json" PATTERN "maker" EXCLUDE)

  # What a desktop knows the program by: menu entry, icon, file type, software centre.
  install(FILES ${packaging}/sinew.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
  install(FILES ${packaging}/sinew-rig.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages RENAME sinew.xml)
  install(FILES ${packaging}/sinew.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo
    RENAME org.example.Sinew.metainfo.xml)
  install(FILES ${packaging}/icons/sinew.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
  foreach(size 16 24 32 48 64 128 256)
    install(FILES ${packaging}/icons/sinew-${size}.png RENAME sinew.png
      DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/${size}x${size}/apps)
  endforeach()

  # What a shell knows it by. Made by packaging/make_pages.py from the program's own help.
  install(FILES ${packaging}/completions/sinew.bash RENAME sinew
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
  install(FILES ${packaging}/completions/_sinew DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
  install(FILES ${packaging}/completions/sinew.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
  find_program(SINEW_GZIP gzip REQUIRED)
  function(sinew_install_gzipped file name destination)
    set(packed ${PROJECT_BINARY_DIR}/packed/${name}.gz)
    # -n: no time stamp, so that the same file gives the same bytes.
    add_custom_command(OUTPUT ${packed} DEPENDS ${file} VERBATIM
      COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_BINARY_DIR}/packed
      COMMAND ${CMAKE_COMMAND} -E copy ${file} ${PROJECT_BINARY_DIR}/packed/${name}
      COMMAND ${SINEW_GZIP} -9nf ${PROJECT_BINARY_DIR}/packed/${name})
    set_property(DIRECTORY APPEND PROPERTY sinew_packed ${packed})
    install(FILES ${packed} DESTINATION ${destination})
  endfunction()
  sinew_install_gzipped(${packaging}/sinew.1 sinew.1 ${CMAKE_INSTALL_MANDIR}/man1)
  sinew_install_gzipped(${PROJECT_SOURCE_DIR}/CHANGELOG.md changelog ${CMAKE_INSTALL_DATADIR}/doc/sinew)
  sinew_install_gzipped(${packaging}/debian/changelog changelog.Debian ${CMAKE_INSTALL_DATADIR}/doc/sinew)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/sinew
    PATTERN cpp EXCLUDE PATTERN python EXCLUDE)
  # What Help > Pages opens.
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/sinew
    FILES_MATCHING PATTERN "*.md" PATTERN "*.png" PATTERN "*.jpg" PATTERN "*.webp")
  install(FILES ${packaging}/debian/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/sinew)
  if(SINEW_BUILD_PYTHON)
    foreach(name changelog changelog.Debian)
      install(FILES ${PROJECT_BINARY_DIR}/packed/${name}.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/python3-sinew
        COMPONENT python)
    endforeach()
  endif()
  get_property(packed_files DIRECTORY PROPERTY sinew_packed)
  add_custom_target(sinew_packed ALL DEPENDS ${packed_files})
endif()

if(SINEW_BUILD_PYTHON)
  # Where Python looks: of Debian's the packages' own folder in /usr and the local one in /usr/local; anywhere else, in a
  # virtual environment for instance, the usual one. Decided when it is installed, since the prefix may be another then.
  set(SINEW_PYTHON_DIR "" CACHE STRING "Where the Python module goes, relative to the prefix; empty: where Python looks")
  install(CODE "
    set(sinew_python_dir \"${SINEW_PYTHON_DIR}\")
    if(sinew_python_dir)
    elseif(CMAKE_INSTALL_PREFIX STREQUAL \"/usr\" AND EXISTS /usr/lib/python3/dist-packages)
      set(sinew_python_dir lib/python3/dist-packages)
    elseif(CMAKE_INSTALL_PREFIX STREQUAL \"/usr/local\" AND EXISTS /usr/lib/python3/dist-packages)
      set(sinew_python_dir lib/python${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}/dist-packages)
    else()
      set(sinew_python_dir lib/python${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}/site-packages)
    endif()" COMPONENT python)
  install(TARGETS sinew_python LIBRARY DESTINATION "\${sinew_python_dir}/sinew" COMPONENT python)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/python/sinew DESTINATION "\${sinew_python_dir}" COMPONENT python
    FILES_MATCHING PATTERN "*.py" PATTERN "*.pyi" PATTERN "py.typed" PATTERN "__pycache__" EXCLUDE)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples/python/ COMPONENT python
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/python3-sinew/examples FILES_MATCHING PATTERN "*.py")
  install(FILES ${PROJECT_SOURCE_DIR}/packaging/debian/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/python3-sinew
    COMPONENT python)
endif()
