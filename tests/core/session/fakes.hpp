#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/session/frames/frame_listener.hpp"
#include "core/session/run/session_openers.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::test {

/// A device: gives out the poses that a test hands in.
class FakeDevice : public PoseSource {
 public:
  std::optional<SourcePose> poll(double) override {
    const std::scoped_lock lock(mutex_);
    if (waiting_.empty()) return std::nullopt;
    SourcePose newest = waiting_.back();
    newest.dropped = dropped_ += waiting_.size() - 1;
    waiting_.clear();
    return newest;
  }
  double next_due_s() const override { return 1e9; }
  double rate_hz() const override { return 60; }
  void set_max_rate(double) override {}
  std::optional<Body> body() const override {
    const std::scoped_lock lock(mutex_);
    return body_;
  }
  void on_arrival(std::function<void()> called) override {
    const std::scoped_lock lock(mutex_);
    called_ = std::move(called);
  }

  void arrive(const SourcePose& pose) {
    std::function<void()> called;
    {
      const std::scoped_lock lock(mutex_);
      waiting_.push_back(pose);
      called = called_;
    }
    if (called) called();
  }
  void measure(const Body& body) {
    const std::scoped_lock lock(mutex_);
    body_ = body;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<SourcePose> waiting_;
  std::optional<Body> body_;
  std::function<void()> called_;
  std::uint64_t dropped_ = 0;
};

/// A device as somebody's `unique_ptr`, while the test keeps its hand on it.
class SharedDevice : public PoseSource {
 public:
  explicit SharedDevice(std::shared_ptr<FakeDevice> device) : device_(std::move(device)) {}
  std::optional<SourcePose> poll(double now_s) override { return device_->poll(now_s); }
  double next_due_s() const override { return device_->next_due_s(); }
  double rate_hz() const override { return device_->rate_hz(); }
  void set_max_rate(double rate_hz) override { device_->set_max_rate(rate_hz); }
  std::optional<Body> body() const override { return device_->body(); }
  void on_arrival(std::function<void()> called) override { device_->on_arrival(std::move(called)); }

 private:
  std::shared_ptr<FakeDevice> device_;
};

class FakeSink : public PoseSink {
 public:
  void send(const OutgoingPose& pose) override {
    const std::scoped_lock lock(mutex_);
    sent_.push_back(pose);
  }
  void set_body(const Body& body) override {
    const std::scoped_lock lock(mutex_);
    bodies_.push_back(body);
  }
  SinkHealth health() const override {
    const std::scoped_lock lock(mutex_);
    SinkHealth health;
    health.frames = sent_.size();
    return health;
  }
  std::vector<OutgoingPose> sent() const {
    const std::scoped_lock lock(mutex_);
    return sent_;
  }
  /// It was told, the latest last.
  std::vector<Body> bodies() const {
    const std::scoped_lock lock(mutex_);
    return bodies_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<OutgoingPose> sent_;
  std::vector<Body> bodies_;
};

class FakeListener : public FrameListener {
 public:
  void frame_solved(const FrameSnapshotPtr& frame) override {
    const std::scoped_lock lock(mutex_);
    frames_.push_back(frame);
  }
  std::vector<FrameSnapshotPtr> frames() const {
    const std::scoped_lock lock(mutex_);
    return frames_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<FrameSnapshotPtr> frames_;
};

}  // namespace abrazo::test
