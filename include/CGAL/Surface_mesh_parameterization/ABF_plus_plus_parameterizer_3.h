// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_ABF_PLUS_PLUS_PARAMETERIZER_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_ABF_PLUS_PLUS_PARAMETERIZER_3_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_options.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_report.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/one_to_one.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/prescriptions.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_pins.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/run_parameterizer.h>

#include <CGAL/Default.h>
#include <CGAL/boost/graph/properties.h>

#include <memory>
#include <utility>
#include <vector>

/// \file ABF_plus_plus_parameterizer_3.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// The class `ABF_plus_plus_parameterizer_3` implements *ABF++*, angle-based flattening \cgalCite{cgal:slmb-abf-05}: a
/// free-border parameterization that finds the planar angles nearest to the angles of the surface, and then the planar
/// triangulation with these angles.
///
/// The map is nearly conformal, and it has no flipped triangles: an exact predicate checks the orientation of every
/// triangle, on the coordinates that are written. On surfaces that are hard to flatten, it stretches much less than
/// linear conformal maps.
///
/// These defaults are not those of the paper (Section \ref ABF_math explains them):
///
/// | option | default | why | as in the paper |
/// | :----- | :------ | :-- | :-------------- |
/// | `Flattening_options::barrier` | 0.1 | keeps angles away from zero | 0 |
/// | `ABF_plus_plus_options::step` | `NEWTON` | converges quadratically | `SEQUENTIAL_LINEARLY_CONSTRAINED` |
/// | `ABF_plus_plus_options::linear_solver` | `ITERATIVE` | needs fewer factorizations | `DIRECT` |
/// | `ABF_plus_plus_options::layout` | `AUTOMATIC_LAYOUT` | exact where angles fit together | `LEAST_SQUARES_LAYOUT` |
///
/// Constraints in logarithms, the line search, the stopping rule and the pinned vertices of the layout are ours in any
/// case.
///
/// \cgalModels{Parameterizer_3}
///
/// \tparam TriangleMesh_ must be a model of `FaceGraph`. Edges may be the border of a seam (`Seam_mesh`).
///
/// \tparam SolverTraits_ must be a model of `SparseLinearAlgebraTraits_d` with a field number type. If it models
/// `SparseLinearAlgebraWithFactorTraits_d`, its factorizations are reused. The matrices are symmetric positive
/// definite. Each is factored by a solver that `Solver_traits_factory<SolverTraits_>` makes of the given object. If the
/// factors only precondition conjugate gradients, the counterpart of lower precision,
/// `Low_precision_solver_traits<SolverTraits_>`, factors them.<br>
///         <b>%Default:</b> `CGAL::SuperLU_solver_traits<>`, which needs SuperLU
///
/// Each copy of a parameterizer has a report of its own. Several copies can flatten several charts at once.
/// `CGAL::Surface_mesh_parameterization::parameterize()` takes its parameterizer by value. At the end of a run, the
/// copy passes its report on to the parameterizer that it was copied from, where the report can be read.
///
/// A parameterizer can be called again. It keeps what it found out about the pattern of its matrices, and shares that
/// with its copies. With `ABF_plus_plus_options::warm_start`, it also starts from the angles of the last call.
///
/// \sa `CGAL::Surface_mesh_parameterization::LSCM_parameterizer_3`
/// \sa `CGAL::Surface_mesh_parameterization::ARAP_parameterizer_3`
template <typename TriangleMesh_, typename SolverTraits_ = Default>
class ABF_plus_plus_parameterizer_3
{
public:
  /// Triangle mesh type
  typedef TriangleMesh_ Triangle_mesh;
  /// Same as `Triangle_mesh`
  typedef TriangleMesh_ TriangleMesh;

#ifndef DOXYGEN_RUNNING
  typedef typename Default::Lazy_get<SolverTraits_, internal::ABF::Default_solver_traits<TriangleMesh_>>::type
      Solver_traits;
#else
  /// Solver traits type
  typedef SolverTraits_ Solver_traits;
#endif

