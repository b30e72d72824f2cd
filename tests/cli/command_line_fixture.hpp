#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/cli/run_command.hpp"

namespace abrazo::test {

/// A test in an empty folder that is gone afterwards. File names in the words are relative to it.
class CommandLineTest : public ::testing::Test {
 protected:
  CommandLineTest();
  ~CommandLineTest() override;

  Outcome run(const std::vector<std::string>& words) const { return run_abrazo(folder_, words); }
  /// The same for words without blanks: run("motion info a.bvh").
  Outcome run(const std::string& line) const;

  const std::filesystem::path& folder() const { return folder_; }
  std::filesystem::path path(const std::string& name) const { return folder_ / name; }
  void write(const std::string& name, const std::string& content) const;
  std::string read(const std::string& name) const;
  /// Names in the folder, sorted.
  std::vector<std::string> names() const;

  /// Writes "demo/" (one take of 11 s; "0.5" gives two) and "demo.h5".
  void make_demo(const std::string& minutes = "0.2") const;
  void make_library() const;

  /// "abrazo: ... <part> ..." on one line of stderr (beside warnings), nothing on stdout, exit status 1.
  static void expect_failure(const Outcome& outcome, const std::string& part);
  /// The same with exit status 2, and the help to read is named.
  static void expect_wrong_usage(const Outcome& outcome, const std::string& part);

  /// A name as a stranger's file may have it: one that clears the terminal, colours it, and tells of "FORGED"
  /// on a line of its own.
  static const std::string hostile_name;
  /// That name is shown, and does none of this.
  static void expect_harmless(const std::string& text);

 private:
  std::filesystem::path folder_;
};

/// A CSV of numbers with a header line.
struct Table {
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;
  double at(std::size_t row, const std::string& column) const;
};
Table parse_table(const std::string& csv);

/// Each line of a trace as an object.
std::vector<nlohmann::json> parse_lines(const std::string& json_lines);

}  // namespace abrazo::test
