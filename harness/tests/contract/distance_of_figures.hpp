#pragma once
/// How far figures are from each other, place by place.

#include "solvers/problem/problem_statement.hpp"

namespace gcs::contract {

/// The most that an element's place differs by, of two figures in one frame: infinite for a real and a complex one. The
/// signs of a line's direction and of a plane's normal mean nothing.
double distance_of(const Figure& a, const Figure& b);

}  // namespace gcs::contract
