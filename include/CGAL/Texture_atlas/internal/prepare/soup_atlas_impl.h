// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SOUP_ATLAS_IMPL_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SOUP_ATLAS_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/make_atlas_of_soup.h>
#include <CGAL/Texture_atlas/internal/options/wrong_option.h>
#include <CGAL/Texture_atlas/internal/prepare/prepare_surface.h>
#include <CGAL/Texture_atlas/internal/prepare/surface_atlas.h>

#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

inline void check_size(const std::string& array, const std::size_t size, const std::size_t wanted)
{
  if(size != wanted) {
    throw Input_error(array + " has " + std::to_string(size) + " elements, and must have " +
                      std::to_string(wanted));
  }
}

inline void check_numbers(const std::string& array, const std::vector<Index>& numbers, const std::size_t end)
{
  for(std::size_t i = 0; i < numbers.size(); ++i) {
    if(numbers[i] >= end && numbers[i] != no_index) {
      throw Input_error(array + "[" + std::to_string(i) + "] is " + std::to_string(numbers[i]) +
                            ", and there are only " + std::to_string(end),
                        {}, {}, Diagnosis::NUMBER_OUT_OF_RANGE);
    }
  }
}

// Throws an `Input_error` if the arrays of a soup do not fit together. Points of polygons are checked later.
inline void check_arrays(const Surface_soup& soup)
{
  const std::vector<Index>& first = soup.first_corners;
  if(first.empty() || first.front() != 0 || first.back() != soup.vertices.size()) {
    throw Input_error("first_corners must begin with 0 and end with the number of vertices");
  }
  if(const auto end = std::is_sorted_until(first.begin(), first.end()); end != first.end()) {
    const auto polygon = static_cast<std::size_t>(end - first.begin());
    throw Input_error("first_corners[" + std::to_string(polygon) + "] is less than the one before",
                      {polygon - 1});
  }
  if(soup.has_point_texture) {
    check_size("texture", soup.texture.size(), soup.points.size());
  }
  if(!soup.corner_texture.empty()) {
    check_size("corner_texture", soup.corner_texture.size(), soup.number_of_corners());
    check_numbers("corner_texture", soup.corner_texture, soup.texture.size());
  }
  if(!soup.materials.empty()) {
    check_size("materials", soup.materials.size(), soup.number_of_polygons());
    check_numbers("materials", soup.materials, soup.material_names.size());
  }
  if(!soup.is_ignored.empty()) {
    check_size("is_ignored", soup.is_ignored.size(), soup.number_of_polygons());
  }
}

// What is wrong with the options for these soups, in a sentence, or nothing
inline std::string wrong_soup_option(const Soup_options& options,
                                     const std::vector<const Surface_soup*>& soups)
{
  const bool has_seams =
      options.texture_seams || options.material_seams || options.given_charts != Atlas_options::REPLACE ||
      std::any_of(soups.begin(), soups.end(),
                  [](const Surface_soup* const soup) { return !soup->marked_seams.empty(); });
  if(soups.size() != 1 && (options.symmetric || options.component)) {
    return std::string(options.symmetric ? "symmetric" : "component") + " goes with one soup only";
  }
  if(options.symmetric && has_seams) {
    return "symmetric goes without given seams and charts: these stay where they are";
  }
  const std::string wrong = wrong_option(options);
  return wrong.empty() && options.pack_into_square ? wrong_gutter(options) : wrong;
}

