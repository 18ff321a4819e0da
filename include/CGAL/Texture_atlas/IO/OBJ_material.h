// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_IO_OBJ_MATERIAL_H
#define CGAL_TEXTURE_ATLAS_IO_OBJ_MATERIAL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <array>
#include <cstddef>
#include <string>

/// \file OBJ_material.h

namespace CGAL {

namespace Texture_atlas {

/// \ingroup PkgTextureAtlasRef
///
/// A material in the files that `IO::write_OBJ()` writes: a colour and pictures. Names of picture files are written as
/// they are: programs look for them from the folder of the OBJ file. An empty name means that there is no such picture.
struct OBJ_material
{
  std::string name = "surface"; ///< The name, which no other material of the file has.

  /// Red, green and blue from 0 to 1 (`Kd`). Many programs multiply the colours of `color_image` by it.
  std::array<double, 3> color = {1, 1, 1};

  std::string color_image;        ///< The picture of the colours (`map_Kd`).
  std::string normal_image;       ///< The picture of the normals in tangent space (`norm` and `map_Bump`).
  std::string displacement_image; ///< The picture of the displacements (`disp`).

  /// The displacement that is black in the picture, such as `Baked_textures::least_displacement`.
  double least_displacement = 0;

  /// The displacement that is white in the picture, such as `Baked_textures::greatest_displacement`.
  double greatest_displacement = 1;
};

/// \ingroup PkgTextureAtlasRef
///
/// What `IO::read_OBJ()` and `IO::write_OBJ()` return. Like the `bool` of \cgal's functions for files, it converts to
/// `true` on success.
struct OBJ_report : Report
{
  using Report::Report;

  /// The line with the error, from 1; 0 if there is none. Of a line that is continued, it is the first.
  std::size_t line = 0;

  std::size_t number_of_faces_without_coordinates =
      0; ///< The faces that have no texture coordinates in the file.
};

} // namespace Texture_atlas

} // namespace CGAL

#endif // CGAL_TEXTURE_ATLAS_IO_OBJ_MATERIAL_H
