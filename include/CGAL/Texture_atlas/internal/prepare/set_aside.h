// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SET_ASIDE_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SET_ASIDE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>
#include <CGAL/Texture_atlas/internal/prepare/build_mesh_impl.h>
#include <CGAL/Texture_atlas/internal/prepare/check_polygons.h>
#include <CGAL/Texture_atlas/internal/prepare/Input_error.h>

#include <CGAL/Texture_atlas/internal/atlas/far_points.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/Disjoint_sets.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

inline std::vector<bool> far_points(const Polygon_soup& soup)
{
  const auto point = [&soup](const std::size_t v) {
    return Far_points::Point{soup.points[v].x(), soup.points[v].y(), soup.points[v].z()};
  };
  std::vector<Far_points::Point> corners;
  for(const Polygon& polygon : soup.polygons) {
    std::transform(polygon.begin(), polygon.end(), std::back_inserter(corners), point);
  }
  const Far_points stray(std::move(corners));
  std::vector<bool> result;
  for(std::size_t v = 0; v < soup.points.size(); ++v) {
    result.push_back(stray.contain(point(v)));
  }
  return result;
}

// Finds which polygons of a soup cannot be part of a surface: those with too few vertices, those at points that are not
// finite or far away, and, unless that is repaired, all that hang together, by edges, with an edge of more than two
// faces or of faces that are oriented differently.
class Soup_inspector
{
public:
  Soup_inspector(const Polygon_soup& soup, const std::vector<bool>& is_far, const bool is_repaired)
      : m_soup(soup), m_is_repaired(is_repaired), m_is_far(is_far), m_sets(soup.polygons.size())
  {
    for(std::size_t p = 0; p < soup.polygons.size(); ++p) {
      inspect_polygon(p);
    }
    if(!is_repaired) {
      inspect_edges();
    }
  }

  // The parts to set aside. `part_of` receives the part of each polygon, or `no_index` for those that remain. All
  // degenerate polygons are one part, and so are all polygons at points that are not finite, or far away.
  std::vector<Skipped_part> parts(std::vector<Index>& part_of)
  {
    part_of.assign(m_soup.polygons.size(), no_index);
    std::vector<Skipped_part> result;
    std::map<Diagnosis, Index> part_of_kind;  // of polygons that are wrong by themselves
    std::map<std::size_t, Index> part_of_set; // of others, by the representative of what hangs together
    for(const auto& [p, defect] : m_defects) {
      Index& part = is_alone(p) ? part_of_kind.try_emplace(defect.status, no_index).first->second
                                : part_of_set.try_emplace(m_sets.find_set(p), no_index).first->second;
      if(part == no_index) {
        part = static_cast<Index>(result.size());
        result.push_back(skipped_part(defect.status, defect.message));
        result.back().vertices = defect.vertices;
      }
      if(is_alone(p)) {
        part_of[p] = part;
      }
    }
    for(std::size_t p = 0; p < m_soup.polygons.size() && !part_of_set.empty(); ++p) {
      const auto part = part_of_set.find(m_sets.find_set(p));
      if(part_of[p] == no_index && part != part_of_set.end()) {
        part_of[p] = part->second;
      }
    }
    for(const auto& [kind, vertices] : m_wrong_points) {
      if(const auto part = part_of_kind.find(kind); part != part_of_kind.end()) {
        result[part->second].message =
            wrong_points_text(vertex_name(m_soup, *vertices.begin()), vertices.size(), kind);
        result[part->second].vertices.assign(vertices.begin(), vertices.end());
      }
    }
    return result;
  }

  // Whether a point is not finite, or far away
  bool is_wrong(const std::size_t v) const { return !is_finite(m_soup.points[v]) || m_is_far[v]; }

private:
  struct Side
  {
    std::size_t from, to, polygon;
  };

  struct Defect
  {
    Diagnosis status;
    std::string message;
    std::vector<std::size_t> vertices; // that the message is about
  };

  void add_defect(const std::size_t p, const Diagnosis diagnosis, const std::string& message,
                  const std::vector<std::size_t>& vertices = {})
  {
    m_defects.try_emplace(p, Defect{diagnosis, message, vertices});
  }

  // Whether the polygon is wrong by itself, so that those around it may remain
  bool is_alone(const std::size_t p) const
  {
    const auto defect = m_defects.find(p);
    return defect != m_defects.end() && (defect->second.status == Diagnosis::DEGENERATE_FACE ||
                                         m_wrong_points.count(defect->second.status) > 0);
  }

  void inspect_polygon(const std::size_t p)
  {
    try {
      check_polygon(m_soup, p);
    } catch(const Input_error& error) {
      add_defect(p, Diagnosis::DEGENERATE_FACE, error.what(), error.vertices);
    }
    for(const std::size_t v : m_soup.polygons[p]) {
      if(!is_finite(m_soup.points[v])) {
        add_wrong_point(p, v, Diagnosis::NON_FINITE_POINT);
      } else if(m_is_far[v]) {
        add_wrong_point(p, v, Diagnosis::FAR_POINT);
      }
    }
  }

  void add_wrong_point(const std::size_t p, const std::size_t v, const Diagnosis kind)
  {
    m_wrong_points[kind].insert(v);
    add_defect(p, kind, ""); // said when all are known
  }

