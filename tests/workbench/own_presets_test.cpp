#include "app/workbench/base/own_presets.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "core/base/atomic_file.hpp"

namespace abrazo::app::own_presets_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class PresetFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / (std::string("abrazo_presets_") +
                                              testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path file() const { return folder_ / "presets.json"; }

  static Settings calm() {
    Settings settings = *preset("paper");
    settings.alpha = 2;
    settings.foot_locks = false;
    return settings;
  }

  fs::path folder_;
};

TEST_F(PresetFile, IsEmptyBeforeAnythingWasSaved) {
  OwnPresets presets(file());
  EXPECT_TRUE(presets.read());
  EXPECT_TRUE(presets.all().empty());
  EXPECT_FALSE(fs::exists(file()));
}

TEST_F(PresetFile, GivesBackWhatWasSavedInItsOrder) {
  OwnPresets presets(file());
  ASSERT_TRUE(presets.save("calm", calm()));
  ASSERT_TRUE(presets.save(" \u00e9lan ", *preset("responsive")));
  OwnPresets again(file());
  ASSERT_TRUE(again.read());
  ASSERT_EQ(again.all().size(), 2U);
  EXPECT_EQ(again.all()[0], (OwnPreset{"calm", calm()}));
  EXPECT_EQ(again.all()[1].name, "\u00e9lan");
  EXPECT_EQ(again.all()[1].settings, *preset("responsive"));
  const std::string text = *read_whole_file(file());
  EXPECT_THAT(text, HasSubstr("\n        \"alpha\": 2")) << "readable, a line for each";
}

TEST_F(PresetFile, SavingUnderAKnownNameReplaces) {
  OwnPresets presets(file());
  ASSERT_TRUE(presets.save("calm", calm()));
  ASSERT_TRUE(presets.save("calm", *preset("responsive")));
  ASSERT_EQ(presets.all().size(), 1U);
  EXPECT_EQ(presets.all()[0].settings, *preset("responsive"));
}

TEST_F(PresetFile, CanBeRenamedAndRemoved) {
  OwnPresets presets(file());
  ASSERT_TRUE(presets.save("calm", calm()));
  ASSERT_TRUE(presets.save("other", calm()));
  EXPECT_THAT(presets.rename("calm", "other").error().text(), HasSubstr("already"));
  EXPECT_THAT(presets.rename("nobody", "x").error().text(), HasSubstr("no such preset"));
  ASSERT_TRUE(presets.rename("calm", "calmer"));
  ASSERT_TRUE(presets.remove("other"));
  OwnPresets again(file());
  ASSERT_TRUE(again.read());
  ASSERT_EQ(again.all().size(), 1U);
  EXPECT_EQ(again.all()[0].name, "calmer");
}

TEST_F(PresetFile, NamesOfBuiltInPresetsAndNoNameAreRefused) {
  OwnPresets presets(file());
  for (const char* name : {"", "  ", "paper", "responsive"}) EXPECT_FALSE(presets.save(name, calm())) << name;
  EXPECT_FALSE(presets.save(std::string(100, 'x'), calm()));
  EXPECT_FALSE(fs::exists(file()));
}

TEST_F(PresetFile, ABrokenFileIsNamedAndLeftAsItIs) {
  for (const char* broken : {"{\"abrazo_presets\": 1, \"presets\": [{\"name\":", "[]",
                             R"({"abrazo_presets": 1, "presets": [{"name": "a", "settings": {"alhpa": 1}}]})",
                             R"({"abrazo_presets": 1, "presets": [{"settings": {}}]})"}) {
    ASSERT_TRUE(write_whole_file(file(), broken));
    OwnPresets presets(file());
    const Status read = presets.read();
    ASSERT_FALSE(read) << broken;
    EXPECT_THAT(read.error().text(), HasSubstr("presets.json"));
    EXPECT_FALSE(presets.save("calm", calm()));
    EXPECT_EQ(*read_whole_file(file()), broken);
  }
}

TEST_F(PresetFile, ExportedSettingsComeBackAndSomeKeysAreEnough) {
  ASSERT_TRUE(write_whole_file(file(), readable_settings(calm())));
  EXPECT_EQ(*read_settings_file(file(), *preset("responsive")), calm());
  ASSERT_TRUE(write_whole_file(file(), R"({"alpha": 3})"));
  Settings wanted = *preset("responsive");
  wanted.alpha = 3;
  EXPECT_EQ(*read_settings_file(file(), *preset("responsive")), wanted);
  ASSERT_TRUE(write_whole_file(file(), R"({"alpha": 99})"));
  EXPECT_THAT(read_settings_file(file(), wanted).error().text(), HasSubstr("presets.json"));
}

}  // namespace
}  // namespace abrazo::app::own_presets_test
