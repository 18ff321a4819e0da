#!/usr/bin/env bash
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What was expected, of a PLY file with a list `texcoord` of each face, in which two triangles have different
# coordinates at a common point: the coordinates of each corner, as of the same model in OBJ.
# What happens, with assimp 5.2.4 (as it calls itself; Debian's 5.2.5): without a message, the common points have the
# coordinates of the second triangle in both.
# Needs g++ and apt-get; changes nothing outside of its temporary folder. Fails if the behaviour changes.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq libassimp-dev=5.2.5~ds0-1+b1 libassimp5=5.2.5~ds0-1+b1 libdraco7=1.5.5+dfsg-2 \
  libminizip1=1.1-8+deb12u1
for package in *.deb; do dpkg-deb -x "$package" root; done
cat >two.ply <<'END'
ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
element face 2
property list uchar int vertex_indices
property list uchar float texcoord
end_header
0 0 0
1 0 0
1 1 0
0 1 0
3 0 1 2 6 0 0 0.25 0 0.25 0.25
3 0 2 3 6 0.75 0.75 1 1 0.75 1
END
cat >two.obj <<'END'
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
vt 0 0
vt 0.25 0
vt 0.25 0.25
vt 0.75 0.75
vt 1 1
vt 0.75 1
f 1/1 2/2 3/3
f 1/4 3/5 4/6
END
cat >read.cpp <<'END'
#include <assimp/Importer.hpp>
#include <assimp/scene.h>
#include <assimp/version.h>
#include <iostream>
int main()
{
  std::cout << aiGetVersionMajor() << "." << aiGetVersionMinor() << "." << aiGetVersionPatch() << "\n";
  for (const auto name : {"two.obj", "two.ply"}) {
    Assimp::Importer importer;
    const aiMesh& mesh = *importer.ReadFile(name, 0)->mMeshes[0];
    std::cout << name;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f)
      for (unsigned i = 0; i < 3; ++i) {
        const aiVector3D& uv = mesh.mTextureCoords[0][mesh.mFaces[f].mIndices[i]];
        std::cout << (i == 0 ? ": " : ", ") << uv.x << " " << uv.y;
      }
    std::cout << "\n";
  }
}
END
libraries=root/usr/lib/$(gcc -print-multiarch)
g++ -isystem root/usr/include read.cpp -o read "$libraries/libassimp.so" -Wl,-rpath-link,"$libraries"
LD_LIBRARY_PATH=$libraries ./read | tee output
diff output - <<'END'
5.2.4
two.obj: 0 0, 0.25 0, 0.25 0.25: 0.75 0.75, 1 1, 0.75 1
two.ply: 0.75 0.75, 0.25 0, 1 1: 0.75 0.75, 1 1, 0.75 1
END
