#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/stream/protocol/stream_health.hpp"

namespace abrazo::widgets {

/// A sink with its present rates.
struct SinkRow {
  SinkHealth health;
  double packets_per_s = 0;
};

/// Converts the counters of sinks to rates. The caller passes the time.
class SinkRates {
 public:
  /// @param now_s later than at the previous call
  std::vector<SinkRow> update(const std::vector<SinkHealth>& sinks, double now_s) {
    std::vector<SinkRow> rows;
    std::map<std::string, Count> counts;
    for (const SinkHealth& sink : sinks) {
      const std::string key = sink.character + " " + sink.uri;
      Count count{now_s, sink.packets, 0};
      const auto before = counts_.find(key);
      if (before != counts_.end() && sink.packets >= before->second.packets) {
        const double elapsed_s = now_s - before->second.since_s;
        // A shorter interval gives noisy rates.
        constexpr double shortest_s = 0.9;
        count = before->second;
        if (elapsed_s >= shortest_s)
          count = {now_s, sink.packets,
                   static_cast<double>(sink.packets - before->second.packets) / elapsed_s};
      }
      rows.push_back({sink, count.per_s});
      counts[key] = count;
    }
    counts_ = std::move(counts);
    return rows;
  }

 private:
  struct Count {
    double since_s = 0;
    std::uint64_t packets = 0;
    double per_s = 0;
  };
  std::map<std::string, Count> counts_;
};

}  // namespace abrazo::widgets
