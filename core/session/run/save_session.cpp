#include "core/session/run/save_session.hpp"

#include <filesystem>

#include "core/base/atomic_file.hpp"
#include "core/library/store/motion_library_file.hpp"
#include "core/session/run/recorder.hpp"

namespace abrazo {
namespace {

namespace fs = std::filesystem;

/// Completed references for the session file; for missing files the saved ones.
Project with_contents(const SessionToSave& what) {
  Project project = what.project;
  for (DataReference& data : project.data) {
    if (auto completed = reference_to(data.absolute_path, data.use, what.to)) {
      data = std::move(*completed);
      continue;
    }
    for (const DataReference& old : what.saved.data)
      if (old.use == data.use && old.absolute_path == data.absolute_path) data = old;
  }
  return project;
}

/// @return the number of frames that could not be read
Result<std::uint64_t> add_frames(const SessionToSave& what, const std::string& file,
                                 const Progress& progress) {
  return what.history ? add_history(file, *what.history, progress) : Result<std::uint64_t>(std::uint64_t{0});
}

Result<std::uint64_t> save_copy(const SessionToSave& what, const Project& project, const Progress& progress) {
  std::error_code trouble;
  if (fs::exists(what.to + "-wal", trouble))
    return Error{"another program or window is recording into this file; choose another name", what.to};
  if (what.recorder)
    if (const Status flushed = what.recorder->flush(); !flushed) return flushed.error();
  AtomicFile copy(what.to);
  const std::string partial = copy.partial().string();
  const bool has_frames = !what.file.empty() && fs::exists(what.file, trouble);
  Status done = has_frames ? copy_session(what.file, partial) : Status(Done{});
  std::uint64_t left_out = 0;
  if (done) {
    const auto added = add_frames(what, partial, progress);
    added ? void(left_out = *added) : void(done = added.error());
  }
  if (done) done = save_project(partial, project);
  if (done) done = edit_session_takes(partial, what.takes);
  if (done) done = copy.commit();
  if (!done) return Error{done.error().message, what.to};
  return left_out;
}

Result<std::uint64_t> save_in_place(const SessionToSave& what, const Project& project,
                                    const Progress& progress) {
  const auto left_out = add_frames(what, what.to, progress);
  if (!left_out) return left_out;
  if (const Status saved = save_project(what.to, project); !saved) return saved.error();
  return left_out;
}

Result<SavedSession> save_to(const SessionToSave& what, Project project, const Progress& progress) {
  const bool is_own = what.to == what.file;
  if (const std::string last = saved_at(what.to);
      is_own && what.saved_at && !last.empty() && last != *what.saved_at)
    return Error{"was saved by another window at " + last +
                     ", after it was opened or saved here; save it under another name, or open it again",
                 what.to};
  if (is_own && what.recorder) {
    what.recorder->save_project(std::make_shared<const Project>(project));
    if (const Status flushed = what.recorder->flush(); !flushed) return flushed.error();
    return SavedSession{std::move(project), saved_at(what.to), false, 0};
  }
  const auto left_out = is_own ? save_in_place(what, project, progress) : save_copy(what, project, progress);
  if (!left_out) return left_out.error();
  return SavedSession{std::move(project), saved_at(what.to), what.history.has_value(), *left_out};
}

}  // namespace

std::string saved_at(const std::string& file) {
  const auto reading = read_project(file);
  return reading ? reading->saved_at : std::string();
}

Result<SavedSession> save_session(const SessionToSave& what, const Progress& progress) {
  const bool with_library = !what.library_file.empty();
  std::error_code ignored;
  const bool was_there = with_library && fs::exists(what.library_file, ignored);
  if (with_library)
    if (const Status written = write_library(*what.library, what.library_file, part(progress, 0, 0.5));
        !written)
      return written.error();
  auto saved = save_to(what, with_contents(what), with_library ? part(progress, 0.5, 1) : progress);
  if (!saved && with_library && !was_there) fs::remove(what.library_file, ignored);
  return saved;
}

}  // namespace abrazo
