// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_ATLAS_REPORT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_ATLAS_REPORT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_measures.h>

#include <cstddef>
#include <string>
#include <vector>

/// \file Atlas_report.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// What `make_atlas()` reports.
struct Atlas_report : Report
{
  /// How the map of a chart was made.
  enum Method
  {
    ABF_PLUS_PLUS, ///< By ABF++, whose map does not overlap itself.
    HIERARCHICAL, ///< By hierarchical ABF++, whose map does not overlap itself. Charts of more than 20,000 triangles begin with it.
    INJECTIVE, ///< As injective map (`Flattening_options::injective`), as that of ABF++ overlaps itself, or has too few digits.
    SEPARATED  ///< A piece of a map of ABF++ that overlapped itself, cut out as `split_overlaps()` does.
  };

  /// What it took to make a chart that is good (`Chart::is_good`).
  enum Strategy
  {
    USUAL,              ///< The options as they are.
    LARGER_AREA_WEIGHT, ///< As there was no good map, one that is as isometric as possible.
    MORE_CHARTS ///< The part was divided, as there was no good map of it in one piece, or it would have left most of the square empty.
  };

  /// Whether both sides of the seams within a chart have equal lengths in the plane
  /// (`Atlas_options::equal_seam_lengths`), and if not why.
  enum Seam_lengths
  {
    NO_SEAMS,      ///< No seam has both sides in the chart.
    EQUAL_LENGTHS, ///< Both sides have equal lengths. The map is that of ABF++, or a piece of it.
    NOT_WANTED,    ///< `Atlas_options::equal_seam_lengths` is `false`.
    OTHER_METHOD, ///< The map, or that of which it is a piece, is hierarchical or injective. These do not keep lengths of seams.
    NOT_TRIED, ///< The part has more than 32 handles and borders, and its map without equal lengths overlaps itself. The chart is a piece of that.
    NO_EQUATIONS,  ///< The seams are such that there are no equations for their lengths.
    NOT_CONVERGED, ///< The solver does not reach equal lengths. The map was made without them.
    TOO_MUCH_DISTORTION ///< Around handles or between borders, equal lengths take more than 1.1 times the energy. The map was made
    ///< without them.
  };

  /// A chart of the atlas.
  struct Chart
  {
    std::size_t part = 0;            ///< The part of the surface that it is of.
    std::size_t number_of_faces = 0; ///< The number of its faces.
    Method method = ABF_PLUS_PLUS;   ///< How its map was made.
    Strategy strategy = USUAL;       ///< What it took.
    double area = 0;                 ///< Its area on the surface.
    double border_length = 0;        ///< The length of its border on the surface.

    /// \f$\sqrt{\sum A^2/A' \; \sum A'}/\sum A\f$, with areas \f$A\f$ on the surface and \f$A'\f$ in the plane: the stretch that is due
    /// to scale. 1 at best. Seams are added until it is at most 3 % above `Seam_options::stretch_bound`.
    double scale_stretch = 1;
    bool bound_reached = true; ///< Whether `scale_stretch` is at most that.
    double l2_stretch = 1;     ///< As `Flattening_measures::l2_stretch`.

    /// The number of faces whose quasi-conformal ratio is above 1000, although that of the map from an equilateral triangle to them is not.
    std::size_t crushed_faces = 0;

    /// Whether `l2_stretch` is at most 2, or at most `Seam_options::stretch_bound` if that is larger, and no face is
    /// crushed. With an infinite bound, every chart is good.
    bool is_good = true;
    double contact = 0; ///< As `Flattening_report::contact`.
    int rounds = 0;     ///< How often seams were added because the map stretched too much.

    bool has_equal_seams = false;         ///< Whether `seam_lengths` is `EQUAL_LENGTHS`.
    Seam_lengths seam_lengths = NO_SEAMS; ///< Whether both sides of seams have equal lengths, and if not why.

    /// Largest difference between the logarithms of the lengths of both sides of an edge on a seam, with the final coordinates of any
    /// map. Seams to other charts do not count: each chart has its own scale, up to a constant.
    double largest_seam_jump = 0;
  };

  /// A part of the surface that has no charts.
  struct Skipped
  {
    std::size_t part = 0;            ///< Its number.
    std::size_t first_face = 0;      ///< Its first face, by its rank in the order of the faces of the mesh.
    std::size_t number_of_faces = 0; ///< The number of its faces.
    Diagnosis status = Diagnosis::NOTHING_WRONG; ///< Why.
    std::string message;                         ///< A sentence that says what is wrong and where.
  };

