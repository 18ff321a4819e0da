// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The bodies of the functions of `symmetry.h`. `symmetrize_seams.h` includes it, or the source file of the compiled
// library. The plane in which a surface is most nearly symmetric is the best of many directions: planes are fitted to
// the surface and its mirror image, as by the iterative closest point method.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_SYMMETRY_IMPL_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_SYMMETRY_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>
#include <CGAL/Texture_atlas/internal/seams/nearest_objects.h>
#include <CGAL/Texture_atlas/internal/seams/mirror_seams.h>
#include <CGAL/Texture_atlas/internal/seams/symmetry.h>
#include <CGAL/Texture_atlas/internal/seams/triangle_arrays.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Texture_atlas::internal {

class Mirror_plane_finder
{
  typedef Seam_kernel::Point_3 Point_3;
  typedef Seam_kernel::Vector_3 Vector_3;

public:
  // At least one triangle has an area.
  explicit Mirror_plane_finder(const Triangle_arrays& mesh) : m_mesh(mesh), m_surface(mesh.proper_triangles())
  {}

  // Many planes are tried with few samples, and the best ones are fitted with more.
  Mirror_plane run() const
  {
    const std::vector<Point_3> few = samples(few_samples), many = samples(many_samples);
    std::vector<Mirror_plane> planes;
    for(const Vector_3& normal : directions(many))
      planes.push_back(fitted(plane_through_center(normal, few), few, 10));
    const auto is_better = [](const Mirror_plane& p, const Mirror_plane& q) {
      return p.deviation < q.deviation;
    };
    std::stable_sort(planes.begin(), planes.end(), is_better);
    planes.resize(2);
    for(Mirror_plane& plane : planes)
      plane = fitted(plane, many, 40);
    return oriented(*std::min_element(planes.begin(), planes.end(), is_better));
  }

private:
  // Its largest coordinate is positive.
  static Mirror_plane oriented(Mirror_plane plane)
  {
    const Vector_3 n = plane.normal;
    const double least = (std::min)({n.x(), n.y(), n.z()}), largest = (std::max)({n.x(), n.y(), n.z()});
    if(-least > largest) {
      plane.normal = -n;
      plane.offset = -plane.offset;
    }
    return plane;
  }

  // Spread over the area
  std::vector<Point_3> samples(std::size_t count) const
  {
    std::vector<double> area;
    for(const auto& t : m_mesh.triangles)
      area.push_back(std::sqrt(m_mesh.normal(t).squared_length()));
    std::partial_sum(area.begin(), area.end(), area.begin());
    std::vector<Point_3> result;
    for(std::size_t i = 0; i < count; ++i) {
      const double here = (static_cast<double>(i) + 0.5) / static_cast<double>(count) * area.back();
      const auto place = std::upper_bound(area.begin(), area.end(), here) - area.begin();
      const auto& [a, b, c] = m_mesh.triangles[(std::min)(static_cast<std::size_t>(place), area.size() - 1)];
      double u = fraction(static_cast<double>(i) *
                          0.7548776662466927), // steps of an even sequence in the plane
          v = fraction(static_cast<double>(i) * 0.5698402909980532);
      if(u + v > 1) {
        u = 1 - u;
        v = 1 - v;
      }
      const Point_3& p = m_mesh.points[a];
      result.push_back(p + u * (m_mesh.points[b] - p) + v * (m_mesh.points[c] - p));
    }
    return result;
  }

  static double fraction(double x) { return x - std::floor(x); }

  static Eigen::Vector3d vector(const Point_3& p) { return {p.x(), p.y(), p.z()}; }

