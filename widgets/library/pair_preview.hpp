#pragma once

#include <QWidget>

#include "widgets/common/palette.hpp"
#include "widgets/library/preview_scale.hpp"

class QSlider;

namespace abrazo::widgets {

/// Two small stick figures from the side and from above, to verify axes, unit and pairing of two motions.
class PairPreview : public QWidget {
  Q_OBJECT
 public:
  explicit PairPreview(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  /// @param b may have no clip: then one figure
  void show(const PreviewedClip& a, const PreviewedClip& b);
  int frame() const { return m_frame; }
  QSize sizeHint() const override { return {380, 250}; }

 public slots:
  void setFrame(int frame);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void paintView(QPainter& painter, const QRectF& area, bool from_above) const;
  void paintFloor(QPainter& painter, const QRectF& area, double scale, double floor) const;
  QString facts() const;

  Palette m_palette;
  PreviewedClip m_a, m_b;
  PreviewScale m_scale;
  int m_frame = 0;
  QSlider* m_slider;
};

}  // namespace abrazo::widgets
