// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_FILE_NAMES_H
#define FLATTEN_MESH_FILE_NAMES_H

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/predicate.hpp>

#include <filesystem>
#include <string>
#include <system_error>

namespace flatten_mesh {

// The name of an output that stands for standard output, and that of an input that stands for standard input.
const char* const standard_output = "-";
const char* const standard_input = "-";

// In names of outputs, for the name of the input without folder and extension
const char* const placeholder = "%";

// In names of pictures, for the number of a page
const char* const udim_placeholder = "<UDIM>";

inline bool has_placeholder(const std::string& name)
{
  return name.find(placeholder) != std::string::npos;
}

// The extension in lower case, without its dot.
inline std::string file_format(const std::string& name)
{
  const std::string extension = std::filesystem::path(name).extension().string();
  return boost::algorithm::to_lower_copy(extension.empty() ? extension : extension.substr(1));
}

// Other surfaces are written as OBJ, also to standard output and to names without an extension.
inline bool is_obj_output(const std::string& name)
{
  return file_format(name) != "ply" && file_format(name) != "glb";
}

// `CGAL::Seam_mesh` and CGAL's demo ask for this ending of files of seams.
inline bool is_selection_file(const std::string& name)
{
  return boost::algorithm::ends_with(name, ".selection.txt");
}

// Whether the name exists and is neither a file nor a folder, but a device or a pipe, say.
inline bool is_other_file(const std::filesystem::path& path)
{
  std::error_code ignored;
  return std::filesystem::is_other(path, ignored);
}

// The target of a name, also through links to files that do not exist yet. Pipes such as /dev/fd/63 have no other
// name.
inline std::filesystem::path resolved(const std::string& name)
{
  std::error_code ignored;
  std::filesystem::path path = std::filesystem::absolute(name, ignored);
  if(is_other_file(path)) {
    return path;
  }
  for(int links = 0; links < 40 && std::filesystem::is_symlink(path, ignored); ++links) {
    path = path.parent_path() / std::filesystem::read_symlink(path, ignored);
  }
  const std::filesystem::path canonical = std::filesystem::weakly_canonical(path, ignored);
  return canonical.empty() ? path : canonical;
}

// Whether two names lead to the same file, or will when it is written.
inline bool is_same_file(const std::string& a, const std::string& b)
{
  std::error_code ignored;
  return std::filesystem::equivalent(a, b, ignored) || resolved(a) == resolved(b);
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_FILE_NAMES_H
