#include "widgets/plots/plot_panel.hpp"

#include <QPainter>
#include <QScrollBar>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/session/frames/frame_gaps.hpp"
#include "widgets/common/utf8.hpp"
#include "widgets/plots/plot_colours.hpp"
#include "widgets/plots/plot_menu.hpp"
#include "widgets/plots/plot_pane.hpp"
#include "widgets/plots/plot_picture.hpp"
#include "widgets/plots/selection_series.hpp"

namespace abrazo::widgets {
namespace {

constexpr std::size_t newest_kept = 40'000;  // rows: five minutes and a half at 120 Hz
constexpr std::size_t older_kept = 40'000;

/// "leader lhand [mm]"
std::string panel_title(const Selection& selection, const PaneSeries& series) {
  Selection named = selection;
  if (named.kind == SelectionKind::Joints) named = Selection::joint(named.last_joint());
  const std::string name = named.kind == SelectionKind::Tetrahedron ? "tetrahedron" : name_of(named);
  const std::string_view unit = info_of(series.front()).unit;
  return unit == "1" ? name : name + " [" + std::string(unit) + "]";
}

}  // namespace

struct PlotPanel::Parts {
  std::vector<PlotPane*> panes;
  QScrollBar* scroll = nullptr;  ///< by rows of panes
  SampleTable table;
  FrameGaps gaps;
  SeriesReader reader;
  Selection selection;
  PaneSeries selected;  ///< series of the pane of the selection; without one when empty
  SelectionReader selection_reader;
  std::uint64_t unread_before = 0;  ///< rows of frames before this one have another selection's values
  PlotWindow window;
  Playback playback;
  Palette palette = palette_of(Theme::Dark);
  std::uint64_t next_index = 0;
  std::optional<double> pointer_s;
  static constexpr std::uint64_t no_frame = ~std::uint64_t{0};
  std::pair<std::uint64_t, SeriesValues> read_again{no_frame, {}};  ///< of this frame, from the history

