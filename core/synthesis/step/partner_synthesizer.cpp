#include "core/synthesis/step/partner_synthesizer.hpp"

#include <algorithm>
#include <array>
#include <exception>
#include <new>
#include <stdexcept>

#include "core/motion/body/person_bounds.hpp"
#include "core/synthesis/frames/frame_room.hpp"
#include "core/synthesis/settings/settings_check.hpp"
#include "core/synthesis/step/frame_pipeline.hpp"
#include "core/synthesis/step/role_views.hpp"
#include "core/synthesis/step/synthesizer_state.hpp"

namespace abrazo {

namespace {

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

std::string_view first_joint_without_position(const Pose& pose) {
  int joint = 0;
  while (joint + 1 < joint_count && pose.row(joint).allFinite()) ++joint;
  return joint_names[static_cast<std::size_t>(joint)];
}

}  // namespace

struct PartnerSynthesizer::State {
  std::shared_ptr<const RoleViews> views;
  Settings settings;
  std::string unlearned;  ///< why the selection `intent` is unavailable; empty if available
  std::string unusable;   ///< which setting no step can be solved with; empty when all can be used
  std::optional<Body> user_body;
  std::optional<int> pinned;
  std::shared_ptr<const Vetoes> vetoes = std::make_shared<const Vetoes>();
  std::optional<IntendedPairs> meant;
  /// By the user's role, each once needed. A passive user's gets the pairs with the roles exchanged, so that
  /// the user is always the first body.
  std::array<std::unique_ptr<FramePipeline>, 2> pipelines;
  double unsolved_s = 0;  ///< since the last frame that was solved
  FrameResult shown;      ///< of a passive user, in the order active, passive

  void set_settings(const Settings& changed) {
    settings = changed;
    unlearned.clear();
    const Status usable = check_settings(changed);
    unusable = usable ? std::string() : usable.error().text();
  }

  bool user_is_passive() const { return settings.user_role == UserRole::Passive; }

  FramePipeline& pipeline_of(UserRole role) {
    auto& pipeline = pipelines[role == UserRole::Passive ? 1 : 0];
    if (!pipeline) {
      const RoleViews::View& view = views->of(role);
      auto made = std::make_unique<FramePipeline>(view.library, settings, views->pairs(), view.index);
      made->set_user_body(user_body);
      made->pin_pair(pinned);
      made->set_vetoes(*vetoes);
      made->set_intended(meant);
      pipeline = std::move(made);
    }
    return *pipeline;
  }
  /// Always exists: a role change creates it first.
  FramePipeline& pipeline() { return pipeline_of(settings.user_role); }

  /// Tried once: what fails takes long, and steps are many.
  void learn_intent() {
    if (!unlearned.empty()) return;
    try {
      const auto& model = views->intent(settings.user_role);
      pipeline().set_intent(model);
      reserve_room(shown.intent, *model);
    } catch (const std::bad_alloc&) {
      unlearned = "there is not enough memory to learn the library";
    } catch (const std::exception& failure) {
      unlearned = std::string("the library could not be learned: ") + failure.what();
    }
  }

