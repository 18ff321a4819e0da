// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_FLATTENING_MEASURES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_FLATTENING_MEASURES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// Measures of the distortion of one triangle, which `measure_flattening()` passes to a visitor.
///
/// On a triangle, the map \f$S\f$ from the plane to the surface is linear. Below, \f$S_u\f$ and \f$S_v\f$ are its
/// derivatives along the axes of the plane. Its singular values \f$\Gamma \geq \gamma\f$ are the largest and the
/// smallest factor by which it stretches lengths. The factor \f$a = \sqrt{\gamma\Gamma}\f$ applies to the square
/// roots of areas. The plane is scaled so that the whole layout has the area of the surface. The areas of flipped
/// triangles count positively.
///
/// The measures of a flipped triangle are those of its mirror image. Flips are counted separately, so they do not hide
/// how good a map is elsewhere. (Sander et al. call the stretch of a flipped triangle infinite.) If a triangle has no
/// area, in space or in the plane, every measure that is computed from derivatives has its worst value: 1 for shear,
/// principal shear and equal-stretch error, and infinity for the others. Its scale is 0. If a planar coordinate of a
/// triangle is not finite, its measures are NaN.
struct Flattening_face_measures
{
  /// Area on the surface: the weight of the triangle in all means but that of the angular distortion.
  double area = 0;

  /// Mean over the corners of \f$|\alpha - \hat\alpha|\f$, the change of the surface's own angle \f$\hat\alpha\f$, in
  /// radians.
  double mean_angle_change = 0;

  /// Root of the mean over the corners of \f$(\alpha - \hat\alpha)^2\f$, in radians.
  double rms_angle_change = 0;

  /// \f$1/\sqrt{\gamma\Gamma}\f$, the factor from lengths on the surface to lengths in the plane.
  double scale = 0;

  /// Mean over the corners of \f$(\alpha/\beta - 1)^2\f$; see `Flattening_measures::angular_distortion`.
  double angular_distortion = 0;

  /// \f$L_2\f$ stretch \f$\sqrt{(\Gamma^2 + \gamma^2)/2}\f$ \cgalCite{cgal:ssgh-tmpm-01}.
  double l2_stretch = 0;

  /// \f$L_\infty\f$ stretch \f$\Gamma\f$ \cgalCite{cgal:ssgh-tmpm-01}.
  double linf_stretch = 0;

  /// Cosine \f$|S_u \cdot S_v| / (|S_u| |S_v|)\f$ between the images of the axes, in [0, 1].
  double shear = 0;

  /// Largest shear of any two orthogonal axes, \f$(\Gamma^2 - \gamma^2)/(\Gamma^2 + \gamma^2)\f$, in [0, 1].
  double principal_shear = 0;

  /// \f$||S_u|^2 - |S_v|^2| / (|S_u|^2 + |S_v|^2)\f$, in [0, 1].
  double equal_stretch_error = 0;

  /// \f$\Gamma/\gamma\f$, at least 1.
  double quasi_conformal_ratio = 0;

  /// \f$|\ln(\gamma\Gamma)|\f$: 0 for a triangle that keeps its area. Enlarging and shrinking by the same factor give
  /// the same value.
  double area_distortion = 0;

  /// \f$\Gamma^2 + \gamma^2 + \Gamma^{-2} + \gamma^{-2}\f$ \cgalCite{cgal:ss-bpfb-15}, at least 4.
  double symmetric_dirichlet_energy = 0;

  /// Smallest planar angle, in radians.
  double smallest_angle = 0;

  /// Whether the triangle is not positively oriented in the plane (exact).
  bool flipped = false;
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// Measures of the distortion of a flattening: means over its triangles, weighted by their areas \f$A_t\f$ on the
/// surface, and extremes. `Flattening_face_measures` explains the measures of a triangle. Triangles without area on
/// the surface count only for the angles and the flips, unless there are no others.
///
/// The map is injective if and only if no triangle is flipped and the border is simple.
///
/// All measures are invariant under scaling, translation, and rotation of the plane, except `l2_shear` and
/// `l2_equal_stretch_error`, which depend on the direction of the axes.
struct Flattening_measures
{
  /// Mean of \f$|\alpha - \hat\alpha|\f$, the change of the surface's own angles, in radians. 0 at best.
  double mean_angle_change = 0;

  /// The root of the mean square of the same change, in radians. 0 at best.
  double rms_angle_change = 0;

