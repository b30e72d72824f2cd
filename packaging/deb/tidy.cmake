# Read by cpack when the files of all packages are in place: what Debian's policy wants of them.
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(programs ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/programs/usr)
set(development ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/development/usr)
set(python ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/python/usr)

file(GLOB_RECURSE binaries ${programs}/bin/* ${programs}/lib/*.so ${python}/lib/*.so ${programs}/libexec/* ${python}/lib/abrazo-scene-reader
  ${development}/libexec/*)
run(strip --remove-section=.comment --remove-section=.note ${binaries})
file(GLOB_RECURSE archives ${development}/lib/*.a)
run(strip --strip-debug --remove-section=.comment --remove-section=.note --enable-deterministic-archives ${archives})

file(GLOB pages ${programs}/share/man/man1/*.1)
run(gzip -9n ${pages})

# Every row of the first table in copyright.in.
file(READ ${programs}/share/doc/abrazo/copyright licences)
string(REGEX REPLACE ".*Code of others inside(.*)Loaded by the programs.*" "\\1" inside "${licences}")
string(REGEX MATCHALL "[a-z0-9.+-]+-dev" inside "${inside}")
foreach(package IN LISTS inside)
  if(NOT EXISTS ${programs}/share/doc/abrazo/third-party/${package}.txt)
    message(FATAL_ERROR "The copyright notice of ${package} is missing. It is compiled in, so it has to be passed on: "
                        "name it in packaging/programs.cmake, and see that /usr/share/doc/${package}/copyright is there")
  endif()
endforeach()

# A package of one's own has Debian's list of changes; the real one is CHANGELOG.md.
string(TIMESTAMP day "%a, %d %b %Y %H:%M:%S +0000" UTC)
set(packages abrazo abrazo-dev)
if(EXISTS ${python})
  list(APPEND packages python3-abrazo)
endif()
foreach(package IN LISTS packages)
  set(doc ${programs}/share/doc/${package})
  if(package STREQUAL "abrazo-dev")
    set(doc ${development}/share/doc/${package})
  elseif(package STREQUAL "python3-abrazo")
    set(doc ${python}/share/doc/${package})
  endif()
  if(NOT package STREQUAL "abrazo")
    file(COPY ${programs}/share/doc/abrazo/copyright ${programs}/share/doc/abrazo/third-party DESTINATION ${doc})
  endif()
  file(WRITE ${doc}/changelog "${CPACK_PACKAGE_NAME} (${CPACK_PACKAGE_VERSION}) bookworm; urgency=medium

  * Version ${CPACK_PACKAGE_VERSION}: see /usr/share/doc/abrazo/CHANGELOG.md in the package abrazo.

 -- ${CPACK_PACKAGE_CONTACT}  ${day}
")
  run(gzip -9n ${doc}/changelog)
endforeach()

run(chmod -R u=rwX,go=rX ${CPACK_TEMPORARY_INSTALL_DIRECTORY})
run(find ${CPACK_TEMPORARY_INSTALL_DIRECTORY} -exec touch --no-dereference --date=@$ENV{SOURCE_DATE_EPOCH} {} +)
