#include "solvers/homotopies/leg_message.hpp"

#include <utility>

#include "solvers/running/message_bytes.hpp"

namespace gcs {
namespace {

template <class System>
void visit_squares(auto& visit, System& s) {
  visit_all(visit, s.unknowns, s.differences, s.first, s.linear, s.first_linear, s.given);
}

template <class System>
void visit_monomials(auto& visit, System& s) {
  visit_all(visit, s.unknowns, s.monomials, s.first, s.shares);
}

template <class Order>
void visit_elimination(auto& visit, Order& e) {
  visit_all(visit, e.unknowns, e.entries, e.equation, e.unknown, e.steps, e.lower, e.upper, e.targets,
            e.entry_numbers);
}

template <class SomeRoute>
void visit_route(auto& visit, SomeRoute& route) {
  for (auto& coefficients : route.coefficients) visit(coefficients);
  visit_all(visit, route.end, route.rates);
}

}  // namespace

SentLegs::SentLegs(std::span<const Leg> legs, int unknowns) {
  const Route* last = nullptr;
  for (const Leg& leg : legs) {
    // One route serves many legs in a row.
    if (leg.route != std::exchange(last, leg.route)) routes.push_back(*leg.route);
    route_of.push_back(static_cast<int>(routes.size()) - 1);
    starts.emplace_back(leg.start, leg.start + unknowns);
    shortest_steps.push_back(leg.shortest_step);
  }
}

std::vector<Leg> SentLegs::legs() const {
  std::vector<Leg> result;
  for (std::size_t i = 0; i < starts.size(); ++i)
    result.push_back(
        {starts[i].data(), &routes.at(static_cast<std::size_t>(route_of[i])), shortest_steps[i]});
  return result;
}

std::string to_message(const LegTask& task) {
  MessageWriter write;
  const auto* squares = std::get_if<SquareSystem>(&task.system);
  write(squares != nullptr);
  if (squares != nullptr)
    visit_squares(write, *squares);
  else
    visit_monomials(write, std::get<MonomialSystem>(task.system));
  visit_elimination(write, task.elimination);
  visit_all(write, task.options, task.set, task.threads, task.all_wide);
  return std::move(write.message);
}

LegTask read_task(std::string_view message) {
  MessageReader read(message);
  LegTask task;
  bool are_squares = false;
  read(are_squares);
  if (are_squares)
    visit_squares(read, task.system.emplace<SquareSystem>());
  else
    visit_monomials(read, task.system.emplace<MonomialSystem>());
  visit_elimination(read, task.elimination);
  visit_all(read, task.options, task.set, task.threads, task.all_wide);
  return task;
}

std::string to_message(std::span<const Leg> legs, int unknowns) {
  const SentLegs sent(legs, unknowns);
  MessageWriter write;
  write(sent.routes.size());
  for (const Route& route : sent.routes) visit_route(write, route);
  write(sent.route_of);
  for (std::size_t i = 0; i < sent.starts.size(); ++i)
    visit_all(write, sent.starts[i], sent.shortest_steps[i]);
  return std::move(write.message);
}

SentLegs read_legs(std::string_view message) {
  MessageReader read(message);
  SentLegs sent;
  std::size_t routes = 0;
  read(routes);
  while (sent.routes.size() < routes) visit_route(read, sent.routes.emplace_back());
  read(sent.route_of);
  for (std::size_t i = 0; i < sent.route_of.size(); ++i)
    visit_all(read, sent.starts.emplace_back(), sent.shortest_steps.emplace_back());
  return sent;
}

std::string to_message(const FollowedLegs& followed) {
  MessageWriter write;
  write(to_block(followed));
  return std::move(write.message);
}

FollowedLegs read_followed(std::string_view message) {
  MessageReader read(message);
  Journal::Block block;
  read(block);
  return from_block(block);
}

}  // namespace gcs
