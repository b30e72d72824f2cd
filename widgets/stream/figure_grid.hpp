#pragma once

#include <QWidget>
#include <vector>

#include "widgets/common/palette.hpp"
#include "widgets/stream/stream_words.hpp"

namespace abrazo::widgets {

/// Names and numbers in two columns; the positions depend only on the width.
class FigureGrid : public QWidget {
  Q_OBJECT
 public:
  explicit FigureGrid(const QString& name, QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  void show(std::vector<StreamFigure> figures);
  const std::vector<StreamFigure>& figures() const { return m_figures; }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;

 private:
  QRectF cell(std::size_t which) const;

  Palette m_palette;
  std::vector<StreamFigure> m_figures;
};

}  // namespace abrazo::widgets
