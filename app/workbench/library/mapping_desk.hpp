#pragma once

#include <QObject>
#include <QPointer>
#include <QStringList>

#include "app/workbench/library/mapping_dialog.hpp"
#include "core/opening/joint_maps.hpp"

namespace abrazo::app {

class MainWindow;

/// Asks for the joint map of a file with unknown points, stores it for files with the same points, and opens
/// the file with it.
class MappingDesk : public QObject {
  Q_OBJECT
 public:
  explicit MappingDesk(MainWindow& window);
  /// Null if no dialog is open.
  MappingDialog* dialog() const { return m_dialog; }
  /// Folder of stored maps.

 private:
  void offer(const QStringList& files, const UnmappedMotion& motion);
  void use(const QStringList& files);

  MainWindow& m_window;
  QPointer<MappingDialog> m_dialog;
};

}  // namespace abrazo::app
