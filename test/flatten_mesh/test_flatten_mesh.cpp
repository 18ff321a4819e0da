// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The program `flatten_mesh --plain` as a black box: exit status, messages, files.

#include "run_flatten_mesh.h"

BOOST_AUTO_TEST_SUITE(test_flatten_mesh)

struct Plain_folder : public Folder
{
  Plain_folder() { common_options = "--plain "; }

  // A file with this text is refused, in a line with these words.
  void check_refused(const std::string& name, const std::string& text, const Lines& words,
                     const std::string& options = "")
  {
    flatten(write(name, text), options);
    check_refusal(words);
  }
};

BOOST_FIXTURE_TEST_SUITE(good_input, Plain_folder)

BOOST_AUTO_TEST_CASE(bundled_mesh)
{
  flatten(dinosaur());
  check_success();
  for(const std::string& word :
      parts_of("vertices|triangles|borders|iterations|angle change|per corner|scale|energy|L2 stretch|"
               "L-infinity stretch|L2 shear|L2 principal shear|equal-stretch error|"
               "quasi-conformal ratio|area distortion|symmetric Dirichlet|flipped triangles|border |"
               "smallest angle|seconds|layout"))
    check_printed(word);
  const auto tree = json();
  for(const std::string& key :
      parts_of("angular_distortion|mean_angle_change|rms_angle_change|mean_corner_angle_change|"
               "rms_corner_angle_change|quasi_conformal_ratio_95|min_scale|max_scale|l2_stretch|"
               "linf_stretch|l2_shear|l2_principal_shear|l2_equal_stretch_error|"
               "mean_quasi_conformal_ratio|max_quasi_conformal_ratio|l2_area_distortion|"
               "symmetric_dirichlet_energy|smallest_angle|iterations|peak_memory_mb|seconds.read|"
               "seconds.write|seconds.parameterize|seconds.targets|seconds.angles|seconds.layout|"
               "seconds.certify")) {
    BOOST_TEST_INFO_SCOPE(key);
    BOOST_TEST(std::isfinite(tree.get<double>(key)));
  }
#ifdef __linux__
  const double coordinates_mb = tree.get<double>("vertices") * 5 * sizeof(double) / (1024. * 1024.);
  BOOST_TEST(tree.get<double>("peak_memory_mb") > coordinates_mb);
  BOOST_TEST(tree.get<double>("peak_memory_mb") < 1024); // megabytes indeed
  check_printed("peak memory");
#endif
  BOOST_TEST(tree.get<int>("borders") == 1);
  BOOST_TEST(tree.get<std::string>("border") == "simple");
  BOOST_TEST(tree.get<int>("triangles") > 5000);
  BOOST_TEST(lines_with(obj(), "vt").size() == tree.get<std::size_t>("vertices"));
  const std::string svg = content(file("flat.svg"));
  BOOST_TEST(svg.find("<svg") < 100u);
  BOOST_TEST(count_in_svg(svg, "fill:rgb(") > 20u); // the colours of the triangles
  BOOST_TEST(svg.size() > 10000u);
  BOOST_TEST((svg.find("nan") == std::string::npos));
}

#ifdef ABF_WITH_PNG
// A plane square as a checkerboard: both colours, in about equal parts, on a white ground.
BOOST_AUTO_TEST_CASE(picture_shows_a_checkerboard)
{
  run(quoted(write("sheet.off", off(Sheet()))) + " --picture " + quoted(file("flat.png")));
  BOOST_TEST(status == 0);
  const std::vector<Pixel> pixels = pixels_of(file("flat.png"));
  std::size_t light = 0, dark = 0, ground = 0;
  for(const Pixel& pixel : pixels) {
    const bool is_ground = pixel[0] == 255;
    ground += is_ground;
    light += !is_ground && pixel[0] > 150;
    dark += pixel[0] < 80;
  }
  BOOST_TEST(ground > 0u);
  BOOST_TEST(light > pixels.size() / 10);
  BOOST_TEST(dark > light / 2);
  BOOST_TEST(dark < light * 2);
}
#endif

BOOST_AUTO_TEST_CASE(order_and_coordinates_survive)
{
  const Sheet sheet;
  flatten(write("sheet.off", off(sheet)));
  check_success();
  BOOST_TEST(numbers(lines_with(obj(), "v")) == numbers(lines_of(sheet.points())),
             boost::test_tools::per_element());
  std::vector<bool> has_texture;
  BOOST_TEST((obj_faces(obj(), has_texture) == sheet.faces()));
  BOOST_TEST((std::count(has_texture.begin(), has_texture.end(), false) == 0));
}

BOOST_AUTO_TEST_CASE(quadrangles_stay)
{
  Sheet sheet;
  sheet.triangulated = false;
  flatten(write("quads.off", off(sheet)));
  check_success();
  std::vector<bool> has_texture;
  BOOST_TEST((obj_faces(obj(), has_texture) == sheet.faces()));
  BOOST_TEST(json().get<int>("triangles") == 2 * sheet.columns * sheet.rows);
}

BOOST_AUTO_TEST_CASE(unused_vertices_stay)
{
  const Sheet sheet;
  flatten(write("unused.off", off(sheet.vertices() + 1, sheet.points() + "7 7 7\n", sheet.faces())));
  check_success();
  BOOST_TEST(lines_with(obj(), "v").size() == static_cast<std::size_t>(sheet.vertices() + 1));
  BOOST_TEST(lines_with(obj(), "vt").size() == static_cast<std::size_t>(sheet.vertices()));
}

BOOST_AUTO_TEST_CASE(other_formats)
{
  const Sheet sheet;
  for(const std::string& input : {write("sheet.obj", obj_input(sheet)), write("sheet.stl", stl(sheet)),
                                  write("sheet.PLY", ply(floats(sheet), sheet.faces()))}) {
    BOOST_TEST_INFO_SCOPE(input);
    flatten(input);
    check_success();
    BOOST_TEST(json().get<int>("vertices") == sheet.vertices());
    BOOST_TEST(lines_with(obj(), "f").size() == sheet.faces().size());
  }
}

BOOST_AUTO_TEST_CASE(components)
{
  Sheet small, large;
  small.rows = 3;
  large.shift = 20;
  std::vector<std::vector<int>> faces = small.faces();
  for(const std::vector<int>& face : large.faces(small.vertices()))
    faces.push_back(face);
  const std::string input =
      write("two.off", off(small.vertices() + large.vertices(), small.points() + large.points(), faces));
  std::vector<bool> has_texture;
  flatten(input);
  check_success();
  BOOST_TEST(json().get<int>("vertices") == large.vertices());
  BOOST_TEST((obj_faces(obj(), has_texture) == faces));
  BOOST_TEST(!has_texture.front());
  BOOST_TEST(has_texture.back());

  flatten(input, "--component 1");
  check_success();
  BOOST_TEST(json().get<int>("vertices") == small.vertices());
  BOOST_TEST((obj_faces(obj(), has_texture) == faces));
  BOOST_TEST(has_texture.front());
  BOOST_TEST(!has_texture.back());
}

BOOST_AUTO_TEST_CASE(holes)
{
  Sheet sheet;
  sheet.holes = {7, 16};
  const std::string input = write("holes.off", off(sheet));
  flatten(input);
  check_success();
  BOOST_TEST(json().get<int>("borders") == 3);
  BOOST_TEST(json().get<std::string>("layout") == "exact");
  const double solved = json().get<double>("energy");
  flatten(input, "--border 2");
  check_success();
  for(const std::string method : {"direct", "hierarchical"}) {
    flatten(input, "--holes solve --method " + method);
    if(method == "direct")
      check_success();
    else
      check_told("holes were filled instead of solved: the coarse chart would consist of little but holes");
    BOOST_TEST(status == 0);
    flatten(input, "--holes fill --method " + method);
    check_success();
  }
  flatten(input, "--holes solve");
  BOOST_TEST(json().get<double>("energy") == solved);
  flatten(input, "--holes refuse");
  BOOST_TEST(json().get<std::string>("status") == "SEVERAL_BORDERS");
}

