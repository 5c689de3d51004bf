#pragma once
/// How many figures three points and three lines have at most of which all fifteen pairs are constrained.

#include <cstdint>
#include <optional>

#include "solvers/problem/problem_statement.hpp"

namespace gcs {

/// In a fixed frame, at any values, isolated ones. Nothing where the problem is none of three points and three lines in
/// space with the distances between points and of each line from each point, and of every two lines the distance or the
/// angle.
///
/// A line. With the points 0, p_1, p_2, their plane's normal n, and a direction u, the foot f of a line at the distances
/// d_0, d_1, d_2 solves f·u = 0 and 2 f·p_j = m_j/(u·u), m_j = (p_j·p_j − d_j² + d_0²) u·u − (p_j·u)². With
/// G_jk = p_j·p_k u·u − (p_j·u)(p_k·u), f·f = d_0² is F = mᵀ adj(G) m − 4 d_0² (u·u) det G = 0: a sextic C in the plane of
/// directions. Where u·u = 0, it is −((p_1·u)(p_2·u)((p_2 − p_1)·u))²: C touches that conic in the six points e·u = 0, e
/// an edge of the triangle. Where n·u = 0 it has three nodes, on each branch of which f is finite.
///
/// Three angles. Up to signs there are two triples of directions a_i with these cosines, and the lines have the directions
/// u_i = R a_i, R in SO(3), since −1 turns all of them over. With R by a quaternion q, F(R a_i) = 0 are three surfaces of
/// degree 12 in P³. On the quadric q·q = 0, u_i = λ_i(q) ℓ(q) with ℓ·ℓ = 0, and ℓ is constant along the lines of one
/// ruling: six of them have e·ℓ = 0. There F, which is in the ideal of (u·u, (e·u)²) = ((q·q)², (e·u)²), vanishes twice. So
/// the surfaces, with the six skew lines blown up, are divisors 12 H − 2 ΣE = Σ 2 (H − E_k) or contain such: without base
/// points, so that isolated points are at most (12 H − 2 ΣE)³ = 12³ − 6 (3·12·2·2 − 2·2³) = 960 for each triple.
///
/// Otherwise on the product of the three curves: cosines are zeros of (u·v)² − c² (u·u)(v·v), of degree 2 in u, 12 on the
/// curve. Distances are zeros of ((g − f)·(u×v))² − δ² (u×v)², also of degree 2 in u but for poles: f×u has simple ones at
/// the six points of u·u = 0, which makes 12 + 2·6. Three divisors of degrees k, l, m in either of their curves meet in
/// 2 k l m points, and isolated ones are no more, since divisors of degree ≥ 12 from conics, or 24 ≥ 2·7, the genus, have no
/// base points.
///
/// These are counts at generic values; isolated figures persist when values are moved.
std::optional<std::uint64_t> three_lines_bound(const ProblemStatement& problem);

}  // namespace gcs
