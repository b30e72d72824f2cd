#include "widgets/common/parts.hpp"

#include <QComboBox>
#include <QFocusEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QTableView>
#include <utility>

#include "widgets/common/theme.hpp"

namespace abrazo::widgets {
namespace {

class EscapeOfField : public QObject {
 public:
  EscapeOfField(QLineEdit& field, QWidget& list) : QObject(&field), m_field(field), m_list(list) {
    field.installEventFilter(this);
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    const bool is_key = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
    if (!is_key || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape)
      return QObject::eventFilter(watched, event);
    event->accept();  // before the window's own Escape
    if (event->type() == QEvent::ShortcutOverride) return true;
    m_field.text().isEmpty() ? m_list.setFocus(Qt::OtherFocusReason) : m_field.clear();
    return true;
  }

 private:
  QLineEdit& m_field;
  QWidget& m_list;
};

class SelectedByClick : public QObject {
 public:
  explicit SelectedByClick(QLineEdit& field) : QObject(&field), m_field(field) {
    field.installEventFilter(this);
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::FocusIn)
      m_isFirst = static_cast<QFocusEvent*>(event)->reason() == Qt::MouseFocusReason;
    if (event->type() == QEvent::MouseButtonRelease && std::exchange(m_isFirst, false) &&
        !m_field.hasSelectedText())
      m_field.selectAll();
    return QObject::eventFilter(watched, event);
  }

 private:
  QLineEdit& m_field;
  bool m_isFirst = false;
};

class ShownUnderPointer : public QObject {
 public:
  ShownUnderPointer(QWidget& area, QWidget& button, std::function<bool()> may)
      : QObject(&button), m_button(button), m_may(std::move(may)) {
    area.installEventFilter(this);
    button.hide();
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Enter) m_button.setVisible(!m_may || m_may());
    if (event->type() == QEvent::Leave) m_button.hide();
    return QObject::eventFilter(watched, event);
  }

 private:
  QWidget& m_button;
  std::function<bool()> m_may;
};

}  // namespace

QLabel* quiet_label(const QString& text, QWidget* parent, int px) {
  auto* label = new QLabel(text, parent);
  label->setObjectName("secondary");
  if (px > 0) label->setFont(interface_font(px));
  return label;
}

void describe(QWidget& widget, const QString& name, const QString& tip) {
  widget.setAccessibleName(name);
  widget.setToolTip(tip);
}

void leave_by_escape(QLineEdit& field, QWidget& list) {
  new EscapeOfField(field, list);
}

void show_under_pointer(QWidget& area, QWidget& button, std::function<bool()> may) {
  QSizePolicy policy = button.sizePolicy();
  policy.setRetainSizeWhenHidden(true);
  button.setSizePolicy(policy);
  new ShownUnderPointer(area, button, std::move(may));
}

void make_typeable(QComboBox& box) {
  box.setEditable(true);
  box.setInsertPolicy(QComboBox::NoInsert);
  new SelectedByClick(*box.lineEdit());
}

void make_rows(QTableView& table, int row_px) {
  table.verticalHeader()->hide();
  table.verticalHeader()->setDefaultSectionSize(row_px);
  table.setSelectionBehavior(QAbstractItemView::SelectRows);
  table.setSelectionMode(QAbstractItemView::SingleSelection);
  table.setShowGrid(false);
}

}  // namespace abrazo::widgets
