#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/library/store/motion_library.hpp"
#include "core/selection/intent_model.hpp"

namespace abrazo::widgets {

/// The solver's belief about the next partner along the takes of a library, each cut into equal parts. Plain
/// data, independent of Qt.
class TakeBelief {
 public:
  static constexpr int parts = 96;   ///< two pixels each in the usual width of a strip
  static constexpr int levels = 20;  ///< resolution of 5 %, so that tiny changes do not redraw

  /// Assigns the blocks of a model to parts, once per model. Shown values stay until the next show().
  void begin(std::span<const BeliefBlock> blocks, std::span<const LibraryTake> takes);
  /// @param belief per block, 255 = strongest; ignored if its size is not the number of blocks. The stronger
  /// of overlapping blocks (either performer active) counts
  /// @return the takes that changed, ascending; valid until the next call
  const std::vector<int>& show(std::span<const std::uint8_t> belief);

  /// Whether any take has a belief.
  bool is_any() const { return is_any_; }
  /// Per part, 0 to `levels`.
  std::span<const std::uint8_t, parts> along(int take) const;
  /// Relative to the strongest in the library [0, 1].
  double at(int take, int frame) const;

  struct Peak {
    double belief = 0;  ///< relative to the strongest in the library [0, 1]
    int frame = 0;      ///< middle of the place
  };
  Peak peak(int take) const;

 private:
  using Light = std::array<std::uint8_t, parts>;
  struct Place {
    int take = 0;
    int begin = 0, end = 0;  ///< parts
  };
  std::vector<Place> places_;  ///< per block
  std::vector<int> frames_;    ///< per take
  std::vector<Light> lights_, next_;
  std::vector<int> changed_;
  bool is_any_ = false;
};

}  // namespace abrazo::widgets
