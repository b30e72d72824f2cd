#include "widgets/timeline/timeline_accessible.hpp"

#include <QAccessibleWidget>

#include "core/session/frames/time_place.hpp"
#include "widgets/timeline/timeline_view.hpp"

namespace abrazo::widgets {
namespace {

class AccessibleTimeline : public QAccessibleWidget, public QAccessibleValueInterface {
 public:
  explicit AccessibleTimeline(TimelineView* view) : QAccessibleWidget(view, QAccessible::Slider) {}

  void* interface_cast(QAccessible::InterfaceType type) override {
    if (type == QAccessible::ValueInterface) return static_cast<QAccessibleValueInterface*>(this);
    return QAccessibleWidget::interface_cast(type);
  }
  QString text(QAccessible::Text what) const override {
    if (what != QAccessible::Value) return QAccessibleWidget::text(what);
    const Playback& playback = view()->playback();
    const QString time = QString::fromStdString(clock_text(playback.cursor_s));
    switch (playback.state) {
      case Playback::State::Following:
        return time + ", live";
      case Playback::State::Playing:
        return time + ", playing";
      case Playback::State::Parked:
        break;
    }
    if (view()->lanes().is_of_take()) return time + ", parked";
    return time + QString(", parked %1 s behind live").arg(playback.behind_live_s(), 0, 'f', 1);
  }
  QVariant currentValue() const override { return view()->playback().cursor_s; }
  void setCurrentValue(const QVariant& value) override { view()->askSeek(value.toDouble()); }
  QVariant minimumValue() const override { return view()->playback().first_s; }
  QVariant maximumValue() const override { return view()->playback().last_s; }
  QVariant minimumStepSize() const override { return view()->axis().seconds_per_pixel(); }

 private:
  TimelineView* view() const { return static_cast<TimelineView*>(widget()); }
};

QAccessibleInterface* make(const QString&, QObject* object) {
  auto* view = qobject_cast<TimelineView*>(object);
  return view ? new AccessibleTimeline(view) : nullptr;
}

}  // namespace

void install_timeline_accessibility() {
  QAccessible::installFactory(make);  // keeps each factory once
}

}  // namespace abrazo::widgets