// The edges of seams, as points of the soup
inline std::vector<std::pair<Index, Index>> seams_of(const Given_surface& given, const Edge_marks& seams)
{
  const Mesh& mesh = given.surface.mesh;
  std::vector<std::pair<Index, Index>> pairs;
  for(const Edge e : mesh.edges()) {
    for(const Halfedge h : {mesh.halfedge(e, 0), mesh.halfedge(e, 1)}) {
      if(seams[e] && !mesh.is_border(h)) {
        pairs.push_back(points_of(given.soup, given.surface, h));
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

inline Soup_atlas atlas_of_soup(const Given_surface& given, const Atlas& atlas)
{
  const Surface_soup& soup = given.soup;
  Model_texture texture = texture_of(soup, given.surface.mesh, given.surface.origins, atlas);
  keep_given_texture(soup, soup.is_ignored, texture);
  Soup_atlas result{std::move(texture.uv), {}, {}, seams_of(given, atlas.seams)};
  result.is_turned = std::move(texture.is_turned);
  for(const Index chart : texture.charts) {
    result.charts.push_back(chart == no_index ? -1 : static_cast<int>(chart));
  }
  return result;
}

// Throws an `Input_error`.
inline Soup_report try_atlas_of_soups(const std::vector<const Surface_soup*>& soups, const bool is_common,
                                      const Soup_settings& options, std::vector<Soup_atlas>& atlases,
                                      Notes& notes)
{
  Real_timer timer;
  timer.start();
  const Welding welding = {options.weld && options.repair ? Welding::ALL : Welding::NONE,
                           options.weld_tolerance};
  std::vector<Prepared_surface> surfaces(soups.size());
  std::vector<Given_surface> given;
  Mesh common;
  for(std::size_t i = 0; i < soups.size(); ++i) {
    const std::string name = soups[i]->name.empty() ? "soup " + std::to_string(i) : soups[i]->name;
    try {
      notes.set_subject(is_common ? "'" + name + "'" : "");
      check_arrays(*soups[i]);
      surfaces[i] = prepare_surface(*soups[i], {options.repair, welding, soups[i]->is_ignored}, notes);
    } catch(const Input_error& error) {
      throw is_common ? error.about("'" + name + "'", i) : error;
    }
    given.push_back({*soups[i], surfaces[i], "'" + name + "'"});
    if(is_common) {
      append(given.back(), common);
    }
  }
  notes.set_subject("");
  Mesh& mesh = is_common ? common : surfaces.front().mesh;
  const double seconds = timer.time();
  const Atlas atlas = empty_atlas(mesh);
  Soup_report report = make_atlas_of_surfaces(options, given, mesh, atlas, notes);
  report.seconds.read += seconds;
  if(report.has_atlas() && !options.pack_into_square && first_turned_face(mesh, atlas) != Mesh::null_face()) {
    throw Input_error("a triangle is so thin that rounding turns it over where charts lie in rows",
                      {polygon_of_face(given, first_turned_face(mesh, atlas))}, {},
                      Diagnosis::PRECISION_EXCEEDED);
  }
  if(report.has_atlas()) {
    atlases.clear();
    for(const Given_surface& each : given) {
      atlases.push_back(atlas_of_soup(each, is_common ? atlas_of_surface(atlas, each) : atlas));
    }
  }
  return report;
}

CGAL_ANGLE_BASED_FLATTENING_INLINE Soup_report make_atlas_of_soups(
    const std::vector<const Surface_soup*>& soups, const bool is_common, const Soup_options& options,
    const Linear_solvers& solvers, std::vector<Soup_atlas>& atlases)
{
  Soup_report report;
  report.message = wrong_soup_option(options, soups);
  if(!report.message.empty()) {
    report.status = Diagnosis::WRONG_OPTION;
    return report;
  }
  if(soups.empty()) {
    report.status = Diagnosis::EMPTY_MESH;
    report.message = "there is no soup";
    return report;
  }
  Notes notes;
  try {
    report = try_atlas_of_soups(soups, is_common, {options, solvers}, atlases, notes);
  } catch(const Input_error& error) {
    report.status = error.status;
    report.message = error.what();
    report.offending_polygons = error.faces;
    report.offending_points = error.vertices;
    report.offending_soup = error.soup;
  }
  report.notes = notes.texts();
  return report;
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SOUP_ATLAS_IMPL_H
