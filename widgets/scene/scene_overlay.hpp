#pragma once

#include <QWidget>

#include "widgets/common/palette.hpp"
#include "widgets/scene/mesh_scalar.hpp"
#include "widgets/scene/scene_options.hpp"

class QToolButton;

namespace abrazo::widgets {

class SceneOptionsPanel;

/// A colour map with words.
struct LegendScale {
  QString title, low, high;
  bool is_diverging = false;
  bool operator==(const LegendScale& other) const {
    return title == other.title && low == other.low && high == other.high &&
           is_diverging == other.is_diverging;
  }
};

/// @param upper  of the map in the scalar's unit; 0 when there is nothing to show
LegendScale scalar_legend(MeshScalar scalar, double upper);
/// @param doublings  |log2 ratio| at the ends
LegendScale volume_legend(double doublings);

/// What colours mean: title with unit, colour bar, its two ends, and a lock that keeps the range.
class ScalarLegend : public QWidget {
  Q_OBJECT
 public:
  explicit ScalarLegend(QWidget* parent);
  void setColours(const Palette& palette);
  void show(const LegendScale& scale);
  /// Sets the lock without saying so.
  void setLocked(bool locked);

 signals:
  void lockToggled(bool locked);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void dressLock();
  Palette m_palette;
  LegendScale m_scale;
  QToolButton* m_lock;
};

/// Chips that choose what colours the mesh.
class ScalarChips : public QWidget {
  Q_OBJECT
 public:
  explicit ScalarChips(QWidget* parent);
  void setScalar(MeshScalar scalar);
  void setBetweenOnly(bool only);
  void setCells(bool shown);
  void setOptions(const SceneOptions& options);

 signals:
  void scalarChosen(abrazo::widgets::MeshScalar scalar);
  void betweenOnlyChosen(bool only);
  void cellsChosen(bool shown);
  void optionsRequested(const abrazo::widgets::SceneOptions& options);

 private:
  std::array<QToolButton*, mesh_scalar_count> m_scalars{};
  QToolButton *m_cells, *m_betweenOnly, *m_filter;
  SceneOptionsPanel* m_options;
  SceneOptions m_shown;
};

/// A few lines about the frame at the bottom left. Never takes the pointer.
class FrameFacts : public QWidget {
  Q_OBJECT
 public:
  explicit FrameFacts(QWidget* parent);
  void setColours(const Palette& palette);
  /// @param trouble  shown in the warning colour; empty when all is well
  void show(const QString& first, const QString& second, const QString& trouble);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Palette m_palette;
  QString m_first, m_second, m_trouble;
};

}  // namespace abrazo::widgets
