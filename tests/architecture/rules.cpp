#include "tests/architecture/rules.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <regex>

namespace abrazo::test {
namespace {

std::string at(const SourceFile& file, int line, const std::string& why) {
  return file.path + ":" + std::to_string(line) + ": " + why;
}

/// Runs `why(file, include)` on every include of every C++ file under `folder`; a text that is not empty is a
/// violation.
template <typename Why>
Violations check_includes(std::span<const SourceFile> files, std::string_view folder, Why why) {
  Violations found;
  for (const SourceFile& file : files) {
    if (!file.is_under(folder) || !file.is_cpp()) continue;
    for (const Include& include : includes_of(file)) {
      const std::string text = why(file, include.path);
      if (!text.empty()) found.push_back(at(file, include.line, text));
    }
  }
  return found;
}

/// "mesh" of "core/mesh/capsules.hpp"; empty when there is no second folder.
std::string second_folder(std::string_view path) {
  const std::size_t begin = path.find('/') + 1;
  if (begin == 0) return {};
  const std::size_t end = path.find('/', begin);
  return end == std::string_view::npos ? std::string() : std::string(path.substr(begin, end - begin));
}

/// "core/stream" of "core/stream/vmc/osc_packet.hpp".
std::string folder_with_rooms(std::string_view path) {
  const std::string second = second_folder(path);
  return second.empty() ? std::string() : std::string(path.substr(0, path.find('/') + 1)) + second;
}

/// "vmc" of "core/stream/vmc/osc_packet.hpp"; empty when it stands in no room.
std::string room_of(std::string_view path) {
  return second_folder(path.substr(path.find('/') + 1));
}

bool is_qt(const std::string& include) {
  static const std::regex qt(R"re(^(Q[A-Z]|Qt[A-Z][A-Za-z]*/|qcustomplot))re");
  return std::regex_search(include, qt);
}

bool is_vtk(const std::string& include) {
  return include.starts_with("vtk") || include.starts_with("QVTK");
}

/// A third party and the only place that may know it: a file, a folder (ends in '/'), or files that begin
/// alike (ends in '_'). Without a place it is any one source file.
struct ThirdParty {
  std::string_view name;
  const char* includes;  ///< regular expression
  std::string_view place;
};

constexpr std::array third_parties = {
    ThirdParty{"TetGen", "^tetgen", "core/mesh/tetrahedralize.cpp"},
    ThirdParty{"FLANN", "^flann/", "core/library/store/flann_tree.cpp"},
    ThirdParty{"CGAL", "^CGAL/", "tests/"},  // judges TetGen's meshes
    ThirdParty{"HDF5", "^(hdf5|H5)", "core/library/store/hdf5_file.cpp"},
    ThirdParty{"OpenCV", "^opencv", "core/video/"},
    ThirdParty{"SQLite", "^sqlite3", ""},
    ThirdParty{"liblo", "^lo/", ""},
    ThirdParty{"pugixml", "^pugi", "core/library/takes/eaf_"},
    ThirdParty{"tinygltf", "^tiny_gltf", "core/motion/scenes/glb_writer.cpp"},
    ThirdParty{"assimp", "^assimp/", "core/motion/scenes/assimp_scene.cpp"},
    ThirdParty{"zlib", "^zlib", "core/motion/numpy/zip_archive.cpp"},
    ThirdParty{"CLI11", "^CLI/", "app/"},
    ThirdParty{"pybind11", "^(pybind11/|Python\\.h|numpy/)", "app/python/"},
    ThirdParty{"QCustomPlot", "^qcustomplot", "widgets/plots/"},
    ThirdParty{"VTK", "^(vtk|QVTK)", "widgets/scene/"},
};

/// @param first  the file that was seen to name a party without a fixed place; set when there was none
bool is_in_place(const SourceFile& file, std::string_view place, std::string& first) {
  if (place.ends_with('/')) return file.is_under(place);
  if (place.ends_with('_')) return file.path.starts_with(place);
  if (!place.empty()) return file.path == place;
  if (first.empty() && !file.is_header()) first = file.path;
  return file.path == first;
}

/// What a view may see of core: what was computed, what it can ask for, and plain values.
bool is_open_to_widgets(const std::string& include) {
  static const std::set<std::string> open = {"core/session/frames/comparison_plan.hpp",
                                             "core/session/frames/frame_gaps.hpp",
                                             "core/session/frames/frame_snapshot.hpp",
                                             "core/session/frames/frame_history.hpp",
                                             "core/session/frames/frame_in_library.hpp",
                                             "core/session/frames/command.hpp",
                                             "core/session/frames/decisions.hpp",
                                             "core/session/frames/decision_edits.hpp",
                                             "core/session/frames/frame_store.hpp",
                                             "core/stream/protocol/stream_health.hpp",
                                             "core/stream/protocol/stream_uri.hpp",
                                             "core/session/frames/latency.hpp",
                                             "core/session/frames/markers.hpp",
                                             "core/session/frames/settings_track.hpp",
                                             "core/session/frames/time_place.hpp",
                                             "core/session/frames/playback.hpp",
                                             "core/session/edit/recorded_takes.hpp",
                                             "core/session/edit/take_name.hpp",
                                             "core/session/edit/take_sequence.hpp",
                                             "core/annotation/annotations.hpp",
                                             "core/library/takes/tier.hpp",
                                             "core/video/camera_model.hpp",
                                             "core/video/video_frame.hpp",
                                             "core/video/video_sync.hpp",
                                             "core/synthesis/settings/settings.hpp",
                                             "core/synthesis/settings/preset_choice.hpp",
                                             "core/synthesis/frames/frame_result.hpp",
                                             "core/synthesis/step/look_ahead.hpp",
                                             "core/library/store/motion_library.hpp",
                                             "core/library/store/normalization.hpp",
                                             "core/selection/candidate.hpp",
                                             "core/selection/frame_intent.hpp",
                                             "core/selection/intent_model.hpp",
                                             "core/motion/body/joint_set.hpp",
                                             "core/motion/body/body.hpp",
                                             "core/motion/body/girth.hpp",
                                             "core/motion/body/clip.hpp",
                                             "core/motion/scenes/worn_character.hpp",
                                             "core/metrics/holds.hpp",
                                             "core/metrics/movement.hpp",
                                             "core/metrics/partner_error.hpp",
                                             "core/metrics/run_comparison.hpp"};
  if (open.contains(include)) return true;
  return include.starts_with("core/mesh/") ||
         (include.starts_with("core/base/") && include != "core/base/atomic_file.hpp");
}

bool is_path_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '}' || c == ')' ||
         c == '-';
}

}  // namespace

