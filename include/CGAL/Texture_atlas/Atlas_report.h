// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_ATLAS_REPORT_H
#define CGAL_TEXTURE_ATLAS_ATLAS_REPORT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_measures.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <string>
#include <vector>

/// \file Atlas_report.h

namespace CGAL {

namespace Texture_atlas {

/// \ingroup PkgTextureAtlasRef
///
/// The report of `pack_charts()`.
struct Packing_report : Report
{
  using Report::Report;

  std::size_t number_of_faces = 0;  ///< The number of faces that have a chart.
  std::size_t number_of_charts = 0; ///< The number of charts that have a face.

  /// The page of each chart, from 0 on. The charts are in the order of their numbers.
  std::vector<int> page_of_chart;
  std::size_t number_of_pages = 0; ///< The number of pages.

  /// The scale of each chart, relative to that of all. It is less than 1 for charts with less than 0.1 % of the area
  /// that would be less than a texel (or block) wide, and longer than 2 % of the page. With their gutters, they would
  /// make all others smaller.
  std::vector<double> scale_of_chart;

  /// The sum of the areas of all triangles, as a share of all pages. Overlaps within a chart count several times.
  double covered_share = 0;

  /// The number of texels per unit of length on the surface, where the weight is 1 and the map is isometric.
  double texels_per_length = 0;

  /// The number of charts that were tried in all directions, not only in four.
  std::size_t number_of_turned_charts = 0;

  /// The number of charts that were not tried in rows of texels where the previous chart of about the same size did not
  /// fit.
  std::size_t number_of_small_charts = 0;

  /// The number of charts that were enlarged to a sixteenth of a texel, or of a block, or to four steps of the grid of
  /// `Packing_options::quantization_bits`, so that they do not vanish when coordinates are rounded.
  std::size_t number_of_enlarged_charts = 0;

  std::size_t number_of_attempts = 0; ///< The number of scales that were tried.

  /// The faces with a corner that found no place on the grid of `Packing_options::quantization_bits`, and keeps its
  /// coordinates: positions, from 0, in the sequence of faces of the mesh.
  std::vector<std::size_t> faces_off_grid;
};

/// \ingroup PkgTextureAtlasRef
///
/// The report of `make_atlas()` and `make_common_atlas()`. `Mesh_atlas_report` adds elements of a mesh.
///
/// If some parts have charts and others have not, the status is `Diagnosis::SOMETHING_SKIPPED`. If no part has charts,
/// it is the diagnosis of the first part. The message is about the first part in both cases.
struct Atlas_report : Report
{
  using Report::Report;

  /// How the map of a chart was made.
  enum Method
  {
    ABF_PLUS_PLUS, ///< By ABF++, or flat as it is, with holes; the map does not overlap itself.
    HIERARCHICAL, ///< By hierarchical ABF++, for more than 20,000 triangles; the map does not overlap itself.
    INJECTIVE, ///< As an injective map: the map of ABF++ overlaps itself, perhaps only after rounding, or is less isometric.
    SEPARATED, ///< As a piece of a map of ABF++ that overlaps itself, as by `split_overlaps()`.
    GIVEN      ///< It was there already (`Atlas_options::given_charts`).
  };

  /// What a good chart (`Chart::is_good`) needed.
  enum Strategy
  {
    USUAL,              ///< Nothing else than the given options.
    LARGER_AREA_WEIGHT, ///< A map that is as isometric as possible.
    MORE_CHARTS ///< A division of the part, which had no good chart, or one that would leave most of the square empty.
  };

  /// Whether both sides of the seams within a chart have equal lengths in the plane
  /// (`Atlas_options::equal_seam_lengths`), and if not, why.
  enum Seam_lengths
  {
    NO_SEAMS,      ///< No seam has both sides in the chart.
    EQUAL_LENGTHS, ///< Both sides have equal lengths.
    NOT_WANTED,    ///< `Atlas_options::equal_seam_lengths` is `false`.
    OTHER_METHOD,  ///< The map, or the map that it is a piece of, is hierarchical, injective or given.
    NOT_TRIED, ///< The part has more than 32 handles and borders, and its map with free lengths overlaps itself.
    NO_EQUATIONS,       ///< There are no equations for the lengths of such seams.
    NOT_CONVERGED,      ///< The solver did not reach equal lengths.
    TOO_MUCH_DISTORTION ///< Equal lengths around handles or between borders raise the energy by more than 10 %.
  };

