// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_POLYGON_SOUP_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_POLYGON_SOUP_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>
#include <CGAL/Texture_atlas/Atlas_report.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>
#include <CGAL/Texture_atlas/internal/prepare/Input_error.h>
#include <CGAL/Texture_atlas/Surface_soup.h>

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

using Texture_atlas::Surface_soup;
using Kernel = Surface_soup::Kernel;
using Index = Surface_soup::Index;
constexpr Index no_index = Surface_soup::none;

using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;
using Halfedge = Mesh::Halfedge_index;
using Edge = Mesh::Edge_index;

using Edge_marks = Mesh::Property_map<Edge, bool>;

// The edges along which a mesh is cut open.
inline Edge_marks seam_marks(Mesh& mesh)
{
  return mesh.add_property_map<Edge, bool>("e:flatten_mesh_seam", false).first;
}

// The edges that divide larger polygons into triangles.
inline Edge_marks diagonals(Mesh& mesh)
{
  return mesh.add_property_map<Edge, bool>("e:flatten_mesh_diagonal", false).first;
}

// Which vertices at the same place are joined
struct Welding
{
  enum Extent
  {
    NONE,
    SEPARATE_FACES, // if no two faces share a vertex
    ALL
  };

  Extent extent = ALL;
  double tolerance = 0; // the distance of points that count as the same
};

using Polygon = std::vector<std::size_t>;

// Polygons that have no chart, and why
using Skipped_part = Atlas_report::Skipped;

inline Skipped_part skipped_part(const Diagnosis status, std::string message)
{
  Skipped_part part;
  part.status = status;
  part.message = std::move(message);
  return part;
}

// The points and polygons of a model, which can be repaired.
struct Polygon_soup
{
  std::vector<Kernel::Point_3> points;
  std::vector<Polygon> polygons;
  std::vector<Index> origins;  // of each polygon, in the model
  std::vector<bool> is_turned; // of each polygon: its corners are in reverse order
  std::map<std::size_t, std::vector<Index>>
      corners; // of polygons that have not all corners of the model's: these
  bool is_welded = false;
  std::vector<Skipped_part> left_out; // what `leave_out()` removed, in the order of the file
};

inline bool is_finite(const Kernel::Point_3& point)
{
  return std::isfinite(point.x()) && std::isfinite(point.y()) && std::isfinite(point.z());
}

// With its point, counted from 1
inline std::string vertex_name(const Polygon_soup& soup, const std::size_t v)
{
  return vertex_text(static_cast<std::ptrdiff_t>(v) + 1, soup.points[v]);
}

inline bool has_repeated_vertex(Polygon polygon)
{
  std::sort(polygon.begin(), polygon.end());
  return std::adjacent_find(polygon.begin(), polygon.end()) != polygon.end();
}

using Vertex_pair = std::pair<std::size_t, std::size_t>;

inline Vertex_pair side_of(const Polygon& polygon, const std::size_t corner)
{
  return std::minmax(polygon[corner], polygon[corner + 1 < polygon.size() ? corner + 1 : 0]);
}

// Of a polygon, the corners that do not repeat the vertex of the corner before. Some programs name a vertex twice in a
// row, which changes nothing. All corners, if fewer than three were left.
inline std::vector<Index> corners_without_repetition(const Surface_soup& model, const Index polygon)
{
  const Index first = model.first_corners[polygon], end = model.first_corners[polygon + 1];
  std::vector<Index> corners;
  for(Index c = first; c < end; ++c) {
    if(model.vertices[c] != model.vertices[c == first ? end - 1 : c - 1]) {
      corners.push_back(c);
    }
  }
  if(corners.size() < 3) {
    corners.resize(end - first);
    std::iota(corners.begin(), corners.end(), first);
  }
  return corners;
}

// All polygons of a model, valid or not
inline Polygon_soup polygon_soup(const Surface_soup& model)
{
  Polygon_soup soup;
  soup.points = model.points;
  soup.is_welded = model.is_welded;
  const std::size_t polygons = model.number_of_polygons();
  soup.polygons.reserve(polygons);
  for(std::size_t p = 0; p < polygons; ++p) {
    Polygon& polygon = soup.polygons.emplace_back();
    std::vector<Index> corners = corners_without_repetition(model, static_cast<Index>(p));
    for(const Index c : corners) {
      polygon.push_back(model.vertices[c]);
    }
    if(corners.size() < model.size(static_cast<Index>(p))) {
      soup.corners.emplace(p, std::move(corners));
    }
    soup.origins.push_back(static_cast<Index>(p));
  }
  soup.is_turned.assign(polygons, false);
  return soup;
}

// Tells of the polygons with fewer corners than in the model.
inline void tell_repetitions(const Polygon_soup& soup, Notes& notes)
{
  std::size_t count = 0, first = 0;
  for(const auto& [p, corners] : soup.corners) {
    first = count == 0 ? soup.origins[p] : first;
    ++count;
  }
  if(count > 0) {
    notes.add(count_text(count, "face names", "faces name") +
              " a vertex twice in a row, which is taken for one corner; the first is " + face_name(first));
  }
}

// Polygons of the same polygon of the model are removed together.
inline void remove_whole_polygons(const Polygon_soup& soup, std::vector<Index>& part_of)
{
  std::map<Index, Index> parts; // of polygons of the model
  for(const auto& [p, corners] : soup.corners) {
    if(part_of[p] != no_index) {
      parts.emplace(soup.origins[p], part_of[p]);
    }
  }
  for(const auto& [p, corners] : soup.corners) {
    if(const auto part = parts.find(soup.origins[p]); part != parts.end()) {
      part_of[p] = part->second;
    }
  }
}

// Removes polygons, and remembers how many and why. `part_of` is, for each polygon, the number of its part, or
// `no_index` for one that stays. Of the parts, only the diagnosis and the message have to be known.
inline void leave_out(Polygon_soup& soup, std::vector<Index> part_of, std::vector<Skipped_part> parts)
{
  remove_whole_polygons(soup, part_of);
  std::set<Index> divided; // polygons of the model, of which only the first triangle counts
  for(Skipped_part& part : parts) {
    part.first_face = (std::numeric_limits<std::size_t>::max)();
    part.number_of_faces = 0;
  }
  std::size_t kept = 0;
  std::map<std::size_t, std::vector<Index>> corners;
  for(std::size_t p = 0; p < soup.polygons.size(); ++p) {
    if(part_of[p] != no_index) {
      Skipped_part& part = parts[part_of[p]];
      part.first_face = (std::min)(part.first_face, std::size_t(soup.origins[p]));
      part.number_of_faces += soup.corners.count(p) == 0 || divided.insert(soup.origins[p]).second;
    } else {
      soup.polygons[kept].swap(soup.polygons[p]);
      soup.origins[kept] = soup.origins[p];
      soup.is_turned[kept] = soup.is_turned[p];
      if(const auto own = soup.corners.find(p); own != soup.corners.end()) {
        corners.emplace(kept, std::move(own->second));
      }
      ++kept;
    }
  }
  soup.polygons.resize(kept);
  soup.origins.resize(kept);
  soup.is_turned.resize(kept);
  soup.corners = std::move(corners);
  soup.left_out.insert(soup.left_out.end(), parts.begin(), parts.end());
  std::stable_sort(soup.left_out.begin(), soup.left_out.end(),
                   [](const Skipped_part& a, const Skipped_part& b) { return a.first_face < b.first_face; });
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_POLYGON_SOUP_H
