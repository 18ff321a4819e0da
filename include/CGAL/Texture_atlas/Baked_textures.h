// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_BAKED_TEXTURES_H
#define CGAL_TEXTURE_ATLAS_BAKED_TEXTURES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

/// \file Baked_textures.h

namespace CGAL {

namespace Texture_atlas {

/// \ingroup PkgTextureAtlasRef
///
/// The options of `bake_surface()`.
struct Baking_options
{
  int resolution = 1024; ///< Texels along the horizontal sides of the texture, from 1 to 16384.

  /// Texels along the vertical sides, from 1 to 16384; by default, the same as `resolution`.
  std::optional<int> height;

  /// Number of texels around charts that are filled, from 0 to 1024. It should be at most `Packing_options::gutter`;
  /// between charts that are closer than two gutters, each texel belongs to the nearest chart.
  int gutter = 2;

  /// Length of rays to each side of the simple surface, in units of the surface; finite and above 0. If unset, the
  /// length is a twentieth of the diagonal of the bounding box of the simple surface.
  std::optional<double> ray_length;

  /// Whether normals are in the coordinates of the surface, instead of in tangent space.
  bool normals_in_object_space = false;

  int threads = 0; ///< As `Flattening_options::threads`.

  /// The number of texels along the vertical sides: `height`, or its default.
  int number_of_rows() const { return height.value_or(resolution); }
};

/// \ingroup PkgTextureAtlasRef
///
/// The report of `bake_surface()`.
struct Baking_report : Report
{
  using Report::Report;

  /// The number of texels that a chart touches. Each got its values from the fine surface.
  std::size_t number_of_chart_texels = 0;

  /// The number of texels around the charts, which got the values of the nearest texel of a chart.
  std::size_t number_of_gutter_texels = 0;

  /// The number of texels of charts whose ray met only faces of the fine surface with a normal against the ray. The
  /// normal was reversed.
  std::size_t number_of_back_faces = 0;

  /// The number of texels of charts whose ray met nothing. They got the values of the closest point of the fine
  /// surface.
  std::size_t number_of_missed_rays = 0;

  double ray_length = 0; ///< The length of rays to each side, in units of the surface.

  /// The largest distance between a point of the simple surface and its point of the fine surface, in units of the
  /// surface.
  double largest_distance = 0;

  double mean_distance = 0; ///< The mean of these distances.

  /// returns the number of texels of charts whose ray met a face with a normal along the ray.
  std::size_t number_of_front_faces() const
  {
    return number_of_chart_texels - number_of_back_faces - number_of_missed_rays;
  }
};

/// \ingroup PkgTextureAtlasRef
///
/// The directions at a corner of a face that normals in tangent space refer to, as in glTF: the attributes `NORMAL` and
/// `TANGENT`. A viewer needs these attributes to show a normal map exactly.
struct Tangent_frame
{
  std::array<double, 3> normal;  ///< The normal of the vertex, of length 1.
  std::array<double, 3> tangent; ///< The direction of growing u, orthogonal to the normal, of length 1.

  /// 1, or -1 if the chart is mirrored. The bitangent, the direction of growing v, is the cross product of normal and
  /// tangent times this sign.
  double sign = 1;
};

/// \ingroup PkgTextureAtlasRef
///
/// The images that `bake_surface()` makes. They are stored row by row, as in picture files: the first row is that at
/// \f$v = 1\f$, the last that at \f$v = 0\f$, and \f$u\f$ grows along each row. Row \f$i\f$ and column \f$j\f$ of a
/// texture of \f$m\f$ rows and \f$n\f$ columns have their centre at \f$u = (j + 1/2) / n\f$ and
/// \f$v = 1 - (i + 1/2) / m\f$.
struct Baked_textures : Baking_report
{
  using Baking_report::Baking_report;

  /// Where the values of a texel come from.
  enum Texel : std::uint8_t
  {
    /// The texel is in no chart and no gutter. Its normal is (0, 0, 1), its displacement is 0, and its colour is black.
    EMPTY,
    GUTTER,     ///< The values are those of the nearest texel of a chart.
    FRONT_FACE, ///< The ray met a face of the fine surface with a normal along the ray.

    /// The ray met only faces with a normal against the ray. The normal of the nearest one was reversed.
    BACK_FACE,
    CLOSEST_POINT ///< The ray met nothing. The values are those of the closest point.
  };

  int resolution = 0; ///< The number of columns of texels.
  int height = 0;     ///< The number of rows of texels.

  std::vector<std::uint8_t> texels; ///< For each texel, its `Texel`.
  std::vector<float> normals;       ///< For each texel, x, y and z of a vector of length 1.

  /// For each texel, the distance from the simple to the fine surface along the interpolated normal of the simple
  /// surface, in units of the surface. It is negative where the fine surface is inside.
  std::vector<float> displacements;

  std::vector<float>
      colors; ///< For each texel, red, green and blue from 0 to 1; empty if the fine mesh has no colours.

  float least_displacement = 0;    ///< The least of the displacements of charts.
  float greatest_displacement = 0; ///< The greatest of the displacements of charts.

  /// returns the normals as pixels: 0 for -1, and the largest number of the type for 1.
  ///
  /// \tparam Channel `std::uint8_t` or `std::uint16_t`
  template <typename Channel>
  std::vector<Channel> normal_pixels() const
  {
    return pixels<Channel>(normals, -1, 1);
  }

  /// returns the displacements as pixels: 0 for the least displacement, and the largest number of the type for the
  /// greatest one.
  ///
  /// \tparam Channel `std::uint8_t` or `std::uint16_t`
  template <typename Channel>
  std::vector<Channel> displacement_pixels() const
  {
    return pixels<Channel>(displacements, least_displacement, greatest_displacement);
  }

  /// returns the colours as pixels: 0 for 0, and the largest number of the type for 1.
  ///
  /// \tparam Channel `std::uint8_t` or `std::uint16_t`
  template <typename Channel>
  std::vector<Channel> color_pixels() const
  {
    return pixels<Channel>(colors, 0, 1);
  }

private:
  template <typename Channel>
  static std::vector<Channel> pixels(const std::vector<float>& values, double least, double greatest)
  {
    const double scale = greatest > least ? (std::numeric_limits<Channel>::max)() / (greatest - least) : 0;
    std::vector<Channel> result(values.size());
    for(std::size_t i = 0; i < values.size(); ++i) {
      const double value = (std::min)((std::max)(static_cast<double>(values[i]), least), greatest);
      result[i] = static_cast<Channel>(std::lround(scale * (value - least)));
    }
    return result;
  }
};

/// \ingroup PkgTextureAtlasRef
///
/// The textures that `bake_surface()` makes of two meshes, and what is wrong with these.
///
/// \tparam TriangleMesh a model of `FaceGraph`: the simple surface, which `offending_vertices` and `offending_faces`
///   are of
/// \tparam FineMesh a model of `FaceGraph`: the fine surface
template <typename TriangleMesh, typename FineMesh>
struct Baked_surface : Mesh_report<TriangleMesh, Baked_textures>
{
  /// The vertices of the fine surface that the diagnosis is about.
  std::vector<typename boost::graph_traits<FineMesh>::vertex_descriptor> offending_fine_vertices;
  /// The faces of the fine surface that it is about.
  std::vector<typename boost::graph_traits<FineMesh>::face_descriptor> offending_fine_faces;
};

} // namespace Texture_atlas

} // namespace CGAL

#endif // CGAL_TEXTURE_ATLAS_BAKED_TEXTURES_H