const std::map<std::string, std::set<std::string>>& core_table() {
  static const std::map<std::string, std::set<std::string>> table = {
      {"base", {}},
      {"motion", {"base"}},
      {"mesh", {"base", "motion"}},
      {"library", {"base", "motion", "mesh"}},
      {"selection", {"base", "motion", "mesh", "library"}},
      {"retarget", {"base", "motion", "mesh", "library"}},
      {"synthesis", {"base", "motion", "mesh", "library", "selection", "retarget"}},
      {"bodies", {"base", "motion", "mesh", "library", "selection", "retarget", "synthesis"}},
      {"metrics", {"base", "motion", "mesh", "library", "selection", "retarget", "synthesis"}},
      {"annotation", {"base", "motion", "mesh", "library", "selection", "retarget", "synthesis", "metrics"}},
      {"choreography", {"base", "motion", "library"}},
      {"evaluation",
       {"base", "motion", "mesh", "library", "selection", "retarget", "synthesis", "metrics", "choreography",
        "annotation", "bodies"}},
      {"stream", {"base", "motion"}},
      {"video", {"base", "motion"}},
      {"session",
       {"base", "motion", "mesh", "library", "selection", "retarget", "synthesis", "metrics", "stream",
        "video", "annotation"}},
      {"opening",
       {"base", "motion", "mesh", "library", "selection", "retarget", "synthesis", "metrics", "stream",
        "video", "annotation", "choreography", "session"}},
  };
  return table;
}

