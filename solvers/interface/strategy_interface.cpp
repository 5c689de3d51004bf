#include "solvers/interface/strategy_interface.hpp"

namespace gcs {

SolveReport::SolveReport() = default;
SolveReport::SolveReport(const SolveReport&) = default;
SolveReport::SolveReport(SolveReport&&) noexcept = default;
SolveReport& SolveReport::operator=(const SolveReport&) = default;
SolveReport& SolveReport::operator=(SolveReport&&) noexcept = default;
SolveReport::~SolveReport() = default;

}  // namespace gcs
