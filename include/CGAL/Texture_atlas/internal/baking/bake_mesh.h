// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The side of baking that knows the callers' meshes: reads and checks both, scales them to a safe range, and scales the
// results back. Included by `bake_surface.h`. The work itself is done by `bake()`.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_BAKING_BAKE_MESH_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_BAKING_BAKE_MESH_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/Baked_textures.h>
#include <CGAL/Texture_atlas/internal/baking/bake.h>
#include <CGAL/Texture_atlas/internal/baking/read_shaded_mesh.h>
#include <CGAL/Texture_atlas/internal/baking/shaded_surfaces.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>
#include <CGAL/Texture_atlas/internal/options/wrong_option.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>

#include <Eigen/Geometry>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Bakes a mesh into textures of another one.
template <typename TriangleMesh, typename HalfedgeUVMap, typename FineMesh, typename TangentFrameMap,
          typename NamedParameters, typename FineNamedParameters>
class Mesh_baker
{
  typedef Shaded_mesh_reader<TriangleMesh, NamedParameters> Reader;
  typedef Shaded_mesh_reader<FineMesh, FineNamedParameters> Fine_reader;
  typedef typename Reader::face_descriptor face_descriptor;
  typedef Baked_surface<TriangleMesh, FineMesh> Result;
  static constexpr bool all_have_charts =
      parameters::is_default_parameter<NamedParameters, internal_np::face_patch_t>::value;

  static_assert(
      parameters::is_default_parameter<NamedParameters, internal_np::vertex_color_map_t>::value,
      "colours are those of the fine surface: give `vertex_color_map` in the second named parameters");

public:
  Mesh_baker(const TriangleMesh& mesh, HalfedgeUVMap uv, const FineMesh& fine_mesh, TangentFrameMap frames,
             const Baking_options& options, const NamedParameters& np, const FineNamedParameters& fine_np)
      : m_uv(uv), m_frames(frames), m_np(np), m_fine_np(fine_np), m_reader(mesh, np),
        m_fine_reader(fine_mesh, fine_np), m_options(options)
  {}

  Result run()
  {
    Result result;
    Baked_textures& textures = result;
    if(!check_options() || !read_simple() || !read_fine()) {
      static_cast<Baking_report&>(textures) =
          m_report ? static_cast<const Baking_report&>(m_fine_report) : m_report;
      result.offending_vertices = m_report.offending_vertices;
      result.offending_faces = m_report.offending_faces;
      result.offending_fine_vertices = m_fine_report.offending_vertices;
      result.offending_fine_faces = m_fine_report.offending_faces;
      return result;
    }
    move_and_scale();
    Baking baking = bake(std::move(m_simple), std::move(m_fine), m_options);
    write_frames(baking.frames);
    textures = std::move(baking.textures);
    scale_back(textures);
    return result;
  }

private:
  bool fail(Diagnosis diagnosis, const std::string& message)
  {
    return Reader::fail(m_report, diagnosis, message);
  }

  bool check_options()
  {
    const std::string wrong = wrong_option(m_options);
    return wrong.empty() || fail(Diagnosis::WRONG_OPTION, wrong);
  }

  bool read_simple()
  {
    const auto has_chart = [&](face_descriptor f) {
      if constexpr(all_have_charts) {
        (void)f;
        return true;
      } else
        return get(parameters::get_parameter(m_np, internal_np::face_patch), f) >= 0;
    };
    if(!m_reader.read(has_chart, m_simple, Diagnosis::NOT_TRIANGULATED, m_report))
      return false;
    if(m_simple.vertex.empty())
      return fail(Diagnosis::EMPTY_MESH, "no face of the simple surface has a chart");
    for(std::size_t v = 0; v < m_simple.points.size(); ++v)
      if(!(m_simple.points[v].array().abs() < largest_point).all())
        return m_reader.fail_at(m_reader.vertices_read()[v], m_report, Diagnosis::NON_FINITE_POINT,
                                " has a coordinate that is not finite, or above 1e37");
    if constexpr(!all_have_charts)
      for(const face_descriptor f : m_reader.faces_read())
        m_simple.chart.push_back(
            static_cast<long>(get(parameters::get_parameter(m_np, internal_np::face_patch), f)));
    return read_texture_coordinates();
  }

  bool read_texture_coordinates()
  {
    bool has_area = false;
    for(const face_descriptor f : m_reader.faces_read()) {
      for(int k = 0; k < 3; ++k) {
        const auto& p = get(m_uv, m_reader.halfedge_to(f, k));
        m_simple.uv.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
        if(!m_simple.uv.back().allFinite())
          return m_reader.fail_at(f, m_report, Diagnosis::NO_TEXTURE_COORDINATES,
                                  " has texture coordinates that are not finite");
        if(m_simple.uv.back().minCoeff() < 0 || m_simple.uv.back().maxCoeff() > 1)
          return m_reader.fail_at(f, m_report, Diagnosis::OUTSIDE_SQUARE,
                                  " has texture coordinates outside of the unit square");
      }
      const Planar_point* uv = &m_simple.uv[m_simple.uv.size() - 3];
      has_area = has_area || cross(uv[1] - uv[0], uv[2] - uv[0]) != 0;
    }
    return has_area ||
           fail(Diagnosis::NO_TEXTURE_COORDINATES, "the texture coordinates of all faces have no area");
  }