// Tubes of a circumference of 12: scale varies by exp(2 pi height / 12), at which the corners of a 12-gon gnaw a
// little.
BOOST_AUTO_TEST_CASE(far_borders)
{
  const auto tube = [](const int rows) {
    std::ostringstream points;
    std::vector<std::vector<int>> faces;
    for(int j = 0; j <= rows; ++j) {
      for(int i = 0; i < 12; ++i) {
        const double angle = 3.14159265358979 / 6 * (i + 0.5 * (j % 2));
        points << 1.91 * std::cos(angle) << ' ' << 1.91 * std::sin(angle) << ' ' << j << '\n';
      }
    }
    for(int q = 0; q < 12 * rows; ++q) {
      const int a = q, b = q / 12 * 12 + (q + 1) % 12, shift = q / 12 % 2;
      faces.push_back({a, b, (shift == 0 ? a : b) + 12});
      faces.push_back(shift == 0 ? std::vector<int>{b, b + 12, a + 12} : std::vector<int>{a, b + 12, a + 12});
    }
    return off(12 * (rows + 1), points.str(), faces);
  };
  flatten(write("short.off", tube(12)));
  check_success();
  BOOST_TEST(is_stretched());
  BOOST_TEST(json().get<double>("predicted_scale_range") > 300);
  BOOST_TEST(json().get<double>("predicted_scale_range") < 900);
  for(const std::string method : {"direct", "hierarchical"}) {
    flatten(write("long.off", tube(30)), "--method " + method);
    BOOST_TEST(status == 0);
    BOOST_TEST(json().get_child("notes").size() == 1u);
    BOOST_TEST(is_stretched());
    flatten(file("long.off"), "--stretch-bound 1.5 --method " + method);
    check_success();
    BOOST_TEST(!is_stretched());
    BOOST_TEST(json().get<double>("l2_stretch") < 1.01);
    flatten(write("tube.off", tube(60)), "--method " + method);
    BOOST_TEST(status == 2);
    BOOST_TEST(json().get<std::string>("status") == "SCALE_TOO_LARGE");
    check_told("cut the surface open from the border");
  }
}

// Six needles at a vertex that a scanner did not measure
BOOST_AUTO_TEST_CASE(a_stray_vertex_is_named)
{
  Sheet sheet;
  sheet.columns = sheet.rows = 12;
  sheet.holes = {30, 100};
  std::istringstream points(sheet.points());
  std::string moved, line;
  for(int v = 0; std::getline(points, line); ++v)
    moved += v == 80 ? "0 0 -1e6\n" : line + "\n";
  flatten(write("stray.off", off(sheet.vertices(), moved, sheet.faces())));
  BOOST_TEST(status == 2);
  check_told("remove vertex 81 (0, 0, -1e+06)");
}

BOOST_AUTO_TEST_CASE(all_options)
{
  const Sheet sheet;
  const std::string input = write("sheet.off", off(sheet));
  for(const std::string options :
      {"--barrier 0", "--layout exact", "--layout least-squares", "--layout auto",
       "--tolerance 1e-6 --max-iterations 50", "--step sqp", "--step newton", "--solver eigen",
       "--solver superlu", "--method direct --component 0 --border 0",
       "--method hierarchical --simplification-rate 0.9", "--method hierarchical --polish"}) {
    BOOST_TEST_INFO_SCOPE(options);
    flatten(input, options);
    check_success();
  }
  run("--input " + quoted(input) + " --json " + quoted(file("flat.json")));
  check_success();
}

// Lines without information about the surface are skipped. Those that are not understood are reported.
BOOST_AUTO_TEST_CASE(obj_lines)
{
  const Sheet sheet;
  const std::string text = obj_input(sheet);
  flatten(write("silent.obj", "\xEF\xBB\xBFmtllib a.mtl\n" + text + "vt 0 0 # comment\ns off\n"));
  check_success();
  BOOST_TEST(lines_with(obj(), "mtllib").size() == 1u); // the rest of the model stays

  flatten(write("skipped.obj", "call other.obj\n" + text + "l 1 2\np 3\ncurve 7\n"));
  BOOST_TEST(status == 0);
  BOOST_TEST(lines_of(standard_error).size() == 1u, standard_error);
  for(const char* word : {"note", "4 lines", "line 1", "'call'"})
    check_told(word);
  BOOST_TEST((json().get_child("notes").front().second.get_value<std::string>().find("4 lines") !=
              std::string::npos));

  std::string continued = text;
  continued.replace(continued.find("\nf ") + 2, 1, " \\\r\n");
  flatten(write("continued.obj", continued));
  check_success();
  BOOST_TEST(lines_with(obj(), "f").size() == sheet.faces().size());
  flatten(write("backwards.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3/1/1 -2//2 -1\n"));
  check_success();
}

BOOST_AUTO_TEST_CASE(byte_order_marks)
{
  for(const std::string& input : {write("sheet.off", "\xEF\xBB\xBF" + off(Sheet())),
                                  write("sheet.stl", "\xEF\xBB\xBF" + stl(Sheet()))}) {
    BOOST_TEST_INFO_SCOPE(input);
    flatten(input);
    check_success();
  }
}

BOOST_AUTO_TEST_CASE(soup_is_welded)
{
  const Sheet sheet;
  const Lines points = lines_of(sheet.points());
  std::string text;
  std::vector<std::vector<int>> faces;
  for(const std::vector<int>& face : sheet.faces()) {
    const int first = 3 * static_cast<int>(faces.size());
    for(const int v : face)
      text += points[static_cast<std::size_t>(v)] + "\n";
    faces.push_back({first, first + 1, first + 2});
  }
  const std::string input = write("soup.off", off(3 * static_cast<int>(faces.size()), text, faces));
  flatten(input);
  BOOST_TEST(status == 0);
  check_told("merged: 35 vertices remain of 144");
  BOOST_TEST(json().get<int>("components") == 1);
  BOOST_TEST(json().get<int>("vertices") == sheet.vertices());
  flatten(input, "--repair off");
  check_success();
  BOOST_TEST(json().get<int>("components") == 48);

  std::string triangles = stl(sheet);
  triangles.insert(triangles.find("endsolid"), "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 0 0\n"
                                               "vertex 1 0 0\nendloop\nendfacet\n");
  const std::string point = "1 2 3\n1 2 3\n1 2 3\n";
  flatten(write("point.off", "OFF\n6 2 0\n" + point + point + "3 0 1 2\n3 3 4 5\n"));
  BOOST_TEST(status == 2);
  check_told("every face has two corners at the same place");
  flatten(write("collapsed.stl", triangles));
  BOOST_TEST(status == 2);
  check_told("no chart for 1 face, the first is face 49: DEGENERATE_FACE");
  BOOST_TEST(json().get<int>("triangles") == 48);
  BOOST_TEST(json().get<std::string>("status") == "SOMETHING_SKIPPED");
  BOOST_TEST(json().get_child("skipped").size() == 1u);
  BOOST_TEST(!obj().empty());
}

