// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PICTURES_SEAM_CHAINS_H
#define PICTURES_SEAM_CHAINS_H

#include <CGAL/Texture_atlas/internal/prepare/build_mesh.h>

#include <cstddef>
#include <vector>

namespace pictures {

using namespace CGAL::Texture_atlas::internal::prepare;

namespace internal {

// The seam by which a seam goes on at the target of a halfedge; the null edge at ends and where seams meet.
inline Edge next_seam(const Mesh& mesh, const Edge_marks& seams, const Halfedge h)
{
  Edge next = Mesh::null_edge();
  std::size_t count = 0;
  for(const Halfedge other : mesh.halfedges_around_target(h)) {
    const Edge e = mesh.edge(other);
    count += seams[e] || mesh.is_border(e);
    next = seams[e] && e != mesh.edge(h) ? e : next;
  }
  return count == 2 ? next : Mesh::null_edge();
}

} // namespace internal

// The number of the chain of seams of each edge, from 0; -1 off the seams. A chain goes from an end, or from where
// seams meet, to the next.
inline std::vector<int> seam_chains(const Mesh& mesh, const Edge_marks& seams)
{
  std::vector<int> chains(mesh.number_of_edges(), -1);
  int number = 0;
  for(const Edge first : mesh.edges()) {
    if(!seams[first] || chains[first.idx()] >= 0) {
      continue;
    }
    chains[first.idx()] = number;
    for(Halfedge h : {mesh.halfedge(first, 0), mesh.halfedge(first, 1)}) {
      for(Edge e = internal::next_seam(mesh, seams, h); e != Mesh::null_edge() && chains[e.idx()] < 0;
          e = internal::next_seam(mesh, seams, h)) {
        chains[e.idx()] = number;
        h = mesh.source(mesh.halfedge(e)) == mesh.target(h) ? mesh.halfedge(e)
                                                            : mesh.opposite(mesh.halfedge(e));
      }
    }
    ++number;
  }
  return chains;
}

} // namespace pictures

#endif // PICTURES_SEAM_CHAINS_H
