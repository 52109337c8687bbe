#include <spdlog/fmt/fmt.h>

#include <cstdio>

#include "apps/commands/command.h"
#include "apps/commands/scene_argument.h"
#include "apps/exit_codes.h"
#include "core/simulation.h"

namespace ringlet {
namespace {

template <class Interface>
std::string join_types(const std::vector<Choice<Interface>>& choices) {
  std::string text;
  for (const auto& choice : choices) text += (text.empty() ? "" : ", ") + choice.type();
  return text.empty() ? "none" : text;
}

int check(Registry& registry, const Arguments& arguments) {
  const Scene scene = read_scene_argument(registry, arguments);
  const Simulation simulation(scene);
  const Model& model = simulation.model();
  fmt::print("{}: ok\n", *arguments.operand(0));
  fmt::print("  strands     {} of {} vertices in all, {} of them pinned ({})\n",
             model.strands.count(), model.strands.vertex_count(), model.pins.size(),
             join_types(scene.strands));
  if (model.rest) {
    fmt::print("  rest        {}: {} of {} strands held, acceleration left {:.3g} m/s^2\n",
               scene.rest->type(), model.rest->strands - model.rest->not_held, model.rest->strands,
               model.rest->acceleration);
  }
  fmt::print("  energies    {}\n", join_types(scene.energies));
  fmt::print("  forces      {}\n", join_types(scene.forces));
  fmt::print("  collision   {}\n", scene.collision ? scene.collision->type() : "none");
  fmt::print("  solver      {}\n", scene.solver.type());
  fmt::print("  integrator  {}\n", scene.integrator.type());
  fmt::print("  steps       {}\n", scene.run.steps);
  fmt::print("  writers     {}\n", join_types(scene.run.write));
  return exit_ok;
}

}  // namespace

Command check_command() {
  return {"check",
          {"SCENE.json"},
          "reads a scene and tells every problem in it; runs and writes nothing",
          scene_options(),
          check};
}

}  // namespace ringlet
