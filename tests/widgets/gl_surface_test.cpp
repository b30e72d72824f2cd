// When and what the surface of the scene draws, on a window of VTK with two actors.
#include "widgets/scene/actors/gl_surface.hpp"

#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCullerCollection.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#include <QTest>
#include <QTimer>

#include "widgets/scene/actors/empty_culler.hpp"

namespace abrazo::widgets::gl_surface_test {
namespace {

/// Counts the renderings that end within its paint.
class CountingSurface : public GlSurface {
 public:
  using GlSurface::GlSurface;
  int renderings = 0, in_last_paint = 0;

 protected:
  void paintEvent(QPaintEvent* event) override {
    const int before = renderings;
    GlSurface::paintEvent(event);
    in_last_paint = renderings - before;
  }
};

struct GlSurfaceTest : ::testing::Test {
  GlSurfaceTest() {
    surface.resize(320, 240);
    surface.setRenderWindow(window);
    window->AddRenderer(renderer);
    renderer->GetCullers()->RemoveAllItems();
    renderer->AddCuller(vtkNew<EmptyCuller>());
    vtkNew<vtkSphereSource> sphere;
    sphere->Update();
    sphere_mapper->SetInputConnection(sphere->GetOutputPort());
    sphere_actor->SetMapper(sphere_mapper);
    empty_mapper->SetInputData(vtkNew<vtkPolyData>());
    empty_actor->SetMapper(empty_mapper);
    renderer->AddActor(sphere_actor);
    renderer->AddActor(empty_actor);
    vtkNew<vtkCallbackCommand> rendered;
    rendered->SetClientData(&surface);
    rendered->SetCallback([](vtkObject*, unsigned long, void* counting, void*) {
      ++static_cast<CountingSurface*>(counting)->renderings;
    });
    window->AddObserver(vtkCommand::EndEvent, rendered);
  }

  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkOpenGLPolyDataMapper> sphere_mapper, empty_mapper;
  vtkNew<vtkActor> sphere_actor, empty_actor;
  CountingSurface surface{nullptr};
};

/// The window around it is often painted for the first time by the same paint.
TEST_F(GlSurfaceTest, DrawsItsFirstPictureBetweenTwoPaints) {
  int renderings_of_paint = -1, requests = 0;
  surface.requestPicture([&](double) { renderings_of_paint = surface.in_last_paint; });
  surface.show();
  ASSERT_TRUE(QTest::qWaitFor([&] { return renderings_of_paint >= 0; }, 30'000));
  EXPECT_EQ(renderings_of_paint, 0);
  EXPECT_GT(surface.renderings, 0);
  // A later one has no such company: it is drawn by the paint that shows it.
  ASSERT_TRUE(QTest::qWaitFor([&] { return surface.in_last_paint > 0; }, 30'000)) << "with smooth edges";
  surface.requestPicture([&](double) { ++requests; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return requests > 0; }, 30'000));
  EXPECT_EQ(surface.in_last_paint, 1);
}

/// Frames come faster than a first picture is drawn. Each request is answered, or replaced by a later one.
TEST_F(GlSurfaceTest, ShowsItsFirstPictureThoughMoreAreRequestedMeanwhile) {
  int shown = 0;
  QTimer frames;
  QObject::connect(&frames, &QTimer::timeout, [&] { surface.requestPicture([&](double) { ++shown; }); });
  frames.start(1);
  surface.show();
  EXPECT_TRUE(QTest::qWaitFor([&] { return shown >= 3; }, 30'000));
}

TEST_F(GlSurfaceTest, LeavesOutActorsWithoutCells) {
  (void)surface.picture();
  EXPECT_EQ(renderer->GetNumberOfPropsRendered(), 1);
}

/// VTK would compute the range of all points with every upload.
TEST_F(GlSurfaceTest, UploadsPointsAsTheyAre) {
  (void)surface.picture();
  EXPECT_EQ(sphere_mapper->GetVBOShiftScaleMethod(), vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
}

}  // namespace
}  // namespace abrazo::widgets::gl_surface_test
