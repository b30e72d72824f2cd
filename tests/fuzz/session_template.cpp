#include "tests/fuzz/session_template.hpp"

#include <fstream>
#include <iterator>
#include <limits>

#include "core/session/file/project.hpp"
#include "core/session/file/session_file.hpp"
#include "core/session/file/session_writer.hpp"
#include "core/session/file/synthesizer_state_bytes.hpp"
#include "core/synthesis/step/synthesizer_state.hpp"
#include "tests/core/session/project_values.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::fuzz {

namespace {

constexpr double for_ever = std::numeric_limits<double>::infinity();

FrameSnapshot snapshot(int index) {
  FrameSnapshot frame;
  frame.index = static_cast<std::uint64_t>(index);
  frame.time_s = 0.1 * index;
  frame.elapsed_s = 0.1;
  frame.input_frame = index;
  frame.user = test::standing_pose();
  frame.result.query_world = frame.user;
  frame.result.result = test::facing_pair(0.7);
  frame.result.candidates.resize(2);
  for (Candidate& candidate : frame.result.candidates) candidate.pair = index;
  frame.result.selected = 1;
  frame.result.collisions = {{{1, 2}, {26, 27}, 0.02, 0.01}};
  frame.result.message = "feet were let go";
  frame.settings.neighbours = 5 + index;
  Decisions decisions;
  decisions.pinned = index;
  decisions.vetoes.takes.insert("salsa");
  frame.decisions = std::make_shared<const Decisions>(decisions);
  SynthesizerState state;
  state.user_body = body_of(test::standing_pose());
  state.pinned = 3;
  state.vetoes = std::make_shared<const Vetoes>(decisions.vetoes);
  state.meant = IntendedPairs{"turn", std::nullopt};
  frame.before = std::make_shared<const SynthesizerState>(state);
  return frame;
}

ReceivedPose received(int index) {
  ReceivedPose made;
  made.performer = "Ana";
  made.pose.pose = test::standing_pose();
  made.pose.time_s = made.pose.arrived_s = 0.1 * index;
  made.sender_time_s = 100 + index;
  return made;
}

/// A project with rows in every table.
Project project() {
  for (unsigned seed = 0;; ++seed) {
    Project made = test::ProjectMaker(seed).make();
    bool camera = false, picked = false, sync = false, annotated = false, suggested = false;
    for (const ProjectVideo& video : made.videos) {
      camera = camera || video.camera;
      picked = picked || !video.picked.empty();
      sync = sync || !video.sync.points.empty();
    }
    for (const auto& [subject, annotations] : made.annotations) {
      suggested = suggested || !annotations.suggestions().empty();
      for (const AnnotationTier& tier : annotations.tiers())
        annotated = annotated || (!tier.annotations.empty() && !tier.vocabulary.empty());
    }
    if (camera && picked && sync && annotated && suggested && made.data.size() > 1 && made.view.size() > 1)
      return made;
  }
}

void write_template(const std::string& path) {
  const Project values = project();
  expect(save_project(path, values).ok(), "the template cannot be saved");
  const RecordingFacts facts{"", "small", 100, "clip:user.bvh", nullptr, {}};
  auto writer = SessionWriter::open(path, facts, {});
  expect(writer.ok(), "the template cannot be recorded");
  expect((*writer)->begin_batch().ok(), "the template cannot be written");
  (*writer)->begin_take("first");
  for (int i = 0; i < 3; ++i)
    expect((*writer)->write(snapshot(i)).ok() && (*writer)->write(received(i)).ok(),
           "the template has no frames");
  expect((*writer)->end_take().ok() && (*writer)->write(values.markers).ok(), "the template has no take");
  expect((*writer)->close(0).ok(), "the template cannot be closed");
}

void read_record(const SessionRecord& record) {
  (void)accepted(
      record.each_frame(-for_ever, for_ever, [](const FrameSnapshot&) -> Status { return Done{}; }));
  (void)accepted(record.each_pose(std::nullopt, -for_ever, for_ever,
                                  [](const ReceivedPose&) -> Status { return Done{}; }));
  (void)accepted(
      record.each_source(-for_ever, for_ever, [](const SessionSource&) -> Status { return Done{}; }));
}

}  // namespace

const std::vector<std::uint8_t>& session_template() {
  static const std::vector<std::uint8_t> bytes = [] {
    const ScratchFile file("template.abrazo", {});
    std::filesystem::remove(file.path());
    write_template(file.path().string());
    std::ifstream stream(file.path(), std::ios::binary);
    return std::vector<std::uint8_t>(std::istreambuf_iterator<char>(stream), {});
  }();
  return bytes;
}

const FrameRow& frame_template() {
  static const FrameRow row = row_of(snapshot(1), 1, 0);
  return row;
}

void read_session(const std::filesystem::path& path) {
  const std::string name = path.string();
  if (const auto project = read_project(name); accepted(project))
    expect(project->damaged == 0 || !project->damage.empty(), "damage of which nothing is said");
  const auto session = SessionFile::open(name);
  if (!accepted(session)) return;
  read_record(**session);
  const SessionContents& contents = (*session)->contents();
  for (const std::uint64_t frame : {contents.first_frame, contents.last_frame})
    (void)accepted((*session)->frame(frame));
}

}  // namespace abrazo::fuzz
