// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Which parts of a surface, opened along seams, are disks that can be flattened, and what is wrong with the others.
// `is_disk_cut.h` makes the user's report and messages of it.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_CHECK_PARTS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_CHECK_PARTS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/Seam_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/find_borders.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>
#include <CGAL/Texture_atlas/internal/seams/opened_surface.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Finds out which parts of an opened surface are disks.
template <typename TriangleMesh>
class Part_checker
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  typedef typename Disk_cut_report<TriangleMesh>::Part Part;

public:
  template <typename EdgeIsSeamMap>
  Part_checker(const TriangleMesh& mesh, EdgeIsSeamMap seams)
      : m_mesh(mesh), m_surface(mesh, seams), m_found(m_surface.halfedge_of.size(), false),
        m_neighbour_of(m_surface.first_side.size(), no_side),
        m_sectors_at(get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh))
  {
    for(vertex_descriptor v : vertices(mesh))
      put(m_sectors_at, v, 0);
    for(std::size_t side : m_surface.first_side) {
      const vertex_descriptor v = target(m_surface.halfedge_of[side], mesh);
      put(m_sectors_at, v, get(m_sectors_at, v) + 1);
    }
  }

  std::vector<Part> parts()
  {
    std::vector<Part> result;
    for(std::size_t p = 0; p < m_surface.number_of_parts(); ++p)
      result.push_back(part(m_surface.parts[p], m_surface.parts[p + 1]));
    return result;
  }

private:
  typedef typename Opened_surface<TriangleMesh>::Part Range;

  Part part(const Range& range, const Range& end)
  {
    Part result;
    result.face = face(m_surface.halfedge_of[range.first_side], m_mesh);
    result.number_of_faces = range.number_of_faces;
    find_borders(range, end, result);
    std::size_t border_edges = 0;
    for(std::size_t size : result.border_sizes)
      border_edges += size;
    const std::size_t edges = (end.first_side - range.first_side + border_edges) / 2;
    const std::size_t vertices = end.first_sector - range.first_sector;
    result.euler_characteristic =
        static_cast<std::ptrdiff_t>(vertices + range.number_of_faces) - static_cast<std::ptrdiff_t>(edges);
    result.number_of_handles = static_cast<std::size_t>(2 - result.euler_characteristic -
                                                        static_cast<std::ptrdiff_t>(result.borders.size())) /
                               2;
    find_defect(range, end, result);
    return result;
  }

  void find_borders(const Range& range, const Range& end, Part& result)
  {
    for(std::size_t first = range.first_side; first < end.first_side; ++first) {
      if(!m_surface.is_on_border(first) || m_found[first])
        continue;
      std::size_t size = 0;
      for(std::size_t side = first; !m_found[side]; side = m_surface.next_on_border(side), ++size)
        m_found[side] = true;
      result.borders.push_back(m_surface.halfedge_of[first]);
      result.border_sizes.push_back(size);
    }
  }

  void find_defect(const Range& range, const Range& end, Part& part)
  {
    const auto fail = [&](Diagnosis defect, auto where) {
      part.status = defect;
      part.where = where;
    };
    const auto fails_at = [&](Diagnosis defect, std::size_t side) {
      if(side != no_side)
        fail(defect, m_surface.halfedge_of[side]);
      return side != no_side;
    };
    if(fails_at(Diagnosis::NOT_TRIANGULATED, side_of_polygon(range, end)) ||
       fails_at(Diagnosis::NON_MANIFOLD_VERTEX, side_to_non_manifold_vertex(range, end)))
      return;
    if(part.borders.empty())
      fail(Diagnosis::NO_BORDER, m_surface.halfedge_of[range.first_side]);
    else if(part.number_of_handles > 0)
      fail(Diagnosis::NONZERO_GENUS, m_surface.halfedge_of[range.first_side]);
    else if(part.borders.size() > 1)
      fail(Diagnosis::SEVERAL_BORDERS, part.borders[1]);
    else if(part.border_sizes.front() < 3)
      fail(Diagnosis::SHORT_BORDER, part.borders.front());
    else
      fails_at(Diagnosis::PARALLEL_EDGES, parallel_side(range, end));
  }

  std::size_t side_of_polygon(const Range& range, const Range& end) const
  {
    const std::vector<std::size_t>& next = m_surface.next_side;
    for(std::size_t side = range.first_side; side < end.first_side; ++side)
      if(next[next[next[side]]] != side || next[side] == side)
        return side;
    return no_side;
  }

  // A vertex of several sectors, one of which goes all around it. (`Seam_mesh` cannot tell them apart.)
  std::size_t side_to_non_manifold_vertex(const Range& range, const Range& end) const
  {
    for(std::size_t s = range.first_sector; s < end.first_sector; ++s) {
      const std::size_t side = m_surface.first_side[s];
      if(!m_surface.is_on_border(side) && get(m_sectors_at, target(m_surface.halfedge_of[side], m_mesh)) > 1)
        return side;
    }
    return no_side;
  }

  // A loop, or a side to a sector that another side with the same source leads to. Such a pair remains unnoticed only
  // if both sides are on the border, whose edges are then just these two.
  std::size_t parallel_side(const Range& range, const Range& end)
  {
    std::vector<std::size_t> source(end.first_side - range.first_side);
    for(std::size_t side = range.first_side; side < end.first_side; ++side)
      source[m_surface.next_side[side] - range.first_side] = m_surface.sector[side];
    for(std::size_t s = range.first_sector; s < end.first_sector; ++s) {
      const std::size_t first = m_surface.first_side[s];
      std::size_t side = first;
      do {
        const std::size_t neighbour = source[side - range.first_side];
        if(neighbour == s || m_neighbour_of[neighbour] == s)
          return side;
        m_neighbour_of[neighbour] = s;
        side = m_surface.rotate(side);
      } while(side != no_side && side != first);
    }
    return no_side;
  }

  const TriangleMesh& m_mesh;
  const Opened_surface<TriangleMesh> m_surface;
  std::vector<bool> m_found;               // of each side on the border
  std::vector<std::size_t> m_neighbour_of; // of each sector: the last one that met it as a neighbour
  typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<std::size_t>>::const_type
      m_sectors_at; // of each vertex: how many
};

