#include "harness/results/path_reader.hpp"

#include <algorithm>

#include "harness/instances/instance_lookup.hpp"
#include "harness/results/file_formats.hpp"
#include "solvers/reading/json_cursor.hpp"

namespace gcs {
namespace {

/// Where the numbers of a row go: coordinate `axis` of a point.
struct Column {
  int point = 0;
  int axis = 0;
};

/// "p4.y"
Column column_named(const JsonCursor& place, const std::string& name, const ProblemStatement& problem) {
  const std::size_t dot = name.rfind('.');
  const std::string_view axes =
      std::string_view("xyz").substr(0, static_cast<std::size_t>(problem.dimension));
  if (dot != std::string::npos && dot + 2 == name.size()) {
    const auto point = std::find(problem.points.begin(), problem.points.end(), name.substr(0, dot));
    const std::size_t axis = axes.find(name.back());
    if (point != problem.points.end() && axis != std::string_view::npos)
      return {static_cast<int>(point - problem.points.begin()), static_cast<int>(axis)};
  }
  place.fail("'" + name + "' is no coordinate of the instance", "write the path again");
}

std::vector<Column> read_columns(const JsonCursor& columns, const ProblemStatement& problem) {
  const auto entries = columns.elements();
  std::vector<Column> moving;
  const std::vector<std::string> first{"t", "length", "radius"};
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (i >= first.size())
      moving.push_back(column_named(entries[i], entries[i].text(), problem));
    else if (entries[i].text() != first[i])
      entries[i].fail("this column is not '" + first[i] + "'", "write the path again");
  }
  return moving;
}

Figure read_fixed(const JsonCursor& fixed, const ProblemStatement& problem) {
  Figure figure{Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(problem.points.size())), {}};
  for (const auto& [name, value] : fixed.members()) {
    const Column column = column_named(value, name, problem);
    figure.points(column.axis, column.point) = value.number().value;
  }
  return figure;
}

PathCorner read_corner(const JsonCursor& row, const Figure& fixed, const std::vector<Column>& columns) {
  const auto numbers = row.elements(columns.size() + 3, "numbers, one for each column");
  PathCorner corner{fixed, numbers[0].number().value, numbers[1].number().value};
  for (std::size_t i = 0; i < columns.size(); ++i)
    corner.figure.points(columns[i].axis, columns[i].point) = numbers[i + 3].number().value;
  return corner;
}

/// Something moves, and the arc length does not fall.
void require_way(const JsonCursor& rows, const std::vector<PathCorner>& corners) {
  const auto moves = [&](const PathCorner& corner) {
    return corner.figure.points != corners.front().figure.points;
  };
  const auto falls = [](const PathCorner& a, const PathCorner& b) { return b.length < a.length; };
  if (std::none_of(corners.begin(), corners.end(), moves))
    rows.fail("nothing moves along this path", "write it again");
  if (std::adjacent_find(corners.begin(), corners.end(), falls) != corners.end())
    rows.fail("the arc length falls from one row to the next", "write it again");
}

PathCrossingCorner read_crossing(const JsonCursor& cursor, std::size_t corners) {
  const JsonCursor row = cursor.required("row");
  const double number = row.number().value;
  if (!(number >= 0 && number < static_cast<double>(corners)))
    row.fail("there is no such row", "write the path again");
  return {static_cast<std::size_t>(number), cursor.required("direction").number().value > 0 ? 1 : -1};
}

}  // namespace

StoredPath parse_path(const std::string& text, const std::string& file, const Instance& instance) {
  const JsonValue document = parse_json(text, file);
  const JsonCursor root(document, file);
  root.require_format(path_format);
  if (to_text(root.required("instance").value(), -1) != to_text(instance.document, -1))
    root.required("instance").fail("the path is of another instance", "write it again with `gcsbench path`");
  const std::vector<Column> columns = read_columns(root.required("columns"), instance.problem);
  const Figure fixed = read_fixed(root.required("fixed"), instance.problem);
  StoredPath path{root.required("within").number().value, root.required("length").number().value, {}, {}};
  for (const JsonCursor& row : root.required("rows").elements())
    path.corners.push_back(read_corner(row, fixed, columns));
  require_way(root.required("rows"), path.corners);
  for (const JsonCursor& crossing : root.required("crossings").elements())
    path.crossings.push_back(read_crossing(crossing, path.corners.size()));
  return path;
}

}  // namespace gcs
