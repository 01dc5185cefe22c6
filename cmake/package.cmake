# cmake/package.cmake: `cmake --build build/release --target package` makes Debian packages: sinew, the program, and
# python3-sinew, where the Python module is built.
#
# The library for other programs is in neither: that is what `cmake --install` is for.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME sinew)
set(CPACK_PACKAGE_VENDOR "Sinew contributors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # It would stand before each of these, whose first lines are their own.
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION
"editor that adds muscles to animated glTF characters
Sinew opens a skinned glTF character, lets the user place ellipsoids on its
bones and blend them, and turns the coarse mesh plus the ellipsoids into one
smooth, textured, closed mesh while the character plays its animation.

The package holds the editor, the command line (inspect, check, muscle,
retarget, fit, smooth, export, pack, render, farm, bench) and sample characters.")
set(CPACK_DEBIAN_PYTHON_DESCRIPTION
"muscles for animated glTF characters (Python 3)
Sinew turns a skinned glTF character with ellipsoids on its bones into one
smooth, textured, closed mesh while the character plays its animation.

The package holds the Python module sinew: rigs are made and edited,
surfaces of any pose are NumPy arrays without a copy, and characters are
exported for games. With it comes an add-on for Blender, as a zip that
Blender's preferences install.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL program)
if(SINEW_BUILD_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_COMPONENTS_GROUPING IGNORE)  # A package each.
set(CPACK_DEB_COMPONENT_INSTALL ON)

# example.org is reserved: whoever publishes the package sets their own.
set(SINEW_PACKAGE_MAINTAINER "Sinew contributors <sinew@example.org>"
  CACHE STRING "Name and address in the Debian package")
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${SINEW_PACKAGE_MAINTAINER}")
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME sinew)
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-sinew)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
# Linked libraries are found by dpkg-shlibdeps; libepoxy opens these two by name, and the letters are files.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "libgl1, libegl1, fonts-inter, fonts-dejavu-core")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "libgl1-mesa-dri, fonts-noto-cjk, xdg-utils")
# The extension is for one minor version of Python; modules are compiled to bytecode where they are installed.
if(SINEW_BUILD_PYTHON)
  math(EXPR next_python "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next_python}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "sinew, blender, python3-matplotlib")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
    ${PROJECT_SOURCE_DIR}/packaging/debian/python/postinst ${PROJECT_SOURCE_DIR}/packaging/debian/python/prerm)
endif()
include(CPack)
