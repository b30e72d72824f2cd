#include "app/workbench/recorded_session.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "app/workbench/generated_fight.hpp"
#include "core/session/library_reference.hpp"
#include "core/session/recorded_frames.hpp"

namespace abrazo::app {
namespace {

using LibraryPtr = std::shared_ptr<const MotionLibrary>;

/// What the frames of the file were solved with last.
Result<SessionLibrary> reference_of(const SessionContents& contents, const std::string& file) {
  if (contents.libraries.empty()) return Error{"does not say which library it was solved with", file};
  return contents.libraries.back();
}

LibraryPtr generated(const SessionLibrary& reference, const Progress& progress) {
  for (const auto make : {make_demo, make_fight}) {
    const auto made = make(progress);
    if (made && made->library->name() == reference.name && check_session_library(reference, *made->library))
      return made->library;
  }
  return nullptr;
}

/// The session's library and where it is from.
struct Found {
  LibraryPtr library;
  std::string file;
  std::vector<std::string> warnings;
};

Result<Found> given_library(const SessionLibrary& reference, const std::string& given,
                            const Progress& progress) {
  auto opened = load_material({given}, {}, progress);
  if (!opened) return opened.error();
  Found found{opened->library, given, {}};
  const Status same = check_session_library(reference, *found.library);
  if (!same)
    found.warnings.push_back(same.error().text() +
                             "; meshes and selected pairs of the recorded frames may be wrong");
  return found;
}

Result<Found> find_library(const SessionLibrary& reference, const std::string& file, const Material& open,
                           const Progress& progress) {
  if (open.library && check_session_library(reference, *open.library))
    return Found{open.library, open.library_file, {}};
  const bool was_a_file = !reference.relative_path.empty() || !reference.absolute_path.empty();
  if (was_a_file) {
    const auto opened = open_session_library(reference, file);
    if (opened) return Found{*opened, reference.absolute_path, {}};
    return Error{opened.error().message + "; open the session together with its library (both files at once)",
                 opened.error().where};
  }
  if (LibraryPtr library = generated(reference, progress)) return Found{library, "", {}};
  return Error{"was solved with the library \"" + reference.name +
                   "\", which was not saved as a file; open the session together with that library "
                   "(both files at once)",
               file};
}

double rate_of(const SessionContents& contents) {
  double lasted_s = 0;
  std::uint64_t frames = 0;
  for (const SessionRun& run : contents.runs)
    if (run.frames > 1) {
      lasted_s += run.last_s - run.first_s;
      frames += run.frames - 1;
    }
  return lasted_s > 0 ? static_cast<double>(frames) / lasted_s : 0;
}

}  // namespace

Markers RecordedSession::markers() const {
  Markers markers;
  for (const SessionMarker& marker : contents.markers) markers.add(marker.time_s, marker.name);
  return markers;
}

namespace {

/// The library that the frames were solved with; another one where a person said that it will do.
Result<Found> library_of(const SessionLibrary& reference, const OpenedProject& project,
                         const std::string& given, const Material& open, const Progress& progress,
                         bool may_be_another) {
  if (!given.empty()) return given_library(reference, given, progress);
  auto found = find_library(reference, project.file, open, progress);
  if (found) return found;
  for (const auto use : {DataReference::Use::Library, DataReference::Use::Manifest})
    if (const std::string place = project.place_of(use); !place.empty())
      return given_library(reference, place, progress);
  if (!may_be_another) return found;
  auto demo = make_demo(progress);
  if (!demo) return demo.error();
  return Found{demo->library,
               "",
               {"its library '" + reference.name +
                "' is not there: the generated dance stands in for it; the "
                "bodies are as recorded, meshes and selected pairs of the recorded frames are wrong"}};
}

Result<Material> load_recorded(const std::shared_ptr<const SessionFile>& session,
                               const OpenedProject& project, const std::string& library, const Material& open,
                               const Progress& progress, bool may_be_another) {
  const std::string& file = project.file;
  const SessionContents& contents = session->contents();
  const auto reference = reference_of(contents, file);
  if (!reference) return reference.error();
  auto found = library_of(*reference, project, library, open, progress, may_be_another);
  if (!found) return found.error();
  auto frames = RecordedFrames::open(file, found->library);
  if (!frames) return frames.error();
  auto recorded = std::make_shared<RecordedSession>();
  recorded->file = file;
  recorded->frames = *frames;
  recorded->contents = contents;
  Material material;
  material.library = found->library;
  material.library_file = found->file;
  material.excluded_takes = reference->excluded_takes;
  material.input.name = std::filesystem::path(file).stem().string();
  material.input.fps = rate_of(contents);
  material.warnings = session->recovery();
  const auto& damage = project.reading.damage;
  std::ranges::copy_if(damage, std::back_inserter(material.warnings), [&](const std::string& sentence) {
    return std::ranges::find(session->recovery(), sentence) == session->recovery().end();
  });
  material.warnings.insert(material.warnings.end(), found->warnings.begin(), found->warnings.end());
  material.recorded = std::move(recorded);
  return material;
}

}  // namespace

Result<Material> load_session(const std::string& file, const std::string& library, const Material& open,
                              const Progress& progress, const Places& places) {
  report(progress, 0, "Opening " + std::filesystem::path(file).filename().string());
  auto project = open_project(file, places);
  if (!project) return project.error();
  std::error_code ignored;
  std::shared_ptr<const SessionFile> session;
  if (!(*project)->file.empty() && std::filesystem::exists((*project)->file, ignored)) {
    auto opened = SessionFile::open((*project)->file);
    if (!opened) return opened.error();
    session = *opened;
  }
  auto material = session && session->contents().frames > 0
                      ? load_recorded(session, **project, library, open, progress, !places.empty())
                  : (*project)->reading.is_saved
                      ? material_of(**project, progress)
                      : Result<Material>(Error{"has no frames: nothing was recorded into it", file});
  if (!material) return material.error();
  material->project = *project;
  return material;
}

}  // namespace abrazo::app
