#include "core/selection/intent_model.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "core/base/parallel.hpp"
#include "core/selection/history_kernel.hpp"
#include "core/selection/partner_embedding.hpp"
#include "core/selection/positive_solve.hpp"
#include "core/selection/recorded_motion.hpp"

namespace abrazo {

namespace {

constexpr double examples_per_second = 7.5;
constexpr double landings_per_second = 15;
constexpr double blocks_per_second = 2;
// What a frame may take bounds them: docs/benchmarks.md.
constexpr std::size_t most_examples = 4096;
constexpr std::size_t most_landings = 16384;
constexpr double ridge = 0.02;
constexpr double lead_s = 1.0 / 30;  ///< the partner that is wanted is the one of the next moment
constexpr std::string_view learning = "learning partners";

using Rows = HistoryKernel::Rows;

/// Every n-th of many, evenly.
std::vector<int> at_most(const std::vector<int>& pairs, std::size_t most) {
  if (pairs.size() <= most) return pairs;
  std::vector<int> kept;
  for (std::size_t i = 0; i < most; ++i) kept.push_back(pairs[i * pairs.size() / most]);
  return kept;
}

/// Every n-th pair of a take, about `per_second`, at most `most` in total. Includes the first of every
/// stretch, and optionally of every move.
std::vector<int> thinned(const MotionLibrary& library, std::span<const int> pairs, double per_second,
                         std::size_t most, bool every_move) {
  for (double rate = per_second;; rate *= 0.8) {
    std::vector<int> kept;
    std::string_view label;
    double due = 0;
    int last = -2;
    for (const int pair : pairs) {
      const double step = std::max(1.0, library.take_of(pair).pairs_per_second() / rate);
      const std::string_view label_before = std::exchange(label, library.label(pair));
      due = last >= 0 && library.later_pair(last, 1) == pair ? due - 1 : 0;
      last = pair;
      if (due >= 0.5 && !(every_move && label != label_before)) continue;
      due = (due >= 0.5 ? 0 : due) + step;
      kept.push_back(pair);
    }
    if (kept.size() <= most || rate < 0.1) return at_most(kept, most);
  }
}

std::vector<std::string> labels_of(const MotionLibrary& library, std::span<const int> pairs) {
  std::vector<std::string> labels;
  std::string_view last;
  for (const int pair : pairs) {
    const std::string_view label = library.label(pair);
    if (!labels.empty() && label == last) continue;
    last = label;
    if (std::find(labels.begin(), labels.end(), label) == labels.end()) labels.emplace_back(label);
  }
  std::sort(labels.begin(), labels.end());
  return labels;
}

int index_of(const std::vector<std::string>& labels, std::string_view label) {
  const auto found = std::lower_bound(labels.begin(), labels.end(), label);
  return found != labels.end() && *found == label ? static_cast<int>(found - labels.begin()) : -1;
}

}  // namespace

struct IntentModel::Learned {
  Learned(std::shared_ptr<const MotionLibrary> of, HistoryKernel with, PartnerEmbedding in)
      : library(std::move(of)), motion_before(*library), kernel(std::move(with)), partners(std::move(in)) {}

  std::shared_ptr<const MotionLibrary> library;
  RecordedMotion motion_before;
  HistoryKernel kernel;
  PartnerEmbedding partners;
  std::vector<std::string> labels;
  std::vector<BeliefBlock> blocks;

  HistoryKernel::Compared examples;  ///< motions
  Rows weights;                      ///< of the regression: example x (point, its square, labels)
  Eigen::VectorXf usual;             ///< the expectation for a motion unlike all learned ones

  std::vector<int> landings;
  Rows landing_motions, landing_points;
  Eigen::VectorXf landing_squares;
  std::vector<int> landing_blocks, landing_labels;
  /// Beside one another, because reading them from the library's poses fetches as many places of memory.
  std::vector<RootFrame> landing_places;

