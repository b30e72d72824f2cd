#pragma once

#include <QDialog>
#include <QTimer>
#include <optional>

#include "core/opening/import_preview.hpp"
#include "widgets/common/palette.hpp"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QScrollArea;
class QSlider;
class QTableWidget;
class QToolButton;
class QVBoxLayout;

namespace abrazo::widgets {
class MotionPicture;
}

namespace abrazo::app {

/// How one motion file is read, with a picture of the result. Changes only itself: it requests
/// views of the file, and passes on the reading when the user accepts it.
class ImportPanel : public QDialog {
  Q_OBJECT
 public:
  ImportPanel(const MotionReading& reading, QWidget* parent);
  void setColours(const widgets::Palette& palette);
  /// Shows the imported file; fields that the user did not set show the values found.
  void show(const ImportView& view);
  using QDialog::show;
  /// Whether similar files are read in the same way.
  void setRemembers(bool on);
  bool remembers() const;
  const MotionReading& reading() const { return m_reading; }
  const ImportView& view() const { return m_view; }
  /// Waits for a view that was requested.
  bool isWaiting() const { return m_isWaiting; }
  widgets::MotionPicture& picture() { return *m_picture; }
  /// Why a person is asked: what the file leaves open, or why it cannot be read. Empty: nothing is open.
  QString reason() const;
  /// The reason, and what else the file's reader warns of.
  QString warnings() const;
  /// Uses a joint map or marker model, by its name or file.
  void chooseJoints(const QString& name_or_file);

 signals:
  /// Requests a view of the file with this reading.
  void viewRequested(const abrazo::MotionReading& reading);
  /// Requests the assignment of points to joints.
  void jointsRequested(const std::shared_ptr<const abrazo::NamedMotion>& motion);
  void rulesRequested();

 private:
  QWidget* makeReason();
  QWidget* makeFileColumn();
  QWidget* makePicture();
  QWidget* makeSpaceColumn();
  QWidget* makeFoot();
  QComboBox* addField(QVBoxLayout* column, const QString& name, bool editable = false);
  void connectParts();
  void take(QComboBox* field);
  void request();
  void refuse(QComboBox* field, const QString& why);
  void showFields();
  void showJoints();
  void showReason();
  void showWarnings();
  void fitWarnings();
  void showSpace();
  void showFrame();
  void showTime();

  MotionReading m_reading;
  ImportView m_view;
  bool m_isWaiting = true;
  widgets::Palette m_palette;
  QComboBox *m_performer = nullptr, *m_animation = nullptr, *m_order = nullptr;
  QComboBox *m_unit = nullptr, *m_up = nullptr, *m_rate = nullptr, *m_floor = nullptr, *m_joints = nullptr;
  QLabel* m_reason = nullptr;
  QScrollArea* m_warningsArea = nullptr;
  QLabel *m_file = nullptr, *m_facts = nullptr, *m_height = nullptr, *m_toes = nullptr;
  QLabel *m_found = nullptr, *m_warnings = nullptr, *m_time = nullptr, *m_state = nullptr;
  QTableWidget* m_table = nullptr;
  widgets::MotionPicture* m_picture = nullptr;
  QToolButton *m_play = nullptr, *m_names = nullptr;
  QSlider* m_frame = nullptr;
  QCheckBox* m_remember = nullptr;
  QPushButton *m_assign = nullptr, *m_import = nullptr;
  QTimer m_clock;
};

}  // namespace abrazo::app
