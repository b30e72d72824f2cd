#include "core/synthesis/partner_synthesizer.hpp"

#include <algorithm>
#include <exception>

#include "core/synthesis/frame_pipeline.hpp"
#include "core/synthesis/synthesizer_state.hpp"

namespace abrazo {

namespace {

constexpr double tracking_loss_s = 0.3;

Result<std::vector<int>> selectable_pairs(const MotionLibrary& library,
                                          const std::vector<std::string>& excluded) {
  std::vector<bool> is_excluded(library.takes().size(), false);
  for (const std::string& name : excluded) {
    const int take = library.find_take(name);
    if (take < 0) {
      std::string names;
      for (const LibraryTake& known : library.takes()) names += (names.empty() ? "" : ", ") + known.name;
      return Error{"the library has no take of this name to leave out; it has " + names, name};
    }
    is_excluded[static_cast<std::size_t>(take)] = true;
  }
  std::vector<int> pairs;
  for (int pair = 0; pair < library.pair_count(); ++pair)
    if (!is_excluded[library.source(pair).take]) pairs.push_back(pair);
  if (pairs.empty()) return Error{"no pair is left to select from: every take is left out", library.name()};
  return pairs;
}

std::string first_joint_without_position(const Pose& pose) {
  int joint = 0;
  while (joint + 1 < joint_count && pose.row(joint).allFinite()) ++joint;
  return std::string(joint_names[static_cast<std::size_t>(joint)]);
}

}  // namespace

struct PartnerSynthesizer::State {
  std::shared_ptr<const MotionLibrary> library;
  std::vector<int> pairs;  ///< that may be selected
  Settings settings;
  std::optional<Body> user_body;
  std::optional<int> pinned;
  std::shared_ptr<const Vetoes> vetoes = std::make_shared<const Vetoes>();
  std::shared_ptr<const MotionLibrary> exchanged;  ///< the library as a passive user sees it, once needed
  std::unique_ptr<FramePipeline> pipeline;
  double unsolved_s = 0;  ///< since the last frame that was solved
  FrameResult shown;      ///< of a passive user, in the order active, passive

  bool user_is_passive() const { return settings.user_role == UserRole::Passive; }

  /// For a passive user the pipeline gets the pairs with the roles exchanged, so that the user is always its
  /// first body.
  std::unique_ptr<FramePipeline> new_pipeline(const Settings& wanted) {
    const bool is_passive = wanted.user_role == UserRole::Passive;
    if (is_passive && !exchanged)
      exchanged = std::make_shared<const MotionLibrary>(with_roles_exchanged(*library));
    auto made = std::make_unique<FramePipeline>(is_passive ? exchanged : library, wanted, pairs);
    if (user_body) made->set_user_body(*user_body);
    made->pin_pair(pinned);
    made->set_vetoes(*vetoes);
    return made;
  }
};

Result<std::unique_ptr<PartnerSynthesizer>> PartnerSynthesizer::create(
    std::shared_ptr<const MotionLibrary> library, const Settings& settings,
    const std::vector<std::string>& excluded_takes) {
  auto pairs = selectable_pairs(*library, excluded_takes);
  if (!pairs) return pairs.error();
  auto state = std::make_unique<State>();
  state->library = std::move(library);
  state->pairs = std::move(*pairs);
  state->settings = settings;
  state->pipeline = state->new_pipeline(settings);
  return std::unique_ptr<PartnerSynthesizer>(new PartnerSynthesizer(std::move(state)));
}

PartnerSynthesizer::PartnerSynthesizer(std::unique_ptr<State> state) : state_(std::move(state)) {}
PartnerSynthesizer::~PartnerSynthesizer() = default;

const FrameResult& PartnerSynthesizer::step(const Pose& user, Duration elapsed) {
  FramePipeline& pipeline = *state_->pipeline;
  // Frames that gave nothing count as time without tracking: velocities and locks belong to the last one
  // solved.
  const double since_solved_s = state_->unsolved_s + std::max(0.0, elapsed.count());
  const bool starts = !(elapsed.count() > 0) || since_solved_s > tracking_loss_s;
  state_->unsolved_s = since_solved_s;
  try {
    if (!user.allFinite()) {
      pipeline.refuse("the user's pose has no finite position for " + first_joint_without_position(user));
    } else {
      if (starts) pipeline.forget();
      pipeline.solve(user, starts ? 0.0 : since_solved_s);
      if (pipeline.result().status != StepStatus::Failed) state_->unsolved_s = 0;
    }
  } catch (const std::exception& failure) {
    pipeline.refuse(failure.what());
  }
  if (!state_->user_is_passive()) return pipeline.result();
  exchange_roles(pipeline.result(), state_->shown);
  return state_->shown;
}

void PartnerSynthesizer::set_settings(const Settings& settings) {
  if (settings.user_role != state_->settings.user_role) {
    state_->pipeline = state_->new_pipeline(settings);
    state_->unsolved_s = 0;
  } else {
    state_->pipeline->set_settings(settings);
  }
  state_->settings = settings;
}

const Settings& PartnerSynthesizer::settings() const {
  return state_->settings;
}

void PartnerSynthesizer::set_user_body(const Body& body) {
  state_->user_body = body;
  state_->pipeline->set_user_body(body);
}

void PartnerSynthesizer::reset() {
  state_->pipeline->forget();
}

void PartnerSynthesizer::pin_pair(std::optional<int> pair) {
  state_->pinned = pair;
  state_->pipeline->pin_pair(pair);
}

void PartnerSynthesizer::set_vetoes(const Vetoes& vetoes) {
  state_->vetoes = std::make_shared<const Vetoes>(vetoes);
  state_->pipeline->set_vetoes(vetoes);
}

SynthesizerState PartnerSynthesizer::state() const {
  return {.user_role = state_->settings.user_role,
          .memory = state_->pipeline->memory(),
          .user_body = state_->user_body,
          .pinned = state_->pinned,
          .vetoes = state_->vetoes,
          .unsolved_s = state_->unsolved_s};
}

void PartnerSynthesizer::restore(const SynthesizerState& state) {
  Settings settings = state_->settings;
  settings.user_role = state.user_role;
  set_settings(settings);
  state_->user_body = state.user_body;
  pin_pair(state.pinned);
  if (state_->vetoes != state.vetoes) {
    state_->vetoes = state.vetoes;
    state_->pipeline->set_vetoes(*state.vetoes);
  }
  state_->pipeline->restore(state.memory);
  state_->unsolved_s = state.unsolved_s;
}

const MotionLibrary& PartnerSynthesizer::library() const {
  return *state_->library;
}

}  // namespace abrazo
