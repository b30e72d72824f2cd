#pragma once

#include <QObject>
#include <QPointer>
#include <QStringList>

#include "app/workbench/library/mapping_dialog.hpp"
#include "core/opening/joint_maps.hpp"

namespace abrazo::app {

class MainWindow;

/// Asks which points are which joints when a file with unknown points is opened, keeps the answer for files
/// with the same points, and opens the file with it.
class MappingDesk : public QObject {
  Q_OBJECT
 public:
  explicit MappingDesk(MainWindow& window);
  /// Null while nothing is asked.
  MappingDialog* dialog() const { return m_dialog; }
  /// Where answers are kept.

 private:
  void offer(const QStringList& files, const UnmappedMotion& motion);
  void use(const QStringList& files);

  MainWindow& m_window;
  QPointer<MappingDialog> m_dialog;
};

}  // namespace abrazo::app