  /// As `mean_angle_change`, but every corner counts alike, independent of the area of its triangle.
  double mean_corner_angle_change = 0;

  /// As `rms_angle_change`, but every corner counts alike, independent of the area of its triangle.
  double rms_corner_angle_change = 0;

  /// Mean over all corners of \f$(\alpha/\beta - 1)^2\f$ with planar angles \f$\alpha\f$ and target angles
  /// \f$\beta\f$: the energy of Equation 1 of \cgalCite{cgal:slmb-abf-05} divided by \f$3 n_f\f$, which ABF++
  /// minimizes. The target angles are those of the surface, scaled to sum to \f$2\pi\f$ at interior vertices, and at
  /// least 0.001 away from 0 and \f$\pi\f$. If the surface's own angles do not sum to \f$2\pi\f$, this measure says
  /// nothing about how much they change.
  double angular_distortion = 0;

  /// \f$L_2\f$ stretch \f$\sqrt{\sum A_t (\Gamma_t^2 + \gamma_t^2)/2 / \sum A_t}\f$
  /// \cgalCite{cgal:ssgh-tmpm-01}; 1 at best, infinite if a triangle has no area in the plane.
  double l2_stretch = 0;

  /// \f$L_\infty\f$ stretch \f$\max \Gamma_t\f$ \cgalCite{cgal:ssgh-tmpm-01}; 1 at best, infinite if a triangle
  /// has no area in the plane.
  double linf_stretch = 0;

  /// \f$L_2\f$ shear, the root of the mean square of the shear, Equation 24 of \cgalCite{cgal:slmb-abf-05};
  /// 0 at best, 1 at worst.
  double l2_shear = 0;

  /// The root of the mean square of the principal shear: as `l2_shear`, but with the worst axes of each triangle. It
  /// does not depend on the direction of the layout. 0 at best, 1 at worst.
  double l2_principal_shear = 0;

  /// The root of the mean square of the equal-stretch error, the second component of conformality in Section 6 of
  /// \cgalCite{cgal:slmb-abf-05}. The paper refers to a thesis for its formula. The formula here has the form and the
  /// range of the shear. 0 at best, 1 at worst.
  double l2_equal_stretch_error = 0;

  /// Mean of \f$\Gamma_t/\gamma_t\f$; 1 at best.
  double mean_quasi_conformal_ratio = 0;

  /// The least number that \f$\Gamma_t/\gamma_t\f$ does not exceed on 95 percent of the area; 1 at best.
  double quasi_conformal_ratio_95 = 0;

  /// Least \f$1/\sqrt{\gamma_t\Gamma_t}\f$; 1 at best.
  double min_scale = 0;

  /// Largest \f$1/\sqrt{\gamma_t\Gamma_t}\f$; 1 at best.
  double max_scale = 0;

  /// Largest \f$\Gamma_t/\gamma_t\f$; 1 at best.
  double max_quasi_conformal_ratio = 0;

  /// The root of the mean square of \f$\ln(\gamma_t\Gamma_t)\f$; 0 at best.
  double l2_area_distortion = 0;

  /// Mean of the symmetric Dirichlet energy \cgalCite{cgal:ss-bpfb-15}, per area, of a layout as large as the
  /// surface. 4 at best, infinite if a triangle has no area in the plane.
  double symmetric_dirichlet_energy = 0;

  /// Number of triangles that are not positively oriented in the plane (exact, for the coordinates as doubles).
  int flipped_triangles = 0;

  /// Whether the borders in the plane are those of a polygon with holes (exact, for the coordinates as doubles). No two
  /// border edges have a point in common, except a vertex of both. The holes are within the outer border, not within
  /// one another, and turn the other way. If no triangle is flipped, the map is injective if and only if this holds;
  /// see `is_injective()`.
  ///
  /// `crossing_border_edges()` lists the edges that have a point in common. If there are none, and no triangle is
  /// flipped, this can be `false` only if the map is not locally injective; see `is_locally_injective()`. It is `false`
  /// if a coordinate of a border vertex is not a finite number.
  bool border_is_simple = false;

  /// Smallest angle of a planar triangle, in radians.
  double smallest_angle = 0;
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// What `measure_flattening()` returns: the measures, or what is wrong with the mesh.
///
/// \tparam TriangleMesh a model of `FaceGraph`
template <typename TriangleMesh>
struct Flattening_measures_report : Mesh_report<TriangleMesh>, Flattening_measures
{};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_FLATTENING_MEASURES_H
