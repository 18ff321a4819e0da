// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_ATLAS_INPUT_IMPL_H
#define FLATTEN_MESH_ATLAS_INPUT_IMPL_H

#include "flatten_mesh/compiled.h"
#include "flatten_mesh/atlas/Atlas_input.h"
#include "flatten_mesh/atlas/set_aside.h"
#include "flatten_mesh/model/build_mesh_impl.h"
#include "flatten_mesh/model/check_polygons.h"
#include "flatten_mesh/model/divide_keyholes.h"
#include "flatten_mesh/model/duplicate_polygons.h"
#include "flatten_mesh/model/polygons_without_area.h"
#include "flatten_mesh/model/separate_soup.h"
#include "flatten_mesh/model/weld_soup.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace flatten_mesh {

namespace internal {

inline Mesh build_separated_polygon_mesh(const Model& model, Polygon_soup& soup, const bool repair,
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
inline std::size_t remove_left_out(const Face_choice& choice, const Model& model, Polygon_soup& soup)
{
  const std::vector<bool> is_left_out = left_out_polygons(choice, model);
  std::vector<Index> part_of;
  for(const bool is_one : is_left_out) {
    part_of.push_back(is_one ? 0 : no_index);
  }
  const auto number = static_cast<std::size_t>(std::count(is_left_out.begin(), is_left_out.end(), true));
  if(number > 0) {
    leave_out(soup, part_of, {Skipped_part()});
    soup.left_out.clear(); // nothing is wrong with it
  }
  return number;
}

// Removes polygons without area, so that they neither tear charts nor make edges of three faces. Returns which
// polygons of the model these are; nothing if there are none.
inline std::vector<bool> remove_polygons_without_area(const Model& model, const std::vector<bool>& is_far,
                                                      Polygon_soup& soup)
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

inline void build_atlas_input(const bool repair, const Welding& welding, const Face_choice& choice,
                              Notes& notes, Atlas_input& input)
{
  Polygon_soup soup = polygon_soup(input.model);
  tell_repetitions(soup, notes);
  check_not_empty(soup);
  valences(soup); // throws if a vertex does not exist
  input.left_out = remove_left_out(choice, input.model, soup);
  const std::vector<bool> is_far = far_points(soup);
  std::vector<bool> has_no_area = remove_polygons_without_area(input.model, is_far, soup);
  divide_keyholes(input.model, soup, notes);
  set_aside(soup, is_far, repair);
  if(repair) {
    leave_out_duplicates(soup);
    weld_soup(welding, soup, notes);
    separate_backs(soup, notes);
  }
  while(!soup.polygons.empty() && input.mesh.is_empty()) {
    std::vector<std::size_t> undivided;
    Surface_of_model built = end_surface(
        input.model, soup, build_separated_polygon_mesh(input.model, soup, repair, notes), undivided);
    if(undivided.empty()) {
      input.mesh = std::move(built.mesh);
      input.origins = std::move(built.origins);
    } else {
      set_undivided_aside(undivided, soup);
    }
  }
  input.origins.is_turned.resize(input.model.number_of_polygons(), false); // also if no face remains
  input.origins.has_no_area = std::move(has_no_area);
  input.set_aside = std::move(soup.left_out);
}

} // namespace internal

FLATTEN_MESH_INLINE Atlas_input atlas_input_of(Model model, const bool repair, Notes& notes,
                                               const Welding& welding, const Face_choice& choice)
{
  Atlas_input input;
  input.model = std::move(model);
  internal::build_atlas_input(repair, welding, choice, notes, input);
  return input;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_ATLAS_INPUT_IMPL_H
