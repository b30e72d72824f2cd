#pragma once

#include <string>

#include "core/base/progress.hpp"
#include "core/opening/material.hpp"
#include "core/opening/opened_session.hpp"

namespace abrazo {

/// Data for opening a session that is not in its file.
struct SessionWish {
  std::string library;  ///< library or manifest in the place of its own; empty = none was given
  Material open;        ///< what is open now: its library may be the session's
  /// A person said that it will do without what is missing: the generated dance answers in its library's
  /// place.
  bool may_stand_in = false;
};

/// A session with the library it was solved with, or what a project says in which nothing was recorded. What
/// was recovered, is missing or another is among the warnings. A project without its library opens with the
/// generated dance; a recording does only when `may_stand_in`.
Result<Material> material_of(const OpenedSession& session, const SessionWish& wish, const Progress& progress);

}  // namespace abrazo
