# What the engine links, named once: the build reads this file, and so does find_package(abrazo), which has a copy beside its
# configuration. A program that links the engine needs these libraries and not their headers; Eigen is the exception.
#   package: NAME[|least version[|more words]]=Debian package found by find_package
#   library: NAME=file's name=Debian package                  found by find_library, linked as abrazo::NAME
set(abrazo_engine_packages
  "Eigen3|3.4|NO_MODULE=libeigen3-dev" "Threads=libc6-dev" "fmt=libfmt-dev" "SQLite3|3.40=libsqlite3-dev" "pugixml=libpugixml-dev")
set(abrazo_engine_libraries
  # The serial HDF5 by name: VTK, OpenCV and GDAL load it too, and two variants in one process corrupt each other.
  "hdf5=hdf5_serial=libhdf5-dev"
  "lo=lo=liblo-dev"
  "tinygltf=tinygltf=libtinygltf-dev"
  "tet=tet=libtet1.5-dev | libtet-dev"
  # FLANN's own code is compiled in; what could save an index calls this.
  "lz4=lz4=liblz4-dev"
  "zlib=z=zlib1g-dev")

# abrazo_find_engine_libraries(MISSING): makes a target of every library; MISSING is what is not there, and how to get it.
macro(abrazo_find_engine_libraries missing)
  set(${missing} "")
  foreach(abrazo_entry IN LISTS abrazo_engine_packages)
    string(REPLACE "=" ";" abrazo_entry "${abrazo_entry}")
    list(GET abrazo_entry 0 abrazo_words)
    list(GET abrazo_entry 1 abrazo_debian)
    string(REPLACE "|" ";" abrazo_words "${abrazo_words}")
    list(GET abrazo_words 0 abrazo_name)
    # Not find_package's version: Eigen 5 does not answer to 3.4, and Eigen 3.4 to no range.
    list(LENGTH abrazo_words abrazo_count)
    set(abrazo_least 0)
    if(abrazo_count GREATER 1)
      list(GET abrazo_words 1 abrazo_least)
      list(REMOVE_AT abrazo_words 1)
    endif()
    find_package(${abrazo_words} QUIET)
    if(NOT ${abrazo_name}_FOUND OR "${${abrazo_name}_VERSION}" VERSION_LESS abrazo_least)
      string(APPEND ${missing} " ${abrazo_name} (in Debian: ${abrazo_debian})")
    endif()
  endforeach()
  if(TARGET SQLite::SQLite3 AND NOT TARGET SQLite3::SQLite3)  # its name until CMake 4.3
    add_library(SQLite3::SQLite3 ALIAS SQLite::SQLite3)
  endif()
  foreach(abrazo_entry IN LISTS abrazo_engine_libraries)
    string(REPLACE "=" ";" abrazo_entry "${abrazo_entry}")
    list(GET abrazo_entry 0 abrazo_name)
    list(GET abrazo_entry 1 abrazo_file)
    list(GET abrazo_entry 2 abrazo_debian)
    find_library(ABRAZO_LIBRARY_${abrazo_name} ${abrazo_file})
    mark_as_advanced(ABRAZO_LIBRARY_${abrazo_name})
    if(NOT ABRAZO_LIBRARY_${abrazo_name})
      string(APPEND ${missing} " ${abrazo_name} (in Debian: ${abrazo_debian})")
    elseif(NOT TARGET abrazo::${abrazo_name})
      add_library(abrazo::${abrazo_name} UNKNOWN IMPORTED)
      set_target_properties(abrazo::${abrazo_name} PROPERTIES IMPORTED_LOCATION "${ABRAZO_LIBRARY_${abrazo_name}}")
    endif()
  endforeach()
endmacro()
