#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "core/huge_pages.h"
#include "core/strand_bands.h"
#include "core/vertex_field.h"

namespace ringlet {

/// A term E(u) of the potential that depends on a weighted sum of up to four vertices, as a contact
/// is, at some positions:
///
///     u = sum_i w_i x_i,    dE/dx_i = w_i g,    d2E/dx_i dx_j = w_i w_j C
struct CouplingTerm {
  /// All different; the first two and the last two of them are neighbours on a strand (two edges)
  /// where they have weight.
  std::array<int, 4> vertices;
  std::array<double, 4> weights;  ///< 0: the vertex takes no part
  Eigen::Vector3d gradient;       ///< g
  Eigen::Matrix3d curvature;      ///< C, symmetric and positive semi-definite
};

/// A term E(x_0, ..., x_{n-1}) of the potential of up to four vertices of any strands.
struct TupleTerm {
  int count = 0;                ///< n
  std::array<int, 4> vertices;  ///< all different
  /// dE/dx_i, and the blocks of the Hessian, which is positive semi-definite.
  std::array<Eigen::Vector3d, 4> gradient;
  std::array<std::array<Eigen::Matrix3d, 4>, 4> hessian;
};

/// The terms that couple arbitrary vertices, and what they are for a linear solver: a part that
/// fits into the bands of the strands, and one that couples edges beyond them.
///
/// A term goes into the bands as a whole where all its vertices are near each other on one strand.
/// Else the bands have what each of its two edges would feel if the other one stood still, and
/// beyond them is what one edge feels of the other. A tuple is treated in the same way, in as many
/// parts as its vertices are far from each other. What remains in the bands is never indefinite.
class Couplings {
 public:
  Couplings() = default;
  explicit Couplings(const StrandGroups& groups)
      : groups_(&groups), of_group_(groups.count()), place_(groups.vertex_count(), -1) {}

  void clear();
  void add(const CouplingTerm& term) { terms_.push_back(term); }
  void add(const TupleTerm& term) { tuples_.push_back(term); }
  /// Appends terms that the caller writes, every member; valid until more are added.
  std::span<CouplingTerm> append(int count);
  /// Sorts what was added; call once after the last term. What one edge feels of another one leaves
  /// pinned vertices out: free is 1 for a free vertex and 0 for a pinned one.
  void finish(const VertexScalars& free);

  /// The memory that they hold.
  std::size_t bytes() const;
  bool empty() const { return terms_.empty() && tuples_.empty(); }
  /// Adds the gradients of the terms to the rows of a group.
  void add_gradient(int group, std::span<Vector3<Pack>> rows) const;
  /// Adds what fits there to the bands of a group.
  void add_to_bands(int group, GroupBands bands) const;
  /// Whether there is anything to add to a group.
  bool has_part_in(int group) const {
    return of_group_[group].part_count > 0 || !of_group_[group].tuple_parts.empty();
  }

  /// Whether an edge of the group feels another one beyond the bands.
  bool touches(int group) const {
    return of_group_[group].felt_count > 0 || !of_group_[group].blocks.empty();
  }
  /// The vertices that are coupled beyond the bands, one group after the other.
  int coupled_count() const { return static_cast<int>(coupled_.size()); }
  /// Those of a group, one strand after the other, and the number of the first among all of them.
  std::span<const int> coupled(int group) const {
    return std::span(coupled_).subspan(of_group_[group].first_coupled,
                                       of_group_[group].coupled_count);
  }
  int first_coupled(int group) const { return of_group_[group].first_coupled; }
  /// The first row of a group in which any is.
  int first_coupled_row(int group) const { return of_group_[group].first_coupled_row; }
  /// y = C x for the coupled vertices of a group, C being the matrix beyond the bands; x has an
  /// entry a coupled vertex of all groups.
  void multiply(int group, std::span<const Vector3<double>> x, std::span<Vector3<double>> y) const;
  /// y += C x for the rows of a group.
  void add_product(int group, const VertexField& x, VertexField& y) const;

