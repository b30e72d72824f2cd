#include "app/render/rendering.hpp"

#include <fmt/format.h>

#include <QBuffer>
#include <QCoreApplication>
#include <numbers>

#include "core/base/file_series.hpp"
#include "core/motion/scenes/read_worn_character.hpp"
#include "core/video/film_plan.hpp"
#include "core/video/video_writer.hpp"
#include "widgets/scene/view/scene_pictures.hpp"

namespace abrazo::app {
namespace {

constexpr double rounding_s = 1e-6;

/// Where pictures go.
class PictureSink {
 public:
  virtual ~PictureSink() = default;
  virtual Status add(const QImage& picture) = 0;
  virtual Status finish() { return Done{}; }
};

class FilmSink : public PictureSink {
 public:
  explicit FilmSink(VideoWriter video) : m_video(std::move(video)) {}
  Status add(const QImage& picture) override {
    return m_video.add({picture.constBits(), static_cast<std::size_t>(picture.sizeInBytes())},
                       static_cast<std::size_t>(picture.bytesPerLine()));
  }
  Status finish() override { return m_video.finish(); }

 private:
  VideoWriter m_video;
};

/// One picture or a series, under their names only when the last one is there: an older series stays until
/// then.
class FileSink : public PictureSink {
 public:
  FileSink(std::string output, bool is_series) : m_output(std::move(output)), m_isSeries(is_series) {}
  Status add(const QImage& picture) override {
    const std::string name = m_isSeries ? series_name(m_output, m_count) : m_output;
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (!picture.save(&buffer, "PNG")) return Error{"the picture cannot be coded as PNG", name};
    ++m_count;
    return m_files.add(name, bytes.toStdString());
  }
  Status finish() override { return m_files.commit(); }

 private:
  std::string m_output;
  bool m_isSeries;
  int m_count = 0;
  FileSeries m_files;
};

Result<std::unique_ptr<PictureSink>> open_sink(const RenderOptions& options, RenderKind kind) {
  if (kind != RenderKind::Film)
    return std::unique_ptr<PictureSink>(
        std::make_unique<FileSink>(options.output, kind == RenderKind::Series));
  const PictureSize size = picture_size(options.size).value();
  auto video = VideoWriter::open(options.output, size.width, size.height, options.rate_hz);
  if (!video) return video.error();
  return std::unique_ptr<PictureSink>(std::make_unique<FilmSink>(std::move(video).value()));
}

Result<FilmPlan> plan_of(const FrameSource& source, const RenderOptions& options, RenderKind kind) {
  constexpr int most_pictures = 10'000'000;
  FilmPlan plan{options.from_s.value_or(source.first_s), options.to_s.value_or(source.last_s),
                options.rate_hz};
  const auto within = [&](double time_s) {
    return time_s >= source.first_s - rounding_s && time_s <= source.last_s + rounding_s;
  };
  for (const auto& [asked, word] : {std::pair{options.from_s, "--from"}, std::pair{options.to_s, "--to"}})
    if (asked && !within(*asked))
      return Error{fmt::format("{} {} is outside of what was recorded, {:.3f} to {:.3f} s", word, *asked,
                               source.first_s, source.last_s),
                   options.input};
  if (kind == RenderKind::Picture) plan.to_s = plan.from_s;
  if (plan.to_s < plan.from_s)
    return Error{fmt::format("--to {} is before the first frame, {:.3f} s", plan.to_s, plan.from_s),
                 options.input};
  if ((plan.to_s - plan.from_s) * plan.rate_hz > most_pictures)
    return Error{"would be more than 10 million pictures; choose a part with --from and --to", options.input};
  return plan;
}

widgets::ScenePictures::Look look_of(const FrameSource& source, const RenderOptions& options) {
  widgets::ScenePictures::Look look;
  look.library = source.library;
  look.theme = options.theme == "light" ? widgets::Theme::Light : widgets::Theme::Dark;
  look.captions = options.captions == "on";
  const auto show = [&look](widgets::ScenePart part, bool shown) {
    look.visibility[static_cast<std::size_t>(part)] = shown;
  };
  if (options.mesh == "off")
    for (const auto part : {widgets::ScenePart::MeshBetween, widgets::ScenePart::MeshWithin})
      show(part, false);
  if (options.user == "off") show(widgets::ScenePart::User, false);
  show(widgets::ScenePart::LookAhead, options.ahead == "on");
  std::optional<ViewDirection> direction;
  view_direction(options.camera, direction);
  constexpr double rad = std::numbers::pi / 180;
  if (direction) look.direction = {{direction->azimuth_deg * rad, direction->elevation_deg * rad}};
  return look;
}

/// The characters' files, read; each file once.
Result<widgets::WornPair> characters_of(const RenderOptions& options) {
  widgets::WornPair characters;
  const std::array<const std::string*, 2> files = {&options.active_character, &options.passive_character};
  for (std::size_t body = 0; body < 2; ++body) {
    if (files[body]->empty()) continue;
    if (body == 1 && characters[0] && *files[1] == *files[0]) {
      characters[1] = characters[0];
      continue;
    }
    auto read = read_worn_character(*files[body]);
    if (!read) return read.error();
    characters[body] = std::move(*read);
  }
  return characters;
}

/// Measured from frames that are spread over the whole recording, so that a part of it looks like all of it.
Result<std::array<Stance, 2>> stances_of(const FrameSource& source) {
  constexpr int most_frames = 200;
  std::array<std::vector<Pose>, 2> poses;
  for (int i = 0; i < most_frames; ++i) {
    const auto frame = source.at(source.first_s + (source.last_s - source.first_s) * i / (most_frames - 1));
    if (!frame) return frame.error();
    if (!*frame) continue;
    poses[0].push_back((*frame)->result.active());
    poses[1].push_back((*frame)->result.passive());
  }
  return std::array<Stance, 2>{stance_of(poses[0]), stance_of(poses[1])};
}

}  // namespace

Result<Rendered> render(const FrameSource& source, const RenderOptions& options, const Progress& progress) {
  const auto kind = render_kind(options.output);
  if (!kind) return kind.error();
  const auto plan = plan_of(source, options, *kind);
  if (!plan) return plan.error();
  widgets::ScenePictures::Look look = look_of(source, options);
  auto characters = characters_of(options);
  if (!characters) return characters.error();
  look.characters = std::move(*characters);
  if (look.characters[0] || look.characters[1]) {
    const auto stances = stances_of(source);
    if (!stances) return stances.error();
    look.stances = *stances;
  }
  auto sink = open_sink(options, *kind);
  if (!sink) return sink.error();
  const PictureSize size = picture_size(options.size).value();
  widgets::ScenePictures pictures(QSize(size.width, size.height), look);
  for (int i = 0; i < plan->pictures(); ++i) {
    if (!report(progress, static_cast<double>(i) / plan->pictures(),
                fmt::format("picture {} of {}", i + 1, plan->pictures())))
      return Error{"was stopped; nothing was written", options.output};
    const auto frame = source.at(plan->time_of(i) + rounding_s);
    if (!frame) return frame.error();
    if (const Status added = (*sink)->add(pictures.picture(*frame)); !added) return added.error();
    QCoreApplication::processEvents();
  }
  report(progress, 1, "done");
  if (const Status finished = (*sink)->finish(); !finished) return finished.error();
  return Rendered{*kind == RenderKind::Series ? series_name(options.output, 0) : options.output,
                  plan->pictures()};
}

}  // namespace abrazo::app
