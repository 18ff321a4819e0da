// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_DIAGNOSIS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_DIAGNOSIS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <ostream>
#include <string>
#include <type_traits>
#include <vector>

/// \file Diagnosis.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// How a call ended. Each function and parameterizer of this package uses some of these values. Section \ref
/// ABF_errors of the manual says for each value what to do.
enum class Diagnosis
{
  NOTHING_WRONG, ///< The call succeeded.

  // The mesh
  EMPTY_MESH,          ///< There is no face, or none with a chart.
  NOT_TRIANGULATED,    ///< A face is not a triangle.
  NON_FINITE_POINT,    ///< A coordinate of a point is infinite or not a number.
  FAR_POINT,           ///< A vertex is more than 10^9 times as far from the middle as most.
  TOO_LARGE,           ///< There are more triangles than 32-bit numbers allow.
  NO_AREA,             ///< No face has an area in space, up to rounding, or a weight above 0.
  NON_MANIFOLD_VERTEX, ///< The faces around a vertex form several fans: the surface is pinched.
  NON_MANIFOLD_EDGE,   ///< Two faces run along an edge in the same direction, or more than two meet there.
  REPEATED_VERTEX,     ///< A face has the same vertex twice.
  SEVERAL_COMPONENTS,  ///< The surface is not connected.
  NO_BORDER,           ///< The surface is closed: it must be cut open first, or `make_atlas()` takes it.
  NOT_ON_BORDER, ///< The given halfedge is null or not on a border of an open surface, or a corner is not on it.
  SHORT_BORDER,    ///< A border has fewer than three edges, or fewer than four for a rectangle.
  SEVERAL_BORDERS, ///< The surface has holes, but must be a disk.
  NONZERO_GENUS,   ///< The surface has handles: it is not a disk.

  /// The surface is neither a sphere nor a disk, which `Cone_options::angle_multiple` needs.
  WRONG_TOPOLOGY,
  PARALLEL_EDGES, ///< Two edges have the same vertices, or an edge is a loop: no planar drawing exists.
  NON_FINITE_COORDINATE,    ///< A coordinate in the plane is infinite or not a number.
  INCONSISTENT_COORDINATES, ///< Planar coordinates differ within a chart at a vertex without a seam.
  DEGENERATE_CHART, ///< A chart has no area in the plane up to rounding, or too large an area to compute.

  // Points and polygons
  WRONG_INPUT,              ///< Points and polygons are no surface as a whole.
  DEGENERATE_FACE,          ///< A polygon has fewer than three different vertices.
  DUPLICATE_FACE,           ///< A polygon has the same corners as another one.
  INCONSISTENT_ORIENTATION, ///< Two polygons run along an edge in the same direction.
  UNDIVIDED_FACE, ///< A polygon cannot be divided into triangles: all its diagonals are edges of others.

  // What is asked for
  WRONG_OPTION,    ///< An option is out of its range, or contradicts another option.
  WRONG_WEIGHT,    ///< A weight or importance is negative, out of its range, or not a number.
  WRONG_ANGLE_SUM, ///< A prescribed angle is not possible at its vertex.

  /// The prescribed angles do not have the sum of a polygon, or of the closed surface.
  WRONG_ANGLE_TOTAL,
  /// An edge joins two border vertices, and the prescribed border leaves no room beside it.
  FLAT_CHORD,
  WRONG_PIN,             ///< A pin has a position that is not finite, or that of another pin.
  INFEASIBLE_ANGLE_SUMS, ///< The triangles near some vertices cannot have the angles that are prescribed there.
  NO_CUT_ALLOWED,        ///< The edges that may become seams leave no way to cut.

  // The computation
  LINEAR_SYSTEM_FAILED, ///< The solver traits failed.
  NO_CONVERGENCE,       ///< The solver did not satisfy the constraints, and the layout has flipped triangles.
  COARSE_CHART_FAILED,  ///< The coarse parameterizer gave no valid map, and fallbacks are off.
  SCALE_TOO_LARGE,      ///< The map of a surface with several borders would need a range of scale above 1e10.
  FLIPPED_TRIANGLES,    ///< A triangle is not positively oriented in the plane.
  INFEASIBLE_PINS,      ///< With the pins at their positions, triangles are flipped or overlap.
  OVERLAPPING,          ///< The map overlaps itself, but should be injective.
  PRECISION_EXCEEDED,   ///< There is a valid map, but the number type of the coordinates cannot hold it.
  NOT_CERTIFIED,        ///< Exact predicates did not confirm the result.
  CANCELLED,            ///< A visitor or an exception stopped the computation.
  TIMED_OUT,            ///< The computation took longer than its time limit.

