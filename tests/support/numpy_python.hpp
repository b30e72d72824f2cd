#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

namespace abrazo::test {

/// A Python 3 that has NumPy; empty where there is none, and tests that compare with it are skipped.
inline std::string python_with_numpy() {
  for (const std::string python : {"python3", "/usr/bin/python3"})
    if (std::system((python + " -c 'import numpy' > /dev/null 2>&1").c_str()) == 0) return python;
  return {};
}

/// What a command prints; "failed" in place of it where it fails.
inline std::string printed_by(const std::string& command) {
  FILE* pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) return "failed";
  std::string text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
  return ::pclose(pipe) == 0 ? text : "failed";
}

}  // namespace abrazo::test
