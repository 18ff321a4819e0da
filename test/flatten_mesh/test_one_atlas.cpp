// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// `flatten_mesh --one-atlas`: several models in one atlas.

#include "run_flatten_mesh.h"

#include "generated_gltf.h"
#include "generated_models.h"
#include "read_textured_model.h"

BOOST_AUTO_TEST_SUITE(test_one_atlas)

using textured::read_textured;
using textured::Textured_face;

inline std::string obj_ball(const double radius, const double x, const std::uint32_t n = 8)
{
  const generated::Ball ball(n, n + 4);
  std::ostringstream text;
  text.precision(17);
  text << "o ball\nusemtl red\n";
  std::map<std::array<float, 3>, std::size_t> numbers; // the ball has vertices several times
  std::vector<std::size_t> vertex;
  for(std::size_t i = 0; i < ball.points.size(); i += 3) {
    const std::array<float, 3> p = {ball.points[i], ball.points[i + 1], ball.points[i + 2]};
    const auto [place, is_new] = numbers.emplace(p, numbers.size() + 1);
    vertex.push_back(place->second);
    if(is_new)
      text << "v " << x + radius * p[0] << ' ' << radius * p[1] << ' ' << radius * p[2] << '\n';
  }
  for(std::size_t i = 0; i < ball.triangles.size(); i += 3) {
    text << "f " << vertex[ball.triangles[i]] << ' ' << vertex[ball.triangles[i + 1]] << ' '
         << vertex[ball.triangles[i + 2]] << '\n';
  }
  return text.str();
}

struct Models : Folder
{
  Models() { fs::create_directory(path / "out"); }

  // Runs the program on files of the folder.
  void flatten_together(const Lines& inputs, const std::string& options)
  {
    std::string words;
    for(const std::string& input : inputs)
      words += quoted(file(input)) + " ";
    run(words + "--one-atlas --json " + quoted(file("flat.json")) + " " + options);
    asks_for_json = true;
  }

  std::string out(const std::string& name) const { return file("out/" + name); }

  std::size_t files_in_out() const
  {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(path / "out"), {}));
  }

  boost::property_tree::ptree model(const std::size_t i) const
  {
    const boost::property_tree::ptree tree = json();
    auto child = tree.get_child("models").begin();
    std::advance(child, i);
    return child->second;
  }
};

BOOST_FIXTURE_TEST_SUITE(of_the_program, Models)

// Models of all formats, at the same place in space: each keeps its faces and materials, all have the same texel
// density, and no texel belongs to two faces.
BOOST_AUTO_TEST_CASE(models_share_the_page)
{
  write("large.obj", obj_ball(2, 0));
  write("small.glb", generated::ball_with_nodes("{\"mesh\":0}").binary());
  write("strip.obj", generated::obj_text(generated::strip(3), 3));
  write("block.off", Block{2, 1, 1}.make().text());
  const Lines inputs = {"large.obj", "small.glb", "strip.obj", "block.off"};
  flatten_together(inputs, "--output " + quoted(out("%.glb")) + " --svg " + quoted(file("flat.svg")) +
                               " --seams-to " + quoted(out("%.selection.txt")));
  BOOST_TEST_REQUIRE(status == 0, standard_error);
  BOOST_TEST(json().get<std::string>("status") == "OK");
  BOOST_TEST(json().get<std::string>("input") == "4 models");
  BOOST_TEST(files_in_out() == 8u);
  BOOST_TEST(fs::exists(file("flat.svg")));

  std::size_t charts = 0, triangles = 0;
  std::vector<double> density;
  std::vector<Textured_face> all;
  for(std::size_t i = 0; i < inputs.size(); ++i) {
    BOOST_TEST_INFO_SCOPE(inputs[i]);
    const std::vector<Textured_face> given = read_textured(file(inputs[i])),
                                     faces = read_textured(model(i).get<std::string>("output"));
    BOOST_TEST(given.size() == faces.size());
    BOOST_TEST(textured::area(given) == textured::area(faces), boost::test_tools::tolerance(0.02));
    if(i < 2) // of triangles; polygons may be divided in other ways
      BOOST_TEST((textured::corners_of(given) == textured::corners_of(faces)));
    BOOST_TEST(model(i).get<std::string>("input") == file(inputs[i]));
    BOOST_TEST(model(i).get<std::size_t>("triangles") == faces.size());
    BOOST_TEST(model(i).get<std::size_t>("first_chart") == charts);
    BOOST_TEST(model(i).get<std::size_t>("charts") > 0u);
    BOOST_TEST(model(i).get_child("skipped").size() == 0u);
    charts += model(i).get<std::size_t>("charts");
    triangles += faces.size();
    density.push_back(textured::planar_area(faces) / textured::area(faces));
    all.insert(all.end(), faces.begin(), faces.end());
  }
  BOOST_TEST(json().get_child("atlas.charts").size() == charts);
  BOOST_TEST(json().get<std::size_t>("triangles") == triangles);
  BOOST_TEST(*std::max_element(density.begin(), density.end()) <
             1.1 * *std::min_element(density.begin(), density.end()));
  BOOST_TEST(textured::number_of_shared_texels(all, 256) == 0u);
  BOOST_TEST(content(out("small.glb")).find("\"wood\"") != std::string::npos);
  BOOST_TEST(content(out("strip.glb")).find("\"red paint\"") != std::string::npos);
  for(const std::string& input : inputs)
    BOOST_TEST(standard_output.find(file(input)) != std::string::npos);
}

