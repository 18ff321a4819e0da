// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_PYTHON_INTERRUPTIBLE_H
#define ABF_PYTHON_INTERRUPTIBLE_H

#include "failures.h"

#include <CGAL/Texture_atlas/Atlas_visitor.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_visitor.h>

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <future>
#include <limits>
#include <utility>

namespace abf_python {

namespace py = pybind11;
namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;

// How far a computation is. It is written by the thread that computes, and read by the one that waits.
struct Progress_state
{
  std::atomic<bool> is_cancelled{false};
  std::atomic<const char*> stage{"READ"};
  std::atomic<double> share{0}; // of the stage

  bool start(const char* const name)
  {
    stage = name;
    share = 0;
    return !is_cancelled;
  }
};

class Atlas_watcher : public TA::Atlas_visitor
{
public:
  explicit Atlas_watcher(Progress_state& state) : m_state(state) {}

  bool start(const Stage stage) override { return m_state.start(to_string(stage)); }

  bool progress(const double share) override
  {
    m_state.share = share;
    return !m_state.is_cancelled;
  }

private:
  Progress_state& m_state;
};

// It watches one computation after the other.
class Flattening_watcher : public SMP::Flattening_visitor
{
public:
  void follow(Progress_state& state) { m_state = &state; }

  bool start(const Stage stage) override { return m_state->start(to_string(stage)); }

  bool step(const SMP::ABF_plus_plus_step&) override { return !m_state->is_cancelled; }

  bool level(const int vertices, const int all_vertices) override
  {
    m_state->share = static_cast<double>(vertices) / all_vertices;
    return !m_state->is_cancelled;
  }

private:
  Progress_state* m_state = nullptr;
};

// What a caller of a computation may ask for
struct Watch
{
  py::object progress; // None, or a function of the stage and its share; `False` ends the computation
  double timeout = std::numeric_limits<double>::infinity(); // in seconds
};

// Why a computation is to end early
enum class End
{
  NONE,
  CANCELLED,
  TIMED_OUT,
  RAISED // a Python exception, which is kept
};

namespace internal {

// Looks after signals, calls the function of the caller, and says whether to go on. A Python exception is thrown.
inline bool looks_well(const Watch& watch, const Progress_state& state)
{
  if(PyErr_CheckSignals() != 0) {
    throw py::error_already_set();
  }
  if(watch.progress.is_none()) {
    return true;
  }
  const py::object answer = watch.progress(state.stage.load(), state.share.load());
  return !answer.is(py::bool_(false));
}

} // namespace internal

// Computes `f(state)` in another thread, without the lock of the interpreter. Meanwhile, the calling thread looks after
// signals, the timeout and the progress twenty times a second. The computation ends before this function does, whatever
// happens.
template <class Function>
auto run_interruptibly(const Watch& watch, const Function& f) -> decltype(f(std::declval<Progress_state&>()))
{
  using Clock = std::chrono::steady_clock;
  Progress_state state;
  const auto begin = Clock::now();
  End end = End::NONE;
  std::exception_ptr raised;
  auto future = std::async(std::launch::async, [&] { return f(state); });
  {
    const py::gil_scoped_release unlocked;
    while(future.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready) {
      if(end != End::NONE) {
        continue;
      }
      if(std::chrono::duration<double>(Clock::now() - begin).count() > watch.timeout) {
        end = End::TIMED_OUT;
      } else {
        const py::gil_scoped_acquire locked;
        try {
          end = internal::looks_well(watch, state) ? End::NONE : End::CANCELLED;
        } catch(...) {
          end = End::RAISED;
          raised = std::current_exception();
        }
      }
      state.is_cancelled = end != End::NONE;
    }
  }
  switch(end) {
  case End::CANCELLED:
    throw Cancelled();
  case End::TIMED_OUT:
    throw Timed_out();
  case End::RAISED:
    std::rethrow_exception(raised);
  default:
    return future.get();
  }
}

} // namespace abf_python

#endif // ABF_PYTHON_INTERRUPTIBLE_H
