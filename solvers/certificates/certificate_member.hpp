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

using PointOf = std::function<std::vector<std::complex<double>>(std::size_t)>;
using TakeCertificate = std::function<void(std::size_t, Certificate)>;

/// Hands what Certifier::certify says of each of so many points to `take`: certificates of long lists need more memory
/// than the lists. On threads and, where there is one, by the crew; where stop is asked for, some are left out. Both
/// functions are called from any thread.
void certify_points(const Certifier& certifier, std::size_t points, const PointOf& point_of,
                    const ProofSetup& setup, const TakeCertificate& take, int least_bits = bits_of_doubles);

/// The other side. Null where the task is none of certificates; throws std::invalid_argument for bytes that are none.
std::unique_ptr<ItemWork> begin_certificates(const std::string& task);

}  // namespace gcs
