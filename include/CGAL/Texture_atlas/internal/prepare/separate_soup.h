// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SEPARATE_SOUP_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SEPARATE_SOUP_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/Input_error.h>
#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>
#include <CGAL/Texture_atlas/internal/prepare/check_polygons.h>
#include <CGAL/Texture_atlas/internal/prepare/one_sided_cut.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/Disjoint_sets.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// Records where sheets of the surface were separated.
struct Separation_visitor : public CGAL::Polygon_mesh_processing::Default_orientation_visitor
{
  std::vector<bool>* is_turned = nullptr; // of each polygon
  std::set<Vertex_pair>* edges = nullptr; // CGAL names an edge as often as it has polygons
  std::vector<std::size_t>* vertices = nullptr;

  void non_manifold_edge(const std::size_t v, const std::size_t w, std::size_t)
  {
    edges->insert((std::minmax)(v, w));
  }

  void polygon_orientation_reversed(const std::size_t p) { (*is_turned)[p] = !(*is_turned)[p]; }

  void duplicated_vertex(const std::size_t v, std::size_t) { vertices->push_back(v); }
};

// CGAL keeps the orientation of the first polygon of each component. This function keeps the orientation of the
// majority.
inline void keep_majority(Polygon_soup& soup, std::vector<bool>& is_turned)
{
  CGAL::Surface_mesh_parameterization::internal::ABF::Disjoint_sets components(soup.points.size());
  for(const Polygon& polygon : soup.polygons) {
    for(const std::size_t v : polygon) {
      components.union_set(polygon[0], v);
    }
  }
  std::vector<std::size_t> all(soup.points.size(), 0), turned(soup.points.size(), 0);
  for(std::size_t p = 0; p < soup.polygons.size(); ++p) {
    const std::size_t component = components.find_set(soup.polygons[p][0]);
    ++all[component];
    turned[component] += is_turned[p];
  }
  for(std::size_t p = 0; p < soup.polygons.size(); ++p) {
    const std::size_t component = components.find_set(soup.polygons[p][0]);
    if(turned[component] > all[component] - turned[component]) {
      std::reverse(soup.polygons[p].begin(), soup.polygons[p].end());
      is_turned[p] = !is_turned[p];
    }
  }
}

// As `CGAL::Polygon_mesh_processing::orient_polygon_soup()`, which has no argument for edges along which polygons are
// to be separated
inline void orient_and_separate(const std::set<Vertex_pair>& cut, Separation_visitor& visitor,
                                Polygon_soup& soup)
{
  CGAL::Polygon_mesh_processing::internal::Polygon_soup_orienter<std::vector<Kernel::Point_3>,
                                                                 std::vector<Polygon>, Separation_visitor>
      orienter(soup.points, soup.polygons, visitor);
  orienter.fill_edge_map();
  orienter.marked_edges.insert(cut.begin(), cut.end());
  orienter.orient();
  orienter.duplicate_singular_vertices();
}

// Makes surfaces of any polygons: orients them, and separates them where more than two meet in an edge, where parts
// touch in a vertex, and along a short cut where they are one-sided.
inline void separate_soup(const Surface_soup& model, Polygon_soup& soup, Notes& notes)
{
  std::vector<bool> is_turned(soup.polygons.size(), false);
  std::set<Vertex_pair> edges;
  std::vector<std::size_t> vertices;
  Separation_visitor visitor;
  visitor.is_turned = &is_turned;
  visitor.edges = &edges;
  visitor.vertices = &vertices;
  const std::set<Vertex_pair> cut = one_sided_cut(soup);
  orient_and_separate(cut, visitor, soup);
  keep_majority(soup, is_turned);
  for(std::size_t p = 0; p < is_turned.size(); ++p) {
    soup.is_turned[p] = soup.is_turned[p] != is_turned[p];
  }
  const std::string begin = model.name.empty() ? "" : "'" + model.name + "': ";
  const auto turned = std::find(is_turned.begin(), is_turned.end(), true);
  if(turned != is_turned.end()) {
    notes.add(begin + "faces were oriented inconsistently: " +
              count_text(static_cast<std::size_t>(std::count(turned, is_turned.end(), true)), "face") +
              " turned; the first is " +
              face_name(soup.origins[static_cast<std::size_t>(turned - is_turned.begin())]));
  }
  if(!cut.empty()) {
    const auto& [v, w] = *cut.begin();
    notes.add(begin + "the surface is one-sided, like a Moebius strip: it is cut along " +
              count_text(cut.size(), "edge") + "; the first is " + edge_name(v, w));
    std::set<std::size_t> ends;
    for(const auto& edge : cut) {
      ends.insert({edge.first, edge.second});
    }
    const auto is_told = [&ends](const std::size_t end) { return ends.count(end) > 0; };
    vertices.erase(std::remove_if(vertices.begin(), vertices.end(), is_told), vertices.end());
  }
  if(!edges.empty()) {
    const auto& [v, w] = *edges.begin();
    notes.add(begin + "more than two faces meet at " + count_text(edges.size(), "edge") +
              ", for example at " + edge_name(v, w) + ": they are separated there");
  }
  if(!vertices.empty()) {
    notes.add(begin + "parts of the surface were separated at " +
              count_text(vertices.size(), "vertex", "vertices") + ", for example at " +
              vertex_name(vertices.front()));
  }
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SEPARATE_SOUP_H
