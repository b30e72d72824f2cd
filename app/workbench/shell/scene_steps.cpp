#include <QPointer>
#include <QUndoCommand>
#include <QUndoStack>

#include "app/workbench/shell/actions.hpp"
#include "widgets/scene/view/scene_view.hpp"

namespace abrazo::app {
namespace {

using widgets::LegendRange;
using widgets::SceneOptions;
using widgets::SceneView;
using widgets::SteadyRange;

constexpr int cut_step_id = 0x637574;  // "cut"; no other command has it

/// The history would otherwise have equal lines of different changes.
QString words_of(const SceneOptions& before, const SceneOptions& after) {
  if (before.cuts != after.cuts) return after.cuts ? "cutting plane on" : "cutting plane off";
  if (before.cut_in_world != after.cut_in_world)
    return after.cut_in_world ? "fix cutting plane in the world" : "cutting plane turns with the view";
  return before.cut_m != after.cut_m ? "move cutting plane" : "turn cutting plane";
}

/// The cutting plane changed by a person.
class CutStep : public QUndoCommand {
 public:
  CutStep(SceneView& scene, const SceneOptions& before, const SceneOptions& after, int edit)
      : QUndoCommand(words_of(before, after)),
        m_scene(&scene),
        m_before(before),
        m_after(after),
        m_edit(edit) {}

  int id() const override { return cut_step_id; }
  bool mergeWith(const QUndoCommand* other) override {
    const auto& later = static_cast<const CutStep&>(*other);
    if (later.m_edit != m_edit) return false;
    m_after = later.m_after;
    setText(words_of(m_before, m_after));
    return true;
  }
  void undo() override { show(m_before); }
  void redo() override { show(m_after); }

 private:
  /// Other options stay as they are.
  void show(const SceneOptions& cut) {
    if (m_scene) m_scene->restoreCut(cut);
  }

  QPointer<SceneView> m_scene;
  SceneOptions m_before, m_after;
  int m_edit;
};

QString words_of(const SteadyRange& before, const SteadyRange& after) {
  if (!after.locked()) return "adapt the range of colours";
  const bool is_same = after.lower() == before.lower() && after.upper() == before.upper();
  return is_same ? "keep the range of colours" : "set the range of colours";
}

/// A range of the legend changed by a person.
class RangeStep : public QUndoCommand {
 public:
  RangeStep(SceneView& scene, const LegendRange& before, const LegendRange& after)
      : QUndoCommand(words_of(before.range, after.range)),
        m_scene(&scene),
        m_before(before),
        m_after(after) {}

  void undo() override { show(m_before); }
  void redo() override { show(m_after); }

 private:
  void show(const LegendRange& range) {
    if (m_scene) m_scene->restoreRange(range);
  }

  QPointer<SceneView> m_scene;
  LegendRange m_before, m_after;
};

}  // namespace

void keep_scene_edits(SceneView& scene, QUndoStack& undo) {
  QObject::connect(&scene, &SceneView::rangeEdited, &undo,
                   [&scene, &undo](const LegendRange& before, const LegendRange& after) {
                     undo.push(new RangeStep(scene, before, after));
                   });
  QObject::connect(&scene, &SceneView::cutEdited, &undo,
                   [&scene, &undo](const SceneOptions& before, const SceneOptions& after, int edit) {
                     undo.push(new CutStep(scene, before, after, edit));
                   });
}

}  // namespace abrazo::app
