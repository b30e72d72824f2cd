#include "app/cli/report_folder.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

namespace abrazo::app {

namespace fs = std::filesystem;

ReportFolder::~ReportFolder() {
  std::error_code not_empty;
  if (is_new_) fs::remove(path_, not_empty);
}

Status ReportFolder::make() {
  std::error_code failure;
  const bool was_there = fs::exists(path_, failure);
  fs::create_directories(path_, failure);
  if (failure || !fs::is_directory(path_, failure))
    return Error{"the folder cannot be made (" + (failure ? failure.message() : "a file has its name") +
                     "); choose another",
                 path_.string()};
  is_new_ = !was_there;
  if (::access(path_.c_str(), W_OK | X_OK) != 0)
    return Error{std::string("the folder is not writable (") + std::strerror(errno) +
                     "); choose another or change its permissions",
                 path_.string()};
  return Done{};
}

}  // namespace abrazo::app