  /// Mesh vertex type
  typedef typename boost::graph_traits<Triangle_mesh>::vertex_descriptor vertex_descriptor;

  /// Mesh halfedge type
  typedef typename boost::graph_traits<Triangle_mesh>::halfedge_descriptor halfedge_descriptor;

  /// Mesh face type
  typedef typename boost::graph_traits<Triangle_mesh>::face_descriptor face_descriptor;

  /// constructs a parameterizer from `options` and a traits object for the sparse linear systems, and keeps copies of
  /// both. A visitor in the options must outlive the calls of `parameterize()`.
  explicit ABF_plus_plus_parameterizer_3(const ABF_plus_plus_options& options = ABF_plus_plus_options(),
                                         Solver_traits sparse_la = Solver_traits())
      : m_options(options), m_linear_algebra(std::move(sparse_la)), m_solvers(m_linear_algebra)
  {
    m_prescriptions.equal_seam_lengths = options.equal_seam_lengths;
  }

  /// sets the points of the vertices, from the next call of `parameterize()` on. Without a call of this function, they
  /// are `get(CGAL::vertex_point, mesh)`.
  ///
  /// The function keeps a copy of the property map, and so do copies of the parameterizer. `parameterize()` reads it
  /// once for each vertex.
  ///
  /// \tparam VertexPointMap must be a model of `ReadablePropertyMap` with
  ///   `boost::graph_traits<Triangle_mesh>::%vertex_descriptor` as key type and a `Point_3` of any kernel as value
  ///   type. For a `Seam_mesh`, the key type can also be the vertex descriptor of the mesh that it cuts.
  template <typename VertexPointMap>
  void set_points(VertexPointMap points)
  {
    m_prescriptions.points = internal::ABF::vertex_points<Triangle_mesh>(points);
  }

  /// sets the numbers that messages call vertices by, from the next call of `parameterize()` on. Without a call of this
  /// function, they are positions in the sequence of vertices, from 0; of a `Seam_mesh`, positions in that of the mesh
  /// that it cuts.
  ///
  /// \tparam VertexIndexMap must be a model of `ReadablePropertyMap` with
  ///         `boost::graph_traits<Triangle_mesh>::%vertex_descriptor` as key type and an integer as value type. Several
  ///         vertices may have the same number.
  template <typename VertexIndexMap>
  void set_vertex_numbers(VertexIndexMap numbers)
  {
    m_prescriptions.numbers = internal::ABF::vertex_numbers_of<Triangle_mesh>(numbers);
  }

  /// sets how much the angles of each face matter, from the next call of `parameterize()` on. Without a call of this
  /// function, all faces have the importance 1.
  ///
  /// The importance of a face is its weight in the energy: a factor of the squared relative changes of its angles, and
  /// of their barrier. Faces of large importance change less, and the faces around them change more. Only ratios
  /// matter: if all faces have the same importance, it has no effect. On scanned surfaces, patches of 5 % of the faces
  /// with the importance 10 had 0.6 to 0.9 times their angular distortion, and the rest of the surface had up to 6 %
  /// more. With the importance 0.1, they had 1.4 to 3.5 times their angular distortion.
  ///
  /// The importance of every face of the flattened component must be in [0.1, 10]. It has no unit. Otherwise,
  /// `parameterize()` returns `ERROR_WRONG_PARAMETER` with the diagnosis `Diagnosis::WRONG_WEIGHT`, and the
  /// `Mesh_report::offending_faces` of `report()` are these faces. If neighbouring faces differ by a factor of 100, the
  /// solver may take 25 times as many steps.
  ///
  /// The function keeps a copy of the property map, and so do copies of the parameterizer. `parameterize()` reads it
  /// once for each face.
  ///
  /// \tparam FaceImportanceMap must be a model of `ReadablePropertyMap` with
  ///         `boost::graph_traits<Triangle_mesh>::%face_descriptor` as key type and a value type that is convertible
  ///         to `double`.
  template <typename FaceImportanceMap>
  void set_importance(FaceImportanceMap fimap)
  {
    m_prescriptions.importance = internal::ABF::face_importance<Triangle_mesh>(fimap);
  }

