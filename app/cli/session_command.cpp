#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "app/cli/command_line.hpp"
#include "app/cli/text_lines.hpp"
#include "core/base/json_text.hpp"
#include "core/opening/opened_session.hpp"
#include "core/session/file/session_schema.hpp"

namespace abrazo::app {

namespace {

struct SessionInfoArguments {
  std::string session;
  bool json = false;
};

std::string_view state_text(FoundData::State state) {
  constexpr std::array<std::string_view, 3> texts = {"found", "changed", "missing"};
  return texts[static_cast<std::size_t>(state)];
}

std::size_t count_of(const Annotations& annotations) {
  std::size_t count = 0;
  for (const AnnotationTier& tier : annotations.tiers()) count += tier.annotations.size();
  return count;
}

std::string part_name(const std::string& subject) {
  return subject.empty() ? "the session" : subject;
}

std::string as_text(const OpenedSession& session) {
  const SessionContents& contents = session.recording.contents;
  const ProjectReading& reading = session.project->reading;
  const Project& project = reading.project;
  TextLines text;
  text.add("{}", session.project->file);
  text.add("  version    {}{}", session_schema_version,
           session.recording.is_being_recorded ? ", is being recorded" : "");
  text.add("  saved      {}", reading.is_saved ? reading.saved_at : "never as a project");
  text.add("  recorded   {} frames, {:.3f} s, in {} part(s)", contents.frames,
           contents.last_s - contents.first_s, contents.runs.size());
  for (const SessionTake& take : contents.takes)
    text.add("  take       {}, {:.3f} to {:.3f} s, frames {} to {}{}", take.name, take.start_s, take.end_s,
             take.first_frame, take.last_frame, take.interrupted ? ", not ended" : "");
  text.add("  markers    {}", project.markers.all().size());
  for (const auto& [subject, annotations] : project.annotations) {
    const std::size_t suggested = annotations.suggestions().size();
    text.add("  annotated  {}: {} in {} tiers{}", part_name(subject), count_of(annotations),
             annotations.tiers().size(),
             suggested > 0 ? fmt::format(", {} suggested", suggested) : std::string());
  }
  for (std::size_t i = 0; i < session.project->found.size(); ++i) {
    const FoundData& found = session.project->found[i];
    text.add("  {:<10} {}: {}", text_of(project.data[i].use), state_text(found.state),
             found.path.empty() ? fmt::format("{}", fmt::join(found.looked, ", ")) : found.path);
  }
  for (const std::string& sentence : session.recording.recovery) text.add("  note       {}", sentence);
  for (const std::string& sentence : reading.damage) text.add("  damaged    {}", sentence);
  return text.take();
}

void write_takes(JsonText& json, const SessionContents& contents) {
  json.key("takes").begin_array();
  for (const SessionTake& take : contents.takes)
    json.begin_object()
        .key("name")
        .value(take.name)
        .key("start_s")
        .value(take.start_s)
        .key("end_s")
        .value(take.end_s)
        .key("frames")
        .value(static_cast<long long>(take.last_frame + 1 - take.first_frame))
        .key("ended")
        .value(!take.interrupted)
        .end_object();
  json.end_array();
}

void write_annotations(JsonText& json, const Project& project) {
  json.key("annotations").begin_array();
  for (const auto& [subject, annotations] : project.annotations) {
    json.begin_object().key("subject").value(subject).key("tiers").begin_array();
    for (const AnnotationTier& tier : annotations.tiers())
      json.begin_object()
          .key("name")
          .value(tier.name)
          .key("annotations")
          .value(static_cast<long long>(tier.annotations.size()))
          .end_object();
    json.end_array()
        .key("suggestions")
        .value(static_cast<long long>(annotations.suggestions().size()))
        .end_object();
  }
  json.end_array();
}

void write_data(JsonText& json, const OpenedSession& session) {
  json.key("data").begin_array();
  for (std::size_t i = 0; i < session.project->found.size(); ++i) {
    json.begin_object()
        .key("use")
        .value(text_of(session.project->project().data[i].use))
        .key("state")
        .value(state_text(session.project->found[i].state))
        .key("path")
        .value(session.project->found[i].path)
        .key("looked")
        .begin_array();
    for (const std::string& place : session.project->found[i].looked) json.value(place);
    json.end_array().end_object();
  }
  json.end_array();
}

std::string as_json(const OpenedSession& session) {
  const SessionContents& contents = session.recording.contents;
  const ProjectReading& reading = session.project->reading;
  JsonText json;
  json.begin_object().key("version").value(static_cast<long long>(session_schema_version));
  json.key("saved_at").value(reading.saved_at);
  json.key("is_being_recorded").value(session.recording.is_being_recorded);
  json.key("recordings").value(static_cast<long long>(contents.runs.size()));
  json.key("frames").value(static_cast<long long>(contents.frames));
  json.key("seconds").value(contents.last_s - contents.first_s);
  json.key("markers").value(static_cast<long long>(reading.project.markers.all().size()));
  json.key("videos").value(static_cast<long long>(reading.project.videos.size()));
  write_takes(json, contents);
  write_annotations(json, reading.project);
  write_data(json, session);
  json.key("damaged_rows").value(static_cast<long long>(reading.damaged)).key("notes").begin_array();
  for (const std::string& sentence : session.recording.recovery) json.value(sentence);
  for (const std::string& sentence : reading.damage) json.value(sentence);
  return json.end_array().end_object().take();
}

void run_info(CommandLine& line, const SessionInfoArguments& arguments) {
  const auto session = open_session(arguments.session);
  if (!session) return fail(line, session.error());
  if (arguments.json)
    answer_json(line, as_json(*session));
  else
    answer(line, as_text(*session));
}

}  // namespace

void add_session_command(CommandLine& line) {
  CLI::App* session = line.app.add_subcommand("session", "show session files");
  session->require_subcommand(1);
  CLI::App* info = session->add_subcommand(
      "info", "version, recordings, takes, annotations, and the referenced files with their paths");
  const auto arguments = std::make_shared<SessionInfoArguments>();
  info->add_option("session", arguments->session, "session file")->required()->type_name("S.abrazo");
  info->add_flag("--json", arguments->json, "as one JSON object on stdout");
  info->callback([&line, arguments] { run_info(line, *arguments); });
}

}  // namespace abrazo::app
