#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.hpp"

namespace abrazo::app {

/// The output folder of a report. A newly created folder is removed if the report fails.
class ReportFolder {
 public:
  explicit ReportFolder(const std::string& path) : path_(path) {}
  ~ReportFolder();
  ReportFolder(const ReportFolder&) = delete;
  ReportFolder& operator=(const ReportFolder&) = delete;

  /// Creates the folder and its parents if missing. An Error if that fails or the folder is not writable;
  /// called before the work.
  Status make();

 private:
  std::filesystem::path path_;
  bool is_new_ = false;
};

}  // namespace abrazo::app
