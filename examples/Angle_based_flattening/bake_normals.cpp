// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/bake_surface.h>
#include <CGAL/Surface_mesh_parameterization/make_atlas.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <png.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using UV_map = Surface::Property_map<Surface::Halfedge_index, Kernel::Point_2>;
namespace SMP = CGAL::Surface_mesh_parameterization;
namespace SMS = CGAL::Surface_mesh_simplification;
namespace np = CGAL::parameters;
using Frame_map = Surface::Property_map<Surface::Halfedge_index, SMP::Tangent_frame>;

// `format` is one of libpng's: PNG_FORMAT_RGB for 8 bits, or PNG_FORMAT_LINEAR_Y for grey of 16 bits.
bool write_png(const char* name, int resolution, png_uint_32 format, const void* pixels)
{
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = image.height = resolution;
  image.format = format;
  return png_image_write_to_file(&image, name, 0, pixels, 0, nullptr) != 0;
}

// Each corner has a texture coordinate and a normal of its own; programs join what is equal.
bool write_obj(const Surface& surface, const UV_map& uv, const Frame_map& frames)
{
  std::ofstream out("bake_normals.obj");
  out << "mtllib bake_normals.mtl\nusemtl baked\n";
  out.precision(9);
  for(auto v : vertices(surface))
    out << "v " << surface.point(v) << "\n";
  std::size_t corner = 0;
  for(auto f : faces(surface)) {
    for(auto h : halfedges_around_face(halfedge(f, surface), surface)) {
      const auto& n = frames[h].normal;
      out << "vt " << uv[h] << "\nvn " << n[0] << " " << n[1] << " " << n[2] << "\n";
    }
    out << "f";
    for(auto h : halfedges_around_face(halfedge(f, surface), surface)) {
      ++corner;
      out << " " << surface.target(h).idx() + 1 << "/" << corner << "/" << corner;
    }
    out << "\n";
  }
  return bool(out);
}

// Some programs take the texture of normals from `norm`, others from `map_Bump`.
bool write_mtl(const SMP::Baked_textures& textures)
{
  std::ofstream out("bake_normals.mtl");
  out << "newmtl baked\nKd 0.8 0.8 0.8\n"
      << "norm bake_normals.png\nmap_Bump bake_normals.png\n"
      << "disp -mm " << textures.least_displacement << " "
      << textures.greatest_displacement - textures.least_displacement << " bake_displacement.png\n";
  return bool(out);
}

int main(int argc, char* argv[])
{
  Surface fine;
  if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/dinosaur.off", fine)) {
    std::cerr << "Cannot read the mesh.\n";
    return 1;
  }
  CGAL::Polygon_mesh_processing::triangulate_faces(fine);

  // The simple surface, without faces that are turned over
  const std::size_t wanted = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : fine.number_of_faces() / 8;
  Surface simple = fine;
  SMS::edge_collapse(
      simple, [&](auto, const auto&, auto, auto) { return simple.number_of_faces() <= wanted; },
      np::filter(SMS::Bounded_normal_change_filter<>()));
  simple.collect_garbage();

  const UV_map uv = simple.add_property_map<Surface::Halfedge_index, Kernel::Point_2>("h:uv", {0, 0}).first;
  const SMP::Atlas_report atlas = SMP::make_atlas(simple, uv, np::resolution(512));
  if(!atlas) {
    std::cerr << atlas.message << "\n";
    return 1;
  }

  const Frame_map frames =
      simple.add_property_map<Surface::Halfedge_index, SMP::Tangent_frame>("h:frame").first;
  const SMP::Baked_textures textures =
      SMP::bake_surface(simple, uv, fine, np::resolution(512, np::tangent_frame_map(frames)));
  if(!textures) {
    std::cerr << textures.report.message << "\n";
    return 1;
  }
  std::cout << fine.number_of_faces() << " triangles baked into the texture of " << simple.number_of_faces()
            << ": " << textures.report.number_of_chart_texels << " texels, "
            << textures.report.number_of_missed_rays << " rays missed, "
            << textures.report.number_of_back_faces << " met back faces, distances up to "
            << textures.report.largest_distance << "\n";

  const bool is_written =
      write_png("bake_normals.png", 512, PNG_FORMAT_RGB, textures.normal_pixels<std::uint8_t>().data()) &&
      write_png("bake_displacement.png", 512, PNG_FORMAT_LINEAR_Y,
                textures.displacement_pixels<std::uint16_t>().data()) &&
      write_mtl(textures) && write_obj(simple, uv, frames);
  return is_written ? 0 : 1;
}
