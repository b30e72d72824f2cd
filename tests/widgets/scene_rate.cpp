// How many frames a second the scene alone and in its window can show. Prints; not a test.

#include <QApplication>
#include <QElapsedTimer>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "tests/widgets/synthetic_frames.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/scene/view/scene_view.hpp"

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  abrazo::widgets::apply_theme(application, abrazo::widgets::palette_of(abrazo::widgets::Theme::Dark));
  abrazo::widgets::SceneView scene;
  scene.setLibrary(abrazo::test::two_take_library());
  scene.resize(1280, 720);
  scene.show();
  const int frames = argc > 1 ? std::atoi(argv[1]) : 100;
  for (std::uint64_t warm = 0; warm < 10; ++warm) {
    scene.showFrame(abrazo::test::synthetic_frame(warm, 0.016 * static_cast<double>(warm)));
    QApplication::processEvents();
  }
  QElapsedTimer clock;
  clock.start();
  const std::clock_t processor = std::clock();
  const auto before = scene.renderedFrames();
  for (std::uint64_t i = 10; i < static_cast<std::uint64_t>(frames + 10); ++i) {
    scene.showFrame(abrazo::test::synthetic_frame(i, 0.016 * static_cast<double>(i)));
    QApplication::processEvents();
  }
  const double seconds = static_cast<double>(clock.nsecsElapsed()) * 1e-9;
  std::printf("%d frames at 1280x720: %.1f per second, %.1f ms of processor time each, %llu swaps\n", frames,
              frames / seconds,
              1000.0 * static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC / frames,
              static_cast<unsigned long long>(scene.renderedFrames() - before));
  return 0;
}
