// What the fuzzers kept, once through each target: inputs that reach far, and those that once broke it.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "tests/fuzz/fuzz_target.hpp"

namespace abrazo::fuzz::corpus_test {
namespace {

namespace fs = std::filesystem;

std::vector<std::uint8_t> content_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, none))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

class KeptInputs : public testing::TestWithParam<Target> {
 protected:
  void read_all(const char* kind) const {
    for (const fs::path& file : files_in(fs::path(ABRAZO_FUZZ_FOLDER) / kind / GetParam().name)) {
      const std::vector<std::uint8_t> bytes = content_of(file);
      EXPECT_NO_THROW(GetParam().read(bytes)) << file;
    }
  }
};

TEST_P(KeptInputs, AreReadOrRefusedWithAReason) {
  read_all("corpus");
}

TEST_P(KeptInputs, WhatOnceBrokeAReaderDoesSoNoMore) {
  read_all("regressions");
}

TEST_P(KeptInputs, NothingAndShortNoiseAreNoTrouble) {
  std::vector<std::uint8_t> bytes;
  for (int length = 0; length < 64; ++length) {
    EXPECT_NO_THROW(GetParam().read(bytes)) << length << " bytes";
    bytes.push_back(static_cast<std::uint8_t>(length * 151 + 7));
  }
}

INSTANTIATE_TEST_SUITE_P(Every, KeptInputs, testing::ValuesIn(targets()),
                         [](const auto& target) { return std::string(target.param.name); });

TEST(KeptInputs, AreThereAndEveryFolderHasATarget) {
  std::size_t inputs = 0;
  for (const char* kind : {"corpus", "regressions"})
    for (const fs::directory_entry& folder : fs::directory_iterator(fs::path(ABRAZO_FUZZ_FOLDER) / kind)) {
      inputs += files_in(folder.path()).size();
      const std::string name = folder.path().filename().string();
      if (name == "intrinsics" || name == "view_json") continue;  // these are not there without OpenCV or Qt
      EXPECT_TRUE(std::any_of(targets().begin(), targets().end(),
                              [&](const Target& target) { return target.name == name; }))
          << kind << "/" << name;
    }
  EXPECT_GT(inputs, 400U) << "they are not all there";
}

}  // namespace
}  // namespace abrazo::fuzz::corpus_test
