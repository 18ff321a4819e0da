// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// CGAL's tree over the triangles of the fine surface, with searches that tell front faces from back faces.
// `bake_impl.h` asks it once or twice for each texel.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_BAKING_FINE_SURFACE_TREE_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_BAKING_FINE_SURFACE_TREE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/baking/fine_surface_searches.h>
#include <CGAL/Texture_atlas/internal/baking/shaded_surfaces.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif

#include <boost/iterator/counting_iterator.hpp>

namespace CGAL::Texture_atlas::internal {

// Finds points on the fine surface. CGAL's tree, with searches of our own: its own queries return the nearest triangle
// on one side, or all triangles, and do not tell front faces from back faces.
class Fine_surface_tree
{
  typedef CGAL::Simple_cartesian<double> Kernel;
#if CGAL_VERSION_NR >= 1060000000
  typedef CGAL::AABB_traits_3<Kernel, Fine_triangle> Traits;
#else
  typedef CGAL::AABB_traits<Kernel, Fine_triangle> Traits;
#endif

public:
  explicit Fine_surface_tree(const Shaded_surface& surface)
      : m_tree(boost::counting_iterator<int>(0), boost::counting_iterator<int>(surface.number_of_triangles()),
               surface)
  {
    m_tree.build();
  }

  Fine_point along_ray(const Space_vector& origin, const Space_vector& direction, double reach) const
  {
    return found(Ray_search(origin, direction, reach));
  }

  Fine_point closest(const Space_vector& origin) const
  {
    return found(Closest_point_search(origin));
  }

private:
  template <typename Search>
  Fine_point found(Search search) const
  {
    m_tree.traversal_with_priority(true, search); // the searches know their queries
    return search.result();
  }

  CGAL::AABB_tree<Traits> m_tree;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_BAKING_FINE_SURFACE_TREE_H
