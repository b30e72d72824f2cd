#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>
#include <thread>

#include "app/cli/command_line.hpp"
#include "app/cli/interruption.hpp"
#include "app/cli/live_report.hpp"
#include "app/cli/motion_reading.hpp"
#include "app/cli/settings_options.hpp"
#include "core/base/output_file.hpp"
#include "core/library/store/motion_library_file.hpp"
#include "core/session/file/session_file.hpp"
#include "core/session/run/session_engine.hpp"
#include "core/stream/receive/clip_source.hpp"
#include "core/stream/receive/silent_source.hpp"
#include "core/synthesis/step/role_views.hpp"

namespace abrazo::app {

namespace {

constexpr double between_looks_s = 0.1;  ///< so soon an interruption is noticed
constexpr double between_reports_s = 0.5;

struct LiveOptions {
  std::string library, record, take, role_control = "hand";
  std::vector<std::string> listen, send, send_user, excluded;
  MotionReading clip;  ///< how the motion of `clip:FILE` is read
  SettingsOptions settings;
  double seconds = 0, calibrate_after_s = 0;
  bool json = false;
};

/// Checks the options before anything is opened.
struct LivePlan {
  StreamUri listen;
  std::vector<StreamUri> send, send_user;
  Settings settings;
};

Result<std::vector<StreamUri>> sinks_of(const std::vector<std::string>& texts) {
  std::vector<StreamUri> uris;
  for (const std::string& text : texts) {
    auto uri = parse_stream_uri(text);
    if (!uri) return uri.error();
    if (uri->scheme == StreamUri::Scheme::Clip)
      return Error{"a clip is no place to send to; --record and abrazo export write files", text};
    if (const Status usable = check_stream_options(*uri, StreamDirection::Send); !usable)
      return usable.error();
    uris.push_back(std::move(*uri));
  }
  return uris;
}

/// An Error for options of the other kind of input: nothing is ignored silently.
Status check_words_of_input(const LiveOptions& options, const StreamUri& listen) {
  const MotionReading& clip = options.clip;
  const bool is_clip = listen.scheme == StreamUri::Scheme::Clip;
  if (is_clip && options.calibrate_after_s > 0)
    return Error{"--calibrate is for streams; a clip is measured as a whole", listen.text};
  if (!is_clip &&
      (!clip.skeleton.empty() || !clip.joint_map.empty() || !clip.up.empty() || clip.metres_per_unit ||
       clip.fps || !clip.performer.empty() || !clip.animation.empty() || !clip.body_model.empty()))
    return Error{
        "--skeleton, --metres-per-unit, --fps, --joint-map, --up, --performer, --animation and --body-model "
        "are for "
        "clip:FILE; "
        "a stream has options in its URI, such as ?performer=NAME, ?map=FILE.json, ?up=z",
        listen.text};
  return Done{};
}

Result<LivePlan> plan_of(const LiveOptions& options) {
  if (options.listen.size() > 1) return Error{"one stream plays the user; name one", options.listen.back()};
  auto listen = parse_stream_uri(options.listen.front());
  if (!listen) return listen.error();
  if (const Status usable = check_stream_options(*listen, StreamDirection::Listen); !usable)
    return usable.error();
  if (const Status fits = check_words_of_input(options, *listen); !fits) return fits.error();
  auto send = sinks_of(options.send), send_user = sinks_of(options.send_user);
  if (!send) return send.error();
  if (!send_user) return send_user.error();
  for (const std::vector<StreamUri>* uris : {&*send, &*send_user})
    for (const StreamUri& uri : *uris)
      if (const Status away = check_no_loop(*listen, uri); !away) return away.error();
  auto settings = options.settings.read();
  if (!settings) return settings.error();
  if (!options.record.empty())
    if (const Status usable = check_output(options.record, {options.library, listen->file}); !usable)
      return usable.error();
  return LivePlan{std::move(*listen), std::move(*send), std::move(*send_user), std::move(*settings)};
}

/// The clip that plays the user; null for a stream.
Result<std::shared_ptr<ClipSource>> clip_of(CommandLine& line, const LiveOptions& options,
                                            const StreamUri& uri) {
  if (uri.scheme != StreamUri::Scheme::Clip) return std::shared_ptr<ClipSource>();
  MotionReading reading = options.clip;
  reading.file = uri.file;
  auto clip = read_performer(line, reading);
  if (!clip) return clip.error();
  if (clip->clip.poses.empty()) return Error{"has no frames", uri.file};
  const double rate_hz = clip->clip.fps;
  return std::make_shared<ClipSource>(std::move(clip->clip), rate_hz, false);
}

/// "take 1", or the first number that a file which is gone on in does not have.
std::string free_take_name(const std::string& path) {
  std::error_code ignored;
  std::vector<SessionTake> takes;
  if (std::filesystem::exists(path, ignored))
    if (const auto file = SessionFile::open(path); file) takes = (*file)->contents().takes;
  for (int number = 1;; ++number) {
    std::string name = fmt::format("take {}", number);
    const auto has_name = [&](const SessionTake& take) { return take.name == name; };
    if (std::none_of(takes.begin(), takes.end(), has_name)) return name;
  }
}

Status start_recording(SessionEngine& engine, const LiveOptions& options,
                       const std::shared_ptr<const MotionLibrary>& library) {
  const std::string take = options.take.empty() ? free_take_name(options.record) : options.take;
  RecordingFacts facts;
  facts.library_path = options.library;
  facts.library_name = library->name();
  facts.library_pairs = static_cast<std::uint64_t>(library->pair_count());
  facts.input = options.listen.front();
  facts.library = library;
  facts.excluded_takes = options.excluded;
  if (const Status recorded = engine.record(options.record, facts); !recorded) return recorded;
  engine.recorder()->begin_take(take);
  return Done{};
}

RoleControl role_control_of(const std::string& word) {
  return word == "library"  ? RoleControl::Library
         : word == "leader" ? RoleControl::Leader
                            : RoleControl::Hand;
}

/// Everything is attached before the first pose, so that nothing of it is missed.
Status open_all(SessionEngine& engine, const LiveOptions& options, const LivePlan& plan,
                const std::shared_ptr<const MotionLibrary>& library) {
  engine.forget_history();
  if (const Status set = engine.control_role(role_control_of(options.role_control)); !set) return set;
  for (const StreamUri& uri : plan.send)
    if (const Status sent = engine.send(uri, Character::Partner); !sent) return sent;
  for (const StreamUri& uri : plan.send_user)
    if (const Status sent = engine.send(uri, Character::User); !sent) return sent;
  std::error_code ignored;
  const bool is_new_file = !std::filesystem::exists(options.record, ignored);
  if (!options.record.empty())
    if (const Status recorded = start_recording(engine, options, library); !recorded) return recorded;
  if (plan.listen.scheme == StreamUri::Scheme::Clip) return Done{};
  const Status open = engine.receive(plan.listen, plan.listen.option("performer"));
  if (!open && engine.recorder()) {
    [[maybe_unused]] const Status ended = engine.stop_recording();  // the error is about the port
    if (is_new_file) std::filesystem::remove(options.record, ignored);
  }
  return open;
}

/// Keeps every diagnosis, and prints it when it first comes.
void note_diagnoses(CommandLine& line, const StreamHealth& health, std::vector<LiveEnd::Diagnosis>& seen) {
  for (const StreamDiagnosis& diagnosis : health.diagnoses) {
    const auto known = std::find_if(seen.begin(), seen.end(),
                                    [&](const auto& before) { return before.newest.kind == diagnosis.kind; });
    if (known != seen.end()) {
      known->last_s = health.taken_s;
      known->newest = diagnosis;
      continue;
    }
    seen.push_back({health.taken_s, health.taken_s, diagnosis});
    if (diagnosis.severity != StreamDiagnosis::Severity::Note) warn(line, diagnosis.text);
  }
}

/// Until it was long enough, the clip is over or someone interrupts. @return the diagnoses that there were
std::vector<LiveEnd::Diagnosis> run(CommandLine& line, const LiveOptions& options, SessionEngine& engine,
                                    const ClipSource* clip, const LiveReport& live) {
  const SessionClock& clock = engine.clock();
  const double start_s = clock.now_s();
  double end_s = options.seconds > 0 ? start_s + options.seconds : std::numeric_limits<double>::infinity();
  if (clip) end_s = std::min(end_s, start_s + clip->clip().duration_s());
  std::vector<LiveEnd::Diagnosis> diagnoses;
  std::string told_failure;  ///< of the recording
  bool is_calibrated = options.calibrate_after_s <= 0;
  double next_report_s = start_s + between_reports_s;
  while (!interrupted()) {
    const double now_s = clock.now_s();
    if (now_s >= end_s) break;
    const auto receiver = engine.receiver();
    if (!is_calibrated && receiver && now_s >= start_s + options.calibrate_after_s) {
      receiver->calibrate({});
      is_calibrated = true;
    }
    if (now_s >= next_report_s) {
      next_report_s = now_s + between_reports_s;
      if (receiver) note_diagnoses(line, receiver->health(), diagnoses);
      if (const auto recorder = engine.recorder())
        if (const std::string failure = recorder->state().failure; failure != told_failure) {
          told_failure = failure;
          warn(line, failure.empty() ? "recording continues" : "recording: " + failure);
        }
      show_state(line, live.line(now_s - start_s));
    }
    std::this_thread::sleep_until(clock.at(std::min(now_s + between_looks_s, end_s)));
  }
  clear_progress(line);
  return diagnoses;
}

/// Stops everything. @return why the recording is incomplete
Status end_session(CommandLine& line, SessionEngine& engine, const std::shared_ptr<ClipSource>& clip,
                   LiveEnd& end) {
  if (const auto receiver = engine.receiver()) {
    end.stream = receiver->health();
    note_diagnoses(line, *end.stream, end.diagnoses);
  }
  engine.stop_receiving();
  // Until the solver has let go of the clip, a frame may still be under way.
  while (clip && clip.use_count() > 1) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  Status written = Done{};
  if (const auto recorder = engine.recorder()) {
    recorder->end_take();
    written = engine.stop_recording();
    end.recording = recorder->state();
  }
  end.sinks = engine.sinks();
  return written;
}

/// The reason why no frame was solved.
Error nothing_solved(const LiveEnd& end, const LiveReport& live, const StreamUri& uri) {
  if (const std::string failure = live.latest_failure(); !failure.empty()) return {failure, uri.text};
  if (end.stream && !end.stream->diagnoses.empty()) return {end.stream->diagnoses.front().text, uri.text};
  if (!end.diagnoses.empty()) return {end.diagnoses.back().newest.text, uri.text};
  return {"no pose came in", uri.text};
}

/// A session would select by Eq. 7 until the library is learned; so it is done before the session starts.
Status learn(CommandLine& line, const PartnerSynthesizer& synthesizer, const Settings& settings) {
  if (settings.selection != SelectionMethod::Intent) return Done{};
  show_state(line, "learning the library");
  try {
    synthesizer.views()->intent(settings.user_role);
  } catch (const std::bad_alloc&) {
    clear_progress(line);
    return Error{"there is not enough memory to learn the library", synthesizer.library().name()};
  } catch (const std::runtime_error& failure) {
    clear_progress(line);
    return Error{failure.what(), synthesizer.library().name()};
  }
  clear_progress(line);
  return Done{};
}

Status run_live(CommandLine& line, const LiveOptions& options) {
  const auto plan = plan_of(options);
  if (!plan) return plan.error();
  auto library_file = read_library(options.library);
  if (!library_file) return library_file.error();
  const auto library = std::make_shared<const MotionLibrary>(std::move(*library_file));
  const auto clip = clip_of(line, options, plan->listen);
  if (!clip) return clip.error();
  auto synthesizer = PartnerSynthesizer::create(library, plan->settings, options.excluded);
  if (!synthesizer) return synthesizer.error();

  if (const Status learned = learn(line, **synthesizer, plan->settings); !learned) return learned;

  SessionEngine engine(std::move(*synthesizer), std::make_shared<SilentSource>());
  const auto live = std::make_shared<LiveReport>();
  engine.push(AttachListener{live});
  if (const Status opened = open_all(engine, options, *plan, library); !opened) return opened;
  if (const auto receiver = engine.receiver())
    note(line, "listening " + listening_words(receiver->health().listening));
  const double start_s = engine.clock().now_s();
  if (*clip) {
    (*clip)->seek(0, start_s);
    engine.push(ReplaceSource{*clip});
  }
  LiveEnd end;
  end.diagnoses = run(line, options, engine, clip->get(), *live);
  end.seconds = engine.clock().now_s() - start_s;
  const Status written = end_session(line, engine, *clip, end);
  engine.push(DetachListener{live});
  if (options.json)
    answer_json(line, live->json(end));
  else if (!line.quiet)
    answer(line, live->text(end));
  if (!written) return written;
  return live->solved() > 0 ? Status(Done{}) : nothing_solved(end, *live, plan->listen);
}

void add_options(CLI::App& live, LiveOptions& options) {
  const auto list = [&](const char* name, std::vector<std::string>& texts, const char* help) {
    return live.add_option(name, texts, help)->expected(1)->allow_extra_args(false)->take_all();
  };
  live.add_option("--library", options.library, "motion library (abrazo library build)")
      ->required()
      ->type_name("LIB");
  list("--listen", options.listen,
       "where the user's poses come from: vmc://HOST:PORT, natnet://HOST[:PORT][?multicast=GROUP], "
       "xsens://HOST:PORT, clip:FILE; without HOST only packets of this machine are accepted (127.0.0.1), "
       "with "
       "HOST 0.0.0.0 "
       "every network")
      ->required()
      ->type_name("URI");
  list("--send", options.send,
       "address that the partner is sent to, such as vmc://127.0.0.1:39540; may be repeated")
      ->type_name("URI");
  list("--send-user", options.send_user,
       "address that the user, as received by the solver, is sent to; may be repeated")
      ->type_name("URI");
  CLI::Option* record = live.add_option("--record", options.record,
                                        "everything into a session file; an existing one is continued")
                            ->type_name("S.abrazo");
  live.add_option("--take", options.take, "name of the recorded take; by default take 1, take 2, ...")
      ->needs(record)
      ->type_name("NAME");
  live.add_option("--seconds", options.seconds, "end after this time; else at Ctrl-C, or with the clip")
      ->check(above_zero)
      ->type_name("N");
  live.add_option("--calibrate", options.calibrate_after_s,
                  "measure the user, who stands in the T-pose after this many seconds")
      ->check(above_zero)
      ->type_name("S");
  live.add_option("--role-control", options.role_control,
                  "who decides the user's role: hand (the setting user-role), library or leader")
      ->check(CLI::IsMember({"hand", "library", "leader"}))
      ->type_name("WORD")
      ->capture_default_str();
  list("--exclude", options.excluded, "a take that is never selected; may be repeated")->type_name("TAKE");
  live.add_flag("--json", options.json, "the statistics as one JSON object on stdout");
  options.settings.add_to(live);
}

}  // namespace

void add_live_command(CommandLine& line) {
  auto options = std::make_shared<LiveOptions>();
  CLI::App* live = line.app.add_subcommand(
      "live", "a stream in, the partner out: the live loop without a window, with statistics at the end");
  add_options(*live, *options);
  add_reading_options(*live, options->clip);
  for (const char* name : {"--skeleton", "--metres-per-unit", "--fps", "--joint-map", "--up", "--performer",
                           "--animation", "--body-model"})
    live->get_option(name)->group("How clip:FILE is read");
  live->callback([&line, options] {
    if (const Status done = run_live(line, *options); !done) fail(line, done.error());
  });
}

}  // namespace abrazo::app
