#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>

#include "core/base/text.hpp"
#include "core/synthesis/settings/settings.hpp"
#include "tests/cli/command_line_fixture.hpp"

namespace abrazo::test::settings_test {
namespace {

using ::testing::HasSubstr;

class SettingsOptions : public CommandLineTest {
 protected:
  /// The settings that a run says it used.
  nlohmann::json used(const std::string& options) const {
    const Outcome outcome =
        run("synth --library demo.h5 --input demo/salsa_01_a.bvh --trace t.jsonl " + options);
    EXPECT_EQ(outcome.status, 0) << options << ": " << outcome.err;
    return parse_lines(read("t.jsonl")).at(0)["settings"];
  }
};

TEST_F(SettingsOptions, EachOfTheContractCanBeGiven) {
  make_library();
  const std::vector<std::pair<std::string, nlohmann::json>> given = {
      {"alpha 0.75", 0.75},
      {"velocity-weight 0.4", 0.4},
      {"velocity-form predicted", "predicted"},
      {"morph-weight 100", 100},
      {"morph-steps 2", 2},
      {"projection-steps 0", 0},
      {"neighbours 200", 200},
      {"neighbours 1", 1},
      {"edge-weights inverse-mean", "inverse-mean"},
      {"edge-weights uniform", "uniform"},
      {"step-rate 7.5", 7.5},
      {"collisions off", false},
      {"foot-locks off", false},
      {"user-role passive", "passive"},
      {"selection intent", "intent"},
  };
  for (const auto& [words, value] : given) {
    const std::string key = words.substr(0, words.find(' '));
    const std::string few_steps = key == "step-rate" ? "" : "--step-rate 5 ";
    EXPECT_EQ(used(few_steps + "--" + words).at(key), value) << words;
  }
}

TEST_F(SettingsOptions, AreChangedOnTopOfThePreset) {
  make_library();
  const auto responsive = nlohmann::json::parse(settings_json(*preset("responsive")));
  EXPECT_EQ(used(""), responsive) << "the default";
  EXPECT_EQ(used("--preset paper"), nlohmann::json::parse(settings_json(*preset("paper"))));
  auto changed = responsive;
  changed["alpha"] = 0.3;
  EXPECT_EQ(used("--alpha 0.3"), changed);
}

TEST_F(SettingsOptions, AWrongValueIsWrongUsageThatSaysTheRange) {
  const std::string synth = "synth --library l.h5 --input a.bvh ";
  expect_wrong_usage(run(synth + "-k 0"), "--neighbours: '0' cannot be used: a whole number from 1 to 200");
  expect_wrong_usage(run(synth + "-k 201"), "a whole number from 1 to 200");
  expect_wrong_usage(run(synth + "-k 1.5"), "a whole number from 1 to 200");
  expect_wrong_usage(run(synth + "--alpha nan"), "--alpha: 'nan' cannot be used");
  expect_wrong_usage(run(synth + "--alpha -1"), "a number from 0 to 5");
  expect_wrong_usage(run(synth + "--alpha 1 --alpha 2"), "--alpha");
  expect_wrong_usage(run(synth + "--collisions yes"), "on or off");
  expect_wrong_usage(run(synth + "--edge-weights Uniform"), "inverse|inverse-mean|uniform");
  expect_wrong_usage(run(synth + "--preset paperback"), "paperback");
}

TEST_F(SettingsOptions, HelpShowsEachWithItsRange) {
  const std::string help = run("synth --help").out;
  for (const SettingInfo& info : all_settings())
    EXPECT_THAT(help, HasSubstr("--" + std::string(info.key) + " "));
  EXPECT_THAT(help, HasSubstr("[1 to 200; default 10]"));
}

// The guide's table: | `key` | symbol | paper | responsive | range | ... |
TEST_F(SettingsOptions, AreInTheGuideWithTheirValues) {
  std::ifstream in(ABRAZO_GUIDE "/command-line.md");
  const std::string guide{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  std::map<std::string, std::vector<std::string>> rows;
  for (const std::string_view line : split_lines(guide)) {
    const auto cells = split_fields(line, '|');
    if (!line.starts_with("| `") || cells.size() < 8) continue;  // tables of fields have fewer columns
    const std::string_view key = cells[1].substr(1, cells[1].find('`', 1) - 1);
    rows[std::string(key)].assign(cells.begin() + 1, cells.end());
  }
  for (const SettingInfo& info : all_settings()) {
    const std::string key(info.key);
    ASSERT_TRUE(rows.contains(key)) << key << " has no row in the table of settings";
    EXPECT_EQ(rows[key][2], setting_text(*preset("paper"), key)) << key;
    EXPECT_EQ(rows[key][3], setting_text(*preset("responsive"), key)) << key;
  }
}

}  // namespace
}  // namespace abrazo::test::settings_test
