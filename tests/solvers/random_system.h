#pragma once

#include <Eigen/Core>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "core/linear_solver.h"
#include "core/parameters.h"

namespace ringlet {

/// Straight strands with these numbers of vertices.
Strands straight_strands(const std::vector<int>& vertex_counts);

/// A symmetric positive definite matrix made as a Newton step makes it, and the same matrix dense
/// (unknown 3 vertex + coordinate), summed from the same terms by other means: masses, positive
/// semi-definite terms over four neighbours, contacts of any two edges, half as many tuples
/// of any vertices, and the root of every second strand pinned.
struct RandomSystem {
  RandomSystem(const std::vector<int>& vertex_counts, int contacts, unsigned seed);

  /// A right-hand side that is zero at pins and pads, as a gradient is.
  VertexField right_hand_side(unsigned seed) const;
  /// The exact solution, by a dense factorisation.
  static Eigen::Matrix3Xd dense_solution(const Eigen::MatrixXd& a, const VertexField& b);

  Strands strands;
  StrandGroups groups;
  VertexScalars free;
  SystemMatrix matrix;
  Eigen::MatrixXd dense;
  /// Without what couples strands, or is left out so that contacts within a strand stay definite.
  Eigen::MatrixXd dense_bands;

 private:
  void add_masses();
  void add_neighbours(std::mt19937& random);
  void add_contact(std::mt19937& random);
  void add_tuple(std::mt19937& random);
  void pin();
};

/// The largest difference of two columns, relative to the largest column of b.
double relative_difference(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b);

/// A solver as a scene would ask for it.
std::unique_ptr<LinearSolver> make_solver(const Json& json);

/// Of strands that fill more than one group, and not all of it.
inline const std::vector<int> mixed_lengths{5, 9, 2, 14, 3, 4, 7, 8, 20, 6, 11};

/// A solver prepared with a copy of a matrix, as a Newton iteration does.
class Prepared {
 public:
  Prepared(LinearSolver& solver, const SystemMatrix& a, VertexField b);

  bool accepted() const { return accepted_; }
  /// solution() is what it was before where the solver writes nothing.
  SolveReport solve() { return solver_.solve(b_, solution_); }
  VertexField& solution() { return solution_; }

 private:
  LinearSolver& solver_;
  SystemMatrix matrix_;
  VertexField b_, solution_;
  bool accepted_;
};

}  // namespace ringlet
