#!/usr/bin/env bash
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What was expected: equal edge descriptors are interchangeable, so that `halfedge(e, mesh)` tells the two sides of an
# edge apart: `h == halfedge(edge(h, mesh), mesh)` for one of both halfedges.
# What happens, with CGAL 5.5.1: the edge of a halfedge and the edge of its opposite compare equal and have the same
# hash, but `halfedge()`, `source()` and `target()` return those of the halfedge that the descriptor was made of. So the
# condition above holds for both halfedges, and what a set or map of edges returns depends on which one came first.
# Both Surface_mesh and Polyhedron_3 do so.
# Needs g++ and apt-get; changes nothing outside of its temporary folder. Fails if the behaviour changes.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq libcgal-dev=5.5.1-2 libboost1.74-dev=1.74.0+ds1-21 libgmp-dev=2:6.2.1+dfsg1-1.1 \
  libgmp10=2:6.2.1+dfsg1-1.1 libgmpxx4ldbl=2:6.2.1+dfsg1-1.1 libmpfr-dev=4.2.0-1 libmpfr6=4.2.0-1
for package in *.deb; do dpkg-deb -x "$package" root; done
cat >edges.cpp <<'END'
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/version.h>
#include <functional>
#include <iostream>
#include <set>

typedef CGAL::Simple_cartesian<double> Kernel;

template <class Mesh>
void look(const char* const name)
{
  Mesh mesh;
  CGAL::make_tetrahedron(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0), Kernel::Point_3(0, 1, 0),
                         Kernel::Point_3(0, 0, 1), mesh);
  const auto h = *halfedges(mesh).begin();
  const auto e = edge(h, mesh), f = edge(opposite(h, mesh), mesh);
  const std::hash<typename boost::graph_traits<Mesh>::edge_descriptor> hash;
  const std::set<typename boost::graph_traits<Mesh>::edge_descriptor> known = {e};
  std::cout << name << ": equal " << (e == f) << ", same hash " << (hash(e) == hash(f)) << ", same halfedge "
            << (halfedge(e, mesh) == halfedge(f, mesh)) << ", same source " << (source(e, mesh) == source(f, mesh))
            << ", same halfedge as in a set " << (halfedge(*known.find(f), mesh) == halfedge(f, mesh)) << "\n";
}

int main()
{
  std::cout << "CGAL " << CGAL_VERSION_STR << "\n";
  look<CGAL::Surface_mesh<Kernel::Point_3>>("Surface_mesh");
  look<CGAL::Polyhedron_3<Kernel>>("Polyhedron_3");
}
END
libraries=root/usr/lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH 2>/dev/null || gcc -print-multiarch)
g++ -std=c++17 -isystem root/usr/include -isystem "root/usr/include/$(basename "$libraries")" edges.cpp -o edges \
  -L "$libraries" -lmpfr -lgmp
LD_LIBRARY_PATH=$libraries ./edges | tee output
diff output - <<'END'
CGAL 5.5.1
Surface_mesh: equal 1, same hash 1, same halfedge 0, same source 0, same halfedge as in a set 0
Polyhedron_3: equal 1, same hash 1, same halfedge 0, same source 0, same halfedge as in a set 0
END
