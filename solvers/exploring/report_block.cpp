#include "solvers/exploring/report_block.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "solvers/running/message_bytes.hpp"

namespace gcs {
namespace {

// Each calls `visit` with all members, to be written or read.

void visit_vector(auto& visit, auto& v) { visit_all(visit, v[0], v[1], v[2]); }

void visit_points(MessageWriter& write, const Eigen::Matrix3Xd& points) {
  write(std::vector<double>(points.data(), points.data() + points.size()));
}
void visit_points(MessageReader& read, Eigen::Matrix3Xd& points) {
  std::vector<double> numbers;
  read(numbers);
  if (numbers.size() % 3 != 0) throw std::invalid_argument("a block has a point that is none");
  points = Eigen::Map<const Eigen::Matrix3Xd>(numbers.data(), 3, std::ssize(numbers) / 3);
}

void visit_figure(auto& visit, auto& figure) {
  visit_points(visit, figure.points);
  visit_each(visit, figure.lines, [](auto& v, auto& line) {
    visit_vector(v, line.point);
    visit_vector(v, line.direction);
  });
  visit_each(visit, figure.planes, [](auto& v, auto& plane) {
    visit_vector(v, plane.normal);
    v(plane.offset);
  });
}

void visit_path(auto& visit, auto& path) {
  visit_all(visit, path.end, path.cause, path.length, path.crossings, path.winding_number, path.pole_order,
            path.proven);
}

void visit_work(auto& visit, auto& work) {
  visit_all(visit, work.iterations, work.rejected_steps, work.newton_iterations, work.evaluations,
            work.partial_evaluations, work.jacobians, work.factorisations, work.plan_changes,
            work.smallest_step, work.mean_driving_parameters, work.max_driving_parameters);
}

void visit_report(auto& visit, auto& report) {
  visit_all(visit, report.status, report.reason);
  visit_each(visit, report.candidates, [](auto& v, auto& candidate) {
    visit_figure(v, candidate.figure);
    visit_all(v, candidate.multiplicity, candidate.error);
  });
  visit_each(visit, report.paths, [](auto& v, auto& path) { visit_path(v, path); });
  visit_each(visit, report.curves, [](auto& v, auto& curve) {
    v(curve.released);
    visit_path(v, curve.path);
    visit_each(v, curve.figures, [](auto& w, auto& figure) { visit_figure(w, figure); });
    v(curve.places);
  });
  visit_work(visit, report.work);
  visit_each(visit, report.particulars,
             [](auto& v, auto& particular) { visit_all(v, particular.name, particular.value); });
}

/// Bytes in numbers that every journal keeps as they are: so many of them, and then six in each.
constexpr std::size_t bytes_of_number = 6;
constexpr double most_in_number = 0x1p48;

Journal::Block packed(const std::string& bytes) {
  Journal::Block block{static_cast<double>(bytes.size())};
  for (std::size_t i = 0; i < bytes.size(); i += bytes_of_number) {
    double number = 0;
    for (std::size_t j = std::min(i + bytes_of_number, bytes.size()); j-- > i;)
      number = 256 * number + static_cast<unsigned char>(bytes[j]);
    block.push_back(number);
  }
  return block;
}

std::string unpacked(const Journal::Block& block) {
  const double size = block.empty() ? -1 : block.front();
  if (size != std::ceil(size) || std::ceil(size / bytes_of_number) + 1 != static_cast<double>(block.size()))
    throw std::invalid_argument("a journal's block is none of reports");
  std::string bytes;
  for (auto number = block.begin() + 1; number != block.end(); ++number) {
    if (!(*number >= 0 && *number < most_in_number))
      throw std::invalid_argument("a journal's block has a number that is none of reports");
    auto rest = static_cast<std::uint64_t>(*number);
    for (std::size_t j = 0; j < bytes_of_number; ++j, rest >>= 8)
      bytes.push_back(static_cast<char>(rest & 0xff));
  }
  bytes.resize(static_cast<std::size_t>(size));
  return bytes;
}

}  // namespace

Journal::Block to_block(const std::vector<SolveReport>& reports) {
  MessageWriter write;
  visit_each(write, reports, [](auto& v, auto& report) { visit_report(v, report); });
  return packed(write.message);
}

std::vector<SolveReport> reports_from(const Journal::Block& block) {
  const std::string bytes = unpacked(block);
  MessageReader read(bytes);
  std::vector<SolveReport> reports;
  visit_each(read, reports, [](auto& v, auto& report) { visit_report(v, report); });
  return reports;
}

}  // namespace gcs