  /// A chart of the atlas.
  struct Chart
  {
    std::size_t part = 0; ///< The number of the part of the surface that contains the chart.
    int page = 0;         ///< The page, from 0 on; 0 if nothing was packed.
    double scale = 1;     ///< The scale relative to that of all; see `Packing_report::scale_of_chart`.
    std::size_t number_of_faces = 0; ///< The number of faces.
    Method method = ABF_PLUS_PLUS;   ///< How the map was made.

    /// Whether ABF++ was not tried, because its map of a coarse copy of the chart overlaps itself. Copies are made only
    /// of charts with at least 2400 vertices and at most 20,000 triangles.
    bool overlap_is_predicted = false;
    Strategy strategy = USUAL; ///< What the map needed.
    double area = 0;           ///< The area on the surface.
    double border_length = 0;  ///< The length of the border on the surface.

    /// The stretch that is due to scale: \f$\sqrt{\sum A^2/A' \; \sum A'}/\sum A\f$, with areas \f$A\f$ on the surface
    /// and \f$A'\f$ in the plane. 1 is perfect. Seams are added to keep it near
    /// `Seam_options::stretch_bound`.
    double scale_stretch = 1;
    bool bound_reached = true; ///< Whether `scale_stretch` is at most 1.03 times the bound.
    double l2_stretch = 1;     ///< See `Flattening_measures::l2_stretch`.

    /// The number of faces with a quasi-conformal ratio above 1000 that are not that thin on the surface.
    std::size_t crushed_faces = 0;

    /// The share of the area in faces with a quasi-conformal ratio above 5, without those that are too thin on the
    /// surface.
    double skewed_share = 0;

    /// Whether `l2_stretch` is at most 2, or `Seam_options::stretch_bound` if larger, no face is crushed, and
    /// `skewed_share` is at most 0.01. With an infinite bound, every chart is good.
    bool is_good = true;
    double contact = 0; ///< See `Flattening_report::contact`.
    int rounds = 0;     ///< How often seams were added because the map stretched too much.

    bool has_equal_seams = false;         ///< Whether `seam_lengths` is `EQUAL_LENGTHS`.
    Seam_lengths seam_lengths = NO_SEAMS; ///< Whether seams have equal lengths, and if not, why.

    /// Largest difference between the logarithms of the lengths of both sides of a seam edge within the chart.
    double largest_seam_jump = 0;

    /// The number of the mesh that contains the chart, among those of `make_common_atlas()`.
    std::size_t mesh = 0;
  };

  /// A part of the surface that has no charts.
  struct Skipped
  {
    std::size_t part = 0;       ///< The number of the part.
    std::size_t first_face = 0; ///< Its first face: a position, from 0, in the sequence of faces of the mesh.
    std::size_t number_of_faces = 0;             ///< The number of faces.
    Diagnosis status = Diagnosis::NOTHING_WRONG; ///< What is wrong.
    std::string message;                         ///< A sentence that says what is wrong, and where.
    std::size_t mesh = 0; ///< The number of the mesh that contains it, among those of `make_common_atlas()`.

    /// The vertices that are wrong, such as those with a coordinate that is not finite: positions, from 0, in the
    /// sequence of vertices of the mesh. Empty if the part is wrong as a whole.
    std::vector<std::size_t> vertices;
  };

  /// Wall clock time of each stage, in seconds.
  struct Seconds
  {
    double read = 0;    ///< Copying the mesh into arrays, and checking it.
    double charts = 0;  ///< Finding seams, and flattening.
    double pack = 0;    ///< Placing the charts in the square.
    double certify = 0; ///< Exact checks of the final coordinates.
    double measure = 0; ///< Measuring distortion.
    double write = 0;   ///< Writing the caller's property maps.

    /// returns the sum of the stages.
    double total() const { return read + charts + pack + certify + measure + write; }
  };

  std::vector<Chart> charts;    ///< The charts, by their numbers.
  std::vector<Skipped> skipped; ///< The parts without charts.

  /// The number of parts: connected pieces of the surface between given seams, numbered by their first faces.
  std::size_t number_of_parts = 0;
  std::size_t number_of_terminals = 0; ///< The number of terminals (`Seam_options`).

  /// The number of faces without area, which change no chart: each lies on an edge of a neighbor (see `make_atlas()`).
  std::size_t degenerate_triangles = 0;

  /// The number of polygons that were made convex in the plane by moving vertices (see `make_atlas()`).
  std::size_t number_of_mended_polygons = 0;

  double seam_length = 0; ///< The length of all seams, each counted once.

