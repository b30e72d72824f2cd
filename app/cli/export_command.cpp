#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>

#include "app/cli/command_line.hpp"
#include "app/cli/export_parts.hpp"
#include "app/cli/output_file.hpp"
#include "app/cli/session_reading.hpp"

namespace abrazo::app {

namespace {

enum class Content { Motion, Mesh, Labels, Trace };

/// What a word of --what is, and the file types it can be written as.
struct ContentKind {
  Content content;
  std::string name;  ///< in messages
  std::vector<std::string> extensions;
};

const ContentKind& kind_of(const std::string& what) {
  static const ContentKind motion{Content::Motion, "motion", {".bvh", ".glb", ".csv"}};
  static const std::map<std::string, ContentKind> others = {
      {"mesh", {Content::Mesh, "meshes", {".vtu", ".pvd"}}},
      {"labels", {Content::Labels, "labels", {".eaf", ".csv", ".json"}}},
      {"trace", {Content::Trace, "a trace", {".jsonl"}}}};
  const auto found = others.find(what);
  return found == others.end() ? motion : found->second;
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  return text;
}

/// Whether the words fit together: a motion cannot be a mesh file, a trace has no performer.
Status check_wish(const ExportWish& wish) {
  const ContentKind& kind = kind_of(wish.what.front());
  for (const std::string& what : wish.what)
    if (wish.what.size() > 1 && kind_of(what).content != Content::Motion)
      return Error{"user, active and passive can share a file; " + what + " needs one of its own",
                   wish.output};
  for (std::size_t i = 0; i < wish.what.size(); ++i)
    if (std::find(wish.what.begin(), wish.what.begin() + static_cast<std::ptrdiff_t>(i), wish.what[i]) !=
        wish.what.begin() + static_cast<std::ptrdiff_t>(i))
      return Error{wish.what[i] + " is asked for twice", wish.output};
  const bool fits = std::any_of(kind.extensions.begin(), kind.extensions.end(),
                                [&](const std::string& end) { return wish.output.ends_with(end); });
  if (!fits)
    return Error{kind.name + " cannot be written as this file type; use " + listed(kind.extensions),
                 wish.output};
  if (!wish.performer.empty() && wish.what != std::vector<std::string>{"user"})
    return Error{"--performer is for --what user: the poses as they were received", wish.session};
  if ((wish.time_s || wish.frame) && kind.content != Content::Mesh)
    return Error{"--time and --frame choose the frame of a mesh; use --from and --to", wish.session};
  if ((wish.time_s || wish.frame) && wish.output.ends_with(".pvd"))
    return Error{"a .pvd is a series; write the one frame as .vtu", wish.output};
  if (wish.rate_hz > 0 && kind.content == Content::Trace)
    return Error{"a trace has the frames as they were solved; leave --rate out", wish.session};
  return Done{};
}

Result<Exported> exported_content(CommandLine& line, const SessionFile& file, const ExportWish& wish) {
  switch (kind_of(wish.what.front()).content) {
    case Content::Mesh:
      return export_mesh(line, file, wish);
    case Content::Labels:
      return export_labels(line, file, wish);
    case Content::Trace:
      return export_trace(line, file, wish);
    case Content::Motion:
      break;
  }
  return export_motion(line, file, wish);
}

Status run_export(CommandLine& line, const ExportWish& wish) {
  if (const Status checked = check_wish(wish); !checked) return checked;
  if (const Status usable = check_output(wish.output, {wish.session, wish.library}); !usable) return usable;
  const auto file = open_session(line, wish.session);
  if (!file) return file.error();
  auto exported = exported_content(line, **file, wish);
  if (!exported) return exported.error();
  if (wish.json) {
    JsonText json;
    json.begin_object().key("what").begin_array();
    for (const std::string& what : wish.what) json.value(what);
    json.end_array().key("files").begin_array();
    for (const std::string& path : exported->files) json.value(path);
    json.end_array();
    answer(line, json.take() + "," + exported->figures.take() + "}\n");
  } else if (!line.quiet) {
    const std::string& name = exported->files.back();
    answer(line,
           fmt::format("{}: {}{}\n", name, exported->text,
                       exported->files.size() > 1 ? fmt::format(", {} files", exported->files.size()) : ""));
  }
  return Done{};
}

void add_options(CLI::App& command, ExportWish& wish) {
  command.add_option("session", wish.session, "session file that was recorded")
      ->required()
      ->type_name("S.abrazo");
  command
      .add_option("--what", wish.what, "user, active, passive (several with commas), mesh, labels or trace")
      ->required()
      ->delimiter(',')
      ->expected(1)
      ->allow_extra_args(false)  // otherwise it also takes the words that follow
      ->take_all()
      ->check(CLI::IsMember({"user", "active", "passive", "mesh", "labels", "trace"}))
      ->type_name("WHAT");
  command
      .add_option(
          "-o,--output", wish.output,
          "bodies: .bvh, .glb or .csv; mesh: .vtu or .pvd; labels: .eaf, .csv or .json; trace: .jsonl")
      ->required()
      ->type_name("FILE");
  command.add_option("--take", wish.part.take, "only this take")->type_name("NAME");
  command.add_option("--from", wish.part.from_s, "from this time of the session on [s]")->type_name("T");
  command.add_option("--to", wish.part.to_s, "up to this time of the session [s]")->type_name("T");
  CLI::Option* time =
      command.add_option("--time", wish.time_s, "mesh: of the frame shown at this time [s]")->type_name("T");
  command.add_option("--frame", wish.frame, "mesh: of the frame of this index")
      ->type_name("N")
      ->excludes(time);
  command
      .add_option("--performer", wish.performer, "user: all poses received of this performer, solved or not")
      ->type_name("NAME");
  command
      .add_option("--rate", wish.rate_hz,
                  "poses a second; by default that of the frames. Of a mesh series: at most so many")
      ->check(above_zero)
      ->type_name("HZ");
  command.add_option("--library", wish.library, "mesh, trace: the library, when it is not where it was")
      ->type_name("LIB");
  command.add_flag("--json", wish.json, "what was written as one JSON object on stdout");
}

}  // namespace

void add_export_command(CommandLine& line) {
  auto wish = std::make_shared<ExportWish>();
  CLI::App* command =
      line.app.add_subcommand("export", "bodies, meshes, labels or the trace of a recorded session as files");
  add_options(*command, *wish);
  command->callback([&line, wish] {
    if (const Status done = run_export(line, *wish); !done) fail(line, done.error());
  });
}

}  // namespace abrazo::app
