#include "solvers/homotopies/leg_block.hpp"

#include <stdexcept>

#include "solvers/numeric/digest.hpp"

namespace gcs {
namespace {

constexpr std::size_t head = 4;              // the number of unknowns, and the work
constexpr std::size_t numbers_of_state = 5;  // before the coordinates

void append(const LegResult& result, Journal::Block& block) {
  const LegState& state = result.state;
  block.insert(block.end(), {static_cast<double>(state.end), state.s, static_cast<double>(state.steps),
                             static_cast<double>(state.rejected), state.last_correction});
  for (const std::complex<double>& value : result.x) block.insert(block.end(), {value.real(), value.imag()});
}

LegResult read_result(const double* numbers, std::size_t unknowns) {
  LegResult result;
  result.state = {static_cast<LegEnd>(static_cast<int>(numbers[0])), numbers[1], static_cast<int>(numbers[2]),
                  static_cast<int>(numbers[3]), numbers[4]};
  for (std::size_t i = 0; i < unknowns; ++i) {
    const double* value = numbers + numbers_of_state + 2 * i;
    result.x.emplace_back(value[0], value[1]);
  }
  return result;
}

void add(const Route& route, Digest& digest) {
  for (const ComplexVectorX& coefficients : route.coefficients)
    digest.add(std::span<const std::complex<double>>(coefficients));
  digest.add(std::span<const std::complex<double>>(route.end));
  digest.add(std::span<const double>(route.rates));
}

}  // namespace

LegWork& LegWork::operator+=(const LegWork& other) {
  accepted += other.accepted;
  rejected += other.rejected;
  evaluations += other.evaluations;
  return *this;
}

void LegWork::add_to(WorkCounters& work) const {
  work.iterations += accepted;
  work.rejected_steps += rejected;
  work.newton_iterations += evaluations;
  work.evaluations += evaluations;
  work.jacobians += evaluations;
  work.factorisations += evaluations;
}

Journal::Block to_block(const FollowedLegs& followed) {
  const LegWork& work = followed.work;
  const std::size_t unknowns = followed.results.empty() ? 0 : followed.results.front().x.size();
  Journal::Block block{static_cast<double>(unknowns), static_cast<double>(work.accepted),
                       static_cast<double>(work.rejected), static_cast<double>(work.evaluations)};
  for (const LegResult& result : followed.results) append(result, block);
  return block;
}

FollowedLegs from_block(const Journal::Block& block) {
  const std::size_t unknowns = block.size() < head ? 0 : static_cast<std::size_t>(block[0]);
  const std::size_t per_leg = numbers_of_state + 2 * unknowns;
  if (block.size() < head || (block.size() - head) % per_leg != 0)
    throw std::invalid_argument("a journal's block is none of followed paths");
  FollowedLegs followed;
  followed.work = {static_cast<std::int64_t>(block[1]), static_cast<std::int64_t>(block[2]),
                   static_cast<std::int64_t>(block[3])};
  for (std::size_t i = head; i < block.size(); i += per_leg)
    followed.results.push_back(read_result(&block[i], unknowns));
  return followed;
}

std::uint64_t fingerprint(std::span<const Leg> legs, int unknowns) {
  Digest digest;
  digest.add(static_cast<std::uint64_t>(unknowns));
  const Route* last = nullptr;
  for (const Leg& leg : legs) {
    digest.add(std::span(leg.start, static_cast<std::size_t>(unknowns)));
    digest.add(std::span(&leg.shortest_step, 1));
    // One route serves many legs in a row.
    if (leg.route != last) add(*leg.route, digest);
    last = leg.route;
  }
  return digest.value();
}

}  // namespace gcs
