#include "core/session/run/session_engine.hpp"

#include <algorithm>
#include <charconv>
#include <future>
#include <thread>
#include <utility>

#include "core/motion/files/import_clip.hpp"
#include "core/session/file/library_fingerprints.hpp"
#include "core/session/frames/joined_stores.hpp"
#include "core/session/run/listener_gate.hpp"
#include "core/session/run/partner_output.hpp"
#include "core/session/run/solver_thread.hpp"
#include "core/stream/receive/clip_source.hpp"
#include "core/synthesis/step/role_views.hpp"

namespace abrazo {

namespace {

constexpr double longest_clip_rate_hz = 120;

/// A source that reports when the solver thread releases it.
class LentSource {
 public:
  explicit LentSource(std::unique_ptr<PoseSource> source) : source_(std::move(source)) {}
  ~LentSource() {
    source_.reset();
    returned_.set_value();
  }
  PoseSource* get() const { return source_.get(); }
  std::future<void> returned() { return returned_.get_future(); }

 private:
  std::unique_ptr<PoseSource> source_;
  std::promise<void> returned_;
};

/// Passes on what was solved before it was attached, too.
class FromTheStart : public FrameListener {
 public:
  FromTheStart(std::shared_ptr<FrameListener> to, const FrameHistory& history)
      : to_(std::move(to)), history_(history) {}
  void frame_solved(const FrameSnapshotPtr& frame) override {
    if (!std::exchange(has_begun_, true))
      for (const FrameSnapshotPtr& earlier : history_.range(history_.span().memory_first_s, frame->time_s))
        if (earlier->index < frame->index) to_->frame_solved(earlier);
    to_->frame_solved(frame);
  }

 private:
  const std::shared_ptr<FrameListener> to_;
  const FrameHistory& history_;
  bool has_begun_ = false;
};

std::string text_option(const StreamUri& uri, std::string_view key) {
  const auto found = uri.options.find(key);
  return found == uri.options.end() ? std::string() : found->second;
}

std::optional<double> number_option(const StreamUri& uri, std::string_view key) {
  const std::string text = text_option(uri, key);
  double value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  return read.ec == std::errc{} && !text.empty() ? std::optional(value) : std::nullopt;
}

Result<std::unique_ptr<PoseSource>> open_clip(const StreamUri& uri, const std::string& performer) {
  ImportOptions options;
  options.fps = number_option(uri, "fps");
  options.metres_per_unit = number_option(uri, "metres-per-unit");
  auto clips = load_motion(uri.file, text_option(uri, "skeleton"), options);
  if (!clips) return clips.error();
  std::string names;
  for (ImportedClip& found : *clips) {
    if ((performer.empty() || found.clip.name == performer) && !found.clip.poses.empty())
      return std::unique_ptr<PoseSource>(
          std::make_unique<ClipSource>(std::move(found.clip), longest_clip_rate_hz));
    names += (names.empty() ? "" : ", ") + found.clip.name;
  }
  return Error{"has no frames of \"" + performer + "\"; it has " + names, uri.file};
}

UserRole other_character(UserRole role) {
  return role == UserRole::Active ? UserRole::Passive : UserRole::Active;
}

}  // namespace

struct SessionEngine::Parts {
  Parts(std::shared_ptr<PartnerSynthesizer> synthesizer, std::shared_ptr<PoseSource> source,
        const SessionClock& session_clock, SessionOpeners open_with,
        std::shared_ptr<const FrameStore> recorded)
      : clock(session_clock),
        openers(std::move(open_with)),
        own_source(source),
        views(synthesizer->views()),
        settings(synthesizer->settings()),
        solver(make_loop(std::move(synthesizer), std::move(source), std::move(recorded)), clock) {
    prepare_roles();
  }

  /// The history gets the recorded frames before the first is solved, which is numbered after them.
  std::unique_ptr<LiveLoop> make_loop(std::shared_ptr<PartnerSynthesizer> synthesizer,
                                      std::shared_ptr<PoseSource> source,
                                      std::shared_ptr<const FrameStore> recorded) {
    opened = std::move(recorded);
    history.set_store(opened);
    return std::make_unique<LiveLoop>(std::move(synthesizer), std::move(source), commands, history, latest,
                                      [this] { return clock.now_s(); });
  }

  /// Prepares the view of the library for the other role before it is needed; unless that takes the memory
  /// of a library that was too large to be read.
  void prepare_roles() const {
    for (const UserRole each : {settings.user_role, other_character(settings.user_role)})
      if (!views->is_costly(each)) views->prepare(each);
  }

