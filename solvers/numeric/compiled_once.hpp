#pragma once
/// Templates of the libraries that hundreds of sources would instantiate, and that compiled_once.cpp alone does: a sixth of
/// a build's code was that. The precompiled headers have it in; no source needs it.

#include <Eigen/Dense>
#include <string>
#include <vector>

#ifndef GCS_ONCE
#define GCS_ONCE extern  // but where it is compiled
#endif

GCS_ONCE template class std::basic_string<char>;
GCS_ONCE template class std::vector<int>;
GCS_ONCE template class std::vector<double>;
GCS_ONCE template class std::vector<std::string>;

GCS_ONCE template class Eigen::PartialPivLU<Eigen::MatrixXd>;
GCS_ONCE template class Eigen::PartialPivLU<Eigen::MatrixXcd>;
GCS_ONCE template class Eigen::FullPivLU<Eigen::MatrixXd>;
GCS_ONCE template class Eigen::FullPivLU<Eigen::MatrixXcd>;
GCS_ONCE template class Eigen::ColPivHouseholderQR<Eigen::MatrixXd>;
GCS_ONCE template class Eigen::ColPivHouseholderQR<Eigen::MatrixXcd>;
GCS_ONCE template class Eigen::JacobiSVD<Eigen::Matrix3d>;
GCS_ONCE template class Eigen::JacobiSVD<Eigen::MatrixXd>;
GCS_ONCE template class Eigen::JacobiSVD<Eigen::MatrixXcd>;

namespace Eigen::internal {

// What products, factors and their solutions are made of.
using Complex = std::complex<double>;
template <class Scalar, int order>
using In = const_blas_data_mapper<Scalar, long, order>;
template <class Scalar>
using Out = blas_data_mapper<Scalar, long, ColMajor, 0, 1>;

GCS_ONCE template struct gebp_kernel<double, double, long, Out<double>, 4, 4, false, false>;
GCS_ONCE template struct general_matrix_matrix_product<long, double, 0, false, double, 0, false, 0, 1>;
GCS_ONCE template struct general_matrix_matrix_product<long, Complex, 0, false, Complex, 0, false, 0, 1>;
GCS_ONCE template struct general_matrix_vector_product<long, double, In<double, 0>, 0, false, double,
                                                       In<double, 0>, false, 0>;
GCS_ONCE template struct general_matrix_vector_product<long, double, In<double, 0>, 0, false, double,
                                                       In<double, 1>, false, 0>;
GCS_ONCE template struct general_matrix_vector_product<long, double, In<double, 1>, 1, false, double,
                                                       In<double, 0>, false, 0>;
GCS_ONCE template struct general_matrix_vector_product<long, double, In<double, 1>, 1, false, double,
                                                       In<double, 1>, false, 1>;
GCS_ONCE template struct general_matrix_vector_product<long, Complex, In<Complex, 0>, 0, false, Complex,
                                                       In<Complex, 0>, false, 0>;
GCS_ONCE template struct general_matrix_vector_product<long, Complex, In<Complex, 0>, 0, false, Complex,
                                                       In<Complex, 1>, false, 0>;
GCS_ONCE template struct general_matrix_vector_product<long, Complex, In<Complex, 1>, 1, false, Complex,
                                                       In<Complex, 0>, false, 0>;
GCS_ONCE template struct general_matrix_vector_product<long, Complex, In<Complex, 1>, 1, true, Complex,
                                                       In<Complex, 0>, false, 0>;
GCS_ONCE template struct general_matrix_vector_product<long, Complex, In<Complex, 1>, 1, false, Complex,
                                                       In<Complex, 0>, true, 0>;
GCS_ONCE template struct gemm_pack_lhs<double, long, In<double, 0>, 4, 2, Packet2d, 0, false, false>;
GCS_ONCE template struct gemm_pack_lhs<double, long, In<double, 1>, 4, 2, Packet2d, 1, false, false>;
GCS_ONCE template struct gemm_pack_rhs<double, long, In<double, 0>, 4, 0, false, false>;
GCS_ONCE template struct gemm_pack_rhs<double, long, Out<double>, 4, 0, false, true>;
GCS_ONCE template struct triangular_solve_matrix<double, long, 1, 5, false, 0, 0, 1>;
GCS_ONCE template struct triangular_solve_matrix<double, long, 1, 2, false, 0, 0, 1>;
GCS_ONCE template struct triangular_solve_matrix<Complex, long, 1, 5, false, 0, 0, 1>;
GCS_ONCE template struct triangular_solve_matrix<Complex, long, 1, 2, false, 0, 0, 1>;
GCS_ONCE template struct triangular_solve_vector<double, double, long, 1, 2, false, 0>;
GCS_ONCE template struct triangular_solve_vector<double, double, long, 1, 5, false, 0>;
GCS_ONCE template struct triangular_solve_vector<Complex, Complex, long, 1, 2, false, 0>;
GCS_ONCE template struct triangular_solve_vector<Complex, Complex, long, 1, 5, false, 0>;
GCS_ONCE template struct partial_lu_impl<double, 0, int, Dynamic>;
GCS_ONCE template struct partial_lu_impl<Complex, 0, int, Dynamic>;

GCS_ONCE template void evaluateProductBlockingSizesHeuristic<double, double, 4, long>(long&, long&, long&,
                                                                                      long);
GCS_ONCE template void evaluateProductBlockingSizesHeuristic<double, double, 1, long>(long&, long&, long&,
                                                                                      long);
GCS_ONCE template void evaluateProductBlockingSizesHeuristic<Complex, Complex, 4, long>(long&, long&, long&,
                                                                                        long);
GCS_ONCE template void evaluateProductBlockingSizesHeuristic<Complex, Complex, 1, long>(long&, long&, long&,
                                                                                        long);
GCS_ONCE template void kernel_retval<FullPivLU<MatrixXd>>::evalTo(MatrixXd&) const;

}  // namespace Eigen::internal

#undef GCS_ONCE
