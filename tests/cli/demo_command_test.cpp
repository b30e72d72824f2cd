#include "tests/cli/command_line_fixture.hpp"

namespace abrazo::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class DemoCommand : public CommandLineTest {};

TEST_F(DemoCommand, WritesTakesLabelsAndTheManifestThatNamesThem) {
  const Outcome outcome = run("demo -o deep/inside --minutes 0.1");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.out, HasSubstr("next: abrazo library build deep/inside/manifest.json"));
  const auto manifest = nlohmann::json::parse(read("deep/inside/manifest.json"));
  ASSERT_EQ(manifest["takes"].size(), 1u);
  EXPECT_EQ(manifest["takes"][0]["roles"], "a");
  for (const char* performer : {"a", "b"})
    EXPECT_THAT(read("deep/inside/" + manifest["takes"][0][performer]["motion"].get<std::string>()),
                ::testing::StartsWith("HIERARCHY"));
  EXPECT_THAT(read("deep/inside/labels.csv"), ::testing::StartsWith("take,start_frame,end_frame,label"));
}

TEST_F(DemoCommand, TheSameSeedGivesTheSameFiles) {
  for (const std::string words : {"one --seed 4", "two --seed 4", "other --seed 5"})
    ASSERT_EQ(run("demo --minutes 0.1 -o " + words).status, 0);
  EXPECT_EQ(read("one/salsa_01_b.bvh"), read("two/salsa_01_b.bvh"));
  EXPECT_NE(read("one/salsa_01_b.bvh"), read("other/salsa_01_b.bvh"));
}

TEST_F(DemoCommand, AFileInTheFoldersPlaceIsLeftAlone) {
  write("taken", "mine");
  expect_failure(run("demo -o taken --minutes 0.1"), "taken: the folder cannot be made");
  expect_failure(run("demo -o taken/below --minutes 0.1"), "taken/below: the folder cannot be made");
  EXPECT_EQ(read("taken"), "mine");
}

TEST_F(DemoCommand, AnUnknownStyleIsWrongUsage) {
  expect_wrong_usage(run("demo -o d --style tango"), "tango");
  EXPECT_THAT(names(), ElementsAre());
}

}  // namespace
}  // namespace abrazo::test
