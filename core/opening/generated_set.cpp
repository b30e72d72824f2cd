#include "core/opening/generated_set.hpp"

#include <map>
#include <mutex>
#include <string>

#include "core/choreography/fight.hpp"
#include "core/choreography/salsa.hpp"
#include "core/library/build/motion_library_builder.hpp"

namespace abrazo {
namespace {

constexpr const char* dance_name = "generated salsa";
constexpr const char* fight_name = "generated fight";

/// A minute of it as the library; half a minute of another, whose first performer plays the user.
template <typename Generate>
Result<Material> make(const char* name, const char* performer, Generate generate, const Progress& progress) {
  ChoreographyOptions options;
  options.minutes = 1;
  auto library = build_library(name, generate(options, {}), {}, progress);
  if (!library) return library.error();
  Material material;
  material.library = std::make_shared<const MotionLibrary>(std::move(library).value());
  material.is_generated = true;
  options.seed = 20;
  options.minutes = 0.5;
  options.take_seconds = 30;
  material.input = generate(options, {}).front().a;
  material.input.name = performer;
  return material;
}

/// Whoever makes it first; the same for everyone after. What failed or was cancelled is not kept.
template <typename Generate>
Result<Material> generated(const char* name, const char* performer, Generate generate,
                           const Progress& progress) {
  static std::mutex mutex;
  static std::map<std::string, Material> made;
  const std::lock_guard lock(mutex);
  const auto found = made.find(name);
  if (found != made.end()) return found->second;
  auto material = make(name, performer, generate, progress);
  if (material) made.emplace(name, material.value());
  return material;
}

}  // namespace

Result<Material> generated_dance(const Progress& progress) {
  report(progress, 0, "Generating a dance");
  return generated(dance_name, "generated leader", generate_salsa, progress);
}

Result<Material> generated_fight(const Progress& progress) {
  report(progress, 0, "Generating a fight");
  return generated(fight_name, "generated fighter", generate_fight, progress);
}

GenerateMaterial generated_of_name(const std::string& library) {
  if (library == dance_name) return generated_dance;
  return library == fight_name ? generated_fight : nullptr;
}

}  // namespace abrazo