  Eigen::Index outputs() const { return partners.size() + 1 + static_cast<Eigen::Index>(labels.size()); }
  void place_in_blocks();
  bool regress(const std::vector<int>& of, const Rows& motions, const Progress& progress);
  bool describe_landings(const Progress& progress);
};

/// Blocks follow one another without a hole as long as the recording has none.
void IntentModel::Learned::place_in_blocks() {
  int before = -1;  // the landing before
  const auto end_stretch = [&] {
    int last = before;
    while (library->later_pair(last, 1) >= 0) ++last;
    const LibraryTake& take = library->take_of(last);
    blocks.back().end_frame =
        std::min(static_cast<int>(library->source(last).frame) + take.frame_stride, take.frames);
  };
  for (const int pair : landings) {
    const PairSource& source = library->source(pair);
    const auto frame = static_cast<int>(source.frame);
    const bool continues = before >= 0 && library->later_pair(before, pair - before) == pair;
    if (!continues && before >= 0) end_stretch();
    if (!continues || frame >= blocks.back().end_frame) {
      const int begin = continues ? blocks.back().end_frame : frame;
      const LibraryTake& take = library->take_of(pair);
      const int length = std::max(
          1, static_cast<int>(std::min<double>(std::round(take.fps / blocks_per_second), take.frames)));
      blocks.push_back({source.take, source.swapped, begin, std::max(begin + length, frame + 1)});
    }
    before = pair;
    landing_blocks.push_back(static_cast<int>(blocks.size()) - 1);
    landing_labels.push_back(index_of(labels, library->label(pair)));
  }
  if (before >= 0) end_stretch();
}

/// Weights with which every example's partner and label count, by how alike its motion is: (K + ridge I)^-1
/// Y.
/// @param motions the examples, described
bool IntentModel::Learned::regress(const std::vector<int>& of, const Rows& motions,
                                   const Progress& progress) {
  const auto count = static_cast<Eigen::Index>(of.size());
  Eigen::MatrixXd wanted = Eigen::MatrixXd::Zero(count, outputs());
  std::vector<float> point(static_cast<std::size_t>(partners.size()));
  std::vector<float> work(static_cast<std::size_t>(partners.room()));
  for (Eigen::Index e = 0; e < count; ++e) {
    const int pair = of[static_cast<std::size_t>(e)];
    partners.embed(motion_before.partner_after(pair, lead_s), point, work);
    const auto found = Eigen::Map<const Eigen::VectorXf>(point.data(), partners.size()).cast<double>();
    wanted.row(e).head(partners.size()) = found.transpose();
    wanted(e, partners.size()) = found.squaredNorm();
    if (const int label = index_of(labels, library->label(pair)); label >= 0)
      wanted(e, partners.size() + 1 + label) = 1;
  }
  const Eigen::RowVectorXd mean = wanted.colwise().mean();
  usual = mean.transpose().cast<float>();
  wanted.rowwise() -= mean;

  Eigen::MatrixXd alike(count, count);
  const bool compared = for_each_row(of.size(), 64, part(progress, 0, 0.3), learning, [&](std::size_t at) {
    const auto e = static_cast<Eigen::Index>(at);
    std::vector<float> with_earlier(at + 1), room(at + 1);
    kernel.compare(examples, {motions.row(e).data(), static_cast<std::size_t>(kernel.size())}, with_earlier,
                   room);
    alike.row(e).head(e + 1) =
        Eigen::Map<const Eigen::RowVectorXf>(with_earlier.data(), e + 1).cast<double>();
    alike(e, e) = 1 + ridge;
  });
  if (!compared || !solve_positive(alike, wanted, part(progress, 0.3, 1))) return false;
  weights = wanted.cast<float>();
  return true;
}

bool IntentModel::Learned::describe_landings(const Progress& progress) {
  const auto count = static_cast<Eigen::Index>(landings.size());
  landing_motions.resize(count, kernel.size());
  landing_points.resize(count, partners.size());
  landing_places.resize(landings.size());
  const bool described = for_each_row(landings.size(), 64, progress, learning, [&](std::size_t at) {
    const auto row = static_cast<Eigen::Index>(at);
    HistoryKernel::Raw raw;
    motion_before.sample(landings[at], raw);
    kernel.describe(raw, {landing_motions.row(row).data(), static_cast<std::size_t>(kernel.size())});
    std::vector<float> work(static_cast<std::size_t>(partners.room()));
    partners.embed(motion_before.partner_after(landings[at], 0),
                   {landing_points.row(row).data(), static_cast<std::size_t>(partners.size())}, work);
    landing_places[at] = partner_place(*library, landings[at]);
  });
  landing_squares = landing_points.rowwise().squaredNorm();
  return described;
}

std::shared_ptr<const IntentModel> IntentModel::learn(std::shared_ptr<const MotionLibrary> library,
                                                      std::span<const int> pairs, const Progress& progress) {
  const std::vector<int> examples = thinned(*library, pairs, examples_per_second, most_examples, false);
  const RecordedMotion recorded(*library);
  Rows motions(static_cast<Eigen::Index>(examples.size()), HistoryKernel::raw_size);
  const bool sampled =
      for_each_row(examples.size(), 64, part(progress, 0, 0.1), learning, [&](std::size_t e) {
        HistoryKernel::Raw raw;
        recorded.sample(examples[e], raw);
        motions.row(static_cast<Eigen::Index>(e)) =
            Eigen::Map<const Eigen::RowVectorXf>(raw.data(), HistoryKernel::raw_size);
      });
  if (!sampled) return nullptr;
  std::vector<Pose> landmarks;
  const std::size_t landmark_count = std::min<std::size_t>(examples.size(), PartnerEmbedding::most_landmarks);
  for (std::size_t l = 0; l < landmark_count; ++l)
    landmarks.push_back(recorded.partner_after(examples[l * examples.size() / landmark_count], 0));

  auto learned = std::make_unique<Learned>(library, HistoryKernel(motions), PartnerEmbedding(landmarks));
  learned->labels = labels_of(*library, pairs);
  motions = learned->kernel.describe(motions);
  learned->examples = learned->kernel.to_compare(motions);
  learned->landings = thinned(*library, pairs, landings_per_second, most_landings, true);
  learned->place_in_blocks();
  if (!learned->describe_landings(part(progress, 0.1, 0.3))) return nullptr;
  if (!learned->regress(examples, motions, part(progress, 0.3, 1))) return nullptr;
  return std::shared_ptr<const IntentModel>(new IntentModel(std::move(learned)));
}

IntentModel::IntentModel(std::unique_ptr<const Learned> learned) : learned_(std::move(learned)) {}
IntentModel::~IntentModel() = default;

const std::shared_ptr<const MotionLibrary>& IntentModel::library() const {
  return learned_->library;
}
const std::vector<std::string>& IntentModel::labels() const {
  return learned_->labels;
}
const std::vector<BeliefBlock>& IntentModel::blocks() const {
  return learned_->blocks;
}
const std::vector<int>& IntentModel::landings() const {
  return learned_->landings;
}
int IntentModel::block_of_landing(std::size_t landing) const {
  return learned_->landing_blocks[landing];
}
int IntentModel::label_of_landing(std::size_t landing) const {
  return learned_->landing_labels[landing];
}
int IntentModel::example_count() const {
  return static_cast<int>(learned_->examples.size());
}

IntentModel::Reading IntentModel::make_reading() const {
  const Learned& of = *learned_;
  Reading reading;
  reading.motion.resize(static_cast<std::size_t>(of.kernel.size()));
  reading.kernel.resize(static_cast<std::size_t>(of.examples.size()));
  reading.kernel_work = reading.kernel;
  reading.expected.resize(static_cast<std::size_t>(of.outputs()));
  reading.moves.resize(of.labels.size());
  reading.partner_m.resize(of.landings.size());
  reading.embedding_work.resize(static_cast<std::size_t>(of.partners.room()));
  for (Reading::Described& room : reading.described) {
    room.point.resize(static_cast<std::size_t>(of.partners.size()));
    room.motion.resize(static_cast<std::size_t>(of.kernel.size()));
  }
  return reading;
}

void IntentModel::read(const MotionHistory& history, Reading& reading) const {
  const Learned& of = *learned_;
  HistoryKernel::Raw raw;
  HistoryKernel::sample(history, raw);
  of.kernel.describe(raw, reading.motion);

  of.kernel.compare(of.examples, reading.motion, reading.kernel, reading.kernel_work);
  const Eigen::Map<const Eigen::VectorXf> kernel(reading.kernel.data(), of.examples.size());

  Eigen::Map<Eigen::VectorXf> expected(reading.expected.data(), of.outputs());
  expected.noalias() = of.weights.transpose() * kernel;
  expected += of.usual;
  const auto point = expected.head(of.partners.size());
  reading.expected_square = point.squaredNorm();
  reading.spread_m = std::max(0.0F, expected(of.partners.size()) - reading.expected_square);

  // A regression of 0 and 1 may leave [0, 1] a little.
  float sum = 0;
  for (std::size_t l = 0; l < reading.moves.size(); ++l) {
    const float seen = expected(of.partners.size() + 1 + static_cast<Eigen::Index>(l));
    reading.moves[l] = std::max(seen, 1e-3F);
    sum += reading.moves[l];
  }
  for (float& probability : reading.moves) probability /= sum;

  Eigen::Map<Eigen::VectorXf> partner(reading.partner_m.data(), of.landing_points.rows());
  partner.noalias() = of.landing_points * point;
  partner = (of.landing_squares - 2 * partner).array() + (reading.expected_square + reading.spread_m);
}

const RootFrame& IntentModel::place_of_landing(std::size_t landing) const {
  return learned_->landing_places[landing];
}

float IntentModel::leader_kernel(std::size_t landing, const Reading& reading) const {
  const auto motions = learned_->landing_motions.row(static_cast<Eigen::Index>(landing));
  return learned_->kernel(reading.motion, {motions.data(), reading.motion.size()});
}

const IntentModel::Reading::Described& IntentModel::described(int pair, Reading& reading) const {
  for (const Reading::Described& known : reading.described)
    if (known.pair == pair) return known;
  const Learned& of = *learned_;
  Reading::Described& made = reading.described[reading.next_described];
  reading.next_described = (reading.next_described + 1) % reading.described.size();
  made.pair = pair;
  of.partners.embed(of.motion_before.partner_after(pair, 0), made.point, reading.embedding_work);
  HistoryKernel::Raw raw;
  of.motion_before.sample(pair, raw);
  of.kernel.describe(raw, made.motion);
  return made;
}

IntentModel::PairReading IntentModel::read_pair(int pair, Reading& reading) const {
  const Learned& of = *learned_;
  const Reading::Described& pair_described = described(pair, reading);
  const Eigen::Map<const Eigen::VectorXf> point(pair_described.point.data(), of.partners.size());
  const Eigen::Map<const Eigen::VectorXf> expected(reading.expected.data(), of.partners.size());
  PairReading of_pair;
  of_pair.partner_m = (point - expected).squaredNorm() + reading.spread_m;
  of_pair.leader_kernel = of.kernel(reading.motion, pair_described.motion);
  of_pair.label = index_of(of.labels, of.library->label(pair));
  return of_pair;
}

}  // namespace abrazo
