#include "widgets/scene/view/scene_view.hpp"

#include <QEvent>
#include <cmath>

#include "core/session/frames/frame_in_library.hpp"
#include "core/synthesis/step/look_ahead.hpp"
#include "widgets/common/parts.hpp"
#include "widgets/scene/actors/ahead_lines.hpp"
#include "widgets/scene/values/morph_step.hpp"
#include "widgets/scene/view/scene_view_parts.hpp"

namespace abrazo::widgets {
namespace {

constexpr int fresh_ms = 12;
constexpr int standstill_ms = 130;  // without a new picture: time for smooth edges

QString seconds(double time_s) {
  return QString::number(time_s, 'f', 3) + " s";
}

constexpr double least_doublings = 0.01;  ///< a ratio of 1 would be no range

}  // namespace

/// Colours of the mesh for the frame, and the legends that explain them.
MeshLook SceneView::Parts::look() {
  const FrameResult& result = shown->result;
  MeshLook look;
  look.scalars = edge_scalars(*shown, scalar);
  range().show(typical_upper(result.edges, look.scalars), shown->time_s);
  look.scale = {range().upper(), scalar_info(scalar).is_signed, options.map,
                options.is_logarithmic && !scalar_info(scalar).is_signed, range().lower()};
  look.scale.part = part_on(palette.dark);
  const bool lacks_values =
      std::any_of(look.scalars.begin(), look.scalars.end(), [](double v) { return !std::isfinite(v); });
  legend->show(scalar_legend(scalar, look.scale, lacks_values));
  if (shows(ScenePart::Tetrahedra)) {
    cell_range.show(typical_doublings(cell_volumes(result)), shown->time_s);
    look.doublings = cell_range.upper();
    cell_legend->show(volume_legend(look.doublings));
  }
  look.filter = {
      options.shortest_m,  options.longest_m, options.isolates ? picker.selected() : Selection{}, hidden,
      options.least_value, options.most_value};
  look.apart = options.apart;
  return look;
}

SceneView::SceneView(QWidget* parent) : QWidget(parent), m_parts(std::make_unique<Parts>(this)) {
  Parts& p = *m_parts;
  setMinimumSize(320, 220);
  setAccessibleName("Scene");
  auto* box = column_in(this);
  p.surface->setFocusPolicy(Qt::StrongFocus);
  p.surface->setAccessibleName("Scene");
  p.cut_layer = new CutHandleLayer(this);
  p.cut_layer->lower();
  p.surface->lower();
  box->addWidget(p.surface);

  p.chips = new ScalarChips(this);
  p.legend = new ScalarLegend(this);
  p.cell_legend = new ScalarLegend(this);
  p.cell_legend->setVisible(false);
  p.facts = new FrameFacts(this);
  p.morph = new MorphStrip(this);
  p.morph->setVisible(false);
  wireOverlay();
  wirePointer();
  wireCut();
  p.standstill.setSingleShot(true);
  p.standstill.setInterval(standstill_ms);
  connect(&p.standstill, &QTimer::timeout, this, &SceneView::renderSharp);
  connect(&p.move_timer, &QTimer::timeout, this, [this] {
    if (!m_parts->move) return m_parts->move_timer.stop();
    const bool is_fresh = m_parts->since_render.isValid() && m_parts->since_render.elapsed() < fresh_ms;
    if (!is_fresh) render();  // else a frame has taken the camera along
  });
  setColours(palette_of(Theme::Dark));
  p.actors.setVisibility(p.visibility);
  p.actors.setTrailJoints({hands.begin(), hands.end()});
}

SceneView::~SceneView() = default;

void SceneView::wireOverlay() {
  Parts& p = *m_parts;
  connect(p.chips, &ScalarChips::scalarChosen, this, &SceneView::setScalar);
  connect(p.chips, &ScalarChips::betweenOnlyChosen, this,
          [this](bool only) { showPart(ScenePart::MeshWithin, !only); });
  connect(p.chips, &ScalarChips::cellsChosen, this,
          [this](bool shown) { showPart(ScenePart::Tetrahedra, shown); });
  connect(p.chips, &ScalarChips::optionsRequested, this, &SceneView::edit);
  for (ScalarLegend* legend : {p.legend, p.cell_legend})
    connect(legend, &ScalarLegend::lockToggled, this, [this, legend](bool locked) {
      LegendRange after = shownRange(legend);
      after.range.set_locked(locked);
      editRange(after);
    });
  connect(p.legend, &ScalarLegend::rangeRequested, this, [this](double lower, double upper) {
    LegendRange after = shownRange(m_parts->legend);
    after.range.fix(lower, upper);
    editRange(after);
  });
  connect(p.cell_legend, &ScalarLegend::rangeRequested, this, [this](double, double ratio) {
    LegendRange after = shownRange(m_parts->cell_legend);
    after.range.fix(0, std::max(std::abs(std::log2(ratio)), least_doublings));
    editRange(after);
  });
  connect(p.legend, &ScalarLegend::mapRequested, this, [this](ColourMap map, bool logarithmic) {
    SceneOptions options = m_parts->options;
    options.map = map;
    options.is_logarithmic = logarithmic;
    setOptions(options);
  });
  connect(p.morph, &MorphStrip::stepRequested, this, &SceneView::setMorphStep);
  connect(p.morph, &MorphStrip::closeRequested, this, [this] {
    m_parts->step.reset();
    showPart(ScenePart::MorphSteps, false);
    refresh();
  });
}

LegendRange SceneView::shownRange(const ScalarLegend* legend) const {
  const Parts& p = *m_parts;
  if (legend == p.cell_legend) return {std::nullopt, p.cell_range};
  return {p.scalar, p.ranges[static_cast<std::size_t>(p.scalar)]};
}

void SceneView::editRange(const LegendRange& after) {
  const LegendRange before = shownRange(after.scalar ? m_parts->legend : m_parts->cell_legend);
  restoreRange(after);
  if (!after.range.has_ends_of(before.range)) emit rangeEdited(before, after);
}

void SceneView::restoreRange(const LegendRange& range) {
  Parts& p = *m_parts;
  (range.scalar ? p.ranges[static_cast<std::size_t>(*range.scalar)] : p.cell_range) = range.range;
  p.legend->setLocked(p.range().locked());
  p.cell_legend->setLocked(p.cell_range.locked());
  refresh();
}

const PartVisibility& SceneView::visibility() const {
  return m_parts->visibility;
}
MeshScalar SceneView::scalar() const {
  return m_parts->scalar;
}
const SceneOptions& SceneView::options() const {
  return m_parts->options;
}
SceneMemory SceneView::memory() const {
  const Parts& p = *m_parts;
  SceneMemory memory{p.visibility, p.scalar, p.options, {}};
  for (std::size_t s = 0; s < mesh_scalar_count; ++s)
    if (const SteadyRange& range = p.ranges[s]; range.locked() && range.upper() > 0)
      memory.ranges[s] = {range.lower(), range.upper()};
  return memory;
}

void SceneView::setMemory(const SceneMemory& memory) {
  for (std::size_t s = 0; s < mesh_scalar_count; ++s) {
    SteadyRange& range = m_parts->ranges[s];
    if (const auto& kept = memory.ranges[s])
      range.fix(kept->lower, kept->upper);
    else
      range.set_locked(false);
  }
  setVisibility(memory.visibility);
  setScalar(memory.scalar);
  setOptions(memory.options);
}

const Selection& SceneView::selection() const {
  return m_parts->picker.selected();
}
const std::vector<Selection>& SceneView::hidden() const {
  return m_parts->hidden;
}

void SceneView::setLibrary(std::shared_ptr<const MotionLibrary> library) {
  Parts& p = *m_parts;
  p.framed = false;
  p.ranges = {};  // another library has other values
  p.cell_range = {};
  p.legend->setLocked(false);
  p.cell_legend->setLocked(false);
  extendLibrary(std::move(library));
}

void SceneView::extendLibrary(std::shared_ptr<const MotionLibrary> library) {
  Parts& p = *m_parts;
  p.library = std::move(library);
  p.picker.setLibrary(p.library);
  // The shown frame stays until the next one; pairs of its library may be other ones in this, or none.
  p.frame = in_library(p.frame, p.library);
  p.shown = p.frame && p.step ? at_step(p.frame, *p.step) : p.frame;
  if (p.shown) p.picker.show(*p.shown);
  dressCharacters();
  if (!p.library || p.library->bodies().empty()) return;
  p.actors.setBodies(p.library->usual_active_body(), p.library->usual_passive_body());
}

void SceneView::setColours(const Palette& palette) {
  Parts& p = *m_parts;
  p.palette = palette;
  p.stage.setColours(palette, devicePixelRatioF());
  p.picker.setColours(palette);
  p.tags.setColours(palette);
  p.legend->setColours(palette);
  p.cell_legend->setColours(palette);
  p.facts->setColours(palette);
  p.cut_layer->setColours(palette);
  p.morph->setColours(palette);
  refresh();
}

void SceneView::showFrame(FrameSnapshotPtr frame) {
  if (!frame || frame == m_parts->frame) return;
  m_parts->frame = std::move(frame);
  refresh();
}

/// Moves what changed and renders.
void SceneView::refresh() {
  Parts& p = *m_parts;
  if (p.frame) {
    p.shown = p.step ? at_step(p.frame, *p.step) : p.frame;
    followPair();
    p.actors.show(*p.shown, p.look());
    showGhost();
    showAhead();
    placeReference();
    p.picker.show(*p.shown);
    updateFacts();
    if (p.actors.counts() != p.counts) emit countsChanged(p.counts = p.actors.counts());
  }
  render();
}

/// The selected pair continues from the shown frame.
void SceneView::showAhead() {
  Parts& p = *m_parts;
  if (!p.shows(ScenePart::LookAhead)) return;
  const FrameResult& result = p.shown->result;
  std::vector<Pose> ahead;
  if (p.library) ahead = look_ahead(result, *p.library, p.shown->settings.user_role, ahead_s, ahead_step_s);
  p.actors.showAhead(ahead, partner_row(result));
}

void SceneView::updateFacts() {
  Parts& p = *m_parts;
  const FrameSnapshot& frame = *p.shown;
  const FrameResult& result = frame.result;
  const int steps = step_count(frame), step = morphStep();
  const QString way = QString::fromStdString(step_text(frame, step));
  const QString place = QString("frame %1 · %2").arg(frame.index).arg(seconds(frame.time_s));
  FrameFacts::Line first{place, place};
  const auto add = [&first](const QString& whole, const QString& brief) {
    first.whole += " · " + whole;
    first.brief += " · " + brief;
  };
  if (step + 1 < steps) add("morph step " + way, "step " + way);
  p.morph->showStep(step, steps, way);
  const bool filters =
      p.options.filters_edges() || (p.options.isolates && selection().is_of_mesh()) || !p.hidden.empty();
  if (filters) {
    const QString edges =
        QString("%1 of %2 edges").arg(p.actors.mesh().shownEdges().size()).arg(result.edges.size());
    add("filter: " + edges, edges);
  }
  QString second = frame.absent                ? QString::fromStdString(absence_text(frame))
                   : result.candidates.empty() ? ""
                                               : "no source";
  if (const int pair = selected_pair(frame, p.library); p.library && pair >= 0) {
    const std::string_view label = p.library->label(pair);
    second = QString("source %1 · %2")
                 .arg(QString::fromStdString(p.library->take_of(pair).name))
                 .arg(p.library->source(pair).frame);
    if (!label.empty())
      second += " · " + QString::fromUtf8(label.data(), static_cast<int>(label.size())).replace('_', ' ');
  }
  if (const int inverted = p.actors.mesh().invertedCount(); inverted > 0 && p.shows(ScenePart::Tetrahedra))
    add(QString("%1 of %2 tetrahedra inverted").arg(inverted).arg(result.tetrahedra.size()),
        QString("%1 inverted").arg(inverted));
  p.facts->show(first, second,
                result.status == StepStatus::Ok ? QString() : QString::fromStdString(result.status_text()));
}

void SceneView::setVisibility(const PartVisibility& visibility) {
  Parts& p = *m_parts;
  if (visibility == p.visibility) return;
  p.visibility = visibility;
  p.actors.setVisibility(visibility);
  p.picker.setVisibility(visibility);
  p.stage.ghosts.setVisible(p.shows(ScenePart::Comparison));
  p.chips->setBetweenOnly(!p.shows(ScenePart::MeshWithin));
  p.chips->setCells(p.shows(ScenePart::Tetrahedra));
  p.cell_legend->setVisible(p.shows(ScenePart::Tetrahedra));
  p.morph->setVisible(p.shows(ScenePart::MorphSteps) || p.step);
  arrange();
  refresh();
  emit visibilityChanged(visibility);
}

void SceneView::showPart(ScenePart part, bool shown) {
  PartVisibility changed = m_parts->visibility;
  changed[static_cast<std::size_t>(part)] = shown;
  setVisibility(changed);
}

void SceneView::setScalar(MeshScalar scalar) {
  Parts& p = *m_parts;
  SceneOptions options = p.options;
  options.least_value = 0;  // limits of another value would hide what nobody meant
  options.most_value = MeshFilter::no_limit;
  if (p.scalar != scalar && options != p.options) setOptions(options);
  p.scalar = scalar;
  if (!p.range().locked()) p.range().reset();
  p.legend->setLocked(p.range().locked());
  p.chips->setScalar(scalar);
  refresh();
  emit scalarChanged(scalar);
}

void SceneView::askRange() {
  m_parts->legend->askRange();
}

void SceneView::setOptions(const SceneOptions& wanted) {
  const Parts& p = *m_parts;
  SceneOptions placed = wanted;
  // The plane of a cut that is off would wait unseen.
  if (wanted.cut_in_world && !p.options.cut_in_world) placed.cuts = true;
  if (wanted.cut_in_world && !p.options.cut_in_world && p.shown) {
    const Vec3 one = p.shown->result.result.row(0), other = p.shown->result.result.row(joint_count);
    placed.cut_at = 0.5 * (one + other);
    placed.cut_azimuth_rad = new_cut_azimuth(p.camera.azimuth_rad, other - one);
    placed.cut_elevation_rad = 0;
  }
  applyOptions(placed);
}

void SceneView::applyOptions(const SceneOptions& wanted) {
  Parts& p = *m_parts;
  if (wanted == p.options) return;
  // Two pairs take more room than one, and cells that are apart more than a pair.
  const bool is_of_other_size = wanted.shows_reference_beside != p.options.shows_reference_beside ||
                                (wanted.apart != p.options.apart && p.shows(ScenePart::Tetrahedra));
  p.options = wanted;
  p.surface->style = p.options.navigation;
  p.camera.is_parallel = p.options.is_parallel;
  p.applyCut();
  p.actors.trails().set_length(p.options.trail_s);
  p.legend->setMap(p.options.map, p.options.is_logarithmic);
  p.chips->setOptions(p.options);
  refresh();
  if (is_of_other_size) frameAll();
  emit optionsChanged(p.options);
}

/// In a narrow view chips, legend and facts would cover heads and feet: the pair is drawn between them.
void SceneView::Parts::makeRoom(bool narrow) {
  narrow_overlays_px.reset();
  camera.lowered = 0;
  if (!narrow || chips->isHidden()) return;
  const ScalarLegend* lowest = cell_legend->isHidden() ? legend : cell_legend;
  const int above = std::max(lowest->geometry().bottom(), chips->geometry().bottom()),
            below = facts->height();
  narrow_overlays_px = above + below;
  camera.lowered = static_cast<double>(above - below) / std::max(1, surface->height());
}

int SceneView::morphStep() const {
  const Parts& p = *m_parts;
  const int last = p.frame ? step_count(*p.frame) : 0;
  return p.step ? std::min(*p.step, last) : last;
}

void SceneView::setMorphStep(int step) {
  Parts& p = *m_parts;
  if (!p.frame) return;
  const int last = step_count(*p.frame);
  p.step = step >= last ? std::nullopt : std::optional(std::max(step, 0));
  p.morph->setVisible(p.step || p.shows(ScenePart::MorphSteps));
  arrange();
  refresh();
}

void SceneView::stepMorph(int by) {
  setMorphStep(morphStep() + by);
}

void SceneView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  arrange();
  render();
}

