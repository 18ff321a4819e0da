// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_HIERARCHICAL_PARAMETERIZER_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_HIERARCHICAL_PARAMETERIZER_3_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_options.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_report.h>
#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/one_to_one.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/prescriptions.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_pins.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/coarse_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/run_parameterizer.h>

#include <CGAL/Default.h>
#include <CGAL/Surface_mesh.h>

#include <type_traits>
#include <utility>
#include <vector>

/// \file Hierarchical_parameterizer_3.h

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal::ABF {

// Whether a parameterizer gives access to its solver traits
template <typename Parameterizer, typename = void>
struct Has_solver_traits : std::false_type
{};

template <typename Parameterizer>
struct Has_solver_traits<Parameterizer,
                         std::void_t<decltype(std::declval<const Parameterizer&>().solver_traits())>>
    : std::true_type
{};

// The type of these, or the default
template <typename Parameterizer, bool = Has_solver_traits<Parameterizer>::value>
struct Solver_traits_of : Default_solver_traits<Parameterizer>
{};

template <typename Parameterizer>
struct Solver_traits_of<Parameterizer, true>
{
  typedef typename Parameterizer::Solver_traits type;
};

// Whether the parameterizer has a traits object of this type
template <typename SolverTraits, typename Parameterizer, bool = Has_solver_traits<Parameterizer>::value>
struct Has_traits_object : std::is_same<SolverTraits, typename Parameterizer::Solver_traits>
{};

template <typename SolverTraits, typename Parameterizer>
struct Has_traits_object<SolverTraits, Parameterizer, false> : std::false_type
{};

// A copy of that object if there is one
template <typename SolverTraits, typename Parameterizer>
SolverTraits solver_traits_of(const Parameterizer& parameterizer)
{
  if constexpr(Has_traits_object<SolverTraits, Parameterizer>::value) {
    return parameterizer.solver_traits();
  } else {
    (void)parameterizer;
    return SolverTraits();
  }
}

// A coarse parameterizer with the same options as the hierarchical one
template <typename Parameterizer>
Parameterizer coarse_parameterizer_for(const Hierarchical_options& options)
{
  if constexpr(std::is_constructible<Parameterizer, const ABF_plus_plus_options&>::value) {
    ABF_plus_plus_options coarse;
    coarse.barrier = options.barrier;
    coarse.holes = options.holes;
    coarse.fallbacks = options.fallbacks;
    return Parameterizer(coarse);
  } else {
    (void)options;
    return Parameterizer();
  }
}

} // namespace internal::ABF

/// \ingroup PkgAngleBasedFlatteningRef
/// \anchor hierarchical_coarse_mesh
///
/// The type of the coarse chart that `Hierarchical_parameterizer_3` passes to its coarse parameterizer: a
/// `Surface_mesh` with points of `Simple_cartesian<double>`.
///
/// A coarse parameterizer takes this type of mesh, for example `LSCM_parameterizer_3<Hierarchical_coarse_mesh>`.
typedef CGAL::Surface_mesh<internal::ABF::Chart::Point_3> Hierarchical_coarse_mesh;

