#pragma once

#include <fstream>
#include <memory>
#include <string>

#include "core/base/atomic_file.hpp"
#include "core/base/result.hpp"

namespace abrazo {

/// Lines written in sequence to a file that appears complete at the end.
class LineFile {
 public:
  static Result<std::unique_ptr<LineFile>> open(const std::string& path);
  void add(const std::string& line) { out_ << line << '\n'; }
  /// False once something could not be written.
  bool good() const { return static_cast<bool>(out_); }
  /// All lines are on the disk, but the file has no name yet; nothing can be added any more.
  Status close();
  /// Closes it and gives it its name.
  Status finish();

 private:
  explicit LineFile(const std::string& path);
  std::string path_;
  AtomicFile file_;
  std::ofstream out_;
};

}  // namespace abrazo
