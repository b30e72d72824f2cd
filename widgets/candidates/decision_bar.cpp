#include "widgets/candidates/decision_bar.hpp"

#include <QKeyEvent>
#include <QPainter>
#include <QToolButton>

#include "widgets/candidates/pin_mark.hpp"
#include "widgets/common/icons.hpp"
#include "widgets/common/parts.hpp"
#include "widgets/common/plain_text.hpp"
#include "widgets/common/theme.hpp"

namespace abrazo::widgets {
namespace {

constexpr int gap = 4;
constexpr int margin = 12;
constexpr int button_height = 24;

/// Return and Space press it, although Space plays and pauses elsewhere in the window.
class LiftButton : public QToolButton {
 public:
  using QToolButton::QToolButton;

 protected:
  bool event(QEvent* event) override {
    if (event->type() == QEvent::ShortcutOverride && presses(static_cast<QKeyEvent*>(event))) event->accept();
    return QToolButton::event(event);
  }
  void keyPressEvent(QKeyEvent* event) override {
    presses(event) ? click() : QToolButton::keyPressEvent(event);
  }

 private:
  static bool presses(const QKeyEvent* event) {
    return event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter || event->key() == Qt::Key_Space;
  }
};

QIcon mark(const Decision& decision, const Palette& palette) {
  return painted_icon({12, 14}, [&](QPainter& painter) {
    if (decision.kind == Decision::Kind::Pin) draw_pin(painter, {6, 7}, palette.warning, true);
    if (decision.kind == Decision::Kind::Veto) draw_veto(painter, {6, 7}, palette.secondary);
    if (decision.kind == Decision::Kind::Meant) draw_meant(painter, {6, 7}, palette.warning);
  });
}

}  // namespace

DecisionBar::DecisionBar(QWidget* parent) : QWidget(parent), m_palette(palette_of(Theme::Dark)) {
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  setAccessibleName("Decisions in force");
  hide();
}

void DecisionBar::setColours(const Palette& palette) {
  m_palette = palette;
  for (std::size_t i = 0; i < m_buttons.size(); ++i) m_buttons[i]->setIcon(mark(m_decisions[i], palette));
}

void DecisionBar::setDecisions(std::vector<Decision> decisions) {
  m_decisions = std::move(decisions);
  makeButtons();
  setVisible(!m_decisions.empty());
  arrange();
  updateGeometry();
}

void DecisionBar::makeButtons() {
  for (QToolButton* button : m_buttons) {
    button->hide();
    button->deleteLater();  // one of them may be the clicked button
  }
  m_buttons.clear();
  for (const Decision& decision : m_decisions) {
    auto* button = new LiftButton(this);
    const QString what = QString::fromStdString(decision.text);
    button->setObjectName("chip");
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setFont(interface_font(12));
    button->setIcon(mark(decision, m_palette));
    button->setIconSize({12, 14});
    button->setText(what + "  ✕");
    button->setFocusPolicy(Qt::StrongFocus);
    const QString lift = decision.kind == Decision::Kind::Pin     ? "Unpin the pair: " + what
                         : decision.kind == Decision::Kind::Meant ? "Cancel it, " + what
                                                                  : "Remove the veto: " + what;
    describe(*button, lift, plain_tip(lift));
    connect(button, &QToolButton::clicked, this, [this, decision] { emit lifted(decision); });
    button->show();
    m_buttons.push_back(button);
  }
}

/// Flow layout: side by side, then the next line. @return the required height
int DecisionBar::arrange() {
  int x = margin, y = gap;
  for (QToolButton* button : m_buttons) {
    const int wide = std::min(button->sizeHint().width(), std::max(40, width() - 2 * margin));
    if (x > margin && x + wide > width() - margin) {
      x = margin;
      y += button_height + gap;
    }
    button->setGeometry(x, y, wide, button_height);
    x += wide + gap;
  }
  const int needed = m_buttons.empty() ? 0 : y + button_height + gap;
  if (needed != minimumHeight()) setFixedHeight(needed);
  return needed;
}

void DecisionBar::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  arrange();
}

QSize DecisionBar::sizeHint() const {
  return {200, minimumHeight()};
}

QSize DecisionBar::minimumSizeHint() const {
  return {60, minimumHeight()};
}

}  // namespace abrazo::widgets
