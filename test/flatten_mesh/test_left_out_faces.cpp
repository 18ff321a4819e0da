// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// `flatten_mesh --only-material` and `--ignore`: faces that get no charts, and keep the coordinates that they had.

#include "run_flatten_mesh.h"

#include "generated_gltf.h"
#include "read_textured_model.h"

BOOST_AUTO_TEST_SUITE(test_left_out_faces)

using textured::read_textured;
using textured::Textured_face;

// A grid of n by n squares on a hill. Stripes of `width` squares have material, object and group of their own. The
// coordinates are those of a plane above it.
struct Striped_hill
{
  int n = 12, width = 4;
  bool has_texture = true;

  static std::string stripe_name(const int stripe) { return std::string(1, static_cast<char>('a' + stripe)); }

  std::string obj() const
  {
    std::ostringstream text;
    for(int i = 0; i <= n; ++i) {
      for(int j = 0; j <= n; ++j) {
        text << "v " << i << ' ' << j << ' ' << 0.125 * (i * (n - i) + j * j % 7) << '\n';
        if(has_texture)
          text << "vt " << 10 + i << ' ' << j << '\n';
      }
    }
    for(int i = 0; i < n; ++i) {
      const std::string name = stripe_name(i / width);
      if(i % width == 0)
        text << "o object_" << name << "\ng all group_" << name << "\nusemtl paint " << name << '\n';
      for(int j = 0; j < n; ++j) {
        text << "f";
        for(const int v :
            {i * (n + 1) + j, (i + 1) * (n + 1) + j, (i + 1) * (n + 1) + j + 1, i * (n + 1) + j + 1}) {
          text << ' ' << v + 1;
          if(has_texture)
            text << '/' << v + 1;
        }
        text << '\n';
      }
    }
    return text.str();
  }
};

// Faces of the chosen stripes have new coordinates, and all others those that they had.
inline void check_stripes(const std::vector<Textured_face>& faces, const std::set<int>& chosen,
                          const int width, const bool has_texture = true)
{
  std::size_t new_ones = 0;
  std::vector<Textured_face> with_charts;
  for(const Textured_face& face : faces) {
    float least = face.points[0][0];
    for(const auto& point : face.points)
      least = (std::min)(least, point[0]);
    const bool is_chosen = chosen.count(static_cast<int>(least) / width) == 1;
    if(!is_chosen && !has_texture) {
      BOOST_TEST(face.uv.empty());
      continue;
    }
    BOOST_TEST_REQUIRE(face.uv.size() == 3u);
    for(std::size_t i = 0; i < 3; ++i) {
      if(is_chosen) {
        BOOST_TEST((face.uv[i][0] >= 0 && face.uv[i][0] <= 1 && face.uv[i][1] >= 0 && face.uv[i][1] <= 1));
      } else {
        BOOST_TEST(face.uv[i][0] == 10 + static_cast<double>(face.points[i][0]));
        BOOST_TEST(face.uv[i][1] == static_cast<double>(face.points[i][1]));
      }
    }
    if(is_chosen)
      with_charts.push_back(face);
    new_ones += is_chosen;
  }
  BOOST_TEST(new_ones > 0u);
  BOOST_TEST(textured::number_of_shared_texels(with_charts, 128) == 0u);
}

BOOST_FIXTURE_TEST_SUITE(of_the_program, Folder)

BOOST_AUTO_TEST_CASE(chosen_stripes)
{
  const Striped_hill hill;
  const std::string input = write("hill.obj", hill.obj());
  for(const auto& [options, chosen] :
      {std::pair<std::string, std::set<int>>{"--only-material 'paint b'", {1}},
       {"--only-material 'paint a, paint c'", {0, 2}},
       {"--ignore 'paint b'", {0, 2}},
       {"--ignore object_a", {1, 2}},
       {"--ignore object_a,group_c", {1}},
       {"--only-material 'paint a,paint b' --ignore group_a", {1}},
       {"--ignore object_b --seams creases", {0, 2}}}) {
    for(const std::string format : {"obj", "ply", "glb"}) {
      BOOST_TEST_INFO_SCOPE(options << " " << format);
      const std::string output = file("flat." + format);
      run(quoted(input) + " " + options + " --output " + quoted(output) + " --json " +
          quoted(file("flat.json")));
      BOOST_TEST(status == 0, standard_error);
      BOOST_TEST(json().get<std::string>("status") == "OK");
      BOOST_TEST(json().get<std::size_t>("left_out") == (3 - chosen.size()) * 48);
      BOOST_TEST(json().get<std::size_t>("components") == (chosen == std::set<int>{0, 2} ? 2u : 1u));
      BOOST_TEST(standard_output.find("left out") != std::string::npos);
      const std::vector<Textured_face> faces = read_textured(output);
      BOOST_TEST(faces.size() == 288u);
      check_stripes(faces, chosen, hill.width);
    }
  }
}

