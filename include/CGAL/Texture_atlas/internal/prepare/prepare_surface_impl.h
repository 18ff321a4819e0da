// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_PREPARE_SURFACE_IMPL_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_PREPARE_SURFACE_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/prepare_surface.h>
#include <CGAL/Texture_atlas/internal/prepare/set_aside.h>
#include <CGAL/Texture_atlas/internal/prepare/build_mesh_impl.h>
#include <CGAL/Texture_atlas/internal/prepare/check_polygons.h>
#include <CGAL/Texture_atlas/internal/prepare/divide_keyholes.h>
#include <CGAL/Texture_atlas/internal/prepare/duplicate_polygons.h>
#include <CGAL/Texture_atlas/internal/prepare/polygons_without_area.h>
#include <CGAL/Texture_atlas/internal/prepare/separate_soup.h>
#include <CGAL/Texture_atlas/internal/prepare/weld_soup.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

inline Mesh build_separated_polygon_mesh(const Surface_soup& model, Polygon_soup& soup, const bool repair,
                                         Notes& notes)
{
  try {
    return build_polygon_mesh(soup);
  } catch(const Input_error&) {
    if(!repair) {
      throw;
    }
    separate_soup(model, soup, notes);
    return build_polygon_mesh(soup);
  }
}

// Removes polygons that are not to be flattened. Returns how many.
inline std::size_t remove_left_out(const std::vector<bool>& is_left_out, Polygon_soup& soup)
{
  const auto number = static_cast<std::size_t>(std::count(is_left_out.begin(), is_left_out.end(), true));
  if(number > 0) {
    std::vector<Index> part_of;
    for(const bool is_one : is_left_out) {
      part_of.push_back(is_one ? 0 : no_index);
    }
    leave_out(soup, part_of, {Skipped_part()});
    soup.left_out.clear(); // nothing is wrong with it
  }
  return number;
}

// Removes polygons without area, so that they neither tear charts nor make edges of three faces. Returns which
// polygons of the model these are; nothing if there are none.
inline std::vector<bool> remove_polygons_without_area(const Surface_soup& model,
                                                      const std::vector<bool>& is_far, Polygon_soup& soup)
{
  const std::vector<bool> is_one = have_no_area(soup, is_far);
  if(std::find(is_one.begin(), is_one.end(), true) == is_one.end()) {
    return {};
  }
  std::vector<bool> has_no_area(model.number_of_polygons(), false);
  std::vector<Index> part_of;
  for(std::size_t p = 0; p < is_one.size(); ++p) {
    has_no_area[soup.origins[p]] = is_one[p];
    part_of.push_back(is_one[p] ? 0 : no_index);
  }
  leave_out(soup, part_of, {Skipped_part()});
  soup.left_out.clear(); // they get coordinates later
  return has_no_area;
}

CGAL_ANGLE_BASED_FLATTENING_INLINE Prepared_surface prepare_surface(const Surface_soup& given,
                                                                    const Preparation& how, Notes& notes)
{
  Prepared_surface surface;
  Polygon_soup soup = polygon_soup(given);
  tell_repetitions(soup, notes);
  check_not_empty(soup);
  valences(soup); // throws if a vertex does not exist
  surface.left_out = remove_left_out(how.is_left_out, soup);
  const std::vector<bool> is_far = far_points(soup);
  std::vector<bool> has_no_area = remove_polygons_without_area(given, is_far, soup);
  divide_keyholes(given, soup, notes);
  set_aside(soup, is_far, how.repair);
  if(how.repair) {
    leave_out_duplicates(soup);
    weld_soup(how.welding, soup, notes);
    separate_backs(soup, notes);
  }
  while(!soup.polygons.empty() && surface.mesh.is_empty()) {
    std::vector<std::size_t> undivided;
    Surface_of_model built =
        end_surface(given, soup, build_separated_polygon_mesh(given, soup, how.repair, notes), undivided);
    if(undivided.empty()) {
      surface.mesh = std::move(built.mesh);
      surface.origins = std::move(built.origins);
    } else {
      set_undivided_aside(undivided, soup);
    }
  }
  surface.origins.is_turned.resize(given.number_of_polygons(), false); // also if no face remains
  surface.origins.has_no_area = std::move(has_no_area);
  surface.set_aside = std::move(soup.left_out);
  return surface;
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_PREPARE_SURFACE_IMPL_H
