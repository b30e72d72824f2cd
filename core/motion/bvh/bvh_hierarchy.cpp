#include "core/motion/bvh/bvh_hierarchy.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/text.hpp"

namespace abrazo {

namespace {

/// A number whose decimal sign may be a comma.
std::optional<double> lenient_number(std::string_view word) {
  std::string text(word);
  std::replace(text.begin(), text.end(), ',', '.');
  const auto number = parse_number(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

class HierarchyParser {
 public:
  HierarchyParser(LineReader& lines, std::string_view where) : lines_(lines), where_(where) {}

  Result<BvhHierarchy> parse();

 private:
  Status read_line(std::string_view line);
  Status read_statement(std::string_view statement);
  Status open_node(std::string_view kind, std::string_view name);
  Status close_node();
  Status read_offset(std::string_view& rest);
  Status read_channels(std::string_view& rest);
  Status finish();
  std::string unique_name(const std::string& wanted, bool is_end_site);
  Error error(std::string message) const { return error_at(where_, lines_.number(), std::move(message)); }

  LineReader& lines_;
  std::string where_;
  BvhHierarchy hierarchy_;
  std::vector<int> open_;        ///< nodes whose brace is open, outermost first
  bool brace_expected_ = false;  ///< a node was named, its '{' has not come yet
  bool motion_reached_ = false;
  std::set<std::string> names_;  ///< of the current root
};

std::string HierarchyParser::unique_name(const std::string& wanted, bool is_end_site) {
  std::string name = wanted;
  for (int count = 2; !names_.insert(name).second; ++count) name = wanted + "." + std::to_string(count);
  if (name != wanted && !is_end_site)
    hierarchy_.warnings.push_back(
        {"duplicate-name", lines_.number(),
         "there is a second joint " + in_quotes(wanted) + "; it is called " + in_quotes(name) + " here"});
  return name;
}

Status HierarchyParser::open_node(std::string_view kind, std::string_view name) {
  if (brace_expected_) return error("expected '{', found " + in_quotes(kind));
  BvhNode node;
  const bool is_root = kind == "root";
  if (is_root != open_.empty())
    return error(is_root ? "a ROOT inside another; is a '}' missing?"
                         : "expected ROOT before " + in_quotes(kind));
  if (!is_root) node.parent = open_.back();
  if (!is_root && hierarchy_.nodes[static_cast<std::size_t>(open_.back())].is_end_site)
    return error("an End Site cannot have joints");
  node.is_end_site = kind == "end";
  if (is_root) names_.clear();
  std::string wanted(trimmed(name));
  if (node.is_end_site) wanted = hierarchy_.nodes[static_cast<std::size_t>(node.parent)].name + "_End";
  if (wanted.empty()) return error("the joint has no name");
  node.name = unique_name(wanted, node.is_end_site);
  open_.push_back(static_cast<int>(hierarchy_.nodes.size()));
  hierarchy_.nodes.push_back(std::move(node));
  brace_expected_ = true;
  return Done{};
}

Status HierarchyParser::close_node() {
  if (open_.empty() || brace_expected_) return error("'}' without a '{' before it");
  const BvhNode& node = hierarchy_.nodes[static_cast<std::size_t>(open_.back())];
  if (!node.has_offset)
    hierarchy_.warnings.push_back({"missing-offset", lines_.number(),
                                   in_quotes(node.name) + " has no OFFSET; it was put where its parent is"});
  open_.pop_back();
  // Some programs end every chain so: it says nothing of where the limb ends.
  if (node.is_end_site && node.has_offset && node.offset.isZero() && node.channels.empty())
    hierarchy_.nodes.pop_back();
  return Done{};
}

Status HierarchyParser::read_offset(std::string_view& rest) {
  BvhNode& node = hierarchy_.nodes[static_cast<std::size_t>(open_.back())];
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view word = take_word(rest);
    const auto number = lenient_number(word);
    if (!number)
      return error("expected three numbers after OFFSET" +
                   (word.empty() ? ", the line ends early" : ", found " + in_quotes(word)));
    node.offset[axis] = *number;
  }
  node.has_offset = true;
  return Done{};
}

Status HierarchyParser::read_channels(std::string_view& rest) {
  BvhNode& node = hierarchy_.nodes[static_cast<std::size_t>(open_.back())];
  const std::string_view count_word = take_word(rest);
  const auto count = parse_integer(count_word);
  if (!count || *count < 0 || *count > 6)
    return error("expected a number of channels from 0 to 6, found " + in_quotes(count_word));
  node.channels.clear();
  for (long long i = 0; i < *count; ++i) {
    const std::string_view word = take_word(rest);
    const std::string name = lower_case(word);
    const bool is_position = name.ends_with("position"), is_rotation = name.ends_with("rotation");
    if (!(is_position || is_rotation) || name.size() != 9 || name[0] < 'x' || name[0] > 'z')
      return error("expected " + std::to_string(*count) + " channel names such as Xposition or Zrotation, " +
                   (word.empty() ? "the line ends early" : "found " + in_quotes(word)));
    node.channels.push_back(name[0] - 'x' + (is_rotation ? 3 : 0));
  }
  hierarchy_.values_per_row += node.channels.size();
  return Done{};
}

/// @param statement  without braces, not blank; may hold several statements
Status HierarchyParser::read_statement(std::string_view statement) {
  std::string_view rest = statement;
  const std::string_view word = take_word(rest);
  const std::string key = lower_case(word);
  if (key == "hierarchy") return Done{};
  if (key == "motion") return motion_reached_ = true, Status(Done{});
  if (key == "root" || key == "joint" || key == "end") return open_node(key, rest);
  if (key != "offset" && key != "channels")
    return error("expected HIERARCHY, ROOT, JOINT, End Site, OFFSET, CHANNELS, a brace or MOTION, found " +
                 in_quotes(word));
  if (open_.empty() || brace_expected_) return error(in_quotes(word) + " outside the braces of a joint");
  if (key == "channels" && !hierarchy_.nodes[static_cast<std::size_t>(open_.back())].channels.empty())
    return error("the joint has CHANNELS twice");
  if (const Status read = key == "offset" ? read_offset(rest) : read_channels(rest); !read) return read;
  return trimmed(rest).empty() ? Status(Done{}) : read_statement(rest);
}

Status HierarchyParser::read_line(std::string_view line) {
  while (!line.empty()) {
    const auto brace = std::min(line.find_first_of("{}"), line.size());
    if (const std::string_view statement = trimmed(line.substr(0, brace)); !statement.empty())
      if (const Status read = read_statement(statement); !read) return read;
    if (brace == line.size()) break;
    if (line[brace] == '}') {
      if (const Status closed = close_node(); !closed) return closed;
    } else {
      if (!brace_expected_) return error("'{' without a joint before it");
      brace_expected_ = false;
    }
    line.remove_prefix(brace + 1);
  }
  return Done{};
}

Status HierarchyParser::finish() {
  if (hierarchy_.nodes.empty())
    return Error{"has no ROOT; expected a BVH file that begins with HIERARCHY", where_};
  if (!motion_reached_)
    return error("the file ends without MOTION, so it has no frames; export it again with its motion");
  if (brace_expected_) return error("MOTION where '{' was expected");
  if (!open_.empty())
    hierarchy_.warnings.push_back(
        {"braces", lines_.number(), std::to_string(open_.size()) + " '}' missing before MOTION"});
  if (hierarchy_.values_per_row == 0) return error("no joint has CHANNELS, so there is no motion");
  return Done{};
}

Result<BvhHierarchy> HierarchyParser::parse() {
  std::string_view line;
  while (!motion_reached_ && lines_.next(line))
    if (const Status read = read_line(line); !read) return read.error();
  if (const Status finished = finish(); !finished) return finished.error();
  return std::move(hierarchy_);
}

}  // namespace

Result<BvhHierarchy> parse_bvh_hierarchy(LineReader& lines, std::string_view where) {
  return HierarchyParser(lines, where).parse();
}

}  // namespace abrazo