// As if all were in one file
BOOST_AUTO_TEST_CASE(the_same_as_of_one_file)
{
  const std::string first = obj_ball(1, 0), second = obj_ball(0.7, 5, 10);
  write("first.obj", first);
  write("second.obj", second);
  std::string both = first;
  const std::size_t vertices = lines_with(first, "v").size();
  for(const std::string& line : lines_with(second, "v"))
    both += "v " + line + "\n";
  for(const std::string& line : lines_with(second, "f")) {
    std::istringstream words(line);
    both += "f";
    for(std::size_t v = 0; words >> v;)
      both += " " + std::to_string(v + vertices);
    both += "\n";
  }
  for(const std::string options : {"", "--seams creases:20", "--for conformal --no-pack"}) {
    BOOST_TEST_INFO_SCOPE(options);
    flatten(write("both.obj", both), options);
    BOOST_TEST_REQUIRE(status == 0, standard_error);
    const auto expected = textured::texture_of(read_textured(file("flat.obj")));
    flatten_together({"first.obj", "second.obj"}, "--output " + quoted(out("%.obj")) + " " + options);
    BOOST_TEST_REQUIRE(status == 0, standard_error);
    auto found = textured::texture_of(read_textured(out("first.obj")));
    const auto rest = textured::texture_of(read_textured(out("second.obj")));
    found.insert(found.end(), rest.begin(), rest.end());
    BOOST_TEST((expected == found));
  }
}

// What lies around a model does not hide its seams.
BOOST_AUTO_TEST_CASE(models_do_not_hide_one_another)
{
  Block around = {3, 3, 3}, away = {3, 3, 3};
  write("inner.off", Block{2, 1, 1, {}, true}.make().text());
  write("around.off", around.make().text());
  std::string far = away.make().text();
  std::string moved;
  for(const std::string& line : lines_of(far)) { // to where it hides nothing
    std::istringstream words(line);
    double x = 0, y = 0, z = 0;
    std::string rest;
    if(words >> x >> y >> z && !(words >> rest) && line.find('.') != std::string::npos) {
      std::ostringstream point;
      point << x << ' ' << y << ' ' << z + 64;
      moved += point.str() + "\n";
    } else {
      moved += line + "\n";
    }
  }
  write("away.off", moved);
  std::vector<std::string> seams;
  for(const std::string other : {"around.off", "away.off"}) {
    flatten_together({"inner.off", other}, "--seams hidden --seams-to " + quoted(out("%.selection.txt")));
    BOOST_TEST_REQUIRE(status == 0, standard_error);
    seams.push_back(content(out("inner.selection.txt")));
  }
  BOOST_TEST(!seams[0].empty());
  BOOST_TEST(seams[0] == seams[1]);
}

BOOST_AUTO_TEST_CASE(seams_of_each_model)
{
  write("a.obj", obj_ball(1, 0));
  write("b.obj", obj_ball(1, 9));
  flatten_together({"a.obj", "b.obj"}, "--seams-to " + quoted(file("%.selection.txt")));
  BOOST_TEST_REQUIRE(status == 0, standard_error);
  const Edges given = edges_in(content(path / "b.selection.txt"));
  flatten_together({"a.obj", "b.obj"},
                   "--seams-from " + quoted(file("%.selection.txt")) + " --output " + quoted(out("%.obj")));
  BOOST_TEST_REQUIRE(status == 0, standard_error);
  BOOST_TEST((edges_with_two_textures(content(out("b.obj"))) == given));
  fs::remove(file("b.selection.txt"));
  flatten_together({"a.obj", "b.obj"}, "--seams-from " + quoted(file("%.selection.txt")));
  check_refusal({"b.obj", "b.selection.txt"});
  flatten_together({"a.obj", "b.obj"}, "--seams-from uv");
  check_refusal({"a.obj", "no texture coordinates"});
}

