#pragma once

#include <QWidget>

#include "widgets/common/palette.hpp"
#include "widgets/scene/mesh_scalar.hpp"

class QToolButton;

namespace abrazo::widgets {

/// What the colours of the mesh mean: title with unit, colour bar, its two ends, and a lock that keeps the
/// range.
class ScalarLegend : public QWidget {
  Q_OBJECT
 public:
  explicit ScalarLegend(QWidget* parent);
  void setColours(const Palette& palette);
  void show(MeshScalar scalar, double upper);
  bool isLocked() const;

 signals:
  void lockToggled(bool locked);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void dressLock();
  Palette m_palette;
  MeshScalar m_scalar = MeshScalar::Residual;
  double m_upper = -1;
  QToolButton* m_lock;
};

/// Chips that choose what colours the mesh.
class ScalarChips : public QWidget {
  Q_OBJECT
 public:
  explicit ScalarChips(QWidget* parent);
  void setScalar(MeshScalar scalar);
  void setBetweenOnly(bool only);

 signals:
  void scalarChosen(abrazo::widgets::MeshScalar scalar);
  void betweenOnlyChosen(bool only);

 private:
  std::array<QToolButton*, 3> m_scalars{};
  QToolButton* m_betweenOnly;
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
