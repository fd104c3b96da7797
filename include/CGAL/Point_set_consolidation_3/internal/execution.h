// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// All rights reserved.
//
// This file is part of Point_set_consolidation_3; it follows the conventions of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_EXECUTION_H
#define CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_EXECUTION_H

#include <CGAL/Point_set_consolidation_3/options.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_consolidation_3 {
namespace internal {

/// Thrown on the calling thread when the user's callback asked to stop; public functions catch it
/// and leave their output untouched.
struct Cancelled {};

/// Input that a method cannot work with. The public function adds its name to the message.
struct Unusable_input : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

using Point_set_consolidation_3::Stage_time;
using Stage_times = std::vector<Stage_time>;

/// One monotone progress in [0, 1] over a whole call. The callback runs on the calling thread only,
/// between iterations, so it may throw: the exception leaves the public function like any other.
class Progress {
public:
  Progress() = default;
  explicit Progress(std::function<bool(double)> callback) : m_callback(std::move(callback)) {}

  bool is_observed() const { return bool(m_callback); }

  /// Reports `fraction` of the current stage; throws `Cancelled` if the user wants to stop.
  void update(double fraction)
  {
    if(!m_callback)
      return;
    Fractions& f = m_fractions;
    f.last = (std::max)(f.last, (std::min)(1., f.done + f.share * (std::min)(1., fraction)));
    if(!m_callback(f.last))
      throw Cancelled();
  }
  void begin_stage(double share) { m_fractions.share = share; }
  void end_stage() { m_fractions.done += m_fractions.share; m_fractions.share = 0; }
  void finish() { m_fractions.done = 1; m_fractions.share = 0; update(1); }

  /// Of all: done by earlier stages, the share of the current one, last reported.
  struct Fractions {
    double done = 0, share = 0, last = 0;
  };
  const Fractions& fractions() const { return m_fractions; }
  /// For a stage that is stopped and may run again.
  void set_fractions(const Fractions& fractions) { m_fractions = fractions; }

private:
  std::function<bool(double)> m_callback;
  Fractions m_fractions;
};

/// How a stage runs: in parallel or not, and whom it tells. Results do not depend on it.
struct Execution {
  bool parallel = false;
  Progress progress;
  Stage_times times;
};

template <typename ConcurrencyTag>
Execution make_execution(std::function<bool(double)> callback = {})
{
  constexpr bool parallel = std::is_convertible<ConcurrencyTag, Parallel_tag>::value;
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!parallel, "Parallel_tag needs TBB: link CGAL::TBB_support");
#endif
  return Execution{parallel, Progress(std::move(callback)), {}};
}

/// Books the time of a stage and its share of the progress.
class Stage {
public:
  Stage(Execution& execution, const char* name, double share)
    : m_execution(execution), m_name(name), m_start(Clock::now())
  {
    m_execution.progress.begin_stage(share);
    m_execution.progress.update(0);
  }
  ~Stage()
  {
    m_execution.progress.end_stage();
    const std::chrono::duration<double> elapsed = Clock::now() - m_start;
    m_execution.times.push_back({m_name, elapsed.count(), m_iterations});
  }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  void update(double fraction) { m_execution.progress.update(fraction); }
  void count_iteration() { ++m_iterations; }

private:
  using Clock = std::chrono::steady_clock;
  Execution& m_execution;
  std::string m_name;
  Clock::time_point m_start;
  std::size_t m_iterations = 0;
};

}  // namespace internal
}  // namespace Point_set_consolidation_3
}  // namespace CGAL

#endif  // CGAL_POINT_SET_CONSOLIDATION_3_INTERNAL_EXECUTION_H
