#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/command_line.hpp"
#include "core/base/json_text.hpp"
#include "core/session/session_export.hpp"

namespace abrazo::app {

/// What `abrazo export` was asked for.
struct ExportWish {
  std::string session, output, library, performer;
  std::vector<std::string> what;
  SessionPart part;
  std::optional<double> time_s;
  std::optional<long long> frame;
  double rate_hz = 0;  ///< 0 = as recorded
  bool json = false;
};

/// What was written: a sentence for people, figures for programs.
struct Exported {
  std::vector<std::string> files;
  std::string text;  ///< "1234 frames at 120 Hz"
  JsonText figures;  ///< members of an object that is still open
};

inline void write_range(JsonText& json, const SessionRange& range) {
  json.key("from_s").value(range.from_s).key("to_s").value(range.to_s);
}

// One for each kind of content. The output file has a fitting extension and can be written.
Result<Exported> export_motion(CommandLine& line, const SessionFile& file, const ExportWish& wish);
Result<Exported> export_mesh(CommandLine& line, const SessionFile& file, const ExportWish& wish);
Result<Exported> export_labels(CommandLine& line, const SessionFile& file, const ExportWish& wish);
Result<Exported> export_trace(CommandLine& line, const SessionFile& file, const ExportWish& wish);

}  // namespace abrazo::app