  void for_each_pipeline(const auto& change) {
    for (const auto& pipeline : pipelines)
      if (pipeline) change(*pipeline);
  }
};

Result<std::unique_ptr<PartnerSynthesizer>> PartnerSynthesizer::create(
    std::shared_ptr<const MotionLibrary> library, const Settings& settings,
    const std::vector<std::string>& excluded_takes) {
  auto pairs = selectable_pairs(*library, excluded_takes);
  if (!pairs) return pairs.error();
  auto state = std::make_unique<State>();
  state->views = RoleViews::shared(std::move(library), std::move(*pairs));
  state->set_settings(settings);
  reserve_room(state->shown);
  try {
    state->pipeline();
  } catch (const std::runtime_error& failure) {
    return Error{failure.what(), state->views->library()->name()};
  }
  return std::unique_ptr<PartnerSynthesizer>(new PartnerSynthesizer(std::move(state)));
}

PartnerSynthesizer::PartnerSynthesizer(std::unique_ptr<State> state) : state_(std::move(state)) {}
PartnerSynthesizer::~PartnerSynthesizer() = default;

const FrameResult& PartnerSynthesizer::step(const Pose& user, Duration elapsed) {
  FramePipeline& pipeline = state_->pipeline();
  // Frames that gave nothing count as time without tracking: velocities and locks belong to the last one
  // solved.
  const double since_solved_s = state_->unsolved_s + std::max(0.0, elapsed.count());
  const bool starts = !(elapsed.count() > 0);
  const bool was_lost = !starts && since_solved_s > tracking_loss_s;
  state_->unsolved_s = since_solved_s;
  try {
    if (!state_->unusable.empty()) {
      pipeline.refuse(state_->unusable);
    } else if (!user.allFinite()) {
      pipeline.refuse("the user's pose has no finite position for ", first_joint_without_position(user));
    } else if (const auto reason = why_not_a_person(user)) {
      pipeline.refuse("held: not a person: ", reason->sentence());
    } else {
      if (starts) pipeline.forget();
      if (was_lost) pipeline.lose_track();
      if (state_->settings.selection == SelectionMethod::Intent && !pipeline.has_intent())
        state_->learn_intent();
      if (!state_->unlearned.empty()) throw std::runtime_error(state_->unlearned);
      pipeline.solve(user, starts || was_lost ? 0.0 : since_solved_s);
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
  const FramePipeline& before = state_->pipeline();
  FramePipeline& next = state_->pipeline_of(settings.user_role);
  if (&next != &before) next.take_over(before.memory());
  next.set_settings(settings);
  state_->set_settings(settings);
}

const Settings& PartnerSynthesizer::settings() const {
  return state_->settings;
}

void PartnerSynthesizer::set_user_body(const Body& body) {
  state_->user_body = body;
  state_->pipeline().set_user_body(body);
}

void PartnerSynthesizer::forget_user_body() {
  state_->user_body.reset();
  state_->pipeline().set_user_body(std::nullopt);
}

const std::optional<Body>& PartnerSynthesizer::user_body() const {
  return state_->pipeline().memory().user.body();
}

void PartnerSynthesizer::reset() {
  state_->pipeline().forget();
}

void PartnerSynthesizer::pin_pair(std::optional<int> pair) {
  state_->pinned = pair;
  state_->for_each_pipeline([&](FramePipeline& pipeline) { pipeline.pin_pair(pair); });
}

void PartnerSynthesizer::set_vetoes(const Vetoes& vetoes) {
  state_->vetoes = std::make_shared<const Vetoes>(vetoes);
  state_->for_each_pipeline([&](FramePipeline& pipeline) { pipeline.set_vetoes(vetoes); });
}

void PartnerSynthesizer::set_intended(const std::optional<IntendedPairs>& meant) {
  if (state_->meant == meant) return;
  state_->meant = meant;
  state_->for_each_pipeline([&](FramePipeline& pipeline) { pipeline.set_intended(meant); });
}

SynthesizerState PartnerSynthesizer::state() const {
  return {.user_role = state_->settings.user_role,
          .memory = state_->pipeline().memory(),
          .user_body = state_->user_body,
          .pinned = state_->pinned,
          .vetoes = state_->vetoes,
          .meant = state_->meant,
          .unsolved_s = state_->unsolved_s};
}

void PartnerSynthesizer::restore(const SynthesizerState& state) {
  state_->pipeline_of(state.user_role);
  state_->settings.user_role = state.user_role;
  state_->user_body = state.user_body;
  pin_pair(state.pinned);
  if (state_->vetoes != state.vetoes) set_vetoes(*state.vetoes);
  state_->vetoes = state.vetoes;
  set_intended(state.meant);
  state_->pipeline().set_settings(state_->settings);
  state_->pipeline().restore(state.memory);
  state_->unsolved_s = state.unsolved_s;
}

void PartnerSynthesizer::take_over(const SynthesizerState& state) {
  state_->pipeline_of(state.user_role);
  state_->settings.user_role = state.user_role;
  state_->user_body = state.user_body;
  state_->pipeline().set_settings(state_->settings);
  state_->pipeline().take_over(state.memory);
  state_->unsolved_s = state.unsolved_s;
}

const MotionLibrary& PartnerSynthesizer::library() const {
  return *state_->views->library();
}

std::shared_ptr<const MotionLibrary> PartnerSynthesizer::shared_library() const {
  return state_->views->library();
}

const std::shared_ptr<const RoleViews>& PartnerSynthesizer::views() const {
  return state_->views;
}

}  // namespace abrazo
