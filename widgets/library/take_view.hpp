#pragma once

#include <QListView>

namespace abrazo::widgets {

class TakeModel;
class TakeFilter;

/// The rows of the takes with their interaction. The pointer on a strip, or Left and Right, browse the take.
class TakeView : public QListView {
  Q_OBJECT
 public:
  TakeView(TakeModel& model, TakeFilter& filter, QWidget* parent = nullptr);
  /// -1 if no row is current.
  int currentTake() const;
  void setCurrentTake(int take);

 signals:
  /// Browsing by pointer or key.
  void lookedAt(int take, int frame);
  void lookedAway();
  void activatedTake(int take);
  void currentTakeChanged(int take);
  void menuRequested(int take, const QPoint& at);

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;

 private:
  bool lookAlong(const QModelIndex& index, const QPoint& at, bool anywhere_in_height);
  void step(int frames);
  void stepToMove(int direction);

  TakeModel& m_model;
  TakeFilter& m_filter;
  QPersistentModelIndex m_dragged;
};

}  // namespace abrazo::widgets
