// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_MAKE_SEAM_MESH_H
#define CGAL_TEXTURE_ATLAS_MAKE_SEAM_MESH_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/named_parameters.h>
#include <CGAL/Texture_atlas/internal/seams/opened_surface.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

// `Seam_mesh` calls only functions of meshes that were declared before it.
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Surface_mesh.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <unordered_set>
#include <vector>

/// \file make_seam_mesh.h

namespace CGAL {

namespace Texture_atlas {

/// \ingroup PkgTextureAtlasRef
///
/// The seam mesh that `make_seam_mesh()` returns. Its copies share the marks of seams.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`.
template <typename TriangleMesh>
using Cut_mesh =
#ifdef DOXYGEN_RUNNING
    CGAL::Seam_mesh<TriangleMesh, unspecified_type, unspecified_type>;
#else
    CGAL::Seam_mesh<
        TriangleMesh,
        typename boost::property_map<TriangleMesh, CGAL::dynamic_edge_property_t<bool>>::const_type,
        typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<bool>>::const_type>;
#endif

#ifndef DOXYGEN_RUNNING
namespace internal {

// `Seam_mesh` tells the sectors of exactly those vertices apart that are marked. Besides the ends of seams we mark
// pinched vertices, so that they come apart as well.
template <typename TriangleMesh, typename VertexIsSeamMap, typename EdgeIsSeamMap>
void mark_vertices(const TriangleMesh& mesh, EdgeIsSeamMap seams, VertexIsSeamMap marks)
{
  const auto has_border = get(CGAL::dynamic_vertex_property_t<bool>(), mesh);
  for(auto v : vertices(mesh)) {
    put(has_border, v, false);
    put(marks, v, false);
  }
  for(auto h : halfedges(mesh)) {
    const auto v = target(h, mesh);
    if(get(seams, edge(h, mesh)) || (CGAL::is_border(h, mesh) && get(has_border, v)))
      put(marks, v, true);
    if(CGAL::is_border(h, mesh))
      put(has_border, v, true);
  }
}

// A halfedge to a marked vertex that faces surround; or the null halfedge. Around such a vertex, `Seam_mesh` searches
// for a seam or border without end.
template <typename TriangleMesh, typename VertexIsSeamMap, typename EdgeIsSeamMap>
typename boost::graph_traits<TriangleMesh>::halfedge_descriptor
halfedge_to_surrounded_mark(const TriangleMesh& mesh, EdgeIsSeamMap seams, VertexIsSeamMap marks)
{
  const Opened_surface<TriangleMesh> surface(mesh, seams);
  for(std::size_t side : surface.first_side)
    if(!surface.is_on_border(side) && get(marks, target(surface.halfedge_of[side], mesh)))
      return surface.halfedge_of[side];
  return boost::graph_traits<TriangleMesh>::null_halfedge();
}

template <typename Point>
double distance(const Point& p, const Point& q)
{
  return std::hypot(CGAL::to_double(p.x()) - CGAL::to_double(q.x()),
                    CGAL::to_double(p.y()) - CGAL::to_double(q.y()),
                    CGAL::to_double(p.z()) - CGAL::to_double(q.z()));
}

// A halfedge on the longest border cycle along these faces; the first one found if lengths are not comparable.
template <typename SeamMesh, typename FaceRange, typename NamedParameters>
typename SeamMesh::halfedge_descriptor longest_border(const SeamMesh& mesh, const FaceRange& faces,
                                                      const NamedParameters& np)
{
  typedef typename SeamMesh::halfedge_descriptor halfedge_descriptor;
  const auto points = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                   get_const_property_map(CGAL::vertex_point, mesh.mesh()));
  const auto point = [&](const halfedge_descriptor& h) { return get(points, target(h.tmhd, mesh.mesh())); };
  std::unordered_set<halfedge_descriptor> visited;
  halfedge_descriptor longest;
  double largest_length = -1;
  for(auto f : faces)
    for(halfedge_descriptor inner : CGAL::halfedges_around_face(halfedge(f, mesh), mesh)) {
      const halfedge_descriptor border = opposite(inner, mesh);
      if(!CGAL::is_border(border, mesh) || visited.count(border) != 0)
        continue;
      double length = 0;
      for(halfedge_descriptor h = border; visited.insert(h).second; h = next(h, mesh))
        length += distance(point(opposite(h, mesh)), point(h));
      if(longest == halfedge_descriptor() || length > largest_length) {
        longest = border;
        largest_length = length;
      }
    }
  return longest;
}

} // namespace internal
#endif // DOXYGEN_RUNNING

/// \ingroup PkgTextureAtlasRef
///
/// What `make_seam_mesh()` returns.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`.
template <typename TriangleMesh>
struct Seam_mesh_report : Mesh_report<TriangleMesh>
{
  Cut_mesh<TriangleMesh> mesh; ///< The seam mesh. It has no seams if anything is wrong.
};

/// \ingroup PkgTextureAtlasRef
///
/// returns the `Seam_mesh` of a surface with marked seams, which the parameterizers take as it is.
///
/// \code{.cpp}
/// auto cut = make_seam_mesh(mesh, seams);
/// if(!cut)
///   std::cerr << cut.message << "\n";
/// typedef Cut_mesh<Mesh> Seam_mesh;
/// parameterize(cut.mesh, ABF_plus_plus_parameterizer_3<Seam_mesh>(), border_halfedge(cut.mesh), uvmap);
/// \endcode
///
/// The coordinates belong to halfedges of `mesh`: those of the corner of a face at the target of `h` are at the key
/// `target(h, cut.mesh)`, which converts to a halfedge of `mesh`. `uvmap` has these keys only.
///
/// The seam mesh has its own copies of the marks: it does not change with `seams`. It refers to `mesh`, which must
/// exist as long as the seam mesh. It knows its number of seams, whereas the constructor of `Seam_mesh` assumes 0 for
/// edges that are already marked. Marked border edges, which `Seam_mesh` does not support, are not seams. A pinched
/// vertex on the border becomes several vertices, one for each fan of faces.
///
/// Include the header of a mesh type other than `Surface_mesh` before `make_seam_mesh.h`: otherwise, `Seam_mesh` does
/// not find its functions.
///
/// Time and memory are linear in the size of the mesh.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`.
/// \tparam EdgeIsSeamMap a model of `ReadablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type.
///
/// \param mesh the surface.
/// \param seams is `true` for the edges to be cut open. They need not leave disks.
///
/// \return the seam mesh, or what is wrong: a vertex is surrounded by faces, and is on a seam or border of other faces
///   as well (`Diagnosis::NON_MANIFOLD_VERTEX`). The offending vertex is that one.
template <typename TriangleMesh, typename EdgeIsSeamMap>
Seam_mesh_report<TriangleMesh> make_seam_mesh(const TriangleMesh& mesh, EdgeIsSeamMap seams)
{
  internal::Check_edge_map<TriangleMesh, EdgeIsSeamMap>();
  const auto edge_marks = get(CGAL::dynamic_edge_property_t<bool>(), mesh);
  std::size_t number_of_seams = 0;
  for(auto e : edges(mesh)) {
    const bool is_seam = get(seams, e) && !CGAL::is_border(e, mesh);
    put(edge_marks, e, is_seam);
    number_of_seams += is_seam;
  }
  const auto vertex_marks = get(CGAL::dynamic_vertex_property_t<bool>(), mesh);
  internal::mark_vertices(mesh, edge_marks, vertex_marks);
  const auto wrong = internal::halfedge_to_surrounded_mark(mesh, edge_marks, vertex_marks);

  Seam_mesh_report<TriangleMesh> result{{}, Cut_mesh<TriangleMesh>(mesh, edge_marks, vertex_marks)};
  if(wrong == boost::graph_traits<TriangleMesh>::null_halfedge()) {
    result.mesh.set_seam_edges_number(
        static_cast<typename Cut_mesh<TriangleMesh>::edges_size_type>(number_of_seams));
    return result;
  }
  for(auto e : edges(mesh))
    put(edge_marks, e, false);
  for(auto v : vertices(mesh))
    put(vertex_marks, v, false);
  result.status = Diagnosis::NON_MANIFOLD_VERTEX;
  result.offending_vertices = {target(wrong, mesh)};
  result.message = internal::vertex_of_mesh_text(mesh, target(wrong, mesh)) +
                   " is surrounded by faces, and is on a seam or border of other faces";
  return result;
}

#ifndef DOXYGEN_RUNNING
// The seam mesh refers to the mesh.
template <typename TriangleMesh, typename EdgeIsSeamMap>
Seam_mesh_report<TriangleMesh> make_seam_mesh(const TriangleMesh&& mesh, EdgeIsSeamMap seams) = delete;
#endif

/// \ingroup PkgTextureAtlasRef
///
/// returns a halfedge on the longest border of a seam mesh, for the parameterizers; the null halfedge if there is no
/// border. The time is linear.
///
/// \tparam TM, SEM, SVM the arguments of any `Seam_mesh`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param seam_mesh the seam mesh.
/// \param np optional named parameters:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the points of the vertices of `seam_mesh.mesh()`}
///     \cgalParamType{a model of `ReadablePropertyMap` with a `Point_3` of any kernel as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, seam_mesh.mesh())`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
template <typename TM, typename SEM, typename SVM, typename CGAL_NP_TEMPLATE_PARAMETERS>
typename CGAL::Seam_mesh<TM, SEM, SVM>::halfedge_descriptor
border_halfedge(const CGAL::Seam_mesh<TM, SEM, SVM>& seam_mesh,
                const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::longest_border(seam_mesh, faces(seam_mesh), np);
}

/// \ingroup PkgTextureAtlasRef
///
/// returns a halfedge on the longest border of the part of `f`: the faces connected with `f` across edges that are not
/// seams. It is the null halfedge if the part is closed.
///
/// The time is \cgalBigO{m \log m} if the part has \f$m\f$ faces.
template <typename TM, typename SEM, typename SVM, typename CGAL_NP_TEMPLATE_PARAMETERS>
typename CGAL::Seam_mesh<TM, SEM, SVM>::halfedge_descriptor
border_halfedge(const CGAL::Seam_mesh<TM, SEM, SVM>& seam_mesh,
                typename boost::graph_traits<TM>::face_descriptor f,
                const CGAL_NP_CLASS& np = parameters::default_values())
{
  std::vector<typename boost::graph_traits<TM>::face_descriptor> part;
  Polygon_mesh_processing::connected_component(f, seam_mesh, std::back_inserter(part));
  return internal::longest_border(seam_mesh, part, np);
}

} // namespace Texture_atlas

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_TEXTURE_ATLAS_MAKE_SEAM_MESH_H
