#include "widgets/sweep/sweep_panel.hpp"

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include "widgets/common/parts.hpp"
#include "widgets/common/typeset.hpp"
#include "widgets/sweep/heat_map.hpp"
#include "widgets/sweep/sweep_form.hpp"

namespace abrazo::widgets {

SweepPanel::SweepPanel(QWidget* parent) : QWidget(parent) {
  auto* column = column_in(this, {16, 14, 16, 14}, 10);
  m_form = new SweepForm(this);
  m_map = new HeatMap(this);
  column->addWidget(m_form);
  column->addWidget(buttons());
  column->addWidget(m_map, 1);
  column->addWidget(findings());
  connect(m_form, &SweepForm::changed, this, &SweepPanel::edited);
  connect(m_form, &SweepForm::metricChosen, this, &SweepPanel::metricChosen);
  connect(m_map, &HeatMap::selectionChanged, this, &SweepPanel::tell);
  connect(m_map, &HeatMap::adoptRequested, this, &SweepPanel::adoptRequested);
  connect(m_map, &HeatMap::hovered, this, [this](int point) {
    m_hovered = point;
    tell();
  });
  setRunning(false);
  tell();
}

QWidget* SweepPanel::buttons() {
  auto* box = new QWidget(this);
  auto* row = row_in(box, {}, 10);
  m_estimate = new QLabel(box);
  m_estimate->setWordWrap(true);
  m_progress = new QProgressBar(box);
  m_progress->setRange(0, 1000);
  m_progress->setTextVisible(false);
  m_progress->setFixedHeight(6);
  m_progress->setAccessibleName("Progress of the sweep");
  auto* words = nested_column({}, 4);
  words->addWidget(m_estimate);
  words->addWidget(m_progress);
  m_start = new QPushButton(box);
  m_start->setObjectName("startSweep");
  m_start->setMinimumWidth(90);
  m_start->setAutoDefault(false);  // Return in a field does not start the sweep
  row->addLayout(words, 1);
  row->addWidget(m_start, 0, Qt::AlignTop);
  connect(m_start, &QPushButton::clicked, this,
          [this] { m_running ? emit cancelRequested() : emit startRequested(m_form->request()); });
  return box;
}

QWidget* SweepPanel::findings() {
  auto* box = new QWidget(this);
  auto* row = row_in(box, {}, 8);
  auto* words = nested_column({}, 2);
  m_best = new QLabel(box);
  m_best->setWordWrap(true);
  m_best->setTextFormat(Qt::RichText);
  m_cell = new QLabel(box);
  m_cell->setWordWrap(true);
  m_cell->setMinimumHeight(34);
  m_cell->setTextFormat(Qt::RichText);
  m_cell->setAlignment(Qt::AlignTop);
  words->addWidget(m_best);
  words->addWidget(m_cell);
  m_adopt = new QPushButton("Adopt", box);
  m_adopt->setObjectName("adoptCell");
  m_adopt->setToolTip("Applies both settings of the selected cell to the solver, as one undo step");
  m_export = new QPushButton("Export\u2026", box);
  m_export->setObjectName("exportSweep");
  m_export->setToolTip("The report that abrazo sweep writes, as a page (HTML) or as JSON");
  m_adopt->setAutoDefault(false);
  m_export->setAutoDefault(false);
  row->addLayout(words, 1);
  row->addWidget(m_adopt, 0, Qt::AlignTop);
  row->addWidget(m_export, 0, Qt::AlignTop);
  connect(m_adopt, &QPushButton::clicked, this, [this] { emit adoptRequested(m_map->selected()); });
  connect(m_export, &QPushButton::clicked, this, &SweepPanel::exportRequested);
  return box;
}

void SweepPanel::setColours(const Palette& palette) {
  m_map->setColours(palette);
  m_warning = palette.dark ? palette.warning : palette.live;
  m_secondary = palette.secondary;
  showEstimate(m_estimate->text(), m_usable);
}

void SweepPanel::showEstimate(const QString& words, bool usable) {
  m_usable = usable;
  m_estimate->setText(words);
  m_estimate->setStyleSheet(QString("color: %1").arg((usable ? m_secondary : m_warning).name()));
  m_start->setEnabled(m_running || usable);
}

void SweepPanel::showGrid(const SweepGrid& grid) {
  m_map->showGrid(grid);
  tell();
}

void SweepPanel::showProgress(double fraction, const QString& words) {
  m_progress->setValue(static_cast<int>(1000 * fraction));
  showEstimate(words, true);
}

void SweepPanel::setRunning(bool running) {
  m_running = running;
  m_start->setText(running ? "Cancel" : "Start");
  m_progress->setVisible(running);
  m_form->setRunning(running);
  m_start->setEnabled(running || m_usable);
}

void SweepPanel::tell() {
  const SweepGrid& grid = m_map->grid();
  const int shown = m_hovered >= 0 ? m_hovered : m_map->selected();
  const auto rich = [](const std::string& plain) { return QString::fromStdString(typeset(plain)); };
  m_best->setText(grid.empty() ? QString() : rich(grid.best_text()));
  if (grid.empty())
    m_cell->clear();
  else if (shown < 0 || shown >= grid.points())
    m_cell->setText("Click a cell, or go there with the arrow keys, to select it; a double click adopts it.");
  else
    m_cell->setText(rich((m_hovered >= 0 ? "Under the pointer: " : "Selected: ") + grid.place_text(shown)) +
                    ": " + QString::fromStdString(escaped_html(grid.value_text(shown))));
  m_adopt->setEnabled(m_map->selected() >= 0);
  m_export->setEnabled(!grid.empty() && grid.best().has_value());
}

}  // namespace abrazo::widgets
