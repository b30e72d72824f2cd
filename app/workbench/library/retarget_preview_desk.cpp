#include "app/workbench/library/retarget_preview_desk.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/base/job.hpp"
#include "app/workbench/library/retarget_outcome.hpp"
#include "app/workbench/library/retarget_preview.hpp"

namespace abrazo::app {
namespace {

// Around the play position: what is computed first. Fitting a frame takes some 2 ms.
constexpr double near_before_s = 0.1, near_after_s = 0.4;
// While all frames are computed, the next near ones are begun so much before the last ones end.
constexpr double ahead_s = 0.15;

using Files = std::array<std::optional<BodyChoice>, 2>;

std::array<BodyChoice*, 2> bodies_of(RetargetWish& wish) {
  return {&wish.active, &wish.passive};
}

bool are_of_same_file(const BodyChoice& a, const BodyChoice& b) {
  return a.kind == BodyChoice::Kind::OfFile && b.kind == BodyChoice::Kind::OfFile && a.file == b.file;
}

bool give_the_same(const RetargetWish& a, const RetargetWish& b) {
  return a.contacts == b.contacts && a.smoothness == b.smoothness &&
         body_choice_text(a.active) == body_choice_text(b.active) &&
         body_choice_text(a.passive) == body_choice_text(b.passive);
}

QString state_of(const RetargetedTake& take) {
  QString state = outcome_of(take);
  state[0] = state[0].toUpper();
  return state;
}

}  // namespace

/// What a worker made of the frames near the play position.
struct RetargetPreviewDesk::Read {
  std::shared_ptr<const PairedTake> take;
  std::shared_ptr<const RecordedPair> recorded;  ///< all frames of the request
  PreviewedPair::Piece piece;
  Files measured;
};

RetargetPreviewDesk::RetargetPreviewDesk(RetargetPreview& view, QObject* parent)
    : QObject(parent), m_view(view) {
  connect(&view.ticker(), &FrameTicker::playbackChanged, this, &RetargetPreviewDesk::follow);
}

RetargetPreviewDesk::~RetargetPreviewDesk() = default;

bool RetargetPreviewDesk::isOfShownTake(const Request& request) const {
  return m_request && m_take && m_shown.recorded && request.source == m_request->source &&
         request.wish.takes == m_request->wish.takes && request.wish.from == m_request->wish.from &&
         request.wish.to == m_request->wish.to;
}

void RetargetPreviewDesk::show(Request request) {
  const bool is_same_take = isOfShownTake(request);
  if (is_same_take && m_trouble.isEmpty() && give_the_same(request.wish, m_request->wish)) return;
  if (!is_same_take) {
    m_take.reset();
    m_shown = {};
  }
  m_request = std::move(request);
  m_trouble.clear();
  m_isWhole = false;
  m_isNew = true;
  Job::retire(std::move(m_whole), this);
  // The near frames are not cancelled, so that a slider that keeps moving shows bodies all the time.
  if (!m_near) computeNear();
}

void RetargetPreviewDesk::showNothing(const QString& why) {
  Job::retire(std::move(m_whole), this);
  Job::retire(std::move(m_near), this);
  m_request.reset();
  m_take.reset();
  m_measured = {};
  m_shown = {};
  m_view.showNothing();
  m_view.showState(why);
}

RetargetWish RetargetPreviewDesk::measuredWish() const {
  RetargetWish wish = m_request->wish;
  const auto bodies = bodies_of(wish);
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (m_measured[i] && are_of_same_file(*bodies[i], *m_measured[i])) *bodies[i] = *m_measured[i];
  return wish;
}

void RetargetPreviewDesk::computeNear() {
  m_isNew = false;
  // Another recording begins at its beginning.
  const double cursor_s = m_shown.recorded ? m_view.ticker().playback().cursor_s : 0;
  m_near = std::make_unique<Job>([this, request = *m_request, wish = measuredWish(), take = m_take,
                                  recorded = m_shown.recorded,
                                  cursor_s](const Progress& progress) mutable -> Job::Finish {
    const auto failed = [this](const Error& error) {
      return [this, error] {
        if (!m_isNew) fail(error);  // else another request has come
      };
    };
    Read read{std::move(take), std::move(recorded), {}, {}};
    if (!read.take) {
      std::vector<std::string> warnings;
      auto takes = read_takes(request.source, wish.takes, warnings, progress);
      if (!takes) return failed(takes.error());
      read.take = std::make_shared<const PairedTake>(std::move(takes->front()));
    }
    if (!read.recorded) {
      auto part_of_take = cut(recorded_pair_of(*read.take), wish.from, wish.to);
      if (!part_of_take) return failed(part_of_take.error());
      read.recorded = std::make_shared<const RecordedPair>(std::move(*part_of_take));
    }
    const auto bodies = bodies_of(wish);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (const Status measured = measure_file(*bodies[i], progress); !measured)
        return failed(measured.error());
      read.measured[i] = *bodies[i];
    }
    const PreviewedPair all{read.recorded, wish.from, {}};
    read.piece.first = all.frame_at(cursor_s - near_before_s);
    RetargetWish near = wish;
    near.from = wish.from + static_cast<long long>(read.piece.first);
    near.to = wish.from + static_cast<long long>(all.frame_at(cursor_s + near_after_s)) + 1;
    auto made = retarget_take(*read.take, near, progress);
    if (!made) return failed(made.error());
    read.piece.pair = std::make_shared<const RetargetedPair>(std::move(made->pair));
    return [this, read, request] {
      // Of a take that is not asked for any more nothing is shown.
      if (m_request && request.wish.takes == m_request->wish.takes && request.source == m_request->source &&
          request.wish.from == m_request->wish.from && request.wish.to == m_request->wish.to)
        takeNear(read);
    };
  });
  connect(m_near.get(), &Job::finished, this, [this] {
    m_near.release()->deleteLater();  // it is what speaks
    if (!m_request || !m_trouble.isEmpty()) return;
    if (m_isNew) return computeNear();
    if (!m_whole && !m_isWhole) computeWhole();
  });
}

