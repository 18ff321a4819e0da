// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Bakes texel by texel: finds the point of the fine surface, and stores its normal, color and distance. Gutters are
// filled at the end. Included by `bake.h`, or by the source file of the compiled library. Makes textures like that of
// Figure 9 (Section 6.1).

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_BAKING_BAKE_IMPL_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_BAKING_BAKE_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/baking/bake.h>
#include <CGAL/Texture_atlas/internal/baking/chart_texels.h>
#include <CGAL/Texture_atlas/internal/baking/fine_surface_searches.h>
#include <CGAL/Texture_atlas/internal/baking/shaded_surfaces.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Statistics of some texels
struct Distance_statistics
{
  std::size_t texels = 0, back_faces = 0, missed = 0;
  double sum = 0, largest = 0;
  float least_displacement = std::numeric_limits<float>::infinity();
  float greatest_displacement = -std::numeric_limits<float>::infinity();

  void add(const Distance_statistics& other)
  {
    texels += other.texels;
    back_faces += other.back_faces;
    missed += other.missed;
    sum += other.sum;
    largest = (std::max)(largest, other.largest);
    least_displacement = (std::min)(least_displacement, other.least_displacement);
    greatest_displacement = (std::max)(greatest_displacement, other.greatest_displacement);
  }
};

class Baker
{
public:
  Baker(const Charted_surface& simple, const Painted_surface& fine, const std::vector<Tangent_frame>& frames,
        const Baking_options& options)
      : m_simple(simple), m_fine(fine), m_frames(frames), m_options(options), m_tree(fine)
  {
    m_reach = options.ray_length ? *options.ray_length : diagonal() / 20;
  }

  Baked_textures run()
  {
    const Chart_texels texels(m_simple, m_options.resolution, m_options.number_of_rows());
    allocate();
    std::vector<Distance_statistics> statistics(texels.number_of_bands());
    parallel_for(texels.number_of_bands(), [&](int band) { statistics[band] = bake_band(texels, band); });
    Distance_statistics total;
    for(const Distance_statistics& band : statistics)
      total.add(band);
    report(total);
    Gutter_filler(m_textures, m_options.gutter).run();
    return std::move(m_textures);
  }

private:
  // The directions of a point of the simple surface, each of length 1
  struct Frame
  {
    Space_vector tangent, bitangent, normal;
  };

  double diagonal() const
  {
    Eigen::AlignedBox3d box;
    for(const Space_vector& p : m_simple.points)
      box.extend(p);
    return box.isEmpty() ? 0 : box.diagonal().norm();
  }

  void allocate()
  {
    const std::size_t n = static_cast<std::size_t>(m_options.resolution) * m_options.number_of_rows();
    m_textures.resolution = m_options.resolution;
    m_textures.height = m_options.number_of_rows();
    m_textures.texels.assign(n, Baked_textures::EMPTY);
    m_textures.displacements.assign(n, 0);
    m_textures.normals.assign(3 * n, 0);
    for(std::size_t i = 0; i < n; ++i)
      m_textures.normals[3 * i + 2] = 1;
    if(!m_fine.colors.empty())
      m_textures.colors.assign(3 * n, 0);
  }

  Distance_statistics bake_band(const Chart_texels& texels, int band)
  {
    Distance_statistics statistics;
    const std::vector<Texel_source> sources = texels.sources(band);
    std::size_t texel = static_cast<std::size_t>(texels.first_row(band)) * m_options.resolution;
    for(const Texel_source& source : sources) {
      if(source.triangle >= 0)
        bake_texel(texel, source, statistics);
      ++texel;
    }
    return statistics;
  }

  void bake_texel(std::size_t texel, const Texel_source& source, Distance_statistics& statistics)
  {
    const int* v = &m_simple.vertex[3 * static_cast<std::size_t>(source.triangle)];
    const Space_vector p = interpolated(m_simple.points, v, source.weights),
                       normal = interpolated(m_simple.normals, v, source.weights),
                       direction = direction_of(normal, m_simple.normals[v[0]]);
    Fine_point found = m_tree.along_ray(p, direction, m_reach);
    Baked_textures::Texel kind = found.is_back_face ? Baked_textures::BACK_FACE : Baked_textures::FRONT_FACE;
    if(!found.is_found()) {
      found = m_tree.closest(p);
      kind = Baked_textures::CLOSEST_POINT;
    }
    const int* w = &m_fine.vertex[3 * static_cast<std::size_t>(found.triangle)];
    const Space_vector q = interpolated(m_fine.points, w, found.weights);
    const double displacement = kind == Baked_textures::CLOSEST_POINT ? direction.dot(q - p) : found.distance;
    m_textures.texels[texel] = kind;
    m_textures.displacements[texel] = static_cast<float>(displacement);
    write(normal_to_store(source, direction, normal_at(found, direction, kind)),
          &m_textures.normals[3 * texel]);
    if(!m_fine.colors.empty())
      write(interpolated(m_fine.colors, w, found.weights), &m_textures.colors[3 * texel]);

    ++statistics.texels;
    statistics.back_faces += kind == Baked_textures::BACK_FACE;
    statistics.missed += kind == Baked_textures::CLOSEST_POINT;
    const double distance = std::abs(found.distance);
    statistics.sum += distance;
    statistics.largest = (std::max)(statistics.largest, distance);
    statistics.least_displacement =
        (std::min)(statistics.least_displacement, m_textures.displacements[texel]);
    statistics.greatest_displacement =
        (std::max)(statistics.greatest_displacement, m_textures.displacements[texel]);
  }