  // Atlases
  STRETCH_BOUND_MISSED, ///< Each face has a chart, but some chart is not good.
  SOMETHING_SKIPPED,    ///< Some parts have no charts; all other parts have charts.

  /// The charts of an atlas do not fit into the pages, or are not certified to be apart.
  PACKING_FAILED,
  TOO_MANY_CHARTS, ///< The charts and their gutters do not fit into the page, however small the charts are.
  CHART_TOO_LARGE, ///< A chart is larger than a page, with the given number of texels per unit.
  TOO_MANY_PAGES,  ///< The charts would take more than 10,000 pages.

  // Baking
  /// A face has texture coordinates that are not finite, or at some corners only; or no face has an area there.
  NO_TEXTURE_COORDINATES,
  OUTSIDE_SQUARE,             ///< A texture coordinate is below 0 or above 1.
  EMPTY_FINE_MESH,            ///< The fine surface has no face with an area.
  FINE_MESH_NOT_TRIANGULATED, ///< A face of the fine surface is not a triangle.
  WRONG_FINE_POINT, ///< A point of the fine surface is not finite, or too far from the simple surface.
  WRONG_NORMAL,     ///< A given normal is zero or not finite.

  // Files
  CANNOT_OPEN,         ///< The file cannot be opened.
  CANNOT_READ,         ///< Reading failed.
  CANNOT_WRITE,        ///< Writing failed, for example because the disk is full.
  TOO_FEW_LINES,       ///< The file has no third line.
  TOO_FEW_NUMBERS,     ///< A line has fewer numbers than it needs.
  NOT_A_NUMBER,        ///< A word is not a number.
  NUMBER_OUT_OF_RANGE, ///< There is no vertex, or no pair of texture coordinates, of this number.
  ODD_COUNT,           ///< The number of vertex numbers is odd.
  NO_SUCH_EDGE         ///< There is no edge between two vertices.
};

#ifndef DOXYGEN_RUNNING
namespace internal::ABF {

// The name of an enumerator with this number; "unknown" for a number that is none
template <std::size_t N>
const char* name_of(int number, const char* const (&names)[N])
{
  return number < static_cast<int>(N) ? names[number] : "unknown";
}

} // namespace internal::ABF
#endif // DOXYGEN_RUNNING

