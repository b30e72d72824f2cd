#include "core/session/file/session_libraries.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/library/store/motion_library_file.hpp"
#include "core/session/file/library_reference.hpp"

namespace abrazo {

Result<SessionLibraries::Opened> SessionLibraries::open(const SessionLibrary* reference) {
  if (last_.library && reference == last_reference_) return last_;
  Opened opened;
  if (!given_.empty()) {
    auto library = read_library(given_);
    if (!library) return library.error();
    if (reference)
      if (const Status same = check_session_library(*reference, *library); !same)
        return Error{same.error().message, given_};
    opened = {std::make_shared<const MotionLibrary>(std::move(*library)), given_};
  } else if (!reference) {
    return Error{"does not say which library it was solved with; pass it with --library LIB", file_->path()};
  } else {
    auto library = open_session_library(*reference, file_->path());
    if (!library)
      return Error{library.error().message + "; --library LIB says where it is", library.error().where};
    opened = {std::move(*library), reference->name};
  }
  last_ = opened;
  last_reference_ = reference;
  return opened;
}

Result<std::vector<std::shared_ptr<const MotionLibrary>>> SessionLibraries::all(
    std::vector<std::string>& warnings) const {
  std::vector<std::shared_ptr<const MotionLibrary>> found;
  std::shared_ptr<const MotionLibrary> given;
  if (!given_.empty()) {
    auto library = read_library(given_);
    if (!library) return library.error();
    given = std::make_shared<const MotionLibrary>(std::move(*library));
  }
  const auto& references = file_->contents().libraries;
  const auto same = [](const SessionLibrary& a, const SessionLibrary& b) {
    return a.fingerprint == b.fingerprint && a.pairs == b.pairs && a.absolute_path == b.absolute_path &&
           a.relative_path == b.relative_path && a.name == b.name;
  };
  bool given_fits = references.empty();
  for (auto reference = references.begin(); reference != references.end(); ++reference) {
    if (std::any_of(references.begin(), reference, [&](const auto& one) { return same(one, *reference); }))
      continue;
    if (given && check_session_library(*reference, *given)) {
      given_fits = true;
      continue;
    }
    if (reference->relative_path.empty() && reference->absolute_path.empty()) {
      warnings.push_back(
          fmt::format("{}: its library \"{}\" was never a file; frames solved with it have no mesh",
                      file_->path(), reference->name));
      continue;
    }
    auto library = open_session_library(*reference, file_->path());
    if (library)
      found.push_back(std::move(*library));
    else
      warnings.push_back(library.error().text() +
                         "; frames solved with it have no mesh (--library names it)");
  }
  if (given && !given_fits)
    warnings.push_back(check_session_library(references.back(), *given).error().text() +
                       "; meshes may be wrong");
  if (given) found.push_back(std::move(given));
  return found;
}

}  // namespace abrazo
