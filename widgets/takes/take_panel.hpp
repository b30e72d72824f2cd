#pragma once

#include <QWidget>

#include "core/session/edit/recorded_takes.hpp"
#include "widgets/common/palette.hpp"
#include "widgets/takes/recording_status.hpp"

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QToolButton;

namespace abrazo::widgets {

class TabularLabel;
class TakeRows;

/// Recording of takes: next name, record button, countdown, state of the disk, and the list of takes. Records
/// nothing itself: it emits requests and shows what it is given.
class TakePanel : public QWidget {
  Q_OBJECT
 public:
  explicit TakePanel(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  void setTakes(const RecordedTakes& takes);
  void showStatus(const RecordingStatus& status);
  QString typedName() const;
  void setTypedName(const QString& name);
  /// Name of the next take.
  QString nextName() const;
  int countdown() const;  ///< [s]
  void setCountdown(int seconds);
  TakeRows& rows() { return *m_rows; }
  QString diskText() const;
  QString elapsedText() const;
  QPushButton& recordButton() { return *m_record; }
  QPushButton& againButton() { return *m_again; }

 signals:
  void recordRequested();  ///< starts a take, cancels a countdown, or ends the take
  void againRequested();
  void nameEdited(const QString& name);
  void countdownEdited(int seconds);
  void everythingRequested(bool on);
  void saveAsRequested();
  void pairRequested();
  void goToRequested(qint64 id);
  void renameRequested(qint64 id, const QString& name);
  void removeRequested(qint64 id);

 private:
  QWidget* makeHead();
  QWidget* makeDisk();
  void connectParts();
  void showNext();
  void dress();

  Palette m_palette;
  RecordingStatus m_status;
  RecordedTakes m_takes;
  QLineEdit* m_name;
  QLabel *m_next, *m_disk, *m_file, *m_none;
  QPushButton *m_record, *m_again;
  QSpinBox* m_countdown;
  TabularLabel* m_elapsed;
  QCheckBox* m_everything;
  QToolButton *m_saveAs, *m_pair;
  TakeRows* m_rows;
};

}  // namespace abrazo::widgets
