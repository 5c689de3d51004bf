#include "harness/report/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "harness/base/atomic_file.hpp"
#include "harness/drawings/html_text.hpp"
#include "harness/report/html_table.hpp"
#include "harness/report/page_assets.hpp"
#include "harness/report/page_data.hpp"
#include "harness/report/page_scene.hpp"
#include "harness/report/verdicts.hpp"

namespace gcs {
namespace {

/// An instance of any run.
struct PageInstance {
  std::string id;
  const StoredScene* scene = nullptr;  ///< null: nothing was stored
};

/// Each once, in the order of the runs.
std::vector<PageInstance> instances_of(const std::vector<PageRun>& runs) {
  std::vector<PageInstance> instances;
  for (const PageRun& run : runs)
    for (const InstanceSummary& measured : run.record.instances) {
      if (!is_drawn(run.record, measured.id)) continue;
      auto known = std::find_if(instances.begin(), instances.end(),
                                [&](const PageInstance& other) { return other.id == measured.id; });
      if (known == instances.end()) known = instances.insert(known, {measured.id, nullptr});
      const auto scene = run.scenes.find(measured.id);
      if (known->scene == nullptr && scene != run.scenes.end()) known->scene = &scene->second;
    }
  return instances;
}

std::string run_prefix(std::size_t number) { return fmt::format("run{}-", number + 1); }

// ---- contents

std::string link(const std::string& anchor, const std::string& text) {
  return fmt::format("<li><a href=\"#{}\">{}</a>", anchor, html_escaped(text));
}

std::string contents(const std::vector<PageRun>& runs, const std::vector<PageInstance>& instances) {
  std::string text = "<nav aria-label=\"Contents\">\n<ul>\n" + link("standing", "What is proven") + "</li>\n";
  for (std::size_t r = 0; r < runs.size(); ++r) {
    text += link(run_prefix(r) + "run", "Run " + runs[r].name) + "\n<ul>\n";
    for (const Table& table : runs[r].tables.tables)
      text += link(run_prefix(r) + html_anchor(table.name), table.caption) + "</li>\n";
    text += "</ul></li>\n";
  }
  text += link("instances", "Instances") + "\n<ul>\n";
  for (const PageInstance& instance : instances)
    text += link("scene-" + html_anchor(instance.id), instance.id) + "</li>\n";
  return text + "</ul></li>\n</ul></nav>\n";
}

// ---- what is proven

std::string standing_html(std::optional<VerdictStanding> standing) {
  if (!standing) return "<td>–</td>";
  return fmt::format("<td class=\"verdict {0}\">{0}</td>", word(*standing));
}

std::string verdict_row(const Verdict& one) {
  return fmt::format(
      "<tr><th scope=\"row\">{}</th><td>{}</td>{}<td>{}</td>{}<td class=\"words\">{}</td></tr>\n",
      html_escaped(one.quantity), one.printed.empty() ? "–" : html_escaped(one.printed),
      standing_html(one.printed_standing), html_escaped(one.ours), standing_html(one.our_standing),
      html_escaped(one.reason));
}

/// The run that knows most about an instance: the first with certificates for it, else the first.
const PageRun& run_for(const std::vector<PageRun>& runs, const std::string& id) {
  const auto certified = std::find_if(runs.begin(), runs.end(), [&](const PageRun& run) {
    return std::any_of(run.record.cells.begin(), run.record.cells.end(),
                       [&](const CellRecord& cell) { return cell.spec.instance == id && cell.proofs; });
  });
  if (certified != runs.end()) return *certified;
  return *std::find_if(runs.begin(), runs.end(), [&](const PageRun& run) {
    return std::any_of(run.record.instances.begin(), run.record.instances.end(),
                       [&](const InstanceSummary& instance) { return instance.id == id; });
  });
}

std::string standing_table(const std::vector<PageRun>& runs, const std::vector<PageInstance>& instances,
                           const Publications& publications) {
  std::string rows;
  for (const PageInstance& instance : instances) {
    const PageRun& run = run_for(runs, instance.id);
    const auto measured = std::find_if(run.record.instances.begin(), run.record.instances.end(),
                                       [&](const InstanceSummary& other) { return other.id == instance.id; });
    std::string own;
    for (const Verdict& one : verdicts(run.record, *measured, instance.scene, publications))
      own += verdict_row(one);
    if (own.empty()) continue;
    rows += fmt::format(
        "<tr class=\"heading\"><th scope=\"rowgroup\" colspan=\"6\"><a href=\"#scene-{}\">{}</a></th></tr>\n",
        html_anchor(instance.id), html_escaped(instance.id));
    rows += own;
  }
  return "<section class=\"table\" id=\"standing\"><h2>What is proven</h2>\n"
         "<p>Numbers of solutions: what the papers print, and what this program proves, refutes or leaves "
         "open. Ours "
         "count classes up to reflection; with given positions all figures, and of bodies that are no mirror "
         "image of "
         "themselves solutions up to motion.</p>\n"
         "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Numbers of "
         "solutions\"><table>\n<thead><tr>"
         "<th class=\"stub\" scope=\"col\"></th><th scope=\"col\">published</th><th class=\"stub\" "
         "scope=\"col\">is</th>"
         "<th scope=\"col\">ours</th><th class=\"stub\" scope=\"col\">is</th><th class=\"stub\" "
         "scope=\"col\">why</th></tr></thead>\n"
         "<tbody>\n" +
         rows + "</tbody>\n</table></div></section>\n";
}

// ---- runs

std::string fact(std::string_view name, const std::string& value) {
  return fmt::format("<dt>{}</dt><dd>{}</dd>\n", name, html_escaped(value.empty() ? "unknown" : value));
}

std::string environment_html(const RunFile& record) {
  const Environment& environment = record.environment;
  return "<dl class=\"facts\">\n" + fact("measured", record.started) + fact("processor", environment.cpu) +
         fact("vector instructions", environment.instructions) + fact("compiler", environment.compiler) +
         fact("flags", environment.flags) + fact("source", environment.commit) +
         fact("threads", std::to_string(environment.threads)) + fact("seed", std::to_string(record.seed)) +
         "</dl>\n";
}

std::string drawings_html(const std::vector<Drawing>& drawings) {
  if (drawings.empty()) return "";
  std::string text = "<div class=\"figures\">\n";
  for (const Drawing& drawing : drawings)
    text += fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", drawing.svg,
                        html_escaped(drawing.caption));
  return text + "</div>\n";
}

/// Tables of errors are long, and the figures show what they say.
bool has_long_tables(const RunFile& record) {
  return std::any_of(record.tables.begin(), record.tables.end(), [](const RequestedTable& requested) {
    const TableKind* kind = find_table(requested.name);
    return kind != nullptr && kind->measures_accuracy;
  });
}

std::string folded(const std::string& summary, const std::string& content) {
  return "<details class=\"table\"><summary>" + html_escaped(summary) + "</summary>\n" + content +
         "</details>\n";
}

std::string run_html(const PageRun& run, std::size_t number) {
  const std::string prefix = run_prefix(number);
  std::string text = fmt::format("<section id=\"{}run\">\n<h2>Run {}</h2>\n", prefix, html_escaped(run.name));
  text += environment_html(run.record) + drawings_html(run.tables.drawings);
  for (const Table& table : run.tables.tables)
    text +=
        has_long_tables(run.record) ? folded(table.caption, to_html(table, prefix)) : to_html(table, prefix);
  for (const std::string& line : run.tables.lines)
    text += "<p class=\"missing\">" + html_escaped(line) + "</p>\n";
  return text + folded("All measurements of this run", to_html(run.tables.measurements, prefix)) +
         "</section>\n";
}

// ---- instances

std::string instances_html(const std::vector<PageInstance>& instances) {
  std::string text =
      "<section id=\"instances\">\n<h2>Instances</h2>\n<p>Coordinates and lengths are in the unit of the "
      "instance's "
      "file. S is the closed path of pairs (figure, t) through the sketch, at t = 0, along which the lengths "
      "go to the "
      "given ones, at t = 1. Its figures are those of a polyline within the stated distance of S; solutions "
      "are "
      "shown as listed. Where S is not shown, figures move from solution to solution: bodies rigidly, with "
      "what two bodies share the first of them, lines and planes with their directions, free points on "
      "segments; what is in between is no solution. Of a family of instances the first member stands for "
      "all.</p>\n";
  std::size_t number = 0;
  for (const PageInstance& instance : instances)
    text +=
        instance.scene != nullptr ? scene_html(*instance.scene, number++) : missing_scene_html(instance.id);
  return text + "</section>\n";
}

std::vector<const StoredScene*> stored(const std::vector<PageInstance>& instances) {
  std::vector<const StoredScene*> scenes;
  for (const PageInstance& instance : instances)
    if (instance.scene != nullptr) scenes.push_back(instance.scene);
  return scenes;
}

}  // namespace

