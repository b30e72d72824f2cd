#include "core/session/frames/frame_in_library.hpp"

#include <algorithm>

#include "core/synthesis/step/synthesizer_state.hpp"

namespace abrazo {

namespace {

int pair_of_frame(const MotionLibrary& library, const std::string& take, int frame, bool swapped) {
  const int same = library.find_pair(take, frame, swapped);
  return same >= 0 ? same : library.find_pair(take, frame, !swapped);
}

}  // namespace

int same_pair(const MotionLibrary& from, int pair, const MotionLibrary& to) {
  if (pair < 0 || pair >= from.pair_count()) return -1;
  const PairSource& source = from.source(pair);
  return pair_of_frame(to, from.take_of(pair).name, static_cast<int>(source.frame), source.swapped);
}

int same_pair(const NotedPairs& from, int pair, const MotionLibrary& to) {
  const auto noted = from.by_number.find(pair);
  if (noted == from.by_number.end()) return -1;
  return pair_of_frame(to, noted->second.take, noted->second.frame, noted->second.swapped);
}

PairNumbers::PairNumbers(const MotionLibrary& from, const MotionLibrary& to) : from_(from), to_(to) {
  for (const LibraryTake& take : from.takes()) takes_.push_back(to.find_take(take.name));
}

int PairNumbers::operator()(int pair) {
  if (pair < 0 || pair >= from_.pair_count()) return -1;
  const PairSource& source = from_.source(pair);
  const int take = takes_[source.take], near = pair + apart_;
  if (take < 0) return -1;
  if (near >= 0 && near < to_.pair_count()) {
    PairSource same = source;
    same.take = static_cast<std::uint32_t>(take);
    if (order_of(to_.source(near)) == order_of(same)) return near;
  }
  const int found = same_pair(from_, pair, to_);
  if (found >= 0) apart_ = found - pair;
  return found;
}

namespace {

/// Nothing is known of the library that a frame was solved with.
bool is_of_unknown_library(const FrameSnapshot& frame) {
  return !frame.library && !frame.noted_pairs;
}

/// The number in a library of a pair of the frame's own, of which something is known.
int number_in(const MotionLibrary& library, const FrameSnapshot& frame, int pair) {
  return frame.library ? same_pair(*frame.library, pair, library)
                       : same_pair(*frame.noted_pairs, pair, library);
}

}  // namespace

bool has_pairs_of(const MotionLibrary& library, const FrameSnapshot& frame) {
  const bool is_noted = !frame.library && frame.noted_pairs;
  const auto has = [&](int pair) {
    return pair >= 0 && pair < library.pair_count() && (!is_noted || number_in(library, frame, pair) == pair);
  };
  const auto has_or_none = [&](int pair) { return pair == -1 || has(pair); };
  const auto& candidates = frame.result.candidates;
  return std::all_of(candidates.begin(), candidates.end(),
                     [&](const Candidate& each) { return has(each.pair); }) &&
         (!frame.before || (has_or_none(frame.before->memory.current_pair) &&
                            has_or_none(frame.before->memory.motion.playhead.pair)));
}

int selected_pair(const FrameSnapshot& frame, const std::shared_ptr<const MotionLibrary>& library) {
  const FrameResult& result = frame.result;
  if (result.selected < 0) return -1;
  const int pair = result.candidates[static_cast<std::size_t>(result.selected)].pair;
  if (!library || frame.library == library) return pair;
  if (is_of_unknown_library(frame)) return pair < library->pair_count() ? pair : -1;
  return number_in(*library, frame, pair);
}

namespace {

/// Of whichever library the frame is, numbers beyond this one's are none of its pairs.
FrameSnapshotPtr without_pairs_beyond(const FrameSnapshotPtr& frame, int pair_count) {
  const auto is_beyond = [pair_count](const Candidate& each) { return each.pair >= pair_count; };
  const auto& candidates = frame->result.candidates;
  if (std::none_of(candidates.begin(), candidates.end(), is_beyond)) return frame;
  auto without = std::make_shared<FrameSnapshot>(*frame);
  for (Candidate& each : without->result.candidates)
    if (is_beyond(each)) each.pair = -1;
  return without;
}

/// Of a frame of which something is known.
AbsentLibrary library_of(const FrameSnapshot& frame) {
  if (frame.library) return {frame.library->name(), {}};
  return {frame.noted_pairs->library, frame.noted_pairs->file};
}

}  // namespace

FrameSnapshotPtr in_library(const FrameSnapshotPtr& frame,
                            const std::shared_ptr<const MotionLibrary>& library) {
  if (!frame || !library || frame->library == library) return frame;
  if (is_of_unknown_library(*frame)) return without_pairs_beyond(frame, library->pair_count());
  auto translated = std::make_shared<FrameSnapshot>(*frame);
  FrameResult& result = translated->result;
  result.candidates.clear();
  result.selected = -1;
  for (std::size_t i = 0; i < frame->result.candidates.size(); ++i) {
    Candidate candidate = frame->result.candidates[i];
    candidate.pair = number_in(*library, *frame, candidate.pair);
    if (candidate.pair < 0) continue;
    if (static_cast<int>(i) == frame->result.selected)
      result.selected = static_cast<int>(result.candidates.size());
    result.candidates.push_back(candidate);
  }
  if (result.selected < 0 && frame->result.selected >= 0)
    translated->absent = std::make_shared<const AbsentLibrary>(library_of(*frame));
  translated->library = library;
  translated->noted_pairs.reset();
  return translated;
}

std::string absence_text(const FrameSnapshot& frame) {
  if (!frame.absent) return {};
  const std::string& name = frame.absent->name;
  if (name.empty()) return "Danced with a library that is not open";
  if (frame.library && frame.library->name() == name)
    return "Danced with a pair that library “" + name + "” does not have now";
  return "Danced with library “" + name + "”, which is not open";
}

}  // namespace abrazo
