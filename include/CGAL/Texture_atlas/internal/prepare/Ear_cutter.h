// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_EAR_CUTTER_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_EAR_CUTTER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/Flat_polygon.h>

#include <algorithm>
#include <cstddef>
#include <queue>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// Triangles between the corners of a polygon
struct Polygon_triangles
{
  std::vector<Index> corners; // three for each triangle, in the direction of the polygon
  std::vector<Index>
      opposites; // of each of them: the one on the other side of the edge that it faces, or `no_index`

  Index size() const { return static_cast<Index>(corners.size() / 3); }
};

// Cuts off one corner after the other. In simple polygons, these are ears, the best ones first. Without ears, as in
// polygons that cross themselves, it is the corner that turns best to the left. `is_taken(i, j)` tells which diagonals
// must not be used.
template <class Is_taken>
class Ear_cutter
{
public:
  Ear_cutter(const Flat_polygon& polygon, const Is_taken& is_taken) : m_polygon(polygon), m_is_taken(is_taken)
  {
    reset();
    for(Index i = 0; i < polygon.size(); ++i) {
      if(!is_left_turn(i)) {
        m_obstacles.push_back(i);
      }
    }
    std::sort(m_obstacles.begin(), m_obstacles.end(), [&polygon](const Index i, const Index j) {
      return polygon.plane(i).x() < polygon.plane(j).x();
    });
    for(Index i = 0; i < polygon.size(); ++i) {
      add_candidate(i);
    }
  }

  // Without triangles if taken diagonals are in the way
  Polygon_triangles run()
  {
    while(m_left > 3) {
      if(!cut_ear() && !cut_any_corner()) {
        return fan();
      }
    }
    return end();
  }

private:
  struct Candidate
  {
    double shape;
    Index corner, version;
    double first_x; // of corners that may be in the way

    bool operator<(const Candidate& other) const
    {
      return shape < other.shape || (shape == other.shape && corner > other.corner);
    }
  };

  struct Waiting // for an obstacle
  {
    Candidate candidate;
    Index before; // that waits for the same
  };

  using Queue = std::priority_queue<Candidate>;

  void reset()
  {
    const Index size = m_polygon.size();
    m_left = size;
    m_triangles = Polygon_triangles();
    m_previous.resize(size);
    m_next.resize(size);
    for(Index i = 0; i < size; ++i) {
      m_next[i] = i + 1 < size ? i + 1 : 0;
      m_previous[m_next[i]] = i;
    }
    m_across.assign(size, no_index);
    m_version.assign(size, 0);
    m_last_waiting.assign(size, no_index);
  }

  bool is_left_turn(const Index i) const
  {
    return m_polygon.turn(m_previous[i], i, m_next[i]) == CGAL::LEFT_TURN;
  }

  bool is_cut(const Index i) const { return m_version[i] == no_index; }

  void add_candidate(const Index i)
  {
    const Index before = m_previous[i], after = m_next[i];
    if(m_left > 3 && m_is_taken(before, after)) {
      return;
    }
    const CGAL::Orientation turn = m_polygon.turn(before, i, after);
    const double first_x =
        (std::min)({m_polygon.plane(before).x(), m_polygon.plane(i).x(), m_polygon.plane(after).x()});
    const Candidate candidate = {static_cast<int>(turn) * m_polygon.shape(before, i, after), i, m_version[i],
                                 first_x};
    m_corners.push(candidate);
    if(turn == CGAL::LEFT_TURN) {
      m_ears.push(candidate);
    }
  }

  bool is_current(const Candidate& candidate) const
  {
    return candidate.version == m_version[candidate.corner];
  }

  // Returns whether there was one.
  bool cut_ear()
  {
    while(!m_ears.empty()) {
      const Candidate candidate = m_ears.top();
      m_ears.pop();
      if(!is_current(candidate)) {
        continue;
      }
      const Index obstacle = find_obstacle(candidate);
      if(obstacle == no_index) {
        cut(candidate.corner);
        return true;
      }
      m_waiting.push_back({candidate, m_last_waiting[obstacle]});
      m_waiting.back().candidate.first_x = m_polygon.plane(obstacle).x();
      m_last_waiting[obstacle] = static_cast<Index>(m_waiting.size() - 1);
    }
    return false;
  }

  // An obstacle has gone.
  void wake(const Index obstacle)
  {
    for(Index i = m_last_waiting[obstacle]; i != no_index; i = m_waiting[i].before) {
      if(is_current(m_waiting[i].candidate)) {
        m_ears.push(m_waiting[i].candidate);
      }
    }
    m_last_waiting[obstacle] = no_index;
  }

  // Only polygons that cross themselves come here, and there is less to be gained from tests.
  bool cut_any_corner()
  {
    while(!m_corners.empty()) {
      const Candidate candidate = m_corners.top();
      m_corners.pop();
      if(is_current(candidate)) {
        m_most_tests = (std::min)(m_most_tests, m_tests + 300 * std::size_t(m_left));
        cut(candidate.corner);
        return true;
      }
    }
    return false;
  }

