#pragma once

#include <cstring>
#include <utility>

#include "core/autodiff.h"
#include "core/element.h"
#include "core/numeric_filter.h"
#include "core/parameters.h"

namespace ringlet {

template <>
struct EnumNames<Filter> {
  static constexpr std::pair<Filter, const char*> names[] = {
      {Filter::tight, "tight"}, {Filter::paper, "paper"},
      {Filter::exact, "exact"}, {Filter::gauss_newton, "gauss_newton"},
      {Filter::clamp, "clamp"}, {Filter::absolute, "absolute"}};
};

/// The filter of a kernel, as a scene chooses it.
template <class Kernel>
struct FilterChoice {
  Filter filter = Filter::tight;

  static Schema<FilterChoice> schema() {
    return Schema<FilterChoice>()
        .key("filter", &FilterChoice::filter, "", any_number(),
             "how the Hessian of an element is made positive semi-definite")
        .check([](FilterChoice& choice, const std::string& pointer, ParseContext& context) {
          const Filter chosen = choice.filter;
          if (ClosedFormKernel<Kernel> || is_numeric(chosen)) return;
          if (chosen == Filter::tight || chosen == Filter::exact) return;
          context.problem(pointer_to(pointer, "filter"),
                          "it gives only its value; expected one of tight, exact, clamp, absolute");
        });
  }
};

/// The elements of a kernel, one by one or in lanes: value, gradient, and the Hessian with a
/// filter, from the kernel's closed form or, of a kernel that gives only its value, by automatic
/// differentiation.
template <ValueKernel Kernel>
class KernelDerivatives {
 public:
  static constexpr int K = Kernel::vertices;
  template <class S>
  using Rest = typename Kernel::template Rest<S>;

  KernelDerivatives(Kernel kernel, Filter filter) : kernel_(std::move(kernel)), filter_(filter) {}

  const Kernel& kernel() const { return kernel_; }

  /// Whether something remains to be done by a numeric eigensolver when evaluate_kernel() is done.
  bool filters_numerically() const { return is_numeric(filter_); }
  /// use.template operator()<F>() with the filter F that the kernel is asked for.
  template <class Use>
  auto with_kernel_filter(const Use& use) const {
    if (filter_ == Filter::tight) return use.template operator()<Filter::tight>();
    if constexpr (has_closed_form) {
      if (filter_ == Filter::paper) return use.template operator()<Filter::paper>();
      if (filter_ == Filter::gauss_newton) return use.template operator()<Filter::gauss_newton>();
    }
    return use.template operator()<Filter::exact>();
  }
  /// What the kernel itself gives.
  template <Filter filter, class S>
  S evaluate_kernel(const Stencil<S, K>& x, const Rest<S>& rest,
                    ElementOutputs<S, K> outputs) const {
    if constexpr (GeometricKernel<Kernel>) {
      return kernel_.evaluate(kernel_.geometry(x, rest), rest, filter, outputs);
    } else if constexpr (ClosedFormKernel<Kernel>) {
      return kernel_.evaluate(x, rest, filter, outputs);
    } else {
      constexpr auto curvature = filter == Filter::tight ? Curvature::positive : Curvature::exact;
      return evaluate_by_autodiff<curvature>(kernel_, x, rest, outputs);
    }
  }
  /// All of it.
  template <class S>
  [[gnu::flatten]] S evaluate(const Stencil<S, K>& x, const Rest<S>& rest,
                              Derivatives<S, K>& derivatives) const {
    const S energy = with_kernel_filter(
        [&]<Filter filter>() { return evaluate_kernel<filter>(x, rest, derivatives.outputs()); });
    if (filters_numerically()) filter_eigenvalues(filter_, derivatives);
    return energy;
  }

 private:
  static constexpr bool has_closed_form = ClosedFormKernel<Kernel>;

  Kernel kernel_;
  Filter filter_;
};

/// Rest data of the elements in the lanes of packs.
template <class Kernel>
struct RestLanes {
  using Packs = typename Kernel::template Rest<Pack>;
  using One = typename Kernel::template Rest<double>;
  static constexpr int size = sizeof(One) / sizeof(double);
  static_assert(sizeof(Packs) == size * sizeof(Pack), "Rest<S> must hold only scalars S");

  static void set(Packs& packs, int lane, const One& rest) {
    for (int n = 0; n < size; ++n) {
      std::memcpy(reinterpret_cast<char*>(&packs) + n * sizeof(Pack) + lane * sizeof(double),
                  reinterpret_cast<const char*>(&rest) + n * sizeof(double), sizeof(double));
    }
  }
  static One get(const Packs& packs, int lane) {
    One rest;
    for (int n = 0; n < size; ++n) {
      std::memcpy(reinterpret_cast<char*>(&rest) + n * sizeof(double),
                  reinterpret_cast<const char*>(&packs) + n * sizeof(Pack) + lane * sizeof(double),
                  sizeof(double));
    }
    return rest;
  }
};

}  // namespace ringlet
