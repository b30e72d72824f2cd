#include "core/evaluation/run/library_data.hpp"

#include <algorithm>

#include "core/library/store/takes_of_library.hpp"

namespace abrazo {

namespace {

/// A pair whose roles differ from those of its take: the library has both assignments, whatever the takes
/// say.
bool is_against_roles(const PairSource& source) {
  return source.annotated == (source.swapped ? ActivePerformer::A : ActivePerformer::B);
}

}  // namespace

Result<EvaluationData> evaluation_data_of(std::shared_ptr<const MotionLibrary> library) {
  auto takes = takes_of_library(*library);
  if (!takes) return takes.error();
  EvaluationData data;
  data.name = library->name();
  data.takes = std::move(*takes);
  const auto& sources = library->columns().sources;
  data.both_roles = std::any_of(sources.begin(), sources.end(), is_against_roles);
  data.library = std::move(library);
  return data;
}

}  // namespace abrazo
