/// gcsbench convert: a stored result in its other form.

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <string_view>

#include "harness/base/atomic_file.hpp"
#include "harness/cli/argument_checks.hpp"
#include "harness/cli/commands.hpp"
#include "harness/results/result_io.hpp"
#include "harness/results/result_reader.hpp"

namespace gcs {

namespace {

ExitCode convert(const std::string& result, const std::string& out) {
  require_another_file(out, result);
  const std::string text = read_result(result);
  Output file(out);
  rewrite_result(
      text, result, [&](std::string_view piece) { file.write(piece); }, form_of(out));
  file.commit();
  return ExitCode::done;
}

}  // namespace

void add_convert_command(CLI::App& app, Invocation& invocation) {
  struct Arguments {
    std::string result;
    std::string out = "-";
  };
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("convert", "Write a result as JSON or as CBOR");
  command
      ->add_option("RESULT", arguments->result,
                   "A result that solve --out wrote, in either form; - is standard input")
      ->required();
  command
      ->add_option("--out", arguments->out,
                   "The file to write, as CBOR where its name ends in .cbor; - is standard output, as JSON")
      ->check(output_name())
      ->type_name("FILE")
      ->capture_default_str();
  command->footer(
      "It is what solve --out would have written there, with every digit.\n"
      "\nExample:\n"
      "  gcsbench solve icosahedron --strategy monodromy --out result.cbor\n"
      "  gcsbench convert result.cbor | python3 -m json.tool\n");
  command->callback([&invocation, arguments] {
    invocation.action = [arguments] { return convert(arguments->result, arguments->out); };
  });
}

}  // namespace gcs
