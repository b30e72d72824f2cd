# Sources that are compiled together: what they share is read and instantiated once, which takes a third of the time. Neighbours
# of one folder make a batch, so a new file moves others only within its folder. A folder is core/session or app/workbench here, with
# all of its rooms: batches of each room would be more and smaller. Names without linkage have to be unique in a folder
# (in tests every file has a namespace of its own). -DABRAZO_UNITY=OFF, as in the preset `dev`, compiles
# every file alone.
option(ABRAZO_UNITY "Compile the sources of a folder in batches" ON)

# abrazo_unity(TARGET BATCH [ALONE source...]): batches of at most BATCH sources; those after ALONE stay by themselves.
function(abrazo_unity target batch)
  cmake_parse_arguments(ARG "" "" "ALONE" ${ARGN})
  if(NOT ABRAZO_UNITY)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  get_target_property(source_dir ${target} SOURCE_DIR)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  list(SORT sources)
  set(previous "")
  set(index 0)
  foreach(source IN LISTS sources)
    get_filename_component(name ${source} NAME)
    if(name IN_LIST ARG_ALONE)
      continue()
    endif()
    get_filename_component(folder ${source} ABSOLUTE BASE_DIR ${source_dir})
    get_filename_component(folder ${folder} DIRECTORY)
    file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${folder})
    string(REGEX MATCH "^(tests/)?[^/]+(/[^/]+)?" folder "${folder}")
    if(NOT folder STREQUAL previous)
      set(index 0)
      set(previous "${folder}")
    endif()
    math(EXPR number "${index} / ${batch}")
    math(EXPR index "${index} + 1")
    get_filename_component(folder_name "${folder}" NAME)
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP "${folder_name}_${number}")
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    # clang reports a local name that another file of the batch uses at file scope. gcc and the preset `dev` report what shadows
    # within a file.
    target_compile_options(${target} PRIVATE -Wno-shadow)
  endif()
endfunction()