BOOST_AUTO_TEST_CASE(same_bytes_on_any_number_of_threads)
{
  write("a.obj", obj_ball(1, 0));
  write("b.obj", obj_ball(2, 0, 11));
  std::set<std::string> contents;
  for(const std::string threads : {"1", "2", "5"}) {
    flatten_together({"a.obj", "b.obj"}, "--threads " + threads + " --output " + quoted(out("%.ply")));
    BOOST_TEST_REQUIRE(status == 0, standard_error);
    contents.insert(content(out("a.ply")) + content(out("b.ply")));
  }
  BOOST_TEST(contents.size() == 1u);
}

BOOST_AUTO_TEST_CASE(one_model_is_a_set)
{
  write("a.obj", obj_ball(1, 0));
  flatten_together({"a.obj"}, "--output " + quoted(file("alone.obj")));
  BOOST_TEST_REQUIRE(status == 0, standard_error);
  BOOST_TEST(json().get_child("models").size() == 1u);
  BOOST_TEST(fs::exists(file("alone.obj")));
}

// The other models have charts.
BOOST_AUTO_TEST_CASE(skipped_parts_name_their_model)
{
  write("good.obj", obj_ball(1, 0));
  write("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 3 nan 0\nv 4 0 0\nv 3 1 0\nf 1 2 3\nf 4 5 6\n");
  write("worse.obj", "v 0 nan 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  flatten_together({"good.obj", "bad.obj", "worse.obj"}, "--output " + quoted(out("%.obj")));
  BOOST_TEST(status == 2);
  BOOST_TEST(json().get<std::string>("status") == "SOMETHING_SKIPPED");
  check_told(quoted(file("bad.obj")) + ": no chart for 1 face, the first is face 2: NON_FINITE_POINT");
  check_told(quoted(file("worse.obj")) + ": no chart for 1 face, the first is face 1: NON_FINITE_POINT");
  BOOST_TEST(json().get_child("skipped").size() == 2u);
  BOOST_TEST(json().get_child("skipped").front().second.get<std::string>("input") == file("bad.obj"));
  BOOST_TEST(model(0).get_child("skipped").size() == 0u);
  BOOST_TEST(model(1).get_child("skipped").size() == 1u);
  BOOST_TEST(model(2).get<std::size_t>("charts") == 0u);
  BOOST_TEST(files_in_out() == 3u);
  BOOST_TEST(lines_with(content(out("worse.obj")), "vt").empty());
  BOOST_TEST(lines_with(content(out("bad.obj")), "vt").size() == 3u + 1u); // and one for the other face
}

// All or nothing
BOOST_AUTO_TEST_CASE(one_wrong_file_is_named)
{
  write("good.obj", obj_ball(1, 0));
  write("short.ply", "ply\nformat ascii 1.0\nelement vertex 3\n");
  write("no_face.obj", "v 0 0 0\n");
  const std::string outputs = "--output " + quoted(out("%.obj")) + " --svg " + quoted(file("flat.svg"));
  for(const std::string wrong : {"short.ply", "no_face.obj", "missing.obj"}) {
    BOOST_TEST_INFO_SCOPE(wrong);
    flatten_together({"good.obj", wrong}, outputs);
    check_refusal({wrong});
    BOOST_TEST(files_in_out() == 0u);
  }
}

BOOST_AUTO_TEST_CASE(options_that_mean_nothing)
{
  write("a.obj", obj_ball(1, 0));
  write("b.obj", obj_ball(1, 0));
  fs::create_directory(path / "other");
  write("other/a.obj", obj_ball(1, 0));
  for(const auto& [options, word] :
      {std::pair<std::string, std::string>{"--component 1", "--one-atlas goes without --component"},
       {"--simplify 20", "--one-atlas goes without --simplify"},
       {"--bake-from " + quoted(file("b.obj")), "--one-atlas goes without --bake-from"},
       {"--plain", "--one-atlas goes without --plain"},
       {"- --format obj", "--one-atlas"},
       {"--svg " + quoted(file("%.svg")), "leave the '%' out"},
       {"--output " + quoted(file("flat.obj")), "names one file for 2 inputs"},
       {"--output " + quoted(file("%.obj")), "would overwrite the input"},
       {"--svg " + quoted(file("b.obj")), "b.obj"},
       {quoted(file("other/a.obj")) + " --output " + quoted(out("%.obj")), "inputs with the same name"}}) {
    BOOST_TEST_INFO_SCOPE(options);
    flatten_together({"a.obj", "b.obj"}, options);
    check_refusal({word});
    BOOST_TEST(files_in_out() == 0u);
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
