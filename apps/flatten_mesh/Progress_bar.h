// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_PROGRESS_BAR_H
#define FLATTEN_MESH_PROGRESS_BAR_H

#include "flatten_mesh/texts.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <iostream>
#include <mutex>
#include <string>
#include <thread>

namespace flatten_mesh {

// The content of a progress bar: the stage, the share of it that is done, and the time left. The share is negative if
// it is unknown.
inline std::string progress_line(const std::string& stage, const double share, const double seconds)
{
  const std::size_t width = 30;
  if(share < 0) {
    return stage + " (" + format_number("%.0f s", seconds) + ")";
  }
  const auto done = static_cast<std::size_t>(std::lround(static_cast<double>(width) * (std::min)(share, 1.)));
  std::string line = stage + " [" + std::string(done, '#') + std::string(width - done, '.') + "] " +
                     format_number("%.0f %%", 100 * share);
  if(share > 0.01) {
    line += ", " + format_number("%.0f s", seconds * (1 - share) / share) + " left";
  }
  return line;
}

// Shows on standard error, a terminal, what the program is doing, from a second after the start on. A thread keeps the
// line up to date. Until the bar is cleared, nothing else may be written on the terminal.
class Progress_bar
{
public:
  explicit Progress_bar(const bool is_on) : m_is_on(is_on), m_start(Clock::now()), m_stage_start(m_start)
  {
    if(m_is_on) {
      m_thread = std::thread([this] { run(); });
    }
  }

  Progress_bar(const Progress_bar&) = delete;
  Progress_bar& operator=(const Progress_bar&) = delete;

  ~Progress_bar() { clear(); }

  void stage(const std::string& name)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_stage = name;
    m_share = -1;
    m_stage_start = Clock::now();
  }

  // From 0 to 1
  void share(const double part)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_share = part;
  }

  // Makes room for a line of another text.
  void clear_line()
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    if(m_is_shown) {
      std::cerr << "\r\033[K" << std::flush;
    }
  }

  // Removes the bar for good.
  void clear()
  {
    if(!m_thread.joinable()) {
      return;
    }
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      m_is_on = false;
    }
    m_changed.notify_all();
    m_thread.join();
  }

private:
  using Clock = std::chrono::steady_clock;

  void run()
  {
    const auto first_line = m_start + std::chrono::seconds(1);
    std::unique_lock<std::mutex> lock(m_mutex);
    m_changed.wait_until(lock, first_line, [this] { return !m_is_on; });
    while(m_is_on) {
      const std::chrono::duration<double> time = Clock::now() - m_stage_start;
      std::cerr << "\r\033[K" << progress_line(m_stage, m_share, time.count()) << std::flush;
      m_is_shown = true;
      m_changed.wait_for(lock, std::chrono::milliseconds(200), [this] { return !m_is_on; });
    }
    if(m_is_shown) {
      std::cerr << "\r\033[K" << std::flush;
    }
  }

  bool m_is_on, m_is_shown = false;
  Clock::time_point m_start, m_stage_start;
  std::string m_stage;
  double m_share = -1;
  std::mutex m_mutex;
  std::condition_variable m_changed;
  std::thread m_thread;
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_PROGRESS_BAR_H
