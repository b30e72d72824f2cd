#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <string>
#include <string_view>

#include "app/scene_reader/confinement.hpp"
#include "core/base/text.hpp"
#include "core/base/version.hpp"
#include "core/motion/scenes/assimp_scene.hpp"
#include "core/motion/scenes/scene_answer.hpp"
#include "core/motion/scenes/scene_process.hpp"

namespace {

using abrazo::SceneReaderExit;

int ends_with(SceneReaderExit code) {
  return static_cast<int>(code);
}

/// Standard input, which has to be a file. Empty when it is not.
std::string_view given_bytes() {
  struct stat facts {};
  if (::fstat(STDIN_FILENO, &facts) != 0 || !S_ISREG(facts.st_mode) || facts.st_size <= 0) return {};
  const auto size = static_cast<std::size_t>(facts.st_size);
  void* place = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, STDIN_FILENO, 0);
  return place == MAP_FAILED ? std::string_view() : std::string_view(static_cast<const char*>(place), size);
}

bool write_answer(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t wrote = ::write(STDOUT_FILENO, bytes.data(), bytes.size());
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(wrote));
  }
  return true;
}

}  // namespace

#ifdef ABRAZO_INSTRUMENTED
/// Looking for leaks takes a thread and files, which are not allowed any more at the end.
extern "C" const char* __asan_default_options() {  // NOLINT(bugprone-reserved-identifier): its name
  return "detect_leaks=0";
}
#endif

/// Reads one FBX, glTF or Collada file for the engine (core/motion/scenes/scene_process.cpp), within limits.
/// Words: format as its number, the file's name, the animation, bytes of memory, seconds of the processor.
/// The file's bytes are standard input; the answer goes to standard output.
int main(int count, char** words) {
  using namespace abrazo;
  const bool asks_version = count == 2 && std::string_view(words[1]) == "--version";
  if (asks_version) return std::printf("abrazo-scene-reader %s\n", version()) > 0 ? 0 : 1;
  const auto number = [&](int word) { return count == 6 ? parse_integer(words[word]).value_or(-1) : -1; };
  const long long format = number(1), memory_bytes = number(4), processor_s = number(5);
  const bool is_scene = format == static_cast<int>(MotionFormat::Gltf) ||
                        format == static_cast<int>(MotionFormat::Fbx) ||
                        format == static_cast<int>(MotionFormat::Collada);
  if (!is_scene || memory_bytes <= 0 || processor_s <= 0) {
    std::fputs(
        "abrazo-scene-reader is started by Abrazo when an FBX, glTF or Collada file is read; "
        "there is nothing to be done with it by hand\n",
        stderr);
    return ends_with(SceneReaderExit::WrongUse);
  }
  const std::string file = words[2];
  const std::string_view bytes = given_bytes();
  // Only the text form of glTF names further files.
  const bool names_files = format == static_cast<int>(MotionFormat::Gltf) && !bytes.starts_with("glTF");
  const std::string folder = std::filesystem::path(file).parent_path().string();
  app::Confinement limits{static_cast<std::size_t>(memory_bytes), static_cast<unsigned>(processor_s), {}};
  if (names_files) limits.folder = folder.empty() ? "." : folder;
  if (!app::confine(limits)) return ends_with(SceneReaderExit::NoLimits);
  try {
    const auto motions = read_scene(bytes, static_cast<MotionFormat>(format), file, words[3]);
    return ends_with(write_answer(scene_answer(motions)) ? SceneReaderExit::Answered
                                                         : SceneReaderExit::WrongUse);
  } catch (const std::bad_alloc&) {
    return ends_with(SceneReaderExit::OutOfMemory);
  }
}