/// \ingroup PkgAngleBasedFlatteningRef
///
/// The class `Hierarchical_parameterizer_3` flattens surfaces of millions of triangles in seconds: the hierarchical
/// method of Section 5 of \cgalCite{cgal:slmb-abf-05}. It simplifies the surface, flattens the coarse chart with
/// another parameterizer, and refines the map while it inserts the removed vertices again.
///
/// No step flips a triangle: a vertex is inserted or moved only where all its triangles keep their orientation.
/// Finally, an exact predicate checks every triangle.
///
/// Half-edge collapses remove vertices in levels of independent vertices, cheapest first. The cost of a collapse is
/// the volume that it sweeps. If the coarse chart cannot be flattened, finer charts are tried. The last resort is a
/// single triangle, which needs no solver. `Hierarchical_report` lists the charts that failed, and notes the last
/// resort; without `Flattening_options::fallbacks`, it is an error.
///
/// \cgalModels{Parameterizer_3}
///
/// \tparam TriangleMesh_ must be a model of `FaceGraph`. Edges may be the border of a seam (`Seam_mesh`).
///
/// \tparam CoarseParameterizer_ must be a model of `Parameterizer_3` for `Hierarchical_coarse_mesh`, with the nested
///         types `Triangle_mesh` and `Solver_traits` that the parameterizers of \cgal have. If it returns flipped
///         triangles or an error, or throws a `CGAL::Failure_exception`, a finer chart is tried. Other exceptions pass
///         through. With `LSCM_parameterizer_3` the method is hierarchical LSCM (\ref ABF_coarse_methods "how often
///         it serves").<br>
///         <b>%Default:</b> `ABF_plus_plus_parameterizer_3<Hierarchical_coarse_mesh>`
///
/// \tparam SolverTraits_ solves the linear systems of polishing (`Hierarchical_options::polish`); see
///         `ABF_plus_plus_parameterizer_3` for the requirements.<br>
///         <b>%Default:</b> `CoarseParameterizer_::Solver_traits` if the coarse parameterizer has a member
///         `solver_traits()`, as `ABF_plus_plus_parameterizer_3` has. The object is then a copy of the object of the
///         coarse parameterizer. Otherwise, `CGAL::SuperLU_solver_traits<>`.
///
/// Each copy of a parameterizer has a report of its own; see `ABF_plus_plus_parameterizer_3`.
///
/// \sa `CGAL::Surface_mesh_parameterization::ABF_plus_plus_parameterizer_3`
template <typename TriangleMesh_, typename CoarseParameterizer_ = Default, typename SolverTraits_ = Default>
class Hierarchical_parameterizer_3
{
public:
  /// Triangle mesh type
  typedef TriangleMesh_ Triangle_mesh;
  /// Same as `Triangle_mesh`
  typedef TriangleMesh_ TriangleMesh;

#ifndef DOXYGEN_RUNNING
  typedef typename Default::Get<CoarseParameterizer_,
                                ABF_plus_plus_parameterizer_3<Hierarchical_coarse_mesh>>::type
      Coarse_parameterizer;
#else
  /// Type of the coarse parameterizer
  typedef CoarseParameterizer_ Coarse_parameterizer;
#endif

#ifndef DOXYGEN_RUNNING
  typedef
      typename Default::Lazy_get<SolverTraits_, internal::ABF::Solver_traits_of<Coarse_parameterizer>>::type
          Solver_traits;
#else
  /// Solver traits type of polishing
  typedef SolverTraits_ Solver_traits;
#endif

  /// Mesh vertex type
  typedef typename boost::graph_traits<Triangle_mesh>::vertex_descriptor vertex_descriptor;

  /// Mesh halfedge type
  typedef typename boost::graph_traits<Triangle_mesh>::halfedge_descriptor halfedge_descriptor;

  /// Mesh face type
  typedef typename boost::graph_traits<Triangle_mesh>::face_descriptor face_descriptor;

  /// constructs a parameterizer from `options`. The coarse parameterizer is default constructed. If its constructor
  /// takes `ABF_plus_plus_options`, it gets the same `barrier`, `holes` and `fallbacks` of `Flattening_options`.
  explicit Hierarchical_parameterizer_3(const Hierarchical_options& options = Hierarchical_options())
      : Hierarchical_parameterizer_3(options,
                                     internal::ABF::coarse_parameterizer_for<Coarse_parameterizer>(options))
  {}

  /// constructs a parameterizer from `options` and the parameterizer of the coarse chart. It keeps copies of both.
  /// Polishing uses the solver traits object of the coarse parameterizer if this object has the type `Solver_traits`,
  /// and otherwise a default constructed object.
  Hierarchical_parameterizer_3(const Hierarchical_options& options, Coarse_parameterizer coarse_parameterizer)
      : m_options(options), m_coarse_parameterizer(std::move(coarse_parameterizer)),
        m_linear_algebra(internal::ABF::solver_traits_of<Solver_traits>(m_coarse_parameterizer))
  {}

