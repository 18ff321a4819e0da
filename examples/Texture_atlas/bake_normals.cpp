// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Texture_atlas/IO/OBJ.h>
#include <CGAL/Texture_atlas/bake_surface.h>
#include <CGAL/Texture_atlas/make_atlas.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/boost/graph/helpers.h>

#include <png.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using UV_map = Surface::Property_map<Surface::Halfedge_index, Kernel::Point_2>;
namespace TA = CGAL::Texture_atlas;
namespace SMS = CGAL::Surface_mesh_simplification;
namespace np = CGAL::parameters;
using Frame_map = Surface::Property_map<Surface::Halfedge_index, TA::Tangent_frame>;

// `format` is one of libpng's: PNG_FORMAT_RGB for 8 bits, or PNG_FORMAT_LINEAR_Y for grey of 16 bits.
bool write_png(const char* name, int resolution, png_uint_32 format, const void* pixels)
{
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = image.height = resolution;
  image.format = format;
  return png_image_write_to_file(&image, name, 0, pixels, 0, nullptr) != 0;
}

// The material names both pictures, and the normals are those that the texture refers to.
bool write_obj(Surface& surface, const UV_map& uv, const Frame_map& frames,
               const TA::Baked_textures& textures)
{
  const auto normals =
      surface.add_property_map<Surface::Vertex_index, Kernel::Vector_3>("v:normal", CGAL::NULL_VECTOR).first;
  for(auto f : faces(surface)) {
    for(auto h : halfedges_around_face(halfedge(f, surface), surface)) {
      const auto& n = frames[h].normal;
      normals[target(h, surface)] = Kernel::Vector_3(n[0], n[1], n[2]);
    }
  }
  TA::OBJ_material material;
  material.normal_image = "bake_normals.png";
  material.displacement_image = "bake_displacement.png";
  material.least_displacement = textures.least_displacement;
  material.greatest_displacement = textures.greatest_displacement;
  return bool(TA::IO::write_OBJ("bake_normals.obj", surface, uv, material, np::vertex_normal_map(normals)));
}

// Each corner is a vertex of its own: 12 numbers, 48 bytes. In glTF, v goes down, and numbers are little endian, as on
// most machines.
bool write_gltf(const Surface& surface, const UV_map& uv, const Frame_map& frames)
{
  std::vector<float> numbers;
  for(auto f : faces(surface)) {
    for(auto h : halfedges_around_face(halfedge(f, surface), surface)) {
      const auto& p = surface.point(target(h, surface));
      const auto& [n, t, sign] = frames[h];
      for(double number :
          {p.x(), p.y(), p.z(), n[0], n[1], n[2], t[0], t[1], t[2], sign, uv[h].x(), 1 - uv[h].y()}) {
        numbers.push_back(static_cast<float>(number));
      }
    }
  }
  const std::size_t bytes = numbers.size() * sizeof(float);
  std::ofstream data("bake_normals.bin", std::ios::binary), out("bake_normals.gltf");
  data.write(reinterpret_cast<const char*>(numbers.data()), static_cast<std::streamsize>(bytes));

  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(surface);
  const auto accessor = [&numbers](int offset, const char* type) {
    return R"({"bufferView":0,"componentType":5126,"count":)" + std::to_string(numbers.size() / 12) +
           R"(,"byteOffset":)" + std::to_string(offset) + R"(,"type":")" + type + '"';
  };
  out.precision(9);
  out << R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1,"TANGENT":2,"TEXCOORD_0":3},"material":0}]}],
"materials":[{"normalTexture":{"index":0},"pbrMetallicRoughness":{"metallicFactor":0}}],
"textures":[{"source":0}],"images":[{"uri":"bake_normals.png"}],
"buffers":[{"uri":"bake_normals.bin","byteLength":)"
      << bytes << R"(}],"bufferViews":[{"buffer":0,"byteStride":48,"byteLength":)" << bytes << R"(}],
"accessors":[)"
      << accessor(0, "VEC3") << R"(,"min":[)" << float(box.xmin()) << ',' << float(box.ymin()) << ','
      << float(box.zmin()) << R"(],"max":[)" << float(box.xmax()) << ',' << float(box.ymax()) << ','
      << float(box.zmax()) << "]},\n"
      << accessor(12, "VEC3") << "},\n"
      << accessor(24, "VEC4") << "},\n"
      << accessor(40, "VEC2") << "}]}\n";
  return bool(data) && bool(out);
}

int main(int argc, char* argv[])
{
  Surface fine;
  if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/dinosaur.off", fine) ||
     !CGAL::is_triangle_mesh(fine)) {
    std::cerr << "Cannot read a triangle mesh.\n";
    return 1;
  }

  // The simple surface, without faces that are turned over
  const std::size_t wanted = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : fine.number_of_faces() / 8;
  Surface simple = fine;
  SMS::edge_collapse(
      simple, [&](auto, const auto&, auto, auto) { return simple.number_of_faces() <= wanted; },
      np::filter(SMS::Bounded_normal_change_filter<>()));
  simple.collect_garbage();

  const UV_map uv = simple.add_property_map<Surface::Halfedge_index, Kernel::Point_2>("h:uv", {0, 0}).first;
  TA::Atlas_options atlas_options(TA::Atlas_options::FEW_CHARTS);
  atlas_options.resolution = 512;
  const auto atlas = TA::make_atlas(simple, uv, atlas_options);
  if(!atlas) {
    std::cerr << atlas.message << "\n";
    return 1;
  }

  const Frame_map frames =
      simple.add_property_map<Surface::Halfedge_index, TA::Tangent_frame>("h:frame").first;
  TA::Baking_options baking_options;
  baking_options.resolution = 512;
  const auto textures = TA::bake_surface(simple, uv, fine, frames, baking_options);
  if(!textures) {
    std::cerr << textures.message << "\n";
    return 1;
  }
  std::cout << fine.number_of_faces() << " triangles baked into the texture of " << simple.number_of_faces()
            << ": " << textures.number_of_chart_texels << " texels, " << textures.number_of_missed_rays
            << " rays missed, " << textures.number_of_back_faces << " met back faces, distances up to "
            << textures.largest_distance << "\n";

  const bool is_written =
      write_png("bake_normals.png", 512, PNG_FORMAT_RGB, textures.normal_pixels<std::uint8_t>().data()) &&
      write_png("bake_displacement.png", 512, PNG_FORMAT_LINEAR_Y,
                textures.displacement_pixels<std::uint16_t>().data()) &&
      write_obj(simple, uv, frames, textures) && write_gltf(simple, uv, frames);
  return is_written ? 0 : 1;
}
