#include "core/motion/scenes/scene_process.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include "core/base/available_memory.hpp"
#include "core/base/text.hpp"
#include "core/motion/scenes/helper_process.hpp"
#include "core/motion/scenes/scene_answer.hpp"

namespace abrazo {

namespace {

namespace fs = std::filesystem;

constexpr const char* reader_name = "abrazo-scene-reader";
constexpr const char* reader_variable = "ABRAZO_SCENE_READER";

/// Of the module whose code this is, and of the program that has loaded it.
std::vector<fs::path> folders_of_this_code() {
  std::vector<fs::path> folders;
  Dl_info module{};
  std::error_code trouble;
  if (::dladdr(reinterpret_cast<const void*>(&folders_of_this_code), &module) != 0 && module.dli_fname)
    if (const fs::path file(module.dli_fname); file.is_absolute()) folders.push_back(file.parent_path());
  if (const fs::path program = fs::read_symlink("/proc/self/exe", trouble); program.is_absolute())
    if (folders.empty() || folders.front() != program.parent_path()) folders.push_back(program.parent_path());
  return folders;
}

Result<fs::path> find_scene_reader(const std::string& file) {
  std::string looked;
  std::error_code trouble;
  for (const fs::path& place : scene_reader_places()) {
    if (fs::is_regular_file(place, trouble)) return place;
    looked += (looked.empty() ? "" : ", ") + place.lexically_normal().string();
  }
  return Error{"cannot be read, since the program " + std::string(reader_name) +
                   ", which reads FBX, glTF and Collada, is missing (looked for " + looked +
                   "); install Abrazo anew, or name the program in " + reader_variable,
               file};
}

std::string in_gigabytes(std::size_t bytes) {
  const auto tenths = (bytes + (std::size_t{1} << 30U) / 20) * 10 >> 30U;
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " GB";
}

std::string name_of_signal(int number) {
  const char* words = ::sigdescr_np(number);
  return words ? words : "signal " + std::to_string(number);
}

std::string export_again(MotionFormat format) {
  return format == MotionFormat::Fbx ? "export it again, or as GLB or BVH"
                                     : "export it again, or as FBX or BVH";
}

Error too_much_memory(MotionFormat format, const SceneLimits& limits, const std::string& file) {
  return {"takes more than " + in_gigabytes(limits.memory_bytes) +
              " of memory to read, so it was given up; " + export_again(format) +
              ", the skeletons alone and a shorter range",
          file};
}

Error too_long(MotionFormat format, const SceneLimits& limits, const std::string& file) {
  return {"takes longer than " + std::to_string(limits.processor_s) + " s to read, so it was given up; " +
              export_again(format) + ", the skeletons alone and a shorter range",
          file};
}

Error crashed(MotionFormat format, const std::string& how, const std::string& file) {
  return {"is damaged: the program that reads " + std::string(name_of(format)) + " failed on it (" + how +
              "), and nothing else did; " + export_again(format),
          file};
}

Error useless(const std::string& file) {
  return {"cannot be read: what the program " + std::string(reader_name) +
              " said of it makes no sense; install Abrazo anew, so that all of its parts are of one version",
          file};
}

Result<std::vector<NamedMotion>> motions_of(const HelperAnswer& answer, MotionFormat format,
                                            const SceneLimits& limits, const std::string& file) {
  using End = HelperAnswer::End;
  if (answer.end == End::TooLong) return too_long(format, limits, file);
  if (answer.end == End::TooMuch) return too_much_memory(format, limits, file);
  if (answer.end == End::Signal) {
    if (answer.code == SIGXCPU) return too_long(format, limits, file);
    return crashed(format, name_of_signal(answer.code), file);
  }
  if (answer.end == End::Exit && answer.code == static_cast<int>(SceneReaderExit::OutOfMemory))
    return too_much_memory(format, limits, file);
  if (answer.end == End::Exit && answer.code == static_cast<int>(SceneReaderExit::NoLimits))
    return Error{
        "was not read: the system does not let its memory and time be limited; allow setrlimit to programs",
        file};
  if (answer.end == End::Exit && answer.code != static_cast<int>(SceneReaderExit::Answered) &&
      answer.code != static_cast<int>(SceneReaderExit::WrongUse))
    return crashed(format, "exit status " + std::to_string(answer.code), file);
  SceneAnswer parsed = parse_scene_answer(answer.bytes, file);
  if (!parsed.is_whole) return useless(file);
  return std::move(parsed.motions);
}

}  // namespace

std::vector<fs::path> scene_reader_places() {
  if (const char* named = std::getenv(reader_variable); named && *named) return {named};
  std::vector<fs::path> places;
  for (const fs::path& folder : folders_of_this_code()) {
    places.push_back(folder / reader_name);
    places.push_back(folder / ABRAZO_READER_FROM_PROGRAMS / reader_name);
  }
  return places;
}

SceneLimits scene_limits(std::size_t file_bytes) {
  constexpr std::size_t gigabyte = std::size_t{1} << 30U;
  constexpr std::size_t memory_per_byte = 16, bytes_per_second = 250'000;
  SceneLimits limits;
  const std::size_t wanted = 2 * gigabyte + memory_per_byte * file_bytes;
  limits.memory_bytes =
      std::max<std::size_t>(gigabyte / 2, std::min<std::uint64_t>(wanted, available_memory_bytes()));
  limits.processor_s = static_cast<int>(20 + file_bytes / bytes_per_second);
  limits.wall_s = 3.0 * limits.processor_s;
  return limits;
}

Result<std::vector<NamedMotion>> read_scene_apart(std::string_view bytes, MotionFormat format,
                                                  const std::string& file, const std::string& animation,
                                                  const Progress& progress) {
  const Result<fs::path> program = find_scene_reader(file);
  if (!program) return program.error();
  const SceneLimits limits = scene_limits(bytes.size());
  HelperJob job;
  job.program = *program;
  job.arguments = {std::to_string(static_cast<int>(format)), file, animation,
                   std::to_string(limits.memory_bytes), std::to_string(limits.processor_s)};
  job.input = bytes;
  job.most_bytes = limits.memory_bytes;
  job.patience_s = limits.wall_s;
  job.doing = "reading " + fs::path(file).filename().string();
  const Result<HelperAnswer> answer = run_helper(job, progress);
  if (!answer)
    return Error{answer.error().where.empty()
                     ? answer.error().message
                     : "cannot be read: " + answer.error().text() +
                           "; install Abrazo anew, or look at the limits of the system",
                 file};
  return motions_of(*answer, format, limits, file);
}

}  // namespace abrazo