  // Whether corner o is in the way of cutting off i. Only corners that do not turn left can be the first there.
  bool is_obstacle(const Index i, const Index o) const
  {
    const Index before = m_previous[i], after = m_next[i];
    const Kernel::Point_2& point = m_polygon.plane(o);
    return point != m_polygon.plane(before) && point != m_polygon.plane(i) &&
           point != m_polygon.plane(after) && !is_cut(o) && !is_left_turn(o) &&
           m_polygon.turn(before, i, o) != CGAL::RIGHT_TURN &&
           m_polygon.turn(i, after, o) != CGAL::RIGHT_TURN &&
           m_polygon.turn(after, before, o) != CGAL::RIGHT_TURN;
  }

  // A corner in the triangle that would be cut off, or `no_index`
  Index find_obstacle(const Candidate& candidate)
  {
    const Index i = candidate.corner;
    const Kernel::Point_2 &p = m_polygon.plane(m_previous[i]), &q = m_polygon.plane(i),
                          &r = m_polygon.plane(m_next[i]);
    const double most = (std::max)({p.x(), q.x(), r.x()});
    const double low = (std::min)({p.y(), q.y(), r.y()}), high = (std::max)({p.y(), q.y(), r.y()});
    auto o = std::lower_bound(m_obstacles.begin(), m_obstacles.end(), candidate.first_x,
                              [this](const Index k, const double x) { return m_polygon.plane(k).x() < x; });
    for(; o != m_obstacles.end() && m_polygon.plane(*o).x() <= most && m_tests < m_most_tests; ++o) {
      ++m_tests;
      const double y = m_polygon.plane(*o).y();
      if(y >= low && y <= high && is_obstacle(i, *o)) {
        return *o;
      }
    }
    return no_index;
  }

  void join(const Index corner, const Index across)
  {
    m_triangles.opposites[corner] = across;
    if(across != no_index) {
      m_triangles.opposites[across] = corner;
    }
  }

  void add_triangle(const Index i)
  {
    const Index before = m_previous[i], after = m_next[i], first = 3 * m_triangles.size();
    m_triangles.corners.insert(m_triangles.corners.end(), {before, i, after});
    m_triangles.opposites.resize(first + 3, no_index);
    join(first, m_across[i]);
    join(first + 2, m_across[before]);
  }

  void cut(const Index i)
  {
    const Index before = m_previous[i], after = m_next[i];
    add_triangle(i);
    m_across[before] = 3 * m_triangles.size() - 2;
    m_next[before] = after;
    m_previous[after] = before;
    m_version[i] = no_index;
    --m_left;
    remove_cut_obstacles();
    wake(i);
    for(const Index neighbor : {before, after}) {
      ++m_version[neighbor];
      add_candidate(neighbor);
      if(is_left_turn(neighbor)) {
        wake(neighbor);
      }
    }
  }

  // Once few are left, it takes long to pass over the others.
  void remove_cut_obstacles()
  {
    if(2 * std::size_t(m_left) < m_obstacles.size()) {
      m_obstacles.erase(std::remove_if(m_obstacles.begin(), m_obstacles.end(),
                                       [this](const Index i) { return is_cut(i) || is_left_turn(i); }),
                        m_obstacles.end());
    }
  }

  // The last triangle
  Polygon_triangles end()
  {
    const auto i = static_cast<Index>(
        std::find_if(m_version.begin(), m_version.end(), [](const Index v) { return v != no_index; }) -
        m_version.begin());
    add_triangle(i);
    join(3 * m_triangles.size() - 2, m_across[m_next[i]]);
    return std::move(m_triangles);
  }

  // All diagonals from one corner
  Polygon_triangles fan()
  {
    const Index size = m_polygon.size();
    for(Index i = 0; i < size; ++i) {
      bool is_free = true;
      for(Index k = 2; is_free && k + 1 < size; ++k) {
        is_free = !m_is_taken(i, (i + k) % size);
      }
      if(is_free) {
        reset();
        while(m_left > 3) {
          cut(m_next[i]);
        }
        return end();
      }
    }
    return Polygon_triangles();
  }

  const Flat_polygon& m_polygon;
  const Is_taken& m_is_taken;
  Polygon_triangles m_triangles;
  Index m_left = 0;                      // corners
  std::vector<Index> m_previous, m_next; // of each corner, among those left
  std::vector<Index>
      m_across; // of the side from each corner to the next: the corner of a triangle that faces it
  std::vector<Index>
      m_version; // of each corner: how often its neighbours changed; `no_index` once it was cut off
  std::vector<Index> m_obstacles; // that did not turn left, by their x
  Queue m_ears, m_corners;
  std::vector<Waiting> m_waiting;
  std::vector<Index> m_last_waiting; // for each corner
  std::size_t m_tests = 0,
              m_most_tests = 1000000000; // for obstacles, which takes seconds. Later ears are cut without
};

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_EAR_CUTTER_H
