#include <fmt/format.h>

#include <memory>
#include <mutex>

#include "app/python/frame.hpp"
#include "app/python/library.hpp"
#include "core/opening/session_frames.hpp"

namespace abrazo::python {

namespace {

using SessionPtr = std::shared_ptr<const SessionFrames>;

/// Python's iterator over the frames of a session, which it keeps.
class FrameIterator {
 public:
  explicit FrameIterator(SessionPtr session) : session_(std::move(session)), walk_(*session_) {}

  RecordedFrame next() {
    FrameSnapshotPtr frame = without_gil([&] {
      const std::scoped_lock lock(mutex_);
      return unwrap(walk_.next());
    });
    if (!frame) throw py::stop_iteration();
    return RecordedFrame(std::move(frame));
  }

 private:
  SessionPtr session_;
  std::mutex mutex_;
  SessionWalk walk_;
};

SessionPtr open_recorded(const std::filesystem::path& file, const std::filesystem::path& library) {
  return without_gil([&] {
    return std::make_shared<const SessionFrames>(
        unwrap(open_session_frames(file.string(), library.string())));
  });
}

}  // namespace

void bind_session(py::module_& module) {
  py::class_<RecordedFrame, Frame>(module, "RecordedFrame",
                                   "A frame of a session. It has its mesh, selected pair and sources when "
                                   "the session's library is at hand; morph steps are not kept.")
      .def_property_readonly(
          "index", [](const RecordedFrame& self) { return self.snapshot->index; }, "In the session, from 0.")
      .def_property_readonly(
          "time", [](const RecordedFrame& self) { return self.snapshot->time_s; }, "Of the session [s].")
      .def_property_readonly(
          "user",
          [](py::handle self) {
            return view_of(self.cast<const RecordedFrame&>().snapshot->user.data(), {joint_count, 3}, self);
          },
          "(25, 3) [m]: the user's pose as it came.")
      .def_property_readonly(
          "settings",
          [](const RecordedFrame& self) { return from_json(settings_json(self.snapshot->settings)); },
          "A dict: under which it was solved.");
  py::class_<FrameIterator>(module, "FrameIterator", "Goes through the frames of a session.")
      .def("__iter__", [](py::object self) { return self; })
      .def("__next__", &FrameIterator::next);
  py::class_<SessionFrames, std::shared_ptr<SessionFrames>>(
      module, "Session", "The recorded frames of a session file (.abrazo).")
      .def(
          "frames",
          [](std::shared_ptr<SessionFrames> self) {
            return std::make_unique<FrameIterator>(std::move(self));
          },
          "An iterator of RecordedFrame, in their order. One that cannot be read raises abrazo.Error; the "
          "iterator may go\non behind it.")
      .def_property_readonly(
          "first", [](const SessionFrames& self) { return self.contents.first_s; },
          "Time of the first frame [s].")
      .def_property_readonly(
          "last", [](const SessionFrames& self) { return self.contents.last_s; },
          "Time of the last frame [s].")
      .def_readonly("warnings", &SessionFrames::warnings,
                    "What was recovered of a file that was cut off, and which library is missing or another.")
      .def("__len__", [](const SessionFrames& self) { return self.contents.frames; })
      .def("__repr__", [](const SessionFrames& self) {
        return fmt::format("<abrazo.Session {}: {} frames, {:.3f} to {:.3f} s>", self.file,
                           self.contents.frames, self.contents.first_s, self.contents.last_s);
      });
  module.def("open_session", &open_recorded, py::arg("file"), py::kw_only(), py::arg("library") = "",
             "Opens a recorded session, also while it is recorded.\n\n"
             "library: a library or manifest in the place of the one it was solved with. Raises "
             "abrazo.Error.");
}

}  // namespace abrazo::python
