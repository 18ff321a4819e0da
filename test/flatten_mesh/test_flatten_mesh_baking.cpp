// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The options `--bake-from` and `--simplify` of the program `flatten_mesh`: what a viewer shows of its files, notes and
// errors.

#include "run_flatten_mesh.h"

#include "baked_surfaces.h"

#ifdef ABF_WITH_ASSIMP
#include <assimp/Importer.hpp>
#include <assimp/material.h>
#include <assimp/scene.h>
#endif

#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/boost/graph/Euler_operations.h>

BOOST_AUTO_TEST_SUITE(test_flatten_mesh_baking)

#ifdef ABF_WITH_PNG

using baked_surfaces::Plane_point;
using baked_surfaces::Vector;

struct Baking : Folder
{
  Baking()
  {
    common_options = "--quiet ";
    baked_surfaces::Surface fine = baked_surfaces::sphere(5);
    write("fine.off", off_text(fine));
    write("fine.obj", colored_obj(fine));
    CGAL::Polygon_mesh_processing::reverse_face_orientations(fine);
    write("turned.off", off_text(fine));
    baked_surfaces::Surface coarse = baked_surfaces::sphere(1);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> radius(0.92, 1.04);
    for(const auto v : coarse.vertices())
      coarse.point(v) = CGAL::ORIGIN + radius(random) * (coarse.point(v) - CGAL::ORIGIN);
    write("coarse.off", off_text(coarse));
  }

  static std::string off_text(const baked_surfaces::Surface& surface)
  {
    std::ostringstream text;
    text.precision(17);
    CGAL::IO::write_OFF(text, surface);
    return text.str();
  }

  // The colour at a point of the unit sphere, from 0 to 1
  static Vector color_at(const Vector& p) { return (p + Vector(1, 1, 1)) / 2; }

  static std::string colored_obj(const baked_surfaces::Surface& surface)
  {
    std::ostringstream text;
    text.precision(17);
    for(const auto v : surface.vertices()) {
      text << "v " << surface.point(v) << ' '
           << color_at(baked_surfaces::vector_of(surface.point(v))).transpose() << '\n';
    }
    for(const auto f : surface.faces()) {
      text << 'f';
      for(const auto v : surface.vertices_around_face(surface.halfedge(f)))
        text << ' ' << v.idx() + 1;
      text << '\n';
    }
    return text.str();
  }

  void bake(const std::string& input, const std::string& fine, const std::string& output,
            const std::string& options = "")
  {
    run(quoted(file(input)) + " --bake-from " + quoted(file(fine)) + " --output " + quoted(file(output)) +
        " --json " + quoted(file("flat.json")) + " " + options);
  }

  template <class Value>
  Value report(const std::string& name) const
  {
    return json().get<Value>("baking." + name);
  }
};

// The grey values of a PNG file with 16 bits
std::vector<std::uint16_t> grey_pixels(const std::string& png_file)
{
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  BOOST_REQUIRE(png_image_begin_read_from_file(&image, png_file.c_str()) != 0);
  BOOST_TEST((image.format & PNG_FORMAT_FLAG_LINEAR) != 0u);
  BOOST_TEST((image.format & PNG_FORMAT_FLAG_COLOR) == 0u);
  image.format = PNG_FORMAT_LINEAR_Y;
  std::vector<std::uint16_t> pixels(std::size_t(image.width) * image.height);
  BOOST_REQUIRE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr) != 0);
  return pixels;
}

std::vector<std::uint8_t> bytes_of(const std::vector<Pixel>& pixels)
{
  std::vector<std::uint8_t> bytes;
  for(const Pixel& pixel : pixels)
    bytes.insert(bytes.end(), pixel.begin(), pixel.end());
  return bytes;
}

#ifdef ABF_WITH_ASSIMP

Vector vector_of(const aiVector3D& v)
{
  return {v.x, v.y, v.z};
}

// A point in a face of a file, as a viewer interpolates it
struct Shown_point
{
  Vector point, normal, tangent, bitangent;
  Plane_point uv;

  Shown_point(const aiMesh& mesh, std::mt19937& random)
  {
    std::uniform_real_distribution<double> unit(0, 1);
    const double r = std::sqrt(unit(random)), s = unit(random);
    const std::array<double, 3> weights = {1 - r, r * (1 - s), r * s};
    const aiFace& face = mesh.mFaces[random() % mesh.mNumFaces];
    point = normal = tangent = bitangent = Vector(0, 0, 0);
    uv = Plane_point(0, 0);
    for(std::size_t k = 0; k < 3; ++k) {
      const unsigned v = face.mIndices[k];
      point += weights[k] * vector_of(mesh.mVertices[v]);
      normal += weights[k] * vector_of(mesh.mNormals[v]);
      uv += weights[k] * Plane_point(mesh.mTextureCoords[0][v].x, mesh.mTextureCoords[0][v].y);
      if(mesh.HasTangentsAndBitangents()) {
        tangent += weights[k] * vector_of(mesh.mTangents[v]);
        bitangent += weights[k] * vector_of(mesh.mBitangents[v]);
      }
    }
    for(Vector* direction : {&normal, &tangent, &bitangent})
      direction->normalize();
  }

