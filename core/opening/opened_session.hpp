#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/workbench/document/material.hpp"
#include "core/session/file/project.hpp"

namespace abrazo::app {

/// Where files of a project are now, by index into Project::data; an empty path: open without it.
using Places = std::map<std::size_t, std::string>;

/// A session file with its project and where the data of it was found.
struct OpenedProject {
  std::string file;  ///< where it is saved; empty when it never was
  ProjectReading reading;
  std::vector<FoundData> found;  ///< by index into reading.project.data
  std::string autosave;          ///< it was restored from there; empty otherwise

  const Project& project() const { return reading.project; }
  /// The first of a use that was found; empty when there is none.
  std::string place_of(DataReference::Use use) const;
  std::vector<std::size_t> missing() const;
};

/// The key in Project::view under which an autosaved project names the session file that it belongs to.
inline constexpr const char* autosaved_key = "autosaved";

Result<std::shared_ptr<const OpenedProject>> open_project(const std::string& file, const Places& places);

/// Library and input of a project in which nothing was recorded. What is not there is among the warnings, and
/// the generated dance stands in for it.
Result<Material> material_of(const OpenedProject& project, const Progress& progress);

/// What opening without a file of this use means for a person.
std::string without(DataReference::Use use);

}  // namespace abrazo::app
