#pragma once

#include <QWidget>

#include "widgets/common/palette.hpp"
#include "widgets/scene/scene_parts.hpp"

namespace abrazo::widgets {

/// What the scene shows, as an indented list with a dot to show or hide each part and how many there are of
/// it.
class SceneTree : public QWidget {
  Q_OBJECT
 public:
  explicit SceneTree(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  void setInputName(const QString& name);
  QSize sizeHint() const override;

 public slots:
  void setVisibility(const abrazo::widgets::PartVisibility& visibility);
  void setCounts(const abrazo::widgets::PartCounts& counts);

 signals:
  void visibilityRequested(const abrazo::widgets::PartVisibility& visibility);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  QString note(int row) const;
  bool isOn(int row) const;

  Palette m_palette;
  PartVisibility m_visibility = default_visibility;
  PartCounts m_counts{};
  QString m_input = "clip";
  int m_hovered = -1;
};

}  // namespace abrazo::widgets
