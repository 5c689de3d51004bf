#pragma once
/// Certificates that other processes prove.

#include <complex>
#include <string>
#include <vector>

#include "solvers/certificates/certificate.hpp"
#include "solvers/running/crew.hpp"
#include "solvers/running/proof_setup.hpp"

namespace gcs {

/// Those of Certifier::certify, on threads and, where there is one, by the crew. Untried ones where stop is asked for.
std::vector<Certificate> certificates(const Certifier& certifier,
                                      const std::vector<std::vector<std::complex<double>>>& points,
                                      const ProofSetup& setup);

/// The other side. Empty where the task is none of certificates; throws std::invalid_argument for bytes that are none.
ItemWork begin_certificates(const std::string& task);

}  // namespace gcs
