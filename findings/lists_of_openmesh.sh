#!/usr/bin/env bash
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What was expected, of a PLY file whose faces have a list beside that of their vertices: the mesh, without the list.
# What happens, with OpenMesh 9.0: read_mesh() fails if the file is binary. If it is ASCII, it returns true, and the
# mesh has one face of three. Without the list, it has all.
# Needs g++ and apt-get; changes nothing outside of its temporary folder. Fails if the behaviour changes.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq libopenmesh-dev=9.0-4+b1 libopenmesh1=9.0-4+b1
for package in *.deb; do dpkg-deb -x "$package" root; done
cat >read.cpp <<'END'
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/config.h>
#include <cstdint>
#include <fstream>
#include <iostream>

const float points[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 0};
const std::int32_t faces[3][3] = {{0, 1, 2}, {0, 2, 3}, {1, 4, 2}};

void write(const std::string& name, const bool binary, const bool with_lists)
{
  std::ofstream file(name, std::ios::binary);
  file << "ply\nformat " << (binary ? "binary_little_endian" : "ascii")
       << " 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\nelement face 3\n"
          "property list uchar int vertex_indices\n"
       << (with_lists ? "property list uchar float weights\n" : "") << "end_header\n";
  if (!binary)
    for (int i = 0; i < 15; ++i)
      file << points[i] << (i % 3 == 2 ? "\n" : " ");
  else
    file.write(reinterpret_cast<const char*>(points), sizeof points);
  const float weights[] = {.5f, .25f, .125f};
  for (const auto& face : faces) {
    if (!binary) {
      file << "3 " << face[0] << " " << face[1] << " " << face[2] << (with_lists ? " 3 .5 .25 .125\n" : "\n");
      continue;
    }
    file.put(3).write(reinterpret_cast<const char*>(face), sizeof face);
    if (with_lists)
      file.put(3).write(reinterpret_cast<const char*>(weights), sizeof weights);
  }
}

int main()
{
  std::cout << "OpenMesh " << (OM_VERSION >> 16) << "." << (OM_VERSION >> 8 & 255) << "\n";
  omerr().disable();
  for (const bool binary : {false, true})
    for (const bool with_lists : {false, true}) {
      write("mesh.ply", binary, with_lists);
      OpenMesh::PolyMesh_ArrayKernelT<> mesh;
      const bool is_read = OpenMesh::IO::read_mesh(mesh, "mesh.ply");
      std::cout << (binary ? "binary" : "ASCII") << (with_lists ? " with" : " without") << " lists: returns " << is_read
                << ", faces " << mesh.n_faces() << "\n";
    }
}
END
libraries=root/usr/lib/$(gcc -print-multiarch)
[[ -d $libraries ]] || libraries=root/usr/lib
g++ -isystem root/usr/include read.cpp -o read -L "$libraries" -lOpenMeshCore
LD_LIBRARY_PATH=$libraries ./read | tee output
diff output - <<'END'
OpenMesh 9.0
ASCII without lists: returns 1, faces 3
ASCII with lists: returns 1, faces 1
binary without lists: returns 1, faces 3
binary with lists: returns 0, faces 1
END
