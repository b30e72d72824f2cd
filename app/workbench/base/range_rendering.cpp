#include "app/workbench/base/range_rendering.hpp"

#include "widgets/scene/view/scene_pictures.hpp"

namespace abrazo::app {
namespace {

constexpr int breath_ms = 4;  // for the window, between two pictures

}  // namespace

RangeRendering::RangeRendering(FrameRange frames, QObject* parent)
    : QObject(parent), m_isEmpty(frames.empty()), m_frames(std::move(frames)) {
  m_timer.setSingleShot(true);
  m_timer.setInterval(breath_ms);
  connect(&m_timer, &QTimer::timeout, this, &RangeRendering::step);
}

RangeRendering::~RangeRendering() = default;

QString RangeRendering::start(const RangeRequest& request, const widgets::SceneView& like) {
  if (m_isEmpty) return "There is no frame in this range; choose another";
  m_request = request;
  m_writer = std::make_unique<FilmWriter>(request.file, request.size, request.plan.rate_hz);
  m_pictures = std::make_unique<widgets::ScenePictures>(request.size, like, request.captions);
  connect(m_writer.get(), &FilmWriter::hasRoom, this, [this] {
    if (!m_timer.isActive()) m_timer.start();
  });
  connect(m_writer.get(), &FilmWriter::ended, this, &RangeRendering::end);
  m_running.emplace(
      [this] { QMetaObject::invokeMethod(this, &RangeRendering::cancel, Qt::QueuedConnection); });
  m_timer.start();
  return {};
}

QImage RangeRendering::picture(double time_s) {
  constexpr double rounding_s = 1e-6;
  return m_pictures->picture(m_frames.at(time_s + rounding_s));
}

void RangeRendering::step() {
  const int all = m_request.plan.pictures();
  if (!m_writer || m_writer->isFull() || m_done >= all) return;  // continues with hasRoom
  m_writer->offer(picture(m_request.plan.time_of(m_done)));
  ++m_done;
  emit progressed(m_done, all);
  m_done < all ? m_timer.start() : m_writer->finish();
}

void RangeRendering::cancel() {
  m_timer.stop();
  m_writer.reset();
  m_pictures.reset();
  m_running.reset();
}

void RangeRendering::end(const QString& trouble) {
  m_timer.stop();
  m_pictures.reset();
  m_writer.release()->deleteLater();  // it is what speaks
  m_running.reset();
  emit ended(trouble);
}

}  // namespace abrazo::app
