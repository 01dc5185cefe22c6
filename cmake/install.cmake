# cmake/install.cmake: what `cmake --install` puts where, and the package other projects find with find_package(Sinew).
include(CMakePackageConfigHelpers)
set(sinew_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/Sinew)

install(TARGETS sinew_core EXPORT SinewTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/core/include/sinew DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT SinewTargets NAMESPACE Sinew:: DESTINATION ${sinew_package_dir})

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/SinewConfig.cmake.in ${PROJECT_BINARY_DIR}/SinewConfig.cmake
  INSTALL_DESTINATION ${sinew_package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/SinewConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/SinewConfig.cmake ${PROJECT_BINARY_DIR}/SinewConfigVersion.cmake
  DESTINATION ${sinew_package_dir})

if(SINEW_BUILD_APP)
  install(TARGETS sinew RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/shaders DESTINATION ${CMAKE_INSTALL_DATADIR}/sinew)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/assets DESTINATION ${CMAKE_INSTALL_DATADIR}/sinew
    FILES_MATCHING PATTERN "*.glb" PATTERN "*.rig.json" PATTERN "maker" EXCLUDE)
endif()
