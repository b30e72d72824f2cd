#pragma once

#include <QApplication>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <functional>

#include "tests/widgets/pictures.hpp"
#include "tests/widgets/synthetic_frames.hpp"
#include "widgets/scene/values/picture_projection.hpp"
#include "widgets/scene/view/scene_view.hpp"

namespace abrazo::widgets::scene_fixture {

inline const Palette& dark() {
  return palette_of(Theme::Dark);
}

/// A view that shows one frame, with only these parts.
struct Scene {
  SelectionModel model;
  SceneView view;
  explicit Scene(std::initializer_list<ScenePart> parts) {
    PartVisibility visible{};
    for (const ScenePart part : parts) visible[static_cast<std::size_t>(part)] = true;
    view.setLibrary(test::two_take_library());
    view.resize(640, 480);
    view.setVisibility(visible);
    view.show();
    view.showFrame(test::synthetic_frame(3, 0.05));
    QObject::connect(&view, &SceneView::selectionRequested, &model, &SelectionModel::select);
    QObject::connect(&model, &SelectionModel::selectionChanged, &view, &SceneView::showSelection);
  }
  QWidget* surface() { return view.childAt(320, 240); }
  void wheel(Qt::KeyboardModifiers keys) {
    QWheelEvent turn(QPointF(320, 240), surface()->mapToGlobal(QPoint(320, 240)), {}, {0, 120}, Qt::NoButton,
                     keys, Qt::NoScrollPhase, false);
    QApplication::sendEvent(surface(), &turn);
  }
  void change(const std::function<void(SceneOptions&)>& how) {
    SceneOptions options = view.options();
    how(options);
    view.setOptions(options);
  }
};

/// The middle of a picture, off chips, legend and facts.
inline QImage middle_of(const QImage& picture) {
  return picture.copy(0, 120, 640, 280);
}

/// Where a vertex is in the picture of the scene.
inline QPoint place_of(const SceneView& view, const FrameSnapshotPtr& frame, int vertex) {
  const auto at = PictureProjection(view.camera(), view.width(), view.height())
                      .project(frame->result.result.row(vertex).transpose())
                      .value();
  return {qRound(at.x), qRound(at.y)};
}

}  // namespace abrazo::widgets::scene_fixture