BOOST_AUTO_TEST_CASE(orientation_is_repaired)
{
  for(const std::size_t turned : {0u, 1u, 47u}) {
    BOOST_TEST_INFO_SCOPE(turned);
    std::vector<std::vector<int>> faces = Sheet().faces();
    std::swap(faces[turned][1], faces[turned][2]);
    flatten(write("orientation.off", off(Sheet().vertices(), Sheet().points(), faces)));
    BOOST_TEST(status == 0);
    const std::string told = "1 face turned; the first is face " + std::to_string(turned + 1);
    check_told(told);
    BOOST_TEST(json().get<int>("triangles") == 48);
    BOOST_TEST(json().get<int>("components") == 1);
  }
}

BOOST_AUTO_TEST_CASE(bow_tie_is_repaired)
{
  flatten(write("bow_tie.off", "OFF\n5 2 0\n0 0 0\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n3 0 1 2\n3 0 3 4\n"));
  BOOST_TEST(status == 0);
  check_told("separated at 1 vertex, for example at vertex 1");
  BOOST_TEST(json().get<int>("components") == 2);
  BOOST_TEST(lines_with(obj(), "v").size() == 5u);       // as in the file
  BOOST_TEST(lines_with(obj(), "vt").size() == 3u + 1u); // and one for faces without coordinates
}

BOOST_AUTO_TEST_CASE(layouts_are_named)
{
  const std::string input = write("sheet.off", off(Sheet()));
  flatten(input, "--layout exact");
  BOOST_TEST(json().get<std::string>("layout") == "exact");
  flatten(input, "--layout least-squares");
  BOOST_TEST(json().get<std::string>("layout") == "least-squares");
}

BOOST_AUTO_TEST_CASE(verbose_tells_steps)
{
  flatten(write("sheet.off", off(Sheet())), "--verbose");
  BOOST_TEST(status == 0);
  BOOST_TEST(lines_with(standard_error, "step").size() == json().get<std::size_t>("iterations"));
  check_told("layout");
}

BOOST_AUTO_TEST_CASE(help_explains_every_option)
{
  run("--help");
  BOOST_TEST(status == 0);
  BOOST_TEST(standard_error == "");
  for(const std::string& option :
      parts_of("input|output|svg|picture|json|component|border|method|barrier|layout|tolerance|"
               "max-iterations|step|solver|verbose|help|cut|stretch-bound|seams-to|split-overlaps|"
               "injective|area-weight|clearance|equal-seams|rectangle|border-angles|plain|separate|"
               "seams-from|charts-from-materials|no-pack|units|resolution|gutter|rotations|threads|"
               "quiet|format|cones|cone-angle-multiple|weld|unique-instances|up|repair|mip-levels|for|"
               "isometric|seam-price|block|texels-per-unit|chart-image|triangles|ply-coordinates|texture|"
               "placeholder-texture|quantize"))
    check_printed("--" + std::string(option));
}

BOOST_AUTO_TEST_CASE(version)
{
  run("--version");
  BOOST_TEST(status == 0);
  BOOST_TEST(standard_output.compare(0, 15, "flatten_mesh 0.") == 0);
}

BOOST_AUTO_TEST_CASE(names_with_blanks_and_quotes)
{
  fs::create_directory(path / "a \"b\"");
  const std::string input = write("a \"b\"/sheet 1.off", off(Sheet()));
  flatten(input);
  check_success();
  BOOST_TEST(json().get<std::string>("input") == input);
}

BOOST_AUTO_TEST_CASE(an_overlap_is_told_with_both_ways_to_get_rid_of_it)
{
  const std::string input = write("spiral.off", spiral());
  flatten(input);
  BOOST_TEST(status == 0);
  BOOST_TEST(json().get<std::string>("border") == "not simple");
  BOOST_TEST(json().get<std::string>("injective") == "false");
  BOOST_TEST(json().get<std::string>("contact") == "null");
  BOOST_TEST(json().get_child("notes").size() == 1u);
  BOOST_TEST(lines_of(standard_error).size() == 1u);
  check_told("--injective");
  check_told("--split-overlaps");
  check_printed("contact", false);

  flatten(input, "--split-overlaps");
  check_success();
  flatten(write("sheet.off", off(Sheet())));
  check_success();
}

BOOST_AUTO_TEST_CASE(maps_are_injective_by_each_method)
{
  const std::string input = write("spiral.off", spiral());
  for(const std::string options : {"--injective", "--injective --polish", "--injective --method hierarchical",
                                   "--injective --method direct", "--injective --area-weight 0",
                                   "--injective --area-weight 1", "--injective --clearance 0.05"}) {
    BOOST_TEST_INFO_SCOPE(options);
    flatten(input, options);
    check_success();
    const auto tree = json();
    const bool is_direct = options.find("direct") != std::string::npos;
    BOOST_TEST(tree.get<std::string>("border") == "simple");
    BOOST_TEST(tree.get<std::string>("injective") == "true");
    BOOST_TEST(tree.get<std::string>("method") == (is_direct ? "direct" : "hierarchical"));
    BOOST_TEST((tree.get<std::string>("strategy") == "injective descent") == is_direct);
    BOOST_TEST(tree.get<double>("contact") >= 0);
    BOOST_TEST(tree.get<double>("contact") <= 1);
    BOOST_TEST(tree.get<int>("border_rejections") >= 0);
    if(tree.get<std::string>("least_clearance") != "null")
      BOOST_TEST(tree.get<double>("least_clearance") > 0);
    for(const char* line : {"\ncontact ", "\nleast clearance "})
      check_printed(line);
    check_printed(is_direct ? "injective descent" : "injective on each level");
    // whether it converged or not: the border of this map is in contact with itself
    check_printed("; polished", options.find("--polish") != std::string::npos);
  }
}

BOOST_AUTO_TEST_CASE(where_the_hierarchical_method_starts)
{
  flatten(dinosaur(), "--method hierarchical --fallbacks off");
  check_success();
  BOOST_TEST(json().get<std::string>("start") == "COARSE_PARAMETERIZER");
  BOOST_TEST(json().get_child("failed_coarse_charts").empty());
  flatten(dinosaur(), "--method direct");
  BOOST_TEST(json().get<std::string>("start") == "null");
}

// Where nothing overlaps, --injective does not change the map of the direct method.
BOOST_AUTO_TEST_CASE(an_injective_direct_map_is_left_alone)
{
  flatten(dinosaur(), "--method direct");
  const std::string flat = obj();
  flatten(dinosaur(), "--method direct --injective");
  check_success();
  BOOST_TEST(obj() == flat);
  BOOST_TEST(json().get<std::string>("injective") == "true");
  BOOST_TEST(json().get<double>("contact") == 0);
  BOOST_TEST(json().get<std::string>("strategy") == "from target angles");
}

BOOST_AUTO_TEST_CASE(a_larger_area_weight_keeps_areas_better)
{
  std::vector<double> area_distortions;
  for(const std::string weight : {"0", "1"}) {
    flatten(dinosaur(), "--injective --area-weight " + weight);
    check_success();
    area_distortions.push_back(json().get<double>("l2_area_distortion"));
  }
  BOOST_TEST(area_distortions[1] < area_distortions[0]);
}

BOOST_AUTO_TEST_CASE(holes_of_injective_maps_are_filled_or_refused)
{
  Sheet sheet;
  sheet.holes = {7, 16};
  const std::string input = write("sheet.off", off(sheet));
  for(const std::string options :
      {"", " --holes fill", " --method direct", " --method direct --holes fill"}) {
    flatten(input, "--injective" + options);
    check_success();
    BOOST_TEST(json().get<int>("borders") == 3, options);
    BOOST_TEST(json().get<std::string>("injective") == "true", options);
  }
  fs::remove(file("flat.obj"));
  fs::remove(file("flat.svg"));
  flatten(input, "--injective --holes refuse");
  check_refusal({"SEVERAL_BORDERS"});
}

