// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_FILES_READ_OBJ_SOUP_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_FILES_READ_OBJ_SOUP_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/files/text_lines.h>
#include <CGAL/Texture_atlas/IO/OBJ_material.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <istream>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// The points, texture coordinates and faces of an OBJ file, with numbers from 0
struct Obj_soup
{
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  std::size_t number_of_faces() const { return lines.size(); }

  std::size_t face(std::size_t corner) const
  {
    return static_cast<std::size_t>(std::upper_bound(first_corners.begin(), first_corners.end(), corner) -
                                    first_corners.begin()) -
           1;
  }

  std::size_t next(std::size_t corner) const
  {
    const std::size_t f = face(corner);
    return corner + 1 == first_corners[f + 1] ? first_corners[f] : corner + 1;
  }

  std::vector<std::array<double, 3>> points;
  std::vector<std::array<double, 2>> coordinates;
  std::vector<std::size_t> first_corners = {0}; // of each face, and the end
  std::vector<std::size_t> lines;               // of each face
  std::vector<std::size_t> vertices;            // of each corner
  std::vector<std::size_t> corner_coordinates;  // of each corner, or `none`
};

inline OBJ_report obj_failure(Diagnosis status, const std::string& message, std::size_t line = 0)
{
  OBJ_report report;
  report.status = status;
  report.message = (line == 0 ? std::string() : "line " + std::to_string(line) + ": ") + message;
  report.line = line;
  return report;
}

// Reads the points, texture coordinates and faces of an OBJ file, and nothing else. Faces may come before what they
// name.
class Obj_soup_reader
{
public:
  Obj_soup_reader(std::string_view text, Obj_soup& soup)
      : m_lines(text, Text_lines::BACKSLASHES), m_soup(soup)
  {}

  OBJ_report run()
  {
    while(m_report && m_lines.next())
      read_line();
    if(m_report && m_soup.number_of_faces() == 0)
      m_report = obj_failure(Diagnosis::EMPTY_MESH, "the file has no faces");
    if(m_report)
      check_ranges();
    return m_report;
  }

private:
  void read_line()
  {
    const std::string_view keyword = m_lines.word();
    if(keyword == "v")
      read_point();
    else if(keyword == "vt")
      read_coordinates();
    else if(keyword == "f" || keyword == "fo") // the old word
      read_face();
  }

  void read_point()
  {
    std::array<double, 3> point = {};
    for(double& x : point)
      if(!read_double(m_lines.word(), Diagnosis::NON_FINITE_POINT, x))
        return;
    m_soup.points.push_back(point);
  }

  // Those on a line have one only.
  void read_coordinates()
  {
    std::array<double, 2> uv = {};
    if(!read_double(m_lines.word(), Diagnosis::NON_FINITE_COORDINATE, uv[0]))
      return;
    const std::string_view word = m_lines.word();
    if(!word.empty() && !read_double(word, Diagnosis::NON_FINITE_COORDINATE, uv[1]))
      return;
    m_soup.coordinates.push_back(uv);
  }

  bool read_double(std::string_view word, Diagnosis not_finite, double& x)
  {
    if(read_finite_number(word, x))
      return true;
    const std::string name = not_finite == Diagnosis::NON_FINITE_POINT
                                 ? "vertex " + std::to_string(m_soup.points.size() + 1)
                                 : "texture coordinates " + std::to_string(m_soup.coordinates.size() + 1);
    if(word.empty())
      return fail(Diagnosis::TOO_FEW_NUMBERS, name + ": a number is missing");
    if(!read_number(word, x))
      return fail(Diagnosis::NOT_A_NUMBER, name + ": " + quoted(word) + " is not a number");
    return fail(not_finite, name + ": " + quoted(word) + " is not finite");
  }

  void read_face()
  {
    const std::size_t first = m_soup.vertices.size();
    std::size_t with_coordinates = 0;
    for(std::string_view word = m_lines.word(); !word.empty(); word = m_lines.word()) {
      if(!read_corner(word))
        return;
      with_coordinates += m_soup.corner_coordinates.back() != Obj_soup::none;
    }
    const std::size_t size = m_soup.vertices.size() - first;
    if(size < 3) {
      fail(Diagnosis::TOO_FEW_NUMBERS, face_name() + " has fewer than three vertices");
      return;
    }
    if(with_coordinates != 0 && with_coordinates != size) {
      fail(Diagnosis::NO_TEXTURE_COORDINATES, face_name() + " has texture coordinates at some corners only");
      return;
    }
    m_report.number_of_faces_without_coordinates += with_coordinates == 0;
    m_soup.first_corners.push_back(m_soup.vertices.size());
    m_soup.lines.push_back(m_lines.number());
  }

