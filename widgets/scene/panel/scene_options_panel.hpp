#pragma once

#include <QFrame>
#include <vector>

#include "widgets/scene/values/scene_options.hpp"

class QDoubleSpinBox;
class QLabel;
class QSlider;
class QToolButton;

namespace abrazo::widgets {

/// Pop-up: shown edges, spacing of cells, cutting plane, trails.
class SceneOptionsPanel : public QFrame {
  Q_OBJECT
 public:
  explicit SceneOptionsPanel(QWidget* parent);
  /// Of the coloured value, which its limits are in.
  void setUnit(const QString& unit);
  void setOptions(const SceneOptions& options);

 signals:
  void optionsRequested(const abrazo::widgets::SceneOptions& options);

 protected:
  bool event(QEvent* event) override;

 private:
  QWidget* withValue(QSlider* slider, QLabel*& value);
  void showValues();
  SceneOptions asked() const;
  QToolButton* tick(const QString& text, const QString& tip);
  QDoubleSpinBox* length(const QString& name, const QString& tip);
  QDoubleSpinBox* value(const QString& name, const QString& tip);

  SceneOptions m_options;
  std::vector<QWidget*> fields() const;

  QDoubleSpinBox *m_shortest, *m_longest, *m_least, *m_most, *m_trail;
  QToolButton *m_isolates, *m_cuts, *m_inWorld;
  QSlider *m_apart, *m_cut, *m_turn, *m_tilt;
  QLabel *m_apartValue, *m_cutValue, *m_turnValue, *m_tiltValue;
};

}  // namespace abrazo::widgets
