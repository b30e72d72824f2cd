#pragma once

#include <string>

#include "app/cli/child_process.hpp"

namespace abrazo::app {

/// An X server in memory (Xvfb) for as long as this lives. It chooses a number that is free by itself.
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
