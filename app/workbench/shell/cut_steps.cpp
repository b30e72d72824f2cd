#include <QPointer>
#include <QUndoCommand>
#include <QUndoStack>

#include "app/workbench/shell/actions.hpp"
#include "widgets/scene/view/scene_view.hpp"

namespace abrazo::app {
namespace {

using widgets::SceneOptions;
using widgets::SceneView;

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

}  // namespace

void keep_cut_edits(SceneView& scene, QUndoStack& undo) {
  QObject::connect(&scene, &SceneView::cutEdited, &undo,
                   [&scene, &undo](const SceneOptions& before, const SceneOptions& after, int edit) {
                     undo.push(new CutStep(scene, before, after, edit));
                   });
}

}  // namespace abrazo::app