  bool read_fine()
  {
    if(!m_fine_reader.read([](auto) { return true; }, m_fine, Diagnosis::FINE_MESH_NOT_TRIANGULATED,
                           m_fine_report))
      return false;
    read_scale();
    for(std::size_t v = 0; v < m_fine.points.size(); ++v) {
      m_fine.points[v] = moved(m_fine.points[v]);
      if(!(m_fine.points[v].array().abs() < largest_coordinate).all())
        return m_fine_reader.fail_at(
            m_fine_reader.vertices_read()[v], m_fine_report, Diagnosis::WRONG_FINE_POINT,
            " of the fine surface has a coordinate that is not finite, or too far from the simple surface");
    }
    remove_triangles_without_area();
    if(m_fine.vertex.empty())
      return fail(Diagnosis::EMPTY_FINE_MESH, "the fine surface has no face with an area");
    if constexpr(!parameters::is_default_parameter<FineNamedParameters,
                                                   internal_np::vertex_color_map_t>::value) {
      const auto colors = parameters::get_parameter(m_fine_np, internal_np::vertex_color_map);
      for(const auto v : m_fine_reader.vertices_read()) {
        const auto& color = get(colors, v);
        m_fine.colors.emplace_back(color.red() / 255., color.green() / 255., color.blue() / 255.);
      }
    }
    return true;
  }

  void remove_triangles_without_area()
  {
    std::vector<int> kept;
    for(std::size_t c = 0; c < m_fine.vertex.size(); c += 3) {
      const int* v = &m_fine.vertex[c];
      const Space_vector& p = m_fine.points[v[0]];
      if((m_fine.points[v[1]] - p).cross(m_fine.points[v[2]] - p).squaredNorm() > 0)
        kept.insert(kept.end(), v, v + 3);
    }
    m_fine.vertex = std::move(kept);
  }

  // Powers of two do not round.
  void read_scale()
  {
    Eigen::AlignedBox3d box;
    for(const Space_vector& p : m_simple.points)
      box.extend(p);
    m_origin = box.min() / 2 + box.max() / 2;
    const double extent = (box.max() / 2 - box.min() / 2).maxCoeff();
    m_exponent = extent > 0 ? std::ilogb(extent) + 1 : 0;
  }

  Space_vector moved(const Space_vector& p) const
  {
    const Space_vector q = p - m_origin;
    return {std::ldexp(q.x(), -m_exponent), std::ldexp(q.y(), -m_exponent), std::ldexp(q.z(), -m_exponent)};
  }

  void move_and_scale()
  {
    for(Space_vector& p : m_simple.points)
      p = moved(p);
    if(m_options.ray_length) // no ray has to go farther than that
      m_options.ray_length = (std::min)(
          (std::max)(std::ldexp(*m_options.ray_length, -m_exponent), (std::numeric_limits<double>::min)()),
          4 * largest_coordinate);
  }

  void scale_back(Baked_textures& textures) const
  {
    const auto scale = [this](auto& length) {
      length = static_cast<std::remove_reference_t<decltype(length)>>(
          std::ldexp(static_cast<double>(length), m_exponent));
    };
    for(float& displacement : textures.displacements)
      scale(displacement);
    scale(textures.least_displacement);
    scale(textures.greatest_displacement);
    scale(textures.ray_length);
    scale(textures.largest_distance);
    scale(textures.mean_distance);
  }

  void write_frames(const std::vector<Tangent_frame>& frames)
  {
    if constexpr(!std::is_same<TangentFrameMap, std::nullptr_t>::value)
      for(std::size_t i = 0; i < m_reader.faces_read().size(); ++i)
        for(int k = 0; k < 3; ++k)
          put(m_frames, m_reader.halfedge_to(m_reader.faces_read()[i], k), frames[3 * i + k]);
    else
      (void)frames;
  }

  static constexpr double largest_point = 1e37;      // displacements are floats
  static constexpr double largest_coordinate = 1e15; // where the simple surface is about as large as 1

  HalfedgeUVMap m_uv;
  TangentFrameMap m_frames; // or a null pointer
  const NamedParameters& m_np;
  const FineNamedParameters& m_fine_np;
  Reader m_reader;
  Fine_reader m_fine_reader;
  Baking_options m_options;
  typename Reader::Report m_report;
  typename Fine_reader::Report m_fine_report;
  Charted_surface m_simple;
  Painted_surface m_fine;
  Space_vector m_origin = Space_vector::Zero();
  int m_exponent = 0;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_BAKING_BAKE_MESH_H
