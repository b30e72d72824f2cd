#include "app/workbench/export/export_words.hpp"

#include <array>

#include "app/workbench/base/range_words.hpp"

namespace abrazo::app {
namespace {

struct TypeWords {
  const char *ending, *words;
};
constexpr std::array<TypeWords, 14> type_words = {{
    {".glb", "glTF binary (.glb): skinned bodies for Blender, engines, viewers"},
    {".bvh", "BVH (.bvh): skeletons for animation tools"},
    {".csv", "Table (.csv)"},
    {".npz", "NumPy (.npz): positions with names, rate, unit and axis"},
    {".npy", "NumPy (.npy): positions of one body"},
    {".vtu", "VTK mesh (.vtu): one frame for ParaView"},
    {".pvd", "VTK series (.pvd and .vtu): for ParaView"},
    {".eaf", "ELAN (.eaf)"},
    {".json", "JSON (.json)"},
    {".TextGrid", "Praat (.TextGrid)"},
    {".txt", "Audacity label track (.txt)"},
    {".jsonl", "JSON lines (.jsonl): every frame with its reasons"},
    {".png", "Picture (.png)"},
    {".svg", "Drawing (.svg)"},
}};
constexpr std::array<TypeWords, 2> character_words = {{
    {".glb", "glTF binary (.glb): the character, a file for each body"},
    {".vrm", "VRM (.vrm): the character, a file for each body"},
}};

QString label_content_words(const ExportWish& wish) {
  if (wish.is_label_file())
    return "The moves alone, a row for each: take, first frame, end frame, label. Other tiers are left out.";
  if (wish.all_tiers) return "Every tier, a row for each label: tier, start and end in seconds, label.";
  return "Every tier.";
}

QString body_words(SessionBody body) {
  return body == SessionBody::User ? "user" : body == SessionBody::Active ? "leader" : "follower";
}

QString motion_content_words(const ExportWish& wish) {
  QStringList bodies, files;
  for (const SessionBody body : wish.bodies) bodies << body_words(body);
  const QString last = bodies.isEmpty() ? QString() : bodies.takeLast();
  const QString who = "The " + (bodies.isEmpty() ? last : bodies.join(", ") + " and " + last);
  if (!wish.character.empty()) {
    for (const std::string& file : wish.files()) files << QString::fromStdString(file);
    return QString("%1, performed by the character: %2. Without a character there are other file types.")
        .arg(who, files.join(", "));
  }
  if (wish.bodies.size() < 2) return who + " alone.";
  if (wish.output.ends_with(".bvh"))
    return who +
           " in one file, a root for each. Blender and MotionBuilder expect a single root: export the "
           "bodies one by one for them.";
  return who + " in one file.";
}

QString size_words(std::uint64_t bytes) {
  if (bytes < 1'000'000) return QString("%1 kB").arg((bytes + 999) / 1000);
  return QString("%1 MB").arg(static_cast<double>(bytes) / 1e6, 0, 'f', bytes < 10'000'000 ? 1 : 0);
}

}  // namespace

QString export_type_words(const QString& ending) {
  for (const TypeWords& type : type_words)
    if (ending == type.ending) return type.words;
  return ending;
}

QString character_type_words(const QString& ending) {
  for (const TypeWords& type : character_words)
    if (ending == type.ending) return type.words;
  return ending;
}

QStringList all_export_type_words() {
  QStringList all;
  for (const TypeWords& type : character_words) all << type.words;
  for (const TypeWords& type : type_words) all << type.words;
  return all;
}

QString export_content_words(const ExportWish& wish) {
  switch (wish.content) {
    case ExportContent::Motion:
      return motion_content_words(wish);
    case ExportContent::Labels:
      return label_content_words(wish);
    case ExportContent::Mesh:
    case ExportContent::Trace:
      break;
  }
  return {};
}

QString export_plan_words(const ExportWish& wish, const ExportPlan& plan) {
  const QString size = "about " + size_words(plan.bytes);
  if (wish.content == ExportContent::Labels) return size.left(1).toUpper() + size.mid(1);
  QString words = counted(plan.frames, "frame");
  if (plan.rate_hz > 0) words += QString(" at %1 Hz").arg(plan.rate_hz, 0, 'g', 6);
  words += ", " + size;
  if (plan.bridged > 0)
    words += QString("\n%1 interpolated across %2 of the recording")
                 .arg(counted(plan.bridged, "frame"), counted(plan.gaps, "gap"));
  return words;
}

}  // namespace abrazo::app
