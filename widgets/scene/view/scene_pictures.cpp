#include "widgets/scene/view/scene_pictures.hpp"

#include <QGuiApplication>
#include <QPainter>
#include <QPixmap>
#include <QScreen>

#include "widgets/scene/view/scene_view.hpp"

namespace abrazo::widgets {

ScenePictures::ScenePictures(QSize size, const Look& look)
    : m_size(size), m_captions(look.captions), m_look(look) {
  open(size);
  m_scene->setLibrary(look.library);
  m_scene->setCharacters(look.characters, look.stances);
  m_scene->setColours(palette_of(look.theme));
  m_scene->setVisibility(look.visibility);
}

ScenePictures::ScenePictures(QSize size, const SceneView& like, bool captions)
    : m_size(size), m_captions(captions) {
  open(size);
  m_scene->showAs(like, captions);
}

ScenePictures::~ScenePictures() = default;

void ScenePictures::open(QSize size) {
  m_scene = std::make_unique<SceneView>();
  m_scene->setAttribute(Qt::WA_DontShowOnScreen);
  const double ratio = QGuiApplication::primaryScreen()->devicePixelRatio();
  m_scene->setMinimumSize(1, 1);
  m_scene->setFixedSize((QSizeF(size) / ratio).toSize());
  m_scene->show();
}

/// The camera is placed on the first frame; what would be an animation on a screen is done immediately.
void ScenePictures::begin(const FrameSnapshotPtr& frame) {
  m_scene->showFrame(frame);
  if (frame->result.selected < 0) m_scene->frameAll();  // else the scene has done it by itself
  m_scene->becomePicture(m_captions);
  if (const auto& direction = m_look->direction) {
    m_scene->lookFrom((*direction)[0], (*direction)[1]);
    m_scene->becomePicture(m_captions);
    m_scene->frameAll();
    m_scene->becomePicture(m_captions);
  }
  m_look.reset();
}

QImage ScenePictures::picture(const FrameSnapshotPtr& frame) {
  if (m_look && frame) begin(frame);
  m_scene->showFrame(frame);
  if (!m_captions) return fitted(m_scene->picture(), m_size);
  m_scene->renderSharp();
  return fitted(m_scene->grab().toImage(), m_size);
}

QImage fitted(const QImage& picture, QSize size) {
  if (picture.size() == size) return picture.convertToFormat(QImage::Format_RGB888);
  QImage scaled = picture.scaled(size, Qt::KeepAspectRatio, Qt::SmoothTransformation);
  scaled.setDevicePixelRatio(1);
  QImage film(size, QImage::Format_RGB888);
  film.fill(Qt::black);
  QPainter painter(&film);
  painter.drawImage((size.width() - scaled.width()) / 2, (size.height() - scaled.height()) / 2, scaled);
  return film;
}

}  // namespace abrazo::widgets
