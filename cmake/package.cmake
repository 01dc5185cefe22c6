# cmake/package.cmake: `cmake --build build/release --target package` makes a Debian package of the program.
#
# The library for other programs is not in it: that is what `cmake --install` is for.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME sinew)
set(CPACK_PACKAGE_VENDOR "Sinew contributors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "editor that adds muscles to animated glTF characters")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"Sinew opens a skinned glTF character, lets the user place ellipsoids on its
bones and blend them, and turns the coarse mesh plus the ellipsoids into one
smooth, textured, closed mesh while the character plays its animation.

The package holds the editor, the command line (inspect, check, muscle,
retarget, smooth, export, render, farm, bench) and sample characters.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL program)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_DEB_COMPONENT_INSTALL ON)

# example.org is reserved: whoever publishes the package sets their own.
set(SINEW_PACKAGE_MAINTAINER "Sinew contributors <sinew@example.org>"
  CACHE STRING "Name and address in the Debian package")
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${SINEW_PACKAGE_MAINTAINER}")
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME sinew)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
# Linked libraries are found by dpkg-shlibdeps; libepoxy opens these two by name, and the letters are files.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libgl1, libegl1, fonts-inter, fonts-dejavu-core")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libgl1-mesa-dri, fonts-noto-cjk, xdg-utils")
include(CPack)
