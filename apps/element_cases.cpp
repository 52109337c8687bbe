#include "apps/element_cases.h"

#include <map>

#include "core/read_choice.h"

namespace ringlet {
namespace {

/// The energies of the cases, each made once, with the exact filter and with the wanted one.
class CaseEnergies {
 public:
  CaseEnergies(const Registry& registry, const std::optional<std::string>& filter)
      : registry_(registry), filter_(filter) {}

  /// Null, with a problem, if there is no such energy or it has no such elements.
  const ElementFunction* exact(const std::string& name, const std::string& pointer,
                               std::vector<Problem>& problems) {
    return find(name, "exact", pointer, problems);
  }
  const ElementFunction* filtered(const std::string& name, const std::string& pointer,
                                  std::vector<Problem>& problems) {
    return filter_ ? find(name, *filter_, pointer, problems) : nullptr;
  }

 private:
  const ElementFunction* find(const std::string& name, const std::string& filter,
                              const std::string& pointer, std::vector<Problem>& problems) {
    std::unique_ptr<Energy>& energy = energies_[{name, filter}];
    if (energy == nullptr) {
      std::vector<Problem> own;
      const auto choice = read_choice<Energy>(registry_, {{"type", name}, {"filter", filter}}, own);
      for (const Problem& problem : own) problems.push_back({pointer, problem.message});
      if (!own.empty()) return nullptr;
      energy = choice.make();
    }
    if (energy->element_function() == nullptr) {
      problems.push_back({pointer, "the elements of '" + name +
                                       "' do not follow from a stiffness and one rest value"});
    }
    return energy->element_function();
  }

  const Registry& registry_;
  const std::optional<std::string>& filter_;
  std::map<std::pair<std::string, std::string>, std::unique_ptr<Energy>> energies_;
};

struct ElementCase {
  std::string energy;
  std::vector<Eigen::Vector3d> positions;
  double stiffness = 0, rest = 0;

  static Schema<ElementCase> schema() {
    return Schema<ElementCase>()
        .required("energy", &ElementCase::energy, "", any_number(), "name of an energy")
        .required("positions", &ElementCase::positions, "m", any_number(), "of the vertices")
        .required("stiffness", &ElementCase::stiffness, "J", any_number(), "k")
        .required("rest", &ElementCase::rest, "", any_number(), "length, m, or angle, rad");
  }
};

/// Only the keys that are read, so that a file may say more about its cases.
Json known_part(const Json& object) {
  if (!object.is_object()) return object;
  Json known = Json::object();
  for (const KeyInfo& key : ElementCase::schema().infos()) {
    if (object.contains(key.name)) known[key.name] = object[key.name];
  }
  return known;
}

Json rows(const Eigen::MatrixXd& matrix) {
  Json list = Json::array();
  for (const auto& row : matrix.rowwise())
    list.push_back(std::vector<double>(row.begin(), row.end()));
  return list;
}

Json evaluate(const ElementCase& element, const ElementFunction& exact,
              const ElementFunction* filtered) {
  Eigen::Matrix3Xd positions(3, element.positions.size());
  for (std::size_t i = 0; i < element.positions.size(); ++i) {
    positions.col(static_cast<int>(i)) = element.positions[i];
  }
  const ElementDerivatives result = exact.evaluate(positions, element.stiffness, element.rest);
  Json json{{"energy", element.energy},
            {"value", result.value},
            {"gradient", std::vector<double>(result.gradient.begin(), result.gradient.end())},
            {"hessian", rows(result.hessian)}};
  if (filtered != nullptr) {
    json["filtered"] = rows(filtered->evaluate(positions, element.stiffness, element.rest).hessian);
  }
  return json;
}

}  // namespace

Json evaluate_cases(const Registry& registry, const Json& input,
                    const std::optional<std::string>& filter) {
  if (!input.is_object() || !input.contains("cases") || !input["cases"].is_array()) {
    throw InvalidInput(std::vector<Problem>{{"/cases", "expected a list of cases"}});
  }
  std::vector<Problem> problems;
  ParseContext context{registry, ".", {}, problems};
  CaseEnergies energies(registry, filter);
  Json results = Json::array();
  for (std::size_t i = 0; i < input["cases"].size(); ++i) {
    const std::string pointer = pointer_to("/cases", i);
    const std::size_t before = problems.size();
    ElementCase element;
    ElementCase::schema().read(known_part(input["cases"][i]), pointer, context, element);
    if (problems.size() > before) continue;
    const std::string energy_pointer = pointer_to(pointer, "energy");
    const ElementFunction* exact = energies.exact(element.energy, energy_pointer, problems);
    if (exact == nullptr) continue;
    const ElementFunction* filtered = energies.filtered(element.energy, energy_pointer, problems);
    if (static_cast<int>(element.positions.size()) != exact->vertices()) {
      problems.push_back({pointer_to(pointer, "positions"),
                          "expected " + std::to_string(exact->vertices()) + " positions, found " +
                              std::to_string(element.positions.size())});
    }
    if (problems.empty()) results.push_back(evaluate(element, *exact, filtered));
  }
  if (!problems.empty()) throw InvalidInput(problems);
  return {{"cases", results}};
}

}  // namespace ringlet
