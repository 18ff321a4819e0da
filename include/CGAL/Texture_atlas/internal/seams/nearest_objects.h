// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A tree that finds the triangle or segment nearest to a point, or whether a ray meets one. `symmetry_impl.h`,
// `visibility_impl.h`, `seam_router.h` and `mirror_seams.h` search in it.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_NEAREST_OBJECTS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_NEAREST_OBJECTS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/parameterization_names.h>
#include <CGAL/Texture_atlas/internal/seams/triangle_arrays.h>

#include <CGAL/AABB_tree.h>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#if __has_include(<CGAL/AABB_traits_3.h>) // CGAL 6
#include <CGAL/AABB_segment_primitive_3.h>
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif

namespace CGAL::Texture_atlas::internal {

// Finds the nearest of some objects, which are triangles or segments. There is at least one, and none is degenerate.
template <typename Object>
class Nearest_objects
{
  typedef typename std::vector<Object>::const_iterator Iterator;
  static constexpr bool are_triangles = std::is_same<Object, Seam_kernel::Triangle_3>::value;
#if __has_include(<CGAL/AABB_traits_3.h>)
  typedef std::conditional_t<are_triangles, CGAL::AABB_triangle_primitive_3<Seam_kernel, Iterator>,
                             CGAL::AABB_segment_primitive_3<Seam_kernel, Iterator>>
      Primitive;
  typedef CGAL::AABB_traits_3<Seam_kernel, Primitive> Traits;
#else
  typedef std::conditional_t<are_triangles, CGAL::AABB_triangle_primitive<Seam_kernel, Iterator>,
                             CGAL::AABB_segment_primitive<Seam_kernel, Iterator>>
      Primitive;
  typedef CGAL::AABB_traits<Seam_kernel, Primitive> Traits;
#endif

public:
  explicit Nearest_objects(std::vector<Object> objects)
      : m_objects(std::move(objects)), m_tree(m_objects.cbegin(), m_objects.cend())
  {
    m_tree.build();
  }

  Seam_kernel::Point_3 point(const Seam_kernel::Point_3& p) const
  {
    return m_tree.closest_point(p);
  }

  double squared_distance(const Seam_kernel::Point_3& p) const
  {
    return m_tree.squared_distance(p);
  }

  std::size_t object(const Seam_kernel::Point_3& p) const
  {
    return static_cast<std::size_t>(m_tree.closest_point_and_primitive(p).second - m_objects.cbegin());
  }

  bool is_met_by(const Seam_kernel::Ray_3& ray) const
  {
    return m_tree.do_intersect(ray);
  }

private:
  const std::vector<Object> m_objects;
  CGAL::AABB_tree<Traits> m_tree;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_NEAREST_OBJECTS_H