const std::map<std::string, Rooms>& room_table() {
  static const std::set<std::string> of_every_feature = {"base", "document", "shell"};
  static const std::map<std::string, Rooms> table = {
      {"core/motion",
       {{"body", {}},
        {"joints", {"body"}},
        {"bvh", {"body", "joints"}},
        {"acclaim", {"body", "joints"}},
        {"tables", {"body", "joints"}},
        {"scenes", {"body", "joints"}},
        {"numpy", {"body", "joints"}},
        {"files", {"body", "joints", "bvh", "acclaim", "tables", "scenes", "numpy"}}}},
      {"core/synthesis",
       {{"settings", {}},
        {"frames", {"settings"}},
        {"edit", {"settings", "frames"}},
        {"motion", {"settings", "frames"}},
        {"bodies", {"settings", "frames", "edit", "motion"}},
        {"step", {"settings", "frames", "edit", "motion", "bodies"}}}},
      {"core/library", {{"takes", {}}, {"store", {"takes"}}, {"build", {"takes", "store"}}}},
      {"core/evaluation",
       {{"takes", {}},
        {"tables", {"takes"}},
        {"run", {"takes", "tables"}},
        {"plots", {}},
        {"report", {"tables", "plots"}},
        {"sweep", {"tables", "run", "plots", "report"}}}},
      {"core/stream",
       {{"net", {}},
        {"humanoid", {}},
        {"protocol", {"net"}},
        {"vmc", {"humanoid", "protocol", "net"}},
        {"natnet", {"humanoid", "protocol", "net"}},
        {"xsens", {"humanoid", "protocol", "net"}},
        {"receive", {"humanoid", "protocol", "net", "vmc", "natnet", "xsens"}},
        {"send", {"humanoid", "protocol", "net", "vmc", "natnet", "xsens"}}}},
      {"core/session",
       {{"frames", {}},
        {"file", {"frames"}},
        {"edit", {"frames", "file"}},
        {"run", {"frames", "file"}},
        {"export", {"frames", "file", "run"}}}},
      {"widgets/scene",
       {{"values", {}},
        {"actors", {"values"}},
        {"pick", {"values", "actors"}},
        {"panel", {"values", "actors"}},
        {"view", {"values", "actors", "pick", "panel"}}}},
      {"app/workbench",
       {{"base", {}},
        {"document", {"base"}},
        {"shell", {"base", "document"}},
        {"compare", of_every_feature},
        {"export", of_every_feature},
        {"keys", of_every_feature},
        {"labels", of_every_feature},
        {"library", of_every_feature},
        {"project", of_every_feature},
        {"solve", of_every_feature},
        {"stream", of_every_feature},
        {"takes", of_every_feature},
        {"video", of_every_feature},
        {"start",
         {"base", "document", "shell", "compare", "export", "keys", "labels", "library", "project", "solve",
          "stream", "takes", "video"}}}},
  };
  return table;
}

std::span<const RoomException> room_exceptions() {
  static constexpr std::string_view takes =
      "the file of the session and its takes are kept by the desk of takes";
  static constexpr std::array exceptions = {
      RoomException{"app/workbench/project/project_desk.cpp", "app/workbench/takes/take_desk.hpp", takes},
  };
  return exceptions;
}

Violations core_names_no_toolkit(std::span<const SourceFile> files) {
  Violations found = check_includes(files, "core/", [](const SourceFile&, const std::string& include) {
    return is_qt(include) || is_vtk(include) ? "core knows neither Qt nor VTK, but includes " + include
                                             : std::string();
  });
  static const std::regex linked(R"re(\b(Qt[56]?::|Qt[56]\b|VTK|vtk_module))re");
  for (const SourceFile& file : files) {
    if (!file.is_under("core/") || !file.path.ends_with("CMakeLists.txt")) continue;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      const std::string code = file.lines[i].substr(0, file.lines[i].find('#'));
      if (std::regex_search(code, linked)) {
        found.push_back(at(file, static_cast<int>(i) + 1, "core links neither Qt nor VTK"));
      }
    }
  }
  return found;
}

