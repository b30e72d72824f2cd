#include "core/session/session_libraries.hpp"

#include "core/library/motion_library_file.hpp"
#include "core/session/library_reference.hpp"

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

}  // namespace abrazo
