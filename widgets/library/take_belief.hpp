#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/library/store/motion_library.hpp"
#include "core/selection/intent_model.hpp"

namespace abrazo::widgets {

/// Where along the takes of a library the solver expects the next partner, each take cut into equal parts.
/// Plain data, no toolkit.
class TakeBelief {
 public:
  static constexpr int parts = 96;   ///< two pixels each in the usual width of a strip
  static constexpr int levels = 20;  ///< what is distinguished: 5 %, so that a breath of change draws nothing

  /// Which parts the blocks of a model are; once per model. What is shown stays until the next show().
  void begin(std::span<const BeliefBlock> blocks, std::span<const LibraryTake> takes);
  /// @param belief  per block, 255 where it is strongest; of another number than the blocks says nothing.
  /// Where blocks overlap (either performer active) the stronger one counts
  /// @return the takes that look different now, ascending; valid until the next call
  const std::vector<int>& show(std::span<const std::uint8_t> belief);

  /// Something is shown, in whichever take.
  bool is_any() const { return is_any_; }
  /// Per part, 0 to `levels`.
  std::span<const std::uint8_t, parts> along(int take) const;
  /// Of the strongest in the library [0, 1].
  double at(int take, int frame) const;

  struct Peak {
    double belief = 0;  ///< of the strongest in the library [0, 1]
    int frame = 0;      ///< in the middle of where it is
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
