#pragma once

#include <QObject>
#include <array>
#include <memory>
#include <optional>

#include "app/workbench/library/retargeted_frames.hpp"
#include "app/workbench/library/take_source.hpp"
#include "core/bodies/take_retargeting.hpp"
#include "core/session/frames/playback.hpp"

namespace abrazo::app {

class Job;
class RetargetPreview;

/// Computes what the preview shows, on workers: first the frames around the play position, within a fraction
/// of a second, then all of them, as they will be written. A new request replaces the running one.
class RetargetPreviewDesk : public QObject {
  Q_OBJECT
 public:
  RetargetPreviewDesk(RetargetPreview& view, QObject* parent);
  ~RetargetPreviewDesk() override;

  struct Request {
    TakeSource source;
    RetargetWish wish;  ///< of one take; its files do not matter
  };
  void show(Request request);
  /// @param why  for the person
  void showNothing(const QString& why);

  bool isComputing() const { return m_near || m_whole; }
  /// What is shown; null pointers before the first take was read.
  const PreviewedPair& shown() const { return m_shown; }

 signals:
  /// All frames are there.
  void completed();

 private:
  struct Read;
  void computeNear();
  void takeNear(const Read& read);
  void computeWhole();
  void takeWhole(const std::shared_ptr<const TakeOnBodies>& made);
  void follow(const Playback& playback);
  void fail(const Error& error);
  RetargetWish measuredWish() const;
  bool isOfShownTake(const Request& request) const;

  RetargetPreview& m_view;
  std::optional<Request> m_request;
  bool m_isNew = false;                                 ///< nothing of the request is computed yet
  std::shared_ptr<const PairedTake> m_take;             ///< of the request; null before it was read
  std::array<std::optional<BodyChoice>, 2> m_measured;  ///< files of the last requests
  PreviewedPair m_shown;
  bool m_isWhole = false;
  QString m_trouble;
  std::unique_ptr<Job> m_near, m_whole;
};

}  // namespace abrazo::app