template <typename TriangleMesh>
std::string edge_text(typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h,
                      const TriangleMesh& mesh)
{
  return "between " + vertex_of_mesh_text(mesh, source(h, mesh)) + " and " +
         vertex_of_mesh_text(mesh, target(h, mesh));
}

inline std::string count_text(std::size_t count, const std::string& thing)
{
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

template <typename TriangleMesh>
std::string border_text(const typename Disk_cut_report<TriangleMesh>::Part& part, const TriangleMesh& mesh)
{
  std::string text = count_text(part.borders.size(), "border");
  const std::size_t most = 5;
  for(std::size_t i = 0; i < part.borders.size() && i < most; ++i)
    text += (i == 0                         ? ": with the edges "
             : i + 1 == part.borders.size() ? " and "
                                            : ", ") +
            edge_text(part.borders[i], mesh);
  return text + (part.borders.size() > most ? " and others" : "");
}

template <typename TriangleMesh>
void name_offenders(const typename Disk_cut_report<TriangleMesh>::Part& part, const TriangleMesh& mesh,
                    Disk_cut_report<TriangleMesh>& report)
{
  switch(part.status) {
  case Diagnosis::NON_MANIFOLD_VERTEX:
    report.offending_vertices = {target(part.where, mesh)};
    break;
  case Diagnosis::SEVERAL_BORDERS:
  case Diagnosis::SHORT_BORDER:
  case Diagnosis::PARALLEL_EDGES:
    report.offending_edges = {edge(part.where, mesh)};
    break;
  default:
    report.offending_faces = {face(part.where, mesh)};
  }
}

template <typename TriangleMesh>
std::string message(const typename Disk_cut_report<TriangleMesh>::Part& part, const TriangleMesh& mesh)
{
  const std::string name = "the part of face " + rank_text(faces(mesh), part.face) + " (" +
                           count_text(part.number_of_faces, "face") + ")";
  switch(part.status) {
  case Diagnosis::NOT_TRIANGULATED:
    return "face " + rank_text(faces(mesh), face(part.where, mesh)) + " is not a triangle";
  case Diagnosis::NON_MANIFOLD_VERTEX:
    return vertex_of_mesh_text(mesh, target(part.where, mesh)) +
           " is surrounded by faces, and also belongs to other faces";
  case Diagnosis::NO_BORDER:
    return name + " is closed: it has neither a border nor a seam";
  case Diagnosis::NONZERO_GENUS:
    return name + " has " + count_text(part.number_of_handles, "handle") + " and " +
           count_text(part.borders.size(), "border");
  case Diagnosis::SEVERAL_BORDERS:
    return name + " has " + border_text(part, mesh);
  case Diagnosis::SHORT_BORDER:
    return name + " has a border of " + count_text(part.border_sizes.front(), "edge") + ", " +
           edge_text(part.where, mesh) + ": no planar triangulation has fewer than three";
  case Diagnosis::PARALLEL_EDGES:
    return "two edges, or a loop, are " + edge_text(part.where, mesh) +
           ": a planar triangulation has at most one edge between two vertices";
  default:
    return std::string();
  }
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_CHECK_PARTS_H
