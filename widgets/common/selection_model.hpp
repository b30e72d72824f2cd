#pragma once

#include <QObject>

#include "widgets/common/selection.hpp"

Q_DECLARE_METATYPE(abrazo::widgets::Selection)

namespace abrazo::widgets {

/// The one selection shared by all views. A view requests a selection and shows the model's; no view keeps
/// its own.
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

/// Effect of a click with modifier keys: Ctrl toggles, Shift adds.
inline SelectionChange selection_change(Qt::KeyboardModifiers keys) {
  if (keys & Qt::ControlModifier) return SelectionChange::Toggle;
  return keys & Qt::ShiftModifier ? SelectionChange::Add : SelectionChange::Replace;
}

}  // namespace abrazo::widgets
