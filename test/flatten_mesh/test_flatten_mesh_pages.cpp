// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The program `flatten_mesh` with pages of any shape and number, and with images of charts.

#include "run_flatten_mesh.h"

BOOST_AUTO_TEST_SUITE(test_flatten_mesh_pages)

using Place = std::array<double, 2>;

// Flat squares with sides of length 1, apart from each other
inline std::string squares(const int number)
{
  std::string points;
  std::vector<std::vector<int>> faces;
  for(int i = 0; i < number; ++i) {
    for(const auto& [x, y] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}})
      points += std::to_string(2 * i + x) + " " + std::to_string(y) + " 0\n";
    faces.push_back({4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3});
  }
  return off(4 * number, points, faces);
}

struct Pages_folder : public Folder
{
  boost::property_tree::ptree packing() const { return json().get_child("atlas.packing"); }

  // Each face is a square with this side, where both coordinates are multiplied by these factors first.
  void check_squares(const double side, const Place& factors) const
  {
    for(const std::vector<Place>& face : texture_of_faces(obj())) {
      BOOST_REQUIRE_EQUAL(face.size(), 4u);
      for(std::size_t i = 0; i < 4; ++i) {
        const Place &p = face[i], &q = face[(i + 1) % 4], &r = face[(i + 2) % 4];
        const double x = factors[0] * (q[0] - p[0]), y = factors[1] * (q[1] - p[1]);
        BOOST_TEST(std::hypot(x, y) == side, boost::test_tools::tolerance(1e-9));
        BOOST_TEST(std::abs(x * factors[0] * (r[0] - q[0]) + y * factors[1] * (r[1] - q[1])) <
                   1e-9 * side * side);
      }
    }
  }

  void check_refused(const std::string& input, const std::string& options, const Lines& words)
  {
    BOOST_TEST_INFO_SCOPE(options);
    for(const char* name : {"flat.obj", "flat.svg", "flat.json"}) // of runs before
      fs::remove(file(name));
    flatten(input, options);
    check_refusal(words);
  }
};

#ifdef ABF_WITH_PNG
// Of each colour with full opacity: the number of texels. All other texels are transparent.
inline std::map<std::array<png_byte, 4>, int> texels_of_colors(const std::string& png_file, const int width,
                                                               const int height)
{
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  BOOST_REQUIRE(png_image_begin_read_from_file(&image, png_file.c_str()) != 0);
  BOOST_TEST(image.width == static_cast<png_uint_32>(width));
  BOOST_TEST(image.height == static_cast<png_uint_32>(height));
  image.format = PNG_FORMAT_RGBA;
  std::vector<std::array<png_byte, 4>> pixels(PNG_IMAGE_SIZE(image) / 4);
  BOOST_REQUIRE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr) != 0);
  std::map<std::array<png_byte, 4>, int> texels;
  for(const std::array<png_byte, 4>& pixel : pixels) {
    BOOST_TEST((pixel[3] == 0 || pixel[3] == 255));
    if(pixel[3] == 255)
      ++texels[pixel];
  }
  return texels;
}
#endif

BOOST_FIXTURE_TEST_SUITE(pages, Pages_folder)

// Two squares of 50 texels are on each page of 128 by 64.
BOOST_AUTO_TEST_CASE(density_and_pages)
{
  const std::string input = write("squares.off", squares(24));
  flatten(input, "--texels-per-unit 50 --resolution 128x64");
  BOOST_TEST(status == 0, standard_error);
  BOOST_TEST(packing().get<int>("pages") == 12);
  BOOST_TEST(packing().get<int>("resolution") == 128);
  BOOST_TEST(packing().get<int>("height") == 64);
  BOOST_TEST(packing().get<double>("texels_per_unit") == 50, boost::test_tools::tolerance(1e-9));
  check_printed("12 pages");
  check_squares(50, {128, 64});
  std::map<int, int> squares_of_pages, charts_of_pages;
  for(const std::vector<Place>& face : texture_of_faces(obj()))
    ++squares_of_pages[static_cast<int>(face[0][0]) + 10 * static_cast<int>(face[0][1])];
  const auto charts = json().get_child("atlas.charts");
  for(const auto& chart : charts)
    ++charts_of_pages[chart.second.get<int>("page")];
  BOOST_TEST((squares_of_pages == charts_of_pages));
  BOOST_TEST(squares_of_pages.size() == 12u);
  BOOST_TEST(count_in_svg(content(path / "flat.svg"), "stroke:rgb(60%,60%,60%)") == 12u);

  flatten(input, "--texels-per-unit 50 --resolution 128x64 --units world");
  BOOST_TEST(status == 0, standard_error);
  check_squares(1, {1, 1});
}