Violations core_folders_include_downwards(std::span<const SourceFile> files) {
  return check_includes(files, "core/",
                        [](const SourceFile& file, const std::string& include) -> std::string {
                          if (!include.starts_with("core/")) return {};
                          const std::string from = second_folder(file.path);
                          const std::string to = second_folder(include);
                          const auto row = core_table().find(from);
                          if (row == core_table().end())
                            return "core/" + from + " has no row in the table of who may include whom";
                          if (from == to || row->second.contains(to)) return {};
                          return "core/" + from + " may not include from core/" + to + " (" + include + ")";
                        });
}

namespace {

/// Why a file may not include another of its folder; empty when it may, or when they are of different
/// folders.
std::string against_rooms(std::string_view file, const std::string& include) {
  const auto folder = room_table().find(folder_with_rooms(file));
  if (folder == room_table().end() || folder_with_rooms(include) != folder->first) return {};
  const std::string from = room_of(file);
  const std::string to = room_of(include);
  const auto row = folder->second.find(from);
  if (row == folder->second.end() || from == to || row->second.contains(to)) return {};
  return folder->first + "/" + from + " may not include from " + folder->first + "/" + to + " (" + include +
         ")";
}

}  // namespace

Violations rooms_include_downwards(std::span<const SourceFile> files) {
  Violations found;
  for (const SourceFile& file : files) {
    const auto folder = room_table().find(folder_with_rooms(file.path));
    if (folder == room_table().end() || !file.is_cpp()) continue;
    const std::string room = room_of(file.path);
    if (room.empty())
      found.push_back(at(file, 1, "stands in no room of " + folder->first));
    else if (!folder->second.contains(room))
      found.push_back(at(file, 1, folder->first + "/" + room + " has no row in the table of rooms"));
    for (const Include& include : includes_of(file)) {
      const std::string why = against_rooms(file.path, include.path);
      const bool excepted = std::ranges::any_of(room_exceptions(), [&](const RoomException& each) {
        return each.file == file.path && each.include == include.path;
      });
      if (!why.empty() && !excepted) found.push_back(at(file, include.line, why));
    }
  }
  return found;
}

Violations room_exceptions_are_needed(std::span<const SourceFile> files) {
  Violations found;
  for (const RoomException& each : room_exceptions()) {
    const bool needed = std::ranges::any_of(files, [&](const SourceFile& file) {
      if (file.path != each.file || against_rooms(each.file, std::string(each.include)).empty()) return false;
      const std::vector<Include> includes = includes_of(file);
      return std::ranges::find(includes, each.include, &Include::path) != includes.end();
    });
    if (!needed)
      found.push_back(std::string(each.file) + " does not include " + std::string(each.include) +
                      " against the rules any more: take it off the list of exceptions");
  }
  return found;
}

Violations folders_are_not_crowded(std::span<const SourceFile> files) {
  constexpr int most = 50;
  std::map<std::string, int> count;
  for (const SourceFile& file : files) {
    const bool ours = file.is_under("core/") || file.is_under("widgets/") || file.is_under("app/");
    if (ours && file.is_cpp()) ++count[file.path.substr(0, file.path.rfind('/'))];
  }
  Violations found;
  for (const auto& [folder, n] : count)
    if (n > most)
      found.push_back(folder + " has " + std::to_string(n) + " files; at most " + std::to_string(most));
  return found;
}

Violations scene_values_know_no_toolkit(std::span<const SourceFile> files) {
  return check_includes(files, "widgets/scene/values/", [](const SourceFile&, const std::string& include) {
    const bool toolkit = is_vtk(include) || include == "QWidget" || include == "QLabel";
    return toolkit ? "values of the scene are drawn by nobody, but include " + include : std::string();
  });
}

Violations layers_point_down(std::span<const SourceFile> files) {
  Violations found = check_includes(files, "core/", [](const SourceFile&, const std::string& include) {
    const bool up = include.starts_with("widgets/") || include.starts_with("app/");
    return up ? "core may not include " + include : std::string();
  });
  const Violations in_widgets =
      check_includes(files, "widgets/", [](const SourceFile&, const std::string& include) {
        return include.starts_with("app/") ? "widgets may not include " + include : std::string();
      });
  found.insert(found.end(), in_widgets.begin(), in_widgets.end());
  return found;
}