  // Where a ray along the normal meets the unit sphere
  Vector on_sphere() const
  {
    const double along = point.dot(normal);
    return point + (std::sqrt(along * along - point.squaredNorm() + 1) - along) * normal;
  }
};

std::string texture_name(const aiMaterial& material, const aiTextureType type)
{
  aiString name;
  return material.GetTexture(type, 0, &name) == aiReturn_SUCCESS ? name.C_Str() : "";
}

#ifdef ABF_WITH_GLTF
// The pixels of a picture inside of a file
std::vector<std::uint8_t> embedded_pixels(const aiScene& scene, const std::string& name, const Folder& folder)
{
  const aiTexture* texture = scene.GetEmbeddedTexture(name.c_str());
  BOOST_REQUIRE(texture != nullptr);
  BOOST_TEST(texture->mHeight == 0u); // compressed
  return bytes_of(pixels_of(folder.write(
      "embedded.png", std::string(reinterpret_cast<const char*>(texture->pcData), texture->mWidth))));
}

// With everything from one file, a viewer shows the fine sphere.
BOOST_FIXTURE_TEST_CASE(glb_contains_all, Baking)
{
  bake("coarse.off", "fine.obj", "flat.glb", "--resolution 512");
  BOOST_TEST(status == 0);
  BOOST_TEST(standard_error == "");
  Assimp::Importer importer;
  const aiScene* const scene = importer.ReadFile(file("flat.glb"), 0);
  BOOST_REQUIRE(scene != nullptr);
  BOOST_REQUIRE(scene->mNumMeshes == 1u);
  const aiMesh& mesh = *scene->mMeshes[0];
  BOOST_TEST(mesh.mNumFaces == 80u);
  BOOST_REQUIRE(mesh.HasTangentsAndBitangents());
  const aiMaterial& material = *scene->mMaterials[mesh.mMaterialIndex];
  const std::vector<std::uint8_t> normals =
      embedded_pixels(*scene, texture_name(material, aiTextureType_NORMALS), *this);
  const std::vector<std::uint8_t> colors =
      embedded_pixels(*scene, texture_name(material, aiTextureType_BASE_COLOR), *this);
  BOOST_REQUIRE(normals.size() == 3u * 512 * 512);
  BOOST_REQUIRE(colors.size() == normals.size());
  std::mt19937 random(2);
  const int samples = 20000;
  double shown = 0, without = 0, color = 0;
  for(int i = 0; i < samples; ++i) {
    const Shown_point place(mesh, random);
    const Vector n = 2 * baked_surfaces::read_texture(normals, 512, place.uv, true) / 255 - Vector(1, 1, 1);
    const Vector normal = n.x() * place.tangent + n.y() * place.bitangent + n.z() * place.normal;
    shown += baked_surfaces::degrees_between(normal, place.on_sphere());
    without += baked_surfaces::degrees_between(place.normal, place.on_sphere());
    color += (baked_surfaces::read_texture(colors, 512, place.uv, true) / 255 - color_at(place.on_sphere()))
                 .cwiseAbs()
                 .maxCoeff();
  }
  BOOST_TEST(shown / samples < 0.5);
  BOOST_TEST(without / samples > 1.5); // an empty texture would be seen
  BOOST_TEST(color / samples < 0.01);
}

BOOST_FIXTURE_TEST_CASE(from_a_scan_to_a_textured_model, Baking)
{
  common_options = "";
  bake("fine.obj", "fine.obj", "flat.glb", "--simplify 500");
  BOOST_TEST(status == 0, standard_error);
  check_told("note: simplified from 20480 triangles to ");
  const auto triangles = json().get<std::size_t>("triangles");
  BOOST_TEST(triangles <= 500u);
  BOOST_TEST(triangles >= 490u);
  BOOST_TEST(report<int>("missed_rays") == 0);
  BOOST_TEST(report<int>("back_faces") == 0);
  BOOST_TEST(report<double>("largest_distance") < 0.02);
  BOOST_TEST(report<std::size_t>("triangles") == 20480u);
  Assimp::Importer importer;
  const aiScene* const scene = importer.ReadFile(file("flat.glb"), 0);
  BOOST_REQUIRE(scene != nullptr);
  BOOST_TEST(scene->mMeshes[0]->mNumFaces == triangles);
  BOOST_TEST(scene->mNumTextures == 2u);
}
#endif

