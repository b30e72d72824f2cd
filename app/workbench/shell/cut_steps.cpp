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

/// The cutting plane moved or turned by a person.
class CutStep : public QUndoCommand {
 public:
  CutStep(SceneView& scene, const SceneOptions& before, const SceneOptions& after, int edit)
      : QUndoCommand("cutting plane"), m_scene(&scene), m_before(before), m_after(after), m_edit(edit) {}

  int id() const override { return cut_step_id; }
  bool mergeWith(const QUndoCommand* other) override {
    const auto& later = static_cast<const CutStep&>(*other);
    if (later.m_edit != m_edit) return false;
    m_after = later.m_after;
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
