#pragma once

#include <QObject>

#include "widgets/common/selection.hpp"

namespace abrazo::widgets {

/// The one selection that all views show. A view asks it to select and shows what it answers; no view keeps
/// one of its own.
class SelectionModel : public QObject {
  Q_OBJECT
 public:
  explicit SelectionModel(QObject* parent = nullptr) : QObject(parent) {}
  const Selection& selection() const { return m_selection; }

 public slots:
  void select(const abrazo::widgets::Selection& selection) {
    if (selection == m_selection) return;
    m_selection = selection;
    emit selectionChanged(m_selection);
  }

 signals:
  void selectionChanged(const abrazo::widgets::Selection& selection);

 private:
  Selection m_selection;
};

/// What a click does with the keys that are held: Ctrl toggles, Shift adds.
inline SelectionChange selection_change(Qt::KeyboardModifiers keys) {
  if (keys & Qt::ControlModifier) return SelectionChange::Toggle;
  return keys & Qt::ShiftModifier ? SelectionChange::Add : SelectionChange::Replace;
}

}  // namespace abrazo::widgets

Q_DECLARE_METATYPE(abrazo::widgets::Selection)
