#pragma once

#include <QWidget>

#include "widgets/common/palette.hpp"
#include "widgets/video/video_overlay.hpp"

class QToolButton;

namespace abrazo::widgets {

class ValueSlider;

/// Parts and opacity of the overlay.
class OverlaySection : public QWidget {
  Q_OBJECT
 public:
  explicit OverlaySection(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  const OverlayParts& parts() const { return m_parts; }
  double opacity() const { return m_opacity; }

 signals:
  void partsChanged(const abrazo::widgets::OverlayParts& parts);
  void opacityChanged(double opacity);

 private:
  QToolButton* makeToggle(const QString& text, const QString& tip, bool OverlayParts::*part);
  void setOpacity(double opacity);

  OverlayParts m_parts;
  double m_opacity = usual_opacity;
  ValueSlider* m_slider;
  static constexpr double usual_opacity = 0.9;
};

}  // namespace abrazo::widgets