// Whatever the density, a page is the unit square, and squares stay squares in texels.
BOOST_AUTO_TEST_CASE(one_page_of_any_shape)
{
  const std::string input = write("squares.off", squares(7));
  for(const auto& [size, width, height] :
      {std::tuple("256x64", 256, 64), {"96x128", 96, 128}, {"128", 128, 128}}) {
    flatten(input, std::string("--block 4 --gutter 3 --resolution ") + size);
    BOOST_TEST(status == 0, standard_error);
    BOOST_TEST(packing().get<int>("pages") == 1);
    BOOST_TEST(packing().get<int>("block") == 4);
    check_squares(packing().get<double>("texels_per_unit"), {1. * width, 1. * height});
    std::map<std::pair<int, int>, std::set<std::size_t>> squares_of_blocks;
    const auto faces = texture_of_faces(obj());
    for(std::size_t f = 0; f < faces.size(); ++f) {
      for(const Place& p : faces[f]) {
        BOOST_TEST((p[0] > 0 && p[0] < 1 && p[1] > 0 && p[1] < 1));
        squares_of_blocks[{static_cast<int>(p[0] * width / 4), static_cast<int>(p[1] * height / 4)}].insert(
            f);
      }
    }
    for(const auto& [block, owners] : squares_of_blocks)
      BOOST_TEST(owners.size() == 1u);
  }
}

BOOST_AUTO_TEST_CASE(large_surfaces_are_cut_for_pages)
{
  flatten(dinosaur(), "--for few-charts");
  BOOST_TEST(status == 0);
  const double texels = 4 * packing().get<double>("texels_per_unit");
  const std::size_t charts = json().get_child("atlas.charts").size();
  flatten(dinosaur(), "--for few-charts --texels-per-unit " + std::to_string(texels));
  BOOST_TEST(status == 0, standard_error);
  BOOST_TEST(packing().get<int>("pages") > 10);
  BOOST_TEST(json().get_child("atlas.charts").size() > charts + 5);
  BOOST_TEST(json().get<int>("atlas.flipped_triangles") == 0);
}

#ifdef ABF_WITH_PNG
BOOST_AUTO_TEST_CASE(images_of_charts)
{
  const std::string input = write("squares.off", squares(3));
  flatten(input,
          "--texels-per-unit 50 --resolution 128x64 --chart-image " + quoted(file("charts.<UDIM>.png")));
  BOOST_TEST(status == 0, standard_error);
  for(const auto& [name, number] : {std::pair("charts.1001.png", 2u), {"charts.1002.png", 1u}}) {
    const auto texels = texels_of_colors(file(name), 128, 64);
    BOOST_TEST(texels.size() == number);
    for(const auto& [color, count] : texels) {
      BOOST_TEST(count >= 50 * 50);
      BOOST_TEST(count <= 52 * 52);
    }
    check_printed(name);
  }
  BOOST_TEST(!fs::exists(file("charts.1003.png")));

  flatten(input, "--chart-image " + quoted(file("charts.png")));
  BOOST_TEST(texels_of_colors(file("charts.png"), 1024, 1024).size() == 3u);

  // The first rows of the image are those with the largest v.
  flatten(write("square.off", squares(1)),
          "--texels-per-unit 20 --resolution 64 --chart-image " + quoted(file("charts.png")));
  const auto face = texture_of_faces(obj()).front();
  int left = 64, top = 64;
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  BOOST_REQUIRE(png_image_begin_read_from_file(&image, file("charts.png").c_str()) != 0);
  image.format = PNG_FORMAT_RGBA;
  std::vector<png_byte> bytes(PNG_IMAGE_SIZE(image));
  BOOST_REQUIRE(png_image_finish_read(&image, nullptr, bytes.data(), 0, nullptr) != 0);
  for(int i = 0; i < 64 * 64; ++i) {
    if(bytes[static_cast<std::size_t>(4 * i + 3)] != 0) {
      left = (std::min)(left, i % 64);
      top = (std::min)(top, i / 64);
    }
  }
  double smallest_u = 1, largest_v = 0;
  for(const Place& p : face) {
    smallest_u = (std::min)(smallest_u, p[0]);
    largest_v = (std::max)(largest_v, p[1]);
  }
  BOOST_TEST(left == static_cast<int>(64 * smallest_u));
  BOOST_TEST(top == static_cast<int>(64 * (1 - largest_v)));

  const std::string several = "--texels-per-unit 50 --resolution 128x64 ";
  check_refused(input, several + "--chart-image " + quoted(file("flat.png")), {"2 pages", "<UDIM>"});
  check_refused(input,
                several + "--picture " + quoted(file("flat.1002.png")) + " --chart-image " +
                    quoted(file("flat.<UDIM>.png")),
                {"same file"});
  for(const std::string option : {"--no-pack", "--units world", "--plain"})
    check_refused(input, option + " --chart-image " + quoted(file("flat.png")), {"--chart-image"});
  check_refused(input, several + "--bake-from " + quoted(input), {"--bake-from", "2 pages"});
}
#endif