/// \ingroup PkgAngleBasedFlatteningRef
///
/// returns the name of a diagnosis, such as `"NOT_TRIANGULATED"`.
inline std::string to_string(Diagnosis diagnosis)
{
  constexpr const char* names[] = {"NOTHING_WRONG",
                                   "EMPTY_MESH",
                                   "NOT_TRIANGULATED",
                                   "NON_FINITE_POINT",
                                   "FAR_POINT",
                                   "TOO_LARGE",
                                   "NO_AREA",
                                   "NON_MANIFOLD_VERTEX",
                                   "NON_MANIFOLD_EDGE",
                                   "REPEATED_VERTEX",
                                   "SEVERAL_COMPONENTS",
                                   "NO_BORDER",
                                   "NOT_ON_BORDER",
                                   "SHORT_BORDER",
                                   "SEVERAL_BORDERS",
                                   "NONZERO_GENUS",
                                   "WRONG_TOPOLOGY",
                                   "PARALLEL_EDGES",
                                   "NON_FINITE_COORDINATE",
                                   "INCONSISTENT_COORDINATES",
                                   "DEGENERATE_CHART",
                                   "WRONG_INPUT",
                                   "DEGENERATE_FACE",
                                   "DUPLICATE_FACE",
                                   "INCONSISTENT_ORIENTATION",
                                   "UNDIVIDED_FACE",
                                   "WRONG_OPTION",
                                   "WRONG_WEIGHT",
                                   "WRONG_ANGLE_SUM",
                                   "WRONG_ANGLE_TOTAL",
                                   "FLAT_CHORD",
                                   "WRONG_PIN",
                                   "INFEASIBLE_ANGLE_SUMS",
                                   "NO_CUT_ALLOWED",
                                   "LINEAR_SYSTEM_FAILED",
                                   "NO_CONVERGENCE",
                                   "COARSE_CHART_FAILED",
                                   "SCALE_TOO_LARGE",
                                   "FLIPPED_TRIANGLES",
                                   "INFEASIBLE_PINS",
                                   "OVERLAPPING",
                                   "PRECISION_EXCEEDED",
                                   "NOT_CERTIFIED",
                                   "CANCELLED",
                                   "TIMED_OUT",
                                   "STRETCH_BOUND_MISSED",
                                   "SOMETHING_SKIPPED",
                                   "PACKING_FAILED",
                                   "TOO_MANY_CHARTS",
                                   "CHART_TOO_LARGE",
                                   "TOO_MANY_PAGES",
                                   "NO_TEXTURE_COORDINATES",
                                   "OUTSIDE_SQUARE",
                                   "EMPTY_FINE_MESH",
                                   "FINE_MESH_NOT_TRIANGULATED",
                                   "WRONG_FINE_POINT",
                                   "WRONG_NORMAL",
                                   "CANNOT_OPEN",
                                   "CANNOT_READ",
                                   "CANNOT_WRITE",
                                   "TOO_FEW_LINES",
                                   "TOO_FEW_NUMBERS",
                                   "NOT_A_NUMBER",
                                   "NUMBER_OUT_OF_RANGE",
                                   "ODD_COUNT",
                                   "NO_SUCH_EDGE"};
  static_assert(sizeof(names) / sizeof(names[0]) == static_cast<int>(Diagnosis::NO_SUCH_EDGE) + 1);
  return internal::ABF::name_of(static_cast<int>(diagnosis), names);
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// writes the name of a diagnosis, or of another enumerator that `to_string()` takes: a stage, a strategy, a layout.
template <typename Enumerator, typename = std::enable_if_t<std::is_enum<Enumerator>::value>>
auto operator<<(std::ostream& stream, Enumerator enumerator) -> decltype(stream << to_string(enumerator))
{
  return stream << to_string(enumerator);
}

template <typename Mesh, typename Report_>
struct Mesh_report;

/// \ingroup PkgAngleBasedFlatteningRef
///
/// What all reports have in common. A report converts to `true` if nothing is wrong. A `Mesh_report` does not become a
/// report without its elements of the mesh: take it as `const auto`.
struct Report
{
  /// Nothing is wrong.
  Report() = default;

  /// Something is wrong, or nothing.
  Report(Diagnosis what, const std::string& sentence) : status(what), message(sentence) {}

  /// A report of a mesh keeps its elements.
  template <typename Mesh, typename Report_>
  Report(const Mesh_report<Mesh, Report_>&) = delete;

  Diagnosis status = Diagnosis::NOTHING_WRONG; ///< What is wrong.

  /// A sentence that says what is wrong and where; empty if nothing is wrong. Vertices are named by their numbers and
  /// points: "vertex 17 (0.1, nan, 3)". Section \ref ABF_errors of the manual says how they are counted.
  std::string message;

  /// returns whether nothing is wrong.
  explicit operator bool() const { return status == Diagnosis::NOTHING_WRONG; }
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// writes the name of the diagnosis, and the message if there is one.
///
/// \relates Report
inline std::ostream& operator<<(std::ostream& stream, const Report& report)
{
  return stream << report.status << (report.message.empty() ? "" : ": ") << report.message;
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// A report with the elements of a mesh that its diagnosis is about. Those that a diagnosis is not about are empty, and
/// all are if nothing is wrong. Section \ref ABF_errors of the manual says which diagnosis names what.
///
/// \tparam Mesh a model of `FaceGraph`
/// \tparam Report_ `Report`, or what derives from it
template <typename Mesh, typename Report_ = Report>
struct Mesh_report : Report_
{
  /// Vertex type
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
  /// Edge type
  typedef typename boost::graph_traits<Mesh>::edge_descriptor edge_descriptor;
  /// Face type
  typedef typename boost::graph_traits<Mesh>::face_descriptor face_descriptor;

  std::vector<vertex_descriptor> offending_vertices; ///< The vertices that the diagnosis is about.
  std::vector<edge_descriptor> offending_edges;      ///< The edges that it is about.
  std::vector<face_descriptor> offending_faces;      ///< The faces that it is about.
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_DIAGNOSIS_H
