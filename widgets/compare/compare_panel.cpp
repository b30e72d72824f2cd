#include "widgets/compare/compare_panel.hpp"

#include <QButtonGroup>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>

#include "widgets/common/parts.hpp"
#include "widgets/common/scrolled.hpp"
#include "widgets/common/section_header.hpp"
#include "widgets/compare/compare_curve.hpp"
#include "widgets/compare/figure_table.hpp"
#include "widgets/compare/run_card.hpp"

namespace abrazo::widgets {
namespace {

const QMargins row_margins(12, 2, 12, 6);

QPushButton* button_in(QHBoxLayout* row, QWidget* box, const QString& text, const QString& tip) {
  auto* button = new QPushButton(text, box);
  button->setToolTip(tip);
  button->setFocusPolicy(Qt::TabFocus);
  button->setObjectName("small");
  row->addWidget(button);
  return button;
}

}  // namespace

ComparePanel::ComparePanel(QWidget* parent) : QWidget(parent) {
  setObjectName("panel");
  setAttribute(Qt::WA_StyledBackground);
  auto* outer = column_in(this, {}, 0);
  auto* content = new QWidget(this);
  content->setAutoFillBackground(false);
  m_column = column_in(content, {0, 4, 0, 8}, 0);
  m_a = new RunCard("A", content);
  m_b = new RunCard("B", content);
  m_curve = new CompareCurve(content);
  m_table = new FigureTable(content);
  m_note = quiet_label({}, content);
  m_note->setWordWrap(true);
  m_note->setContentsMargins(12, 2, 12, 4);
  for (QWidget* part : {static_cast<QWidget*>(m_a), static_cast<QWidget*>(m_b), makeButtons(), makeSpans(),
                        makeProgress(), static_cast<QWidget*>(m_note), makeCurveHead(),
                        static_cast<QWidget*>(m_curve), static_cast<QWidget*>(m_table)})
    m_column->addWidget(part);
  m_column->addStretch(1);
  auto* scroll = new QScrollArea(this);
  scroll_vertically(*scroll, content);
  outer->addWidget(scroll);
  connect(m_curve, &CompareCurve::seekRequested, this, &ComparePanel::seekRequested);
  showProgress(-1);
  showSides({});
  showNothing({});
}

QWidget* ComparePanel::makeButtons() {
  auto* box = new QWidget(this);
  auto* rows = column_in(box, {12, 2, 12, 6}, 6);
  auto* row = nested_row({}, 6);
  rows->addLayout(row);
  m_freeze = button_in(row, box, "Freeze A", "Store the current settings as A; later changes are B");
  m_swap = button_in(row, box, "Swap", "A gets the settings of B, and B those of A");
  m_adopt = button_in(row, box, "Adopt A", "Restores the settings of A");
  m_clear = button_in(row, box, "Clear", "Let A go");
  row->addStretch(1);
  // Below: beside the others it would be cut in a narrow panel.
  m_aside = new QToolButton(box);
  m_aside->setObjectName("chip");
  m_aside->setText("Live keeps A");
  m_aside->setCheckable(true);
  m_aside->setFocusPolicy(Qt::TabFocus);
  m_aside->setToolTip("Try B beside it: the live partner keeps A until this is switched off");
  rows->addWidget(m_aside, 0, Qt::AlignLeft);
  connect(m_freeze, &QPushButton::clicked, this, &ComparePanel::freezeRequested);
  connect(m_swap, &QPushButton::clicked, this, &ComparePanel::swapRequested);
  connect(m_adopt, &QPushButton::clicked, this, &ComparePanel::adoptRequested);
  connect(m_clear, &QPushButton::clicked, this, &ComparePanel::clearRequested);
  connect(m_aside, &QToolButton::clicked, this, &ComparePanel::asideRequested);
  return box;
}

QWidget* ComparePanel::makeSpans() {
  struct Choice {
    const char *text, *name, *tip;
  };
  constexpr Choice choices[] = {
      {"This frame", "this frame", "Parked: one step, from what the solver knew before this frame"},
      {"2 s", "2 s to here", "Parked: both runs start together 2 s before the cursor"},
      {"10 s", "10 s to here", "Parked: both runs start together 10 s before the cursor"},
      {"In to out", "in to out", "Both runs over the range between the in and out marks"}};
  auto* box = new QWidget(this);
  auto* row = row_in(box, row_margins, 0);
  auto* group = new QButtonGroup(box);
  for (const Choice& choice : choices) {
    auto* button = new QToolButton(box);
    button->setObjectName("segment");
    button->setProperty("first", m_spans.empty());
    button->setProperty("last", m_spans.size() + 1 == std::size(choices));
    button->setText(choice.text);
    describe(*button, QString("What if over: ") + choice.name, choice.tip);
    button->setCheckable(true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    group->addButton(button, static_cast<int>(m_spans.size()));
    row->addWidget(button, 1);
    m_spans.push_back(button);
  }
  m_spans[1]->setChecked(true);
  connect(group, &QButtonGroup::idClicked, this,
          [this](int chosen) { emit spanRequested(static_cast<WhatIfSpan>(chosen)); });
  return box;
}

QWidget* ComparePanel::makeProgress() {
  m_progressRow = new QWidget(this);
  auto* row = row_in(m_progressRow, row_margins, 8);
  m_progress = new QProgressBar(m_progressRow);
  m_progress->setRange(0, 100);
  m_progress->setTextVisible(false);
  m_progress->setFixedHeight(6);
  m_progress->setAccessibleName("Solving again");
  row->addWidget(m_progress, 1);
  auto* cancel = button_in(row, m_progressRow, "Cancel", "Stop solving; the results so far stay");
  connect(cancel, &QPushButton::clicked, this, &ComparePanel::cancelRequested);
  return m_progressRow;
}

QWidget* ComparePanel::makeCurveHead() {
  auto* box = new QWidget(this);
  auto* row = row_in(box, row_margins, 8);
  m_figure = new QComboBox(box);
  m_figure->setAccessibleName("Figure of the curve");
  m_figure->setFocusPolicy(Qt::TabFocus);
  for (std::size_t i = 0; i < step_figure_count; ++i) {
    const RunFigureInfo& info = info_of(static_cast<StepFigure>(i));
    m_figure->addItem(QString::fromUtf8(info.name.data(), static_cast<int>(info.name.size())));
    m_figure->setItemData(static_cast<int>(i),
                          QString::fromUtf8(info.help.data(), static_cast<int>(info.help.size())),
                          Qt::ToolTipRole);
  }
  row->addWidget(m_figure);
  row->addStretch(1);
  connect(m_figure, qOverload<int>(&QComboBox::currentIndexChanged), this,
          [this](int chosen) { m_curve->setFigure(static_cast<StepFigure>(chosen)); });
  return box;
}

void ComparePanel::setColours(const Palette& palette) {
  m_a->setColours(palette);
  m_b->setColours(palette);
  m_curve->setColours(palette);
  m_table->setColours(palette);
}

WhatIfSpan ComparePanel::span() const {
  for (std::size_t i = 0; i < m_spans.size(); ++i)
    if (m_spans[i]->isChecked()) return static_cast<WhatIfSpan>(i);
  return WhatIfSpan::TwoSeconds;
}

void ComparePanel::chooseSpan(WhatIfSpan span) {
  setSpan(span);
  emit spanRequested(span);
}

void ComparePanel::setSpan(WhatIfSpan span) {
  m_spans[static_cast<std::size_t>(span)]->setChecked(true);
}

QString ComparePanel::note() const {
  return m_note->text();
}

void ComparePanel::showSides(const CompareSides& sides) {
  m_a->showRun(sides.origin_a, sides.settings_a);
  m_b->showRun(sides.origin_b, sides.settings_b);
  m_swap->setEnabled(sides.is_frozen);
  m_adopt->setEnabled(sides.is_frozen);
  m_clear->setEnabled(sides.is_frozen);
  m_aside->setEnabled(sides.is_frozen);
  m_aside->setChecked(sides.is_aside);
}

void ComparePanel::showFigures(const RunFigures& a, const RunFigures& b,
                               const std::vector<ComparedStep>& steps, const QString& note) {
  const auto rows = figure_rows(a, b);
  m_a->showFigures(rows);
  m_b->showFigures(rows);
  m_table->showRows(rows);
  m_curve->setSteps(steps);
  m_note->setText(note);
}

void ComparePanel::showNothing(const QString& note) {
  m_a->showFigures({});
  m_b->showFigures({});
  m_table->showRows({});
  m_curve->setSteps({});
  m_note->setText(note);
}

void ComparePanel::showProgress(double fraction) {
  m_progressRow->setVisible(fraction >= 0);
  if (fraction >= 0) m_progress->setValue(static_cast<int>(100 * fraction));
}

void ComparePanel::showCursor(double time_s) {
  m_curve->setCursor(time_s);
}

}  // namespace abrazo::widgets
