# Programs, their manual pages, the guide and the licence.
set(abrazo_programs abrazo)
if(ABRAZO_WORKBENCH)
  list(APPEND abrazo_programs abrazo-render abrazo-workbench)
endif()
foreach(program IN LISTS abrazo_programs)
  # Libraries that others name for us and nothing calls need not be loaded: starting is quicker, packages depend on less.
  target_link_options(${program} PRIVATE LINKER:--as-needed LINKER:-z,relro,-z,now)
endforeach()
install(TARGETS ${abrazo_programs} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT programs)
# Started by those programs, not by people.
install(TARGETS abrazo-scene-reader RUNTIME DESTINATION ${ABRAZO_READER_DIR} COMPONENT programs)

set(abrazo_pages)
foreach(program IN LISTS abrazo_programs)
  set(page ${CMAKE_CURRENT_BINARY_DIR}/${program}.1)
  set(source ${CMAKE_CURRENT_SOURCE_DIR}/man/${program}.1.in)
  add_custom_command(OUTPUT ${page}
    COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/man/make_page $<TARGET_FILE:${program}> ${source} ${PROJECT_VERSION}
            ${CMAKE_INSTALL_FULL_DOCDIR} > ${page}
    DEPENDS ${program} ${source} man/make_page man/help_to_man.awk
    COMMENT "Manual page of ${program}" VERBATIM)
  list(APPEND abrazo_pages ${page})
endforeach()
add_custom_target(abrazo_manual ALL DEPENDS ${abrazo_pages})
install(FILES ${abrazo_pages} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT programs)

# The guide's links work from where it is installed: docs/ and data/ keep their places beside each other.
install(FILES ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${PROJECT_SOURCE_DIR}/SECURITY.md DESTINATION ${ABRAZO_DOC_DIR} COMPONENT programs)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs ${PROJECT_SOURCE_DIR}/data DESTINATION ${ABRAZO_DOC_DIR} COMPONENT programs
  PATTERN docs/images/make EXCLUDE PATTERN docs/images/README.md EXCLUDE)
# Debian's policy wants the licence under this name, and it does no harm elsewhere.
file(READ ${PROJECT_SOURCE_DIR}/LICENSE abrazo_licence)
configure_file(deb/copyright.in ${CMAKE_CURRENT_BINARY_DIR}/copyright @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/copyright DESTINATION ${ABRAZO_DOC_DIR} COMPONENT programs)
# Whose code is inside the programs: their notices go with it, as Debian has them for what was compiled (deb/tidy.cmake wants them
# all). Elsewhere than on Debian there may be none.
foreach(package IN ITEMS libeigen3-dev libflann-dev nlohmann-json3-dev libcli11-dev libfmt-dev pybind11-dev)
  install(FILES /usr/share/doc/${package}/copyright DESTINATION ${ABRAZO_DOC_DIR}/third-party RENAME ${package}.txt
    COMPONENT programs OPTIONAL)
endforeach()