  /// prescribes sums of planar angles at vertices of the outer border, or at cones, from the next call of
  /// `parameterize()` on. At a vertex of the outer border, the sum is the inner angle of the border in the plane.
  /// Angles that are not prescribed are free. If all vertices between two others have the angle \f$\pi\f$, the border
  /// between these two is a straight line; `polygon_angles()` and `rectangle_angles()` prescribe whole polygons.
  ///
  /// All other angles change as little as the prescribed angles allow. The exact layout turns by exactly the prescribed
  /// angles, so that sides are straight up to rounding, independent of the tolerance. The map is locally injective. It
  /// overlaps itself if the prescribed border does.
  ///
  /// Before anything is solved, `parameterize()` checks whether a map with these angles exists. If not, it returns
  /// `ERROR_WRONG_PARAMETER` with one of these diagnoses:
  /// - `Diagnosis::WRONG_ANGLE_SUM`: an angle is not positive and finite, is not at the outer border, or is as large
  ///   as the triangles at its vertex do not allow, which have less than \f$\pi\f$ each. `offending_vertices`
  ///   are the vertices.
  /// - `Diagnosis::WRONG_ANGLE_TOTAL`: if \f$m\f$ border vertices all have prescribed angles, their sum must be \f$(m -
  ///   2)\pi\f$, up to \f$10^{-6}\f$, which is put onto the largest angle. Otherwise, what is left to the other
  ///   vertices must be positive, and less than \f$\pi\f$ for each triangle there. `offending_vertices` are these other
  ///   vertices.
  /// - `Diagnosis::FLAT_CHORD`: an edge joins two border vertices, and the border does not turn towards it between
  ///   them. That is so where a straight side runs along a triangle with two border edges. `offending_vertices`
  ///   are the two vertices of each such edge. `split_flat_chords()` splits these edges.
  /// - `Diagnosis::INFEASIBLE_ANGLE_SUMS`: other angles that the triangles near them cannot give, which
  ///   `offending_vertices` are. This is possible only if an angle is above \f$\pi\f$.
  ///
  /// If the map does not have the prescribed angles up to `ABF_plus_plus_options::tolerance`, it is not returned, and
  /// the diagnosis is `Diagnosis::NO_CONVERGENCE`. With `Flattening_options::injective`, a map that overlaps itself is
  /// an error.
  ///
  /// With equal seam lengths (`ABF_plus_plus_options::equal_seam_lengths`), sums are those of the surface before it was
  /// cut. For a vertex in the middle of a seam, this is the sum of all angles around the vertex; unless the sum is
  /// \f$2\pi\f$, the vertex is a *cone*. For a vertex of the border of the surface, it is the inner angle. All copies
  /// of a vertex must have the same sum. Seam vertices missing from the map get \f$2\pi\f$, and rigid motions map one
  /// side of a seam to the other. The sum of a cone with `free_cone_angle` is free. If no sum is free, all sums
  /// together must be \f$\pi\f$ times the number of triangles: on a closed surface of Euler characteristic \f$\chi\f$,
  /// the sum of \f$2\pi - \theta\f$ over all cones must be \f$2\pi\chi\f$. Chords without room then have the diagnosis
  /// `Diagnosis::INFEASIBLE_ANGLE_SUMS`, and sides are straight only up to the tolerance.
  ///
  /// The function keeps a copy of the property map, and so do copies of the parameterizer. `parameterize()` reads it
  /// once for each vertex.
  ///
  /// \tparam VertexAngleSumMap must be a model of `ReadablePropertyMap` with
  ///         `boost::graph_traits<Triangle_mesh>::%vertex_descriptor` as key type and a value type that is convertible
  ///         to `std::optional<double>`. The angles are in radians. For a `Seam_mesh`, the key type can also be the
  ///         vertex descriptor of the mesh that it cuts, as in `Cone_selection::angles()`. This needs equal seam
  ///         lengths, which are then the default.
  template <typename VertexAngleSumMap>
  void set_angle_sums(VertexAngleSumMap angle_sums)
  {
    m_prescriptions.angle_sums = internal::ABF::vertex_angle_sums<Triangle_mesh>(angle_sums);
  }

