// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Adds up the progress of parts that are made in parallel, reports it to one visitor, and stops all parts if it
// cancels. `build_atlas_impl.h` makes it, and the makers of parts report to it.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_ATLAS_PROGRESS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_ATLAS_PROGRESS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_visitor.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/stage.h>
#include <CGAL/Texture_atlas/Atlas_visitor.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <mutex>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

typedef Visited_stage<Atlas_visitor> Atlas_stage;

// Reports progress from several threads to a visitor, which may cancel.
class Atlas_progress
{
public:
  // `work` is the work for each part of the surface, in any unit.
  Atlas_progress(Atlas_visitor* visitor, std::vector<double> work)
      : m_visitor(visitor), m_work(std::move(work)), m_share(m_work.size(), 0.),
        m_all(std::accumulate(m_work.begin(), m_work.end(), 0.)), m_unfinished(m_work.size())
  {}

  // Returns whether to continue.
  bool set(std::size_t part, double share)
  {
    if(m_visitor == nullptr || m_is_cancelled)
      return !m_is_cancelled;
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_done += m_work[part] * (std::max)(0., share - m_share[part]);
    m_unfinished -= m_share[part] < 1 && share >= 1 ? 1 : 0;
    m_share[part] = (std::max)(m_share[part], share);
    const bool is_finished = m_unfinished == 0;
    const double told = is_finished ? 1. : (std::min)(1., m_done / m_all), least_difference = 0.01;
    if(told >= m_told + least_difference || (is_finished && m_told < 1)) {
      m_told = told;
      m_is_cancelled = m_is_cancelled || !m_visitor->progress(m_told);
    }
    return !m_is_cancelled;
  }

private:
  Atlas_visitor* m_visitor;
  std::vector<double> m_work, m_share;
  double m_all, m_done = 0, m_told = 0;
  std::size_t m_unfinished; // parts
  std::atomic<bool> m_is_cancelled{false};
  std::mutex m_mutex;
};

// The progress of one part. As a visitor of the parameterizers, it translates their reports into shares of the current
// stage.
class Part_progress : public Flattening_visitor
{
public:
  Part_progress(Atlas_progress& all, std::size_t part) : m_all(all), m_part(part) {}

  // The next computation takes the part from one share of its work to another.
  void set_stage(double begin, double end)
  {
    m_begin = begin;
    m_end = end;
    if(!tell(0))
      throw Cancelled();
  }

  bool start(Stage stage) override
  {
    m_is_refining = m_is_refining || stage == REFINE;
    return tell(0);
  }

  bool step(const ABF_plus_plus_step&) override { return tell(0); }

  bool level(int vertices, int all_vertices) override
  {
    const double share = static_cast<double>(vertices) / all_vertices;
    return tell(m_is_refining ? (1 + share) / 2 : (1 - share) / 2);
  }

private:
  bool tell(double share) { return m_all.set(m_part, m_begin + share * (m_end - m_begin)); }

  Atlas_progress& m_all;
  std::size_t m_part;
  double m_begin = 0, m_end = 1;
  bool m_is_refining = false;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_ATLAS_PROGRESS_H
