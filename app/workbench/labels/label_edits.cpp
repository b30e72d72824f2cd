#include "app/workbench/labels/label_edits.hpp"

#include <QMenu>
#include <algorithm>
#include <cmath>

#include "app/workbench/labels/annotation_desk.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "widgets/annotation/value_picker.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/common/utf8.hpp"
#include "widgets/common/value_look.hpp"
#include "widgets/timeline/timeline_view.hpp"
#include "widgets/timeline/transport_bar.hpp"

namespace abrazo::app {
namespace {

using widgets::TimelineView;
using widgets::ValuePicker;

constexpr double same_s = 1e-6;

using widgets::text;

QString span_words(double from_s, double to_s) {
  return QString("%1 to %2 s").arg(from_s, 0, 'f', 2).arg(to_s, 0, 'f', 2);
}

Status status_of(const Result<int>& result) {
  return result ? Status(Done{}) : Status(result.error());
}

QString words(const Annotation& annotation) {
  return annotation.value.empty() ? QString("label") : text(annotation.value).replace('_', ' ');
}

}  // namespace

LabelEdits::LabelEdits(MainWindow& window, AnnotationDesk& desk)
    : QObject(&desk), m_window(window), m_desk(desk) {
  const TimelineView& timeline = window.timeline();
  connect(&timeline, &TimelineView::labelDrawn, this, &LabelEdits::askValue);
  connect(&timeline, &TimelineView::valueEntryRequested, this, [this](int annotation) {
    m_desk.select(annotation);
    ask();
  });
  connect(&timeline, &TimelineView::tierMenuRequested, this, &LabelEdits::openMenu);
}

/// The selected one, else the one of the active tier at the cursor.
const Annotation* LabelEdits::wanted() const {
  if (const Annotation* selected = m_desk.annotations().find(m_desk.selected())) return selected;
  const AnnotationTier* tier = m_desk.annotations().tier(m_desk.activeTier());
  return tier ? tier->at(m_window.ticker().playback().cursor_s) : nullptr;
}

bool LabelEdits::isThere(const Annotation* annotation) const {
  if (!annotation)
    m_window.messages().showInformation(
        "No label is selected, and the active tier has none at the cursor; click one in its lane");
  return annotation != nullptr;
}

void LabelEdits::draw() {
  const AnnotationTier* tier = m_desk.annotations().tier(m_desk.activeTier());
  if (!tier) return m_window.messages().showInformation("Nothing is open, or it has no tier yet");
  const Playback& playback = m_window.ticker().playback();
  if (const auto range = playback.range()) return askValue(tier->id, range->from_s, range->to_s);
  constexpr double usual_s = 1;
  double to = std::min(playback.cursor_s + usual_s, m_desk.range().last_s);
  for (const Annotation& each : tier->annotations)
    if (each.start_s > playback.cursor_s + same_s) to = std::min(to, each.start_s);
  askValue(tier->id, playback.cursor_s, to);
}

/// The interval is there only once it says something.
void LabelEdits::askValue(int tier, double from_s, double to_s) {
  const AnnotationTier* of = m_desk.annotations().tier(tier);
  if (!of) return;
  TimelineView& timeline = m_window.timeline();
  const QPoint below =
      timeline.placeOf(tier, to_s) + QPoint(4, static_cast<int>(widgets::TimelineLanes::tier_px));
  ValuePicker::open(
      timeline, below, {*of, text(of->name) + ", " + span_words(from_s, to_s), text(m_used[tier])},
      m_window.colours(),
      [this, tier, from_s, to_s](const QString& value) { return take(tier, from_s, to_s, value); });
}

QString LabelEdits::take(int tier, double from_s, double to_s, const QString& value) {
  const AnnotationTier* of = m_desk.annotations().tier(tier);
  if (!of) return "The tier no longer exists";
  if (value.isEmpty() && of->kind != TierKind::Note) return "Choose or type its value";
  if (of->kind == TierKind::Role && value != "a" && value != "b")
    return "A role is a or b, the performers of the take";
  Annotations next = m_desk.annotations();
  const auto drawn = next.draw(tier, from_s, to_s, value.toStdString(), m_desk.conflict(), m_desk.range());
  if (!drawn) return text(drawn.error().text());
  m_used[tier] = value.toStdString();
  m_desk.change(std::move(next), "draw " + QString(value).replace('_', ' '));
  m_desk.select(*drawn);
  return {};
}

void LabelEdits::ask() {
  const Annotation* annotation = wanted();
  if (!isThere(annotation)) return;
  const AnnotationTier* tier = m_desk.annotations().tier_of(annotation->id);
  TimelineView& timeline = m_window.timeline();
  const QPoint below = timeline.placeOf(tier->id, annotation->start_s) +
                       QPoint(0, static_cast<int>(widgets::TimelineLanes::tier_px));
  const ValuePicker::Question question{
      *tier, text(tier->name) + ", " + span_words(annotation->start_s, annotation->end_s),
      text(annotation->value)};
  ValuePicker::open(timeline, below, question, m_window.colours(),
                    [this, id = annotation->id, role = tier->kind == TierKind::Role,
                     tier = tier->id](const QString& value) -> QString {
                      Annotations next = m_desk.annotations();
                      const Annotation* known = next.find(id);
                      if (!known) return "The label no longer exists";
                      if (role && value != "a" && value != "b")
                        return "A role is a or b, the performers of the take";
                      const Status said = next.say(id, value.toStdString(), known->detail, known->confidence);
                      if (!said) return text(said.error().text());
                      m_used[tier] = value.toStdString();
                      m_desk.change(std::move(next), "label " + QString(value).replace('_', ' '));
                      return {};
                    });
}

void LabelEdits::remove() {
  const Annotation* annotation = m_desk.annotations().find(m_desk.selected());
  if (!isThere(annotation)) return;
  Annotations next = m_desk.annotations();
  const Status done = next.remove(annotation->id);
  m_desk.changeOrTell(done, std::move(next), "delete " + words(*annotation));
}

void LabelEdits::extend() {
  const double here = m_window.ticker().playback().cursor_s;
  const Annotation* annotation = m_desk.annotations().find(m_desk.selected());
  const AnnotationTier* tier = m_desk.annotations().tier(m_desk.activeTier());
  if (!annotation && tier)
    for (const Annotation& each : tier->annotations)
      if (each.start_s < here - same_s) annotation = &each;
  if (!isThere(annotation)) return;
  const bool start =
      std::abs(here - annotation->start_s) < std::abs(here - annotation->end_s) && here < annotation->end_s;
  Annotations next = m_desk.annotations();
  const Status done = next.place(annotation->id, start ? here : annotation->start_s,
                                 start ? annotation->end_s : here, m_desk.conflict(), m_desk.range());
  m_desk.changeOrTell(done, std::move(next), "extend " + words(*annotation));
}

void LabelEdits::split() {
  const Annotation* annotation = wanted();
  if (!isThere(annotation)) return;
  Annotations next = m_desk.annotations();
  const auto later = next.split(annotation->id, m_window.ticker().playback().cursor_s);
  if (m_desk.changeOrTell(status_of(later), std::move(next), "split " + words(*annotation)) && later)
    m_desk.select(*later);
}

void LabelEdits::merge() {
  const Annotation* annotation = wanted();
  if (!isThere(annotation)) return;
  Annotations next = m_desk.annotations();
  const Status done = next.merge_with_next(annotation->id);
  m_desk.changeOrTell(done, std::move(next), "merge " + words(*annotation));
}

void LabelEdits::nudge(Edge edge, int frames) {
  const Annotation* annotation = wanted();
  if (!isThere(annotation)) return;
  const double rate_hz = m_desk.fps() > 0 ? m_desk.fps() : m_window.transport().rate();
  const double by = frames / (rate_hz > 0 ? rate_hz : 60);
  const double start = annotation->start_s + (edge == Edge::End ? 0 : by);
  const double end = annotation->end_s + (edge == Edge::Start ? 0 : by);
  Annotations next = m_desk.annotations();
  const Status done = end > start + same_s
                          ? next.place(annotation->id, start, end, m_desk.conflict(), m_desk.range())
                          : Status(Error{"a label is at least a frame long", ""});
  const int id = annotation->id;
  if (m_desk.changeOrTell(done, std::move(next), "nudge " + words(*annotation))) m_desk.select(id);
}

void LabelEdits::step(int by) {
  const AnnotationTier* tier = m_desk.annotations().tier(m_desk.activeTier());
  if (!tier || tier->annotations.empty())
    return m_window.messages().showInformation("The active tier has no labels");
  const auto& all = tier->annotations;
  const double here = m_window.ticker().playback().cursor_s;
  const auto selected = std::find_if(all.begin(), all.end(),
                                     [this](const Annotation& each) { return each.id == m_desk.selected(); });
  const Annotation* there = nullptr;
  if (selected != all.end()) {
    const auto at = selected - all.begin() + by;
    if (at >= 0 && at < std::ssize(all)) there = &all[static_cast<std::size_t>(at)];
  } else {
    for (const Annotation& each : all) {
      if (by > 0 && each.start_s > here + same_s && !there) there = &each;
      if (by < 0 && each.start_s < here - same_s) there = &each;
    }
  }
  if (!there)
    return m_window.messages().showInformation(by > 0 ? "That is the last label of its tier"
                                                      : "That is the first label of its tier");
  const double start = there->start_s;
  m_desk.select(there->id);
  m_window.ticker().seek(start);
}

void LabelEdits::stepTier(int by) {
  const auto& tiers = m_desk.annotations().tiers();
  for (std::size_t i = 0; i < tiers.size(); ++i) {
    if (tiers[i].id != m_desk.activeTier()) continue;
    const auto at = static_cast<std::ptrdiff_t>(i) + by;
    if (at >= 0 && at < std::ssize(tiers)) m_desk.setActiveTier(tiers[static_cast<std::size_t>(at)].id);
    return;
  }
}

void LabelEdits::copyTo(int tier) {
  const Annotation* annotation = wanted();
  if (!isThere(annotation)) return;
  Annotations next = m_desk.annotations();
  const auto copied = next.copy_to(annotation->id, tier, m_desk.conflict());
  m_desk.changeOrTell(status_of(copied), std::move(next), "copy " + words(*annotation));
}

void LabelEdits::exchangeRole() {
  Annotations next = m_desk.annotations();
  const AnnotationTier* tier = next.first_of(TierKind::Role);
  if (!tier) return m_window.messages().showInformation("There is no tier that says who leads");
  const double fps = m_desk.fps();
  double here = m_window.ticker().playback().cursor_s;
  if (fps > 0) here = std::round(here * fps) / fps;
  const Annotation* now = tier->at(here);
  const Annotation* before = nullptr;
  for (const Annotation& each : tier->annotations)
    if (each.end_s <= here + same_s) before = &each;
  // The first change there is: A led so far.
  if (tier->annotations.empty() && here > m_desk.range().first_s + same_s) {
    const int id = tier->id;
    (void)next.draw(id, m_desk.range().first_s, here, "a", Conflict::Refuse, m_desk.range());
    tier = next.tier(id);
    before = &tier->annotations.front();
  }
  const std::string leads = now ? now->value : before ? before->value : "b";
  const std::string other = leads == "a" ? "b" : "a";
  double to = now ? now->end_s : m_desk.range().last_s;
  for (const Annotation& each : tier->annotations)
    if (!now && each.start_s > here + same_s) to = std::min(to, each.start_s);
  const auto drawn = next.draw(tier->id, here, to, other, Conflict::Replace, m_desk.range());
  m_desk.changeOrTell(status_of(drawn), std::move(next), "change of role");
}

void LabelEdits::fillMenu(QMenu& menu) {
  QMenu* copy = menu.addMenu("Copy to");
  for (const AnnotationTier& tier : m_desk.annotations().tiers())
    if (tier.id != m_desk.activeTier())
      copy->addAction(text(tier.name), this, [this, id = tier.id] { copyTo(id); });
  copy->setEnabled(!copy->isEmpty());
}

void LabelEdits::openMenu(int tier, int annotation, double time_s, const QPoint& global) {
  QMenu menu(&m_window);
  const auto add = [&](const char* id) {
    if (QAction* action = action_of(m_window, QString("annotation.") + id)) menu.addAction(action);
  };
  const AnnotationTier* of = m_desk.annotations().tier(tier);
  if (annotation != 0) {
    if (of)
      for (const VocabularyEntry& entry : of->vocabulary) {
        QString said = widgets::value_words(*of, entry.value);
        if (entry.key != 0) said += "\t" + QString(QChar(entry.key)).toUpper();
        menu.addAction(said, this, [this, annotation, value = entry.value] {
          Annotations next = m_desk.annotations();
          const Annotation* known = next.find(annotation);
          if (!known) return;
          const Status done = next.say(annotation, value, known->detail, known->confidence);
          m_desk.changeOrTell(done, std::move(next), "label " + text(value).replace('_', ' '));
        });
      }
    menu.addSeparator();
    for (const char* id : {"edit_label", "split_label_at_the_cursor", "merge_label_with_the_next",
                           "extend_label_to_the_cursor"})
      add(id);
    fillMenu(menu);
    menu.addSeparator();
    menu.addAction(action_of(m_window, "timeline.delete_label_or_marker"));
  } else {
    menu.addAction("New label here…", this, [this, tier, time_s] {
      m_window.ticker().seek(time_s);
      m_desk.setActiveTier(tier);
      draw();
    });
    add("change_of_role_here");
  }
  menu.exec(global);
}

}  // namespace abrazo::app
