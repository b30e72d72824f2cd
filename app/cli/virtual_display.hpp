#pragma once

#include <string>

#include "app/cli/child_process.hpp"

namespace abrazo::app {

/// A virtual X server (Xvfb) during the lifetime of this object. It chooses a free display number.
class VirtualDisplay {
 public:
  static Result<VirtualDisplay> start();
  /// ":99"
  const std::string& name() const { return name_; }

 private:
  VirtualDisplay(ChildProcess server, std::string name)
      : server_(std::move(server)), name_(std::move(name)) {}
  ChildProcess server_;
  std::string name_;
};

}  // namespace abrazo::app
