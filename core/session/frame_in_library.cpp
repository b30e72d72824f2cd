#include "core/session/frame_in_library.hpp"

namespace abrazo {

int same_pair(const MotionLibrary& from, int pair, const MotionLibrary& to) {
  if (pair < 0 || pair >= from.pair_count()) return -1;
  const PairSource& source = from.source(pair);
  const std::string& take = from.take_of(pair).name;
  const int frame = static_cast<int>(source.frame);
  const int same = to.find_pair(take, frame, source.swapped);
  return same >= 0 ? same : to.find_pair(take, frame, !source.swapped);
}

int selected_pair(const FrameSnapshot& frame, const std::shared_ptr<const MotionLibrary>& library) {
  const FrameResult& result = frame.result;
  if (result.selected < 0) return -1;
  const int pair = result.candidates[static_cast<std::size_t>(result.selected)].pair;
  if (!library || !frame.library || frame.library == library) return pair;
  return same_pair(*frame.library, pair, *library);
}

FrameSnapshotPtr in_library(const FrameSnapshotPtr& frame,
                            const std::shared_ptr<const MotionLibrary>& library) {
  if (!frame || !library || !frame->library || frame->library == library) return frame;
  auto translated = std::make_shared<FrameSnapshot>(*frame);
  FrameResult& result = translated->result;
  result.candidates.clear();
  result.selected = -1;
  for (std::size_t i = 0; i < frame->result.candidates.size(); ++i) {
    Candidate candidate = frame->result.candidates[i];
    candidate.pair = same_pair(*frame->library, candidate.pair, *library);
    if (candidate.pair < 0) continue;
    if (static_cast<int>(i) == frame->result.selected)
      result.selected = static_cast<int>(result.candidates.size());
    result.candidates.push_back(candidate);
  }
  translated->library = library;
  return translated;
}

}  // namespace abrazo