Violations command_line_knows_no_widgets(std::span<const SourceFile> files) {
  return check_includes(files, "app/cli/", [](const SourceFile&, const std::string& include) {
    const bool toolkit = include.starts_with("widgets/") || is_qt(include) || is_vtk(include);
    return toolkit ? "the command line is built without Qt and VTK, but includes " + include : std::string();
  });
}

Violations python_knows_core_alone(std::span<const SourceFile> files) {
  return check_includes(files, "app/python/", [](const SourceFile&, const std::string& include) {
    const bool layer = include.starts_with("widgets/") || include.starts_with("app/");
    const bool own = include.starts_with("app/python/");
    return (layer && !own) || is_qt(include) || is_vtk(include)
               ? "the Python module is core's alone, but includes " + include
               : std::string();
  });
}

Violations renderer_draws_only_the_scene(std::span<const SourceFile> files) {
  return check_includes(
      files, "app/render/", [](const SourceFile& file, const std::string& include) -> std::string {
        const bool is_view = include.starts_with("widgets/") && !include.starts_with("widgets/scene/") &&
                             !include.starts_with("widgets/common/");
        if (is_view || include.starts_with("app/workbench/"))
          return "the renderer draws the scene and opens no window, but includes " + include;
        const bool is_options = file.path.find("render_options") != std::string::npos;
        if (is_options && (is_qt(include) || is_vtk(include) || include.starts_with("widgets/")))
          return "the command line reads these options without a toolkit, but they include " + include;
        return {};
      });
}

Violations third_parties_have_one_place(std::span<const SourceFile> files) {
  Violations found;
  for (const ThirdParty& party : third_parties) {
    const std::regex named(party.includes);
    std::string first;
    const auto why = [&](const SourceFile& file, const std::string& include) {
      if (!std::regex_search(include, named) || is_in_place(file, party.place, first)) return std::string();
      const std::string place = party.place.empty() ? "one source file" : std::string(party.place);
      return std::string(party.name) + " may be named only in " + place;
    };
    for (const std::string_view layer : {"core/", "widgets/", "app/"}) {
      const Violations here = check_includes(files, layer, why);
      found.insert(found.end(), here.begin(), here.end());
    }
  }
  return found;
}

Violations core_names_no_option(std::span<const SourceFile> files) {
  // The report of a sweep says how the command line evaluates a point again.
  constexpr std::string_view reminder = "core/evaluation/sweep/sweep_report.cpp";
  static const std::regex comment(R"re((^|\s)//.*$)re"), variable_of_a_page(R"re(var\(--)re"),
      option_in_text(R"re("[^"]*--[a-z])re");
  Violations found;
  for (const SourceFile& file : files) {
    if (!file.is_under("core/") || !file.is_cpp() || file.path == reminder) continue;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      const std::string code = std::regex_replace(file.lines[i], comment, "");
      if (std::regex_search(std::regex_replace(code, variable_of_a_page, ""), option_in_text))
        found.push_back(at(file, static_cast<int>(i) + 1,
                           "a text of core names an option of the command line; give the Error a Hint"));
    }
  }
  return found;
}

Violations widgets_see_only_snapshots(std::span<const SourceFile> files) {
  return check_includes(files, "widgets/", [](const SourceFile&, const std::string& include) {
    if (!include.starts_with("core/") || is_open_to_widgets(include)) return std::string();
    return "widgets see snapshots, settings, commands and values, not " + include;
  });
}

Violations widget_folders_are_strangers(std::span<const SourceFile> files) {
  return check_includes(files, "widgets/", [](const SourceFile& file, const std::string& include) {
    if (!include.starts_with("widgets/")) return std::string();
    const std::string from = second_folder(file.path);
    const std::string to = second_folder(include);
    if (from == to || to == "common") return std::string();
    return "widgets/" + from + " may not include from widgets/" + to + "; app connects them";
  });
}

Violations headers_have_pragma_once(std::span<const SourceFile> files) {
  Violations found;
  for (const SourceFile& file : files) {
    if (!file.is_header()) continue;
    if (file.lines.empty() || file.lines.front() != "#pragma once") {
      found.push_back(at(file, 1, "the first line of a header is #pragma once"));
    }
  }
  return found;
}

