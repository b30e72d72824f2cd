#pragma once

#include <QWidget>
#include <array>
#include <vector>

#include "widgets/common/palette.hpp"
#include "widgets/scene/values/mesh_scalar.hpp"
#include "widgets/scene/values/scene_options.hpp"

class QAction;
class QMenu;
class QToolButton;

namespace abrazo::widgets {

class SceneOptionsPanel;

/// Chips that choose what colours the mesh, and which of it is shown.
class ScalarChips : public QWidget {
  Q_OBJECT
 public:
  explicit ScalarChips(QWidget* parent);
  void setScalar(MeshScalar scalar);
  void setBetweenOnly(bool only);
  void setCells(bool shown);
  void setOptions(const SceneOptions& options);
  /// Uses shorter texts if the full ones do not fit, and several rows if these do not either.
  void fitInto(int width_px);
  /// Height below which no chip reaches beyond `x_px`; 0 if none does.
  int freeFrom(int x_px) const;

 signals:
  void scalarChosen(abrazo::widgets::MeshScalar scalar);
  void betweenOnlyChosen(bool only);
  void cellsChosen(bool shown);
  void optionsRequested(const abrazo::widgets::SceneOptions& options);

 private:
  void openFilter();
  QMenu* makeColours();
  void say(bool is_short);
  void sayColour();
  std::vector<std::vector<QToolButton*>> inRows(int width_px) const;

  std::array<QAction*, mesh_scalar_count> m_scalars{};
  QAction* m_cells = nullptr;
  QToolButton *m_colour, *m_betweenOnly, *m_filter;
  SceneOptionsPanel* m_options;
  int m_room = 0;  ///< width that the chips were last fitted into [px]
  SceneOptions m_shown;
};

/// A few lines about the frame at the bottom left. Ignores the pointer.
class FrameFacts : public QWidget {
  Q_OBJECT
 public:
  /// A line, and what is shown of it where it does not fit.
  struct Line {
    QString whole, brief;
    bool operator==(const Line&) const = default;
  };
  explicit FrameFacts(QWidget* parent);
  void setColours(const Palette& palette);
  /// @param trouble shown in the warning colour; empty = none
  void show(const Line& first, const QString& second, const QString& trouble);
  /// As it is drawn.
  QString firstLine() const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString fitting(const QString& line) const;

  Palette m_palette;
  Line m_first;
  QString m_second, m_trouble;
};

}  // namespace abrazo::widgets
