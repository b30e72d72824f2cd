# Debian packages, abrazo, abrazo-dev and, where the module is built, python3-abrazo: `cmake --workflow --preset package`, or cpack in any build folder whose prefix is /usr.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME abrazo)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_VENDOR "The Abrazo authors")
set(CPACK_PACKAGE_CONTACT "Abrazo maintainers <abrazo@packages.invalid>" CACHE STRING "who answers for the packages")
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/packages)
set(CPACK_PACKAGE_CHECKSUM SHA256)
set(CPACK_THREADS 0)
set(CPACK_COMPONENTS_ALL programs development)
if(ABRAZO_PYTHON_BUILT)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME abrazo)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SHLIBDEPS ON)
if(ABRAZO_WORKBENCH)
  # The face the window is drawn for; pictures where there is no display.
  set(CPACK_DEBIAN_PROGRAMS_PACKAGE_RECOMMENDS "fonts-inter, xvfb")
endif()
set(CPACK_DEBIAN_PROGRAMS_DESCRIPTION "virtual partner for close interactions such as partner dance
Abrazo animates a virtual partner that responds to a person's movement. The
partner's motion comes from recorded pairs; an interaction mesh preserves the
spatial relations of the two bodies. Input is recorded motion or a live stream
(VMC, NatNet, Xsens).
.
This package has the workbench, to watch, tune and annotate the partner, the
command line and the user guide.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME abrazo-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS ON)
set(abrazo_needed)
foreach(entry IN LISTS abrazo_engine_packages abrazo_engine_libraries)
  string(REGEX REPLACE ".*=" "" package "${entry}")
  if(NOT package STREQUAL "libc6-dev")
    list(APPEND abrazo_needed ${package})
  endif()
endforeach()
list(SORT abrazo_needed)
list(JOIN abrazo_needed ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "virtual partner for close interactions: embedding the engine
Abrazo animates a virtual partner that responds to a person's movement. The
partner's motion comes from recorded pairs; an interaction mesh preserves the
spatial relations of the two bodies.
.
This package has the engine as a static library with its headers, found by
CMake's find_package(abrazo) as abrazo::core, and an example.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-abrazo)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
# A module of one version of Python is not found by another.
if(ABRAZO_PYTHON_BUILT)
  string(REGEX MATCH "[0-9]+$" next "${ABRAZO_PYTHON_VERSION}")
  math(EXPR next "${next} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= ${ABRAZO_PYTHON_VERSION}~), python3 (<< 3.${next}), python3-numpy")
endif()
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "virtual partner for close interactions: Python module
Abrazo animates a virtual partner that responds to a person's movement. The
partner's motion comes from recorded pairs; an interaction mesh preserves the
spatial relations of the two bodies.
.
This package has the engine as a module for Python 3, with NumPy arrays in and
out: libraries, the synthesizer frame by frame, evaluations, recorded sessions.")

set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_SOURCE_DIR}/deb/time.cmake)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_SOURCE_DIR}/deb/tidy.cmake)
set(CPACK_ABRAZO_SOURCES ${PROJECT_SOURCE_DIR})
include(CPack)
