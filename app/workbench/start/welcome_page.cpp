#include "app/workbench/start/welcome_page.hpp"

#include <QCheckBox>
#include <QFrame>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>
#include <array>

#include "widgets/common/icons.hpp"
#include "widgets/common/plain_text.hpp"
#include "widgets/common/section_header.hpp"
#include "widgets/common/theme.hpp"

namespace abrazo::app {
namespace {

constexpr int page_width = 348, edge = 12, section_height = 26;
constexpr int swatch_size = 14;

QLabel* sentence(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setWordWrap(true);
  label->setContentsMargins(edge, 0, edge, 0);
  return label;
}

/// As the characters are drawn: filled, with a solid or a dashed outline.
QPixmap swatch(const QColor& colour, const QColor& line, Qt::PenStyle outline, double ratio) {
  QPixmap pixmap(QSize(swatch_size, swatch_size) * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(colour);
  painter.setPen(QPen(line, 1.6, outline));
  painter.drawRoundedRect(QRectF(1.5, 1.5, swatch_size - 3, swatch_size - 3), 3, 3);
  return pixmap;
}

}  // namespace

WelcomePage::WelcomePage(QWidget* parent)
    : QWidget(parent),
      m_starts(new QVBoxLayout),
      m_recent(new QVBoxLayout),
      m_close(new QToolButton(this)),
      m_atStart(new QCheckBox("Show this page at the start", this)) {
  setObjectName("welcome");
  setAccessibleName("Welcome");
  setFixedWidth(page_width);
  auto* scroll = new QScrollArea(this);
  auto* page = new QWidget;
  page->setObjectName("panel");
  m_column = new QVBoxLayout(page);
  m_column->setContentsMargins(0, 0, 0, edge);
  m_column->setSpacing(0);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFocusPolicy(Qt::NoFocus);
  auto* around = new QHBoxLayout(this);
  around->setContentsMargins(0, 0, 0, 0);
  around->setSpacing(0);
  auto* column = new QVBoxLayout;
  column->setSpacing(0);
  column->addWidget(scroll, 1);
  around->addLayout(column);
  auto* line = new QFrame(this);
  line->setObjectName("rule");
  line->setFixedWidth(1);
  around->addWidget(line);

  auto* top = new QHBoxLayout;
  top->setContentsMargins(0, 0, 6, 0);
  top->addWidget(section("Welcome"), 1);
  top->addWidget(m_close);
  m_column->addLayout(top);
  m_close->setObjectName("quiet");
  m_close->setFixedSize(20, 20);
  m_close->setAccessibleName("Close the welcome page");
  m_close->setToolTip("Close; Help > Welcome brings it back");
  connect(m_close, &QToolButton::clicked, this, &WelcomePage::closeRequested);
  m_about = sentence({}, page);
  m_column->addWidget(m_about);
  showAbout(true);
  m_column->addWidget(section("Begin"));
  m_column->addLayout(m_starts);
  m_column->addWidget(section("Recent"));
  m_column->addLayout(m_recent);
  addColours();
  addKeys();
  m_column->addStretch(1);
  auto* foot = new QHBoxLayout;  // stays in sight where the page is scrolled
  foot->setContentsMargins(edge, 8, edge, 8);
  foot->addWidget(m_atStart);
  column->addLayout(foot);
  connect(m_atStart, &QCheckBox::toggled, this, &WelcomePage::shownAtStartChanged);
  scroll->setWidget(page);
  setRecent({}, {});
}

void WelcomePage::showAbout(bool is_generated) {
  m_about->setText(
      QString(
          "One dancer is the input. The partner is chosen from a library of pairs, and fitted by the mesh "
          "between the two bodies.") +
      (is_generated ? " What you see is generated." : ""));
}

widgets::SectionHeader* WelcomePage::section(const QString& title) {
  m_heads.push_back(new widgets::SectionHeader(title, this));
  if (m_heads.size() > 1) m_heads.back()->setFixedHeight(section_height);
  return m_heads.back();
}

QPushButton* WelcomePage::link(const QString& text, const QString& key) {
  auto* button = new QPushButton(this);
  button->setObjectName("link");
  button->setText(key.isEmpty() ? text : text + "   " + key);
  button->setAccessibleName(text);
  button->setCursor(Qt::PointingHandCursor);
  return button;
}

void WelcomePage::addStart(const QString& text, const QString& key, std::function<void()> act) {
  QPushButton* button = link(text, key);
  connect(button, &QPushButton::clicked, this, std::move(act));
  m_starts->addWidget(button);
}

void WelcomePage::setRecent(const QStringList& labels, const QStringList& tips) {
  while (QLayoutItem* old = m_recent->takeAt(0)) {
    old->widget()->deleteLater();
    delete old;
  }
  for (int i = 0; i < labels.size(); ++i) {
    QPushButton* button = link(labels[i], {});
    button->setToolTip(widgets::plain_tip(tips.value(i)));
    connect(button, &QPushButton::clicked, this, [this, i] { emit recentChosen(i); });
    m_recent->addWidget(button);
  }
  if (!labels.isEmpty()) return;
  QLabel* none = sentence("Nothing yet. Files can be dropped anywhere on the window.", this);
  none->setObjectName("secondary");
  m_recent->addWidget(none);
}

void WelcomePage::addColours() {
  m_column->addWidget(section("The colours"));
  auto* grid = new QGridLayout;
  grid->setContentsMargins(edge, 0, edge, 0);
  grid->setHorizontalSpacing(10);
  grid->setColumnStretch(1, 1);
  const QStringList words = {"the leader, who is active; solid outline",
                             "the follower, who is passive; dashed outline",
                             "the user as measured, and what the search compares"};
  for (const QString& meaning : words) {
    m_swatches.push_back(new QLabel(this));
    grid->addWidget(m_swatches.back(), grid->rowCount(), 0, Qt::AlignTop);
    auto* text = new QLabel(meaning, this);
    text->setWordWrap(true);
    grid->addWidget(text, grid->rowCount() - 1, 1);
  }
  m_column->addLayout(grid);
  QLabel* same = sentence("They mean the same in bars, lanes and plots.", this);
  same->setObjectName("secondary");
  m_column->addWidget(same);
}

void WelcomePage::addKeys() {
  m_column->addWidget(section("The first keys"));
  auto* grid = new QGridLayout;
  grid->setContentsMargins(edge, 0, edge, 0);
  grid->setHorizontalSpacing(14);
  grid->setColumnStretch(1, 1);
  const std::vector<std::pair<QString, QString>> keys = {
      {"Space", "play or pause"},           {"Left  Right", "a frame back, a frame forward"},
      {"End", "follow the live end again"}, {"F6", "to the next panel"},
      {"Ctrl+P", "find any command"},       {"F1", "the guide and all keys"}};
  for (const auto& [key, what] : keys) {
    auto* name = new QLabel(key, this);
    name->setFont(widgets::interface_font(13, QFont::DemiBold));
    grid->addWidget(name, grid->rowCount(), 0);
    grid->addWidget(new QLabel(what, this), grid->rowCount() - 1, 1);
  }
  m_column->addLayout(grid);
}

void WelcomePage::setColours(const widgets::Palette& palette) {
  for (widgets::SectionHeader* head : m_heads) head->setColours(palette);
  const std::array colours = {palette.active, palette.passive, palette.user};
  for (std::size_t i = 0; i < m_swatches.size(); ++i)
    m_swatches[i]->setPixmap(
        swatch(colours[i], palette.text, i == 1 ? Qt::DotLine : Qt::SolidLine, devicePixelRatioF()));
  m_close->setIcon(widgets::icon(widgets::Icon::Close, palette.secondary));
}

void WelcomePage::setShownAtStart(bool on) {
  m_atStart->setChecked(on);
}

void WelcomePage::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) return emit closeRequested();
  QWidget::keyPressEvent(event);
}

}  // namespace abrazo::app
