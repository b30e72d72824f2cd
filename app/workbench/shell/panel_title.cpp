#include "app/workbench/shell/panel_title.hpp"

#include <QContextMenuEvent>
#include <QDockWidget>
#include <QMenu>
#include <QToolButton>

#include "widgets/common/icons.hpp"
#include "widgets/common/parts.hpp"
#include "widgets/common/section_header.hpp"

namespace abrazo::app {

PanelTitle::PanelTitle(widgets::SectionHeader* header, QDockWidget* panel)
    : QWidget(panel),
      m_panel(panel),
      m_header(header),
      m_more(button("Move or float the panel ")),
      m_close(button("Close the panel ")) {
  setObjectName("panel");
  setAttribute(Qt::WA_StyledBackground);
  auto* row = widgets::row_in(this, {0, 0, 4, 0}, 0);
  row->addWidget(m_header, 1);
  row->addWidget(m_more);
  row->addWidget(m_close);
  m_more->setMenu(makeMenu());
  m_more->setPopupMode(QToolButton::InstantPopup);
  connect(m_close, &QToolButton::clicked, this, &PanelTitle::closeRequested);
  for (QToolButton* each : {m_more, m_close}) widgets::show_under_pointer(*this, *each);
}

QToolButton* PanelTitle::button(const QString& what) {
  auto* made = new QToolButton(this);
  made->setObjectName("quiet");
  made->setFixedSize(20, 20);
  made->setFocusPolicy(Qt::NoFocus);  // View > Panels does the same with the keyboard
  widgets::describe(*made, what + m_panel->windowTitle(), what + m_panel->windowTitle());
  return made;
}

QMenu* PanelTitle::makeMenu() {
  auto* menu = new QMenu(this);
  QAction* floats = menu->addAction("Float", this, [this] { m_panel->setFloating(!m_panel->isFloating()); });
  connect(menu, &QMenu::aboutToShow, floats,
          [this, floats] { floats->setText(m_panel->isFloating() ? "Back into the window" : "Float"); });
  menu->addSeparator();
  const auto add = [&](const QString& text, Qt::DockWidgetArea area) {
    menu->addAction(text, this, [this, area] { emit moveRequested(area); });
  };
  add("To the left", Qt::LeftDockWidgetArea);
  add("To the right", Qt::RightDockWidgetArea);
  add("Below the scene", Qt::BottomDockWidgetArea);
  menu->addSeparator();
  menu->addAction("Close", this, &PanelTitle::closeRequested);
  return menu;
}

void PanelTitle::contextMenuEvent(QContextMenuEvent* event) {
  m_more->menu()->popup(event->globalPos());
}

void PanelTitle::setColours(const widgets::Palette& palette) {
  m_header->setColours(palette);
  const QColor quiet = widgets::mixed(palette.secondary, palette.panel, 0.75);
  m_more->setIcon(widgets::icon(widgets::Icon::More, quiet));
  m_close->setIcon(widgets::icon(widgets::Icon::Close, quiet));
}

}  // namespace abrazo::app
