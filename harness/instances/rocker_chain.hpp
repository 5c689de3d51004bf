#pragma once
/// A chain of rockers in the plane, each of which swings half as often as the one before.

#include <string>

namespace gcs {

/// The text of gcsbench-instance/1 with n rockers, for the family "rocker-chain". S of n rockers turns in t
/// 2^(n+1) − 2 times and has 2^n solutions (rocker_chain.cpp says why). Precondition: n is a decimal ≥ 1.
std::string rocker_chain(const std::string& id, const std::string& n);

}  // namespace gcs