  /// From the next frame on, which a recording has as of this input; returns when the solver thread has
  /// nothing of the lent source before any more, which takes a step at most: then its port is free.
  /// @param source  null = our own
  void play(std::unique_ptr<PoseSource> source, const std::string& input = {}) {
    ReplaceSource next{own_source};
    std::future<void> returned;
    if (source) {
      auto lent = std::make_shared<LentSource>(std::move(source));
      returned = lent->returned();
      next = {std::shared_ptr<PoseSource>(lent, lent->get()), std::make_shared<const std::string>(input)};
    }
    commands.push(std::move(next));
    if (lent_source.valid()) lent_source.wait();
    lent_source = std::move(returned);
  }

  void record_poses_of(StreamReceiver& from) {
    if (recorder)
      poses_listener = from.listen([to = recorder](const ReceivedPose& pose) { to->pose_received(pose); });
  }
  void stop_recording_poses() {
    if (receiver && poses_listener) receiver->unlisten(*poses_listener);
    poses_listener.reset();
  }

  SessionClock clock;
  SessionOpeners openers;
  CommandQueue commands;
  std::shared_ptr<const FrameStore> opened;  ///< of before this run; may be null
  FrameHistory history;
  LatestSlot<FrameSnapshot> latest;
  std::shared_ptr<PoseSource> own_source;  ///< of the constructor; belongs to the solver thread
  std::string own_input;                   ///< its name in a recording, which only the caller knows
  std::shared_ptr<const RoleViews> views;
  Settings settings;  ///< last requested

  std::shared_ptr<StreamReceiver> receiver;
  std::future<void> lent_source;  ///< when the source that plays was taken back; invalid: it is our own
  std::optional<int> poses_listener;
  std::shared_ptr<Recorder> recorder;
  std::shared_ptr<LibraryFingerprints> fingerprints = std::make_shared<LibraryFingerprints>();
  std::shared_ptr<ListenerGate> gate;
  std::shared_ptr<HistoryKeeper> keeper;
  struct Sending {
    std::string uri;
    std::shared_ptr<PoseSink> sink;
  };
  std::vector<Sending> sending;

