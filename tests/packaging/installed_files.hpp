#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace abrazo::test {

/// Of the installed tree: "share/man/man1/abrazo.1" below the prefix.
std::filesystem::path installed(const std::string& name);

/// Every file below an installed folder.
std::vector<std::filesystem::path> installed_files(const std::string& folder = "");

std::string content_of(const std::filesystem::path& file);

/// Where a program of the system is; empty when it is not installed.
std::string program_at(const std::string& name);

}  // namespace abrazo::test
