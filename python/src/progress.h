// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_PYTHON_PROGRESS_H
#define ABF_PYTHON_PROGRESS_H

#include <CGAL/Surface_mesh_parameterization/Flattening_visitor.h>
#include <CGAL/Texture_atlas/Atlas_visitor.h>

#include <atomic>

// How far a computation is. The thread that computes writes it, and the one that waits reads it, in Python.
struct abf_progress
{
  std::atomic<const char*> stage;
  std::atomic<double> share; // of the stage
  std::atomic<int> is_cancelled;

  bool start(const char* const name)
  {
    stage = name;
    share = 0;
    return is_cancelled == 0;
  }
};

namespace abf_python {

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;

class Atlas_watcher : public TA::Atlas_visitor
{
public:
  explicit Atlas_watcher(abf_progress& state) : m_state(state) {}

  bool start(const Stage stage) override { return m_state.start(to_string(stage)); }

  bool progress(const double share) override
  {
    m_state.share = share;
    return m_state.is_cancelled == 0;
  }

private:
  abf_progress& m_state;
};

// It watches one computation after the other.
class Flattening_watcher : public SMP::Flattening_visitor
{
public:
  void follow(abf_progress& state) { m_state = &state; }

  bool start(const Stage stage) override { return m_state->start(to_string(stage)); }

  bool step(const SMP::ABF_plus_plus_step&) override { return m_state->is_cancelled == 0; }

  bool level(const int vertices, const int all_vertices) override
  {
    m_state->share = static_cast<double>(vertices) / all_vertices;
    return m_state->is_cancelled == 0;
  }

private:
  abf_progress* m_state = nullptr;
};

} // namespace abf_python

#endif // ABF_PYTHON_PROGRESS_H
