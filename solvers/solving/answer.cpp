#include "solvers/solving/answer.hpp"

namespace gcs {

Answer::Answer() = default;
Answer::Answer(const Answer&) = default;
Answer::Answer(Answer&&) noexcept = default;
Answer& Answer::operator=(const Answer&) = default;
Answer& Answer::operator=(Answer&&) noexcept = default;
Answer::~Answer() = default;

SolveOutcome::SolveOutcome() = default;
SolveOutcome::SolveOutcome(const SolveOutcome&) = default;
SolveOutcome::SolveOutcome(SolveOutcome&&) noexcept = default;
SolveOutcome& SolveOutcome::operator=(const SolveOutcome&) = default;
SolveOutcome& SolveOutcome::operator=(SolveOutcome&&) noexcept = default;
SolveOutcome::~SolveOutcome() = default;

std::string_view word(RunStatus status) {
  constexpr std::array<std::string_view, all_statuses.size()> words{
      "complete", "partial", "infinite", "unsupported", "gave up", "stopped", "interrupted", "timed out"};
  return words[static_cast<std::size_t>(status)];
}

std::string_view word(Claim claim) {
  constexpr std::array<std::string_view, all_claims.size()> words{
      "some real", "on path", "on path of the core", "all real of this component", "all real", "all complex"};
  return words[static_cast<std::size_t>(claim)];
}

std::string_view word(Convention convention) {
  constexpr std::array<std::string_view, all_conventions.size()> words{"in the given frame", "up to motion",
                                                                       "up to reflection"};
  return words[static_cast<std::size_t>(convention)];
}

std::string_view word(Standing standing) {
  constexpr std::array<std::string_view, all_standings.size()> words{"as stated", "undecided",
                                                                     "not as stated"};
  return words[static_cast<std::size_t>(standing)];
}

}  // namespace gcs
