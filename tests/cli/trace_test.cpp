#include "tests/cli/command_line_fixture.hpp"

namespace abrazo::test::trace_test {
namespace {

using ::testing::Each;
using ::testing::SizeIs;

/// What `abrazo synth --trace` writes, against the fields that other programs were promised.
class Trace : public CommandLineTest {
 protected:
  std::vector<nlohmann::json> trace(const std::string& more = "", const std::string& preset = "paper") const {
    const Outcome outcome =
        run("synth --library demo.h5 --input demo/salsa_01_a.bvh --trace t.jsonl --preset " + preset + " " +
            more);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return parse_lines(read("t.jsonl"));
  }
};

TEST_F(Trace, BeginsWithWhatItWasMadeFrom) {
  make_library();
  const auto header = trace("--alpha 0.25 -k 7 --collisions off").at(0);
  EXPECT_EQ(header["abrazo_trace"], 1);
  EXPECT_TRUE(header["version"].is_string());
  EXPECT_EQ(header["library"], "demo.h5");
  EXPECT_EQ(header["input"], "demo/salsa_01_a.bvh");
  EXPECT_THAT(header["joints"], SizeIs(25));
  EXPECT_EQ(header["joints"][24], "rhand");
  EXPECT_EQ(header["units"], "m");
  EXPECT_EQ(header["fps"], 15);
  EXPECT_EQ(header["settings"]["alpha"], 0.25);
  EXPECT_EQ(header["settings"]["neighbours"], 7);
  EXPECT_EQ(header["settings"]["collisions"], false);
}

TEST_F(Trace, EveryStepHasThePromisedFieldsAndShapes) {
  make_library();
  const auto lines = trace();
  ASSERT_GT(lines.size(), 100u);
  for (std::size_t line = 1; line < lines.size(); ++line) {
    const nlohmann::json& step = lines[line];
    ASSERT_EQ(step["frame"], 4 * (line - 1));
    ASSERT_NEAR(step["time"].get<double>(), static_cast<double>(line - 1) / 15, 1e-9);
    for (const char* pointer : {"/query/world", "/query/normalized", "/selected_pair/active",
                                "/selected_pair/passive", "/active", "/passive"}) {
      const auto& pose = step.at(nlohmann::json::json_pointer(pointer));
      ASSERT_THAT(pose, SizeIs(25)) << pointer;
      ASSERT_THAT(pose, Each(SizeIs(3))) << pointer;
    }
    ASSERT_THAT(step["query"]["features"], SizeIs(15));
    ASSERT_THAT(step["mesh"]["edges"], Each(SizeIs(2)));
    ASSERT_THAT(step["mesh"]["tetrahedra"], Each(SizeIs(4)));
    for (const char* pointer :
         {"/energy/deformation", "/energy/velocity", "/energy/constraint", "/residual/bone_length_max",
          "/residual/foot_lock_max_m", "/residual/penetration_max_m", "/residual/excess_penetration_max_m",
          "/residual/morph_rms_m", "/timing_us/retarget", "/timing_us/select", "/timing_us/mesh",
          "/timing_us/solve", "/timing_us/total"})
      ASSERT_TRUE(step.at(nlohmann::json::json_pointer(pointer)).is_number()) << pointer;
    ASSERT_TRUE(step["foot_locks"].is_array());
    for (const auto& contact : step["collisions"]) {
      ASSERT_THAT(contact["a"], SizeIs(2));
      ASSERT_THAT(contact["b"], SizeIs(2));
      ASSERT_TRUE(contact["depth_m"].is_number());
    }
    ASSERT_TRUE(step["status"] == "ok" || step["status"].get<std::string>().starts_with("relaxed: "));
  }
}

TEST_F(Trace, CandidatesAreInOrderAndTheCheapestIsSelected) {
  make_library();
  const auto lines = trace("--alpha 0.7");
  for (std::size_t line = 1; line < lines.size(); ++line) {
    const auto& candidates = lines[line]["candidates"];
    ASSERT_THAT(candidates, SizeIs(10));
    double previous = 0;
    for (const auto& candidate : candidates) {
      const auto& cost = candidate["cost"];
      const double pose = cost["pose"], active = cost["temporal_active"], passive = cost["temporal_passive"];
      ASSERT_NEAR(cost["total"].get<double>(), pose + 0.7 * (active + passive), 1e-12 + 1e-12 * pose);
      ASSERT_GE(candidate["feature_distance"].get<double>(), previous);
      previous = candidate["feature_distance"];
      ASSERT_GE(cost["total"], candidates.at(lines[line]["selected"].get<std::size_t>())["cost"]["total"]);
    }
  }
}

TEST_F(Trace, TwoRunsDifferInTheirTimingsAlone) {
  make_library();
  auto first = trace("", "responsive");
  auto second = trace("", "responsive");
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t line = 1; line < first.size(); ++line) {
    first[line].erase("timing_us");
    second[line].erase("timing_us");
    ASSERT_EQ(first[line], second[line]) << "line " << line + 1;
  }
}

TEST_F(Trace, ItsPosesAreThoseOfTheCsv) {
  make_library();
  const auto lines = trace("-o pair.csv");
  const Table pair = parse_table(read("pair.csv"));
  ASSERT_EQ(pair.rows.size(), lines.size() - 1);
  EXPECT_EQ(pair.at(30, "active.rhand_y"), lines[31]["active"][24][1]);
  EXPECT_EQ(pair.at(30, "passive.head_z"), lines[31]["passive"][16][2]);
}

}  // namespace
}  // namespace abrazo::test::trace_test
