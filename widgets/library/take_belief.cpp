#include "widgets/library/take_belief.hpp"

#include <algorithm>

namespace abrazo::widgets {
namespace {

constexpr int strongest = 255;

std::uint8_t level_of(std::uint8_t belief) {
  return static_cast<std::uint8_t>((belief * TakeBelief::levels + strongest / 2) / strongest);
}

int part_of(int frame, int frames) {
  return std::clamp(static_cast<int>(static_cast<long long>(frame) * TakeBelief::parts / frames), 0,
                    TakeBelief::parts - 1);
}

}  // namespace

void TakeBelief::begin(std::span<const BeliefBlock> blocks, std::span<const LibraryTake> takes) {
  frames_.clear();
  for (const LibraryTake& take : takes) frames_.push_back(std::max(1, take.frames));
  lights_.resize(takes.size());
  places_.clear();
  for (const BeliefBlock& block : blocks) {
    Place place;  // unknown take: no parts
    if (block.take < takes.size() && block.end_frame > block.begin_frame) {
      place.take = static_cast<int>(block.take);
      const int frames = frames_[block.take];
      place.begin = part_of(block.begin_frame, frames);
      const auto end_parts = static_cast<long long>(block.end_frame) * parts;
      place.end = static_cast<int>(std::min<long long>(parts, (end_parts + frames - 1) / frames));
    }
    places_.push_back(place);
  }
}

const std::vector<int>& TakeBelief::show(std::span<const std::uint8_t> belief) {
  next_.assign(lights_.size(), Light{});
  is_any_ = false;
  if (belief.size() == places_.size())
    for (std::size_t block = 0; block < belief.size(); ++block) {
      const std::uint8_t level = level_of(belief[block]);
      const Place& place = places_[block];
      if (level == 0 || place.begin == place.end) continue;
      is_any_ = true;
      for (int part = place.begin; part < place.end; ++part) {
        std::uint8_t& light = next_[static_cast<std::size_t>(place.take)][static_cast<std::size_t>(part)];
        light = std::max(light, level);
      }
    }
  changed_.clear();
  for (std::size_t take = 0; take < lights_.size(); ++take)
    if (next_[take] != lights_[take]) changed_.push_back(static_cast<int>(take));
  lights_.swap(next_);
  return changed_;
}

std::span<const std::uint8_t, TakeBelief::parts> TakeBelief::along(int take) const {
  return lights_[static_cast<std::size_t>(take)];
}

double TakeBelief::at(int take, int frame) const {
  const auto part = static_cast<std::size_t>(part_of(frame, frames_[static_cast<std::size_t>(take)]));
  return along(take)[part] / double{levels};
}

TakeBelief::Peak TakeBelief::peak(int take) const {
  const auto light = along(take);
  const auto first = std::max_element(light.begin(), light.end());
  const auto end = std::find_if(first, light.end(), [&](std::uint8_t level) { return level != *first; });
  const auto middle_twice = (first - light.begin()) + (end - light.begin());
  return {*first / double{levels},
          static_cast<int>(middle_twice * frames_[static_cast<std::size_t>(take)] / (2 * parts))};
}

}  // namespace abrazo::widgets