Violations no_path_of_a_machine(std::span<const SourceFile> files) {
  // In two parts, so that this file passes its own rule.
  static const std::array<std::string, 4> beginnings = {
      std::string("/") + "work/", std::string("/") + "home/", std::string("/") + "root/",
      std::string("/") + "tmp/bash"};
  Violations found;
  for (const SourceFile& file : files) {
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      const std::string& line = file.lines[i];
      for (const std::string& beginning : beginnings) {
        const std::size_t where = line.find(beginning);
        if (where == std::string::npos || (where > 0 && is_path_character(line[where - 1]))) continue;
        found.push_back(
            at(file, static_cast<int>(i) + 1, "names a path of one machine (" + beginning + "...)"));
      }
    }
  }
  return found;
}

Violations signals_are_of_their_own_object(std::span<const SourceFile> files) {
  static const std::regex foreign(R"re(\bemit\s+(?!this->)\w+(\(\))?(\.|->))re");
  Violations found;
  for (const SourceFile& file : files) {
    if (!file.is_cpp() || !(file.is_under("app/") || file.is_under("widgets/"))) continue;
    for (std::size_t i = 0; i < file.lines.size(); ++i)
      if (std::regex_search(file.lines[i], foreign))
        found.push_back(
            at(file, static_cast<int>(i) + 1, "emits a signal of another object; ask it instead"));
  }
  return found;
}

Violations at_most_lines(std::span<const SourceFile> files, std::string_view prefix, int most,
                         std::string_view ending) {
  Violations found;
  for (const SourceFile& file : files) {
    const int lines = static_cast<int>(file.lines.size());
    if (file.path.starts_with(prefix) && file.path.ends_with(ending) && lines > most) {
      found.push_back(at(file, most + 1, std::to_string(lines) + " lines; at most " + std::to_string(most)));
    }
  }
  return found;
}

Violations top_level_is_known(std::span<const std::string> names, const SourceFile& ignored) {
  static const std::set<std::string, std::less<>> known = {".ci",
                                                           ".clang-format",
                                                           ".clang-tidy",
                                                           ".editorconfig",
                                                           ".git",
                                                           ".gitattributes",
                                                           ".gitignore",
                                                           "CHANGELOG.md",
                                                           "CITATION.cff",
                                                           "CMakeLists.txt",
                                                           "CMakePresets.json",
                                                           "CONTRIBUTING.md",
                                                           "LICENSE",
                                                           "README.md",
                                                           "SECURITY.md",
                                                           "app",
                                                           "cmake",
                                                           "core",
                                                           "data",
                                                           "docs",
                                                           "examples",
                                                           "package-lock.json",
                                                           "package.json",
                                                           "packaging",
                                                           "pages",
                                                           "pyproject.toml",
                                                           "resources",
                                                           "run",
                                                           "test",
                                                           "tests",
                                                           "widgets"};
  const auto is_ignored = [&](std::string_view name) {
    return std::ranges::any_of(ignored.lines, [&](std::string_view rule) {
      if (rule.starts_with('*')) return name.ends_with(rule.substr(1));
      if (rule.starts_with('/')) rule.remove_prefix(1);
      if (rule.ends_with('/')) rule.remove_suffix(1);
      return !rule.empty() && name == rule;
    });
  };
  Violations found;
  for (const std::string& name : names)
    if (!known.contains(name) && !is_ignored(name))
      found.push_back(name + " at the top level is not in the list of tests/architecture/rules.cpp");
  return found;
}

Violations corpora_are_small(std::span<const std::string> paths) {
  constexpr int most = 12;
  std::map<std::string, int> count;
  for (const std::string& path : paths) ++count[path.substr(0, path.rfind('/'))];
  Violations found;
  for (const auto& [folder, n] : count)
    if (n > most)
      found.push_back(folder + " has " + std::to_string(n) + " seeds; at most " + std::to_string(most) +
                      ", chosen by tests/fuzz/keep");
  return found;
}

}  // namespace abrazo::test