// Read as programs do that store 12 bits; files of `float` and of decimals have the same coordinates.
BOOST_AUTO_TEST_CASE(quantized_coordinates)
{
  flatten(dinosaur(), "--quantize 12");
  BOOST_TEST(status == 0, standard_error);
  BOOST_TEST(packing().get<int>("quantization_bits") == 12);
  std::set<std::size_t> named;
  for(const auto& face : packing().get_child("faces_off_grid"))
    named.insert(face.second.get_value<std::size_t>() - 1);
  BOOST_TEST((standard_error.find("found no place on the grid of 12 bits") != std::string::npos) ==
             !named.empty());
  const auto faces = texture_of_faces(obj());
  std::size_t wrong = 0;
  for(std::size_t f = 0; f < faces.size(); ++f) {
    std::array<std::array<long long, 2>, 3> codes = {};
    for(std::size_t k = 0; k < 3; ++k)
      for(std::size_t i = 0; i < 2; ++i) {
        const long long step = std::llround(4095 * faces[f][k][i]);
        codes[k][i] = step * 16 + step / 256;
        wrong += named.count(f) == 0 && std::abs(faces[f][k][i] - double(codes[k][i]) / 65535) > 4e-8;
      }
    const auto difference = [&codes](std::size_t k, std::size_t i) { return codes[k][i] - codes[0][i]; };
    wrong +=
        named.count(f) == 0 && difference(1, 0) * difference(2, 1) <= difference(1, 1) * difference(2, 0);
  }
  BOOST_TEST(wrong == 0u);
  BOOST_TEST(named.size() < faces.size() / 200);
}

BOOST_AUTO_TEST_CASE(what_no_page_holds_is_named)
{
  const std::string input = write("squares.off", squares(2));
  check_refused(input, "--texels-per-unit 70 --resolution 64x128", {"PACKING_FAILED", "chart 0", "64 x 128"});
  check_refused(input, "--texels-per-unit 1e6", {"PACKING_FAILED", "1907349 pages", "10000"});
}

BOOST_AUTO_TEST_CASE(wrong_options)
{
  const std::string input = write("squares.off", squares(2));
  for(const std::string options : {"--resolution 64x",
                                   "--resolution x64",
                                   "--resolution 64x64x64",
                                   "--resolution 64x0",
                                   "--resolution 64x99999",
                                   "--resolution 64,64",
                                   "--block 0",
                                   "--block 3",
                                   "--block 64 --resolution 64x96",
                                   "--resolution 1024x64 --gutter 17",
                                   "--texels-per-unit=-1",
                                   "--texels-per-unit nan",
                                   "--texels-per-unit inf",
                                   "--no-pack --block 4",
                                   "--no-pack --texels-per-unit 10",
                                   "--plain --block 4",
                                   "--quantize 7",
                                   "--quantize 17",
                                   "--quantize 8 --mip-levels 1",
                                   "--quantize 12 --texels-per-unit 10",
                                   "--quantize 12 --units world",
                                   "--quantize 12 --no-pack",
                                   "--quantize 12 --plain"}) {
    check_refused(input, options,
                  {options.find("--quantize") != std::string::npos ? "--quantize"
                   : options.find("--gutter") != std::string::npos ? "--gutter"
                   : options.find("--block") != std::string::npos  ? "--block"
                   : options.find("--texels") != std::string::npos ? "--texels-per-unit"
                                                                   : "--resolution"});
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
