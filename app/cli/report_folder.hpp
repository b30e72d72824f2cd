#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.hpp"

namespace abrazo::app {

/// The folder a report goes into. A folder that was made for a report that did not come about is taken away.
class ReportFolder {
 public:
  explicit ReportFolder(const std::string& path) : path_(path) {}
  ~ReportFolder();
  ReportFolder(const ReportFolder&) = delete;
  ReportFolder& operator=(const ReportFolder&) = delete;

  /// Makes it, with the folders above, when it is not there. An Error when that fails or nothing can be
  /// written into it: asked before the work rather than after it.
  Status make();

 private:
  std::filesystem::path path_;
  bool is_new_ = false;
};

}  // namespace abrazo::app
