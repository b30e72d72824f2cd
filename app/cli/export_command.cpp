#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "app/cli/character_option.hpp"
#include "app/cli/command_line.hpp"
#include "app/cli/motion_reading.hpp"
#include "app/cli/text_lines.hpp"
#include "core/base/json_text.hpp"
#include "core/base/output_file.hpp"
#include "core/opening/library_search.hpp"
#include "core/session/export/exporting.hpp"

namespace abrazo::app {

namespace {

/// Options of `abrazo export`.
struct ExportWords {
  std::string session, library, performer;
  WrittenSpace space;
  std::vector<std::string> what;
  std::optional<long long> frame;
  ExportWish wish;
  bool json = false;
};

ExportContent content_of(const std::string& what) {
  return what == "mesh"     ? ExportContent::Mesh
         : what == "labels" ? ExportContent::Labels
         : what == "trace"  ? ExportContent::Trace
                            : ExportContent::Motion;
}

Result<ExportWish> wish_of(const ExportWords& words) {
  ExportWish wish = words.wish;
  wish.content = content_of(words.what.front());
  for (const std::string& what : words.what) {
    if (words.what.size() > 1 && content_of(what) != ExportContent::Motion)
      return Error{"user, active and passive can share a file; " + what + " needs one of its own",
                   wish.output};
    wish.bodies.push_back(what == "user"     ? SessionBody::User
                          : what == "active" ? SessionBody::Active
                                             : SessionBody::Passive);
  }
  if (!words.performer.empty()) wish.performer = words.performer;
  if (wish.performer && words.what != std::vector<std::string>{"user"})
    return Error{"--performer is for --what user: the poses as they were received", words.session};
  if ((wish.at_s || words.frame) && wish.content != ExportContent::Mesh)
    return Error{"--time and --frame choose the frame of a mesh; use --from and --to", words.session};
  if (words.frame && *words.frame < 0)
    return Error{fmt::format("has no frame {}; they count from 0", *words.frame), words.session};
  if (words.frame) wish.at_frame = static_cast<std::uint64_t>(*words.frame);
  auto space = file_space(words.space);
  if (!space) return space.error();
  wish.space = std::move(*space);
  return wish;
}

/// Opens a session file; warns about damage by a crash and running recording.
Result<std::shared_ptr<const SessionFile>> file_of(CommandLine& line, const std::string& path) {
  auto file = SessionFile::open(path);
  if (!file) return file.error();
  for (const std::string& sentence : (*file)->recovery()) warn(line, path + ": " + sentence);
  if ((*file)->is_being_recorded())
    warn(line, path + ": is still being recorded; this is what it has by now");
  return file;
}

void tell(CommandLine& line, const ExportWords& words, ExportReport& exported) {
  for (const Warning& warning : exported.warnings) warn(line, warning);
  if (words.json) {
    JsonText json;
    json.begin_object().key("what").begin_array();
    for (const std::string& what : words.what) json.value(what);
    json.end_array().key("files").begin_array();
    for (const std::string& path : exported.files) json.value(path);
    json.end_array();
    answer_json(line, json.take() + "," + exported.figures.take() + "}");
  } else if (!line.quiet) {
    TextLines text;
    text.add("{}: {}{}", exported.files.back(), exported.text,
             exported.files.size() > 1 ? fmt::format(", {} files", exported.files.size()) : "");
    answer(line, text.take());
  }
}

Status run_export(CommandLine& line, const ExportWords& words) {
  const auto wish = wish_of(words);
  if (!wish) return wish.error();
  if (const Status checked = check_export(*wish); !checked) return checked;
  for (const std::string& output : wish->files())
    if (const Status usable = check_output(output, {words.session, words.library, wish->character}); !usable)
      return usable;
  const auto file = file_of(line, words.session);
  if (!file) return file.error();
  const auto source =
      export_of_file(*file, library_opener(*file, words.library, "; --library LIB says where it is"));
  auto exported = export_session(*source, *wish, terminal_progress(line));
  if (!exported) return exported.error();
  tell(line, words, *exported);
  return Done{};
}

void add_options(CLI::App& command, ExportWords& words) {
  ExportWish& wish = words.wish;
  command.add_option("session", words.session, "session file that was recorded")
      ->required()
      ->type_name("S.abrazo");
  command
      .add_option("--what", words.what, "user, active, passive (several with commas), mesh, labels or trace")
      ->required()
      ->delimiter(',')
      ->expected(1)
      ->allow_extra_args(false)  // otherwise it also takes the words that follow
      ->take_all()
      ->check(CLI::IsMember({"user", "active", "passive", "mesh", "labels", "trace"}))
      ->type_name("WHAT");
  CLI::Option* output =
      command
          .add_option(
              "-o,--output", wish.output,
              "bodies: .bvh, .glb, .csv, .npz or .npy; mesh: .vtu or .pvd; labels: .eaf, .csv, .json, "
              ".TextGrid or .txt; trace: .jsonl")
          ->required()
          ->type_name("FILE");
  add_character_option(command, wish.character, output, "OUT_user, OUT_active and OUT_passive");
  command.add_option("--take", wish.part.take, "only this take")->type_name("NAME");
  command.add_option("--from", wish.part.from_s, "from this time of the session on [s]")->type_name("T");
  command.add_option("--to", wish.part.to_s, "up to this time of the session [s]")->type_name("T");
  CLI::Option* time =
      command.add_option("--time", wish.at_s, "mesh: of the frame shown at this time [s]")->type_name("T");
  command.add_option("--frame", words.frame, "mesh: of the frame of this index")
      ->type_name("N")
      ->excludes(time);
  command
      .add_option("--performer", words.performer, "user: all poses received of this performer, solved or not")
      ->type_name("NAME");
  command
      .add_option("--rate", wish.rate_hz,
                  "poses per second; by default that of the frames. For a mesh series: the maximum")
      ->check(above_zero)
      ->type_name("HZ");
  add_space_options(command, words.space);
  command.add_option("--library", words.library, "mesh, trace: the library, if it was moved")
      ->type_name("LIB");
  command.add_flag("--json", words.json, "what was written as one JSON object on stdout");
}

}  // namespace

void add_export_command(CommandLine& line) {
  auto words = std::make_shared<ExportWords>();
  CLI::App* command =
      line.app.add_subcommand("export", "bodies, meshes, labels or the trace of a recorded session as files");
  add_options(*command, *words);
  command->callback([&line, words] {
    if (const Status done = run_export(line, *words); !done) fail(line, done.error());
  });
}

}  // namespace abrazo::app