  /// sets the pairs of halfedges that are the two sides of a seam edge, for a mesh that was cut open by copying its
  /// vertices, from the next call of `parameterize()` on. A `Seam_mesh` needs no call of this function.
  /// `ABF_plus_plus_options::equal_seam_lengths` and `ABF_plus_plus_report::largest_seam_jump` use these pairs.
  ///
  /// The other side of the other side of a halfedge must be itself. Otherwise, `parameterize()` returns
  /// `ERROR_WRONG_PARAMETER` with the diagnosis `Diagnosis::WRONG_OPTION`, and `offending_vertices` are the
  /// vertices of an edge. The function keeps a copy of the property map, and so do copies of the parameterizer.
  ///
  /// \tparam HalfedgeSideMap must be a model of `ReadablePropertyMap` with
  ///         `boost::graph_traits<Triangle_mesh>::%halfedge_descriptor` as key type and value type. It maps each
  ///         halfedge without a face to the halfedge on the other side, or to the null halfedge if there is no seam.
  template <typename HalfedgeSideMap>
  void set_seam_sides(HalfedgeSideMap sides)
  {
    m_prescriptions.set_seam_sides(sides);
  }

  /// sets positions of vertices in the plane, from the next call of `parameterize()` on. Without a call of this
  /// function, the map has the area of the surface, and its bounding box starts at the origin.
  ///
  /// - One pin moves the map by a translation.
  /// - Two pins move, turn and scale it: they are exactly at their positions, and no angle changes.
  /// - More pins change angles. The map of least change has all pins exactly at their positions, or near to them if
  ///   `Flattening_options::pin_weight` is finite. Change is spread where triangles would be flipped otherwise.
  ///
  /// The coordinates are certified after that. `Flattening_report::largest_pin_distance` says how far the worst pin is
  /// from its position, and `Flattening_report::largest_pin_angle_change` and
  /// `Flattening_report::mean_pin_angle_change` what pins cost. Energy, steps, and contacts of injective maps in the
  /// report are those before pins.
  ///
  /// Errors are:
  /// - `Diagnosis::WRONG_PIN`: a position is not finite, or two pins have the same position. `offending_vertices`
  ///   are these vertices.
  /// - `Diagnosis::INFEASIBLE_PINS`: with more than two pins, triangles would be flipped, which `offending_faces`
  ///   are, or an injective map (`Flattening_options::injective`) would overlap itself. `offending_vertices` are the
  ///   pin that is farthest from where the map without change has it, or all pins if a mirrored map would be nearer.
  /// - `Diagnosis::PRECISION_EXCEEDED`: the positions are so near to one another, or so far from the origin, that the
  ///   numbers of the coordinates cannot hold the map.
  /// - `Diagnosis::WRONG_OPTION`: there are more than two pins, and prescribed angles (`set_angle_sums()`). With equal
  ///   seam lengths, more than two pins make them differ (`ABF_plus_plus_report::largest_seam_jump`).
  ///
  /// Each copy of a vertex on a seam of a `Seam_mesh` is a vertex of its own, with or without a pin. Pins of other
  /// components have no effect. A call of the member `parameterize()` can also pass pins in `uvmap` and `vpmap`, as the
  /// concept `Parameterizer_3` has it.
  ///
  /// The function keeps a copy of the property map, and so do copies of the parameterizer. `parameterize()` reads it
  /// once for each vertex.
  ///
  /// \tparam VertexPinMap must be a model of `ReadablePropertyMap` with
  ///         `boost::graph_traits<Triangle_mesh>::%vertex_descriptor` as key type and `std::optional` of a
  ///         two-dimensional point as value type.
  template <typename VertexPinMap>
  void set_pins(VertexPinMap pins)
  {
    m_prescriptions.pins = internal::ABF::vertex_pins<Triangle_mesh>(pins);
  }

