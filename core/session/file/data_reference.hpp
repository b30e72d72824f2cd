#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"

namespace abrazo {

/// A file that a project stands on; its content stays where it is.
struct DataReference {
  enum class Use { Library, Manifest, Motion, Skeleton, Video, Intrinsics, JointMap, Take };
  Use use = Use::Library;
  std::string relative_path;  ///< to the session file's folder, with '/'; empty where there is no such path
  std::string absolute_path;  ///< when it was saved last
  std::uint64_t bytes = 0;
  std::string
      hash;  ///< 16 hexadecimal digits of the content (whole up to 64 MiB; else size, begin, middle, end)

  bool operator==(const DataReference&) const = default;
};

/// A reference by place alone; `reference_to` completes it, which reads the file.
DataReference unread_reference(DataReference::Use use, const std::string& file);

/// A reference to a file as it is now.
Result<DataReference> reference_to(const std::string& file, DataReference::Use use,
                                   const std::string& session_path);

/// Where the file is: beside the session by the relative path, else at the absolute one. Found with other
/// content counts as found, and says so.
struct FoundData {
  enum class State { Found, Changed, Missing };
  State state = State::Missing;
  std::string path;                 ///< empty when missing
  std::vector<std::string> looked;  ///< where it was looked for, in order
};
FoundData find_data(const DataReference& reference, const std::string& session_path);

/// After one missing file was pointed out: the others that lie as they did relative to it.
/// @return by index into `data`, the paths at which they exist
std::map<std::size_t, std::string> relocated(const std::vector<DataReference>& data, std::size_t pointed_out,
                                             const std::string& path);

/// "library", "manifest", ...: as the session file has it; and for a sentence.
std::string_view text_of(DataReference::Use use);
Result<DataReference::Use> parse_data_use(std::string_view text);

}  // namespace abrazo
