// What SessionWriter writes of frames, poses and markers, row by row.
#include <cmath>
#include <filesystem>
#include <utility>

#include "core/base/json_text.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/session/file/decisions_json.hpp"
#include "core/session/file/frame_row.hpp"
#include "core/session/file/session_writer_statements.hpp"

namespace abrazo {

namespace fs = std::filesystem;

namespace {

std::string json_list(const std::vector<std::string>& names) {
  JsonText json;
  json.begin_array();
  for (const std::string& name : names) json.value(name);
  return json.end_array().take();
}

/// The path from the session file's folder; empty when there is none (another drive).
std::string path_from(const std::string& session, const std::string& library) {
  std::error_code failure;
  const fs::path folder = fs::absolute(session, failure).parent_path();
  const fs::path relative = fs::relative(fs::absolute(library, failure), folder, failure);
  return failure ? std::string() : relative.generic_string();
}

}  // namespace

Status SessionWriter::write(const FrameSnapshot& frame) {
  const auto index = static_cast<std::int64_t>(frame.index + origin_.offset_frames);
  FrameRow row = row_of(frame, static_cast<std::uint64_t>(index), origin_.offset_s);
  if (const Status noted = note_input(frame, index); !noted) return noted;
  if (const Status noted = note_library(frame, index); !noted) return noted;
  if (const Status noted = note_pairs(frame); !noted) return noted;
  if (const Status noted = note_settings(frame, index, row.time_s); !noted) return noted;
  if (const Status noted = note_take(index, row.time_s); !noted) return noted;
  row.input = memory_.input_id;
  row.library = memory_.library_id;
  bind_row(statements_->frame, row);
  if (Status written = keep_fault(statements_->frame); !written) return written;
  if (!memory_.has_first_frame) {
    auto run = database_.prepare("UPDATE runs SET first_frame = ? WHERE id = ?");
    if (!run) return keep_fault(run.error());
    if (Status noted = keep_fault(run->bind(0, index).bind(1, run_)); !noted) return noted;
    memory_.has_first_frame = true;
  }
  memory_.last_frame = index;
  memory_.last_s = row.time_s;
  return Done{};
}

Status SessionWriter::note_input(const FrameSnapshot& frame, std::int64_t index) {
  const std::string& name = frame.input ? *frame.input : facts_.input;
  if (name != memory_.input) memory_.input_id.reset();
  memory_.input = name;
  if (memory_.input_id || name.empty()) return Done{};
  auto input = database_.prepare("INSERT INTO inputs (input, first_frame) VALUES (?, ?)");
  if (!input) return keep_fault(input.error());
  if (Status written = keep_fault(input->bind(0, name).bind(1, index)); !written) return written;
  memory_.input_id = database_.last_row_id();
  return Done{};
}

Status SessionWriter::note_library(const FrameSnapshot& frame, std::int64_t index) {
  const Library library = frame.library ? frame.library : facts_.library;
  if (memory_.library_id && (!library || library == memory_.library)) return Done{};
  const bool is_first = !library || !memory_.library_id;
  const auto named = library_paths_.find(library);
  const std::string path = library && named != library_paths_.end() ? named->second
                           : is_first                               ? facts_.library_path
                                                                    : std::string();
  auto row = database_.prepare(
      "INSERT INTO libraries (relative_path, absolute_path, name, pairs, excluded_takes, first_frame) "
      "VALUES (?, ?, ?, ?, ?, ?)");
  if (!row) return keep_fault(row.error());
  std::error_code failure;
  if (path.empty())
    row->bind_null(0).bind_null(1);
  else
    row->bind(0, path_from(database_.path(), path))
        .bind(1, fs::absolute(path, failure).lexically_normal().string());
  row->bind(2, library ? library->name() : facts_.library_name);
  row->bind(3, library ? static_cast<std::uint64_t>(library->pair_count()) : facts_.library_pairs);
  row->bind(4, json_list(facts_.excluded_takes)).bind(5, index);
  if (Status written = keep_fault(*row); !written) return written;
  memory_.library_id = database_.last_row_id();
  memory_.library = library;
  memory_.pairs.assign(library ? static_cast<std::size_t>(library->pair_count()) : 0, false);
  return Done{};
}

/// Every pair that was a candidate has a row with its recorded frame.
Status SessionWriter::note_pairs(const FrameSnapshot& frame) {
  for (const Candidate& candidate : frame.result.candidates) {
    const auto pair = static_cast<std::size_t>(candidate.pair);
    if (candidate.pair < 0 || pair >= memory_.pairs.size() || memory_.pairs[pair]) continue;
    const MotionLibrary& library = *memory_.library;
    const PairSource& source = library.source(candidate.pair);
    SessionStatement& row = statements_->pair;
    row.bind(0, *memory_.library_id).bind(1, candidate.pair);
    row.bind(2, library.take_of(candidate.pair).name).bind(3, static_cast<std::int64_t>(source.frame));
    row.bind(4, source.swapped);
    if (const std::string_view label = library.label(candidate.pair); label.empty())
      row.bind_null(5);
    else
      row.bind(5, label);
    if (Status written = keep_fault(row); !written) return written;
    memory_.pairs[pair] = true;
  }
  return Done{};
}

Status SessionWriter::note_settings(const FrameSnapshot& frame, std::int64_t index, double time_s) {
  if (memory_.settings != frame.settings) {
    SessionStatement& row = statements_->settings;
    row.bind(0, index).bind(1, time_s).bind(2, settings_json(frame.settings));
    if (Status written = keep_fault(row); !written) return written;
    memory_.settings = frame.settings;
  }
  if (memory_.is_learning != frame.is_learning) {
    SessionStatement& row = statements_->learning;
    row.bind(0, index).bind(1, static_cast<std::int64_t>(frame.is_learning));
    if (Status written = keep_fault(row); !written) return written;
    memory_.is_learning = frame.is_learning;
  }
  if (memory_.decisions && memory_.decided == frame.decisions) return Done{};
  const Decisions decisions = frame.decisions ? *frame.decisions : Decisions{};
  if (memory_.decisions != decisions) {
    SessionStatement& row = statements_->decisions;
    row.bind(0, index).bind(1, time_s).bind(2, decisions_json(decisions));
    if (Status written = keep_fault(row); !written) return written;
    memory_.decisions = decisions;
  }
  memory_.decided = frame.decisions;
  return Done{};
}

Status SessionWriter::note_take(std::int64_t index, double time_s) {
  if (!memory_.wanted_take) return Done{};
  auto take =
      database_.prepare("INSERT INTO takes (name, begun_at, start_s, first_frame) VALUES (?, ?, ?, ?)");
  if (!take) return keep_fault(take.error());
  take->bind(0, *memory_.wanted_take).bind(1, memory_.wanted_take_begun_at).bind(2, time_s).bind(3, index);
  if (Status written = keep_fault(*take); !written) return written;
  memory_.take_id = database_.last_row_id();
  memory_.wanted_take.reset();
  return Done{};
}

Result<std::int64_t> SessionWriter::performer_id(const std::string& name) {
  if (const auto known = memory_.performers.find(name); known != memory_.performers.end())
    return known->second;
  auto found = database_.prepare("SELECT id FROM performers WHERE name = ?");
  if (!found) return keep_fault(found.error()).error();
  const auto row = found->bind(0, name).step();
  if (!row) {
    fault_ = found->fault();
    return row.error();
  }
  std::int64_t id = *row ? found->integer(0) : 0;
  found->reset();
  if (!*row) {
    auto added = database_.prepare("INSERT INTO performers (name) VALUES (?)");
    if (!added) return keep_fault(added.error()).error();
    if (const Status written = keep_fault(added->bind(0, name)); !written) return written.error();
    id = database_.last_row_id();
  }
  return memory_.performers[name] = id;
}

Status SessionWriter::write(const ReceivedPose& received) {
  const auto performer = performer_id(received.performer);
  if (!performer) return performer.error();
  SessionStatement& row = statements_->pose;
  const auto shifted = [&](int at, double session_s) {
    if (session_s < 0)
      row.bind_null(at);
    else
      row.bind(at, session_s + origin_.offset_s);
  };
  const auto bytes = pose_bytes(received.pose.pose);
  Checksum sum;
  sum.add(std::span<const std::uint8_t>(bytes));
  row.bind(0, *performer);
  shifted(1, received.pose.arrived_s);
  shifted(2, received.pose.assembled_s);
  row.bind(3, received.pose.time_s);
  if (received.sender_time_s)
    row.bind(4, *received.sender_time_s);
  else
    row.bind_null(4);
  row.bind(5, received.pose.frame).bind(6, received.pose.discontinuous);
  row.bind(7, std::span<const std::uint8_t>(bytes)).bind(8, sum.value());
  return keep_fault(row);
}

/// A session that has the times of its file has the markers of all its runs, too.
Status SessionWriter::write(const Markers& markers) {
  auto cleared =
      database_.prepare(facts_.has_times_of_file ? "DELETE FROM markers WHERE run <= ?1 OR run IS NULL"
                                                 : "DELETE FROM markers WHERE run = ?1");
  if (!cleared) return keep_fault(cleared.error());
  if (Status done = keep_fault(cleared->bind(0, run_)); !done) return done;
  auto row = database_.prepare("INSERT INTO markers (id, run, time_s, name) VALUES (?, ?, ?, ?)");
  if (!row) return keep_fault(row.error());
  for (const Marker& marker : markers.all()) {
    // In a separate session of the file the numbers may be in use.
    facts_.has_times_of_file ? row->bind(0, marker.id) : row->bind_null(0);
    row->bind(1, run_).bind(2, marker.time_s + origin_.offset_s).bind(3, marker.name);
    if (Status written = keep_fault(*row); !written) return written;
  }
  return Done{};
}

}  // namespace abrazo