  static Space_vector interpolated(const std::vector<Space_vector>& values, const int* v,
                                   const std::array<double, 3>& weights)
  {
    return weights[0] * values[v[0]] + weights[1] * values[v[1]] + weights[2] * values[v[2]];
  }

  static void write(const Space_vector& value, float* place)
  {
    for(int k = 0; k < 3; ++k)
      place[k] = static_cast<float>(value[k]);
  }

  // The normal of the fine surface, reversed if it points to the other side
  Space_vector normal_at(const Fine_point& found, const Space_vector& direction,
                         Baked_textures::Texel kind) const
  {
    const std::array<Space_vector, 3> p = corners_of(m_fine, found.triangle);
    const Space_vector of_face = direction_of((p[1] - p[0]).cross(p[2] - p[0]), direction);
    const Space_vector normal = direction_of(
        interpolated(m_fine.normals, &m_fine.vertex[3 * static_cast<std::size_t>(found.triangle)],
                     found.weights),
        of_face);
    const bool looks_away = kind == Baked_textures::BACK_FACE ||
                            (kind == Baked_textures::CLOSEST_POINT && of_face.dot(direction) < 0);
    return looks_away ? Space_vector(-normal) : normal;
  }

  Space_vector normal_to_store(const Texel_source& source, const Space_vector& direction,
                               const Space_vector& normal) const
  {
    if(m_options.normals_in_object_space)
      return normal;
    const Frame frame = frame_at(source, direction);
    Eigen::Matrix3d axes;
    axes << frame.tangent, frame.bitangent, frame.normal;
    return direction_of(axes.inverse() * normal, Space_vector::UnitZ());
  }

  // As viewers do it: the directions of the corners are interpolated, and then get length 1.
  Frame frame_at(const Texel_source& source, const Space_vector& direction) const
  {
    Space_vector tangent = Space_vector::Zero(), bitangent = tangent;
    const std::size_t first = 3 * static_cast<std::size_t>(source.triangle);
    for(int k = 0; k < 3; ++k) {
      const Tangent_frame& frame = m_frames[first + k];
      const Eigen::Map<const Space_vector> n(frame.normal.data()), t(frame.tangent.data());
      tangent += source.weights[k] * t;
      bitangent += source.weights[k] * frame.sign * n.cross(t);
    }
    Frame frame = {direction_of(tangent, Space_vector::Zero()), direction_of(bitangent, Space_vector::Zero()),
                   direction};
    if(std::abs(frame.tangent.cross(frame.bitangent).dot(direction)) < 0.01) { // tangents that nearly cancel
      const Eigen::Map<const Space_vector> t(m_frames[first].tangent.data());
      frame.tangent = direction_of(t - direction.dot(t) * direction, direction.unitOrthogonal());
      frame.bitangent = m_frames[first].sign * direction.cross(frame.tangent);
    }
    return frame;
  }

  void report(const Distance_statistics& total)
  {
    Baking_report& report = m_textures;
    report.number_of_chart_texels = total.texels;
    report.number_of_back_faces = total.back_faces;
    report.number_of_missed_rays = total.missed;
    report.ray_length = m_reach;
    report.largest_distance = total.largest;
    if(total.texels > 0) {
      report.mean_distance = total.sum / static_cast<double>(total.texels);
      m_textures.least_displacement = total.least_displacement;
      m_textures.greatest_displacement = total.greatest_displacement;
    }
  }

  const Charted_surface& m_simple;
  const Painted_surface& m_fine;
  const std::vector<Tangent_frame>& m_frames;
  const Baking_options& m_options;
  const Fine_surface_tree m_tree;
  double m_reach;
  Baked_textures m_textures;
};

CGAL_ANGLE_BASED_FLATTENING_INLINE Baking bake(Charted_surface simple, Painted_surface fine,
                                               const Baking_options& options)
{
  Baking result;
  with_threads(options.threads, [&] {
    if(simple.normals.empty())
      add_vertex_normals(simple);
    if(fine.normals.empty())
      add_vertex_normals(fine);
    result.frames = Tangent_maker(simple).run();
    result.textures = Baker(simple, fine, result.frames, options).run();
  });
  return result;
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_BAKING_BAKE_IMPL_H