  SolverThread solver;  // last in, first out
};

SessionEngine::SessionEngine(std::unique_ptr<PartnerSynthesizer> synthesizer,
                             std::shared_ptr<PoseSource> source, SessionClock clock, SessionOpeners openers,
                             std::shared_ptr<const FrameStore> recorded)
    : parts_(std::make_unique<Parts>(std::shared_ptr<PartnerSynthesizer>(std::move(synthesizer)),
                                     std::move(source), clock, std::move(openers), std::move(recorded))) {}

SessionEngine::~SessionEngine() {
  [[maybe_unused]] const Status recorded = stop_recording();  // callers check beforehand
  parts_->stop_recording_poses();
}

void SessionEngine::push(const Command& command) {
  if (const auto* wish = std::get_if<SetSettings>(&command)) parts_->settings = wish->settings;
  const auto* replacement = std::get_if<ReplaceSynthesizer>(&command);
  if (replacement && replacement->synthesizer) {
    parts_->views = replacement->synthesizer->views();
    parts_->prepare_roles();
  }
  parts_->commands.push(command);
}

Status SessionEngine::intend(const IntendedMove& move) {
  const Status possible = check_meant(*parts_->views, move);
  if (possible) push(IntendMove{move});
  return possible;
}

Status SessionEngine::control_role(RoleControl by) {
  const Status possible = check_role_control(*parts_->views, by);
  if (possible) push(SetRoleControl{by});
  return possible;
}

std::vector<MeantChoice> SessionEngine::meant_choices() const {
  const FrameSnapshotPtr newest = parts_->latest.newest();
  if (!newest) return abrazo::meant_choices(*parts_->views, parts_->settings.user_role, nullptr);
  return abrazo::meant_choices(*parts_->views, newest->settings.user_role, &newest->result);
}

const FrameHistory& SessionEngine::history() const {
  return parts_->history;
}

const LatestSlot<FrameSnapshot>& SessionEngine::latest() const {
  return parts_->latest;
}

const SessionClock& SessionEngine::clock() const {
  return parts_->clock;
}

bool SessionEngine::is_held() const {
  return parts_->solver.is_held();
}

std::optional<LiveLoop::ClipProgress> SessionEngine::clip_progress() const {
  return parts_->solver.clip_progress();
}

void SessionEngine::look_at(double clip_time_s) {
  parts_->solver.look_at(clip_time_s);
}

// ---- stream in ----

Status SessionEngine::receive(const StreamUri& uri, const std::string& performer,
                              const StreamReceiverOptions& options) {
  if (uri.scheme == StreamUri::Scheme::Clip) {
    auto clip = open_clip(uri, performer);
    if (!clip) return clip.error();
    stop_receiving();
    parts_->play(std::move(*clip), uri.text);
    return Done{};
  }
  for (const Parts::Sending& sending : parts_->sending)
    if (const auto to = parse_stream_uri(sending.uri); to)
      if (const Status away = check_no_loop(uri, *to); !away) return away.error();
  // The same port again: it has to be free first.
  if (parts_->receiver && parts_->receiver->uri().port == uri.port) stop_receiving();
  StreamReceiverOptions recorded = options;
  recorded.prepare = [&](StreamReceiver& receiver) {
    if (options.prepare) options.prepare(receiver);
    parts_->stop_recording_poses();
    parts_->record_poses_of(receiver);
  };
  auto opened = parts_->openers.receiver(uri, parts_->clock, recorded);
  if (!opened) return opened.error();
  parts_->play((*opened)->source(performer), uri.text);
  parts_->receiver = std::move(*opened);
  return Done{};
}

void SessionEngine::follow_performer(const std::string& performer) {
  if (parts_->receiver) parts_->play(parts_->receiver->source(performer), parts_->receiver->uri().text);
}

void SessionEngine::stop_receiving() {
  parts_->play(nullptr);
  parts_->stop_recording_poses();
  parts_->receiver.reset();
}

std::shared_ptr<StreamReceiver> SessionEngine::receiver() const {
  return parts_->receiver;
}

// ---- stream out ----

Status SessionEngine::send(const StreamUri& uri, Character character) {
  const auto same = [&](const Parts::Sending& sending) { return sending.uri == uri.text; };
  if (std::any_of(parts_->sending.begin(), parts_->sending.end(), same))
    return Error{"something is sent there already; stop that first, or give another port", uri.text};
  if (parts_->receiver)
    if (const Status away = check_no_loop(parts_->receiver->uri(), uri); !away) return away.error();
  // To begin with: the role and the body that the user has in a frame are only known with it.
  const Body body = body_of_character(*parts_->views->library(), character, parts_->settings, std::nullopt);
  auto opened = parts_->openers.sink(uri, body, character == Character::User ? "user" : "partner");
  if (!opened) return opened.error();
  const std::shared_ptr<PoseSink> sink = std::move(*opened);
  parts_->sending.push_back({uri.text, sink});
  push(AttachSink{character, sink});
  return Done{};
}

void SessionEngine::stop_sending(const std::string& uri) {
  for (const Parts::Sending& sending : parts_->sending)
    if (sending.uri == uri) push(DetachSink{sending.sink});
  std::erase_if(parts_->sending, [&](const Parts::Sending& sending) { return sending.uri == uri; });
}

std::vector<SinkHealth> SessionEngine::sinks() const {
  std::vector<SinkHealth> healths;
  for (const Parts::Sending& sending : parts_->sending) healths.push_back(sending.sink->health());
  return healths;
}

// ---- recording ----

void SessionEngine::forget_history() {
  parts_->history.keep_at_most(0);
}

void SessionEngine::keep_history(std::shared_ptr<HistoryKeeper> keeper) {
  parts_->keeper = std::move(keeper);
  if (parts_->recorder) parts_->keeper->rest(parts_->recorder->store());
  parts_->history.set_store(joined_stores(parts_->opened, parts_->keeper->store()));
  push(AttachListener{std::make_shared<FromTheStart>(parts_->keeper, parts_->history)});
}

std::shared_ptr<HistoryKeeper> SessionEngine::history_keeper() const {
  return parts_->keeper;
}

Status SessionEngine::record(const std::string& path, const RecordingFacts& facts) {
  if (parts_->recorder)
    return Error{"is being recorded already; stop that first", parts_->recorder->state().path};
  RecordingFacts complete = facts;
  if (!complete.library) complete.library = parts_->views->library();
  if (!parts_->lent_source.valid()) parts_->own_input = facts.input;
  complete.input = parts_->own_input;  // frames of a lent source name their input
  complete.fingerprints = parts_->fingerprints;
  auto opened = parts_->openers.recorder(path, complete);
  if (!opened) return opened.error();
  parts_->recorder = std::move(*opened);
  parts_->gate = std::make_shared<ListenerGate>(parts_->recorder);
  if (parts_->keeper)
    parts_->keeper->rest(parts_->recorder->store());
  else
    parts_->history.set_store(joined_stores(parts_->history.store(), parts_->recorder->store()));
  push(AttachListener{parts_->gate});
  if (parts_->receiver) parts_->record_poses_of(*parts_->receiver);
  return Done{};
}

std::shared_ptr<Recorder> SessionEngine::recorder() const {
  return parts_->recorder;
}

Status SessionEngine::stop_recording() {
  const std::shared_ptr<Recorder> recorder = release_recorder();
  return recorder ? recorder->finish() : Status(Done{});
}

std::shared_ptr<Recorder> SessionEngine::release_recorder() {
  if (!parts_->recorder) return nullptr;
  parts_->stop_recording_poses();
  if (parts_->keeper) (void)parts_->keeper->go_on();  // its state says why it does not
  parts_->gate->shut();
  push(DetachListener{parts_->gate});
  parts_->gate.reset();
  return std::exchange(parts_->recorder, nullptr);
}

}  // namespace abrazo