  /// Visits the blocks beyond the bands, both triangles: visit(row_vertex, column_vertex, block).
  /// The matrix has at a place the sum of all that are visited there.
  template <class Visit>
  void for_each_off_band(const Visit& visit) const {
    for (const OfGroup& group : of_group_) {
      for (const Felt& felt : felt_of(group)) {
        for (int a = 0; a < 2; ++a) {
          for (int b = 0; b < 2; ++b) {
            const double weight = felt.row_weights[a] * felt.column_weights[b];
            if (weight == 0) continue;
            visit(coupled_[felt.rows[a]], coupled_[felt.columns[b]], weight * felt.full());
          }
        }
      }
      for (const Block& block : group.blocks) {
        visit(coupled_[block.row], coupled_[block.column], block.matrix());
      }
    }
  }

 private:
  /// A term as the strand of one or both of its edges sees it.
  struct Part {
    int term;
    int first, end;  ///< of its vertices in the term
  };
  /// What an edge feels of another one: w_i C sum_j w_j x_j.
  struct Felt {
    std::array<int, 2> rows, columns;  ///< among the coupled vertices
    std::array<double, 2> row_weights, column_weights;
    std::array<double, 6> curvature;  ///< xx, xy, xz, yy, yz, zz

    Eigen::Matrix3d full() const;
    Vector3<double> force(const Vector3<double>& u) const;
  };
  /// Vertices of a tuple that are near each other on one strand.
  struct TuplePart {
    int tuple;
    std::array<bool, 4> has;
  };
  /// What one vertex of a tuple feels of another one, which is of another part.
  struct Block {
    int row, column;  ///< among the coupled vertices
    std::array<double, 9> entries;

    Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> matrix() const {
      return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(entries.data());
    }
    friend Vector3<double> operator*(const Block& block, const Vector3<double>& u) {
      const auto& e = block.entries;
      return {e[0] * u.x + e[1] * u.y + e[2] * u.z, e[3] * u.x + e[4] * u.y + e[5] * u.z,
              e[6] * u.x + e[7] * u.y + e[8] * u.z};
    }
  };
  /// The groups of the two edges of a term; -1: none. All of it is with the first if it is whole.
  struct Split {
    bool is_whole;
    int first_group, second_group;
  };
  struct OfGroup {
    /// In the parts of all groups, and as many places for what is felt.
    int first_part = 0, part_count = 0, felt_count = 0;
    std::vector<TuplePart> tuple_parts;
    std::vector<Block> blocks;
    int first_coupled = 0, coupled_count = 0, first_coupled_row = 0;
  };

  struct FreeEnd {
    std::array<int, 2> vertices;
    std::array<double, 2> weights;

    bool has_weight() const { return weights[0] != 0 || weights[1] != 0; }
  };

  std::span<const Part> parts_of(const OfGroup& group) const {
    return std::span(parts_).subspan(group.first_part, group.part_count);
  }
  std::span<const Felt> felt_of(const OfGroup& group) const {
    return std::span(felt_).subspan(group.first_part, group.felt_count);
  }
  const CouplingTerm& term_of(std::span<const Part> parts, std::size_t n) const;
  bool is_one_part(const CouplingTerm& term) const;
  bool fit_into_band(int i, int j) const;
  void distribute();
  template <class Visit>
  void for_each_part(int block, const Visit& visit) const;
  void distribute(int tuple);
  bool fits(const TupleTerm& term, const TuplePart& part, int member) const;
  void find_blocks(int group, const VertexScalars& free);
  bool is_free(int vertex, const VertexScalars& free) const;
  void mark(int group, int vertex);
  void add_to_bands(const TuplePart& part, int first_row, GroupBands bands) const;
  Split split(const CouplingTerm& term) const;
  void find_felt(int group, const VertexScalars& free);
  FreeEnd free_end(const CouplingTerm& term, int first, const VertexScalars& free) const;
  void number_coupled(int group);

  const StrandGroups* groups_ = nullptr;
  StreamedVector<CouplingTerm> terms_;
  std::vector<TupleTerm> tuples_;
  StreamedVector<Split> split_;  ///< of each term
  std::vector<int> begins_;      ///< of the parts of each block of terms in each group
  std::vector<OfGroup> of_group_;
  StreamedVector<Part> parts_;  ///< one group after the other
  StreamedVector<Felt> felt_;   ///< of a group from its first part on, none of what is whole
  std::vector<int> coupled_;
  std::vector<int> place_;  ///< of each vertex among these; -1: none
};

}  // namespace ringlet
