#include <cmath>
#include <cstring>

#include "core/base/text.hpp"
#include "core/library/store/motion_library_file.hpp"
#include "core/motion/scenes/character_glb.hpp"
#include "core/synthesis/frames/trace.hpp"
#include "tests/cli/command_line_fixture.hpp"
#include "tests/core/opening/opening_files.hpp"
#include "tests/support/humanoid_rig.hpp"

namespace abrazo::test::export_command_test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

/// A session of two seconds that a recorder wrote: "s.abrazo", with the take "waltz" from about 0.5 to 1.5 s,
/// a stream of the performer "Ana", and its library "small.h5".
class ExportCommand : public CommandLineTest {
 protected:
  ExportCommand() {
    EXPECT_TRUE(write_library(*session_library(), path("small.h5")));
    RecordingFacts facts = session_facts();
    facts.library_path = path("small.h5").string();
    session.keeper->recorder = *Recorder::open(path("s.abrazo").string(), facts);
    Recorder& recorder = *session.keeper->recorder;
    for (int i = 0; i < 100; ++i)
      recorder.pose_received(
          received("Ana", i / 50.0, swinging_take("sent", 100, 8).a.poses[static_cast<std::size_t>(i)]));
    session.run_until(0.5);
    recorder.begin_take("waltz");
    session.run_until(1.5);
    recorder.end_take();
    session.run_until(2);
    EXPECT_TRUE(recorder.finish());
  }

  Outcome exported(const std::string& more) const { return run("export s.abrazo " + more); }
  const std::vector<FrameSnapshotPtr>& frames() const { return session.keeper->frames; }

  DrivenSession session;
};

TEST_F(ExportCommand, TheBodiesAsCsvAreThoseThatWereSolved) {
  for (const std::string body : {"user", "active", "passive"}) {
    const Outcome outcome = exported("--what " + body + " -o out.csv --json");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto said = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(said["rate_hz"], 60);
    EXPECT_EQ(said["frames"], frames().size());
    EXPECT_EQ(said["gaps"], 0);
    EXPECT_EQ(said["files"], nlohmann::json::array({"out.csv"}));
    const Table table = parse_table(read("out.csv"));
    ASSERT_EQ(table.rows.size(), frames().size());
    const FrameSnapshot& frame = *frames()[70];
    const Pose pose = body == "user"     ? frame.user
                      : body == "active" ? Pose(frame.result.active())
                                         : Pose(frame.result.passive());
    EXPECT_NEAR(table.at(70, "lhand_x"), pose(20, 0), 1e-9);
    EXPECT_NEAR(table.at(70, "head_y"), pose(16, 1), 1e-9);
  }
}

TEST_F(ExportCommand, BvhAndGlbHoldTheTakeOfBothBodies) {
  ASSERT_EQ(exported("--what active,passive --take waltz -o pair.bvh").status, 0);
  ASSERT_EQ(run("motion positions pair.bvh --performer 2 -o passive.csv").status, 0);
  EXPECT_THAT(parse_table(read("passive.csv")).rows, SizeIs(60));
  ASSERT_EQ(exported("--what active,passive --take waltz -o pair.glb").status, 0);
  const std::string glb = read("pair.glb");
  ASSERT_EQ(glb.substr(0, 4), "glTF");
  std::uint32_t bytes = 0;
  std::memcpy(&bytes, glb.data() + 12, 4);
  const auto gltf = nlohmann::json::parse(glb.substr(20, bytes));
  EXPECT_THAT(gltf["skins"], SizeIs(2));
  EXPECT_EQ(gltf["skins"][1]["name"], "passive");
  EXPECT_NEAR(gltf["accessors"][gltf["animations"][0]["samplers"][0]["input"].get<std::size_t>()]["max"][0]
                  .get<double>(),
              59 / 60.0, 1e-6);
}

TEST_F(ExportCommand, ACharacterPerformsTheBodiesInAFileEach) {
  write("rig.vrm", rig(Naming::Vrm1));
  const Outcome outcome = exported("--what active,passive --character rig.vrm -o out.glb --json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["files"],
            nlohmann::json::array({"out_active.glb", "out_passive.glb"}));
  Clip active{"active", 60, {}}, passive{"passive", 60, {}};
  for (const FrameSnapshotPtr& frame : frames()) {
    active.poses.emplace_back(frame->result.active());
    passive.poses.emplace_back(frame->result.passive());
  }
  const auto performed = write_character_glbs(rig(Naming::Vrm1), std::vector{active, passive}, "rig.vrm");
  EXPECT_EQ(read("out_active.glb"), performed->at(0));
  EXPECT_EQ(read("out_passive.glb"), performed->at(1));
  EXPECT_THAT(names(), Not(Contains("out.glb")));
  ASSERT_EQ(exported("--what user --performer Ana --character rig.vrm -o received.vrm").status, 0);
  EXPECT_THAT(names(), Contains("received_user.vrm"));
}

