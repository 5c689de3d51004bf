/// gcsbench describe: what is known of an instance before any solving.

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <string>

#include "harness/base/atomic_file.hpp"
#include "harness/cli/argument_checks.hpp"
#include "harness/cli/commands.hpp"
#include "harness/descriptions/description_json.hpp"
#include "harness/descriptions/description_text.hpp"
#include "harness/descriptions/equations_text.hpp"
#include "harness/drawings/tree_drawing.hpp"

namespace gcs {

namespace {

struct DescribeArguments {
  std::string instance;
  bool json = false;
  std::string tree;       ///< the file for the interpretation tree; empty: none
  std::string equations;  ///< the word of their form; empty: none
};

ExitCode draw(const Instance& instance, const std::string& file) {
  require_another_file(file, instance.origin);
  if (const auto reason = why_no_tree(instance)) {
    std::cerr << "gcsbench: no tree is drawn: " << *reason << '\n';
    return ExitCode::not_solved;
  }
  Output(file).commit(draw_tree(instance).svg);
  return ExitCode::done;
}

ExitCode print_equations(const Instance& instance, const std::string& form) {
  const Scene scene = instance;
  if (const auto reason = why_no_equations(scene)) {
    std::cerr << "gcsbench: there are no equations: " << *reason << '\n';
    return ExitCode::not_solved;
  }
  for (const EquationsForm one : all_equations_forms)
    if (word(one) == form) std::cout << equations_text(scene, one);
  return ExitCode::done;
}

ExitCode run(const DescribeArguments& arguments) {
  const Instance instance = load_instance(arguments.instance);
  if (!arguments.tree.empty()) return draw(instance, arguments.tree);
  if (!arguments.equations.empty()) return print_equations(instance, arguments.equations);
  const Description description = describe(instance);
  std::cout << (arguments.json ? json_description(description) : text_description(description));
  return ExitCode::done;
}

}  // namespace

void add_describe_command(CLI::App& app, Invocation& invocation) {
  const auto arguments = std::make_shared<DescribeArguments>();
  CLI::App* command = app.add_subcommand("describe", "What is known of an instance before solving it");
  add_instance_argument(*command, arguments->instance);
  command->add_flag("--json", arguments->json, "As JSON");
  command
      ->add_option(
          "--tree", arguments->tree,
          "Draw the plan's interpretation tree, as SVG, in place of a description; - is standard output")
      ->check(output_name())
      ->type_name("FILE")
      ->excludes("--json");
  std::vector<std::string> forms;
  for (const EquationsForm form : all_equations_forms) forms.emplace_back(word(form));
  command
      ->add_option("--equations", arguments->equations,
                   "Print the polynomial equations, for another solver, in place of a description")
      ->check(CLI::IsMember(forms))
      ->excludes("--json")
      ->excludes("--tree");
  command->footer(
      "The tree holds every choice between the two intersections of an instruction, at the given\n"
      "lengths and with the driving parameters of the sketch, and the figures that come out.\n"
      "\nEquations: text has one a line, with the numbers of the file; phc is the input of PHCpack, with\n"
      "doubles. They are what certificates prove, in the frame and a unit of length that a remark names.\n"
      "reduced is the same after Gaussian elimination, without unknowns that are known up to signs: far\n"
      "fewer paths. Both end with a line of JSON: the positions of a solution in the frame and unit of the\n"
      "file, as linear forms in the unknowns.\n"
      "Unknowns: of a point P_x, P_y, P_z; of a line its point nearest to the origin L_x ..., its direction\n"
      "L_ux ..., and the vector product of both L_mx ...; of a plane its normal H_nx ... and its offset "
      "H_h;\n"
      "of a body where its origin is, B_tx ..., and the images of its axes, B_ex ..., B_fx ..., B_gx ...;\n"
      "u1, u2, ... what else keeps them of degree two. Of each class every choice of signs that the\n"
      "frame leaves open is a solution.\n"
      "\nExamples:\n  gcsbench describe disulfide --json\n  gcsbench describe qk33 --tree qk33.svg\n"
      "  gcsbench describe ./my.json --equations reduced > my.phc && phc -b my.phc my.out\n");
  command->callback(
      [&invocation, arguments] { invocation.action = [arguments] { return run(*arguments); }; });
}

}  // namespace gcs