  // Such as "7", "7/3", "7//2" or "-1/-1/-1". Normals are not read.
  bool read_corner(std::string_view word)
  {
    const std::size_t slash = word.find('/');
    m_soup.vertices.push_back(0);
    m_soup.corner_coordinates.push_back(Obj_soup::none);
    if(!read_index(word.substr(0, slash), "vertex", m_soup.points.size(), m_soup.vertices.back()))
      return false;
    if(slash == word.npos)
      return true;
    word.remove_prefix(slash + 1);
    const std::size_t second = word.find('/');
    if(second == 0)
      return true;
    return read_index(word.substr(0, second), "texture coordinates", m_soup.coordinates.size(),
                      m_soup.corner_coordinates.back());
  }

  // Numbers count from 1, or backwards from -1, the last one before this line.
  bool read_index(std::string_view word, const std::string& kind, std::size_t before, std::size_t& index)
  {
    long long number = 0;
    const char* const end = word.data() + word.size();
    const std::from_chars_result result = std::from_chars(word.data(), end, number);
    if(result.ptr != end || result.ec == std::errc::invalid_argument)
      return fail(Diagnosis::NOT_A_NUMBER, face_name() + ": " + quoted(word) + " is not the number of a " +
                                               (kind == "vertex" ? "vertex" : "pair of texture coordinates"));
    if(result.ec != std::errc() || number == 0 || number < -static_cast<long long>(before))
      return fail(Diagnosis::NUMBER_OUT_OF_RANGE,
                  face_name() + " names " + kind + " " + std::string(word) +
                      (number < 0 ? ", counted backwards, but only " + std::to_string(before) + " come before"
                                  : ", but numbers begin with 1"));
    index = number < 0 ? before - static_cast<std::size_t>(-number) : static_cast<std::size_t>(number) - 1;
    return true;
  }

  void check_ranges()
  {
    for(std::size_t f = 0; f < m_soup.number_of_faces() && m_report; ++f)
      for(std::size_t c = m_soup.first_corners[f]; c < m_soup.first_corners[f + 1] && m_report; ++c) {
        check_range(f, m_soup.vertices[c], m_soup.points.size(), "vertex");
        if(m_report && m_soup.corner_coordinates[c] != Obj_soup::none)
          check_range(f, m_soup.corner_coordinates[c], m_soup.coordinates.size(), "texture coordinates");
      }
  }

  void check_range(std::size_t f, std::size_t index, std::size_t size, const std::string& kind)
  {
    if(index >= size)
      m_report =
          obj_failure(Diagnosis::NUMBER_OUT_OF_RANGE,
                      "face " + std::to_string(f + 1) + " names " + kind + " " + std::to_string(index + 1) +
                          ", but the file has only " + std::to_string(size),
                      m_soup.lines[f]);
  }

  bool fail(Diagnosis status, const std::string& message)
  {
    m_report = obj_failure(status, message, m_lines.number());
    return false;
  }

  std::string face_name() const { return "face " + std::to_string(m_soup.number_of_faces() + 1); }

  static std::string quoted(std::string_view word)
  {
    const std::size_t longest = 40;
    return "\"" + std::string(word.substr(0, longest)) + (word.size() > longest ? "..." : "") + "\"";
  }

  Text_lines m_lines;
  Obj_soup& m_soup;
  OBJ_report m_report;
};

inline OBJ_report read_obj_soup(std::istream& in, Obj_soup& soup)
{
  std::string text;
  std::vector<char> part(std::size_t(1) << 16);
  if(!in)
    return obj_failure(Diagnosis::CANNOT_READ, "the stream cannot be read");
  do {
    in.read(part.data(), static_cast<std::streamsize>(part.size()));
    text.append(part.data(), static_cast<std::size_t>(in.gcount()));
  } while(in);
  if(in.bad())
    return obj_failure(Diagnosis::CANNOT_READ, "reading failed");
  return Obj_soup_reader(text, soup).run();
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_FILES_READ_OBJ_SOUP_H
