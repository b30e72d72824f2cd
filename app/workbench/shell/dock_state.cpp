#include "app/workbench/shell/dock_state.hpp"

#include <QDataStream>

namespace abrazo::app {
namespace {

// Markers in the bytes since Qt 4.3.
constexpr int version_mark = 0xff;
constexpr quint8 areas_mark = 0xfd, tool_bars_mark = 0xfc;
constexpr quint8 sequence_mark = 0xfc, tabs_mark = 0xfa, panel_mark = 0xfb;
constexpr quint8 floating_flag = 2, all_flags = 3;

constexpr int areas = 4, most_items = 64, deepest = 8;
constexpr int farthest_px = 1 << 16;  // from the middle of the screens; no side is longer
constexpr int longest_dock_name = 100;

/// Reads piece by piece; once something was wrong everything after it is.
class DockStateReader {
 public:
  explicit DockStateReader(const QByteArray& bytes) : m_stream(bytes) {
    m_stream.setVersion(QDataStream::Qt_5_0);
  }

  bool reads(int version) {
    expect(number() == version_mark && number() == version);
    expect(mark() == areas_mark);
    readAreas();
    expect(mark() == tool_bars_mark && number() == 0);
    return m_isGood && m_stream.atEnd();
  }

 private:
  void expect(bool holds) { m_isGood = m_isGood && holds && m_stream.status() == QDataStream::Ok; }
  quint8 mark() {
    quint8 value = 0;
    m_stream >> value;
    return value;
  }
  int number() {
    qint32 value = 0;
    m_stream >> value;
    return value;
  }
  int numberWithin(int least, int most) {
    const int value = number();
    expect(value >= least && value <= most);
    return value;
  }

  void readAreas() {
    const int count = numberWithin(0, areas);
    int before = -1;
    for (int area = 0; m_isGood && area < count; ++area) {
      before = numberWithin(before + 1, areas - 1);
      readSize();
      readItems(0);
    }
    readSize();  // of the central widget
    for (int corner = 0; corner < 4; ++corner) {
      const int side = number();
      expect(side == Qt::LeftDockWidgetArea || side == Qt::RightDockWidgetArea ||
             side == Qt::TopDockWidgetArea || side == Qt::BottomDockWidgetArea);
    }
  }
  void readSize() {
    for (int side = 0; side < 2; ++side) numberWithin(-1, farthest_px);
  }

  /// Panels beside one another, or behind tabs.
  void readItems(int depth) {
    const quint8 kind = mark();
    expect((kind == sequence_mark || kind == tabs_mark) && depth < deepest);
    const int shown = kind == tabs_mark ? numberWithin(-1, most_items) : -1;
    const quint8 orientation = mark();
    expect(orientation == Qt::Horizontal || orientation == Qt::Vertical);
    const int count = numberWithin(1, most_items);
    expect(shown < count);
    for (int item = 0; m_isGood && item < count; ++item) {
      const quint8 what = mark();
      expect(what == panel_mark || what == sequence_mark);
      if (what == panel_mark) {
        readPanel();
      } else {
        readExtent();
        if (m_isGood) readItems(depth + 1);
      }
    }
  }
  void readPanel() {
    const int bytes =
        numberWithin(2, 2 * longest_dock_name);  // before the name is read, which would take as much memory
    expect(m_isGood && bytes % 2 == 0 && m_stream.skipRawData(bytes) == bytes);
    const quint8 flags = mark();
    expect(flags <= all_flags);
    if ((flags & floating_flag) == 0) return readExtent();
    for (int corner = 0; corner < 2; ++corner) numberWithin(-farthest_px, farthest_px);
    for (int side = 0; side < 2; ++side) numberWithin(0, farthest_px);
  }
  /// Place and length along the row, then its limits, which Qt takes from the panel itself.
  void readExtent() {
    for (int value = 0; value < 2; ++value) numberWithin(-1, farthest_px);
    number();
    number();
  }

  QDataStream m_stream;
  bool m_isGood = true;
};

}  // namespace

bool is_dock_state(const QByteArray& bytes, int version) {
  return DockStateReader(bytes).reads(version);
}

}  // namespace abrazo::app