  /// flattens the connected component of `bhd`.
  ///
  /// The result has positive orientation. Without pins, it has the area of the surface, and its bounding box starts at
  /// the origin. On any error `uvmap` is unchanged. `mesh` is only read.
  ///
  /// Computations are in `double`. Points are converted to `double`, and coordinates are converted to the number type
  /// of `VertexUVmap`.
  ///
  /// For \f$n\f$ vertices, the time is that of a few sparse factorizations with \cgalBigO{n^{3/2}} operations each. If
  /// `ABF_plus_plus_options::linear_solver` is `ABF_plus_plus_options::ITERATIVE`, two matrices of order \f$n\f$ are
  /// factored. If it is `ABF_plus_plus_options::DIRECT`, one matrix of order \f$2n\f$ is factored for each Newton step.
  /// The layout needs one more factorization. The factors take \cgalBigO{n \log n} memory.
  ///
  /// \tparam VertexUVmap must be a model of `ReadWritePropertyMap` with
  ///         `boost::graph_traits<Triangle_mesh>::%vertex_descriptor` as key type and
  ///         %Point_2 (type deduced from `Triangle_mesh` using `Kernel_traits`) as value type.
  /// \tparam VertexIndexMap must be a model of `ReadablePropertyMap` with
  ///         `boost::graph_traits<Triangle_mesh>::%vertex_descriptor` as key type and
  ///         a unique integer as value type. The integers need not be consecutive.
  /// \tparam VertexParameterizedMap must be a model of `ReadablePropertyMap` with
  ///         `boost::graph_traits<Triangle_mesh>::%vertex_descriptor` as key type and a value type that is convertible
  ///         to `bool`.
  ///
  /// \param mesh a surface whose component at `bhd` is a triangulated disk. All requirements are checked.
  /// \param bhd a halfedge on the border of `mesh`: one without a face.
  /// \param uvmap receives the coordinates of the component's vertices. Only positions of pins are read from it. The
  /// coordinates of other vertices are unchanged.
  /// \param vimap the indices of the vertices.
  /// \param vpmap `true` for vertices that are parameterized already: they are pinned at their coordinates in `uvmap`,
  /// as by `set_pins()`, which may pin others. It is only read.
  ///
  /// \return `OK` only if every triangle is positively oriented. Otherwise, with the reason in `report()`:
  /// - `ERROR_EMPTY_MESH`: there is no face at `bhd`;
  /// - `ERROR_NON_TRIANGULAR_MESH`: a face is not a triangle;
  /// - `ERROR_NO_TOPOLOGICAL_DISC`: the surface is closed, or the component is not a manifold, has handles, or has more
  ///   than one border and `Flattening_options::holes` is `Flattening_options::REFUSE`;
  /// - `ERROR_NO_1_TO_1_MAPPING`: there is no valid map (two edges join the same vertices), no valid map was found, or
  ///   a visitor or `Flattening_options::time_limit` stopped the computation;
  /// - `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM`: the solver traits failed;
  /// - `ERROR_WRONG_PARAMETER`: `bhd` is not on a border, but others are, a coordinate is not finite, no triangle
  ///   has an area, there are more than 153 million triangles, the importance of a face is out of its range, pins
  ///   are not finite or not apart, prescribed angles are not possible, or an option is out of its range or does
  ///   not apply.
  ///
  /// \exception std::bad_alloc if memory runs out. Exceptions of a visitor or a property map pass through.
  template <typename VertexUVmap, typename VertexIndexMap, typename VertexParameterizedMap>
  Error_code parameterize(Triangle_mesh& mesh, halfedge_descriptor bhd, VertexUVmap uvmap,
                          VertexIndexMap vimap, VertexParameterizedMap vpmap)
  {
    const std::shared_ptr<const internal::ABF::Planar_angles> last = m_outcome.angles();
    m_outcome.set(Outcome::interrupted());
    internal::ABF::Prescriptions<Triangle_mesh> prescriptions = m_prescriptions;
    prescriptions.may_have_pins = bool(m_prescriptions.pins);
    prescriptions.pins =
        internal::ABF::with_parameterized_vertices<Triangle_mesh>(m_prescriptions.pins, uvmap, vpmap);
    const auto outcome = internal::ABF::run_parameterizer<ABF_plus_plus_report>(
        mesh, bhd, uvmap, vimap, prescriptions, m_options, m_solvers,
        [&](const internal::ABF::Chart& chart, internal::ABF::Rounding round) {
          return internal::ABF::flatten_chart(chart, m_options, m_solvers, round, last.get());
        });
    if(outcome->angles == nullptr)
      outcome->angles = last;
    m_outcome.set(outcome);
    return error_code(outcome->report.status);
  }

