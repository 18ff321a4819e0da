// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Loops and sums on several threads, in blocks that do not depend on their number: results are the same on any machine.
// Every stage with long loops includes it. Without TBB the loops are sequential.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_PARALLEL_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_PARALLEL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/deadline.h>

#include <CGAL/for_each.h>
#include <CGAL/tags.h>

#include <boost/range/irange.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#include <tbb/task_group.h>
#endif

#include <algorithm>
#include <array>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Is thrown where a visitor stops a computation.
struct Cancelled
{};

inline constexpr int block_size = 1024;

// Loops over fewer elements than this stay in one thread: waking another one takes longer. Tasks such as factorizations
// take longer for each element, so a second thread pays from fewer elements on.
inline constexpr int least_parallel_size = 16 * block_size, least_task_size = 4 * block_size;

// What a loop calls, without its type, so that a program has the code of a parallel loop only once
class Loop_body
{
public:
  template <typename Function>
  explicit Loop_body(const Function& f)
      : m_function(&f), m_call([](const void* g, int b) { (*static_cast<const Function*>(g))(b); })
  {}

  void operator()(int b) const { m_call(m_function, b); }

private:
  const void* m_function;
  void (*m_call)(const void*, int);
};

// Asks for the deadline in each call. An exception in one thread also stops the loops that others run at the time
// within the same loop. They would go on behind a loop that was not done.
inline void run_loop(int n, bool is_parallel, const Loop_body& body)
{
  if(n < 2 || !is_parallel) {
    for(int b = 0; b < n; ++b) {
      Deadline::ask();
      body(b);
    }
    return;
  }
  Deadline* const deadline = Deadline::current();
  CGAL::for_each<CGAL::Parallel_if_available_tag>(boost::irange(0, n), [&](int b) {
    const Deadline::Worker worker(deadline);
    Deadline::ask();
    body(b);
    return true;
  });
#ifdef CGAL_LINKED_WITH_TBB
  if(tbb::is_current_task_group_canceling())
    throw Cancelled();
#endif
}

// Calls `f(b)` for each b in [0, n), in parallel if TBB is available. Each call goes through `size` elements.
template <typename Function>
void parallel_for(int n, const Function& f, int size = least_task_size)
{
  run_loop(n, size >= least_task_size, Loop_body(f));
}

// Calls `f(begin, end)` for blocks of [0, n), which do not depend on the number of threads.
template <typename Function>
void parallel_for_blocks(int n, const Function& f)
{
  const auto call = [&](int b) {
    f(b * block_size, n - b * block_size < block_size ? n : (b + 1) * block_size);
  };
  run_loop((n + block_size - 1) / block_size, n >= least_parallel_size, Loop_body(call));
}

// The sum of f(0) to f(n - 1), by blocks, so that rounding does not depend on the number of threads.
template <typename Value = double, typename Function>
Value parallel_sum(int n, const Function& f)
{
  constexpr int blocks_at_once = 256; // so many sums are on the stack
  Value total = Value();
  for(int done = 0; done < n;) {
    std::array<Value, blocks_at_once> sums;
    const int size = (std::min)(n - done, blocks_at_once * block_size);
    parallel_for_blocks(size, [&](int begin, int end) {
      Value sum = Value();
      for(int i = done + begin; i < done + end; ++i)
        sum += f(i);
      sums[begin / block_size] = sum;
    });
    for(int b = 0; b * block_size < size; ++b)
      total += sums[b];
    done += size;
  }
  return total;
}

// Calls `f`, which may use `threads` threads, but at most one per processor. 0 means one per processor.
template <typename Function>
void with_threads(int threads, const Function& f)
{
#ifdef CGAL_LINKED_WITH_TBB
  if(threads > 0) {
    tbb::task_arena arena((std::min)(threads, tbb::this_task_arena::max_concurrency()));
    Deadline* const deadline = Deadline::current();
    arena.execute([&] {
      const Deadline::Worker worker(deadline); // may be another thread
      f();
    });
    return;
  }
#else
  (void)threads;
#endif
  f();
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_PARALLEL_H
