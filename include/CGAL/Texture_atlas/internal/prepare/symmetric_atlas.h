// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SYMMETRIC_ATLAS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SYMMETRIC_ATLAS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>
#include <CGAL/Texture_atlas/internal/prepare/prepare_edges.h>
#include <CGAL/Texture_atlas/Soup_report.h>
#include <CGAL/Texture_atlas/internal/prepare/build_mesh.h>

#include <CGAL/Real_timer.h>
#include <CGAL/Texture_atlas/symmetrize_seams.h>

#include <cstddef>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// Makes atlases of a mesh: one as usual, and several with symmetric seams, of which the densest is chosen.
// `make(atlas, cuts_charts)` makes one with weights of edges, and keeps seams that are there.
template <typename Make>
class Symmetric_atlas_maker
{
public:
  // The weights of edges are set.
  Symmetric_atlas_maker(Mesh& mesh, const Make& make)
      : m_mesh(mesh), m_make(make), m_attempt(separate_atlas()), m_best(separate_atlas())
  {
    const auto weights = edge_weights(mesh);
    for(const Edge e : mesh.edges()) {
      m_weights.push_back(weights[e]);
    }
  }

  // Fills `atlas`, where seams may be given.
  Report_on_atlas run(const Atlas& atlas, Soup_report::Symmetry& symmetry)
  {
    Real_timer timer;
    timer.start();
    m_symmetry.plane = find_mirror_plane(m_mesh);
    m_symmetry.has_symmetric_surface = m_symmetry.plane && m_symmetry.plane.deviation <= largest_deviation;
    const Marks given = marks_of(atlas);
    m_usual = make(atlas, true, false);
    m_symmetry.asymmetry = asymmetry_of(atlas);
    Report_on_atlas report = m_usual;
    if(m_symmetry.has_symmetric_surface && m_usual.has_atlas()) {
      try_seams(marks_of(atlas), false);
      mark(given, m_attempt);
      make(m_attempt, true, true);
      try_seams(marks_of(m_attempt), true);
    }
    if(m_symmetry.has_symmetric_seams) {
      copy(m_best, atlas);
      report = m_report;
    }
    remove(m_attempt);
    remove(m_best);
    symmetry = m_symmetry;
    report.seconds.charts += timer.time() - report.seconds.total(); // of all atlases
    return report;
  }

private:
  using Marks = std::vector<bool>;

  Atlas separate_atlas()
  {
    return {m_mesh.add_property_map<Halfedge, Kernel::Point_2>().first,
            m_mesh.add_property_map<Face, int>("", -1).first,
            m_mesh.add_property_map<Edge, bool>("", false).first};
  }

  void remove(Atlas& atlas)
  {
    m_mesh.remove_property_map(atlas.uv);
    m_mesh.remove_property_map(atlas.chart);
    m_mesh.remove_property_map(atlas.seams);
  }

  void copy(const Atlas& from, const Atlas& to) const
  {
    for(const Halfedge h : m_mesh.halfedges()) {
      to.uv[h] = from.uv[h];
    }
    for(const Face f : m_mesh.faces()) {
      to.chart[f] = from.chart[f];
    }
    mark(marks_of(from), to);
  }

  Marks marks_of(const Atlas& atlas) const
  {
    Marks result;
    for(const Edge e : m_mesh.edges()) {
      result.push_back(atlas.seams[e]);
    }
    return result;
  }

  void mark(const Marks& marks, const Atlas& atlas) const
  {
    std::size_t i = 0;
    for(const Edge e : m_mesh.edges()) {
      atlas.seams[e] = marks[i++];
    }
  }

  Report_on_atlas make(const Atlas& atlas, const bool cuts_charts, const bool favors_plane) const
  {
    auto weights = edge_weights(m_mesh);
    std::size_t i = 0;
    for(const Edge e : m_mesh.edges()) {
      weights[e] = m_weights[i++];
    }
    if(favors_plane) {
      favor_mirror_plane(m_mesh, m_symmetry.plane, weights);
    }
    return m_make(atlas, cuts_charts);
  }

  double asymmetry_of(const Atlas& atlas) const
  {
    return m_symmetry.plane ? measure_symmetry(m_mesh, atlas.seams, m_symmetry.plane).asymmetry : 0;
  }

  // With the seams of either side. If these are not too long, more cuts are tried.
  void try_seams(const Marks& seams, const bool favors_plane)
  {
    for(const bool is_upper_side : {false, true}) {
      mark(seams, m_attempt);
      symmetrize(is_upper_side);
      const Marks symmetric = marks_of(m_attempt);
      if(consider(make(m_attempt, false, favors_plane))) {
        mark(symmetric, m_attempt);
        make(m_attempt, true, favors_plane);
        symmetrize(is_upper_side);
        consider(make(m_attempt, false, favors_plane));
      }
    }
  }

  void symmetrize(const bool is_upper_side) const
  {
    symmetrize_seams(m_mesh, m_attempt.seams, m_symmetry.plane, is_upper_side,
                     parameters::edge_is_constrained_map(diagonals(m_mesh)));
  }

  // Takes the attempt if it is the best so far. Returns whether it has symmetric seams that are not too long.
  bool consider(const Report_on_atlas& report)
  {
    if(!report.has_atlas() || report.skipped.size() > m_usual.skipped.size() ||
       report.seam_length > (1 + largest_extra_length) * m_usual.seam_length) {
      return false;
    }
    const double asymmetry = asymmetry_of(m_attempt);
    if(asymmetry > largest_asymmetry + m_symmetry.plane.deviation) {
      return false;
    }
    if(!m_symmetry.has_symmetric_seams || report.texel_density > m_report.texel_density) {
      copy(m_attempt, m_best);
      m_report = report;
      m_symmetry.has_symmetric_seams = true;
      m_symmetry.asymmetry = asymmetry;
      m_symmetry.extra_length = m_usual.seam_length > 0 ? report.seam_length / m_usual.seam_length - 1 : 0;
    }
    return true;
  }

  static constexpr double largest_deviation = 0.015, largest_extra_length = 0.05, largest_asymmetry = 0.01;

  Mesh& m_mesh;
  const Make& m_make;
  std::vector<double> m_weights;
  Atlas m_attempt, m_best;
  Report_on_atlas m_usual, m_report; // the second is of the best attempt
  Soup_report::Symmetry m_symmetry;
};

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SYMMETRIC_ATLAS_H
