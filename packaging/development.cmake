# find_package(abrazo): the engine as abrazo::core, its headers, and the example that embeds it.
include(CMakePackageConfigHelpers)
set(abrazo_config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/abrazo)

# Headers whose code is in the engine, under the names that they have in the sources; what needs OpenCV belongs to the workbench.
get_target_property(abrazo_sources abrazo_core SOURCES)
file(GLOB_RECURSE abrazo_headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/core/*.hpp)
# These hold JSON of a library that embedders need not have.
list(REMOVE_ITEM abrazo_headers core/motion/scenes/glb_file.hpp core/motion/scenes/gltf_json.hpp)
foreach(header IN LISTS abrazo_headers)
  string(REGEX REPLACE "\\.hpp$" ".cpp" source ${PROJECT_SOURCE_DIR}/${header})
  if(NOT EXISTS ${source} OR source IN_LIST abrazo_sources)
    get_filename_component(folder ${header} DIRECTORY)
    install(FILES ${PROJECT_SOURCE_DIR}/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/abrazo/${folder} COMPONENT development)
  endif()
endforeach()

# For the programs that embed the engine to ship: it is of the engine's version.
set(abrazo_reader_dir ${CMAKE_INSTALL_LIBEXECDIR}/abrazo-dev)
install(TARGETS abrazo-scene-reader RUNTIME DESTINATION ${abrazo_reader_dir} COMPONENT development)
set_target_properties(abrazo_core PROPERTIES EXPORT_NAME core)
install(TARGETS abrazo_core EXPORT abrazo ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(EXPORT abrazo NAMESPACE abrazo:: FILE abrazo-targets.cmake DESTINATION ${abrazo_config_dir} COMPONENT development)
configure_package_config_file(cmake/abrazo-config.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/abrazo-config.cmake
  INSTALL_DESTINATION ${abrazo_config_dir} PATH_VARS abrazo_reader_dir)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/abrazo-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/abrazo-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/abrazo-config-version.cmake
              ${PROJECT_SOURCE_DIR}/cmake/engine_libraries.cmake
  DESTINATION ${abrazo_config_dir} COMPONENT development)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples DESTINATION ${ABRAZO_DOC_DIR}-dev COMPONENT development)
