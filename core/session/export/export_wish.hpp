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

/// What is to be written of a session, and how. The ending of the output's name chooses the file type.
struct ExportWish {
  ExportContent content = ExportContent::Motion;
  std::vector<SessionBody> bodies;                      ///< of a motion, in this order, each once
  std::optional<std::string> performer = std::nullopt;  ///< motion: the poses received of this one instead
  SessionPart part = {};
  std::optional<double> at_s = std::nullopt;             ///< mesh: of the frame shown then
  std::optional<std::uint64_t> at_frame = std::nullopt;  ///< mesh: of the frame of this index
  double rate_hz = 0;                                    ///< 0 = as recorded; of a mesh series: at most
  ClipFileSpace space = {};                              ///< of a motion
  std::string output = {};

  bool one_mesh() const { return content == ExportContent::Mesh && (at_s || at_frame); }
};

/// The file types of a content, as endings of names.
std::vector<std::string> export_types(ExportContent content);

/// Whether the wishes fit together: no mesh as motion file, no body twice. The Error says what to change.
Status check_export(const ExportWish& wish);

/// What was written: a sentence for people, figures for programs.
struct ExportReport {
  std::vector<std::string> files;
  std::string text;               ///< "1234 frames at 120 Hz"
  std::vector<Warning> warnings;  ///< what was left out or bridged
  JsonText figures;               ///< members of an object that is still open
};

/// What an export comes to, before it is made.
struct ExportEstimate {
  std::uint64_t frames = 0;
  std::uint64_t bytes = 0;  ///< within a quarter for motions, a half for meshes and traces
};
/// @param length_s  of the part  @param rate_hz  of its frames, where the wish has none
ExportEstimate estimate_export(const ExportWish& wish, double length_s, double rate_hz);

}  // namespace abrazo
