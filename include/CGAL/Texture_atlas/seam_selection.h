// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_SEAM_SELECTION_H
#define CGAL_TEXTURE_ATLAS_SEAM_SELECTION_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/named_parameters.h>
#include <CGAL/Texture_atlas/Seam_report.h>
#include <CGAL/Texture_atlas/internal/seams/read_vertex_pairs.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <cstddef>
#include <fstream>
#include <iterator>
#include <istream>
#include <ostream>
#include <string>
#include <vector>

/// \file seam_selection.h

namespace CGAL {

namespace Texture_atlas {

#ifndef DOXYGEN_RUNNING
namespace internal {

template <typename TriangleMesh>
typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<std::size_t>>::const_type
number_vertices(const TriangleMesh& mesh, std::size_t& number_of_vertices)
{
  const auto numbers = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
  number_of_vertices = 0;
  for(auto v : vertices(mesh))
    put(numbers, v, number_of_vertices++);
  return numbers;
}

} // namespace internal
#endif

/// \ingroup PkgTextureAtlasRef
///
/// marks the edges of a selection file (`.selection.txt`) as seams.
///
/// A selection file of \cgal has three lines: the numbers of vertices, of faces, and of edges, where an edge is a pair
/// of vertices. This function ignores the first two lines, and reads edges from the third line to the end of the file.
/// Vertices are numbered from 0, in the order of `vertices(mesh)`. These are the files that \cgal's demo for polyhedra
/// writes, and that `Seam_mesh::add_seams()` reads. `Seam_mesh::add_seams()` ignores edges that do not exist, an odd
/// last number, and everything after a word that is not a number. This function reports them as errors.
///
/// Parallel edges are given by the same pair, and are marked together. For \f$n\f$ edges of which \f$k\f$ are in the
/// file, the time is \cgalBigO{(n + k) \log k}.
///
/// \tparam TriangleMesh a model of `VertexListGraph`, `EdgeListGraph` and `FaceGraph`.
/// \tparam EdgeIsSeamMap a model of `WritablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type.
///
/// \param in the file's contents.
/// \param mesh the mesh that the numbers refer to.
/// \param seams is set to `true` for the edges of the file, and unchanged for all other edges. On any error, it is
///        unchanged.
///
/// \return what was read, or what is wrong in which line. The offending vertices are the two without an edge between
///   them.
template <typename TriangleMesh, typename EdgeIsSeamMap>
Mesh_report<TriangleMesh, Seam_selection_report>
read_seam_selection(std::istream& in, const TriangleMesh& mesh, EdgeIsSeamMap seams)
{
  internal::Check_edge_map<TriangleMesh, EdgeIsSeamMap>();
  Mesh_report<TriangleMesh, Seam_selection_report> report;
  std::size_t number_of_vertices = 0;
  const auto number_of = internal::number_vertices(mesh, number_of_vertices);
  std::vector<internal::Selection_number> numbers;
  static_cast<Seam_selection_report&>(report) = internal::read_numbers(in, number_of_vertices, numbers);
  if(!report)
    return report;

  internal::Vertex_pairs pairs(numbers);
  std::vector<typename boost::graph_traits<TriangleMesh>::edge_descriptor> selected;
  for(auto e : edges(mesh)) {
    const std::size_t count = pairs.find(get(number_of, source(e, mesh)), get(number_of, target(e, mesh)));
    if(count == 0)
      continue;
    if(CGAL::is_border(e, mesh))
      report.number_of_border_edges += count;
    else {
      report.number_of_seams += count;
      selected.push_back(e);
    }
  }
  if(const std::size_t i = pairs.first_not_found(numbers.size()); i != numbers.size()) {
    static_cast<Seam_selection_report&>(report) =
        internal::failure(Diagnosis::NO_SUCH_EDGE,
                          "there is no edge between vertices " + std::to_string(numbers[i].value) + " and " +
                              std::to_string(numbers[i + 1].value),
                          numbers[i].line, numbers[i].element);
    for(std::size_t k : {i, i + 1})
      report.offending_vertices.push_back(*std::next(vertices(mesh).begin(), numbers[k].value));
    return report;
  }
  for(auto e : selected)
    put(seams, e, true);
  return report;
}

/// \ingroup PkgTextureAtlasRef
///
/// marks the edges of the selection file `file_name` as seams, as above.
template <typename TriangleMesh, typename EdgeIsSeamMap>
Mesh_report<TriangleMesh, Seam_selection_report>
read_seam_selection(const std::string& file_name, const TriangleMesh& mesh, EdgeIsSeamMap seams)
{
  Mesh_report<TriangleMesh, Seam_selection_report> report;
  std::ifstream in(file_name);
  if(!in) {
    static_cast<Seam_selection_report&>(report) =
        internal::failure(Diagnosis::CANNOT_OPEN, "cannot open " + file_name);
    return report;
  }
  report = read_seam_selection(in, mesh, seams);
  if(!report)
    report.message = file_name + ": " + report.message;
  return report;
}

/// \ingroup PkgTextureAtlasRef
///
/// writes the seams to a selection file, for `read_seam_selection()` and \cgal. The lines of vertices and faces are
/// empty. Marked border edges are left out. The time is linear.
///
/// \tparam TriangleMesh a model of `VertexListGraph`, `EdgeListGraph` and `FaceGraph`.
/// \tparam EdgeIsSeamMap a model of `ReadablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type.
///
/// \param out receives the file's contents.
/// \param mesh the mesh.
/// \param seams is `true` for seams.
///
/// \return what was written, or what is wrong.
template <typename TriangleMesh, typename EdgeIsSeamMap>
Seam_selection_report write_seam_selection(std::ostream& out, const TriangleMesh& mesh, EdgeIsSeamMap seams)
{
  internal::Check_edge_map<TriangleMesh, EdgeIsSeamMap>();
  Seam_selection_report report;
  std::size_t number_of_vertices = 0;
  const auto number_of = internal::number_vertices(mesh, number_of_vertices);
  out << "\n\n";
  for(auto e : edges(mesh)) {
    if(!get(seams, e))
      continue;
    if(CGAL::is_border(e, mesh)) {
      ++report.number_of_border_edges;
      continue;
    }
    ++report.number_of_seams;
    // a string, because a stream may group digits
    out << std::to_string(get(number_of, source(e, mesh))) + " " +
               std::to_string(get(number_of, target(e, mesh))) + " ";
  }
  out << "\n" << std::flush;
  return out ? report : internal::failure(Diagnosis::CANNOT_WRITE, "writing failed");
}

/// \ingroup PkgTextureAtlasRef
///
/// writes the seams to the selection file `file_name`, as above. `Seam_mesh::add_seams()` and \cgal's demo expect that
/// the name ends with `.selection.txt`.
template <typename TriangleMesh, typename EdgeIsSeamMap>
Seam_selection_report write_seam_selection(const std::string& file_name, const TriangleMesh& mesh,
                                           EdgeIsSeamMap seams)
{
  std::ofstream out(file_name);
  if(!out)
    return internal::failure(Diagnosis::CANNOT_OPEN, "cannot open " + file_name);
  Seam_selection_report report = write_seam_selection(out, mesh, seams);
  if(!report)
    report.message = file_name + ": " + report.message;
  return report;
}

} // namespace Texture_atlas

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_TEXTURE_ATLAS_SEAM_SELECTION_H
