#pragma once

#include <QString>
#include <QWidget>

class QPainter;

namespace abrazo::widgets {

/// Width of a text with all digits as wide as the widest, so that changing numbers do not jitter.
double tabular_width(const QFont& font, const QString& text);

/// Draws such a text into a rectangle, vertically centred, in the painter's font and pen.
void draw_tabular(QPainter& painter, const QRectF& rect, Qt::Alignment alignment, const QString& text);

/// A changing number. Its size hint only grows until `fit`, so the layout stays stable.
class TabularLabel : public QWidget {
  Q_OBJECT
 public:
  explicit TabularLabel(QWidget* parent = nullptr);
  void setText(const QString& text);
  const QString& text() const { return m_text; }
  /// As wide as the present text.
  void fit();
  void setColour(const QColor& colour);
  void setAlignment(Qt::Alignment alignment) { m_alignment = alignment; }
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString m_text;
  QColor m_colour;
  Qt::Alignment m_alignment = Qt::AlignLeft;
  int m_widest = 0;
};

}  // namespace abrazo::widgets