std::filesystem::path folder_of_run(const std::filesystem::path& run) {
  return std::filesystem::is_directory(run) ? run : std::filesystem::absolute(run).parent_path();
}

PageRun load_page_run(const std::filesystem::path& run, const Publications& publications) {
  const std::filesystem::path folder = folder_of_run(run);
  RunFile record = load_run_file(run);
  TableSet tables = build_tables(record, publications);
  PageRun page{std::filesystem::absolute(folder).lexically_normal().filename().string(),
               std::move(record),
               std::move(tables),
               {}};
  for (const InstanceSummary& instance : page.record.instances)
    if (auto scene = load_scene(folder, instance.id)) page.scenes.emplace(instance.id, std::move(*scene));
  return page;
}

void write_page(const std::vector<PageRun>& runs, const Publications& publications,
                const std::filesystem::path& folder) {
  AtomicFile(folder / "report.html").commit(page_html(runs, publications));
}

std::string page_html(const std::vector<PageRun>& runs, const Publications& publications) {
  const std::vector<PageInstance> instances = instances_of(runs);
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; "
      "script-src "
      "'unsafe-inline'\">\n<title>gcsbench: solving geometric "
      "constraints</title>\n<style>\n{}</style>\n</head>\n<body>\n",
      page_style);
  text +=
      "<a class=\"skip\" href=\"#standing\">Skip the contents</a>\n<header><h1>Solving geometric "
      "constraints</h1>\n"
      "<p>Points, lines, planes and rigid bodies placed so that given distances and angles hold: what "
      "gcsbench "
      "measured, beside the published figures.</p></header>\n";
  text += contents(runs, instances) + "<main>\n" + standing_table(runs, instances, publications);
  for (std::size_t r = 0; r < runs.size(); ++r) text += run_html(runs[r], r);
  text += instances_html(instances) + "</main>\n<script type=\"application/json\" id=\"page-data\">" +
          script_escaped(page_data(stored(instances))) + "</script>\n<script>\n";
  text += page_script;
  return text + "</script>\n</body>\n</html>\n";
}

}  // namespace gcs