BOOST_FIXTURE_TEST_CASE(obj_names_its_pictures, Baking)
{
  common_options = "";
  bake("coarse.off", "fine.obj", "flat.obj", "--resolution 256");
  BOOST_TEST(status == 0);
  BOOST_TEST(standard_error == "");
  for(const char* name :
      {"flat.obj", "flat.mtl", "flat_normals.png", "flat_displacement.png", "flat_colors.png"})
    check_printed(file(name));
  for(const char* line : {"baked", "  missed", "  back faces", "  distance", "  displacement"})
    check_printed(std::string("\n") + line + " ");
  Assimp::Importer importer;
  const aiScene* const scene = importer.ReadFile(file("flat.obj"), 0);
  BOOST_REQUIRE(scene != nullptr);
  BOOST_REQUIRE(scene->mNumMeshes == 1u);
  const aiMesh& mesh = *scene->mMeshes[0];
  BOOST_REQUIRE(mesh.HasNormals());
  const aiMaterial& material = *scene->mMaterials[mesh.mMaterialIndex];
  BOOST_TEST(material.GetName().C_Str() == "baked");
  BOOST_TEST(texture_name(material, aiTextureType_DIFFUSE) == "flat_colors.png");
  BOOST_TEST(texture_name(material, aiTextureType_NORMALS) == "flat_normals.png");
  BOOST_TEST(texture_name(material, aiTextureType_DISPLACEMENT) == "flat_displacement.png");

  const Lines range = lines_with(content(path / "flat.mtl"), "disp -mm");
  BOOST_REQUIRE(range.size() == 1u);
  const std::vector<double> base_and_gain = numbers(range);
  const std::vector<std::uint16_t> heights = grey_pixels(file("flat_displacement.png"));
  const std::vector<std::uint8_t> normals = bytes_of(pixels_of(file("flat_normals.png")));
  BOOST_REQUIRE(heights.size() == 256u * 256);
  std::mt19937 random(3);
  double largest = 0;
  for(int i = 0; i < 5000; ++i) {
    const Shown_point place(mesh, random);
    const auto texel = static_cast<std::size_t>((1 - place.uv.y()) * 256) * 256 +
                       static_cast<std::size_t>(place.uv.x() * 256);
    const double height = base_and_gain.at(0) + base_and_gain.at(1) * heights[texel] / 65535;
    largest = (std::max)(largest, (place.point + height * place.normal - place.on_sphere()).norm());
  }
  BOOST_TEST(largest < 0.01); // a texel is about 0.02 long
}

#endif

// Faces keep the materials that they have, with colours and opacities; groups remain.
BOOST_FIXTURE_TEST_CASE(materials_are_kept, Baking)
{
  common_options = "";
  write("flat.mtl", "newmtl of another model\n"); // is overwritten, and not referred to from elsewhere
  fs::create_directory(path / "in");
  write("in/paint.mtl", "newmtl red paint\nKd 1 0.25 0\nmap_Kd old.png\nnewmtl glass\nd 0.5\n");
  write("in/model.obj", "mtllib paint.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nvn 0 1 1\n"
                        "f 1//1 2//1 3//1\ng half\nusemtl red paint\nf 1 3 4\nusemtl glass\nf 2 5 3\n");
  write("plane.off", "OFF\n4 2 0\n-1 -1 0.01\n3 -1 0.01\n3 2 0.01\n-1 2 0.01\n3 0 1 2\n3 0 2 3\n");
  bake("in/model.obj", "plane.off", "flat.obj", "--resolution 64");
  BOOST_TEST(status == 0, standard_error);
  check_told("note: baking replaces parts of the input: normals, materials except names");
  Lines kept;
  for(const std::string& line : lines_of(obj()))
    if(line.compare(0, 2, "v ") != 0 && line.compare(0, 2, "vt") != 0 && line.compare(0, 2, "vn") != 0)
      kept.push_back(line.substr(0, line[0] == 'f' ? 1 : std::string::npos));
  const Lines expected = {"# texture coordinates 'vt' by flatten_mesh",
                          "mtllib flat.mtl",
                          "usemtl baked",
                          "f",
                          "g half",
                          "usemtl red paint",
                          "f",
                          "usemtl glass",
                          "f"};
  BOOST_TEST(kept == expected, boost::test_tools::per_element());
  const std::string materials = content(path / "flat.mtl");
  for(const char* text : {"newmtl red paint\nKd 1 0.25 0\nd 1\nnorm flat_normals.png\n",
                          "newmtl glass\nKd 1 1 1\nd 0.5\nnorm flat_normals.png\n",
                          "newmtl baked\nKd 1 1 1\nd 1\nnorm flat_normals.png\n"})
    BOOST_TEST((materials.find(text) != std::string::npos), materials);
  BOOST_TEST(
      (materials.find("map_Kd") == std::string::npos)); // the old picture does not fit the new coordinates
  BOOST_TEST(!fs::exists(file("flat_colors.png")));     // the plane has no colours
  for(const std::string& normal : lines_with(obj(), "vn"))
    BOOST_TEST(numbers({normal}).at(2) == 1);
  for(const Pixel& pixel : pixels_of(file("flat_normals.png")))
    BOOST_TEST((pixel == Pixel{128, 128, 255}));
  bake("in/model.obj", "plane.off", "in/paint.obj", "--resolution 64");
  BOOST_TEST(status == 2);
  check_told("paint.mtl' would overwrite the material file of the input");
  BOOST_TEST((content(path / "in/paint.mtl").find("newmtl red paint") == 0u));
}

