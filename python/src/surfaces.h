// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_PYTHON_SURFACES_H
#define ABF_PYTHON_SURFACES_H

#include "failures.h"
#include "progress.h"
#include "results.h"
#include "soups.h"

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Texture_atlas/internal/prepare/given_seams.h>
#include <CGAL/Texture_atlas/internal/prepare/prepare_surface.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cstdint>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace abf_python {

namespace prepare = CGAL::Texture_atlas::internal::prepare;

using prepare::Edge;
using prepare::Face;
using prepare::Halfedge;
using prepare::Mesh;
using prepare::Vertex;

// The surface of a mesh that has to be an oriented manifold. Its vertices are those of the soup, in their order.
struct Surface : prepare::Prepared_surface
{
  Surface_soup soup;
};

// Whether a failure is about an argument, not about the surface
inline bool is_of_argument(const SMP::Diagnosis status)
{
  return status == SMP::Diagnosis::WRONG_OPTION || status == SMP::Diagnosis::NO_SUCH_EDGE ||
         status == SMP::Diagnosis::NO_TEXTURE_COORDINATES;
}

// Calls a function that may throw exceptions of any kind.
template <class Function>
auto with_failures(const Function& f)
{
  try {
    return f();
  } catch(const Wrong_value&) {
    throw;
  } catch(const Wrong_type&) {
    throw;
  } catch(const Mesh_failure&) {
    throw;
  } catch(const std::bad_alloc&) {
    throw;
  } catch(const prepare::Input_error& error) {
    if(is_of_argument(error.status)) {
      throw Wrong_value(error.what());
    }
    throw Mesh_failure(to_string(error.status), error.what(), {error.faces.begin(), error.faces.end()},
                       {error.vertices.begin(), error.vertices.end()});
  } catch(const std::exception& error) {
    throw Mesh_failure("INTERNAL_ERROR", std::string("internal error: ") + error.what());
  }
}

inline Surface surface_of(Surface_soup&& soup)
{
  return with_failures([&soup] {
    prepare::Notes notes;
    Surface surface;
    static_cast<prepare::Prepared_surface&>(surface) =
        prepare::prepare_surface(soup, {false, {prepare::Welding::NONE, 0}, {}}, notes);
    if(!surface.set_aside.empty()) {
      const TA::Atlas_report::Skipped& part = surface.set_aside.front();
      throw Mesh_failure(to_string(part.status), part.message, {static_cast<std::int64_t>(part.first_face)},
                         {part.vertices.begin(), part.vertices.end()});
    }
    surface.soup = std::move(soup);
    return surface;
  });
}

// The numbers of vertices in messages
inline auto vertex_numbers()
{
  return boost::make_function_property_map<Vertex>([](const Vertex v) { return std::int64_t(v.idx()) + 1; });
}

// The face of the soup that a triangle is part of
inline std::size_t face_in_soup(const Surface& surface, const Face f)
{
  return surface.soup.polygon_of_corner(surface.origins.corners[surface.mesh.halfedge(f).idx()]);
}

// The faces of the soup, sorted, each once
template <class Faces>
std::vector<std::int64_t> faces_in_soup(const Surface& surface, const Faces& faces)
{
  std::vector<std::int64_t> result;
  for(const Face f : faces) {
    result.push_back(static_cast<std::int64_t>(face_in_soup(surface, f)));
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

// Throws if a report says that something is wrong.
template <class Report>
void check_report(const Surface& surface, const Report& report)
{
  if(report.status == SMP::Diagnosis::WRONG_OPTION) {
    throw Wrong_value(report.message);
  }
  if(!report) {
    std::vector<std::int64_t> vertices;
    for(const Vertex v : report.offending_vertices) {
      vertices.push_back(v.idx());
    }
    for(const Edge e : report.offending_edges) {
      vertices.push_back(surface.mesh.vertex(e, 0).idx());
      vertices.push_back(surface.mesh.vertex(e, 1).idx());
    }
    throw Mesh_failure(to_string(report.status), report.message,
                       faces_in_soup(surface, report.offending_faces), std::move(vertices));
  }
}

// The coordinates of a soup with one for each corner
inline Mesh::Property_map<Halfedge, Kernel::Point_2> corner_map(Surface& surface)
{
  const auto uv = surface.mesh.add_property_map<Halfedge, Kernel::Point_2>("h:uv").first;
  for(const Halfedge h : surface.mesh.halfedges()) {
    if(!surface.mesh.is_border(h)) {
      uv[h] = surface.soup.texture[surface.origins.corners[h.idx()]];
    }
  }
  return uv;
}

// The coordinates of each corner of the soup
inline std::vector<Kernel::Point_2> corners_of(const Surface& surface,
                                               const Mesh::Property_map<Halfedge, Kernel::Point_2>& uv)
{
  std::vector<Kernel::Point_2> corners(surface.soup.number_of_corners());
  for(const Halfedge h : surface.mesh.halfedges()) {
    if(!surface.mesh.is_border(h)) {
      corners[surface.origins.corners[h.idx()]] = uv[h];
    }
  }
  return corners;
}

// The marked edges of a mesh, as vertices
inline Vertex_pairs marked_pairs(const Mesh& mesh, const prepare::Edge_marks& marks)
{
  Vertex_pairs pairs;
  for(const Edge e : mesh.edges()) {
    if(marks[e]) {
      pairs.emplace_back(std::minmax<Index>(mesh.vertex(e, 0).idx(), mesh.vertex(e, 1).idx()));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

} // namespace abf_python

#endif // ABF_PYTHON_SURFACES_H
