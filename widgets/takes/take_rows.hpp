#pragma once

#include <QListWidget>

#include "core/session/edit/recorded_takes.hpp"
#include "widgets/common/palette.hpp"

namespace abrazo::widgets {

/// The takes of a session, one row each: name and length; below them time, size and performers. Return and a
/// double click go to a take, F2 renames it, Del requests its removal; the list changes nothing itself.
class TakeRows : public QListWidget {
  Q_OBJECT
 public:
  explicit TakeRows(QWidget* parent = nullptr);
  void setTakes(const RecordedTakes& takes);
  void setColours(const Palette& palette);
  /// The take being recorded; -1 = none.
  void setRunning(std::int64_t id);
  std::int64_t currentTake() const;  ///< -1 = none
  void setCurrentTake(std::int64_t id);
  void rename();  ///< opens the editor of the current row

 signals:
  void goToRequested(qint64 id);
  void renameRequested(qint64 id, const QString& name);
  void removeRequested(qint64 id);

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  std::int64_t takeAt(int row) const;

  RecordedTakes m_takes;
  std::int64_t m_running = -1;
};

}  // namespace abrazo::widgets
