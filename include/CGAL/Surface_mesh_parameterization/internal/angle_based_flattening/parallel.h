// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PARALLEL_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PARALLEL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/for_each.h>
#include <CGAL/tags.h>

#include <boost/range/irange.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <algorithm>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

// Calls `f(b)` for each b in [0, n), several at once where TBB is there.
template <typename Function>
void parallel_for(int n, const Function& f)
{
  CGAL::for_each<CGAL::Parallel_if_available_tag>(boost::irange(0, n), [&](int b) {
    f(b);
    return true;
  });
}

// Calls `f(begin, end)` for blocks of [0, n), which do not depend on the number of threads.
template <typename Function>
void parallel_for_blocks(int n, const Function& f)
{
  const int size = 1024;
  parallel_for((n + size - 1) / size, [&](int b) { f(b * size, n - b * size < size ? n : (b + 1) * size); });
}

// Calls `f`, which may run as many threads at once; as many as there are processors if `threads` is 0, and never more.
template <typename Function>
void with_threads(int threads, const Function& f)
{
#ifdef CGAL_LINKED_WITH_TBB
  if(threads > 0) {
    tbb::task_arena arena((std::min)(threads, tbb::this_task_arena::max_concurrency()));
    arena.execute(f);
    return;
  }
#else
  (void)threads;
#endif
  f();
}

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PARALLEL_H
