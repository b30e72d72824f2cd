#include "app/workbench/document/generated_material.hpp"

#include "core/choreography/fight.hpp"
#include "core/choreography/salsa.hpp"
#include "core/library/build/motion_library_builder.hpp"

namespace abrazo::app {
namespace {

/// A minute of it as the library; half a minute of another, whose first performer plays the user.
template <typename Generate>
Result<Material> generated(const char* name, const char* performer, Generate generate,
                           const Progress& progress) {
  ChoreographyOptions options;
  options.minutes = 1;
  auto library = build_library(name, generate(options, {}), {}, progress);
  if (!library) return library.error();
  Material material;
  material.library = std::make_shared<const MotionLibrary>(std::move(library).value());
  options.seed = 20;
  options.minutes = 0.5;
  options.take_seconds = 30;
  material.input = generate(options, {}).front().a;
  material.input.name = performer;
  return material;
}

}  // namespace

Result<Material> make_demo(const Progress& progress) {
  report(progress, 0, "Generating a dance");
  return generated("generated salsa", "generated leader", generate_salsa, progress);
}

Result<Material> make_fight(const Progress& progress) {
  report(progress, 0, "Generating a fight");
  return generated("generated fight", "generated fighter", generate_fight, progress);
}

}  // namespace abrazo::app
