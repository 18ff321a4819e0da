// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_FILES_WRITE_OBJ_FILES_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_FILES_WRITE_OBJ_FILES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/IO/OBJ_material.h>
#include <CGAL/Texture_atlas/internal/files/read_obj_soup.h>
#include <CGAL/Texture_atlas/internal/files/write_obj_materials.h>
#include <CGAL/Texture_atlas/internal/files/write_obj_mesh.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Writes a mesh and its materials to files.
template <typename PolygonMesh, typename UVMap, typename FaceMaterialMap, typename NamedParameters>
OBJ_report write_obj_files(const std::string& fname, const PolygonMesh& mesh, UVMap uv,
                           FaceMaterialMap face_materials, const std::vector<OBJ_material>& materials,
                           const NamedParameters& np)
{
  Obj_mesh_writer<PolygonMesh, UVMap, FaceMaterialMap, NamedParameters> writer(mesh, uv, face_materials,
                                                                               materials, np);
  OBJ_report report = writer.check();
  if(!report) {
    report.message = fname + ": " + report.message;
    return report;
  }
  const std::filesystem::path material_file = std::filesystem::path(fname).replace_extension(".mtl");
  if(!materials.empty() && material_file == std::filesystem::path(fname))
    return obj_failure(Diagnosis::WRONG_OPTION, fname + ": this is the name of the file of materials");
  std::ofstream out(fname, std::ios::binary), materials_out;
  if(!out)
    return obj_failure(Diagnosis::CANNOT_OPEN, "cannot open " + fname);
  if(!materials.empty()) {
    materials_out.open(material_file, std::ios::binary);
    if(!materials_out)
      return obj_failure(Diagnosis::CANNOT_OPEN, "cannot open " + material_file.string());
    write_obj_materials(materials_out, materials);
  }
  writer.write(out, materials.empty() ? std::string() : material_file.filename().string());
  if(!out.flush())
    return obj_failure(Diagnosis::CANNOT_WRITE, fname + ": writing failed");
  if(!materials.empty() && !materials_out.flush())
    return obj_failure(Diagnosis::CANNOT_WRITE, material_file.string() + ": writing failed");
  return report;
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_FILES_WRITE_OBJ_FILES_H