void SceneView::arrange() {
  Parts& p = *m_parts;
  p.cut_layer->setGeometry(rect());
  p.chips->fitInto(width() - 24);
  p.chips->move(12, 10);
  // Where the chips leave no room the legend goes beside their last row, or below them.
  const int legend_x = width() - p.legend->width() - 10;
  const int free_y = p.chips->y() + p.chips->freeFrom(legend_x - 8 - p.chips->x());
  const bool narrow = free_y > p.chips->y();
  p.legend->move(legend_x, narrow ? free_y : 8);
  p.cell_legend->move(p.legend->x(), p.legend->y() + p.legend->height() + 2);
  p.facts->setGeometry(14, height() - p.facts->height() - 10, width() - 28, p.facts->height());
  p.makeRoom(narrow && 5 * legend_x < 3 * width());  // else the legend is beside the pair
  p.morph->adjustSize();
  p.morph->move(12, p.facts->y() - p.morph->height());
  placeCards();
  emit arranged();
}

/// Below the chips and beside the legend, or below that too: bars there cover no button.
QRect SceneView::noticeRoom() const {
  constexpr int least_width = 320, gap = 6;
  const Parts& p = *m_parts;
  const ScalarLegend* lowest = p.cell_legend->isHidden() ? p.legend : p.cell_legend;
  const int left = p.chips->x(), chips_end = p.chips->geometry().bottom() + gap;
  // Between chips and legend, above the heads, where there is room.
  const int after = p.chips->geometry().right() + 8, between = p.legend->x() - 8 - after;
  if (between >= least_width) return {after, p.chips->y(), between, height() - p.chips->y()};
  const int beside = p.legend->x() - 8 - left;
  if (beside >= least_width) return {left, chips_end, beside, height() - chips_end};
  const int top = std::max(chips_end, lowest->geometry().bottom() + gap);
  return {left, top, width() - 2 * left, height() - top};
}

void SceneView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::StyleChange && m_parts && m_parts->chips) arrange();
}

}  // namespace abrazo::widgets