  /// `seam_length`, divided by the square root of the area that has charts.
  double relative_seam_length = 0;

  /// The largest `Chart::largest_seam_jump` of the charts with equal seams; 0 without such charts.
  double largest_equal_seam_jump = 0;

  /// Distortion of all charts together, each scaled to its area on the surface.
  /// `Flattening_measures::border_is_simple` says whether all charts are injective.
  Flattening_measures measures;

  /// See `Packing_report::faces_off_grid`. Faces of several meshes are counted through.
  std::vector<std::size_t> faces_off_grid;

  std::size_t number_of_pages = 0; ///< The number of pages; 0 if nothing was packed.
  double covered_share = 0;        ///< See `Packing_report::covered_share`; 0 if nothing was packed.

  /// The mean factor from lengths on the surface to lengths in the plane, along \f$u\f$.
  double scale = 1;

  /// The harmonic mean of the density of texels over the surface: `covered_share` divided by the square of the
  /// \f$L_2\f$ stretch. 1 is an isometric map that fills all pages. 0 if nothing was packed.
  double texel_density = 0;

  /// The density that 95 % of the surface have at least, each face in the direction in which it has the fewest texels.
  /// 0 if nothing was packed.
  double low_texel_density = 0;

  Seconds seconds; ///< Time of each stage.

  /// returns whether there is an atlas, of the whole surface or of some parts.
  bool has_atlas() const
  {
    return status == Diagnosis::NOTHING_WRONG || status == Diagnosis::STRETCH_BOUND_MISSED ||
           status == Diagnosis::SOMETHING_SKIPPED;
  }
};

/// \ingroup PkgTextureAtlasRef
///
/// returns the name of a method, such as `"injective"`.
///
/// \relates Atlas_report
inline std::string to_string(Atlas_report::Method method)
{
  constexpr const char* names[] = {"ABF++", "hierarchical ABF++", "injective", "separated", "given"};
  return Surface_mesh_parameterization::internal::ABF::name_of(method, names);
}

/// \ingroup PkgTextureAtlasRef
///
/// returns a name, such as `"MORE_CHARTS"`.
///
/// \relates Atlas_report
inline std::string to_string(Atlas_report::Strategy strategy)
{
  constexpr const char* names[] = {"USUAL", "LARGER_AREA_WEIGHT", "MORE_CHARTS"};
  return Surface_mesh_parameterization::internal::ABF::name_of(strategy, names);
}

/// \ingroup PkgTextureAtlasRef
///
/// returns a name, such as `"TOO_MUCH_DISTORTION"`.
///
/// \relates Atlas_report
inline std::string to_string(Atlas_report::Seam_lengths lengths)
{
  constexpr const char* names[] = {"NO_SEAMS",  "EQUAL_LENGTHS", "NOT_WANTED",    "OTHER_METHOD",
                                   "NOT_TRIED", "NO_EQUATIONS",  "NOT_CONVERGED", "TOO_MUCH_DISTORTION"};
  return Surface_mesh_parameterization::internal::ABF::name_of(lengths, names);
}

/// \ingroup PkgTextureAtlasRef
///
/// The report of `make_atlas()` and `make_common_atlas()` of meshes, with elements of the meshes.
///
/// Of one mesh, `Mesh_report::offending_faces` has the first face of each part without charts, and
/// `Mesh_report::offending_vertices` all its wrong vertices. Of several meshes, these are empty.
///
/// \code{.cpp}
/// for(std::size_t i = 0; i < report.skipped.size(); ++i)
///   for(auto v : report.skipped_elements[i].vertices)
///     std::cerr << v << ": " << report.skipped[i].message << "\n";
/// \endcode
///
/// \tparam TriangleMesh a model of `FaceGraph`
template <typename TriangleMesh>
struct Mesh_atlas_report : Mesh_report<TriangleMesh, Atlas_report>
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor; ///< Vertex type
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;     ///< Face type

  /// Elements of the mesh `Atlas_report::Skipped::mesh`
  struct Part_elements
  {
    std::vector<face_descriptor> faces;      ///< The faces of the part, in the order of the mesh.
    std::vector<vertex_descriptor> vertices; ///< Those of `Atlas_report::Skipped::vertices`.
  };

  std::vector<Part_elements> skipped_elements; ///< The elements of each part in `Atlas_report::skipped`.
};

} // namespace Texture_atlas

} // namespace CGAL

#endif // CGAL_TEXTURE_ATLAS_ATLAS_REPORT_H
