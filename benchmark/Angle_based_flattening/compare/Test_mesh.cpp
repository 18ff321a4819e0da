// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Test_mesh.h"

#include "../common/add_noise.h"
#include "../common/mesh_files.h"
#include "../common/read_mesh.h"
#include "../common/resize_mesh.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_chart.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>

namespace compare {

namespace {

namespace fs = std::filesystem;

// Throws an exception if it is no disk.
Test_mesh read_disk(const fs::path& file)
{
  namespace abf = CGAL::Surface_mesh_parameterization::internal::ABF;
  const Mesh mesh = read_mesh(file.string());
  abf::Chart_reader<Mesh> reader(mesh);
  auto defect = reader.read(CGAL::Polygon_mesh_processing::longest_border(mesh).first);
  if(!defect) {
    defect = abf::diagnose(reader.chart, false);
  }
  if(defect) {
    throw std::runtime_error("'" + file.string() + "' cannot be flattened: " + defect.message);
  }
  return {file.stem().string(), file.string(), static_cast<std::size_t>(reader.chart.number_of_triangles())};
}

// Folders of meshes have much in them that is no disk.
void add_folder(const Command_line& command, const std::string& folder, std::vector<Test_mesh>& meshes)
{
  for(const fs::path& file : mesh_files(folder)) {
    try {
      const Test_mesh mesh = read_disk(file);
      if(mesh.triangles >= command.least && mesh.triangles <= command.most) {
        meshes.push_back(mesh);
      }
    } catch(const std::exception& error) {
      std::cerr << "left out: " << error.what() << std::endl;
    }
  }
}

} // namespace

std::vector<Test_mesh> find_meshes(const Command_line& command)
{
  std::vector<Test_mesh> meshes;
  for(const std::string& name : command.meshes) {
    if(fs::is_directory(name)) {
      add_folder(command, name, meshes);
    } else {
      meshes.push_back(read_disk(name));
    }
  }
  for(const std::string& name : command.data) {
    if(fs::is_directory(name)) {
      add_folder(command, name, meshes);
    } else {
      std::cerr << "left out: there is no folder '" << name << "'" << std::endl;
    }
  }
  for(const std::size_t triangles : command.triangles()) {
    meshes.push_back({fs::path(command.base).stem().string(), "", triangles});
  }
  std::stable_sort(meshes.begin(), meshes.end(), [](const Test_mesh& a, const Test_mesh& b) {
    return a.triangles != b.triangles ? a.triangles < b.triangles : a.name < b.name;
  });
  return meshes;
}

std::string write_resized_mesh(const Command_line& command, const std::size_t triangles,
                               const std::string& folder)
{
  Mesh mesh = resize_mesh(read_mesh(command.base), triangles);
  add_noise(mesh);
  const std::string file = folder + "/resized.ply";
  write_mesh(mesh, file);
  return file;
}

} // namespace compare
