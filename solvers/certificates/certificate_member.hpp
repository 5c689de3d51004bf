#pragma once
/// Certificates that other processes prove.

#include <complex>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "solvers/certificates/certificate.hpp"
#include "solvers/running/crew.hpp"
#include "solvers/running/proof_setup.hpp"

namespace gcs {

/// Those of Certifier::certify of so many points, on threads and, where there is one, by the crew. Untried ones where stop
/// is asked for. `point_of`: called from any thread.
std::vector<Certificate> certificates(
    const Certifier& certifier, std::size_t points,
    const std::function<std::vector<std::complex<double>>(std::size_t)>& point_of, const ProofSetup& setup,
    int least_bits = bits_of_doubles);

/// The other side. Null where the task is none of certificates; throws std::invalid_argument for bytes that are none.
std::unique_ptr<ItemWork> begin_certificates(const std::string& task);

}  // namespace gcs
