#include "core/rest_states/strand_fit.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseQR>
#include <cmath>

#include "core/error.h"

namespace ringlet {

StrandFit::StrandFit(Model& model, int strand, const VertexField& x)
    : root_(model.strands.first(strand)) {
  const int size = model.strands.size(strand);
  for (int i = 0; i < size; ++i) {
    const auto [row, lane] = model.groups.slot(root_ + i);
    const bool is_pinned = model.free[row][lane] == 0;
    free_index_.push_back(is_pinned ? -1 : free_count_++);
    if (!is_pinned) masses_.push_back(model.strands.mass(root_ + i));
  }
  for (const auto& energy : model.energies) {
    HoldingElements* holding = energy->holding_elements();
    if (holding == nullptr) continue;
    const int vertices = holding->vertices();
    for (int first = 0; first + vertices <= size; ++first) {
      Element element{holding, first, Eigen::Matrix3Xd(3, vertices)};
      for (int n = 0; n < vertices; ++n) element.x.col(n) = x.get(root_ + first + n);
      elements_.push_back(std::move(element));
    }
  }
}

template <class See>
void StrandFit::for_free_rows(const Element& element, const See& see) const {
  for (int i = 0; i < element.x.size(); ++i) {
    const int index = free_index_[element.first + i / 3];
    if (index >= 0) see(3 * index + i % 3, i);
  }
}

Eigen::VectorXd StrandFit::pull(const Element& element) const {
  constexpr double trial = 0.1;  // far from rounding, and from where a rest state would wrap
  const int vertex = root_ + element.first;
  if (element.energy->hold(vertex, element.x, trial) == Hold::impossible) return {};
  const Eigen::VectorXd gradient = element.energy->derivatives(vertex, element.x).gradient / trial;
  element.energy->hold(vertex, element.x, 0);
  return gradient;
}

int StrandFit::hold(const VertexField& loads) {
  // A column an element, scaled to length 1, and a row a free coordinate: what minimises the sum
  // over m |a|^2 is the least-squares solution in the scaled forces m^(-1/2) f.
  std::vector<const Element*> holding;
  std::vector<double> lengths;
  std::vector<Eigen::Triplet<double>> entries;
  for (const Element& element : elements_) {
    Eigen::VectorXd column = pull(element);
    if (column.size() == 0) continue;
    double squared = 0;
    for_free_rows(element, [&](int row, int i) {
      column[i] /= std::sqrt(mass(row));
      squared += column[i] * column[i];
    });
    if (squared == 0) continue;
    const auto number = static_cast<int>(holding.size());
    lengths.push_back(std::sqrt(squared));
    for_free_rows(element, [&](int row, int i) {
      entries.emplace_back(row, number, column[i] / lengths.back());
    });
    holding.push_back(&element);
  }
  if (holding.empty()) return 0;

  Eigen::SparseMatrix<double> pulls(3 * free_count_, static_cast<int>(holding.size()));
  pulls.setFromTriplets(entries.begin(), entries.end());
  Eigen::VectorXd load(3 * free_count_);
  for (int i = 0; const int index : free_index_) {
    const int vertex = root_ + i++;
    if (index >= 0) load.segment<3>(3 * index) = loads.get(vertex) / std::sqrt(masses_[index]);
  }
  const Eigen::SparseQR<Eigen::SparseMatrix<double>, Eigen::COLAMDOrdering<int>> factors(pulls);
  const Eigen::VectorXd solution = factors.solve(-load);

  int without_rest = 0;
  for (std::size_t n = 0; n < holding.size(); ++n) {
    const Element& element = *holding[n];
    const Hold held =
        element.energy->hold(root_ + element.first, element.x, solution[n] / lengths[n]);
    without_rest += held == Hold::without_rest ? 1 : 0;
  }
  return without_rest;
}

bool StrandFit::is_stable() const {
  std::vector<Eigen::Triplet<double>> entries;
  // Stable where H + rate^2 M has no negative eigenvalue.
  constexpr double rate = 1;  // 1/s
  for (int row = 0; row < 3 * free_count_; ++row) {
    entries.emplace_back(row, row, rate * rate * mass(row));
  }
  for (const Element& element : elements_) {
    const Eigen::MatrixXd hessian =
        element.energy->derivatives(root_ + element.first, element.x).hessian;
    for_free_rows(element, [&](int row, int i) {
      for_free_rows(element,
                    [&](int column, int j) { entries.emplace_back(row, column, hessian(i, j)); });
    });
  }
  Eigen::SparseMatrix<double> hessian(3 * free_count_, 3 * free_count_);
  hessian.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(hessian);
  return factors.info() == Eigen::Success && factors.vectorD().minCoeff() > 0;
}

}  // namespace ringlet
