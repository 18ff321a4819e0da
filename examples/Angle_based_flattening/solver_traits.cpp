// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Solver_traits_factory.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>

#include <iostream>
#include <memory>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMP = CGAL::Surface_mesh_parameterization;

// A solver of Eigen's, with reusable factorizations. CGAL wraps it.
using Columns = CGAL::Eigen_sparse_matrix<double>::EigenType;
using Simplicial_traits = CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<Columns>>;

// A solver of one's own: all that the concept `SparseLinearAlgebraTraits_d` asks for.
struct Conjugate_gradient_traits
{
  typedef double NT;
  typedef CGAL::Eigen_sparse_matrix<double> Matrix;
  typedef CGAL::Eigen_vector<double> Vector;

  bool linear_solver(const Matrix& A, const Vector& B, Vector& X, NT& D)
  {
    typedef Eigen::IncompleteCholesky<NT> Preconditioner;
    Eigen::ConjugateGradient<Columns, Eigen::Lower | Eigen::Upper, Preconditioner> solver(A.eigen_object());
    solver.setTolerance(1e-12);
    X.eigen_object() = solver.solve(B.eigen_object());
    D = 1; // X is not to be divided by anything
    return solver.info() == Eigen::Success;
  }
};

// A solver of one's own that factors, in double or single precision. Each factorization is a new object, which copies
// of the solver share and never change.
template <typename FT>
class Cholesky_traits
{
  typedef Eigen::SimplicialLLT<Eigen::SparseMatrix<FT>> Cholesky;

public:
  typedef FT NT;
  typedef CGAL::Eigen_sparse_matrix<FT> Matrix;
  typedef CGAL::Eigen_vector<FT> Vector;

  bool factor(const Matrix& A, NT& D)
  {
    D = 1;
    m_cholesky = std::make_shared<const Cholesky>(A.eigen_object());
    return m_cholesky->info() == Eigen::Success;
  }

  bool linear_solver(const Vector& B, Vector& X) const
  {
    X.eigen_object() = m_cholesky->solve(B.eigen_object());
    return true;
  }

  bool linear_solver(const Matrix& A, const Vector& B, Vector& X, NT& D)
  {
    return factor(A, D) && linear_solver(B, X);
  }

private:
  std::shared_ptr<const Cholesky> m_cholesky;
};

// Copies own their factors, so that two of them can factor two matrices at once. Single precision is enough for factors
// that only precondition.
template <>
struct CGAL::Low_precision_solver_traits<Cholesky_traits<double>>
{
  typedef Cholesky_traits<float> type;
  static type create(const Cholesky_traits<double>&) { return type(); }
};

template <typename SolverTraits>
bool flatten(const char* name, Mesh& mesh)
{
  auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  SMP::ABF_plus_plus_parameterizer_3<Mesh, SolverTraits> parameterizer;
  SMP::parameterize(mesh, parameterizer, PMP::longest_border(mesh).first, uv);
  const SMP::ABF_plus_plus_report& report = parameterizer.report();
  std::cout << name << ": " << report.iterations << " steps, energy " << report.energy << " "
            << report.message << "\n";
  return bool(report);
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/dinosaur.off", mesh) || CGAL::is_closed(mesh)) {
    std::cerr << "Cannot read the mesh, or it has no border.\n";
    return 1;
  }
  const bool ok = flatten<CGAL::Default>("SuperLU", mesh) &&
                  flatten<Simplicial_traits>("SimplicialLDLT", mesh) &&
                  flatten<Conjugate_gradient_traits>("conjugate gradients", mesh) &&
                  flatten<Cholesky_traits<double>>("Cholesky", mesh);
  return ok ? 0 : 1;
}
