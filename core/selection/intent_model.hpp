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

/// A stretch of a take with one value of belief.
struct BeliefBlock {
  std::uint32_t take = 0;  ///< of the library
  bool swapped = false;
  int begin_frame = 0, end_frame = 0;  ///< of the take's own file, [begin, end)
  bool operator==(const BeliefBlock&) const = default;
};

/// A model learned once from a library: which partner pose, and which move, follow from the user's last two
/// seconds. Kernel ridge regression from the leader's motion (HistoryKernel) to the partner's pose a moment
/// later (PartnerEmbedding), where the squared distance to the expectation is the expected mean joint
/// distance, so one distance rates every recorded partner. docs/guide/intent.md explains it; decision 29
/// lists the alternatives. Immutable; shared between threads.
class IntentModel {
 public:
  /// Peak memory of learning, for the largest library.
  static constexpr std::uint64_t most_learning_bytes = std::uint64_t{256} << 20;

  /// About a second for tens of thousands of pairs, on every core.
  /// @param pairs selectable pairs, ascending; learns from these only
  /// @return null if `progress` cancelled
  static std::shared_ptr<const IntentModel> learn(std::shared_ptr<const MotionLibrary> library,
                                                  std::span<const int> pairs, const Progress& progress = {});
  ~IntentModel();
  IntentModel(const IntentModel&) = delete;
  IntentModel& operator=(const IntentModel&) = delete;

  const std::shared_ptr<const MotionLibrary>& library() const;
  /// Labels of the learned pairs; "" = pairs without a label.
  const std::vector<std::string>& labels() const;
  /// About half a second each, in the order of the library's pairs.
  const std::vector<BeliefBlock>& blocks() const;
  /// Pairs to which the selection may change: about 15 per second of each take.
  const std::vector<int>& landings() const;
  /// By index into landings().
  int block_of_landing(std::size_t landing) const;
  int label_of_landing(std::size_t landing) const;
  /// Root of the landing's partner on the floor, relative to the leader's root and heading.
  const RootFrame& place_of_landing(std::size_t landing) const;
  int example_count() const;

  /// Evaluation of the user's motion. Kept by the caller, so that a frame does not allocate; created by
  /// `make_reading`.
  struct Reading {
    std::vector<float> motion;     ///< description of the user's motion
    std::vector<float> kernel;     ///< kernel with every example
    std::vector<float> expected;   ///< output of the regression: point of the expected partner, its square,
                                   ///< labels
    float expected_square = 0;     ///< squared norm of the expected point
    float spread_m = 0;            ///< expected distance of partners from the expected one
    std::vector<float> moves;      ///< P(label); they sum to 1
    std::vector<float> partner_m;  ///< per landing: expected mean joint distance

    /// Cache of a described pair: pairs that continue a source are evaluated again in the next frames.
    struct Described {
      int pair = -1;
      std::vector<float> point, motion;
    };
    std::array<Described, 16> described;
    std::size_t next_described = 0;
    std::vector<float> embedding_work, kernel_work;  ///< work space
  };
  Reading make_reading() const;
  /// @param history  not empty
  void read(const MotionHistory& history, Reading& reading) const;
  /// The kernel of the user's motion and the leader's motion before a landing.
  float leader_kernel(std::size_t landing, const Reading& reading) const;

  /// The same for any pair of the library, landing or not.
  struct PairReading {
    float partner_m = 0, leader_kernel = 0;
    int label = -1;  ///< into labels(); -1 if the label was not learned
  };
  PairReading read_pair(int pair, Reading& reading) const;

 private:
  const Reading::Described& described(int pair, Reading& reading) const;

  struct Learned;
  explicit IntentModel(std::unique_ptr<const Learned> learned);
  std::unique_ptr<const Learned> learned_;
};

}  // namespace abrazo
