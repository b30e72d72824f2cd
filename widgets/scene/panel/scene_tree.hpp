#pragma once

#include <QWidget>
#include <array>
#include <vector>

#include "widgets/common/palette.hpp"
#include "widgets/scene/values/scene_tree_rows.hpp"

class QLineEdit;
class QScrollArea;

namespace abrazo::widgets {

class CharacterRows;
class SceneTreeList;

/// The parts of the scene as a tree, with a dot to show or hide each part and its count; a character expands
/// to its joints, which can be selected. Below it the files that the characters wear. Changes nothing itself:
/// it emits requests.
class SceneTree : public QWidget {
  Q_OBJECT
 public:
  explicit SceneTree(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  void setInputName(const QString& name);
  QSize sizeHint() const override;
  SceneTreeList& list() { return *m_list; }
  CharacterRows& characters() { return *m_characters; }

 public slots:
  void setVisibility(const abrazo::widgets::PartVisibility& visibility);
  void setCounts(const abrazo::widgets::PartCounts& counts);
  void showSelection(const abrazo::widgets::Selection& selection);

 signals:
  void visibilityRequested(const abrazo::widgets::PartVisibility& visibility);
  void selectionRequested(const abrazo::widgets::Selection& selection);

 private:
  QLineEdit* m_filter;
  QScrollArea* m_scroll;
  SceneTreeList* m_list;
  CharacterRows* m_characters;
};

/// The painted rows of the tree.
class SceneTreeList : public QWidget {
  Q_OBJECT
 public:
  static constexpr int row_height = 22;

  explicit SceneTreeList(QWidget* parent);
  const std::vector<TreeRow>& rows() const { return m_rows; }
  void setColours(const Palette& palette);
  void setFilter(const QString& filter);
  void setOpen(int character, bool open);
  void setInput(const QString& name);
  void setVisibility(const PartVisibility& visibility);
  void setCounts(const PartCounts& counts);
  void setSelection(const Selection& selection);
  const Selection& selection() const { return m_selection; }
  /// The current row for keys; -1 = none.
  int current() const { return m_current; }

 signals:
  void visibilityRequested(const abrazo::widgets::PartVisibility& visibility);
  void selectionRequested(const abrazo::widgets::Selection& selection);
  void currentChanged(int row);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void leaveEvent(QEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void rebuild();
  void setCurrent(int row);
  void describe();
  void act(int row, SelectionChange how);
  QString note(const TreeRow& row) const;
  void paintRow(QPainter& painter, int index) const;
  int rowAt(int y) const;

  Palette m_palette;
  PartVisibility m_visibility = default_visibility;
  PartCounts m_counts{};
  QString m_input = "clip", m_filter;
  std::array<bool, 2> m_open{};
  std::vector<TreeRow> m_rows;
  Selection m_selection;
  int m_hovered = -1, m_current = -1;
};

}  // namespace abrazo::widgets
