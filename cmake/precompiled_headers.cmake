# What nearly every test includes is compiled once and shared by all test programs: they are many and small. Files still include
# what they use: -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON builds without.
set(abrazo_precompiled_tests
  <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory> <optional> <set> <span> <string> <string_view>
  <utility> <vector> <Eigen/Core> <Eigen/Geometry> <gmock/gmock.h> <gtest/gtest.h>)
set(abrazo_precompiled_gui_tests ${abrazo_precompiled_tests} <QApplication> <QLabel> <QMainWindow> <QMenu> <QMouseEvent> <QPainter>
  <QWidget>)

# abrazo_precompile(TARGET tests|gui_tests): compiles the list for this target.
function(abrazo_precompile target list)
  target_precompile_headers(${target} PRIVATE ${abrazo_precompiled_${list}})
endfunction()

# abrazo_share_precompiled(OWNER TARGET...): what was compiled for OWNER serves the programs among the targets. They have to be
# compiled as OWNER is, and may not lack a macro that it has.
function(abrazo_share_precompiled owner)
  foreach(target ${ARGN})
    get_target_property(type ${target} TYPE)
    get_target_property(libraries ${target} LINK_LIBRARIES)
    if(type STREQUAL "EXECUTABLE" AND libraries MATCHES "gtest|test_main")
      target_precompile_headers(${target} REUSE_FROM ${owner})
    endif()
  endforeach()
endfunction()
