#include "core/opening/session_material.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "core/opening/generated_set.hpp"
#include "core/opening/import_rules.hpp"
#include "core/opening/library_search.hpp"
#include "core/opening/open_files.hpp"
#include "core/session/file/library_reference.hpp"
#include "core/session/frames/frame_history.hpp"

namespace abrazo {
namespace {

namespace fs = std::filesystem;
using Use = DataReference::Use;

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

/// The project says nothing of its library: the generated dance, as in files from before that was noted.
bool says_nothing_of_library(const Project& project) {
  return project.library.empty() && std::ranges::none_of(project.data, [](const DataReference& data) {
           return is_of_library(data.use);
         });
}

/// The library that the session was worked on with. The project names it: the last frames may have been
/// solved with one that stood in for it. @return null if no frame was solved with it
const SessionLibrary* reference_of(const OpenedSession& session) {
  const auto& references = session.recording.contents.libraries;
  if (!session.has_frames()) return nullptr;
  const std::string& name = session.project->project().library;
  if (!session.project->reading.is_saved || name.empty()) return &references.back();
  const auto last = std::ranges::find(references.rbegin(), references.rend(), name, &SessionLibrary::name);
  return last == references.rend() ? nullptr : &*last;
}

/// First what it means: a bar may have no room for all of it.
Result<FoundLibrary> stand_in(const Error& why, const OpenedProject& project, const Progress& progress) {
  auto dance = generated_dance(progress);
  if (!dance) return dance.error();
  dance->stands_in = true;
  dance->warnings.push_back(
      "the generated dance answers in place of the library; annotations of takes are kept, but not shown: " +
      why.message);
  std::vector<std::string> files;
  for (const std::size_t index : project.missing())
    if (is_of_library(project.project().data[index].use))
      files.push_back(project.project().data[index].absolute_path);
  if (!files.empty())
    dance->warnings.push_back(fmt::format("of the library {} not there: {}", files.size() == 1 ? "is" : "are",
                                          fmt::join(files, ", ")));
  return FoundLibrary{std::move(*dance), Done{}};
}

Result<FoundLibrary> library_for(const OpenedSession& session, const SessionWish& wish,
                                 const Progress& progress) {
  const bool has_frames = session.has_frames();
  const auto& references = session.recording.contents.libraries;
  const OpenedProject& project = *session.project;
  if (!has_frames && wish.library.empty() && says_nothing_of_library(project.project())) {
    auto dance = generated_dance(progress);
    return dance ? Result<FoundLibrary>(FoundLibrary{std::move(*dance), Done{}}) : dance.error();
  }
  LibrarySearch search({project.file, references, session.project, wish.library, wish.open});
  const SessionLibrary* reference = reference_of(session);
  auto found = search.find(reference, progress);
  if (!found && wish.library.empty() && (wish.may_stand_in || !has_frames))
    return stand_in(found.error(), project, progress);
  if (!found)
    return Error{found.error().message + "; open the session together with its library (both files at once)",
                 found.error().where};
  // Other labels than when a frame was recorded change nothing that is shown of it.
  if (found->fits || (reference && has_motion_of(*reference, *found->material.library))) return found;
  // Roles that were annotated make other pairs of the same motion.
  const bool is_the_same = std::ranges::any_of(references, [&](const SessionLibrary& each) {
    return has_motion_of(each, *found->material.library_of_files());
  });
  found->material.warnings.push_back(
      is_the_same ? "frames that were solved while the takes had other roles have no mesh"
                  : found->fits.error().text() +
                        "; the recorded frames have no mesh, and candidates only "
                        "where their takes have the same names");
  return found;
}

/// The clip that played the user when the session was saved continues after the recorded frames. A device
/// does not: the user connects it again.
bool clip_continues(const OpenedSession& session) {
  const auto& inputs = session.recording.contents.inputs;
  const Project& project = session.project->project();
  const bool is_named =
      !project.input.empty() ||
      std::ranges::any_of(project.data, [](const DataReference& data) { return data.use == Use::Motion; });
  return session.project->reading.is_saved && is_named && !inputs.empty() &&
         inputs.back().text.starts_with("clip:");
}

Status add_frames(const OpenedSession& session, const FoundLibrary& found, bool continues,
                  const Progress& progress, Material& material) {
  const SessionReading& recording = session.recording;
  const std::string& file = session.project->file;
  // Earlier frames may be of the library before its takes were annotated.
  for (const auto& library : {found.material.library, found.material.unannotated})
    recording.frames->add_library(library);
  // Timeline and plots ask for it as soon as it is open, on the window's thread: then it is there.
  const FrameStore::Span span = recording.frames->span();
  report(progress, 0.8, "Reading the recorded frames");
  const auto overview =
      recording.frames->between(span.first_index, span.last_index, FrameHistory::overview_frames);
  if (overview.empty() && recording.frames->damaged() > 0)
    return Error{"none of its " + std::to_string(span.frames) +
                     " frames can be read: " + recording.frames->damage() + ". If there is a copy, open that",
                 file};
  if (recording.frames->damaged() > 0)
    material.warnings.push_back("frames are damaged and passed over (" + recording.frames->damage() + ")");
  material.recorded =
      std::make_shared<const RecordedSession>(RecordedSession{file, recording.frames, recording.contents});
  const SessionLibrary* reference = reference_of(session);
  material.excluded_takes = (reference ? *reference : recording.contents.libraries.back()).excluded_takes;
  // A library that stands in has other takes; a warning names the one that is missing.
  if (found.material.stands_in || !reference)
    std::erase_if(material.excluded_takes,
                  [&](const std::string& take) { return found.material.library->find_take(take) < 0; });
  if (continues) return Done{};
  material.input = {};
  material.input.name = fs::path(file).stem().string();
  material.input.fps = rate_of(recording.contents);
  return Done{};
}

/// As the person said it who saved the project.
MotionReading reading_of(const OpenedProject& project, const std::string& motion,
                         std::vector<std::string>& warnings) {
  MotionReading reading;
  const auto& view = project.project().view;
  if (const auto how = view.find(view_of_reading); how != view.end()) {
    auto said = parse_reading(how->second, project.file);
    if (said)
      reading = std::move(*said);
    else
      warnings.push_back("how its motion was read is damaged (" + said.error().message +
                         "); it was read as found");
  }
  reading.file = motion;
  reading.skeleton = project.place_of(Use::Skeleton);
  if (const std::string map = project.place_of(Use::JointMap); !map.empty()) reading.joint_map = map;
  return reading;
}

/// The motion file of the project where all of it is there, else a take of the library.
Status add_input(const OpenedProject& project, Material& material) {
  const auto missing = project.missing();
  const bool can_read = std::ranges::none_of(missing, [&](std::size_t i) {
    const Use use = project.project().data[i].use;
    return use == Use::Skeleton || use == Use::JointMap;
  });
  if (const std::string motion = project.place_of(Use::Motion); can_read && !motion.empty())
    return read_input(reading_of(project, motion, material.warnings), material);
  const int take = material.library->find_take(project.project().input);
  if (take < 0 && !material.input.poses.empty()) return Done{};  // of a generated set
  // The library may have been taken from what is open, or from a file.
  if (const auto generate = generated_of_name(material.library->name()); take < 0 && generate) {
    auto generated = generate({});
    if (!generated) return generated.error();
    if (generated->input.name == project.project().input) {
      material.input = std::move(generated->input);
      return Done{};
    }
  }
  if (take < 0 && !project.project().input.empty() && !material.library->takes().empty())
    material.warnings.push_back(
        fmt::format("the motion \"{}\" is not there; the take {} plays the user instead",
                    project.project().input, material.library->takes().back().name));
  material = danced_with(material, take < 0 ? static_cast<int>(material.library->takes().size()) - 1 : take);
  return Done{};
}

void warn_of_data(const OpenedProject& project, std::vector<std::string>& warnings) {
  for (std::size_t i = 0; i < project.found.size(); ++i) {
    const DataReference& data = project.project().data[i];
    const std::string name = fs::path(data.absolute_path).filename().string();
    if (project.found[i].state == FoundData::State::Changed)
      warnings.push_back(name + " has other content than when the session was saved");
    if (project.found[i].state == FoundData::State::Missing && !is_of_library(data.use))
      warnings.push_back(name + " is not there: " + without(data.use));
  }
}

void warn_of_takes(const Project& project, Material& material) {
  for (const auto& [take, count] : annotated_elsewhere(project.annotations, *material.library))
    material.warnings.push_back(
        fmt::format("{} annotation{} of {} {} kept, and not shown: the library \"{}\" has no such take",
                    count, count == 1 ? "" : "s", take, count == 1 ? "is" : "are", material.library->name()));
}

}  // namespace

Result<Material> material_of(const OpenedSession& session, const SessionWish& wish,
                             const Progress& progress) {
  const OpenedProject& project = *session.project;
  const bool has_frames = session.has_frames();
  if (!has_frames && !project.reading.is_saved)
    return Error{"has no frames: nothing was recorded into it", project.file};
  if (has_frames && session.recording.contents.libraries.empty())
    return Error{"does not say which library it was solved with", project.file};
  auto found = library_for(session, wish, progress);
  if (!found) return found.error();
  Material material = found->material;
  const bool continues = has_frames && clip_continues(session);
  if (!has_frames || continues)
    if (const Status added = add_input(project, material); !added) return added.error();
  if (has_frames)
    if (const Status added = add_frames(session, *found, continues, progress, material); !added)
      return added.error();
  const auto damage = session.damage();
  material.warnings.insert(material.warnings.begin(), damage.begin(), damage.end());
  if (!has_frames || continues) warn_of_data(project, material.warnings);
  warn_of_takes(project.project(), material);
  material.stands_in = found->material.stands_in;
  material.project = session.project;
  return material;
}

}  // namespace abrazo
