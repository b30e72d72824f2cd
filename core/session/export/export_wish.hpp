#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/json_text.hpp"
#include "core/base/result.hpp"
#include "core/motion/files/clip_file.hpp"
#include "core/session/export/session_export.hpp"

namespace abrazo {

enum class ExportContent : std::uint8_t { Motion, Mesh, Labels, Trace };

/// What to write of a session, and how. The extension of the output's name selects the file type.
struct ExportWish {
  ExportContent content = ExportContent::Motion;
  std::vector<SessionBody> bodies;                      ///< motion: in this order, each once
  std::optional<std::string> performer = std::nullopt;  ///< motion: the received poses of this performer
                                                        ///< instead
  SessionPart part = {};
  std::optional<double> at_s = std::nullopt;             ///< mesh: of the frame shown at this time
  std::optional<std::uint64_t> at_frame = std::nullopt;  ///< mesh: of the frame with this index
  double rate_hz = 0;                                    ///< 0 = as recorded; for a mesh series an upper
                                                         ///< limit
  ClipFileSpace space = {};                              ///< motion only
  bool all_tiers = false;  ///< labels as .csv: every tier, in seconds; else the moves, in frames of each take
  std::string output = {};
  std::string character = {};  ///< motion: a GLB or VRM that performs it, in OUT_BODY for each body; empty =
                               ///< none

  bool one_mesh() const { return content == ExportContent::Mesh && (at_s || at_frame); }
  /// Whether it is a label file of the moves: see session_labels_csv.
  bool is_label_file() const {
    return content == ExportContent::Labels && output.ends_with(".csv") && !all_tiers;
  }
  /// The files that are written: the output, or with a character OUT_BODY for each body. Not those that
  /// belong to a series.
  std::vector<std::string> files() const;
};

/// File types of a content, as file extensions.
std::vector<std::string> export_types(ExportContent content);

/// Checks that the options fit together: no mesh as motion file, no body twice. The Error says what to
/// change.
Status check_export(const ExportWish& wish);

/// What was written: a sentence for people, numbers for programs.
struct ExportReport {
  std::vector<std::string> files;
  std::string text;               ///< "1234 frames at 120 Hz"
  std::vector<Warning> warnings;  ///< what was left out or bridged
  JsonText figures;               ///< members of an object that is still open
};

}  // namespace abrazo
