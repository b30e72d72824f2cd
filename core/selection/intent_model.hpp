#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/selection/motion_history.hpp"

namespace abrazo {

/// A stretch of a take that shares one value of belief.
struct BeliefBlock {
  std::uint32_t take = 0;  ///< of the library
  bool swapped = false;
  int begin_frame = 0, end_frame = 0;  ///< of the take's own file, [begin, end)
  bool operator==(const BeliefBlock&) const = default;
};

/// What a library says of partners, learned once: which partner, and which move, follow from what the user
/// did in the last two seconds. Kernel ridge regression from the leader's motion (HistoryKernel) to the
/// partner's pose a moment later (PartnerEmbedding), where the squared distance to the expectation is the
/// expected mean joint distance; so every recorded partner is judged by one distance. docs/guide/intent.md
/// tells it at length, decision 29 what else was tried. Immutable; shared between threads.
class IntentModel {
 public:
  /// What learning takes while it is at it, for the largest library.
  static constexpr std::uint64_t most_learning_bytes = std::uint64_t{256} << 20;

  /// About a second for tens of thousands of pairs, on every core.
  /// @param pairs  those that may be selected, ascending; nothing is learned from others
  /// @return null when progress asked to stop
  static std::shared_ptr<const IntentModel> learn(std::shared_ptr<const MotionLibrary> library,
                                                  std::span<const int> pairs, const Progress& progress = {});
  ~IntentModel();
  IntentModel(const IntentModel&) = delete;
  IntentModel& operator=(const IntentModel&) = delete;

  const std::shared_ptr<const MotionLibrary>& library() const;
  /// Of the pairs that were learned from; "" stands for pairs without one.
  const std::vector<std::string>& labels() const;
  /// About half a second each, in the order of the library's pairs.
  const std::vector<BeliefBlock>& blocks() const;
  /// Pairs that may be changed to: some 15 a second of each take.
  const std::vector<int>& landings() const;
  /// By place in landings().
  int block_of_landing(std::size_t landing) const;
  int label_of_landing(std::size_t landing) const;
  int example_count() const;

  /// What the user's motion says. Kept by the caller, so that a frame does not allocate; made by
  /// `make_reading`.
  struct Reading {
    std::vector<float> motion;     ///< the user's, as the kernel describes it
    std::vector<float> kernel;     ///< with every example
    std::vector<float> expected;   ///< the regression: the expected partner's point, its square, labels
    float expected_square = 0;     ///< of the expected point
    float spread_m = 0;            ///< what partners are expected to be off the expected one
    std::vector<float> moves;      ///< P(label); they sum to 1
    std::vector<float> partner_m;  ///< per landing: expected mean joint distance

    /// A pair as it was described: those that a source is gone on with are asked for again in the next
    /// frames.
    struct Described {
      int pair = -1;
      std::vector<float> point, motion;
    };
    std::array<Described, 16> described;
    std::size_t next_described = 0;
    std::vector<float> embedding_work, kernel_work;  ///< room
  };
  Reading make_reading() const;
  /// @param history  not empty
  void read(const MotionHistory& history, Reading& reading) const;
  /// The kernel of the user's motion with the one that led to a landing.
  float leader_kernel(std::size_t landing, const Reading& reading) const;

  /// The same of any pair of the library, a landing or not.
  struct PairReading {
    float partner_m = 0, leader_kernel = 0;
    int label = -1;  ///< into labels(); -1 when nothing of that label was learned from
  };
  PairReading read_pair(int pair, Reading& reading) const;

 private:
  const Reading::Described& described(int pair, Reading& reading) const;

  struct Learned;
  explicit IntentModel(std::unique_ptr<const Learned> learned);
  std::unique_ptr<const Learned> learned_;
};

}  // namespace abrazo
