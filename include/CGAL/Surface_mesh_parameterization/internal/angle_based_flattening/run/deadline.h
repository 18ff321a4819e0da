// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The end of the time that a run has. All threads that work for the run know it, and loops that take long ask for it:
// those of `parallel.h`, and others by `Deadline::ask()`. `run_bounded()` in `stage.h` begins it.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_DEADLINE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_DEADLINE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <atomic>
#include <chrono>
#include <sstream>
#include <string>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

class Deadline
{
  typedef std::chrono::steady_clock Clock;

public:
  // Is thrown where the time of a run is over.
  struct Passed
  {
    const Deadline* deadline;
    std::string message;
  };

  // The time begins. If a run around this one has less time left, that is what counts.
  explicit Deadline(double seconds) : m_seconds(seconds), m_outer(current())
  {
    constexpr double longest = 1e9; // clocks have no room for more
    if(!(seconds < longest))
      return;
    m_end =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
    if(m_outer == nullptr || m_end < m_outer->m_end)
      current() = this;
  }

  ~Deadline() { current() = m_outer; }

  Deadline(const Deadline&) = delete;
  Deadline& operator=(const Deadline&) = delete;

  // That of what the thread works for, or null
  static Deadline*& current()
  {
    static thread_local Deadline* deadline = nullptr;
    return deadline;
  }

  // Throws if the time is over.
  static void ask()
  {
    if(const Deadline* deadline = current(); deadline != nullptr && Clock::now() >= deadline->m_end)
      throw Passed{deadline, deadline->message()};
  }

  // Calls `f`, and returns whether it was done within this time. That of a run around it still ends `f` and this.
  template <typename Function>
  bool allows(const Function& f) const
  {
    try {
      f();
    } catch(const Passed& passed) {
      if(passed.deadline != this)
        throw;
      return false;
    }
    return true;
  }

  // While it lives, the thread works for the run with this deadline.
  class Worker
  {
  public:
    explicit Worker(Deadline* deadline) : m_other(current()) { current() = deadline; }
    ~Worker() { current() = m_other; }

    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

  private:
    Deadline* m_other; // a thread that waits in a loop may help another run
  };

  // A part of the run that messages name. Those within it are not named.
  class Stage
  {
  public:
    explicit Stage(const char* name) : m_deadline(current())
    {
      if(m_deadline != nullptr && m_deadline->m_depth++ == 0)
        m_deadline->m_stage = name;
    }

    ~Stage()
    {
      if(m_deadline != nullptr)
        --m_deadline->m_depth;
    }

    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

  private:
    Deadline* m_deadline;
  };

private:
  std::string message() const
  {
    std::ostringstream text;
    text << "not done after " << m_seconds << " s";
    if(const char* stage = m_stage)
      text << "; the last stage was " << stage;
    return text.str();
  }

  double m_seconds;
  Clock::time_point m_end;
  Deadline* m_outer;
  std::atomic<int> m_depth{0}; // of stages
  std::atomic<const char*> m_stage{nullptr};
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_DEADLINE_H