BOOST_AUTO_TEST_CASE(wrong_values_of_injective_maps_name_the_option)
{
  const std::string input = write("sheet.off", off(Sheet()));
  for(const std::string option : {"--area-weight", "--clearance"}) {
    for(const std::string value : {"-0.1", "1.1", "nan", "inf", "x"}) {
      BOOST_TEST_INFO_SCOPE(option << " " << value);
      flatten(input, "--injective " + option + "=" + value);
      check_refusal({option.substr(2)});
    }
    flatten(input, option + " 0.5");
    check_refusal({option, "--injective"});
  }
  flatten(input, "--injective --clearance 0");
  check_refusal({"--clearance"});
  flatten(input, "--injective --split-overlaps");
  check_refusal({"--injective", "--split-overlaps"});
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_FIXTURE_TEST_SUITE(of_large_surfaces, Plain_folder)

// As --help says: at most 20 % above the energy of the direct method.
BOOST_AUTO_TEST_CASE(auto_on_terrains)
{
  for(const double noise : {0., 0.3, 1.5}) {
    BOOST_TEST_INFO_SCOPE("noise of " << noise);
    const std::string input = write("terrain.off", terrain(noise));
    run(quoted(input) + " --method direct --json " + quoted(file("flat.json")));
    const double least = json().get<double>("energy");
    run(quoted(input) + " --json " + quoted(file("flat.json")));
    BOOST_TEST(json().get<std::string>("method") == "hierarchical");
    BOOST_TEST(json().get<double>("energy") >= 0.99 * least);
    BOOST_TEST(json().get<double>("energy") <= 1.2 * least);
    BOOST_TEST(json().get_child("notes").size() == 0u);
  }
  // What is too coarse is noticed.
  run(quoted(file("terrain.off")) + " --angle-sweeps 1 --json " + quoted(file("flat.json")));
  BOOST_TEST(json().get<std::string>("method") == "direct");
  BOOST_TEST(json().get_child("notes").size() == 1u);
  check_told("direct");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_FIXTURE_TEST_SUITE(seams, Plain_folder)

// Each corner of the plane at its vertex of the surface, and nothing overlaps
BOOST_AUTO_TEST_CASE(maps_along_seams_are_injective)
{
  const std::string seams = file("dinosaur.selection.txt");
  flatten(dinosaur(), "--stretch-bound 1.05 --injective --seams-to " + quoted(seams));
  BOOST_TEST(status == 0);
  BOOST_TEST(json().get<std::string>("injective") == "true");
  BOOST_TEST(json().get<std::string>("border") == "simple");
  BOOST_TEST(json().get<double>("contact") > 0);
  BOOST_TEST(json().get<double>("least_clearance") > 0);
  BOOST_TEST((edges_in(content(seams)) == edges_with_two_textures(obj())));
  const double energy = json().get<double>("angular_distortion");

  flatten(dinosaur(), "--injective --polish --cut " + quoted(seams));
  check_success();
  BOOST_TEST(json().get<std::string>("border") == "simple");
  BOOST_TEST(json().get<double>("angular_distortion") < energy);

  // A closed surface, and one of several components
  flatten(write("sphere.off", sphere().text()), "--injective");
  check_success();
  BOOST_TEST(json().get<std::string>("injective") == "true");
}

// The input's vertices and faces in their order, and two texture coordinates exactly along the seams.
BOOST_AUTO_TEST_CASE(closed_surfaces_are_cut)
{
  for(const Block& block : {cube(), sphere(), ring(), two_rings()}) {
    BOOST_TEST_INFO_SCOPE(block.text());
    const std::string seams = file("block.selection.txt"), input = write("block.off", block.text());
    flatten(input, "--seams-to " + quoted(seams));
    check_success();
    const auto tree = json();
    BOOST_TEST(tree.get<int>("borders") == 1);
    BOOST_TEST(tree.get<std::string>("seams.cut") == "auto");
    BOOST_TEST(tree.get<int>("seams.terminals") > 1);
    BOOST_TEST(tree.get<int>("seams.disks") == 1);
    BOOST_TEST(tree.get<double>("seams.stretch_bound") == 1.1);
    BOOST_TEST(tree.get<double>("seams.scale_stretch") >= 1);
    BOOST_TEST(tree.get<double>("seams.scale_stretch") <= 1.14);
    BOOST_TEST(tree.get<bool>("seams.bound_reached"));
    BOOST_TEST(tree.get<double>("seams.predicted_stretch") >= 1);
    BOOST_TEST(tree.get<double>("seams.length") > 0.5);
    BOOST_TEST(tree.get<double>("seconds.seams") >= 0);
    check_printed("terminals");
    check_printed("scale stretch");
    BOOST_TEST(count_in_svg(content(file("flat.svg")), "stroke:rgb(100%,0%,0%)") == 1u); // the first seam

    std::vector<bool> has_texture;
    BOOST_TEST((obj_faces(obj(), has_texture) == block.faces));
    BOOST_TEST((std::count(has_texture.begin(), has_texture.end(), false) == 0));
    const Lines lines = lines_of(block.text());
    const auto points = lines.begin() + 2, end = points + static_cast<std::ptrdiff_t>(block.places.size());
    BOOST_TEST(numbers(lines_with(obj(), "v")) == numbers(Lines(points, end)),
               boost::test_tools::per_element());
    BOOST_TEST(lines_with(obj(), "vt").size() == tree.get<std::size_t>("vertices"));
    BOOST_TEST(lines_with(obj(), "vt").size() > block.places.size());
    BOOST_TEST(edges_in(content(seams)).size() > 1u);
    BOOST_TEST((edges_with_two_textures(obj()) == edges_in(content(seams))));

    const std::string flat = obj();
    flatten(input, "--cut " + quoted(seams));
    check_success();
    BOOST_TEST(obj() == flat);
    BOOST_TEST(json().get<double>("seams.length") == tree.get<double>("seams.length"));
    BOOST_TEST(json().get<std::string>("seams.terminals") == "null");
  }
}

// The corners of a piece have texture coordinates of their own, which have not changed.
BOOST_AUTO_TEST_CASE(overlaps_are_split)
{
  const auto coordinates = [this] {
    const Lines lines = lines_with(obj(), "vt");
    return std::set<std::string>(lines.begin(), lines.end());
  };
  flatten(dinosaur(), "--stretch-bound 1.05");
  check_success();
  BOOST_TEST(json().get<std::string>("border") == "not simple");
  BOOST_TEST(json().get<std::string>("split") == "null");
  const auto seams_before = edges_with_two_textures(obj());
  const auto coordinates_before = coordinates();
  std::vector<bool> has_texture;
  const auto faces = obj_faces(obj(), has_texture);

  const std::string seams = file("dinosaur.selection.txt");
  flatten(dinosaur(), "--stretch-bound 1.05 --split-overlaps --seams-to " + quoted(seams));
  check_success();
  const auto tree = json();
  BOOST_TEST(tree.get<int>("split.pieces") > 1);
  BOOST_TEST(tree.get<int>("split.overlapping_triangles") > 0);
  BOOST_TEST(tree.get<double>("split.added_seam_length") > 0);
  BOOST_TEST(tree.get<double>("split.extra_seam") > 0);
  BOOST_TEST(tree.get<double>("split.extra_seam") < 0.3);
  BOOST_TEST(tree.get<double>("seconds.split") >= 0);
  check_printed("pieces");
  BOOST_TEST((obj_faces(obj(), has_texture) == faces));
  BOOST_TEST((std::count(has_texture.begin(), has_texture.end(), false) == 0));
  BOOST_TEST((coordinates() == coordinates_before));
  const auto seams_after = edges_with_two_textures(obj());
  BOOST_TEST((edges_in(content(seams)) == seams_after));
  BOOST_TEST(seams_after.size() > seams_before.size());
  BOOST_TEST(std::includes(seams_after.begin(), seams_after.end(), seams_before.begin(), seams_before.end()));

  flatten(dinosaur());
  const std::string flat = obj();
  flatten(dinosaur(), "--split-overlaps");
  check_success();
  BOOST_TEST(obj() == flat);
  BOOST_TEST(json().get<int>("split.pieces") == 1);
}

// A strip of quadrangles that winds around twice, without seams before, is cut along edges of quadrangles.
BOOST_AUTO_TEST_CASE(overlaps_of_quadrangles_are_split)
{
  const int columns = 48;
  const std::string seams = file("strip.selection.txt"), input = write("strip.off", spiral(columns));
  flatten(input, "--split-overlaps --seams-to " + quoted(seams));
  check_success();
  const int pieces = json().get<int>("split.pieces");
  BOOST_TEST(pieces >= 2);
  BOOST_TEST(json().get<std::string>("seams") == "null");
  const Edges edges = edges_in(content(seams));
  BOOST_TEST(static_cast<int>(edges.size()) == pieces - 1);
  for(const auto& [v, w] : edges)
    BOOST_TEST(w == v + 1);
  BOOST_TEST((edges_with_two_textures(obj()) == edges));
  std::vector<bool> has_texture;
  BOOST_TEST(obj_faces(obj(), has_texture).size() == static_cast<std::size_t>(columns));
}

BOOST_AUTO_TEST_CASE(topology_only)
{
  for(const Block& block : {sphere(), ring(), two_rings()}) {
    BOOST_TEST_INFO_SCOPE(block.text());
    const std::string input = write("block.off", block.text());
    flatten(input);
    const auto tree = json();
    flatten(input, "--cut topology");
    check_success();
    BOOST_TEST(json().get<double>("seams.length") <= tree.get<double>("seams.length"));
    BOOST_TEST(json().get<std::string>("seams.predicted_stretch") == "null");
    BOOST_TEST(json().get<int>("seams.rounds") == 0);
  }
  Sheet sheet;
  sheet.holes = {7, 16};
  flatten(write("holes.off", off(sheet)), "--cut topology");
  check_success();
  BOOST_TEST(json().get<int>("borders") == 1);
  BOOST_TEST(json().get<double>("seams.length") > 0);
}

// Without seams nothing changes.
BOOST_AUTO_TEST_CASE(disks_are_left_alone)
{
  Sheet disk, annulus;
  annulus.holes = {7};
  for(const Sheet& sheet : {disk, annulus}) {
    const std::string input = write("sheet.off", off(sheet)), seams = file("sheet.selection.txt");
    flatten(input, "--cut none");
    const std::string flat = obj();
    flatten(input, "--seams-to " + quoted(seams));
    check_success();
    BOOST_TEST(obj() == flat);
    BOOST_TEST(json().get<std::string>("seams") == "null");
    BOOST_TEST(content(seams) == "\n\n\n");
    check_printed("seams", false);
  }
  flatten(write("disk.off", off(disk)), "--cut topology");
  BOOST_TEST(json().get<std::string>("seams") == "null");
}

// A crumpled sphere, each of whose vertices would have to be a terminal. Only `--cut auto` has a bound to miss.
BOOST_AUTO_TEST_CASE(a_missed_bound_is_told)
{
  Block block;
  block.length = block.width = block.height = 12;
  block.round = block.triangulated = true;
  block.noise = 0.5;
  const std::string input = write("crumpled.off", block.make().text()),
                    seams = file("crumpled.selection.txt");
  flatten(input, "--seams-to " + quoted(seams));
  BOOST_TEST(status == 0);
  BOOST_TEST(json().get<double>("seams.scale_stretch") > 1.03 * 1.1);
  BOOST_TEST(!json().get<bool>("seams.bound_reached"));
  BOOST_TEST(json().get<int>("seams.rounds") == 5); // also after one that gains little
  BOOST_TEST(json().get_child("notes").size() == (overlaps() ? 2u : 1u));
  check_told("note: the scale stretch, ");
  check_told("misses the bound of 1.1 ");
  for(const std::string& cut : {std::string("topology"), seams}) {
    flatten(input, "--cut " + quoted(cut));
    check_success();
    BOOST_TEST(json().get<double>("seams.scale_stretch") > 1.03 * 1.1);
    BOOST_TEST(json().get<std::string>("seams.bound_reached") == "null");
  }
}

BOOST_AUTO_TEST_CASE(largest_of_several_disks)
{
  Block block;
  block.length = 3;
  block.make();
  const auto vertex = [&block](const int j, const int k) { return block.vertex({1, j, k}); };
  const std::string seams = path_line({vertex(0, 0), vertex(1, 0), vertex(1, 1), vertex(0, 1), vertex(0, 0)});
  flatten(write("block.off", block.text()), "--cut " + quoted(write("ring.selection.txt", seams)));
  BOOST_TEST(status == 0);
  check_told("2 disks");
  check_told("18 of 28 triangles");
  BOOST_TEST(json().get<int>("seams.disks") == 2);
  BOOST_TEST(json().get<int>("components") == 1);
  std::vector<bool> has_texture;
  BOOST_TEST((obj_faces(obj(), has_texture) == block.faces));
  BOOST_TEST(std::count(has_texture.begin(), has_texture.end(), false) == 5);
}

// The component is cut, whatever else there is in the file.
BOOST_AUTO_TEST_CASE(closed_component)
{
  const Block block = ring();
  const Lines lines = lines_of(block.text());
  const int n = static_cast<int>(block.places.size());
  std::string points = "9 0 0\n9 1 0\n8 0 1\n";
  std::vector<std::vector<int>> faces = {{0, 1, 2}};
  for(int v = 0; v < n; ++v)
    points += lines[static_cast<std::size_t>(2 + v)] + "\n";
  for(const std::vector<int>& face : block.faces)
    faces.push_back({face[0] + 3, face[1] + 3, face[2] + 3});
  const std::string seams = file("seams.selection.txt");
  flatten(write("two.off", off(n + 3, points, faces)), "--seams-to " + quoted(seams));
  check_success();
  std::vector<bool> has_texture;
  BOOST_TEST((obj_faces(obj(), has_texture) == faces));
  BOOST_TEST(std::count(has_texture.begin(), has_texture.end(), false) == 1);
  BOOST_TEST(json().get<int>("components") == 2);
  BOOST_TEST((edges_with_two_textures(obj()) == edges_in(content(seams))));
}

#ifdef ABF_WITH_PNG
BOOST_AUTO_TEST_CASE(picture_shows_seams)
{
  run(quoted(write("sphere.off", sphere().text())) + " --picture " + quoted(file("flat.png")));
  BOOST_TEST(status == 0);
  const std::vector<Pixel> pixels = pixels_of(file("flat.png"));
  BOOST_TEST(std::count_if(pixels.begin(), pixels.end(), [](const Pixel& pixel) {
               return pixel[1] < 25; // the checkerboard has more green
             }) > 100);
}
#endif

BOOST_AUTO_TEST_SUITE_END()

BOOST_FIXTURE_TEST_SUITE(bad_input, Plain_folder)

BOOST_AUTO_TEST_CASE(missing_empty_or_damaged_files)
{
  flatten(file("missing.off"));
  check_refusal({"missing.off", "no file"});
  flatten(path.string());
  check_refusal({"folder"});
  for(const char* format : {"off", "obj", "ply", "stl", "ts"}) {
    BOOST_TEST_INFO_SCOPE(format);
    check_refused(std::string("empty.") + format, "", {"empty"});
    std::string garbage;
    for(unsigned i = 0, x = 1; i < 5000; ++i, x = x * 1103515245u + 12345u)
      garbage += static_cast<char>(x >> 16);
    check_refused(std::string("garbage.") + format, garbage, {"garbage."});
    check_refused(std::string("words.") + format, "these are no numbers\nbut words\n", {"words."});
  }
  check_refused("sheet.xyz", off(Sheet()), {"format", ".ply"});
  check_refused("no_extension", off(Sheet()), {"format"});
}

BOOST_AUTO_TEST_CASE(files_cut_short)
{
  const Sheet sheet;
  const std::string whole = off(sheet);
  check_refused("short.off", whole.substr(0, whole.size() / 2),
                {"short.off", "line 47", "the file ends here"});
  check_refused("short.off", whole.substr(0, whole.find('\n', whole.size() / 2) + 1),
                {"promises 35 vertices and 48 faces", "ends after line 47 with 35 and 10", "cut short"});
  const std::string square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n", header = "OFF\n# comment\n4 2 0\n\n";
  check_refused("absent.off", header + square + "3 0 1 2\n3 0 2 4\n",
                {"absent.off', line 10", "face 2", "vertex '4'"});
  check_refused("words.off", header + "0 0 0\n1 zero 0\n", {"line 6", "'zero'", "vertex 2"});
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
      "float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n";
  check_refused("sheet.ply", text + square + "3 0 1 2\n3 0 2 x\n", {"line 15", "face 2", "'x'"});
  check_refused("no_edges.off", "OFF\n3 1\n" + square, {"line 2", "numbers"});
  check_refused("headless.off", "3 1 0\n" + square, {"line 1", "begins with OFF"});
  check_refused("vertex.stl",
                "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0\nvertex 0 1 "
                "0\nendloop\nendfacet\nendsolid\n",
                {"line 5", "vertex 2", "fewer than three coordinates"});
  const std::string binary = ply(floats(sheet), sheet.faces());
  check_refused("short.ply", binary.substr(0, binary.size() - 40), {"short.ply"});
  check_refused("huge.off", "OFF\n4000000000000000000 4000000000000000000 0\n0 0 0\n", {"huge.off"});
}

BOOST_AUTO_TEST_CASE(no_faces)
{
  const Sheet sheet;
  check_refused("cloud.off", off(sheet.vertices(), sheet.points(), {}), {"cloud.off", "faces"});
}

BOOST_AUTO_TEST_CASE(wrong_lines_of_gocad)
{
  const std::string begin = "GOCAD TSurf 1\nHEADER {\nname: sheet\n}\nTFACE\nVRTX 1 0 0 0\nVRTX 2 1 0 0\n";
  check_refused("vertex.ts", begin + "VRTX 3 0 one 0\nTRGL 1 2 3\nEND\n", {"line 8", "'one'", "coordinate"});
  check_refused("short.ts", begin + "VRTX 3 0 1\nTRGL 1 2 3\nEND\n", {"line 8", "VRTX", "4 numbers"});
  check_refused("face.ts", begin + "VRTX 3 0 1 0\nTRGL 1 2 x\nEND\n", {"line 9", "'x'", "vertex number"});
}

BOOST_AUTO_TEST_CASE(numbers_that_are_none)
{
  const Sheet sheet;
  std::vector<float> coordinates = floats(sheet);
  coordinates[3 * 16 + 1] = std::numeric_limits<float>::quiet_NaN();
  check_refused("nan.ply", ply(coordinates, sheet.faces()), {"vertex 17", "finite"});
  coordinates[3 * 16 + 1] = std::numeric_limits<float>::infinity();
  check_refused("inf.ply", ply(coordinates, sheet.faces()), {"vertex 17", "finite"});
  check_refused("nan.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n3 0 2 3\n", {"line 5", "nan"});
  check_refused("nan.obj", "v 0 0 0\nv 1 0 0\nv 1 1 -inf\nf 1 2 3\n", {"line 3", "inf"});
}

BOOST_AUTO_TEST_CASE(wrong_faces)
{
  const Sheet sheet;
  const auto with = [&sheet](const std::vector<std::vector<int>>& more) {
    std::vector<std::vector<int>> faces = sheet.faces();
    faces.insert(faces.end(), more.begin(), more.end());
    return off(sheet.vertices() + 2, sheet.points() + "3 3 9\n4 4 9\n", faces);
  };
  const int more = sheet.vertices();
  check_refused("twice.off", with({{more, more + 1, more}}), {"face 49", "names vertex 36 (3, 3, 9) twice"});
  check_refused("short_face.off", with({{more, more + 1}}), {"short_face.off"});
  check_refused("absent.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n",
                {"absent.obj", "line 4", "vertex 4", "does not exist"});
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  check_refused("zero.obj", triangle + "f 0 1 2\n", {"line 4", "vertex 0"});
  check_refused("behind.obj", triangle + "\nf -1 -2 -4\n", {"line 5", "vertex -4"});
  check_refused("pair.obj", triangle + "f 1 2\n", {"line 4", "fewer than three"});
  check_refused("words.obj", triangle + "f one two three\n", {"line 4", "'one'"});
  check_refused("plane.obj", "v 0 0\n", {"line 1", "three coordinates"});
  check_refused("named_twice.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 3\n",
                {"line 5", "names vertex 3 twice"});
  check_refused("third.off", with({{0, 8, more}}),
                {"between vertex 1 (0, 0, 0) and vertex 9 (", "3 faces", "manifold"}, "--repair off");
  check_refused("turned.off", with({{1, 0, more}, {1, 0, more + 1}}),
                {"between vertex 1 (0, 0, 0) and vertex 2 ("}, "--repair off");
}

BOOST_AUTO_TEST_CASE(surfaces_joined_at_an_edge_are_separated)
{
  const std::string points = "0 0 0\n0 0 1\n1 0 0\n1 1 0\n-1 0 0\n-1 -1 0\n";
  std::vector<std::vector<int>> faces;
  for(const std::array<int, 4>& v : {std::array<int, 4>{0, 1, 2, 3}, std::array<int, 4>{0, 1, 4, 5}}) {
    faces.insert(faces.end(),
                 {{v[0], v[1], v[2]}, {v[0], v[2], v[3]}, {v[0], v[3], v[1]}, {v[1], v[3], v[2]}});
  }
  const std::string input = write("joined.off", off(6, points, faces));
  for(const std::string cut : {"auto", "topology"}) {
    flatten(input, "--repair off --cut " + cut);
    check_refusal({"between vertex 1 (0, 0, 0) and vertex 2 (0, 0, 1) has 4 faces"});
  }
  for(const std::string cut : {"auto", "topology"}) {
    flatten(input, "--cut " + cut);
    BOOST_TEST(status == 0);
    check_told("more than two faces meet at 1 edge");
    BOOST_TEST(json().get<int>("components") == 2);
    BOOST_TEST(json().get<int>("triangles") == 4);
  }
}

BOOST_AUTO_TEST_CASE(closed_surface)
{
  check_refused("cube.off", cube().text(), {"closed", "border", "--cut auto"}, "--cut none");
}

BOOST_AUTO_TEST_CASE(another_component_is_named)
{
  const std::string tetrahedron = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n", triangle = "3 4 5 6\n";
  check_refused("two.off",
                "OFF\n7 5 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n5 0 0\n6 0 0\n5 1 0\n" + tetrahedron + triangle,
                {"closed", "--component 1"}, "--cut none");
}

BOOST_AUTO_TEST_CASE(handle)
{
  Block block = ring();
  block.faces.pop_back();
  const std::string input = write("handle.off", block.text());
  run(quoted(input) + " --cut none --output " + quoted(file("flat.obj")));
  check_refusal({"NONZERO_GENUS", "handle", "--cut auto"});
  flatten(input, "--cut none");
  BOOST_TEST(status == 2);
  BOOST_TEST(json().get<std::string>("status") == "NONZERO_GENUS");
  BOOST_TEST(json().get<std::size_t>("triangles") == block.faces.size());
  BOOST_TEST(!fs::exists(file("flat.obj")));
  BOOST_TEST(!fs::exists(file("flat.svg")));
  flatten(input);
  check_success();
}

BOOST_AUTO_TEST_CASE(wrong_seams)
{
  const Block block = two_rings();
  const std::string input = write("block.off", block.text());
  const auto check = [&](const std::string& seams, const Lines& words) {
    flatten(input, "--cut " + quoted(write("wrong.selection.txt", seams)));
    check_refusal(words);
  };
  const auto vertex = [&block](const int i, const int j, const int k) { return block.vertex({i, j, k}); };
  const std::string around_end =
      path_line({vertex(1, 0, 0), vertex(1, 0, 1), vertex(1, 1, 1), vertex(1, 1, 0), vertex(1, 0, 0)});
  check("\n\n\n", {"wrong.selection.txt", "not leave disks", "100 triangles", "vertex", "no border"});
  check(around_end, {"not leave disks", "1 handle"});
  check(path_line({0, 1}), {"not leave disks"});
  check("", {"wrong.selection.txt"});
  check("\n\n0 one\n", {"wrong.selection.txt", "line 3", "one"});
  check("\n\n0 1 2\n", {"wrong.selection.txt", "line 3"});
  check("\n\n0 999\n", {"wrong.selection.txt", "line 3", "999"});
  check(path_line({vertex(0, 0, 0), vertex(5, 3, 1)}), {"no edge", "from 0"});
  check(path_line({vertex(0, 0, 0), vertex(1, 0, 1)}) + path_line({vertex(1, 0, 0), vertex(0, 0, 1)}),
        {"no edge", "from 0"}); // the diagonals of a quadrangle
  run(quoted(input) + " --cut " + quoted(file("absent.selection.txt")));
  check_refusal({"absent.selection.txt"});
  const std::string seams = write("kept.selection.txt", around_end);
  run(quoted(input) + " --cut " + quoted(seams) + " --seams-to " + quoted(seams));
  check_refusal({"overwrite"});
}

BOOST_AUTO_TEST_CASE(orientation)
{
  std::vector<std::vector<int>> faces = Sheet().faces();
  std::swap(faces[1][1], faces[1][2]);
  check_refused("orientation.off", off(Sheet().vertices(), Sheet().points(), faces),
                {"oriented differently", "faces 2 and 13", "vertex 8 (", "vertex 9 ("}, "--repair off");
}

BOOST_AUTO_TEST_CASE(bow_tie)
{
  check_refused("bow_tie.off", "OFF\n5 2 0\n0 0 0\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n3 0 1 2\n3 0 3 4\n",
                {"vertex 1", "manifold"}, "--repair off");
  const std::string points = "OFF\n6 4 0\n1 0 1\n1 0 0\n0 1 0\n-1 -1 0\n0 0 1\n0 0 0\n";
  const std::string fan = "3 5 1 2\n3 5 2 3\n3 5 3 1\n", flag = "3 5 4 0\n";
  for(const std::string& faces : {fan + flag, flag + fan})
    check_refused("flag.off", points + faces, {"vertex 6", "manifold"}, "--repair off");
}

// For every orientation of the faces, and every first face.
BOOST_AUTO_TEST_CASE(one_sided)
{
  const int n = 12;
  std::ostringstream points;
  std::vector<std::vector<int>> faces;
  for(int i = 0; i < n; ++i) {
    const double a = 2 * std::acos(-1.) * i / n, r = 0.5 * std::cos(a / 2);
    for(const int side : {-1, 1}) {
      points << (3 + side * r) * std::cos(a) << ' ' << (3 + side * r) * std::sin(a) << ' '
             << side * 0.5 * std::sin(a / 2) << '\n';
    }
    const int b = 2 * i, c = b + 1, d = i + 1 < n ? b + 2 : 1, e = i + 1 < n ? b + 3 : 0;
    faces.push_back({b, d, e});
    faces.push_back({b, e, c});
  }
  flatten(write("strip.off", off(2 * n, points.str(), faces)));
  BOOST_TEST(status == 0);
  check_told("the surface is one-sided, like a Moebius strip: it is cut along 1 edge");
  BOOST_TEST(json().get<int>("triangles") == 2 * n);
  BOOST_TEST(json().get<int>("flipped_triangles") == 0);
}

// A sheet, and triangles that are attached to it as third ones at some of its edges
BOOST_AUTO_TEST_CASE(flaps_are_separated)
{
  const Sheet sheet;
  std::vector<std::vector<int>> faces = sheet.faces();
  const std::size_t number = faces.size();
  for(const std::size_t f : {5u, 20u, 30u})
    faces.push_back({faces[f][0], faces[f][1], sheet.vertices()});
  const std::string input = write("flaps.off", off(sheet.vertices() + 1, sheet.points() + "2 2 5\n", faces));
  flatten(input, "--repair off");
  check_refusal({"has 3 faces, so the surface is not a manifold"});
  flatten(input);
  BOOST_TEST(status == 0);
  check_told("more than two faces meet at 3 edges");
  BOOST_TEST(json().get<std::size_t>("triangles") == number);
}

// Half of a wheel: all faces share its hub, and are then added together.
BOOST_AUTO_TEST_CASE(hub)
{
  const int n = 100000;
  std::ostringstream points;
  points << "0 0 0\n";
  std::vector<std::vector<int>> faces;
  for(int i = 0; i <= n; ++i) {
    const double angle = std::acos(-1.) * i / n;
    points << std::cos(angle) << ' ' << std::sin(angle) << " 0\n";
    if(i < n)
      faces.push_back({0, i + 1, i + 2});
  }
  flatten(write("hub.off", off(n + 2, points.str(), faces)), "--method direct");
  check_success();
  BOOST_TEST(json().get<int>("triangles") == n);
}

BOOST_AUTO_TEST_CASE(component_and_border_out_of_range)
{
  const std::string input = write("sheet.off", off(Sheet()));
  flatten(input, "--component 1");
  check_refusal({"component 1", "1 component"});
  flatten(input, "--border 7");
  check_refusal({"border 7", "1 border"});
}

BOOST_AUTO_TEST_CASE(unwritable_output)
{
  const std::string input = write("sheet.off", off(Sheet()));
  for(const std::string option : {"output .obj", "svg .svg", "json .json"}) {
    BOOST_TEST_INFO_SCOPE(option);
    const std::string name = " --" + option.substr(0, option.find(' ')) + " ";
    const std::string extension = option.substr(option.find(' ') + 1);
    run(quoted(input) + name + quoted(file("absent/flat" + extension)));
    check_refusal({"cannot write", "absent/flat"});
    run(quoted(input) + name + quoted(path.string()));
    check_refusal({"cannot write", "folder"});
    run(quoted(input) + name + "''");
    check_refusal({"empty"});
    run(quoted(input) + name + quoted(file("flat.off")));
    check_refusal({"flat.off", "--output .obj", "--svg .svg", "--picture .png", "--json .json"});
  }
  run(quoted(input) + " --output " + quoted(file("flat.obj")) + " --svg " + quoted(file("absent/flat.svg")));
  check_refusal({"cannot write"});
  run(quoted(input) + " --output " + quoted(file("flat.OBJ")));
  BOOST_TEST(status == 0);
  BOOST_TEST(content(input) == off(Sheet()));
}

// By any path, also through links, and before anything is computed: there is no input.
BOOST_AUTO_TEST_CASE(outputs_that_are_one_file)
{
  fs::create_directory(path / "folder");
  fs::create_directory_symlink(path / "folder", path / "link");
  fs::create_symlink("folder/absent", path / "dangling");
  const std::string input = write("sheet.obj", obj_input(Sheet()));
  fs::create_hard_link(input, path / "hard.obj");
  fs::create_symlink("sheet.obj", path / "soft.obj");
  for(const char* name : {"sheet.obj", "hard.obj", "soft.obj", "folder/../sheet.obj"}) {
    BOOST_TEST_INFO_SCOPE(name);
    run(quoted(input) + " --output " + quoted(file(name)));
    check_refusal({"overwrite the input"});
  }
  const auto check_pair = [this](const std::string& a, const std::string& b) {
    BOOST_TEST_INFO_SCOPE(a << " and " << b);
    run("absent.obj --output " + quoted(a) + " --svg " + quoted(b));
    check_refusal({"are the same"});
  };
  check_pair(file("flat"), file("flat"));
  check_pair(file("flat"), file("folder/../flat"));
  check_pair(file("folder/flat"), file("link/flat"));
  check_pair(file("dangling"), file("link/absent"));
  check_pair("-", "-");
  write("a", "");
  fs::create_hard_link(path / "a", path / "b");
  check_pair(file("a"), file("b"));
  BOOST_TEST(content(input) == obj_input(Sheet()));
}

BOOST_AUTO_TEST_CASE(standard_output_as_file)
{
  const std::string input = write("sheet.off", off(Sheet()));
  run(quoted(input) + " --output -");
  BOOST_TEST(status == 0);
  BOOST_TEST(lines_with(standard_output, "vt").size() == 35u);
  check_printed("seconds", false);
  check_told("angle change");
  run(quoted(input) + " --json -");
  BOOST_TEST(status == 0);
  BOOST_TEST(standard_output.compare(0, 18, "{\n  \"status\": \"OK\"") == 0);
  run("absent.off --json -");
  BOOST_TEST(status == 2);
  BOOST_TEST(standard_output.compare(0, 18, "{\n  \"status\": \"WRO") == 0);
#ifdef __linux__
  run(quoted(input) + " --output /dev/fd/9 9>&1 | cat");
  BOOST_TEST(lines_with(standard_output, "vt").size() == 35u);
  for(const std::string& arguments : {quoted(input), quoted(input) + " --output -", std::string("--help")}) {
    BOOST_TEST_INFO_SCOPE(arguments);
    run(arguments + " --json " + quoted(file("flat.json")) + " --svg " + quoted(file("flat.svg")),
        "/dev/full");
    BOOST_TEST(status == 2);
    check_told("cannot write to standard output");
    BOOST_TEST(!fs::exists(file("flat.svg")));
  }
  BOOST_TEST(json().get<std::string>("status") == "CANNOT_WRITE");
#endif
}

BOOST_AUTO_TEST_CASE(read_only_output_is_kept)
{
  const std::string input = write("sheet.off", off(Sheet())), kept = write("kept.obj", "kept");
  fs::permissions(kept, fs::perms::owner_read);
  run(quoted(input) + " --output " + quoted(kept));
  check_refusal({"kept.obj", "read-only"});
  BOOST_TEST(content(kept) == "kept");
}

BOOST_AUTO_TEST_CASE(interrupted)
{
  check_interrupted(write("sheet.off", off(Sheet())));
}

#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__)
// Solvers do not say why they failed. Threads that wait for memory do not block the end of the program. Some versions of
// OpenBLAS never end if their own memory does not fit, and so the limits are above what the program has in any case.
BOOST_AUTO_TEST_CASE(memory_limits)
{
  const std::string json = file("flat.json"), errors = file("stderr");
  const auto run_within = [&](const int kilobytes, const int seconds, const std::string& arguments) {
    const std::string command = "export OPENBLAS_NUM_THREADS=2; ulimit -v " + std::to_string(kilobytes) +
                                "; timeout -s KILL " + std::to_string(seconds) + " " + quoted(program()) +
                                " " + arguments + " > /dev/null 2> " + quoted(errors);
    return std::system(command.c_str());
  };
  int least = 40000;
  while(least < 4000000 && run_within(least, 2, "--version") != 0)
    least += 40000;
  for(const int more : {10000, 40000}) {
    BOOST_TEST_INFO_SCOPE(least << " + " << more);
    const int result =
        run_within(least + more, 60, "--plain " + quoted(dinosaur()) + " --json " + quoted(json));
    BOOST_TEST(WIFEXITED(result));
    standard_error = content(errors);
    BOOST_TEST(WEXITSTATUS(result) == 4, standard_error);
    check_told("not enough memory");
    BOOST_TEST((content(json).find("not enough memory") != std::string::npos));
    fs::remove(json);
  }
}
#endif

BOOST_AUTO_TEST_CASE(surfaces_without_area)
{
  Sheet sheet;
  const auto check = [this, &sheet](const char* name, const char* step) {
    std::string points;
    for(int i = 0; i < sheet.vertices(); ++i) {
      std::ostringstream number;
      number << 0.1 * i;
      points += step[0] == '0' ? "1 2 3\n" : number.str() + " " + number.str() + " " + step + "\n";
    }
    flatten(write(name, off(sheet.vertices(), points, sheet.faces())));
    BOOST_TEST(status == 2);
    check_told("the surface has no area: all " + std::to_string(sheet.faces().size()) + " triangles");
    BOOST_TEST(json().get<std::string>("status") == "NO_AREA");
    BOOST_TEST(!fs::exists(file("flat.obj")));
  };
  check("point.off", "0");
  check("line.off", "7");

  flatten(write("corner.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n2 0 0\n3 0 1 2\n3 1 0 3\n"));
  BOOST_TEST(status == 0);
  check_told("1 triangle of 2 without area");
}

BOOST_AUTO_TEST_CASE(wrong_usage)
{
  const std::string input = write("sheet.off", off(Sheet()));
  for(const std::string& options :
      parts_of("--unknown|--outp x.obj|--barrier|--barrier -1|--barrier=-1|--barrier nan|--barrier x|"
               "--tolerance 0|--tolerance inf|--max-iterations=-1|--max-iterations 1.5|--component -1|"
               "--component=-1|--border=-1|--layout round|--step big|--solver none|--method best|"
               "--rate 0.9|--simplification-rate 1|--holes shut|second.off|--sweeps 1000000000|"
               "--angle-sweeps 1001|--tolerance 1e-300|--threads 1000000000|--repair maybe|--cut open|"
               "--cut ''|--cut none --stretch-bound 1.2|--stretch-bound 0.9|--stretch-bound nan|"
               "--seams-to seams.txt|--injective --split-overlaps")) {
    BOOST_TEST_INFO_SCOPE(options);
    flatten(input, options);
    check_refusal({"flatten_mesh: "});
  }
  run("");
  check_refusal({"no input", "--help"});
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
