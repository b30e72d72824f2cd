#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <mutex>

#include "app/python/clip.hpp"
#include "app/python/frame.hpp"
#include "app/python/library.hpp"
#include "app/python/progress.hpp"
#include "core/metrics/clip_run.hpp"
#include "core/motion/files/clip_file.hpp"
#include "core/synthesis/step/partner_synthesizer.hpp"
#include "core/synthesis/step/synthesizer_state.hpp"

namespace abrazo::python {

namespace {

/// A synthesizer that Python threads may share: calls are serialised.
class Synthesizer {
 public:
  Synthesizer(const ReadLibrary& library, const std::string& preset_name,
              const std::vector<std::string>& exclude, const py::object& settings)
      : library_(library.library),
        synthesizer_(
            unwrap(PartnerSynthesizer::create(library_, settings_of(preset_name, settings), exclude))) {}

  /// Runs something on the synthesizer without the GIL, and without another thread.
  template <typename Work>
  auto alone(Work work) {
    return without_gil([&] {
      const std::scoped_lock lock(mutex_);
      return work(*synthesizer_);
    });
  }

  Frame step(const Numbers& user, double elapsed_s) {
    if (!(elapsed_s >= 0 && std::isfinite(elapsed_s)))
      throw py::value_error(
          fmt::format("elapsed is {}; seconds since the step before are expected, 0 or more", elapsed_s));
    const Pose pose = pose_of(user, "user");
    return alone([&](PartnerSynthesizer& synthesizer) {
      return Frame{std::make_shared<const FrameResult>(synthesizer.step(pose, Duration(elapsed_s))),
                   library_};
    });
  }

