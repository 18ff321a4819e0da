// A user's program: flattens a small grid.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
namespace SMP = CGAL::Surface_mesh_parameterization;

int main()
{
  Mesh mesh;
  auto bump = [](std::size_t i, std::size_t j) { return Kernel::Point_3(i, j, 0.1 * ((i * j) % 3)); };
  CGAL::make_grid(4, 4, mesh, bump, true);

  auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  const auto border = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  return SMP::parameterize(mesh, SMP::ABF_plus_plus_parameterizer_3<Mesh>(), border, uv) == SMP::OK ? 0 : 1;
}