void RetargetPreviewDesk::takeNear(const Read& read) {
  m_take = read.take;
  m_measured = read.measured;
  const bool is_other = m_shown.recorded != read.recorded;
  if (is_other) m_shown = {read.recorded, m_request->wish.from, {}};
  if (m_isWhole) return;
  // Until all frames of these bodies are there, those elsewhere are of the previous bodies.
  constexpr std::size_t most_pieces = 64;
  if (m_shown.pieces.size() >= most_pieces) m_shown.pieces.erase(m_shown.pieces.begin() + 1);
  m_shown.pieces.push_back(read.piece);
  if (is_other)
    m_view.showRecording(m_shown, m_request->source.library);
  else
    m_view.showPieces(m_shown);
}

void RetargetPreviewDesk::computeWhole() {
  m_whole = std::make_unique<Job>(
      [this, take = m_take, wish = measuredWish()](const Progress& progress) -> Job::Finish {
        auto made = retarget_take(*take, wish, progress);
        if (!made) return [this, error = made.error()] { fail(error); };
        return [this, whole = std::make_shared<const TakeOnBodies>(std::move(*made))] { takeWhole(whole); };
      });
  connect(m_whole.get(), &Job::progressed, this, [this](double done, const QString& doing) {
    m_view.showState(QString("Computing all frames: %1, %2 %").arg(doing).arg(static_cast<int>(100 * done)));
  });
  connect(m_whole.get(), &Job::finished, this, [this] {
    m_whole.release()->deleteLater();  // it is what speaks
    if (m_isWhole) emit completed();
  });
}

void RetargetPreviewDesk::takeWhole(const std::shared_ptr<const TakeOnBodies>& made) {
  m_isWhole = true;
  m_shown.pieces = {{std::shared_ptr<const RetargetedPair>(made, &made->pair), 0}};  // not copied
  m_view.showPieces(m_shown);
  m_view.showState(state_of(made->described()));
}

/// A playing cursor leaves the near frames before all are there.
void RetargetPreviewDesk::follow(const Playback& playback) {
  if (!m_request || !m_shown.recorded || m_near || m_isWhole || !m_trouble.isEmpty()) return;
  const double ahead = playback.state == Playback::State::Playing ? ahead_s * playback.speed : 0;
  const PreviewedPair::Piece& newest = m_shown.pieces.back();
  if (newest.has(m_shown.frame_at(playback.cursor_s)) &&
      newest.has(m_shown.frame_at(playback.cursor_s + ahead)))
    return;
  computeNear();
}

void RetargetPreviewDesk::fail(const Error& error) {
  m_trouble = words(error);
  if (!m_shown.recorded) m_view.showNothing();
  m_view.showState(m_trouble.left(1).toUpper() + m_trouble.mid(1));
}

}  // namespace abrazo::app
