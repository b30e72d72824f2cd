#pragma once

// Waiting for what a running window does.

#include <QElapsedTimer>
#include <QTest>

namespace abrazo::app {

/// Whether `reached` came true while events were handled. The patience only bounds how long a test that
/// fails takes: it is far above what a busy machine needs, so that no test says anything about speed.
template <typename Condition>
bool until(Condition reached, int patience_ms = 120'000) {
  QElapsedTimer clock;
  clock.start();
  // Asked once a turn: what came true need not be true of a second look, when another frame has come.
  while (!reached()) {
    if (clock.elapsed() >= patience_ms) return false;
    QTest::qWait(10);
  }
  return true;
}

}  // namespace abrazo::app
