# What nearly every file of a target includes is compiled once; for tests it is shared by all programs, which are many and small.
# Files still include what they use: -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON builds without.
set(abrazo_precompiled_core
  <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory> <optional> <set> <span> <string> <string_view>
  <utility> <vector> <Eigen/Core> <Eigen/Geometry>)
set(abrazo_precompiled_engine ${abrazo_precompiled_core} <fmt/format.h>)
set(abrazo_precompiled_cli ${abrazo_precompiled_engine} <CLI/CLI.hpp>)
set(abrazo_precompiled_qt ${abrazo_precompiled_core} <QAction> <QBoxLayout> <QComboBox> <QKeyEvent> <QLabel> <QLineEdit> <QMenu>
  <QMouseEvent> <QPainter> <QPushButton> <QToolButton> <QWidget>)
set(abrazo_precompiled_tests ${abrazo_precompiled_core} <gmock/gmock.h> <gtest/gtest.h>)
set(abrazo_precompiled_gui_tests ${abrazo_precompiled_tests} <QApplication> <QLabel> <QMainWindow> <QMenu> <QMouseEvent> <QPainter>
  <QWidget>)

# abrazo_precompile(TARGET engine|cli|qt|tests|gui_tests): compiles the list for this target.
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
