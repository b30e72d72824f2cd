#include <cmath>
#include <sstream>

#include "tests/cli/command_line_fixture.hpp"
#include "tests/packaging/installed_files.hpp"

namespace abrazo::test::embedding_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// A program of somebody else's, which knows the engine only as it is installed.
class Embedding : public CommandLineTest {
 protected:
  Outcome in_a_clean_environment(std::vector<std::string> words) const {
    words.insert(words.begin(), {"/usr/bin/env", "-i", "PATH=/usr/local/bin:/usr/bin:/bin"});
    return RunningCommand(words, folder()).wait();
  }

  /// Of the example, as its page in the guide says.
  Outcome configure(const std::vector<std::string>& further = {}) const {
    std::vector<std::string> words = {ABRAZO_CMAKE,
                                      "-S",
                                      installed("share/doc/abrazo-dev/examples/embed").string(),
                                      "-B",
                                      "build",
                                      "-DCMAKE_BUILD_TYPE=Release",
                                      "-DCMAKE_CXX_COMPILER=" ABRAZO_COMPILER,
                                      "-DCMAKE_PREFIX_PATH=" ABRAZO_INSTALLED};
    words.insert(words.end(), further.begin(), further.end());
    return in_a_clean_environment(words);
  }
};

TEST_F(Embedding, AnotherProgramGetsThePartnerThatTheCommandLineGives) {
  const Outcome configured = configure();
  ASSERT_EQ(configured.status, 0) << configured.out << configured.err;
  const Outcome built = in_a_clean_environment({ABRAZO_CMAKE, "--build", "build"});
  ASSERT_EQ(built.status, 0) << built.out << built.err;

  make_demo("0.5");
  ASSERT_EQ(run("library build demo/manifest.json -o demo.h5").status, 0);
  const Outcome embedded =
      in_a_clean_environment({path("build/embed").string(), "demo.h5", "demo/salsa_01_a.bvh"});
  ASSERT_EQ(embedded.status, 0) << embedded.err;
  const Outcome told =
      run("synth --preset responsive --library demo.h5 --input demo/salsa_01_a.bvh -o pair.csv");
  ASSERT_EQ(told.status, 0) << told.err;

  const Table expected = parse_table(read("pair.csv"));
  std::istringstream roots(embedded.out);
  std::size_t rows = 0;
  for (double x = 0, y = 0, z = 0; roots >> x >> y >> z; ++rows) {
    ASSERT_LT(rows, expected.rows.size());
    EXPECT_NEAR(x, expected.at(rows, "passive.root_x"), 1e-6) << rows;
    EXPECT_NEAR(y, expected.at(rows, "passive.root_y"), 1e-6) << rows;
    EXPECT_NEAR(z, expected.at(rows, "passive.root_z"), 1e-6) << rows;
  }
  EXPECT_EQ(rows, expected.rows.size());
  EXPECT_GT(rows, 300U);

  const Outcome refused = in_a_clean_environment({path("build/embed").string(), "no.h5", "no.bvh"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("no.h5"));
}

TEST_F(Embedding, WhatIsMissingForLinkingIsNamedWithItsPackage) {
  const Outcome configured = configure({"-DCMAKE_DISABLE_FIND_PACKAGE_pugixml=ON"});
  EXPECT_NE(configured.status, 0);
  EXPECT_THAT(configured.err, HasSubstr("pugixml (in Debian: libpugixml-dev)"));
}

TEST_F(Embedding, AnotherVersionThanAskedForIsRefused) {
  write("CMakeLists.txt",
        "cmake_minimum_required(VERSION 3.22)\nproject(other LANGUAGES CXX)\nfind_package(abrazo 9.0 "
        "REQUIRED)\n");
  const Outcome configured = in_a_clean_environment(
      {ABRAZO_CMAKE, "-S", ".", "-B", "build", "-DCMAKE_PREFIX_PATH=" ABRAZO_INSTALLED});
  EXPECT_NE(configured.status, 0);
  EXPECT_THAT(configured.err, HasSubstr("9.0"));
}

TEST_F(Embedding, TheConfigurationNamesNoPlaceOfTheMachineThatBuiltIt) {
  const std::string folder = std::string(ABRAZO_LIBRARIES) + "/cmake/abrazo";
  ASSERT_FALSE(installed_files(folder).empty());
  for (const auto& file : installed_files(folder))
    EXPECT_THAT(content_of(file), Not(HasSubstr("\"/usr/"))) << file;
}

}  // namespace
}  // namespace abrazo::test::embedding_test
