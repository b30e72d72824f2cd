#pragma once

#include <QBoxLayout>
#include <QLabel>
#include <QMargins>
#include <functional>

class QComboBox;
class QLineEdit;
class QTableView;

namespace abrazo::widgets {

/// Layout of a widget. @param spacing  -1 = that of the style
inline QHBoxLayout* row_in(QWidget* box, const QMargins& margins = {}, int spacing = -1) {
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(margins);
  row->setSpacing(spacing);
  return row;
}
inline QVBoxLayout* column_in(QWidget* box, const QMargins& margins = {}, int spacing = -1) {
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(margins);
  column->setSpacing(spacing);
  return column;
}
/// Layouts to be added to another layout.
inline QHBoxLayout* nested_row(const QMargins& margins = {}, int spacing = -1) {
  return row_in(nullptr, margins, spacing);
}
inline QVBoxLayout* nested_column(const QMargins& margins = {}, int spacing = -1) {
  return column_in(nullptr, margins, spacing);
}

/// A label in the colour of secondary text. @param px  size of its font; 0 = that of the window
QLabel* quiet_label(const QString& text, QWidget* parent = nullptr, int px = 0);

/// Names a widget for assistive technology, and explains it to all.
void describe(QWidget& widget, const QString& name, const QString& tip);

/// Of a field that finds something: Escape empties it, and once more goes to the list of what was found.
void leave_by_escape(QLineEdit& field, QWidget& list);

/// Shows a button only while the pointer is over the area; its room stays. What it does must be reachable
/// with the keyboard elsewhere.
/// @param may  whether there is anything for it to do; by default always
void show_under_pointer(QWidget& area, QWidget& button, std::function<bool()> may = {});

/// Lets a person type what is not listed. A click selects all of it: what is typed replaces "as found".
void make_typeable(QComboBox& box);

/// Rows of this height without grid and numbers, chosen one at a time.
void make_rows(QTableView& table, int row_px);

}  // namespace abrazo::widgets