  static Eigen::Vector3d center(const std::vector<Point_3>& points)
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for(const Point_3& p : points)
      sum += vector(p);
    return sum / static_cast<double>(points.size());
  }

  // The principal axes first, then directions that are spread evenly
  static std::vector<Vector_3> directions(const std::vector<Point_3>& points)
  {
    const Eigen::Vector3d middle = center(points);
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
    for(const Point_3& p : points)
      moments += (vector(p) - middle) * (vector(p) - middle).transpose();
    const Eigen::Matrix3d axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments).eigenvectors();
    std::vector<Vector_3> result;
    for(int i = 0; i < 3; ++i)
      result.emplace_back(axes(0, i), axes(1, i), axes(2, i));
    const double golden_angle = CGAL_PI * (3 - std::sqrt(5.));
    for(int i = 0; i < even_directions; ++i) {
      const double z = (i + 0.5) / even_directions, r = std::sqrt(1 - z * z);
      result.emplace_back(r * std::cos(i * golden_angle), r * std::sin(i * golden_angle), z);
    }
    return result;
  }

  static Mirror_plane plane_through_center(const Vector_3& normal, const std::vector<Point_3>& points)
  {
    Mirror_plane plane;
    plane.normal = normal;
    const Eigen::Vector3d c = center(points);
    plane.offset = normal * Vector_3(c.x(), c.y(), c.z());
    return plane;
  }

  // The best plane of a sequence in which each is the best one for the points of the surface that are nearest to the
  // mirror images in the one before
  Mirror_plane fitted(Mirror_plane plane, const std::vector<Point_3>& points, int steps) const
  {
    std::vector<Point_3> nearest;
    find_nearest(points, plane, nearest);
    for(int step = 0; step < steps; ++step) {
      Mirror_plane next = plane_between(points, nearest);
      find_nearest(points, next, nearest);
      if(!(next.deviation < (1 - least_gain) * plane.deviation))
        break;
      plane = next;
    }
    return plane;
  }

  void find_nearest(const std::vector<Point_3>& points, Mirror_plane& plane,
                    std::vector<Point_3>& nearest) const
  {
    double sum = 0;
    nearest.clear();
    for(const Point_3& p : points) {
      const Point_3 image = plane.mirrored(p);
      nearest.push_back(m_surface.point(image));
      sum += CGAL::squared_distance(image, nearest.back());
    }
    plane.deviation = std::sqrt(sum / static_cast<double>(points.size()));
  }

  // The plane in which the mirror images of `points` are nearest to `images` in the sense of least squares
  static Mirror_plane plane_between(const std::vector<Point_3>& points, const std::vector<Point_3>& images)
  {
    const Eigen::Vector3d p = center(points), q = center(images);
    Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
    for(std::size_t i = 0; i < points.size(); ++i)
      products += (vector(points[i]) - p) * (vector(images[i]) - q).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(products + products.transpose().eval());
    const Eigen::Vector3d n = solver.eigenvectors().col(0);
    Mirror_plane plane;
    plane.normal = Vector_3(n.x(), n.y(), n.z());
    plane.offset = n.dot(p + q) / 2;
    return plane;
  }

  static constexpr std::size_t few_samples = 200, many_samples = 2000;
  static constexpr int even_directions = 24;
  static constexpr double least_gain = 1e-3;

  const Triangle_arrays& m_mesh;
  const Nearest_objects<Seam_kernel::Triangle_3> m_surface;
};

CGAL_ANGLE_BASED_FLATTENING_INLINE Mirror_plane fit_mirror_plane(const Triangle_arrays& mesh)
{
  return Mirror_plane_finder(mesh).run();
}

CGAL_ANGLE_BASED_FLATTENING_INLINE std::vector<char>
mirror_seams(const Triangle_arrays& mesh, const Edge_graph& graph, const Mirror_plane& plane,
             const std::vector<char>& may_be_seam, const std::vector<char>& is_seam, int kept)
{
  return Seam_mirror(mesh, graph, plane, may_be_seam).run(is_seam, kept);
}

CGAL_ANGLE_BASED_FLATTENING_INLINE double
asymmetry_of_seams(const Edge_graph& graph, const std::vector<char>& is_seam, const Mirror_plane& plane)
{
  std::vector<Seam_kernel::Segment_3> segments;
  for(std::size_t e = 0; e < is_seam.size(); ++e)
    if(is_seam[e] && graph.length(e) > 0)
      segments.emplace_back(graph.points[graph.ends[e][0]], graph.points[graph.ends[e][1]]);
  if(segments.empty())
    return 0;
  double sum = 0, length = 0;
  const Nearest_objects<Seam_kernel::Segment_3> seams(segments);
  for(const Seam_kernel::Segment_3& segment : segments) {
    const double l = std::sqrt(segment.squared_length());
    const Seam_kernel::Point_3 middle = CGAL::midpoint(segment.source(), segment.target());
    sum += l * std::sqrt(seams.squared_distance(plane.mirrored(middle)));
    length += l;
  }
  return sum / length;
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_SYMMETRY_IMPL_H