  /// returns whether the map is one-to-one on the connected component of `bhd`, in the sense of `is_injective()`: no
  /// triangle is flipped or degenerate, and no two points of the component have the same image. The result is `false`,
  /// too, if `bhd` is not on a border or a face is not a triangle.
  ///
  /// The coordinates in `uvmap` may come from any parameterizer. They are converted to `double`, and the answer is
  /// exact for these numbers; for more precise numbers, use `is_injective()` instead. Unlike functions of this name in
  /// \cgal, this one refuses a map that is mirrored as a whole. The result of `parameterize()` need not pass: it is
  /// locally injective (`is_locally_injective()`), and passes if and only if `Flattening_report::border_is_simple` is
  /// `true`.
  ///
  /// \tparam VertexUVmap must be a model of `ReadablePropertyMap` with
  ///         `boost::graph_traits<Triangle_mesh>::%vertex_descriptor` as key type and a two-dimensional point as value
  ///         type.
  template <typename VertexUVmap>
  bool is_one_to_one_mapping(const Triangle_mesh& mesh, halfedge_descriptor bhd,
                             const VertexUVmap uvmap) const
  {
    return internal::ABF::is_one_to_one(mesh, bhd, uvmap);
  }

  /// returns the given traits object. Copies of it factor the matrices.
  const Solver_traits& solver_traits() const
  {
    return m_linear_algebra;
  }

  /// returns the report of the last call of `parameterize()`, on this parameterizer or on a copy. The next call
  /// changes the report, so do not read it while a copy runs.
  ///
  /// The offending vertices are a vertex that is pinched, is on a second border, or has a coordinate that is not
  /// finite, the two that parallel edges join, or what `set_angle_sums()`, `set_seam_sides()` and `set_pins()` say. The
  /// offending faces are a face that is not a triangle or is at a parallel edge, all faces whose importance is out of
  /// its range, or all faces that would be flipped or wind around a vertex more than once.
  const Mesh_report<Triangle_mesh, ABF_plus_plus_report>& report() const
  {
    return m_outcome.get().report;
  }

private:
  typedef internal::ABF::Outcome<Triangle_mesh, ABF_plus_plus_report> Outcome;

  ABF_plus_plus_options m_options;
  Solver_traits m_linear_algebra;
  internal::ABF::Linear_solvers m_solvers; // shared with copies, as they remember what they analyzed
  internal::ABF::Prescriptions<Triangle_mesh> m_prescriptions;
  internal::ABF::Last_outcome<Outcome> m_outcome;
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// replaces \cgal's function of this name. If the halfedge is null or not on a border, this function violates no
/// precondition. If the surface is closed, it returns `ERROR_NO_TOPOLOGICAL_DISC`, and the status in the report is
/// `Diagnosis::NO_BORDER`; if not, `ERROR_WRONG_PARAMETER` and `Diagnosis::NOT_ON_BORDER`. Otherwise, both functions
/// are the same.
///
/// \relates ABF_plus_plus_parameterizer_3
template <typename TriangleMesh, typename SolverTraits, typename HD, typename VertexUVmap>
Error_code parameterize(TriangleMesh& mesh,
                        ABF_plus_plus_parameterizer_3<TriangleMesh, SolverTraits> parameterizer, HD bhd,
                        VertexUVmap uvmap)
{
  return parameterizer.parameterize(mesh, bhd, uvmap, internal::ABF::numbered_vertices(mesh, bhd),
                                    internal::ABF::None_parameterized());
}

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_ABF_PLUS_PLUS_PARAMETERIZER_3_H
