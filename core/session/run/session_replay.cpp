#include "core/session/run/session_replay.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "core/session/file/library_reference.hpp"
#include "core/session/frames/frame_in_library.hpp"
#include "core/session/run/re_solver.hpp"

namespace abrazo {

namespace {

/// The library that a frame was solved with: the last that begins not after it.
const SessionLibrary* library_at(const SessionContents& contents, std::uint64_t frame) {
  const SessionLibrary* found = nullptr;
  for (const SessionLibrary& library : contents.libraries)
    if (library.first_frame <= frame) found = &library;
  return found;
}

class Replay {
 public:
  Replay(const SessionContents& contents, std::shared_ptr<const MotionLibrary> library)
      : contents_(contents), library_(std::move(library)), fingerprint_(library_fingerprint(*library_)) {}

  Status solve(const FrameSnapshot& recorded, double from_s,
               const std::function<Status(const FrameSnapshot&)>& each) {
    const bool is_before = recorded.time_s < from_s;  // the run-up to its start
    const auto frame = std::make_shared<const FrameSnapshot>(recorded);
    if (!is_of_library(recorded)) {
      if (!is_before) skip("it was solved with another library");
      follows_ = false;
      return Done{};
    }
    if (!has_pairs_of(*library_, recorded))
      return Error{"frame " + std::to_string(recorded.index) +
                       " names pairs that its library does not have; the session is damaged",
                   {}};
    const bool follows = follows_ && recorded.index == next_index_;
    next_index_ = recorded.index + 1;
    if (!follows && !recorded.before) {
      if (!is_before) skip("the solver's state before it was not kept");
      follows_ = false;
      return Done{};
    }
    if (!solver_)
      if (const Status made = make_solver(recorded); !made) return made;
    if (!follows) solver_->go_to({}, recorded);
    follows_ = true;
    auto solved = solver_->solve(recorded, recorded.settings);
    if (is_before) return Done{};
    solved->library = library_;
    solved->times = recorded.times;
    ++done.frames;
    if (solved->result.result != recorded.result.result || solved->result.status != recorded.result.status)
      ++done.differ;
    return each(*solved);
  }

  SessionReplay done;

 private:
  bool is_of_library(const FrameSnapshot& frame) const {
    const SessionLibrary* reference = library_at(contents_, frame.index);
    if (!reference) return true;
    return !is_comparable(reference->fingerprint)
               ? reference->pairs == static_cast<std::uint64_t>(library_->pair_count())
               : reference->fingerprint == fingerprint_;
  }

  Status make_solver(const FrameSnapshot& frame) {
    const SessionLibrary* reference = library_at(contents_, frame.index);
    auto made =
        ReSolver::create(library_, reference ? reference->excluded_takes : std::vector<std::string>());
    if (!made) return made.error();
    solver_ = std::move(*made);
    return Done{};
  }

  void skip(const std::string& why) {
    ++done.skipped;
    if (done.note.empty()) done.note = why;
  }

  const SessionContents& contents_;
  std::shared_ptr<const MotionLibrary> library_;
  std::string fingerprint_;
  std::unique_ptr<ReSolver> solver_;
  bool follows_ = false;
  std::uint64_t next_index_ = 0;
};

}  // namespace

Result<SessionReplay> re_solve_session(const SessionRecord& session,
                                       std::shared_ptr<const MotionLibrary> library, double from_s,
                                       double to_s, const std::function<Status(const FrameSnapshot&)>& each,
                                       const Progress& progress) {
  const SessionContents& contents = session.contents();
  if (!contents.libraries.empty()) {
    Status same = Done{};
    for (const SessionLibrary& reference : contents.libraries) {
      same = check_session_library(reference, *library);
      if (same) break;
    }
    if (!same) return same.error();
  }
  Replay replay(contents, std::move(library));
  // States are kept many times a second; a range in the middle is come to from one before it.
  constexpr double run_up_s = 10;
  const double length_s =
      std::max(1e-9, std::min(to_s, contents.last_s) - std::max(from_s, contents.first_s));
  const auto pass = session.each_frame(from_s - run_up_s, to_s, [&](const FrameSnapshot& frame) -> Status {
    if (frame.index % 64 == 0 &&
        !report(progress,
                std::clamp((frame.time_s - std::max(from_s, contents.first_s)) / length_s, 0.0, 1.0),
                "solving again"))
      return Error{"cancelled", session.where()};
    return replay.solve(frame, from_s, each);
  });
  if (!pass) return pass.error();
  if (pass->damaged > 0) {
    replay.done.skipped += pass->damaged;
    replay.done.note = pass->damage;
  }
  return replay.done;
}

}  // namespace abrazo
