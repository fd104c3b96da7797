// Copyright (c) 2026  The Point_set_consolidation_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSOLIDATION_BENCHMARK_SPEED_OPERATORS_H
#define CONSOLIDATION_BENCHMARK_SPEED_OPERATORS_H

#include "paper_classes.h"
#include "types.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <unistd.h>


namespace benchmark {

using support::Vec3;

/// What all operators get. The model has unit diagonal.
struct Speed_input {
  std::vector<Vec3> points;
  std::vector<Vec3> normals;     ///< true ones
  std::vector<Vec3> directions;  ///< towards the scanner
  std::vector<int> views;
  double spacing = 0.0;  ///< mean distance to the 6 nearest neighbours
};

/// Resident memory of the process while it lives, sampled.
class Memory_samples {
public:
  using Clock = std::chrono::steady_clock;

  Memory_samples() : m_thread([this] { sample(); }) {}
  ~Memory_samples() { stop(); }
  Memory_samples(const Memory_samples&) = delete;
  Memory_samples& operator=(const Memory_samples&) = delete;

  void stop()
  {
    m_stopped = true;
    if(m_thread.joinable())
      m_thread.join();
  }
  /// Largest above that at the beginning, in megabytes.
  double peak(Clock::time_point from, Clock::time_point to) const
  {
    double most = 0.0;
    for(std::size_t i = 0; i < m_samples.size(); ++i) {
      // what a sample says holds until the next one
      const bool is_over = i + 1 < m_samples.size() && m_samples[i + 1].first < from;
      if(!is_over && m_samples[i].first <= to)
        most = (std::max)(most, m_samples[i].second - m_samples.front().second);
    }
    return most;
  }

private:
  void sample()
  {
    constexpr auto interval = std::chrono::milliseconds(5);
    const double megabytes_per_page = static_cast<double>(sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
    while(!m_stopped) {
      long all = 0, resident = 0;
      if(std::FILE* file = std::fopen("/proc/self/statm", "r")) {
        if(std::fscanf(file, "%ld %ld", &all, &resident) == 2)
          m_samples.emplace_back(Clock::now(), static_cast<double>(resident) * megabytes_per_page);
        std::fclose(file);
      }
      std::this_thread::sleep_for(interval);
    }
  }

  std::atomic<bool> m_stopped{false};
  std::vector<std::pair<Clock::time_point, double>> m_samples;
  std::thread m_thread;
};

/// Megabytes of a line of /proc/self/status: VmRSS, resident now, or VmHWM, the most that were; 0 if unknown.
inline double resident_megabytes(const char* line)
{
  std::ifstream status("/proc/self/status");
  for(std::string word; status >> word;)
    if(word == line) {
      double kilobytes = 0.0;
      status >> kilobytes;
      return kilobytes / 1024.0;
    }
  return 0.0;
}

/// Stages of the same name are one.
struct Stage_record {
  std::array<char, 32> name{};
  double seconds = 0.0;
  double megabytes = 0.0;  ///< peak above what there was when the watch was started
};

/// Started when the operator's own input is ready, stopped before its result is looked at. Lies in memory that
/// parent and child share: nothing in it that the parent reads is allocated.
class Stopwatch {
public:
  static constexpr std::size_t most_stages = 24;

  void start()
  {
    m_memory = std::make_unique<Memory_samples>();
    std::ofstream("/proc/self/clear_refs") << 5;  // VmHWM counts from now on
    m_megabytes_begin = resident_megabytes("VmRSS:");
    m_wall_begin = std::chrono::steady_clock::now();
    m_cpu_begin = std::clock();
  }
  void stop()
  {
    cpu_seconds = static_cast<double>(std::clock() - m_cpu_begin) / CLOCKS_PER_SEC;
    m_wall_end = std::chrono::steady_clock::now();
    wall_seconds = std::chrono::duration<double>(m_wall_end - m_wall_begin).count();
    m_memory->stop();
    megabytes = resident_megabytes("VmHWM:") - m_megabytes_begin;
  }
  /// Names and seconds of the package's stages, one after the other; what is left of the time lies before the first
  /// of them, where the input is copied.
  template <typename Stage_times>
  void record_stages(const Stage_times& times)
  {
    double all = 0.0;
    for(const auto& time : times)
      all += time.seconds;
    using Duration = std::chrono::steady_clock::duration;
    const auto length = [](double seconds) {
      return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds));
    };
    auto begin = m_wall_end - length((std::min)(all, wall_seconds));
    for(const auto& time : times) {
      const auto end = begin + length(time.seconds);
      Stage_record* record = nullptr;
      for(std::size_t i = 0; i < number_of_stages && record == nullptr; ++i)
        if(time.name == stages[i].name.data())
          record = &stages[i];
      if(record == nullptr && number_of_stages < most_stages) {
        record = &stages[number_of_stages++];
        std::snprintf(record->name.data(), record->name.size(), "%s", time.name.c_str());
      }
      if(record != nullptr) {
        record->seconds += time.seconds;
        record->megabytes = (std::max)(record->megabytes, m_memory->peak(begin, end));
      }
      begin = end;
    }
  }
  double cpu_seconds = 0.0;  ///< of all threads
  double wall_seconds = 0.0;
  double megabytes = 0.0;  ///< peak above what there was when it was started, the operator's own input
  std::array<Stage_record, most_stages> stages;
  std::size_t number_of_stages = 0;

private:
  std::chrono::steady_clock::time_point m_wall_begin, m_wall_end;
  std::clock_t m_cpu_begin = 0;
  double m_megabytes_begin = 0.0;
  std::unique_ptr<Memory_samples> m_memory;
};

struct Speed_operator {
  std::string name;
  std::string counterpart;  ///< operator of CGAL that it is compared with; itself for CGAL's own
  bool parallel;
  std::size_t largest;  ///< not run on more points
  std::function<void(const Speed_input&, Stopwatch&)> run;
};

/// Particles of all projections, as a share of the points (CGAL's default).
constexpr double particle_share = 0.05;

/// Support radius of all projections, in spacings of the particles.
constexpr double radius_in_spacings = 2.0;

/// Radius of the neighbour queries, in spacings of the points: about 125 neighbours on a surface.
constexpr double query_radius = 5.0;

std::vector<Speed_operator> cgal_operators();
std::vector<Speed_operator> package_operators();

/// What a class of a paper's table is run with: its points and particles are those of `input`.
enum class Class_method { deep_points, iterative };
void run_class(Class_method method, const Paper_class& row, bool parallel, const Speed_input& input, Stopwatch& watch);

}  // namespace benchmark

#endif  // CONSOLIDATION_BENCHMARK_SPEED_OPERATORS_H