BOOST_FIXTURE_TEST_CASE(bad_rays_are_told, Baking)
{
  common_options = "";
  bake("coarse.off", "turned.off", "flat.obj", "--resolution 64");
  BOOST_TEST(status == 0);
  check_told("note: 100.0 % of the rays met only back faces of '" + file("turned.off") + "'");
  BOOST_TEST(report<int>("back_faces") == report<int>("chart_texels"));

  baked_surfaces::Surface open = baked_surfaces::sphere(5);
  for(const auto f : open.faces())
    if(baked_surfaces::point_at(open, {f, {1. / 3, 1. / 3, 1. / 3}}).z() > 0.5)
      CGAL::Euler::remove_face(open.halfedge(f), open);
  open.collect_garbage();
  write("open.off", off_text(open));
  bake("coarse.off", "open.off", "flat.obj", "--resolution 64");
  BOOST_TEST(status == 0);
  check_told(" of the rays met nothing of '" + file("open.off") + "' within ");
  // A quarter of a sphere's area is above one half; texels are about equally dense.
  BOOST_TEST(std::abs(report<double>("missed_rays") / report<double>("chart_texels") - 0.25) < 0.03);
  BOOST_TEST(json().get_child("notes").size() == 1u);

  bake("coarse.off", "fine.off", "flat.obj", "--resolution 64");
  BOOST_TEST(standard_error == "");
}

BOOST_FIXTURE_TEST_CASE(surfaces_that_are_simple_enough_stay, Baking)
{
  common_options = "";
  run(quoted(file("coarse.off")) + " --simplify 80 --output " + quoted(file("flat.obj")));
  check_told("note: the surface has 80 triangles: --simplify does not change it");
  run(quoted(file("coarse.off")) + " --output " + quoted(file("other.obj")));
  BOOST_TEST((obj() == content(path / "other.obj")));
}

BOOST_FIXTURE_TEST_CASE(wrong_uses_are_refused, Baking)
{
  const std::string input = quoted(file("coarse.off")), fine = " --bake-from " + quoted(file("fine.off")),
                    output = " --output " + quoted(file("flat.obj"));
  const auto check = [&](const std::string& arguments, const Lines& words) {
    run(arguments);
    check_refusal(words);
  };
  check(input + fine, {"--bake-from needs --output NAME.obj or NAME.glb"});
  check(input + fine + " --output -", {"--bake-from needs --output"});
  check(input + fine + " --output " + quoted(file("flat.ply")), {"--bake-from needs --output"});
  check(input + fine + output + " --no-pack", {"--bake-from goes without --no-pack"});
  check(input + fine + output + " --units world", {"--bake-from goes without --units world"});
  check(input + fine + output + " --plain", {"--bake-from goes with an atlas"});
  check(input + output + " --bake-from " + quoted(file("missing.off")), {"there is no file", "missing.off"});
  check(input + output + " --bake-from " + quoted(write("broken.off", "OFF\n3 1 0\n0 0 0\n")),
        {"--bake-from", "broken.off"});
  check(input + output + " --bake-from " +
            quoted(write("line.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n")),
        {"line.off", "no face with an area"});
  check(input + output + " --bake-from ''", {"the name after --bake-from is empty"});
  check(input + output + " --simplify 3", {"--simplify is 3, and must be at least 4"});
  check(input + output + " --simplify 50 --seams-from uv", {"--simplify excludes --seams-from"});
  check(quoted(file("fine.obj")) + " --bake-from " + quoted(file("fine.off")) + " --output " +
            quoted(file("fine.obj")),
        {"would overwrite the input"});
  check(input + " --bake-from " + quoted(file("fine.obj")) + " --output " + quoted(file("fine.obj")),
        {"would overwrite the surface that is baked"});
  check(input + fine + output + " --picture " + quoted(file("flat_normals.png")),
        {"flat_normals.png", "are the same file"});
  BOOST_TEST(!fs::exists(file("flat.mtl")));
}

#endif

BOOST_AUTO_TEST_SUITE_END()