  // The sides of the polygons with at least three vertices, by their smaller vertex
  void inspect_edges()
  {
    std::vector<std::size_t> first(m_soup.points.size() + 1, 0);
    for_each_side([&first](const Side& side, std::size_t) { ++first[(std::min)(side.from, side.to) + 1]; });
    for(std::size_t v = 1; v < first.size(); ++v) {
      first[v] += first[v - 1];
    }
    std::vector<Index> polygon_of(first.back()), corner_of(first.back());
    std::vector<std::size_t> next(first);
    for_each_side([&](const Side& side, const std::size_t corner) {
      const std::size_t place = next[(std::min)(side.from, side.to)]++;
      polygon_of[place] = static_cast<Index>(side.polygon);
      corner_of[place] = static_cast<Index>(corner);
    });
    std::vector<Side> sides;
    for(std::size_t v = 0; v < m_soup.points.size(); ++v) {
      sides.clear();
      for(std::size_t i = first[v]; i < first[v + 1]; ++i) {
        sides.push_back(side(polygon_of[i], corner_of[i]));
      }
      inspect_vertex(sides);
    }
  }

  Side side(const std::size_t p, const std::size_t corner) const
  {
    const Polygon& polygon = m_soup.polygons[p];
    return {polygon[corner], polygon[corner + 1 < polygon.size() ? corner + 1 : 0], p};
  }

  template <class Function>
  void for_each_side(const Function& f) const
  {
    for(std::size_t p = 0; p < m_soup.polygons.size(); ++p) {
      const std::size_t sides = is_alone(p) ? 0 : m_soup.polygons[p].size();
      for(std::size_t i = 0; i < sides; ++i) {
        f(side(p, i), i);
      }
    }
  }

  // Sides with the same smaller vertex
  void inspect_vertex(std::vector<Side>& sides)
  {
    const auto larger = [](const Side& side) { return (std::max)(side.from, side.to); };
    std::stable_sort(sides.begin(), sides.end(),
                     [&](const Side& a, const Side& b) { return larger(a) < larger(b); });
    for(auto begin = sides.begin(); begin != sides.end();) {
      const auto end =
          std::find_if(begin, sides.end(), [&](const Side& s) { return larger(s) != larger(*begin); });
      inspect_edge(&*begin, static_cast<std::size_t>(end - begin));
      begin = end;
    }
  }

  void inspect_edge(const Side* sides, const std::size_t count)
  {
    for(std::size_t i = 1; i < count; ++i) {
      m_sets.union_set(sides[0].polygon, sides[i].polygon);
    }
    if(m_is_repaired) {
      return;
    }
    if(count > 2) {
      add_defect(sides[0].polygon, Diagnosis::NON_MANIFOLD_EDGE,
                 edge_name(m_soup, sides[0].from, sides[0].to) + " has " + std::to_string(count) +
                     " faces, so the surface is not a manifold",
                 {sides[0].from, sides[0].to});
    } else if(count == 2 && sides[0].from == sides[1].from) {
      add_defect(sides[0].polygon, Diagnosis::INCONSISTENT_ORIENTATION,
                 "faces " + std::to_string(m_soup.origins[sides[0].polygon] + 1) + " and " +
                     std::to_string(m_soup.origins[sides[1].polygon] + 1) +
                     " are oriented differently: both run along " +
                     edge_name(m_soup, sides[0].from, sides[0].to) + " in the same direction",
                 {sides[0].from, sides[0].to});
    }
  }

  const Polygon_soup& m_soup;
  bool m_is_repaired;
  const std::vector<bool>& m_is_far;                         // of each point
  std::map<Diagnosis, std::set<std::size_t>> m_wrong_points; // of each diagnosis
  CGAL::Surface_mesh_parameterization::internal::ABF::Disjoint_sets m_sets;
  std::map<std::size_t, Defect> m_defects; // of polygons
};

// Removes the polygons that cannot be part of a surface, with all that hangs together with them by edges, and says
// why. Of a soup that is repaired later, what can be repaired remains.
inline void set_aside(Polygon_soup& soup, const std::vector<bool>& is_far, const bool is_repaired)
{
  std::vector<Index> part_of;
  Soup_inspector inspector(soup, is_far, is_repaired);
  const std::vector<Skipped_part> parts = inspector.parts(part_of);
  if(!parts.empty()) {
    leave_out(soup, part_of, parts);
  }
  for(std::size_t v = 0; v < soup.points.size(); ++v) {
    if(inspector.is_wrong(v)) { // and only removed polygons use it
      soup.points[v] = Kernel::Point_3(0, 0, 0);
    }
  }
}

// Removes polygons that cannot be divided into triangles, and says so.
inline void set_undivided_aside(const std::vector<std::size_t>& undivided, Polygon_soup& soup)
{
  std::vector<Index> part_of(soup.polygons.size(), no_index);
  std::vector<Skipped_part> parts;
  for(const std::size_t p : undivided) {
    part_of[p] = static_cast<Index>(parts.size());
    parts.push_back(skipped_part(Diagnosis::UNDIVIDED_FACE, undivided_text(soup.origins[p])));
  }
  leave_out(soup, part_of, parts);
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SET_ASIDE_H
