#pragma once

#include <QWidget>
#include <vector>

#include "widgets/common/palette.hpp"
#include "widgets/video/pick_mark.hpp"

namespace abrazo::widgets {

/// The picked joints with their reprojection errors.
class PickList : public QWidget {
  Q_OBJECT
 public:
  explicit PickList(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  void show(std::vector<PickMark> picks);
  void select(int index);
  int selected() const { return m_selected; }
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }
  /// One line for screen readers.
  QString lineOf(int index) const;

 signals:
  void chosen(int index);
  void removeRequested(int index);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  int rowAt(int y) const;
  QRect removeAt(int row) const;

  Palette m_palette;
  std::vector<PickMark> m_picks;
  int m_selected = -1, m_hovered = -1;
};

}  // namespace abrazo::widgets
