// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SEPARATE_SOUP_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SEPARATE_SOUP_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/Disjoint_sets.h>
#include <CGAL/Texture_atlas/internal/prepare/check_polygons.h>
#include <CGAL/Texture_atlas/internal/prepare/Input_error.h>
#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// An edge of two polygons
struct Inner_edge
{
  Vertex_pair ends;
  std::size_t p, q; // the polygons
  bool is_alike;    // they run along it in opposite directions, as neighbors of a surface do
  double loop;      // see `find_loops()`
};

// The edges of two polygons, and the vertices of all other edges
inline std::pair<std::vector<Inner_edge>, std::vector<std::size_t>>
inner_edges_and_rim(const Polygon_soup& soup)
{
  // With the polygon, and whether it runs from the smaller vertex to the larger one
  std::vector<std::tuple<Vertex_pair, std::size_t, bool>> sides;
  for(std::size_t p = 0; p < soup.polygons.size(); ++p) {
    const Polygon& polygon = soup.polygons[p];
    for(std::size_t i = 0; i < polygon.size(); ++i) {
      const Vertex_pair side = side_of(polygon, i);
      sides.emplace_back(side, p, side.first == polygon[i]);
    }
  }
  std::sort(sides.begin(), sides.end());
  std::pair<std::vector<Inner_edge>, std::vector<std::size_t>> result;
  for(auto begin = sides.begin(); begin != sides.end();) {
    const auto& [ends, p, is_forward] = *begin;
    const auto end =
        std::find_if(begin, sides.end(), [&e = ends](const auto& s) { return std::get<0>(s) != e; });
    if(end - begin == 2 && std::get<1>(begin[1]) != p) {
      result.first.push_back({ends, p, std::get<1>(begin[1]), std::get<2>(begin[1]) != is_forward, -1});
    } else {
      result.second.insert(result.second.end(), {ends.first, ends.second});
    }
    begin = end;
  }
  return result;
}

// Both sides of all polygons. Those of neighbors can be joined to surfaces; then a surface that has both sides of a
// polygon is one-sided.
class Joined_sides
{
public:
  explicit Joined_sides(const std::size_t polygons) : m_sets(2 * polygons) {}

  void join(const Inner_edge& edge)
  {
    m_sets.union_set(2 * edge.p, 2 * edge.q + !edge.is_alike);
    m_sets.union_set(2 * edge.p + 1, 2 * edge.q + edge.is_alike);
  }

  // At this edge
  bool are_joined(const Inner_edge& edge) { return same(2 * edge.p, 2 * edge.q + !edge.is_alike); }

  // At whatever edges, even if the sides differ
  bool polygons_are_joined(const Inner_edge& edge)
  {
    return same(2 * edge.p, 2 * edge.q) || same(2 * edge.p, 2 * edge.q + 1);
  }

  bool is_one_sided(const std::size_t p) { return same(2 * p, 2 * p + 1); }

private:
  bool same(const std::size_t a, const std::size_t b) { return m_sets.find_set(a) == m_sets.find_set(b); }

  CGAL::Surface_mesh_parameterization::internal::ABF::Disjoint_sets m_sets;
};

// Finds for each edge how long the shortest path over it is, from the rim to the rim, or from one vertex back to it
// where there is no rim. The edges of a tree of shortest paths keep -1.
inline void find_loops(const std::vector<Kernel::Point_3>& points, const std::vector<std::size_t>& rim,
                       std::vector<Inner_edge>& edges)
{
  using Entry = std::pair<double, std::size_t>; // a distance, and a vertex
  const double infinity = std::numeric_limits<double>::infinity();
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  std::vector<double> distance(points.size(), infinity), length;
  std::vector<std::size_t> last_edge(points.size(), edges.size());
  std::vector<std::vector<std::size_t>> edges_at(points.size());
  for(std::size_t e = 0; e < edges.size(); ++e) {
    const auto [v, w] = edges[e].ends;
    length.push_back(std::sqrt(CGAL::squared_distance(points[v], points[w])));
    edges_at[v].push_back(e);
    edges_at[w].push_back(e);
  }
  const auto start = [&](const std::size_t v) {
    distance[v] = 0;
    queue.push({0, v});
  };
  const auto find_paths = [&] {
    while(!queue.empty()) {
      const auto [d, v] = queue.top();
      queue.pop();
      for(const std::size_t e : edges_at[v]) {
        const std::size_t w = edges[e].ends.first + edges[e].ends.second - v;
        if(d == distance[v] && d + length[e] < distance[w]) {
          distance[w] = d + length[e];
          last_edge[w] = e;
          queue.push({distance[w], w});
        }
      }
    }
  };
  std::for_each(rim.begin(), rim.end(), start);
  find_paths();
  for(const Inner_edge& edge : edges) {
    if(distance[edge.ends.first] == infinity) {
      start(edge.ends.first);
      find_paths();
    }
  }
  for(std::size_t e = 0; e < edges.size(); ++e) {
    const auto [v, w] = edges[e].ends;
    if(last_edge[v] != e && last_edge[w] != e) {
      edges[e].loop = distance[v] + length[e] + distance[w];
    }
  }
}

// Edges along which one-sided surfaces, such as Moebius strips, are cut so that they can be oriented. The cuts are
// short, and the surfaces remain connected. Two-sided surfaces have none, whatever the orientation of their polygons.
inline std::set<Vertex_pair> one_sided_cut(const Polygon_soup& soup)
{
  auto [edges, rim] = inner_edges_and_rim(soup);
  Joined_sides all(soup.polygons.size());
  for(const Inner_edge& edge : edges) {
    all.join(edge);
  }
  edges.erase(std::remove_if(edges.begin(), edges.end(),
                             [&](const Inner_edge& edge) { return !all.is_one_sided(edge.p); }),
              edges.end());
  // The edges between polygons that are not neighbors in a tree cut the surface to a disk. They are short if the tree
  // begins where loops are long (Erickson and Whittlesey, "Greedy optimal homotopy and homology generators").
  find_loops(soup.points, rim, edges);
  std::stable_sort(edges.begin(), edges.end(), [](const auto& e, const auto& f) { return e.loop > f.loop; });
  Joined_sides tree(soup.polygons.size());
  for(const Inner_edge& edge : edges) {
    if(!tree.polygons_are_joined(edge)) {
      tree.join(edge);
    }
  }
  // Across the others, the sides fit.
  std::set<Vertex_pair> cut;
  for(const Inner_edge& edge : edges) {
    if(!tree.are_joined(edge)) {
      cut.insert(edge.ends);
    }
  }
  return cut;
}

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
              count_text(cut.size(), "edge") + "; the first is " + edge_name(soup, v, w));
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
              ", for example at " + edge_name(soup, v, w) + ": they are separated there");
  }
  if(!vertices.empty()) {
    notes.add(begin + "parts of the surface were separated at " +
              count_text(vertices.size(), "vertex", "vertices") + ", for example at " +
              vertex_name(soup, vertices.front()));
  }
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SEPARATE_SOUP_H
