#pragma once

#include <Eigen/Geometry>
#include <random>
#include <string>

#include "core/session/file/project.hpp"

namespace abrazo::test {

/// Projects with something in every field, different for every seed.
class ProjectMaker {
 public:
  explicit ProjectMaker(unsigned seed) : random_(seed) {}

  Project make() {
    Project project;
    for (int i = 0; i < below(4); ++i) project.data.push_back(reference());
    for (const char* subject : {"", "salsa 1", "Übung, 'zwei'\nneu"})
      if (below(4) > 0) project.annotations[subject] = annotations();
    for (int i = 0; i < below(3); ++i) project.videos.push_back(video(static_cast<int>(project.data.size())));
    for (int i = 0; i < below(6); ++i) project.markers.add(number(), word());
    if (!project.markers.empty()) project.markers.remove(project.markers.all().front().id);
    if (below(2)) project.take_markers["salsa 1"].add(number(), word());
    project.settings.alpha = 0.1 + 0.01 * below(100);
    project.settings.neighbours = 1 + below(50);
    project.settings.user_role = below(2) ? UserRole::Passive : UserRole::Active;
    if (below(2)) project.decisions.pinned = below(1000);
    project.decisions.vetoes.takes.insert(word());
    if (below(2)) project.decisions.meant = IntendedMove{word(), std::nullopt, number(), true};
    project.decisions.role_control = RoleControl::Library;
    project.input = word();
    project.library = below(2) ? "" : "generated salsa";
    project.manifest = below(2) ? "" : R"({"name":"x","takes":[]})";
    project.presets = R"({"abrazo_presets":1,"presets":[]})";
    for (int i = 0; i < below(5); ++i)
      project.view["view " + std::to_string(i)] = word() + std::string("\0z", 2);
    return project;
  }

  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
  double number() { return std::uniform_real_distribution<double>(-1000, 1000)(random_); }
  std::string word() {
    static const char* const words[] = {"turn", "", "dip, low", "O'Brien \"x\"", "línea\n2", "\x01\x7f"};
    return words[below(6)];
  }

 private:
  DataReference reference() {
    return {static_cast<DataReference::Use>(below(8)), below(2) ? "" : "../data/a b.h5",
            "/somewhere/data/" + word(), static_cast<std::uint64_t>(below(1 << 30)) << 20,
            "0123456789abcdef"};
  }

  Annotations annotations() {
    int next = 1;
    std::vector<AnnotationTier> tiers;
    std::vector<Suggestion> suggestions;
    for (int t = 0; t < below(4); ++t) {
      AnnotationTier tier{next++, "tier " + std::to_string(t), static_cast<TierKind>(below(3)), {}, {}};
      for (int i = 0; i < below(4); ++i)
        tier.vocabulary.push_back({word() + std::to_string(i), word(),
                                   below(2) ? std::optional<std::uint32_t>(below(1 << 24)) : std::nullopt,
                                   below(2) ? static_cast<char>('1' + i) : '\0'});
      double at = number();
      for (int i = 0; i < below(20); ++i) {
        const double start = at += below(2) ? 0 : 0.3;
        at += 0.1 + 0.001 * below(1000);
        tier.annotations.push_back({{start, at, word(), word(), word()}, next += 1 + below(2)});
        ++next;
      }
      for (int i = 0; i < below(3); ++i)
        suggestions.push_back(
            {next++, tier.id, 1.5, 2 + number() * 1e-4 + 1, word(), 0.01 * below(101), word()});
      tiers.push_back(std::move(tier));
    }
    return *Annotations::restored(std::move(tiers), std::move(suggestions), next + below(5));
  }

  ProjectVideo video(int references) {
    ProjectVideo video;
    video.data = references == 0 ? -1 : below(references + 1) - 1;
    video.subject = word();
    video.sync.rate = 0.5 + 0.01 * below(100);
    for (int i = 0; i < below(3); ++i)
      video.sync.points.push_back({i + number() * 1e-4, 2 * i + number() * 1e-4});
    if (below(2)) {
      CameraModel camera;
      camera.intrinsics = {1920, 1080, 1001 + number(), 1001 + number(), number(), number(), {}};
      for (double& k : camera.intrinsics.distortion) k = number() * 1e-3;
      camera.pose.rotation =
          Eigen::Quaterniond(number(), number(), number(), number()).normalized().toRotationMatrix();
      camera.pose.translation = Vec3(number(), number(), number());
      video.camera = camera;
    }
    for (int i = 0; i < below(9); ++i)
      video.picked.push_back(
          {Vec3(number(), number(), number()), Pixel(number(), number()), below(51) - 1, number()});
    return video;
  }

  std::mt19937 random_;
};

}  // namespace abrazo::test