  /// Wall clock time of each stage, in seconds.
  struct Seconds
  {
    double read = 0;    ///< Copying the mesh into arrays, and checking it.
    double charts = 0;  ///< Seams and maps of all charts.
    double pack = 0;    ///< Placing the charts in the square.
    double certify = 0; ///< Exact checks of the final coordinates.
    double measure = 0; ///< Measuring distortion.
    double write = 0;   ///< Writing the caller's property maps.

    /// returns the sum of the stages.
    double total() const { return read + charts + pack + certify + measure + write; }
  };

  std::vector<Chart> charts;    ///< In the order of their numbers.
  std::vector<Skipped> skipped; ///< The parts without charts.

  /// The connected parts of the surface without the seams that were given, in the order of their first faces.
  std::size_t number_of_parts = 0;
  std::size_t number_of_terminals = 0; ///< The vertices that were joined to seams because of their scale.

  /// The polygons that vertices were moved for (see `make_atlas()`), and that are convex in the plane since then.
  std::size_t number_of_mended_polygons = 0;

  double seam_length = 0; ///< The length of all seams, each counted once.
  double relative_seam_length =
      0; ///< `seam_length` divided by the square root of the area of the surface that has charts.

  /// Largest `Chart::largest_seam_jump` of the charts with equal seams; 0 without such charts. It is about as small as the angles are exact,
  /// and the digits of coordinates allow.
  double largest_equal_seam_jump = 0;

  /// Distortion of all charts together, with each at the size of its area on the surface. `border_is_simple` says whether all charts are injective.
  Flattening_measures measures;

  double covered_share =
      0; ///< The share of the unit square that is covered, as `Packing_report::covered_share`; 0 if nothing was packed.
  double scale =
      1; ///< The factor from lengths on the surface to those in the plane, in the mean over each chart.

  Seconds seconds; ///< Time of each stage.

  /// returns whether there is an atlas, of the whole surface or of a part.
  bool has_atlas() const
  {
    return status == Diagnosis::NOTHING_WRONG || status == Diagnosis::STRETCH_BOUND_MISSED ||
           status == Diagnosis::SOMETHING_SKIPPED;
  }
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// returns the name of a method, such as `"injective"`.
///
/// \relates Atlas_report
inline std::string to_string(Atlas_report::Method method)
{
  switch(method) {
  case Atlas_report::ABF_PLUS_PLUS:
    return "ABF++";
  case Atlas_report::HIERARCHICAL:
    return "hierarchical ABF++";
  case Atlas_report::INJECTIVE:
    return "injective";
  case Atlas_report::SEPARATED:
    return "separated";
  }
  return "unknown";
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// returns a name, such as `"MORE_CHARTS"`.
///
/// \relates Atlas_report
inline std::string to_string(Atlas_report::Strategy strategy)
{
  switch(strategy) {
  case Atlas_report::USUAL:
    return "USUAL";
  case Atlas_report::LARGER_AREA_WEIGHT:
    return "LARGER_AREA_WEIGHT";
  case Atlas_report::MORE_CHARTS:
    return "MORE_CHARTS";
  }
  return "unknown";
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// returns a name, such as `"EQUAL_LENGTHS"`.
///
/// \relates Atlas_report
inline std::string to_string(Atlas_report::Seam_lengths lengths)
{
  switch(lengths) {
  case Atlas_report::NO_SEAMS:
    return "NO_SEAMS";
  case Atlas_report::EQUAL_LENGTHS:
    return "EQUAL_LENGTHS";
  case Atlas_report::NOT_WANTED:
    return "NOT_WANTED";
  case Atlas_report::OTHER_METHOD:
    return "OTHER_METHOD";
  case Atlas_report::NOT_TRIED:
    return "NOT_TRIED";
  case Atlas_report::NO_EQUATIONS:
    return "NO_EQUATIONS";
  case Atlas_report::NOT_CONVERGED:
    return "NOT_CONVERGED";
  case Atlas_report::TOO_MUCH_DISTORTION:
    return "TOO_MUCH_DISTORTION";
  }
  return "unknown";
}

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_ATLAS_REPORT_H
