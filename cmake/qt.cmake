# The one switch between Qt 5 and Qt 6: the window is built with the Qt that VTK was built with, which is the one that the
# distribution has settled on. Targets are named without a version (Qt::Widgets): both have these names.
if(NOT VTK_QT_VERSION)
  message(FATAL_ERROR "This VTK ${VTK_VERSION} was built without Qt and does not say which one to use: set -DVTK_QT_VERSION=5 or 6")
endif()
find_package(Qt${VTK_QT_VERSION} REQUIRED COMPONENTS Core Gui Widgets Svg PrintSupport)
set(QT_VERSION ${Qt${VTK_QT_VERSION}Core_VERSION})
if(QT_VERSION VERSION_LESS 5.15)
  message(FATAL_ERROR "The workbench needs Qt 5.15 or newer; this is Qt ${QT_VERSION}")
endif()
if(VTK_QT_VERSION EQUAL 6)
  # What Qt 6 has new names for, while Qt 5.15 has only the old ones, is no warning.
  add_compile_definitions(QT_WARN_DEPRECATED_UP_TO=0x050F00)
  find_package(Qt6 REQUIRED COMPONENTS OpenGL)
  set(abrazo_qt_opengl Qt::OpenGL)  # a part of Qt::Gui in Qt 5
  find_library(QCUSTOMPLOT_LIBRARY NAMES QCustomPlotQt6 qcustomplot-qt6 REQUIRED)
else()
  find_library(QCUSTOMPLOT_LIBRARY NAMES QCustomPlot qcustomplot REQUIRED)
endif()