  const SeriesValues* values_of(const FrameSnapshot& frame, const FrameHistory& history);
};

/// Values of its row; for thinned rows, which hold extremes, those of the frame itself.
const SeriesValues* PlotPanel::Parts::values_of(const FrameSnapshot& frame, const FrameHistory& history) {
  const bool is_thinned = table.thinned() > 0 && frame.time_s < table.rows()[table.thinned()].time_s;
  if (!is_thinned) {
    const SampleTable::Row* row = table.at(frame.time_s);
    return row ? &row->values : nullptr;
  }
  if (read_again.first == frame.index) return &read_again.second;
  SeriesReader here;
  SelectionReader of_selection(selection);
  if (const auto before = history.stepped(frame.time_s, -1)) {
    here.read(*before);
    of_selection.read(*before, read_again.second);
  }
  read_again = {frame.index, here.read(frame)};
  of_selection.read(frame, read_again.second);
  return &read_again.second;
}

PlotPanel::PlotPanel(QWidget* parent) : QWidget(parent), m_parts(std::make_unique<Parts>()) {
  setAccessibleName("Plots");
  m_parts->scroll = new QScrollBar(Qt::Vertical, this);
  m_parts->scroll->setAccessibleName("More plots");
  m_parts->scroll->hide();
  connect(m_parts->scroll, &QScrollBar::valueChanged, this, [this] {
    arrangePanes();
    draw();
  });
  setArrangement(default_arrangement());
}

PlotPanel::~PlotPanel() = default;

PlotPane* PlotPanel::makePane() {
  auto* pane = new PlotPane(this);
  pane->setColours(m_parts->palette);
  connect(pane, &PlotPane::seekRequested, this, &PlotPanel::seekRequested);
  connect(pane, &PlotPane::panRequested, this, [this](double by_s) {
    m_parts->window.pan(by_s);
    draw();
  });
  connect(pane, &PlotPane::zoomRequested, this, [this](double factor, double fixed_s) {
    m_parts->window.zoom(factor, fixed_s);
    draw();
  });
  connect(pane, &PlotPane::followRequested, this, [this] {
    attach();
    emit followRequested();
  });
  connect(pane, &PlotPane::pointerMoved, this,
          [this, pane](double time_s, const QPoint& global) { showReadout(time_s, global, pane); });
  connect(pane, &PlotPane::pointerLeft, this, [this] {
    m_parts->pointer_s.reset();
    QToolTip::hideText();
    draw();
  });
  connect(pane, &PlotPane::menuRequested, this, [this, pane](const QPoint& global) {
    const auto& panes = m_parts->panes;
    const auto which = std::ranges::find(panes, pane) - panes.begin();
    show_pane_menu(*this, static_cast<int>(which), global);
  });
  return pane;
}

void PlotPanel::setColours(const Palette& palette) {
  m_parts->palette = palette;
  for (PlotPane* pane : m_parts->panes) pane->setColours(palette);
  update();
}

void PlotPanel::clear() {
  m_parts->next_index = 0;
  m_parts->table.clear();
  m_parts->gaps = {};
  m_parts->reader = {};
  m_parts->selection_reader = SelectionReader(m_parts->selection);
  m_parts->unread_before = 0;
  m_parts->read_again.first = Parts::no_frame;
  m_parts->playback = {};
  m_parts->window.attach();
  for (PlotPane* pane : m_parts->panes) pane->axis()->forget();
}

PaneArrangement PlotPanel::arrangement() const {
  PaneArrangement panes;
  for (const PlotPane* pane : m_parts->panes) panes.push_back(pane->series());
  if (selectionPane() >= 0) panes.pop_back();
  return panes;
}

int PlotPanel::selectionPane() const {
  return m_parts->selected.empty() ? -1 : paneCount() - 1;
}

const Selection& PlotPanel::selection() const {
  return m_parts->selection;
}

void PlotPanel::setArrangement(const PaneArrangement& arranged) {
  auto& panes = m_parts->panes;
  PaneArrangement wanted = arranged;
  if (!m_parts->selected.empty()) wanted.push_back(m_parts->selected);
  const bool are_more = wanted.size() > panes.size();
  while (panes.size() > wanted.size()) {
    panes.back()->hide();
    panes.back()->deleteLater();  // it may be what asked
    panes.pop_back();
  }
  while (panes.size() < wanted.size()) panes.push_back(makePane());
  for (std::size_t p = 0; p < wanted.size(); ++p)
    if (panes[p]->series() != wanted[p]) panes[p]->setSeries(wanted[p]);
  for (PlotPane* pane : panes) {
    const auto first = std::ranges::find_if(
        panes, [pane](const PlotPane* other) { return share_scale(other->series(), pane->series()); });
    if (first != panes.end()) pane->setAxis((*first)->axis());
  }
  for (PlotPane* pane : panes) pane->setTitle({});
  if (selectionPane() >= 0) panes.back()->setTitle(panel_title(m_parts->selection, m_parts->selected));
  arrangePanes();
  if (are_more) m_parts->scroll->setValue(m_parts->scroll->maximum());  // what was added is the last
  draw();
}

void PlotPanel::change(PaneArrangement panes) {
  setArrangement(panes);
  emit arrangementChanged();
}

void PlotPanel::addPane(const PaneSeries& series) {
  PaneArrangement panes = arrangement();
  if (series.empty() || panes.size() >= most_panes) return;
  panes.push_back(series);
  change(std::move(panes));
}

void PlotPanel::removePane(int which) {
  PaneArrangement panes = arrangement();
  if (which >= 0 && which == selectionPane()) return emit selectionRequested({});
  if (which < 0 || which >= paneCount() || panes.size() == 1) return;
  panes.erase(panes.begin() + which);
  change(std::move(panes));
}

void PlotPanel::movePane(int which, int by) {
  PaneArrangement panes = arrangement();
  const int to = which + by, count = static_cast<int>(panes.size());
  if (which < 0 || which >= count || to < 0 || to >= count) return;
  std::swap(panes[static_cast<std::size_t>(which)], panes[static_cast<std::size_t>(to)]);
  change(std::move(panes));
}

bool PlotPanel::setShown(int which, Series series, bool on) {
  if (which < 0 || which >= paneCount()) return false;
  PaneArrangement panes = arrangement();
  const bool of_selection = which == selectionPane();
  PaneSeries& pane = of_selection ? m_parts->selected : panes[static_cast<std::size_t>(which)];
  const bool is_shown = std::ranges::find(pane, series) != pane.end();
  if (on == is_shown) return true;
  if (on ? !can_join(pane, series) : pane.size() == 1) return false;
  if (on)
    pane.push_back(series);
  else
    std::erase(pane, series);
  std::ranges::sort(pane);
  of_selection ? setArrangement(panes) : change(std::move(panes));
  return true;
}

void PlotPanel::restoreUsual() {
  change(default_arrangement());
}

const PlotWindow& PlotPanel::window() const {
  return m_parts->window;
}

int PlotPanel::paneCount() const {
  return static_cast<int>(m_parts->panes.size());
}

PlotPane& PlotPanel::pane(int which) const {
  return *m_parts->panes.at(static_cast<std::size_t>(which));
}

double PlotPanel::cursorX() const {
  const PlotPane* first = m_parts->panes.front();
  return first->x() + first->xOf(m_parts->playback.cursor_s);
}

void PlotPanel::arrangePanes() {
  const auto& panes = m_parts->panes;
  QScrollBar& scroll = *m_parts->scroll;
  const PaneGrid grid = plan_panes(paneCount(), width(), height());
  const int bar = grid.all_rows > grid.rows ? scroll.sizeHint().width() : 0, wide = width() - bar;
  {
    const QSignalBlocker one_change(scroll);
    scroll.setRange(0, grid.all_rows - grid.rows);
    scroll.setPageStep(grid.rows);
  }
  scroll.setGeometry(wide, 0, bar, height());
  scroll.setVisible(bar > 0);
  for (int p = 0; p < paneCount(); ++p) {
    PlotPane* pane = panes[static_cast<std::size_t>(p)];
    const int row = p / grid.columns - scroll.value(), column = p % grid.columns;
    pane->setVisible(row >= 0 && row < grid.rows);
    pane->setCollapsed(grid.collapsed);
    const int left = wide * column / grid.columns, right = wide * (column + 1) / grid.columns;
    const int top = height() * row / grid.rows, bottom = height() * (row + 1) / grid.rows;
    pane->setGeometry(left, top, right - left, bottom - top);
  }
}

void PlotPanel::resizeEvent(QResizeEvent*) {
  arrangePanes();
  draw();
}

void PlotPanel::paintEvent(QPaintEvent*) {
  QPainter(this).fillRect(rect(), m_parts->palette.panel);
}

void PlotPanel::refresh(const FrameHistory& history, const Playback& playback,
                        const FrameSnapshotPtr& shown) {
  Parts& p = *m_parts;
  const std::vector<FrameSnapshotPtr> frames = history.next_since(p.next_index);
  const std::uint64_t frames_each = frames.empty() ? 1 : history.frames_each();
  for (const FrameSnapshotPtr& frame : frames) {
    p.next_index = frame->index + 1;
    SampleTable::Row row{frame->time_s, frame->index, p.reader.read(*frame)};
    p.selection_reader.read(*frame, row.values);
    p.table.append(row, p.gaps.next(*frame, frames_each).is_gap());
  }
  readSelection(history);
  p.table.drop_before(playback.first_s);
  p.table.thin_older(newest_kept, older_kept);
  p.playback = playback;
  p.window.show(playback);
  const SeriesValues* values = shown ? p.values_of(*shown, history) : nullptr;
  for (PlotPane* pane : p.panes) pane->showValues(values);
  draw();
}

void PlotPanel::showSelection(const Selection& selection) {
  Parts& p = *m_parts;
  if (selection == p.selection) return;
  const PaneArrangement panes = arrangement();
  const PaneSeries usual = series_of(selection);
  if (selection.kind != p.selection.kind) p.selected = usual;
  p.read_again.first = Parts::no_frame;
  p.selection = selection;
  p.selection_reader = SelectionReader(selection);
  p.unread_before = p.next_index;
  setArrangement(panes);
}

/// The rows that another selection wrote, the newest first and some at a time: an hour of frames must not
/// hold up the picture.
void PlotPanel::readSelection(const FrameHistory& history) {
  constexpr std::uint64_t frames_at_once = 3000;
  Parts& p = *m_parts;
  const auto& rows = p.table.rows();
  if (rows.empty() || p.unread_before <= rows.front().index) return;
  const std::uint64_t first =
      std::max(rows.front().index, p.unread_before - std::min(p.unread_before, frames_at_once));
  const auto time_of = [&rows](std::uint64_t frame) {
    const auto row = std::ranges::lower_bound(rows, frame, {}, &SampleTable::Row::index);
    return row == rows.end() ? rows.back().time_s : row->time_s;
  };
  SelectionReader reader(p.selection);
  SeriesValues values{};
  // From one frame earlier: a speed needs it.
  for (const FrameSnapshotPtr& frame :
       history.range(time_of(first > 0 ? first - 1 : 0), time_of(p.unread_before - 1))) {
    reader.read(*frame, values);
    if (frame->index >= first && frame->index < p.unread_before)
      p.table.rewrite(frame->index, selection_series(), values);
  }
  p.table.refresh_extremes(first, p.unread_before);
  p.unread_before = first;
  if (first > rows.front().index) emit unfinished();
}

void PlotPanel::attach() {
  m_parts->window.attach();
  draw();
}

void PlotPanel::zoom(double factor) {
  m_parts->window.zoom(factor, m_parts->playback.cursor_s);
  draw();
}

PlotView PlotPanel::viewWithoutPointer() const {
  const Parts& p = *m_parts;
  return {p.window.from_s(), p.window.to_s(), p.playback.cursor_s, {}};
}

void PlotPanel::draw() {
  const Parts& p = *m_parts;
  PlotView view = viewWithoutPointer();
  view.pointer_s = p.pointer_s;
  const bool live = p.playback.state == Playback::State::Following;
  for (PlotPane* pane : p.panes) {
    const bool last = pane == p.panes.back() || pane->geometry().right() + 2 >= p.scroll->x();
    pane->setMark(!last || pane->y() > 0 ? PlotMark::None
                  : p.window.follows()   ? PlotMark::Following
                  : live                 ? PlotMark::Detached
                                         : PlotMark::None);
    if (pane->isVisibleTo(this)) pane->read(p.table, view);
  }
  for (PlotPane* pane : p.panes)
    if (pane->isVisibleTo(this)) pane->draw();
}

void PlotPanel::showReadout(double time_s, const QPoint& global, QWidget* pane) {
  m_parts->pointer_s = time_s;
  draw();
  QToolTip::showText(global + QPoint(14, 10), readout(time_s), pane);
}

QString PlotPanel::readout(double time_s) const {
  const SampleTable::Row* row = m_parts->table.at(time_s);
  if (!row) return {};
  QString rows;
  for (const PlotPane* pane : m_parts->panes)
    for (const Series series : pane->series()) {
      const SeriesInfo& info = info_of(series);
      const double value = row->values[static_cast<std::size_t>(series)];
      rows += QString(
                  "<tr><td><span style='color:%1'>■</span> %2&nbsp;&nbsp;</td><td align=right>%3</td>"
                  "<td>%4</td></tr>")
                  .arg(colour_of(series, m_parts->palette).name(), text(info.name),
                       std::isfinite(value) ? QString::number(value, 'f', info.decimals) : QString("–"),
                       text(info.unit));
    }
  return QString("<b>%1 s</b> · frame %2<table cellspacing=0>%3</table>")
      .arg(row->time_s, 0, 'f', 3)
      .arg(row->index)
      .arg(rows);
}

std::string PlotPanel::csv() const {
  return plot_csv(m_parts->table, m_parts->window.from_s(), m_parts->window.to_s());
}

QImage PlotPanel::picture(double scale) {
  const PlotSheet sheet{m_parts->panes, m_parts->table, viewWithoutPointer(), m_parts->palette.panel, size()};
  const QImage picture = plot_picture(sheet, scale);
  draw();
  return picture;
}

QByteArray PlotPanel::svg() {
  const PlotSheet sheet{m_parts->panes, m_parts->table, viewWithoutPointer(), m_parts->palette.panel, size()};
  const QByteArray content = plot_svg(sheet);
  draw();
  return content;
}

}  // namespace abrazo::widgets