TEST_F(ExportCommand, ACharacterThatCannotPerformIsRefusedAndNothingWritten) {
  write("rig.glb", rig(Naming::Mixamo));
  write("box.glb", "no humanoid");
  const auto before = names();
  expect_failure(exported("--what active --character rig.glb -o out.bvh"), "written as .glb or .vrm");
  expect_failure(exported("--what mesh --time 1 --character rig.glb -o out.vtu"),
                 "performs motion, not meshes");
  expect_failure(exported("--what active --character rig.glb --out-units cm -o out.glb"),
                 "has its own bones");
  expect_failure(exported("--what active,passive --character box.glb -o out.glb"), "is no GLB");
  expect_failure(exported("--what active --character gone.glb -o out.glb"), "gone.glb");
  write("rig_active.glb", rig(Naming::Mixamo));
  expect_failure(exported("--what active --character rig_active.glb -o rig.glb"), "is also read");
  std::filesystem::remove(path("rig_active.glb"));
  EXPECT_EQ(names(), before);
}

TEST_F(ExportCommand, ATimeRangeAndAnotherRate) {
  const Outcome outcome = exported("--what passive --from 0.5 --to 1.0 --rate 120 -o part.csv --json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto said = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(said["rate_hz"], 120);
  EXPECT_TRUE(said["resampled"]);
  EXPECT_NEAR(said["from_s"].get<double>(), 0.5, 1 / 60.0);
  EXPECT_NEAR(static_cast<double>(parse_table(read("part.csv")).rows.size()), 61, 2);
}

TEST_F(ExportCommand, WhatWasReceivedIsThereWhetherItWasSolvedOrNot) {
  ASSERT_EQ(exported("--what user --performer Ana -o ana.csv").status, 0);
  const Table table = parse_table(read("ana.csv"));
  ASSERT_THAT(table.rows, SizeIs(100));
  EXPECT_NEAR(table.at(1, "time"), 0.02, 1e-9);
  EXPECT_NEAR(table.at(33, "lhand_y"), swinging_take("sent", 100, 8).a.poses[33](20, 1), 1e-9);
  expect_failure(exported("--what user --performer Bo -o bo.csv"), "no performer 'Bo'; there are 'Ana'");
}

TEST_F(ExportCommand, OneMeshIsThatOfItsFrame) {
  const Outcome outcome = exported("--what mesh --frame 70 -o mesh.vtu --json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const FrameSnapshot& frame = *frames()[70];
  const auto said = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(said["edges"], frame.result.edges.size());
  EXPECT_EQ(said["tetrahedra"], frame.result.tetrahedra.size());
  const std::string vtu = read("mesh.vtu");
  EXPECT_THAT(vtu,
              HasSubstr("NumberOfCells=\"" +
                        std::to_string(frame.result.edges.size() + frame.result.tetrahedra.size()) + "\""));
  const std::string root = exact_text(frame.result.result(0, 0)) + ' ' +
                           exact_text(frame.result.result(0, 1)) + ' ' +
                           exact_text(frame.result.result(0, 2));
  EXPECT_THAT(vtu, HasSubstr(root));
  EXPECT_THAT(vtu, HasSubstr(exact_text(frame.result.edge_residuals_m[3])));
  ASSERT_EQ(exported("--what mesh --time " + exact_text(frame.time_s + 0.001) + " -o same.vtu").status, 0);
  EXPECT_EQ(read("same.vtu"), vtu);
}

TEST_F(ExportCommand, AMeshSeriesIsFilesAndTheirCollection) {
  const Outcome outcome = exported("--what mesh --take waltz --rate 10 -o mesh.vtu");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(names(), Contains("mesh.pvd"));
  EXPECT_THAT(names(), Contains("mesh_0001.vtu"));
  EXPECT_THAT(names(), Contains("mesh_0010.vtu"));
  EXPECT_THAT(names(), Not(Contains("mesh_0011.vtu")));
  EXPECT_THAT(read("mesh.pvd"), HasSubstr("file=\"mesh_0010.vtu\""));
}

TEST_F(ExportCommand, TheTraceIsThatOfTheLiveSessionButForTimes) {
  const Outcome outcome = exported("--what trace -o t.jsonl --json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["differ"], 0);
  auto trace = parse_lines(read("t.jsonl"));
  ASSERT_EQ(trace.size(), frames().size() + 1);
  EXPECT_EQ(trace[0]["abrazo_trace"], 1);
  EXPECT_EQ(trace[0]["settings"]["morph-steps"], 5);
  for (std::size_t i = 0; i < frames().size(); ++i) {
    auto live = nlohmann::json::parse(trace_frame_line(frames()[i]->result, *session_library(),
                                                       frames()[i]->input_frame, frames()[i]->time_s));
    live.erase("timing_us");
    trace[i + 1].erase("timing_us");
    ASSERT_EQ(trace[i + 1], live) << "frame " << i;
  }
}

TEST_F(ExportCommand, ALibraryThatMovedIsAskedForAndCanBeGiven) {
  std::filesystem::create_directory(path("elsewhere"));
  std::filesystem::rename(path("small.h5"), path("elsewhere/small.h5"));
  for (const std::string what : {"trace -o t.jsonl", "mesh -o m.vtu"}) {
    expect_failure(exported("--what " + what), "--library LIB");
    EXPECT_EQ(exported("--what " + what + " --library elsewhere/small.h5").status, 0);
  }
  EXPECT_EQ(exported("--what active -o a.bvh").status, 0);  // needs none
  EXPECT_EQ(exported("--what labels -o l.eaf").status, 0);
}

TEST_F(ExportCommand, ALibraryThatWasBuiltInTheWindowIsBuiltAgain) {
  make_demo();
  const Material built = built_of(path("demo/manifest.json").string());
  record(path("built.abrazo").string(), built.library, "");
  const std::string mesh = "export built.abrazo --what mesh -o m.vtu";
  expect_failure(run(mesh), "which was not a file; --library LIB");
  EXPECT_EQ(run(mesh + " --library demo/manifest.json").status, 0);
  save(path("built.abrazo").string(), built);
  const Outcome outcome = run(mesh);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
}

TEST_F(ExportCommand, AnotherLibraryIsNotTakenForTheSessions) {
  make_library();
  expect_failure(exported("--what trace -o t.jsonl --library demo.h5"),
                 "demo.h5: the session was recorded with");
  EXPECT_THAT(names(), Not(Contains("t.jsonl")));
}

TEST_F(ExportCommand, LabelsAsEafJsonAndCsv) {
  ASSERT_EQ(exported("--what labels -o l.eaf").status, 0);
  EXPECT_THAT(read("l.eaf"), HasSubstr("<ANNOTATION_VALUE>waltz</ANNOTATION_VALUE>"));
  EXPECT_THAT(read("l.eaf"), HasSubstr("TIER_ID=\"user role\""));
  ASSERT_EQ(exported("--what labels -o l.json").status, 0);
  const auto tiers = nlohmann::json::parse(read("l.json"))["tiers"];
  EXPECT_EQ(tiers[0]["name"], "take");
  EXPECT_NEAR(tiers[0]["intervals"][0]["start_s"].get<double>(), 0.5, 0.02);
  EXPECT_EQ(tiers[1]["intervals"][0]["value"], "active");
  ASSERT_EQ(exported("--what labels -o l.csv").status, 0);
  EXPECT_EQ(read("l.csv"), "take,start_frame,end_frame,label,detail,confidence\nwaltz,0,60,turn,,\n");
}

TEST_F(ExportCommand, WhatDoesNotFitIsRefusedWithWhatDoes) {
  expect_failure(exported("--what mesh -o m.bvh"),
                 "m.bvh: meshes cannot be written as this file type; use .vtu or .pvd");
  expect_failure(exported("--what labels -o l.bvh"), "use .eaf, .csv, .json, .TextGrid or .txt");
  expect_failure(exported("--what trace -o t.csv"), "use .jsonl");
  expect_failure(exported("--what active -o a.vtu"), "use .bvh, .glb, .csv, .npz or .npy");
  expect_failure(exported("--what active,mesh -o a.bvh"), "mesh needs one of its own");
  expect_failure(exported("--what active --performer Ana -o a.bvh"), "--performer is for --what user");
  expect_failure(exported("--what active --frame 3 -o a.bvh"), "use --from and --to");
  expect_failure(exported("--what active --take tango -o a.bvh"), "has no take 'tango'; there are 'waltz'");
  expect_failure(exported("--what active --from 7 -o a.bvh"), "they go from");
  expect_failure(exported("--what mesh --frame 9999 -o m.vtu"), "has no frame 9999");
  expect_wrong_usage(exported("--what bones -o a.bvh"), "bones");
  expect_wrong_usage(run("export s.abrazo -o a.bvh"), "--what");
  EXPECT_THAT(names(), ElementsAre("s.abrazo", "small.h5"));
}

TEST_F(ExportCommand, WhatIsNoSessionFileIsRefused) {
  write("odd.abrazo", "not a database, but long enough to look at");
  expect_failure(run("export odd.abrazo --what user -o u.csv"), "odd.abrazo");
  expect_failure(run("export gone.abrazo --what user -o u.csv"), "gone.abrazo");
  expect_failure(exported("--what user -o s.abrazo.csv/x.csv"), "folder does not exist");
}

TEST_F(ExportCommand, QuietSaysNothing) {
  const Outcome outcome = exported("--what mesh -o m.vtu --quiet");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.out, IsEmpty());
  EXPECT_THAT(outcome.err, IsEmpty());
}

}  // namespace
}  // namespace abrazo::test::export_command_test
