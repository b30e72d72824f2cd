#pragma once

#include <QWidget>

class QVBoxLayout;

namespace abrazo::widgets {

/// Bars over a view. They come and go without moving or resizing anything: a button that the pointer is about
/// to click stays where it is, and the view keeps its frame buffers.
class NoticeColumn : public QWidget {
  Q_OBJECT
 public:
  explicit NoticeColumn(QWidget* parent);
  /// Below those that were added before.
  void add(QWidget* bar);
  /// Above all of them: their coming and going does not move it.
  void addFirst(QWidget* bar);
  /// The bars begin at the top of this part of the parent and are as wide.
  void setRoom(const QRect& room);

 protected:
  bool event(QEvent* event) override;

 private:
  void fit();

  QVBoxLayout* m_bars;
  QRect m_room;
};

}  // namespace abrazo::widgets