// The same charts as of a file without them
BOOST_AUTO_TEST_CASE(they_have_no_influence)
{
  const Striped_hill hill;
  const std::string all = hill.obj();
  std::string some;
  bool is_left_out = false;
  for(const std::string& line : lines_of(all)) {
    is_left_out = line[0] == 'o' ? line == "o object_b" : is_left_out;
    some += is_left_out ? "" : line + "\n";
  }
  flatten(write("some.obj", some));
  const auto expected = textured::texture_of(read_textured(file("flat.obj")));
  flatten(write("all.obj", all), "--ignore object_b");
  std::vector<Textured_face> faces = read_textured(file("flat.obj"));
  faces.erase(faces.begin() + 96, faces.begin() + 192);
  BOOST_TEST((textured::texture_of(faces) == expected));
}

BOOST_AUTO_TEST_CASE(without_coordinates)
{
  Striped_hill hill;
  hill.has_texture = false;
  const std::string input = write("hill.obj", hill.obj());
  for(const std::string format : {"obj", "glb"}) {
    const std::string output = file("flat." + format);
    run(quoted(input) + " --ignore object_b --output " + quoted(output));
    BOOST_TEST(status == 0, standard_error);
    check_stripes(read_textured(output), {0, 2}, hill.width, false);
  }
}

// From glTF to GLB, triangles that are left out have the coordinates that they had in both sets.
BOOST_AUTO_TEST_CASE(gltf)
{
  write("ball.glb", generated::ball_with_nodes("{\"mesh\":0}").binary());
  const std::vector<Textured_face> before = read_textured(file("ball.glb"));
  run(quoted(file("ball.glb")) + " --only-material wood --output " + quoted(file("some.glb")));
  BOOST_TEST_REQUIRE(status == 0, standard_error);
  const std::vector<Textured_face> after = read_textured(file("some.glb"));
  std::map<std::multiset<std::array<float, 3>>, std::vector<std::array<double, 2>>> texture;
  const auto sorted = [](std::vector<std::array<double, 2>> uv) {
    std::sort(uv.begin(), uv.end());
    return uv;
  };
  for(const Textured_face& face : before)
    texture[{face.points.begin(), face.points.end()}] = sorted(face.uv);
  std::size_t same = 0, others = 0;
  for(const Textured_face& face : after)
    (sorted(face.uv) == texture.at({face.points.begin(), face.points.end()}) ? same : others) += 1;
  BOOST_TEST(others == 30u); // of the first material
  BOOST_TEST(same == before.size() - 30);
  run(quoted(file("ball.glb")) + " --ignore ball --output " + quoted(file("none.glb")));
  check_refusal({"leave no face"});
}

BOOST_AUTO_TEST_CASE(several_models)
{
  Striped_hill hill;
  write("a.obj", hill.obj());
  hill.width = 6; // two stripes
  write("b.obj", hill.obj());
  const std::string both = quoted(file("a.obj")) + " " + quoted(file("b.obj")) + " --one-atlas --output " +
                           quoted(file("flat_%.obj"));
  run(both + " --only-material 'paint c'");
  BOOST_TEST_REQUIRE(status == 0, standard_error);
  check_stripes(read_textured(file("flat_a.obj")), {2}, 4);
  for(const Textured_face& face : read_textured(file("flat_b.obj")))
    BOOST_TEST(face.uv[0][0] >= 10);
  run(both + " --only-material 'paint d'");
  check_refusal({"--only-material: there is no material 'paint d'", "'paint c'"});
}

BOOST_AUTO_TEST_CASE(wrong_names)
{
  const std::string input = write("hill.obj", Striped_hill().obj());
  write("plain.off", Block{1, 1, 1}.make().text());
  for(const auto& [options, words] :
      {std::pair<std::string, Lines>{
           "--only-material paint", {"'hill.obj'", "no material 'paint'", "'paint a', 'paint b', 'paint c'"}},
       {"--only-material object_a", {"no material 'object_a'"}},
       {"--ignore nothing", {"no material, object or group 'nothing'", "'object_a', 'all', 'group_a'"}},
       {"--ignore all", {"leave no face"}},
       {"--ignore 'paint a,'", {"--ignore takes names with commas"}},
       {"--only-material ''", {"--only-material takes names"}},
       {"--ignore object_a --simplify 20", {"--ignore goes without --simplify"}},
       {"--ignore object_a --bake-from hill.obj", {"--ignore goes without --simplify and --bake-from"}},
       {"--ignore object_a --plain", {"--ignore goes with an atlas"}}}) {
    BOOST_TEST_INFO_SCOPE(options);
    flatten(input, options);
    Lines expected = words;
    if(expected.front() == "'hill.obj'")
      expected.front() = quoted(input);
    check_refusal(expected);
  }
  flatten(file("plain.off"), "--ignore glass");
  check_refusal({"there are no materials", "there are no objects and groups"});
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