  /// constructs a parameterizer from `options`, the parameterizer of the coarse chart, and a traits object for the
  /// linear systems of polishing. It keeps copies of them.
  Hierarchical_parameterizer_3(const Hierarchical_options& options, Coarse_parameterizer coarse_parameterizer,
                               Solver_traits sparse_la)
      : m_options(options), m_coarse_parameterizer(std::move(coarse_parameterizer)),
        m_linear_algebra(std::move(sparse_la))
  {}

  /// sets the points of the vertices, from the next call of `parameterize()` on; see
  /// `ABF_plus_plus_parameterizer_3::set_points()`.
  template <typename VertexPointMap>
  void set_points(VertexPointMap points)
  {
    m_points = internal::ABF::vertex_points<Triangle_mesh>(points);
  }

  /// sets the numbers that messages call vertices by, from the next call of `parameterize()` on; see
  /// `ABF_plus_plus_parameterizer_3::set_vertex_numbers()`.
  template <typename VertexIndexMap>
  void set_vertex_numbers(VertexIndexMap numbers)
  {
    m_numbers = internal::ABF::vertex_numbers_of<Triangle_mesh>(numbers);
  }

  /// sets how much the angles of each face matter, from the next call of `parameterize()` on; see
  /// `ABF_plus_plus_parameterizer_3::set_importance()`.
  ///
  /// If the coarse parameterizer also has such a member function, it gets the importance of the faces of the coarse
  /// chart. Merged faces get the mean of their importance, weighted by area. (`LSCM_parameterizer_3` has no such
  /// function, and flattens all coarse faces alike.) Relaxation and polishing know the importance of every face.
  template <typename FaceImportanceMap>
  void set_importance(FaceImportanceMap fimap)
  {
    m_importance = internal::ABF::face_importance<Triangle_mesh>(fimap);
  }

  /// sets positions of vertices in the plane, from the next call of `parameterize()` on; see
  /// `ABF_plus_plus_parameterizer_3::set_pins()`. The finished map is moved there, as by the direct method. The coarse
  /// parameterizer knows nothing of pins.
  template <typename VertexPinMap>
  void set_pins(VertexPinMap pins)
  {
    m_pins = internal::ABF::vertex_pins<Triangle_mesh>(pins);
  }

  /// flattens the connected component of `bhd`.
  ///
  /// The result has positive orientation. Without pins, it has the area of the surface, and its bounding box starts at
  /// the origin. On any error `uvmap` is unchanged. Time and memory are linear in the size of the surface, except for
  /// sorting and the
  /// coarse parameterizer.
  ///
  /// Parameters, requirements and exceptions are those of `ABF_plus_plus_parameterizer_3::parameterize()`.
  ///
  /// \return `OK` only if every triangle is positively oriented. Otherwise, `report()` contains the reason. The code is
  /// an error code for the input, as from `ABF_plus_plus_parameterizer_3::parameterize()`, or `ERROR_NO_1_TO_1_MAPPING`
  /// if there is no valid map, none was found, or a visitor or `Flattening_options::time_limit` stopped the
  /// computation. Errors of the coarse parameterizer are not errors of this
  /// function, unless `Flattening_options::fallbacks` is `false`.
  template <typename VertexUVmap, typename VertexIndexMap, typename VertexParameterizedMap>
  Error_code parameterize(Triangle_mesh& mesh, halfedge_descriptor bhd, VertexUVmap uvmap,
                          VertexIndexMap vimap, VertexParameterizedMap vpmap)
  {
    m_outcome.set(Outcome::interrupted());
    internal::ABF::Prescriptions<Triangle_mesh> prescriptions;
    prescriptions.importance = m_importance;
    prescriptions.equal_seam_lengths = false;
    prescriptions.points = m_points;
    prescriptions.numbers = m_numbers;
    prescriptions.may_have_pins = bool(m_pins);
    prescriptions.pins = internal::ABF::with_parameterized_vertices<Triangle_mesh>(m_pins, uvmap, vpmap);
    const auto outcome = internal::ABF::run_parameterizer<Hierarchical_report>(
        mesh, bhd, uvmap, vimap, prescriptions, m_options, m_linear_algebra,
        [&](internal::ABF::Chart& chart, internal::ABF::Rounding round) {
          const internal::ABF::Coarse_solver<Coarse_parameterizer> flatten_coarse(m_coarse_parameterizer);
          return internal::ABF::flatten_chart_hierarchically(
              chart.pins.empty() ? std::move(chart) : internal::ABF::Chart(chart), m_options, flatten_coarse,
              m_linear_algebra, round);
        });
    m_outcome.set(outcome);
    return error_code(outcome->report.status);
  }