 private:
  std::shared_ptr<const MotionLibrary> library_;
  std::unique_ptr<PartnerSynthesizer> synthesizer_;
  std::mutex mutex_;
};

/// A run with the frames it was made of.
struct Run {
  ClipRun run;
  std::vector<Frame> frames;
  std::shared_ptr<const MotionLibrary> library;  ///< what the run's summary refers to
};

std::shared_ptr<Run> synthesize(const ReadLibrary& library, const ReadClip& clip,
                                const std::string& preset_name, const std::vector<std::string>& exclude,
                                const py::object& changes, bool keep_frames, py::object progress) {
  const Settings settings = settings_of(preset_name, changes);
  return CalledProgress(std::move(progress)).run([&](const Progress& report) -> Result<std::shared_ptr<Run>> {
    auto synthesizer = PartnerSynthesizer::create(library.library, settings, exclude);
    if (!synthesizer) return synthesizer.error();
    std::vector<Frame> frames;
    const auto keep = [&](const ClipStep& step) {
      if (keep_frames) frames.push_back({std::make_shared<const FrameResult>(step.result), library.library});
    };
    auto run = run_clip(**synthesizer, clip.clip, keep, report);
    if (!run) return run.error();
    return std::make_shared<Run>(Run{std::move(*run), std::move(frames), library.library});
  });
}

void bind_run(py::module_& module) {
  py::class_<Run, std::shared_ptr<Run>>(module, "Run", "A recorded input, answered: both characters.")
      .def_property_readonly(
          "active", [](py::handle self) { return view_of(self.cast<const Run&>().run.active.poses, self); },
          "(T, 25, 3) float64 [m]: the active body at each step; a read-only view.")
      .def_property_readonly(
          "passive", [](py::handle self) { return view_of(self.cast<const Run&>().run.passive.poses, self); },
          "(T, 25, 3) float64 [m]: the passive body at each step; a read-only view.")
      .def_property_readonly(
          "times",
          [](py::handle self) {
            const std::vector<double>& times = self.cast<const Run&>().run.times_s;
            return view_of(times.data(), {static_cast<py::ssize_t>(times.size())}, self);
          },
          "(T,) [s]: time of the input at each step.")
      .def_property_readonly(
          "fps", [](const Run& self) { return self.run.rate_hz(); }, "Steps per second.")
      .def_readonly("frames", &Run::frames, "A Frame for each step; empty with keep_frames=False.")
      .def_property_readonly(
          "summary", [](const Run& self) { return from_json(self.run.summary.json(self.run.rate_hz())); },
          "A dict: what `abrazo synth --json` prints.")
      .def(
          "save",
          [](const Run& self, const std::filesystem::path& file) {
            without_gil([&] {
              return unwrap(
                  write_clip_file(file.string(), std::array<Clip, 2>{self.run.active, self.run.passive}));
            });
          },
          py::arg("file"), "Writes both characters as .bvh, .glb, .csv or .npz. Raises abrazo.Error.")
      .def("__len__", [](const Run& self) { return self.run.times_s.size(); })
      .def("__repr__", [](const Run& self) {
        return fmt::format("<abrazo.Run: {} steps at {} Hz>", self.run.times_s.size(), self.run.rate_hz());
      });
}

}  // namespace

void bind_synthesis(py::module_& module) {
  bind_run(module);
  py::class_<SynthesizerState>(module, "State", "What a Synthesizer keeps between two steps.");
  py::class_<Synthesizer>(
      module, "Synthesizer",
      "The whole method, one frame at a time: a user's pose in, both characters out. The same library, "
      "settings and\ninput give the same bits, here and in `abrazo synth`.")
      .def(py::init<const ReadLibrary&, const std::string&, const std::vector<std::string>&,
                    const py::object&>(),
           py::arg("library"), py::arg("preset") = "responsive",
           py::arg("exclude") = std::vector<std::string>(), py::arg("settings") = py::none(),
           "preset: 'paper' or 'responsive'; exclude: names of takes that are never selected; settings: a "
           "dict of those\nthat differ from the preset, by the names of the command line: {'alpha': 0.1, "
           "'foot-locks': False}.\nRaises abrazo.Error.")
      .def("step", &Synthesizer::step, py::arg("user"), py::arg("elapsed"),
           "Solves one frame.\n\n"
           "user: (25, 3) [m], world, joints in the order of abrazo.JOINTS; elapsed: since the step before "
           "[s], 0 at the\nfirst; more than 0.3 without a solved frame resets the temporal state. The Frame "
           "is the "
           "caller's to keep. A pose that cannot\nbe answered raises nothing: the frame's status says "
           "'failed: ...' and the last good poses are held. Raises\nValueError on another shape.")
      .def(
          "measure_user",
          [](Synthesizer& self, const ReadClip& clip) {
            if (clip.clip.poses.empty()) throw EngineError({"has no frames", clip.clip.name});
            self.alone([&](PartnerSynthesizer& synthesizer) {
              synthesizer.set_user_body(body_of(clip.clip.poses));
            });
          },
          py::arg("clip"),
          "Takes the user's measures from a whole clip, as synthesize does. Without it the first pose that "
          "can be a\nperson's is measured.")
      .def(
          "change_settings",
          [](Synthesizer& self, const py::object& changes) {
            const Settings now =
                self.alone([](PartnerSynthesizer& synthesizer) { return synthesizer.settings(); });
            const Settings changed = changed_settings(now, changes);
            self.alone([&](PartnerSynthesizer& synthesizer) { synthesizer.set_settings(changed); });
          },
          py::arg("settings"), "Changes some settings from the next step on, a dict. Raises abrazo.Error.")
      .def_property_readonly(
          "settings",
          [](Synthesizer& self) {
            return from_json(self.alone(
                [](PartnerSynthesizer& synthesizer) { return settings_json(synthesizer.settings()); }));
          },
          "All settings, a dict.")
      .def(
          "pin",
          [](Synthesizer& self, std::optional<int> pair) {
            self.alone([&](PartnerSynthesizer& synthesizer) { synthesizer.pin_pair(pair); });
          },
          py::arg("pair"),
          "Selects this pair of the library from the next step on, regardless of its cost; None: by cost "
          "again.")
      .def(
          "state",
          [](Synthesizer& self) {
            return self.alone([](PartnerSynthesizer& synthesizer) { return synthesizer.state(); });
          },
          "All that the next step depends on beside settings and input.")
      .def(
          "restore",
          [](Synthesizer& self, const SynthesizerState& state) {
            self.alone([&](PartnerSynthesizer& synthesizer) { synthesizer.restore(state); });
          },
          py::arg("state"), "Continues from the state, on a synthesizer of the same library.")
      .def(
          "reset",
          [](Synthesizer& self) { self.alone([](PartnerSynthesizer& synthesizer) { synthesizer.reset(); }); },
          "Forgets the steps before: the next is a first one.");

  module.def("synthesize", &synthesize, py::arg("library"), py::arg("clip"), py::arg("preset") = "responsive",
             py::arg("exclude") = std::vector<std::string>(), py::arg("settings") = py::none(), py::kw_only(),
             py::arg("keep_frames") = true, py::arg("progress") = py::none(),
             "Answers a whole clip as `abrazo synth` does, to the bit.\n\n"
             "clip: the user's motion, a Clip; preset, exclude, settings: as for Synthesizer; keep_frames: "
             "whether the run\nkeeps a Frame of each step; progress: True, or a function of (fraction, "
             "doing). Raises abrazo.Error.");
}

}  // namespace abrazo::python
