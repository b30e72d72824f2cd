// Which settings count with which method: what the window greys out, and the sweep does not offer.
#include <gtest/gtest.h>

#include "core/base/text.hpp"
#include "core/choreography/salsa.hpp"
#include "core/library/build/motion_library_builder.hpp"
#include "core/synthesis/settings/settings.hpp"
#include "core/synthesis/step/partner_synthesizer.hpp"

namespace abrazo::setting_effects_test {
namespace {

constexpr int frames = 180;
constexpr Duration step_time(1.0 / 60);

const std::vector<PairedTake>& dance() {
  static const auto takes = [] {
    ChoreographyOptions options;
    options.minutes = 0.5;
    options.take_seconds = 10;
    return generate_salsa(options);
  }();
  return takes;
}

const std::shared_ptr<const MotionLibrary>& library() {
  static const auto built = [] {
    LibraryBuildOptions options;
    options.rate_hz = 30;
    return std::make_shared<const MotionLibrary>(
        *build_library("dance", {dance().begin(), dance().begin() + 2}, options, {}));
  }();
  return built;
}

/// What is seen of a step: both bodies, and how many pairs they were chosen from.
using Seen = std::pair<PairPose, std::size_t>;

/// Of every step with the third take as the user.
std::vector<Seen> danced_with(const Settings& settings) {
  auto synthesizer = std::move(*PartnerSynthesizer::create(library(), settings));
  std::vector<Seen> seen;
  for (int i = 0; i < frames; ++i) {
    const FrameResult& frame = synthesizer->step(dance()[2].a.poses[static_cast<std::size_t>(i)], step_time);
    seen.emplace_back(frame.result, frame.candidates.size());
  }
  return seen;
}

/// These need more than a dance of two people of the library's size whose moves nobody named.
bool needs_more(std::string_view key) {
  return key == "meant-weight" || key == "scale-root-path" || key == "step-rate";
}

std::vector<Settings> with_other_values(const Settings& settings, const SettingInfo& info) {
  std::vector<Settings> others;
  const auto add = [&](const std::string& value) {
    Settings other = settings;
    if (set_setting(other, info.key, value) && !(other == settings)) others.push_back(other);
  };
  if (info.kind == SettingInfo::Kind::Flag) return add("on"), add("off"), others;
  if (info.kind == SettingInfo::Kind::Choice) {
    for (const std::string_view choice : split_fields(info.choices, '|')) add(std::string(choice));
    return others;
  }
  if (info.kind == SettingInfo::Kind::Body) return add("scale:0.85"), others;
  add(exact_text(info.minimum));
  add(exact_text(info.maximum));
  return others;
}

class SettingEffects : public testing::TestWithParam<std::tuple<SelectionMethod, SourcePlayback>> {};

TEST_P(SettingEffects, ASettingChangesTheDanceExactlyWhenItApplies) {
  Settings settings = *preset("responsive");
  settings.velocity_weight = 0.2;
  settings.selection = std::get<0>(GetParam());
  settings.playback = std::get<1>(GetParam());
  const auto usual = danced_with(settings);
  for (const SettingInfo& info : all_settings()) {
    if (info.key == "selection" || info.key == "playback" || needs_more(info.key)) continue;
    bool has_effect = false;
    for (const Settings& other : with_other_values(settings, info))
      has_effect = has_effect || danced_with(other) != usual;
    EXPECT_EQ(has_effect, applies(settings, info.key)) << info.key;
  }
}

TEST_P(SettingEffects, ASettingOfWhatIsOffChangesNothing) {
  Settings settings = *preset("responsive");
  settings.velocity_weight = 0;
  settings.foot_locks = false;
  settings.selection = std::get<0>(GetParam());
  settings.playback = std::get<1>(GetParam());
  const auto usual = danced_with(settings);
  for (const char* key : {"velocity-form", "foot-lock-speed"}) {
    EXPECT_FALSE(applies(settings, key)) << key;
    for (const Settings& other : with_other_values(settings, *find_setting(key)))
      EXPECT_EQ(danced_with(other), usual) << key;
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, SettingEffects,
                         testing::Combine(testing::Values(SelectionMethod::Paper, SelectionMethod::Intent),
                                          testing::Values(SourcePlayback::Frames,
                                                          SourcePlayback::Continuous)));

}  // namespace
}  // namespace abrazo::setting_effects_test
