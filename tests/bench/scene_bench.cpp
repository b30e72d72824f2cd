// One frame of the 3-D view: moving what stands in the scene, and drawing it, apart. Needs a display
// (xvfb-run).
#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include <QApplication>
#include <algorithm>
#include <chrono>
#include <ctime>

#include "core/base/statistics.hpp"
#include "core/synthesis/step/partner_synthesizer.hpp"
#include "tests/bench/bench_data.hpp"
#include "tests/bench/bench_main.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/scene/view/scene_view.hpp"

namespace {

using namespace abrazo;
using namespace abrazo::bench;
using widgets::PartVisibility;
using widgets::ScenePart;
using widgets::SceneView;

constexpr double rate_hz = 60;
constexpr std::size_t warm_up_frames = 10;
constexpr auto longest_picture = std::chrono::seconds(5);

const std::vector<FrameSnapshotPtr>& frames() {
  static const auto all = [] {
    const BenchData& data = bench_data();
    const auto synthesizer =
        std::move(*PartnerSynthesizer::create(data.library, *preset("responsive"), data.excluded));
    synthesizer->set_user_body(body_of(data.user.poses));
    std::vector<FrameSnapshotPtr> solved;
    const auto count = static_cast<std::size_t>(number_from_environment("ABRAZO_BENCH_PICTURES", 90));
    for (std::size_t i = 0; i < std::min(count + warm_up_frames, data.user.poses.size()); ++i) {
      auto frame = std::make_shared<FrameSnapshot>();
      frame->index = i;
      frame->time_s = static_cast<double>(i) / rate_hz;
      frame->user = data.user.poses[i];
      frame->result = synthesizer->step(frame->user, Duration(1 / rate_hz));
      frame->library = data.library;
      solved.push_back(std::move(frame));
    }
    return solved;
  }();
  return all;
}

double seconds_of(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

PartVisibility only_bodies() {
  PartVisibility visible{};
  for (const ScenePart part : {ScenePart::Leader, ScenePart::Follower, ScenePart::Floor})
    visible[static_cast<std::size_t>(part)] = true;
  return visible;
}

PartVisibility with_tetrahedra() {
  PartVisibility visible = widgets::default_visibility;
  visible[static_cast<std::size_t>(ScenePart::Tetrahedra)] = true;
  return visible;
}

PartVisibility everything() {
  PartVisibility visible;
  visible.fill(true);
  return visible;
}

/// @return false when none came
bool wait_for_picture(const SceneView& scene, std::uint64_t pictures_before) {
  const auto begin = std::chrono::steady_clock::now();
  while (scene.renderedFrames() == pictures_before) {
    QApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents, 1);
    if (std::chrono::steady_clock::now() - begin > longest_picture) return false;
  }
  return true;
}

struct Times {
  std::vector<double> update_us, picture_ms, picture_processor_ms;
};

/// @return false when it did not reach the screen
bool show(SceneView& scene, const FrameSnapshotPtr& frame, Times& times) {
  const auto before = scene.renderedFrames();
  const double begin_s = seconds_of(CLOCK_THREAD_CPUTIME_ID);
  scene.showFrame(frame);
  const double moved_s = seconds_of(CLOCK_THREAD_CPUTIME_ID);
  const double clock_s = seconds_of(CLOCK_MONOTONIC), processor_s = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
  if (!wait_for_picture(scene, before)) return false;
  times.update_us.push_back(1e6 * (moved_s - begin_s));
  times.picture_ms.push_back(1e3 * (seconds_of(CLOCK_MONOTONIC) - clock_s));
  times.picture_processor_ms.push_back(1e3 * (seconds_of(CLOCK_PROCESS_CPUTIME_ID) - processor_s));
  return true;
}

/// One iteration shows every frame once.
void run(benchmark::State& state, const PartVisibility& visibility, QSize size) {
  SceneView scene;
  scene.setLibrary(bench_data().library);
  scene.setVisibility(visibility);
  scene.resize(size);
  scene.show();
  Times times, warm_up;
  for (auto _ : state)
    for (std::size_t i = 0; i < frames().size(); ++i)
      if (!show(scene, frames()[i], i < warm_up_frames ? warm_up : times))
        return state.SkipWithError("no picture came: is there a display?");
  state.counters["update_us"] = percentile(times.update_us, 0.5);
  state.counters["update_p99_us"] = percentile(times.update_us, 0.99);
  state.counters["picture_ms"] = percentile(times.picture_ms, 0.5);
  state.counters["picture_processor_ms"] = percentile(times.picture_processor_ms, 0.5);
  state.counters["pictures_per_s"] = 1000 / std::max(1e-3, mean(times.picture_ms));
  state.counters["pictures"] = static_cast<double>(times.picture_ms.size());
}

void add(const char* name, const PartVisibility& visibility, QSize size) {
  benchmark::RegisterBenchmark(fmt::format("scene/{}/{}x{}", name, size.width(), size.height()).c_str(),
                               [=](benchmark::State& state) { run(state, visibility, size); })
      ->Iterations(1)
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
}

}  // namespace

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  widgets::apply_theme(application, widgets::palette_of(widgets::Theme::Dark));
  add("nothing", PartVisibility{}, {1280, 720});
  add("bodies only", only_bodies(), {1280, 720});
  add("as at the start", widgets::default_visibility, {1280, 720});
  add("with tetrahedra", with_tetrahedra(), {1280, 720});
  add("everything", everything(), {1280, 720});
  add("as at the start", widgets::default_visibility, {640, 360});
  return run_benchmarks(argc, argv);
}
