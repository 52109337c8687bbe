#pragma once

#include <Eigen/SparseQR>
#include <memory>
#include <vector>

#include "core/model.h"

namespace ringlet {

/// A strand in the shape that it is to keep, and the elements that may hold it there.
class StrandFit {
 public:
  /// x: the shape of all strands, m. The model must outlive it.
  StrandFit(Model& model, int strand, const VertexField& x);

  int strand() const { return strand_; }
  bool is_free() const { return free_count_ > 0; }
  /// Chooses the rest states of its elements so that what is left of the loads' gradient, N, sets
  /// it in motion least: the accelerations a_i have the least sum m_i |a_i|^2, as those of a chain
  /// of rods that ideal joints would let move (Gauss's principle of least constraint). Called again
  /// with the gradient that is left, it corrects what rounding has spoilt. Returns the number of
  /// elements whose rest state no shape has.
  int hold(const VertexField& gradient);
  /// Whether no small motion grows by itself, by a factor of e in a second or faster.
  bool is_stable() const;

 private:
  struct Element {
    HoldingElements* energy;
    int first;           ///< its first vertex, counted from the root
    Eigen::Matrix3Xd x;  ///< of its vertices
  };

  /// m^(-1/2) times the gradient of an element a unit of slope, scaled to length 1: what minimises
  /// the sum over m |a|^2 is the least-squares solution in the weighted forces m^(-1/2) f.
  struct Pull {
    std::size_t element;
    Eigen::VectorXd direction;
    double length;
  };

  /// Calls see(row, i) for all coordinates i of the element that are free, and their rows among
  /// those of the strand.
  template <class See>
  void for_free_rows(const Element& element, const See& see) const;
  /// Empty if the element can hold nothing.
  Eigen::VectorXd weighted_pull(const Element& element) const;
  /// Of all elements that can hold anything.
  std::vector<Pull> pulls() const;
  void factorise();
  /// m^(-1/2) times a gradient, a row a free coordinate.
  Eigen::VectorXd weighted(const VertexField& gradient) const;
  double mass(int row) const { return masses_[row / 3]; }

  int strand_;
  int root_;  ///< its number among all vertices
  int free_count_ = 0;
  std::vector<int> free_index_;    ///< of each vertex among the free ones; -1: pinned
  std::vector<double> masses_;     ///< of the free vertices, kg
  std::vector<Element> elements_;  ///< by their last vertices
  std::vector<Pull> pulls_;
  std::vector<double> slopes_;  ///< of the elements of the pulls
  /// Of the matrix whose columns are the pulls; null: there are none.
  std::unique_ptr<Eigen::SparseQR<Eigen::SparseMatrix<double>, Eigen::NaturalOrdering<int>>>
      factors_;
};

}  // namespace ringlet
