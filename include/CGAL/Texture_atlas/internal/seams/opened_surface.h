// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A mesh without its seams, as numbered sides and sectors: what becomes of each vertex that seams divide.
// `check_parts.h` examines its parts, and `make_seam_mesh.h` finds the halfedges of a `Seam_mesh` by it.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_OPENED_SURFACE_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_OPENED_SURFACE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Texture_atlas::internal {

inline constexpr std::size_t no_side = (std::numeric_limits<std::size_t>::max)();

// A surface without its seams. A side is a halfedge with a face; sides are numbered part by part, and face by face. A
// sector is a vertex of the opened surface: faces around a vertex that are next to each other across edges that are not
// seams.
template <typename TriangleMesh>
class Opened_surface
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef
      typename boost::property_map<TriangleMesh, CGAL::dynamic_halfedge_property_t<std::size_t>>::const_type
          Side_map;

public:
  // Has the sides and sectors from `first_...` up to those of the next part.
  struct Part
  {
    std::size_t first_side, first_sector, number_of_faces;
  };

  template <typename EdgeIsSeamMap>
  Opened_surface(const TriangleMesh& mesh, EdgeIsSeamMap seams)
  {
    Side_map side_of = get(CGAL::dynamic_halfedge_property_t<std::size_t>(), mesh);
    for(halfedge_descriptor h : halfedges(mesh))
      put(side_of, h, no_side);
    const auto is_cut = [&](halfedge_descriptor h) {
      return CGAL::is_border(opposite(h, mesh), mesh) || get(seams, edge(h, mesh));
    };
    for(face_descriptor f : faces(mesh))
      if(get(side_of, halfedge(f, mesh)) == no_side) {
        parts.push_back({halfedge_of.size(), 0, 0});
        parts.back().number_of_faces = add_part(mesh, f, side_of, is_cut);
      }
    parts.push_back({halfedge_of.size(), 0, 0});

    opposites.reserve(halfedge_of.size());
    for(halfedge_descriptor h : halfedge_of)
      opposites.push_back(is_cut(h) ? no_side : get(side_of, opposite(h, mesh)));
    find_sectors();
  }

  std::size_t number_of_parts() const { return parts.size() - 1; }
  bool is_on_border(std::size_t side) const { return opposites[side] == no_side; }

  // The next side to the same sector, or `no_side` behind the last one
  std::size_t rotate(std::size_t side) const { return opposites[next_side[side]]; }

  std::size_t next_on_border(std::size_t side) const
  {
    std::size_t result = next_side[side];
    while(!is_on_border(result))
      result = next_side[opposites[result]];
    return result;
  }

  std::vector<halfedge_descriptor> halfedge_of; // of each side
  std::vector<std::size_t> next_side;           // of each side: within its face
  std::vector<std::size_t> opposites; // of each side: the one across, `no_side` at borders and seams
  std::vector<std::size_t> sector;    // of each side: that of its target
  std::vector<std::size_t>
      first_side;          // of each sector: one that leads to it, the first in the order of `rotate()`
  std::vector<Part> parts; // and an empty one at the end

private:
  // Returns the number of faces.
  template <typename Is_cut>
  std::size_t add_part(const TriangleMesh& mesh, face_descriptor first, const Side_map& side_of,
                       const Is_cut& is_cut)
  {
    std::size_t number_of_faces = 0;
    const auto add_face = [&](halfedge_descriptor start) {
      const std::size_t begin = halfedge_of.size();
      halfedge_descriptor h = start;
      do {
        put(side_of, h, halfedge_of.size());
        halfedge_of.push_back(h);
        next_side.push_back(halfedge_of.size());
        h = next(h, mesh);
      } while(h != start);
      next_side.back() = begin;
      ++number_of_faces;
    };
    std::size_t side = halfedge_of.size();
    add_face(halfedge(first, mesh));
    for(; side < halfedge_of.size(); ++side) {
      const halfedge_descriptor h = halfedge_of[side];
      if(!is_cut(h) && get(side_of, opposite(h, mesh)) == no_side)
        add_face(opposite(h, mesh));
    }
    return number_of_faces;
  }

  void find_sectors()
  {
    sector.assign(halfedge_of.size(), no_side);
    const auto add_sector = [&](std::size_t start) {
      for(std::size_t side = start; side != no_side && sector[side] == no_side; side = rotate(side))
        sector[side] = first_side.size();
      first_side.push_back(start);
    };
    for(std::size_t p = 0; p < number_of_parts(); ++p) {
      parts[p].first_sector = first_side.size();
      for(std::size_t side = parts[p].first_side; side < parts[p + 1].first_side; ++side)
        if(is_on_border(side))
          add_sector(side);
      for(std::size_t side = parts[p].first_side; side < parts[p + 1].first_side; ++side)
        if(sector[side] == no_side)
          add_sector(side);
    }
    parts.back().first_sector = first_side.size();
  }
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_OPENED_SURFACE_H