  /// returns whether the map is one-to-one on the connected component of `bhd`; see
  /// `ABF_plus_plus_parameterizer_3::is_one_to_one_mapping()`.
  template <typename VertexUVmap>
  bool is_one_to_one_mapping(const Triangle_mesh& mesh, halfedge_descriptor bhd,
                             const VertexUVmap uvmap) const
  {
    return internal::ABF::is_one_to_one(mesh, bhd, uvmap);
  }

  /// returns the traits object that solves the linear systems of polishing.
  const Solver_traits& solver_traits() const
  {
    return m_linear_algebra;
  }

  /// returns the report of the last call of `parameterize()`, on this parameterizer or on a copy.
  /// The offending elements are as for `ABF_plus_plus_parameterizer_3::report()`.
  const Mesh_report<Triangle_mesh, Hierarchical_report>& report() const
  {
    return m_outcome.get().report;
  }

  /// returns the parameterizer of the coarse chart. The default coarse parameterizer has the report of the last coarse
  /// chart.
  const Coarse_parameterizer& coarse_parameterizer() const
  {
    return m_coarse_parameterizer;
  }

private:
  typedef internal::ABF::Outcome<Triangle_mesh, Hierarchical_report> Outcome;

  Hierarchical_options m_options;
  Coarse_parameterizer m_coarse_parameterizer;
  Solver_traits m_linear_algebra;
  internal::ABF::Face_importance<Triangle_mesh> m_importance;
  internal::ABF::Vertex_points<Triangle_mesh> m_points;
  internal::ABF::Vertex_numbers<Triangle_mesh> m_numbers;
  internal::ABF::Vertex_pins<Triangle_mesh> m_pins;
  internal::ABF::Last_outcome<Outcome> m_outcome;
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// replaces \cgal's function of this name, for halfedges that are null or not on a border, as the function for
/// `ABF_plus_plus_parameterizer_3` does.
///
/// \relates Hierarchical_parameterizer_3
template <typename TriangleMesh, typename CoarseParameterizer, typename SolverTraits, typename HD,
          typename VertexUVmap>
Error_code
parameterize(TriangleMesh& mesh,
             Hierarchical_parameterizer_3<TriangleMesh, CoarseParameterizer, SolverTraits> parameterizer,
             HD bhd, VertexUVmap uvmap)
{
  return parameterizer.parameterize(mesh, bhd, uvmap, internal::ABF::numbered_vertices(mesh, bhd),
                                    internal::ABF::None_parameterized());
}

/// \ingroup PkgAngleBasedFlatteningRef
/// \anchor hierarchical_abf_plus_plus_parameterizer
///
/// Hierarchical ABF++: `Hierarchical_parameterizer_3` with `ABF_plus_plus_parameterizer_3` for the coarse chart.
///
/// \tparam TriangleMesh must be a model of `FaceGraph`.
template <typename TriangleMesh>
using Hierarchical_ABF_plus_plus_parameterizer_3 = Hierarchical_parameterizer_3<TriangleMesh, Default>;

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_HIERARCHICAL_PARAMETERIZER_3_H
