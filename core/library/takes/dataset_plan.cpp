#include "core/library/takes/dataset_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <climits>
#include <map>
#include <optional>

#include "core/base/text.hpp"
#include "core/motion/joints/motion_format.hpp"
#include "core/motion/joints/performers.hpp"

namespace abrazo {

namespace {

namespace fs = std::filesystem;

constexpr int deepest = 12;

/// A motion file as one of a pair: the take's name, and which of both.
struct Half {
  std::string take;
  bool second = false;
  bool says_role = false;  ///< the first is the one who leads
};

struct Layout {
  DatasetLayout shown;
  std::optional<Half> (*half)(const fs::path& relative);
  void (*settle)(Manifest::Take& take, const fs::path& body_model);
};

/// "Song1/Take1" -> "Song1_Take1".
std::string take_name(const fs::path& path) {
  std::string name = path.generic_string();
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

std::optional<Half> compas3d_half(const fs::path& file) {
  if (lower_case(file.extension().string()) != ".npz") return std::nullopt;
  const std::string stem = file.stem().string(), lower = lower_case(stem);
  for (const std::string end : {"_leader", "_follower"})
    if (lower.ends_with(end) && lower.size() > end.size())
      return Half{take_name(file.parent_path() / stem.substr(0, stem.size() - end.size())),
                  end == "_follower", true};
  return std::nullopt;
}

std::optional<Half> interx_half(const fs::path& file) {
  const std::string name = lower_case(file.filename().string());
  if ((name != "p1.npz" && name != "p2.npz") || file.parent_path().empty()) return std::nullopt;
  return Half{take_name(file.parent_path()), name == "p2.npz"};
}

std::optional<Half> interhuman_half(const fs::path& file) {
  const std::string person = lower_case(file.parent_path().filename().string());
  if (lower_case(file.extension().string()) != ".npy" || (person != "person1" && person != "person2"))
    return std::nullopt;
  return Half{take_name(file.parent_path().parent_path() / file.stem()), person == "person2"};
}

/// Words by which two files of a pair differ, the first performer's before the second's.
struct PairWords {
  const char *first, *second;
  bool says_role;
};
constexpr std::array<PairWords, 10> pair_words = {{{"leader", "follower", true},
                                                   {"lead", "follow", true},
                                                   {"active", "passive", true},
                                                   {"person1", "person2", false},
                                                   {"p1", "p2", false},
                                                   {"actor", "reactor", true},
                                                   {"subject1", "subject2", false},
                                                   {"a", "b", false},
                                                   {"male", "female", false},
                                                   {"1", "2", false}}};

/// The last word of the path that is one of the pair words, taken out of it.
std::optional<Half> folder_half(const fs::path& file) {
  const auto format = format_of_name(file.string());
  if (!format || *format == MotionFormat::Asf) return std::nullopt;
  const std::string path = (file.parent_path() / file.stem()).generic_string();
  for (std::size_t end = path.size(); end > 0;) {
    const std::size_t mark = path.find_last_of("_-. /", end - 1);
    const std::size_t begin = mark == std::string::npos ? 0 : mark + 1;
    const std::string word = lower_case(path.substr(begin, end - begin));
    for (const PairWords& words : pair_words) {
      const bool second = word == words.second;
      if (!second && word != words.first) continue;
      // "take_a" -> "take"; "leader/take" -> "take"
      std::string rest = path.substr(0, begin > 0 ? begin - 1 : 0) +
                         path.substr(begin > 0 ? end : std::min(end + 1, path.size()));
      if (rest.empty()) rest = "take";
      return Half{take_name(rest), second, words.says_role};
    }
    if (mark == std::string::npos || mark == 0) break;
    end = mark;
  }
  return std::nullopt;
}

std::optional<Half> remocap_half(const fs::path& file) {
  return lower_case(file.extension().string()) == ".bvh" ? folder_half(file) : std::nullopt;
}

void set_axes(Manifest::Take& take, UpAxis up) {
  take.a.up_axis = take.b.up_axis = up;
}

void set_body(Manifest::Take& take, const fs::path& body_model) {
  take.a.body_model = take.b.body_model = body_model;
}

const std::array<Layout, 5>& layouts() {
  static const std::array<Layout, 5> all = {{
      {{"compas3d", "NAME_leader.npz and NAME_follower.npz, with NAME.txt for the labels"},
       compas3d_half,
       [](Manifest::Take& take, const fs::path& body_model) {
         set_axes(take, UpAxis::Z);
         set_body(take, body_model);
       }},
      {{"interx", "a folder for each take with P1.npz and P2.npz"},
       interx_half,
       [](Manifest::Take& take, const fs::path& body_model) {
         take.fps = 120;
         set_body(take, body_model);
       }},
      {{"interhuman", "person1/ID.npy and person2/ID.npy"},
       interhuman_half,
       [](Manifest::Take& take, const fs::path&) {
         take.fps = 30;
         set_axes(take, UpAxis::Z);
       }},
      {{"remocap", "two .bvh whose names differ by one word, such as leader and follower"},
       remocap_half,
       [](Manifest::Take& take, const fs::path&) {
         take.metres_per_unit = 0.001;
         set_axes(take, UpAxis::Y);
       }},
      {{"folder",
        "two motion files whose names or folders differ by one word: leader and follower, a and b, p1 and "
        "p2, "
        "person1 and person2, 1 and 2"},
       folder_half,
       [](Manifest::Take& take, const fs::path& body_model) { set_body(take, body_model); }},
  }};
  return all;
}

/// All files below a folder, relative to it, in the order of their names.
Result<std::vector<fs::path>> files_below(const fs::path& folder) {
  std::error_code trouble;
  if (!fs::is_directory(folder, trouble)) return Error{"is no folder", folder.string()};
  std::vector<fs::path> files;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, trouble), end;
  for (; !trouble && entry != end; entry.increment(trouble)) {
    if (entry.depth() >= deepest) entry.disable_recursion_pending();
    if (std::error_code ignored; entry->is_regular_file(ignored))
      files.push_back(entry->path().lexically_relative(folder));
  }
  if (trouble) return Error{"cannot be listed: " + trouble.message(), folder.string()};
  std::sort(files.begin(), files.end());
  return files;
}

/// Labels of the same name beside the first performer's file, or anywhere below the folder when they are
/// alone there.
fs::path labels_for(const fs::path& first, const std::vector<fs::path>& files) {
  std::string stem = first.stem().string();
  const auto cut = stem.find_last_of("_-.");
  for (const std::string& name : {stem, cut == std::string::npos ? stem : stem.substr(0, cut)})
    for (const std::string ending : {".txt", ".eaf"})
      for (const fs::path& file : files)
        if (lower_case(file.filename().string()) == lower_case(name + ending)) return file;
  return {};
}

}  // namespace

const std::vector<DatasetLayout>& dataset_layouts() {
  static const std::vector<DatasetLayout> shown = [] {
    std::vector<DatasetLayout> list;
    for (const Layout& layout : layouts()) list.push_back(layout.shown);
    return list;
  }();
  return shown;
}

Result<Manifest> plan_dataset(const std::string& name, const fs::path& folder, const fs::path& body_model) {
  const auto layout = std::ranges::find(layouts(), name, [](const Layout& each) { return each.shown.name; });
  if (layout == layouts().end()) {
    std::vector<std::string> names;
    for (const Layout& each : layouts()) names.push_back(each.shown.name);
    return Error{"there is no dataset '" + name + "'; expected one of " + some_of(names), ""};
  }
  const auto files = files_below(folder);
  if (!files) return files.error();
  struct Pair {
    std::array<fs::path, 2> halves;
    bool says_role = false;
  };
  std::map<std::string, Pair> pairs;
  std::vector<std::string> alone, doubled;
  for (const fs::path& file : *files) {
    const auto format = format_of_name(file.string());
    const auto half = layout->half(file);
    if (!half) {
      if (format && *format != MotionFormat::Asf && *format != MotionFormat::PointCsv)
        alone.push_back(file.string());
      continue;
    }
    Pair& pair = pairs[half->take];
    fs::path& place = pair.halves[half->second ? 1 : 0];
    if (!place.empty()) {
      doubled.push_back(file.string());
      continue;
    }
    place = file;
    pair.says_role = half->says_role;
  }
  Manifest manifest;
  manifest.name =
      folder.filename().empty() ? folder.parent_path().filename().string() : folder.filename().string();
  for (const auto& [take_name, pair] : pairs) {
    if (pair.halves[0].empty() || pair.halves[1].empty()) {
      alone.push_back((pair.halves[0].empty() ? pair.halves[1] : pair.halves[0]).string());
      continue;
    }
    Manifest::Take take;
    take.name = take_name;
    take.a.motion = folder / pair.halves[0];
    take.b.motion = folder / pair.halves[1];
    if (pair.says_role) take.roles = {{0, INT_MAX, ActivePerformer::A}};
    if (const fs::path labels = labels_for(pair.halves[0], *files); !labels.empty())
      take.labels = folder / labels;
    layout->settle(take, body_model);
    manifest.takes.push_back(std::move(take));
  }
  if (manifest.takes.empty())
    return Error{fmt::format("holds no pair of the dataset {} among {} files; expected {}", name,
                             files->size(), layout->shown.expected),
                 folder.string()};
  if (!alone.empty())
    manifest.warnings.push_back(
        fmt::format("{} motion files have no partner and were left out: {}", alone.size(), some_of(alone)));
  if (!doubled.empty())
    manifest.warnings.push_back(
        fmt::format("{} files are a second file for the same performer and were left out: {}", doubled.size(),
                    some_of(doubled)));
  return manifest;
}

}  // namespace abrazo
