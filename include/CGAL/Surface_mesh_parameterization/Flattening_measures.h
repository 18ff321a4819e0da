// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_FLATTENING_MEASURES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_FLATTENING_MEASURES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// Measures of the distortion of one triangle, as `measure_flattening()` gives them to a visitor.
///
/// On a triangle, the map \f$S\f$ from the plane to the surface is linear. Below, \f$S_u\f$ and \f$S_v\f$ are its
/// derivatives along the axes of the plane, \f$\Gamma \geq \gamma\f$ are its singular values, the largest and the
/// smallest factor by which it stretches lengths, and \f$a = \sqrt{\gamma\Gamma}\f$ is that of areas' square roots;
/// the plane is scaled such that the whole layout has the area of the surface, areas of flipped triangles counted
/// positively.
///
/// The measures of a flipped triangle are those of its mirror image: flips are counted apart, and do not hide how good
/// a map is elsewhere. (Sander et al. call the stretch of a flipped triangle infinite.) A triangle without area, in
/// space or in the plane, has the worst value of every measure that is made from derivatives: 1 of shear, principal
/// shear and equal-stretch error, else infinity. One with a coordinate in the plane that is not a finite number has measures
/// that are not a number.
struct Flattening_face_measures
{
  /// Area on the surface: the weight of the triangle in all means but that of the angular distortion.
  double area = 0;

  /// Mean over the corners of \f$|\alpha - \hat\alpha|\f$, by how much the surface's own angle
  /// \f$\hat\alpha\f$ changes, in radians.
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

  /// Shear of those axes whose shear is largest, \f$(\Gamma^2 - \gamma^2)/(\Gamma^2 + \gamma^2)\f$, in [0, 1].
  double principal_shear = 0;

  /// \f$||S_u|^2 - |S_v|^2| / (|S_u|^2 + |S_v|^2)\f$, in [0, 1].
  double equal_stretch_error = 0;

  /// \f$\Gamma/\gamma\f$, at least 1.
  double quasi_conformal_ratio = 0;

  /// \f$|\ln(\gamma\Gamma)|\f$: 0 for a triangle that keeps its area, the same for one that is enlarged as for one
  /// that is shrunk by the same factor.
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
/// surface, and extremes. The measures of a triangle are explained with `Flattening_face_measures`. Triangles
/// without area on the surface count for the angles and the flips only, unless there are no others.
///
/// Whether the map is injective follows from two of them for a disk: it is if no triangle is flipped and the border is
/// simple. See `border_is_simple` for other surfaces.
///
/// All of them are invariant under scaling, translation, and rotation of the plane, but for `l2_shear` and
/// `l2_equal_stretch_error`, which depend on the direction of the axes.
struct Flattening_measures
{
  /// Mean of \f$|\alpha - \hat\alpha|\f$, the change of the surface's own angles, in radians. 0 at best.
  double mean_angle_change = 0;

  /// The root of the mean square of the same change, in radians. 0 at best.
  double rms_angle_change = 0;

  /// As `mean_angle_change`, but every corner counts alike, whatever the area of its triangle.
  double mean_corner_angle_change = 0;

  /// As `rms_angle_change`, but every corner counts alike, whatever the area of its triangle.
  double rms_corner_angle_change = 0;

  /// Mean over all corners of \f$(\alpha/\beta - 1)^2\f$ with planar angles \f$\alpha\f$ and target angles
  /// \f$\beta\f$: the energy of Equation 1 of \cgalCite{cgal:slmb-abf-05} divided by \f$3 n_f\f$, which ABF++ minimizes. It
  /// says nothing of how much the surface's own angles change where these do not sum to \f$2\pi\f$: the target angles are those of the surface, scaled to sum to \f$2\pi\f$ at interior vertices, and at least 0.001 away from
  /// 0 and \f$\pi\f$.
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

  /// The root of the mean square of the principal shear: as `l2_shear`, but each triangle with the axes that
  /// are worst for it, so that the direction of the layout does not matter. 0 at best, 1 at worst.
  double l2_principal_shear = 0;

  /// The root of the mean square of the equal-stretch error: the second component of conformality in Section 6 of
  /// \cgalCite{cgal:slmb-abf-05}, which leaves its formula to a thesis; this is one with the form and the range of
  /// the shear. 0 at best, 1 at worst.
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

  /// Mean of the symmetric Dirichlet energy \cgalCite{cgal:ss-bpfb-15}: the energy of a layout as large as the surface,
  /// per area. 4 at best, infinite if a triangle has no area in the plane.
  double symmetric_dirichlet_energy = 0;

  /// Number of triangles that are not positively oriented in the plane (exact, for the coordinates as doubles).
  int flipped_triangles = 0;

  /// Whether the borders are simple polygons in the plane that do not touch one another: no two border edges have a
  /// point in common, other than a vertex of both (exact, for the coordinates as doubles). A map that is locally
  /// injective, as `is_locally_injective()` tells, is injective as a whole exactly if this holds: no two triangles
  /// overlap. `crossing_border_edges()` lists the edges where it does not. Edges with a coordinate that is not a finite
  /// number are left out; their triangles are flipped.
  bool border_is_simple = false;

  /// Smallest angle of a planar triangle, in radians.
  double smallest_angle = 0;
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_FLATTENING_MEASURES_H
