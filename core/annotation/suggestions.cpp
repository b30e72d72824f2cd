#include "core/annotation/suggestions.hpp"

#include "core/annotation/suggestion_reason.hpp"

namespace abrazo {

namespace {

/// Puts what a model proposes for a take into tiers.
class Wording {
 public:
  Wording(const MotionLibrary& library, int take, const LabelledMoves& labelled)
      : labelled_(labelled),
        of_(library.takes()[static_cast<std::size_t>(take)]),
        motion_(couple_motion(library, take, suggestion_rate_hz)),
        geometry_(couple_geometry(motion_)),
        channels_(channels_of(motion_)) {}

  const std::array<MotionChannels, 2>& channels() const { return channels_; }

  void add_move(std::vector<Suggestion>& tier, const ProposedMove& move) const {
    std::string reason = seen_geometry(motion_, geometry_, move.begin, move.end);
    reason += (reason.empty() ? "" : "; ") + neighbour_words(move, labelled_);
    tier.push_back({.start_s = seconds(move.begin),
                    .end_s = seconds(move.end),
                    .value = labelled_.labels[static_cast<std::size_t>(move.label)],
                    .confidence = move.confidence,
                    .reason = std::move(reason)});
  }

  /// Extends the last interval if the role is the same. Moves must be in order.
  void add_role(std::vector<Suggestion>& tier, const ProposedMove& move) {
    const std::string role = move.active == 0 ? "a" : "b";
    const double duration_s = seconds(move.end) - seconds(move.begin);
    if (tier.empty() || tier.back().value != role) {
      tier.push_back({.start_s = seconds(move.begin), .value = role, .reason = {}});
      role_begin_ = move.begin;
      certainty_s_ = 0;
    }
    Suggestion& last = tier.back();
    certainty_s_ += move.role_confidence * duration_s;
    last.end_s = seconds(move.end);
    last.confidence = certainty_s_ / (last.end_s - last.start_s);
    last.reason = role_words(motion_, channels_, role_begin_, move.end, move.active);
  }

 private:
  double seconds(int frame) const {
    return (frame < motion_.size() ? motion_.frames[static_cast<std::size_t>(frame)] : of_.frames) / of_.fps;
  }

  const LabelledMoves& labelled_;
  const LibraryTake& of_;
  CoupleMotion motion_;
  CoupleGeometry geometry_;
  std::array<MotionChannels, 2> channels_;
  int role_begin_ = 0;
  double certainty_s_ = 0;
};

}  // namespace

Result<SuggestedTiers> suggest_annotations(const MotionLibrary& library, const SuggestionRequest& request,
                                           const Progress& progress) {
  const int take = library.find_take(request.take);
  if (take < 0) return Error{"the library has no take of that name", request.take};
  if (!report(progress, 0, "reading the labelled takes")) return Error{"cancelled", ""};
  const LabelledMoves labelled = labelled_moves(library, take);
  if (labelled.takes.empty())
    return Error{"no other take of the library has labels or roles to learn from: annotate one first",
                 request.take};
  const auto model = MoveModel::learn(labelled, part(progress, 0.05, 0.9));
  if (!model) return model.error();
  Wording wording(library, take, labelled);
  SuggestedTiers tiers;
  for (const ProposedMove& move : model->propose(wording.channels())) {
    if (request.moves && labelled.has_labels) wording.add_move(tiers.moves, move);
    if (request.roles && labelled.has_roles) wording.add_role(tiers.roles, move);
  }
  if (const auto damage = library.damage()) return *damage;  // stand-ins were learnt from
  return tiers;
}

}  // namespace abrazo
